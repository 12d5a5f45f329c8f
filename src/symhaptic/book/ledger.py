"""All statements with their verdicts: what `verify` prints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from symhaptic.book.chapters import Chapter, run
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.foreign import Checked, checked
from symhaptic.book.judging import corrected_form, judged_again, to_be_compared
from symhaptic.book.record import Settled
from symhaptic.book.shapes import is_judged, is_statement, is_verdict
from symhaptic.book.sources import PAPER, SOURCES, STATEMENTS, of_source, source_of
from symhaptic.notation.proposition import Proposition
from symhaptic.paper import Statement
from symhaptic.paper.statement import Source
from symhaptic.proof.settle import Settlement
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.verdict import UNSETTLED, Kind, Verdict


class Twice(ValueError):
    """A statement that two derivations settle."""


@dataclass(frozen=True)
class Look:
    """What a process of our own says of a verdict that comes from a chapter's."""

    wrong: str | None
    rocq: Checked


@dataclass(frozen=True)
class Entry:
    """One statement, its verdict, and the derivation that settles it."""

    statement: Statement
    verdict: Verdict
    derivation: str | None
    seconds: float
    own: bool = False
    """Whether it is a user's statement rather than the paper's."""
    judged: Judged | None = None
    """The theorems on which it is settled; sent to another process they are derived there anew."""
    claim: Proposition | None = None
    """What a statement of one's own claims."""
    compared: Settlement | None = None
    """What the print was compared with, where no theorem settles it, to be compared again."""
    look: Look | None = None
    """What was seen of it by the process that derived its theorems anew, and kept them."""

    @property
    def source(self) -> Source | None:
        """Where the statement is from; None of one that a chapter states itself."""
        return source_of(self.statement.id)

    @property
    def consequence(self) -> str | None:
        """What it means for somebody who built a device on it, where something is wrong."""
        return CONSEQUENCES.get(self.statement.id)

    @cached_property
    def rocq(self) -> Checked:
        """How far a foreign kernel has checked it, as far as its record is of what is said here."""
        return checked(self.statement.id, self.judged) if self.look is None else self.look.rocq

    @cached_property
    def wrong(self) -> str | None:
        """What is wrong with the verdict, judged here, if another process gives it."""
        return judged_again(self) if self.look is None else self.look.wrong

    def as_json(self) -> dict[str, Any]:
        """The record of contract `verify --format json`."""
        v = self.verdict
        corrected = corrected_form(v)
        return {
            "id": self.statement.id,
            "source": self.source and self.source.title,
            "location": self.statement.location,
            "quote": self.statement.quote or None,
            "says": self.statement.says,
            "statement": self.statement.text,
            "proposition": v.proposition,
            "verdict": str(v.kind),
            "argued_for": v.argued_for and str(v.argued_for),
            "rests": list(v.rests),
            "method": v.method,
            "condition": v.condition,
            "corrected": None if corrected is None else corrected.replace(r"\br ", ""),
            "counterexample": None if v.counterexample is None else dict(v.counterexample),
            "shows": v.shows,
            "note": v.note,
            "consequence": self.consequence,
            "value": v.value,
            "radius": v.radius,
            "derivation": self.derivation,
            "rocq": self.rocq.as_json(),
            "seconds": round(self.seconds, 3),
        }


def of_chapter(chapter: Chapter) -> list[Entry]:
    """The statements that a chapter settles, or states without settling them."""
    found = {
        id: to_be_compared(
            Entry(
                s.statement,
                s.verdict,
                chapter.source,
                s.seconds,
                own=id not in STATEMENTS,
                judged=s.settlement.judged,
                claim=_own_claim(s),
            ),
            s.settlement,
        )
        for id, s in chapter.page.settled.items()
    }
    for id, statement in chapter.page.own.items():
        found.setdefault(id, Entry(statement, UNSETTLED, chapter.source, 0.0, own=True))
    return list(found.values())


def _own_claim(settled: Settled) -> Proposition | None:
    claim = settled.settlement.claim
    if claim is None or settled.statement.id in STATEMENTS:
        return None
    return claim(settled.statement.printed)


class NoEntries(ValueError):
    """What came from a chapter's process, and is nothing that our code sends."""


def looked_at(entries: list[Entry]) -> list[Entry]:
    """What came from a chapter's process, judged again, without the theorems that came with it.

    A statement that is known here is the one that is known, whatever came.  Raises
    :class:`NoEntries` for what are no entries.
    """
    if type(entries) is not list or not all(map(_is_entry, entries)):
        raise NoEntries("no statements with their verdicts")
    return [_looked_at(entry) for entry in entries]


def _looked_at(entry: Entry) -> Entry:
    """The same of one; what was found wrong decides nothing."""
    wrong = judged_again(entry)
    said = entry.verdict if wrong is None else Verdict(Kind.UNDECIDED, wrong)
    return replace(
        entry,
        statement=STATEMENTS.get(entry.statement.id, entry.statement),
        verdict=replace(said, corrected=None),
        own=entry.statement.id not in STATEMENTS,
        look=Look(wrong, checked(entry.statement.id, entry.judged)),
        judged=None,
        claim=None,
        compared=None,
    )


def _is_entry(entry: Any) -> bool:
    """Whether it has what is listed, each in a line."""
    return (
        type(entry) is Entry
        and is_statement(entry.statement)
        and is_verdict(entry.verdict)
        and type(entry.seconds) in (int, float)
        and type(entry.own) is bool
        and (entry.claim is None or isinstance(entry.claim, Proposition))
        and (entry.judged is None or is_judged(entry.judged))
    )


def of_derivation(path: Path) -> list[Entry]:
    """Run a derivation; its statements with their verdicts, ready to be sent between processes."""
    return [
        replace(entry, verdict=replace(v, corrected=None, corrected_latex=corrected_form(v)))
        for entry in of_chapter(run(path))
        for v in (entry.verdict,)
    ]


def once(
    settled: Iterable[Entry], places: Mapping[str, str]
) -> tuple[list[Entry], dict[str, list[str]]]:
    """The entries of statements that one file settles, and the files of each that several do.

    ``places`` are the files of the committed statements, which need not have been run.  None of
    two verdicts on one statement counts.
    """
    by_id: dict[str, list[Entry]] = {}
    for entry in settled:
        by_id.setdefault(entry.statement.id, []).append(entry)
    kept, several = [], {}
    for id, entries in by_id.items():
        files = [entry.derivation or "" for entry in entries]
        files += [places[id]] if id in places and places[id] not in files else []
        if len(files) == 1:
            kept += entries
        else:
            several[id] = files
    return kept, several


def twice(id: str, files: Iterable[str]) -> str:
    """What is wrong with a statement that several files settle."""
    return f"{id!r} has a verdict in {' and in '.join(files)}; one file may settle a statement"


def ledger(settled: Iterable[Entry], source: Source | None = None) -> list[Entry]:
    """Every statement that comes with the package in its order, or of a source, then one's own.

    Raises :class:`Twice` where two files settle one of them.
    """
    entries, several = once(settled, {})
    for id, files in several.items():
        raise Twice(twice(id, files))
    found = {entry.statement.id: entry for entry in entries}
    listed = STATEMENTS if source is None else of_source(source)
    entries = [found.get(id) or Entry(s, UNSETTLED, None, 0.0) for id, s in listed.items()]
    return entries + [entry for entry in found.values() if entry.own]


def by_source(entries: Iterable[Entry]) -> str:
    """How many statements are from where."""
    counts = Counter(entry.source for entry in entries)
    of_sources = [f"{counts[s]} of {s.title}" for s in SOURCES[1:] if counts[s]]
    own = [f"{counts[None]} found on the way"] if counts[None] else []
    return ", ".join([f"{counts[PAPER]} of the paper", *of_sources, *own])


def counted(entries: Sequence[Entry]) -> str:
    """The verdicts counted, the undecided ones aloud."""
    counts = Counter(entry.verdict.kind for entry in entries)
    return ", ".join(f"{counts[kind]} {kind}" for kind in Kind if counts[kind])

"""All statements with their verdicts: what `verify` prints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from symhaptic.book.chapters import Chapter, run
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.foreign import Checked, checked
from symhaptic.book.sources import PAPER, SOURCES, STATEMENTS, of_source, source_of
from symhaptic.paper import Statement
from symhaptic.paper.statement import Source
from symhaptic.proof.verdict import UNSETTLED, Kind, Verdict


class Twice(ValueError):
    """A statement that two derivations settle."""


@dataclass(frozen=True)
class Entry:
    """One statement, its verdict, and the derivation that settles it."""

    statement: Statement
    verdict: Verdict
    derivation: str | None
    seconds: float
    own: bool = False
    """Whether it is a user's statement rather than the paper's."""
    rocq: Checked = field(default_factory=Checked)
    """How far Rocq has checked what the statement's theorems say now."""

    @property
    def source(self) -> Source | None:
        """Where the statement is from; None of one that a chapter states itself."""
        return source_of(self.statement.id)

    @property
    def consequence(self) -> str | None:
        """What it means for somebody who built a device on it, where something is wrong."""
        return CONSEQUENCES.get(self.statement.id)

    def as_json(self) -> dict[str, Any]:
        """Return the record of contract `verify --format json`."""
        v = self.verdict
        return {
            "id": self.statement.id,
            "source": self.source and self.source.title,
            "location": self.statement.location,
            "quote": self.statement.quote or None,
            "says": self.statement.says,
            "statement": self.statement.text,
            "verdict": str(v.kind),
            "proposition": v.proposition,
            "definitions": list(v.definitions),
            "rests": list(v.rests),
            "method": v.method,
            "condition": v.condition,
            "corrected": None if v.corrected is None else v.corrected.replace(r"\br ", ""),
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
        id: Entry(
            s.statement,
            s.verdict,
            chapter.source,
            s.seconds,
            own=id not in STATEMENTS,
            rocq=checked(id, s.settlement.judged),
        )
        for id, s in chapter.page.settled.items()
    }
    for id, statement in chapter.page.own.items():
        found.setdefault(id, Entry(statement, UNSETTLED, chapter.source, 0.0, own=True))
    return list(found.values())


def of_derivation(path: Path) -> list[Entry]:
    """Run a derivation; return its statements with their verdicts, ready for another process."""
    found = of_chapter(run(path))
    return [replace(entry, verdict=replace(entry.verdict, claim=None)) for entry in found]


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
    return entries + [replace(e, own=True) for id, e in found.items() if id not in STATEMENTS]


def by_source(entries: Iterable[Entry]) -> str:
    """How many statements are from where."""
    counts = Counter(entry.source for entry in entries)
    of_sources = [f"{counts[s]} of {s.title}" for s in SOURCES[1:] if counts[s]]
    own = [f"{counts[None]} further results"] if counts[None] else []
    return ", ".join([f"{counts[PAPER]} of the paper", *of_sources, *own])


def counted(entries: Sequence[Entry]) -> str:
    """The verdicts counted."""
    counts = Counter(entry.verdict.kind for entry in entries)
    return ", ".join(f"{counts[kind]} {kind}" for kind in Kind if counts[kind])

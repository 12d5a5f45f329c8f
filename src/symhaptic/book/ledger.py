"""All statements with their verdicts: what `verify` prints and what is committed."""

from __future__ import annotations

import json
import pickle
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from symhaptic.book.arrivals import arrived
from symhaptic.book.chapters import Chapter, run
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.foreign import Checked, checked
from symhaptic.book.grounds import not_defined, not_shown
from symhaptic.book.record import Settled
from symhaptic.book.shapes import is_judged, is_statement, is_verdict
from symhaptic.book.sources import (
    CLAIMED,
    PAPER,
    SHIPPED,
    SOURCES,
    STATEMENTS,
    of_source,
    source_of,
)
from symhaptic.notation.latex import latex
from symhaptic.notation.proposition import Proposition, of_print
from symhaptic.paper import Statement
from symhaptic.paper.reading import Printed
from symhaptic.paper.statement import Source
from symhaptic.proof.settle import ACCEPTED, WEIGHED, Settlement
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.units import of_another_unit
from symhaptic.proof.verdict import UNSETTLED, Kind, Unfounded, Verdict, called

GENERATED = "written by `symhaptic report`; do not edit"


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
        corrected = _corrected(v)
        return {
            "id": self.statement.id,
            "source": self.source and self.source.title,
            "location": self.statement.location,
            "statement": self.statement.text,
            "verdict": str(v.kind),
            "argued_for": v.argued_for and str(v.argued_for),
            "proposition": v.proposition,
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
        id: _to_be_compared(
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


def _to_be_compared(entry: Entry, grounds: Settlement) -> Entry:
    """With what the print was compared with; *argued* where that cannot be sent to be compared."""
    kind = entry.verdict.kind
    numbers = bool(grounds.values) and not _comes_with_the_package(entry.statement.id)
    if grounds.judged is not None or not (grounds.derived or numbers) or kind not in WEIGHED:
        return entry
    compared = replace(_forms(grounds), values=tuple(grounds.values) if numbers else ())
    try:
        arrives = isinstance(arrived(pickle.dumps(compared), Path()), Settlement)
    except (pickle.PicklingError, AttributeError, TypeError):
        arrives = False
    if arrives:
        return replace(entry, compared=compared)
    if entry.source is PAPER or kind not in ACCEPTED:
        return entry
    return replace(entry, verdict=replace(entry.verdict, kind=Kind.ARGUED, argued_for=kind))


def _forms(grounds: Settlement) -> Settlement:
    """Of the grounds of a verdict those that are forms, and what is done with them."""
    return Settlement(
        tuple(grounds.derived),
        dict(grounds.given),
        definition=grounds.definition,
        unless=grounds.unless and dict(grounds.unless),
        corrected=grounds.corrected,
        misprint=grounds.misprint,
        definitions=tuple(grounds.definitions),
        signs=tuple(grounds.signs),
        values=tuple(grounds.values),
    )


def _comes_with_the_package(id: str) -> bool:
    """Whether a statement's chapter is one of ours."""
    return id in STATEMENTS and source_of(id) in SHIPPED


def _compared_again(entry: Entry, printed: Printed) -> str | None:
    """What is wrong with the verdict that another process gives by comparing, if anything is."""
    id, kind, compared = entry.statement.id, entry.verdict.kind, entry.compared
    quoted = STATEMENTS[id].quoted if id in STATEMENTS else ()
    if compared is None:
        return None if entry.source is PAPER else f"{id}: {kind}, of what was not compared again"
    try:
        if wrong := not_defined(compared.given, compared.definitions):
            return f"{id}: {wrong}"
        for name, meaning in compared.given.items():
            if wrong := of_another_unit(name, meaning):
                return f"{id}: compared again: {wrong}"
        forms = replace(_forms(compared), quoted=quoted)
        found = replace(forms, assumed=not_shown(forms)).decide(printed)
    except (ArithmeticError, AttributeError, TypeError, ValueError) as wrong_data:
        return f"{id}: compared again: {' '.join(str(wrong_data).split())}"
    return _says_else(entry, found, "compared again")


_SAID = {"counterexample": "counterexample", "rests": "ground", "claim": "claim"}
"""What a verdict says that is found here as well, and how it is called."""


def _says_else(entry: Entry, found: Verdict, how: str) -> str | None:
    """What another process says of a verdict that was not found here, if anything is."""
    id, said = entry.statement.id, entry.verdict
    ours = _comes_with_the_package(id)
    numbers = ours and said.kind is Kind.ENCLOSED and found.kind is Kind.PROVED
    if (found.kind is not said.kind and not numbers) or found.condition != said.condition:
        return f"{id}: {how} it is {found.kind}"
    other = [w for name, w in _SAID.items() if getattr(found, name) != getattr(said, name)]
    if _corrected(found) != _corrected(said):
        other.append("correction")
    if not ours and (found.value, found.radius) != (said.value, said.radius):
        other.append("value")
    return f"{id}: {how} it has another {other[0]}" if other else None


def judged_again(entry: Entry) -> str | None:
    """What is wrong with the verdict that another process gives, if anything is.

    The theorems were derived again when they arrived; here they are held against what the
    statement claims.  Without theorems the print is compared again with what was derived.
    """
    judged, statement, kind = entry.judged, entry.statement, entry.verdict.kind
    known, claim = STATEMENTS.get(statement.id), entry.claim
    if judged is None:
        printed, free = (known or statement).printed, statement.id not in CLAIMED
        if kind not in WEIGHED:
            return None
        if free and not printed and known and known.quoted:
            ours = _comes_with_the_package(statement.id)
            return None if ours else _compared_again(entry, printed)
        if free and printed:
            return _compared_again(entry, printed)
        return f"{statement.id}: {kind} without a theorem, of what is not compared with a formula"
    own = None if claim is None else partial(of_print, claim)
    claimed = CLAIMED.get(statement.id) if known else own
    try:
        found = Settlement(judged=judged, claim=claimed).decide((known or statement).printed)
    except Unfounded as wrong:
        return f"{statement.id}: {wrong}"
    return _says_else(entry, found, "judged again")


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
        replace(entry, verdict=replace(v, corrected=None, corrected_latex=_corrected(v)))
        for entry in of_chapter(run(path))
        for v in (entry.verdict,)
    ]


def _corrected(verdict: Verdict) -> str | None:
    """LaTeX of the right form."""
    if verdict.corrected_latex is None and verdict.corrected is not None:
        return latex(verdict.corrected)
    return verdict.corrected_latex


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


def committed(entries: Iterable[Entry]) -> str:
    """The ledger as committed text: no times, so that it is the same from run to run.

    What Rocq says stands in its own record.
    """
    left_out = ("seconds", "rocq")
    records = [{k: v for k, v in e.as_json().items() if k not in left_out} for e in entries]
    return json.dumps({"generated": GENERATED, "statements": records}, indent=1) + "\n"


def expected(path: Path) -> dict[str, str]:
    """The committed verdict of each statement."""
    data = json.loads(path.read_text(encoding="utf-8"))
    return {r["id"]: called(r["verdict"], r.get("argued_for")) for r in data["statements"]}


def places(path: Path) -> dict[str, str]:
    """The derivation of each statement, as far as the committed ledger tells."""
    data = json.loads(path.read_text(encoding="utf-8"))
    return {r["id"]: r["derivation"] for r in data["statements"] if r["derivation"]}


def surprises(entries: Iterable[Entry], known: dict[str, str], whole: bool = True) -> list[str]:
    """Statements whose verdict is not the committed one; a user's own must hold, or be argued to.

    In a ``whole`` ledger each of the committed ones is there.
    """
    entries = list(entries)
    gone = set(known) - {entry.statement.id for entry in entries} if whole else set()
    lines = [f"{id}: nothing, but the ledger says {known[id]}" for id in sorted(gone)]
    for entry in entries:
        id, kind = entry.statement.id, entry.verdict.named
        if entry.own:
            if entry.verdict.claimed not in ACCEPTED | {Kind.EXTERNAL}:
                lines.append(f"{id}: {entry.verdict}; a statement of one's own is to hold")
        elif kind != known.get(id):
            lines.append(f"{id}: {kind}, but the ledger says {known.get(id, 'nothing')}")
    return lines

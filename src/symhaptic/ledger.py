"""All statements with their verdicts: what `verify` prints and what is committed."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from symhaptic.consequences import CONSEQUENCES
from symhaptic.latex import latex
from symhaptic.library import Chapter, run
from symhaptic.paper import STATEMENTS, Statement
from symhaptic.proof.verdict import PASSES, UNSETTLED, Kind, Verdict

GENERATED = "written by `symhaptic report`; do not edit"


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

    @property
    def consequence(self) -> str | None:
        """What it means for somebody who built a device on it, where something is wrong."""
        return CONSEQUENCES.get(self.statement.id)

    def as_json(self) -> dict[str, Any]:
        """The record of contract `verify --format json`."""
        v = self.verdict
        corrected = _corrected(v)
        return {
            "id": self.statement.id,
            "location": self.statement.location,
            "statement": self.statement.text,
            "verdict": str(v.kind),
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
            "seconds": round(self.seconds, 3),
        }


def of_chapter(chapter: Chapter) -> list[Entry]:
    """The statements that a chapter settles, or states without settling them."""
    found = {
        id: Entry(s.statement, s.verdict, chapter.source, s.seconds, own=id not in STATEMENTS)
        for id, s in chapter.page.settled.items()
    }
    for id, statement in chapter.page.own.items():
        found.setdefault(id, Entry(statement, UNSETTLED, chapter.source, 0.0, own=True))
    return list(found.values())


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


def ledger(settled: Iterable[Entry]) -> list[Entry]:
    """Every statement of the paper in its order, then the users' own.

    Raises :class:`Twice` where two files settle one of them.
    """
    entries, several = once(settled, {})
    for id, files in several.items():
        raise Twice(twice(id, files))
    found = {entry.statement.id: entry for entry in entries}
    entries = [found.get(id) or Entry(s, UNSETTLED, None, 0.0) for id, s in STATEMENTS.items()]
    return entries + [entry for entry in found.values() if entry.own]


def counted(entries: Iterable[Entry]) -> str:
    """The verdicts counted, the undecided ones aloud."""
    counts = Counter(entry.verdict.kind for entry in entries)
    return ", ".join(f"{counts[kind]} {kind}" for kind in Kind if counts[kind])


def committed(entries: Iterable[Entry]) -> str:
    """The ledger as committed text: no times, so that it is the same from run to run."""
    records = [{k: v for k, v in entry.as_json().items() if k != "seconds"} for entry in entries]
    return json.dumps({"generated": GENERATED, "statements": records}, indent=1) + "\n"


def expected(path: Path) -> dict[str, str]:
    """The committed verdict of each statement."""
    data = json.loads(path.read_text(encoding="utf-8"))
    return {record["id"]: record["verdict"] for record in data["statements"]}


def places(path: Path) -> dict[str, str]:
    """The derivation of each statement, as far as the committed ledger tells."""
    data = json.loads(path.read_text(encoding="utf-8"))
    return {r["id"]: r["derivation"] for r in data["statements"] if r["derivation"]}


def surprises(entries: Iterable[Entry], known: dict[str, str], whole: bool = True) -> list[str]:
    """Statements whose verdict is not the committed one; a user's own must hold.

    In a ``whole`` ledger each of the committed ones is there.
    """
    entries = list(entries)
    gone = set(known) - {entry.statement.id for entry in entries} if whole else set()
    lines = [f"{id}: nothing, but the ledger says {known[id]}" for id in sorted(gone)]
    for entry in entries:
        id, kind = entry.statement.id, entry.verdict.kind
        if entry.own:
            if kind not in PASSES | {Kind.QUALIFIED, Kind.EXTERNAL}:
                lines.append(f"{id}: {entry.verdict}")
        elif kind != known.get(id):
            lines.append(f"{id}: {kind}, but the ledger says {known.get(id, 'nothing')}")
    return lines

"""Puts every statement to the test: changed in one place, it must be refused.

What comes out is committed as ``reports/mutants.json``: how many changes of which kind were
refused, and each one that was not, by name and with the reason why it may stand.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import sympy as sp

from symhaptic.book import parallel
from symhaptic.book.chapters import BadChapter, Chapter, run
from symhaptic.book.mutation.judgements import Change
from symhaptic.book.mutation.statements import changes_of
from symhaptic.book.mutation.tables import changes_of_tables

GENERATED = "written by `symhaptic mutants`; do not edit"


@dataclass(frozen=True)
class Survivor:
    """A change that is not refused, and why it may stand; without a reason it is a defect."""

    of: str
    kind: str
    change: str
    why: str | None


@dataclass
class Trial:
    """What became of the changes of one chapter."""

    chapter: str
    statements: dict[str, Counter[str]] = field(default_factory=dict)
    """How many changes of each kind were refused, of a statement and of its grounds."""
    tables: Counter[str] = field(default_factory=Counter)
    """The same of the digits of the paper's tables."""
    survivors: list[Survivor] = field(default_factory=list)

    @property
    def refused(self) -> int:
        """How many changes were refused."""
        return sum(c.total() for c in (*self.statements.values(), self.tables))

    @property
    def accepted(self) -> list[Survivor]:
        """Changes that were taken for right and are not."""
        return [s for s in self.survivors if s.why is None]

    def put(self, of: str, tried: Iterable[Change], counts: Counter[str]) -> None:
        """Ask for each change, and note the answer."""
        for change in tried:
            if change.check.holds():
                survivor = Survivor(of, change.kind, change.what, change.excuse())
                if survivor not in self.survivors:
                    self.survivors.append(survivor)
            else:
                counts[change.kind] += 1

    def as_json(self) -> dict[str, Any]:
        """The record of the chapter."""
        return {
            "statements": {id: dict(sorted(c.items())) for id, c in self.statements.items()},
            "tables": dict(sorted(self.tables.items())),
            "survivors": [[s.of, s.kind, s.change, s.why] for s in self.survivors],
        }


def trial(chapter: Chapter) -> Trial:
    """Every verdict of a chapter, changed in one place at a time."""
    found = Trial(chapter.name)
    for id, settled in chapter.page.settled.items():
        found.put(id, changes_of(settled), found.statements.setdefault(id, Counter()))
    found.put(chapter.name, changes_of_tables(chapter), found.tables)
    return found


def _tried(path: Path) -> Trial:
    return trial(run(path))


def trials(paths: list[Path], workers: int = 1) -> Iterator[Trial]:
    """The trials of chapters, in their order."""
    ended: dict[int, Trial] = {}
    next_ = 0
    for number, result in parallel.each(_tried, paths, workers):
        if isinstance(result, BadChapter):
            raise result
        ended[number] = result
        while next_ in ended:
            yield ended.pop(next_)
            next_ += 1


def ours(path: Path) -> bool:
    """Whether a file may be written: it is not there, or an earlier record of trials."""
    if not path.is_file():
        return True
    with path.open("rb") as stream:
        return GENERATED.encode() in stream.read(200)


def committed(found: Iterable[Trial]) -> str:
    """The trials as committed text.

    How SymPy orders the terms of a sum decides which of them are changed; so its version is noted.
    """
    records = {one.chapter: one.as_json() for one in found}
    return (
        json.dumps({"generated": GENERATED, "sympy": sp.__version__, "chapters": records}, indent=1)
        + "\n"
    )


def stale(path: Path, found: Iterable[Trial]) -> bool:
    """Whether a committed record is not that of these trials.

    Of another SymPy's only the statements are asked, for the changes are others.
    """
    text = path.read_text(encoding="utf-8")
    record, ours = json.loads(text), committed(found)
    if record.get("sympy") != sp.__version__:
        return _statements(record) != _statements(json.loads(ours))
    return text != ours


def _statements(record: dict[str, Any]) -> dict[str, list[str]]:
    """The statements that were changed, chapter by chapter."""
    return {name: sorted(one["statements"]) for name, one in record["chapters"].items()}

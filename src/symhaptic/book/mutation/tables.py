"""Numbers of the paper's tables, each digit changed: does a verdict that rests on it notice?

A table is a tuple of records in :mod:`symhaptic.paper.tables`, with its numbers as printed.  All
chapters that name one are derived again from the changed table; the first of them reports it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from decimal import Decimal, InvalidOperation
from functools import cache
from pathlib import Path
from typing import Any

from symhaptic.book.chapters import BadChapter, Chapter, run, shipped
from symhaptic.book.mutation.judgements import Change, because
from symhaptic.paper import tables
from symhaptic.proof.mutants import misprints
from symhaptic.proof.verdict import Kind

Table = tuple[Any, ...]

UNNOTICED = "no verdict rests on this digit: it is as its source has it"


@dataclass(frozen=True)
class Derived:
    """Chapters, derived from another table, come to the same verdicts."""

    chapters: tuple[Path, ...]
    name: str
    table: Table

    def holds(self) -> bool:
        """By running them, with the table in place of the paper's."""
        before = [_verdicts(path) for path in self.chapters]
        kept = getattr(tables, self.name)
        setattr(tables, self.name, self.table)
        try:
            found = (_found(run(path)) for path in self.chapters)
            return all(now == then for now, then in zip(found, before, strict=True))
        except BadChapter:
            return False
        finally:
            setattr(tables, self.name, kept)


Verdicts = dict[str, tuple[Kind, str | None]]


@cache
def _verdicts(path: Path) -> Verdicts:
    return _found(run(path))


def _found(chapter: Chapter) -> Verdicts:
    return {id: (s.verdict.kind, s.verdict.value) for id, s in chapter.page.settled.items()}


def changes_of_tables(chapter: Chapter, among: Sequence[Path] | None = None) -> Iterator[Change]:
    """Each digit of the tables that a chapter is the first to name, among the paper's chapters."""
    paths = shipped() if among is None else among
    for name, table in known_tables(vars(tables)).items():
        naming = tuple(path for path in paths if name in path.read_text(encoding="utf-8"))
        if naming[:1] != (chapter.path,):
            continue
        for i, row in enumerate(table):
            for field in fields(row):
                text = getattr(row, field.name)
                if not _is_number(text):
                    continue
                for other, _ in misprints(text):
                    changed = (*table[:i], replace(row, **{field.name: other}), *table[i + 1 :])
                    what = f"{name}, row {i + 1}, {field.name}: {other} for {text}"
                    check = Derived(naming, name, changed)
                    yield Change("digit", (what,), check, because(UNNOTICED))


def known_tables(names: Mapping[str, Any]) -> dict[str, Table]:
    """The tuples of records that have a printed number."""
    return {
        name: value
        for name, value in names.items()
        if isinstance(value, tuple)
        and value
        and all(is_dataclass(row) for row in value)
        and any(_is_number(getattr(row, f.name)) for row in value for f in fields(row))
    }


def _is_number(text: Any) -> bool:
    try:
        return isinstance(text, str) and Decimal(text).is_finite()
    except InvalidOperation:
        return False

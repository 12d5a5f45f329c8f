"""Numbers of the paper's tables, each digit changed: does a verdict that rests on it notice?

A table is a tuple of records in :mod:`symhaptic.paper.tables`, with its numbers as printed.  A
chapter that names one is derived again from the changed table.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from decimal import Decimal, InvalidOperation
from typing import Any

from symhaptic.library import BadChapter, Chapter, run
from symhaptic.paper import tables
from symhaptic.proof.changes import Change, because
from symhaptic.proof.mutants import misprints
from symhaptic.proof.verdict import Kind

Table = tuple[Any, ...]

UNNOTICED = "no verdict rests on this digit: it is as its source has it"


@dataclass(frozen=True)
class Derived:
    """A chapter, derived from another table, comes to the same verdicts."""

    chapter: Chapter
    name: str
    table: Table

    def holds(self) -> bool:
        """By running it, with the table in place of the paper's."""
        kept = getattr(tables, self.name)
        setattr(tables, self.name, self.table)
        try:
            return _verdicts(run(self.chapter.path)) == _verdicts(self.chapter)
        except BadChapter:
            return False
        finally:
            setattr(tables, self.name, kept)


def _verdicts(chapter: Chapter) -> dict[str, tuple[Kind, str | None]]:
    return {id: (s.verdict.kind, s.verdict.value) for id, s in chapter.page.settled.items()}


def changes_of_tables(chapter: Chapter) -> Iterator[Change]:
    """Each digit of the tables that a chapter names."""
    source = chapter.path.read_text(encoding="utf-8")
    for name, table in known_tables(vars(tables)).items():
        if name not in source:
            continue
        for i, row in enumerate(table):
            for field in fields(row):
                text = getattr(row, field.name)
                if not _is_number(text):
                    continue
                for other, _ in misprints(text):
                    changed = (*table[:i], replace(row, **{field.name: other}), *table[i + 1 :])
                    what = f"{name}, row {i + 1}, {field.name}: {other} for {text}"
                    check = Derived(chapter, name, changed)
                    yield Change("digit", what, check, because(UNNOTICED))


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

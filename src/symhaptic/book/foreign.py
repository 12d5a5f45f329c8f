"""What a foreign kernel has checked: the committed record, and whether it still is of what is said.

Rocq checks a proposition, and each text that it was given.  The record keeps a mark of both: where
a statement's theorems say something else than the record's, nobody but our own kernel has checked
them, and that is what is told.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from sympy import Add, Basic, Mul

from symhaptic.book.chapters import expected_rocq
from symhaptic.book.rules import classical
from symhaptic.notation.proposition import Proposition, field_names
from symhaptic.proof.theorems.judge import Judged

WHOLE, LEAVES, NOT = "whole", "leaves", "not"
"""Leaves and joins alike; with steps open; nothing of the statement."""

CHANGED = "what it says has changed since Rocq was asked"
UNKNOWN = "not checked with Rocq"

REALS, EXCLUDED = "the axioms of the reals", "excluded middle"
EXTENSIONAL, INTEGERS = "functional extensionality", "primitive integers and floats"
LIBRARY = (REALS, EXCLUDED, EXTENSIONAL, INTEGERS)
"""What a statement may rest on beside classical rules: axioms of Rocq's own library."""


@dataclass(frozen=True)
class Checked:
    """How far Rocq has checked a statement, why no further, and on what it found it to rest."""

    extent: str = NOT
    why: str | None = UNKNOWN
    rests: tuple[str, ...] = ()
    """Classical rules and axioms by name, then what Rocq's own library is built on."""
    stale: bool = False

    def as_json(self) -> dict[str, Any]:
        """The field ``rocq`` of a statement."""
        return {"checked": self.extent, "why": self.why, "rests": list(self.rests)}

    @property
    def rules(self) -> list[str]:
        """The classical rules and axioms among what it rests on."""
        return [name for name in self.rests if name in classical()]

    @property
    def others(self) -> list[str]:
        """What else it rests on, in words: what Rocq's library is built on."""
        return [name for name in LIBRARY if name in self.rests]

    @property
    def reason(self) -> str:
        """Why it is not checked whole, without how many of its steps are open."""
        return re.sub(r"^\d+ steps? open: ", "", self.why or "")


def mark(judged: Judged) -> str:
    """What two judgements share whose theorems say the same."""
    theorems = (judged.theorem, *(case.theorem for case in judged.unless))
    said = [(sorted(map(_said, t.hypotheses)), _said(t.conclusion)) for t in theorems]
    return hashlib.sha256(str(said).encode()).hexdigest()[:16]


def _said(part: Any) -> str:
    """What only equal parts of propositions share."""
    if isinstance(part, Basic):
        return _of_term(part)
    if isinstance(part, Proposition):
        kind: Any = type(part)
        parts = [getattr(part, name) for name in field_names(kind)]
        return f"{kind.__name__}{_said(parts)}"
    if isinstance(part, (tuple, list)):
        return f"({', '.join(map(_said, part))})"
    return repr(part)


@cache
def _of_term(term: Basic) -> str:
    """The same of a term, however its terms and factors are ordered; most stand in many places."""
    parts = [_of_term(part) for part in term.args]
    if isinstance(term, (Add, Mul)):
        parts.sort()
    return f"{term.func.__name__}({', '.join(parts)})" if parts else repr(term)


def checked(id: str, judged: Judged | None, path: Path | None = None) -> Checked:
    """What the record says of a statement, settled by these theorems."""
    known = recorded(path or expected_rocq())["statements"].get(id)
    if known is None:
        return Checked()
    if known["says"] != (None if judged is None else mark(judged)):
        return Checked(NOT, CHANGED, stale=True)
    return Checked(known["checked"], known["why"], tuple(known["rests"]))


@cache
def recorded(path: Path) -> dict[str, Any]:
    """The record; an empty one where none is."""
    if not path.is_file():
        return {"statements": {}, "chapters": {}}
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def listed(names: Sequence[str]) -> str:
    """Names in a sentence.

    >>> listed(["a", "b", "c"])
    'a, b and c'
    """
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last


def asked(path: Path | None = None) -> str:
    """Which Rocq was asked; empty where none was."""
    version = recorded(path or expected_rocq()).get("rocq")
    return f"Rocq {version}" if version else ""


def counted(found: Iterable[Checked]) -> str:
    """How many are checked how far."""
    extents = [one.extent for one in found]
    whole, leaves, rest = (extents.count(kind) for kind in (WHOLE, LEAVES, NOT))
    return f"{whole} whole, {leaves} with steps open, {rest} not"


def leaves(path: Path | None = None) -> str:
    """How many of the deciders' leaves are checked, by their kinds, over all chapters."""
    counts = recorded(path or expected_rocq()).get("leaves", {})
    return listed([_of(kind, *count) for kind, count in counts.items()]) if counts else ""


def _of(kind: str, checked: int, total: int) -> str:
    """How many of a kind.

    >>> _of("limits", 3, 4), _of("limits", 4, 4)
    ('3 of 4 limits', 'all 4 limits')
    """
    return f"all {total} {kind}" if checked == total else f"{checked} of {total} {kind}"

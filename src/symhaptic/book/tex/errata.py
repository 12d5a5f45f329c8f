"""The errata: what is wrong in the paper, or right only under a condition, from the ledger."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from symhaptic.book.consequences import IMPORTANCE
from symhaptic.book.ledger import Entry
from symhaptic.book.sources import PAPER
from symhaptic.book.tex.breaking import width
from symhaptic.book.tex.forms import (
    LONG_CLAIM,
    condition,
    correction,
    formula,
    quoted,
    reference,
    running,
    shown_by,
)
from symhaptic.book.tex.words import prose
from symhaptic.proof.verdict import Kind

WRONG = frozenset({Kind.REFUTED, Kind.MISPRINT, Kind.QUALIFIED, Kind.SLIP})
"""Verdicts of what the errata list."""

AT_HAND = (
    "The source was a text conversion of the accepted manuscript, without its figures. What a "
    "figure shows is known from its caption and from the text alone, and the figures of this book "
    "are drawn anew from the captions. An entry that is marked as possibly of the conversion may "
    "not be in the published paper."
)
"""What the paper was read from."""

OTHERS = "Other entries"
"""What stands in no part of the list of consequences."""


def by_importance(entries: Iterable[Entry]) -> list[tuple[str, list[Entry]]]:
    """The errata of the paper in parts, the gravest first, each with its title."""
    wrong = {e.statement.id: e for e in entries if e.source is PAPER and e.verdict.kind in WRONG}
    parts = [
        (title, [wrong.pop(id) for id in listed if id in wrong]) for title, listed in IMPORTANCE
    ]
    return [(title, found) for title, found in (*parts, (OTHERS, [*wrong.values()])) if found]


def errata(entries: Iterable[Entry], chapters: Mapping[str, int]) -> list[tuple[str, list[str]]]:
    """Title and LaTeX of the errata of each part; ``chapters`` are numbers by source."""
    return [
        (title, [_erratum(entry, chapters) for entry in found])
        for title, found in by_importance(entries)
    ]


def _erratum(entry: Entry, chapters: Mapping[str, int]) -> str:
    """The source's words, its formula, our reading, the proposition, then the verdict."""
    statement, verdict = entry.statement, entry.verdict
    claim = verdict.proposition or ""
    claims = f"{{\\footnotesize ${running(claim)}$}}" if 0 < width(claim) < LONG_CLAIM else ""
    right = correction(verdict)
    wrong = verdict.kind in (Kind.MISPRINT, Kind.SLIP)
    rows = [
        ("the paper", quoted(statement)),
        ("printed", formula(statement)),
        ("read as", prose(statement.says)),
        ("proposition", claims),
        ("verdict", f"\\kind{{{verdict.kind}}}{{{verdict.kind}}}"),
        ("right for", condition(verdict) if verdict.condition else ""),
        ("right" if wrong else "what holds", right),
        ("shown by", "; ".join(map(prose, shown_by(verdict)))),
        ("for a device", prose(entry.consequence or "")),
    ]
    place = chapters.get(entry.derivation or "")
    head = f"{{{reference(statement.id)}}}{{{prose(statement.location)}}}"
    body = "".join(f"\\erratumrow{{{label}}}{{{text}}}" for label, text in rows if text)
    return f"\\erratum{head}{{{place}}}{{{body}}}"

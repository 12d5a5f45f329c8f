"""The errata: what is wrong in the paper, or right only under a condition, from the ledger."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from symhaptic.book.ledger import Entry
from symhaptic.book.sources import PAPER
from symhaptic.book.tex.forms import condition, correction, printed, reference, shown_by
from symhaptic.book.tex.words import escaped, prose
from symhaptic.proof.verdict import Kind

CLASSES = (
    (Kind.REFUTED, "Statements that do not hold"),
    (Kind.MISPRINT, "Misprints and slips"),
    (Kind.QUALIFIED, "Conditions left unstated"),
)
"""In the order in which they matter to a reader."""


def errata(entries: Iterable[Entry], chapters: Mapping[str, int]) -> list[tuple[str, list[str]]]:
    """Title and LaTeX of the errata of each class; ``chapters`` are numbers by source."""
    listed = [entry for entry in entries if entry.source is PAPER]
    found = []
    for kind, title in CLASSES:
        of_kind = [entry for entry in listed if entry.verdict.kind is kind]
        if of_kind:
            found.append((title, [_erratum(entry, chapters) for entry in of_kind]))
    return found


def _erratum(entry: Entry, chapters: Mapping[str, int]) -> str:
    statement, verdict = entry.statement, entry.verdict
    rows = [("printed", printed(statement))]
    if verdict.condition:
        rows.append(("right for", condition(verdict)))
    right = correction(verdict)
    if right:
        rows.append(("right" if verdict.kind is Kind.MISPRINT else "what holds", right))
    shown = "; ".join(shown_by(verdict))
    if shown:
        rows.append(("shown by", shown))
    if entry.consequence:
        rows.append(("for a device", prose(entry.consequence)))
    place = chapters.get(entry.derivation or "")
    head = f"{{{reference(statement.id)}}}{{{escaped(statement.location)}}}"
    body = "".join(f"\\erratumrow{{{label}}}{{{text}}}" for label, text in rows)
    kind = f"\\kind{{{verdict.kind}}}{{{verdict.kind}}}"
    return f"\\erratum{head}{{{kind}}}{{{place}}}{{{body}}}"

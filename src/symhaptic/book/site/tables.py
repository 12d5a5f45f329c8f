"""The pages beside the chapters: the results, the errata, the ledger and what is believed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symhaptic.book.foreign import asked, counted, leaves
from symhaptic.book.ledger import Entry
from symhaptic.book.plain import in_formulas
from symhaptic.book.rests import used
from symhaptic.book.rules import called, classical, says
from symhaptic.book.site.chapter import in_words, kind, statement_in_words, statement_link
from symhaptic.book.site.words import (
    breakable,
    container,
    display,
    heading,
    math,
    plain,
    table,
    words,
)
from symhaptic.book.tex.errata import AT_HAND, by_importance
from symhaptic.book.tex.forms import shown_by
from symhaptic.book.tex.results import USE
from symhaptic.book.tex.words import anchor
from symhaptic.notation.predicates import MEANINGS
from symhaptic.notation.written import defined, written
from symhaptic.proof.theorems.axioms import AXIOMS
from symhaptic.proof.verdict import Kind

Chapters = Mapping[str, tuple[int, str]]
"""Number and name of each chapter, by the file that it is derived in."""


def results(entries: Sequence[Entry]) -> str:
    """The formulas to use, each with its condition."""
    found = {entry.statement.id: entry for entry in entries}
    out = [".. _results:", "", *heading("The formulas to use")]
    out += ["As printed, or as corrected, each with the condition under which it is right.", ""]
    for question, ids in USE:
        out += [f".. rubric:: {words(question)}", ""]
        for id in ids:
            if id in found and found[id].derivation is not None:
                out += _use(found[id])
    return "\n".join(out) + "\n"


def _use(entry: Entry) -> list[str]:
    statement, verdict = entry.statement, entry.verdict
    lines = statement.latex
    if verdict.corrected is not None:
        lines = tuple(verdict.corrected.split(r",\quad "))
    shown = display([f"&{line}" for line in lines]) if lines else [words(statement.says), ""]
    where = [math(statement.domain)] if statement.domain else []
    where += [f"for {math(verdict.condition)}"] if verdict.condition else []
    out = [*shown, *([", ".join(where), ""] if where else [])]
    said = container("verdict", [kind(verdict.kind), "", statement_link(statement.id)])
    return container("step", [*out, *said])


def errata(entries: Sequence[Entry]) -> str:
    """What is wrong, and what is right only under a condition."""
    out = [".. _errata:", "", *heading("Errata")]
    out += [words(AT_HAND), ""]
    parts = by_importance(entries)
    rows = [["statement", "read as", "verdict", "where"]]
    rows += [
        [
            f":ref:`{e.statement.id} <erratum-{e.statement.id}>`",
            words(e.statement.says),
            kind(e.verdict.kind),
            _where(e.statement.location),
        ]
        for _, listed in parts
        for e in listed
    ]
    out += table("ledger", rows)
    for title, listed in parts:
        out += heading(title, "-")
        out += [line for entry in listed for line in _erratum(entry)]
    return "\n".join(out) + "\n"


def _where(location: str) -> str:
    """A section's number on one line; a longer place as it fits."""
    return f":kept:`{plain(location)}`" if location.startswith("Sec. ") else words(location)


def _erratum(entry: Entry) -> list[str]:
    statement, verdict = entry.statement, entry.verdict
    out = [f"{statement_link(statement.id)} — {words(statement.location)}", ""]
    out += statement_in_words(statement)
    if verdict.proposition:
        out += container("claim", [f"Claims {breakable(verdict.proposition)}\\ ."])
    out += [f"Verdict: {kind(verdict.kind)}", ""]
    out += ["Right is:" if of_form(entry) else "It holds:", "", in_words(verdict), ""]
    shown = "; ".join(words(text) for text in shown_by(verdict))
    if shown:
        out += [f"*Shown by* {shown}", ""]
    if entry.consequence:
        out += [f"*For a device:* {words(entry.consequence)}", ""]
    return [f".. _erratum-{statement.id}:", "", *container("statement", out)]


def of_form(entry: Entry) -> bool:
    """Whether something else is right than what is printed."""
    return entry.verdict.kind is not Kind.QUALIFIED


def ledger(entries: Sequence[Entry], chapters: Chapters) -> str:
    """Every statement with its verdict, to be filtered and sorted."""
    head = ["statement", "read as", "verdict", "Rocq", "where", "chapter"]
    rows = [head]
    for entry in entries:
        number, name = chapters.get(entry.derivation or "", (0, ""))
        rows.append(
            [
                statement_link(entry.statement.id) if name else plain(entry.statement.id),
                words(entry.statement.says),
                kind(entry.verdict.kind),
                entry.rocq.extent if asked() else "",
                "own finding" if entry.own else _where(entry.statement.location),
                f":doc:`{number} <{name}>`" if name else "",
            ]
        )
    out = [".. _ledger:", "", *heading("Every statement and its verdict")]
    if asked():
        found = counted(entry.rocq for entry in entries)
        out += [
            f"{asked()}, a second judge, was given the theorems, too: {found}. What it "
            "has checked *whole* rests on classical rules alone; *leaves* have steps open.",
            "",
        ]
        if leaves():
            out += [f"Of the deciders' leaves in all chapters it has checked {leaves()}.", ""]
    return "\n".join([*out, *table("ledger", rows)]) + "\n"


def believed(entries: Sequence[Entry]) -> str:
    """The classical rules with their sources, and what the predicates mean."""
    counts = used(entry.verdict.rests for entry in entries)
    out = [".. _believed:", "", *heading("Everything that has to be believed")]
    out += [
        "A theorem is made by rules only. Classical theorems are applied, not proved; each has "
        "its source, and the number of statements that rest on it.",
        "",
    ]
    for rule, source in classical().items():
        axiom = AXIOMS.get(rule)
        told = breakable(written(axiom.says)) if axiom else words(in_formulas(says(rule)))
        out += [f".. _rule-{anchor(rule)}:", "", f".. rubric:: {plain(called(rule))}", ""]
        out += container("claim", [told]) if rule in AXIOMS else [told, ""]
        out += [f"*Source:* {words(in_formulas(source))}. Statements: {counts[rule]}.", ""]
    out += heading("Predicates, and what they mean", "-")
    for shown, meaning in map(defined, MEANINGS):
        out += [f"{breakable(shown)} — {words(meaning)}.", ""]
    return "\n".join(out) + "\n"

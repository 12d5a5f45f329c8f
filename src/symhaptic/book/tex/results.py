"""The results: which formula to use and when, and what is wrong with what is right.

The choice is made here; formulas, conditions and corrections come from statements and verdicts.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from symhaptic.book.ledger import Entry
from symhaptic.book.tex.errata import by_importance
from symhaptic.book.tex.forms import condition, correction, formula, reference, right_is
from symhaptic.book.tex.words import place_of, prose

USE = (
    ("The largest passive stiffness, and the damping that it takes", ("eq11",)),
    ("Passive or not, at each frequency below $\\pi/T$", ("eq5",)),
    ("The boundary of the passive walls: an arc and a line", ("eq7", "eq8")),
    ("Passive or not in short: without delay, and for light damping", ("eq6", "eq9")),
    (
        "The boundary of the stable walls, for every device and delay",
        ("explicit-boundary",),
    ),
    ("Stable or not, by Jury's inequalities", ("jury-inequalities",)),
    ("The linear limit of stability", ("eq24", "eq25")),
    ("Passive walls are stable", ("s5a-subset",)),
    ("Behind a delay of $(\\ell+\\varepsilon)T$: passive or not", ("fractional-passivity",)),
)
"""What a reader asks, and the statements that answer."""


def results(entries: Iterable[Entry], chapters: Mapping[str, int]) -> dict[str, Any]:
    """What the template needs; ``chapters`` are numbers by source."""
    found = {entry.statement.id: entry for entry in entries}
    use = [
        (question, [_use(found[id], chapters) for id in ids if id in found and _settled(found[id])])
        for question, ids in USE
    ]
    return {
        "use": [(question, rows) for question, rows in use if rows],
        "wrong": [
            (title, [_wrong(entry, chapters) for entry in listed])
            for title, listed in by_importance(found.values())
        ],
    }


def _settled(entry: Entry) -> bool:
    return entry.derivation is not None


def _use(entry: Entry, chapters: Mapping[str, int]) -> dict[str, str]:
    """The right form, its condition, and where it is shown."""
    domain = entry.statement.domain
    right = correction(entry.verdict)
    shown = right or formula(replace(entry.statement, domain="")) or prose(entry.statement.says)
    where = [f"${domain}$"] if domain and not right else []
    where += [f"for {condition(entry.verdict)}"] if entry.verdict.condition else []
    if where:
        shown += f"\\\\[2pt]{{\\footnotesize {', '.join(where)}}}"
    shown = shown.replace(r"\\[10pt]", r"\\[7pt]").replace(r"\\[3pt]", r"\\[1pt]")
    return {"shown": shown, **_place(entry, chapters)}


def _wrong(entry: Entry, chapters: Mapping[str, int]) -> dict[str, str]:
    """What is said in words, and what is right: a correction, or a condition."""
    right = right_is(entry.verdict)
    return {"says": prose(entry.statement.says), "right": right, **_place(entry, chapters)}


def _place(entry: Entry, chapters: Mapping[str, int]) -> dict[str, str]:
    id, kind = entry.statement.id, entry.verdict.kind
    return {
        "place": f"\\statementlink{{{place_of(id)}}}{{{reference(id)}}}",
        "kind": f"\\kind{{{kind}}}{{{kind}}}",
        "chapter": str(chapters.get(entry.derivation or "", "")),
    }

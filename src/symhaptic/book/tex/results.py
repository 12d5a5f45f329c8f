"""The results on two pages: which formula to use and when, and what is wrong with what is right.

The choice is made here; formulas, conditions and corrections come from statements and verdicts.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from symhaptic.book.ledger import Entry
from symhaptic.book.tex.breaking import width
from symhaptic.book.tex.errata import CLASSES
from symhaptic.book.tex.forms import condition, correction, printed, reference
from symhaptic.book.tex.words import prose
from symhaptic.proof.verdict import Kind

USE = (
    ("The largest passive stiffness, and the damping that it takes", ("eq11",)),
    ("Passive or not, at each frequency below $\\pi/T$", ("eq5",)),
    ("The boundary of the passive walls: an arc and a line", ("eq7", "eq8")),
    ("Passive or not in short: without delay, and for light damping", ("eq6", "eq9")),
    (
        "The boundary of the stable walls, for every device and delay",
        ("s4d-explicit-only-undelayed",),
    ),
    ("The linear limit of stability", ("eq24", "eq25")),
    ("Passive walls are stable", ("s5a-subset",)),
    ("Behind a delay of $(\\ell+\\varepsilon)T$: passive or not", ("fractional-passivity",)),
)
"""What a reader asks, and the statements that answer."""


LONG = 70.0
"""Width of a correction in em from which on a reader is told what shows it instead."""


def results(entries: Iterable[Entry], chapters: Mapping[str, int]) -> dict[str, Any]:
    """What the template of the two pages needs; ``chapters`` are numbers by source."""
    found = {entry.statement.id: entry for entry in entries}
    use = [
        (question, [_use(found[id], chapters) for id in ids if id in found and _settled(found[id])])
        for question, ids in USE
    ]
    theirs = [entry for entry in found.values() if not entry.own]
    wrong = [
        (title, [_wrong(entry, chapters) for entry in theirs if entry.verdict.claimed is kind])
        for kind, title in CLASSES
    ]
    return {
        "use": [(question, rows) for question, rows in use if rows],
        "wrong": [(title, rows) for title, rows in wrong if rows],
    }


def _settled(entry: Entry) -> bool:
    return entry.derivation is not None


def _use(entry: Entry, chapters: Mapping[str, int]) -> dict[str, str]:
    """The right form, its condition, and where it is shown."""
    shown = correction(entry.verdict) or printed(entry.statement)
    if entry.verdict.condition:
        shown += f"\\\\[3pt]{{\\footnotesize for {condition(entry.verdict)}}}"
    return {"shown": shown, **_place(entry, chapters)}


def _wrong(entry: Entry, chapters: Mapping[str, int]) -> dict[str, str]:
    """What is said in words, and what is right: a correction, or a condition."""
    verdict = entry.verdict
    text = verdict.corrected_latex or ""
    if verdict.claimed is Kind.QUALIFIED:
        right = f"for {condition(verdict)}"
    elif width(text) > LONG and verdict.shows:
        right = verdict.shows
    else:
        right = _in_words(text) if r"\text" in text else f"\\fitting{{{correction(verdict)}}}"
    return {"says": prose(entry.statement.says), "right": right, **_place(entry, chapters)}


def _in_words(text: str) -> str:
    r"""A correction with words in it as a sentence, which may break between them.

    >>> _in_words(r"\text{at}\ x=1,\ \text{and}\ y")
    'at $x=1$, and $y$'
    """
    parts = re.split(r"\\text\{([^{}]*)\}", text.replace(r",\quad ", r",\ "))
    words = [part if at % 2 else _formulas(part) for at, part in enumerate(parts)]
    return " ".join("".join(words).split()).replace(" ,", ",")


def _formulas(text: str) -> str:
    """Formulas between words, each between dollar signs, with the commas outside."""
    parts = re.split(r"(,?\\ )", text)
    return "".join(
        p.replace(r"\ ", " ") if at % 2 else f"${p}$" if p else "" for at, p in enumerate(parts)
    )


def _place(entry: Entry, chapters: Mapping[str, int]) -> dict[str, str]:
    id, kind = entry.statement.id, entry.verdict.kind
    return {
        "place": f"\\statementlink{{{id}}}{{{reference(id)}}}",
        "kind": f"\\kind{{{kind}}}{{{kind}}}",
        "chapter": str(chapters.get(entry.derivation or "", "")),
    }

"""Everything that has to be believed, for one place in the book: rules, deciders and meanings."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from typing import Any

from symhaptic.book.ledger import Entry
from symhaptic.book.plain import in_formulas
from symhaptic.book.rests import used
from symhaptic.book.rules import called, classical, others, says
from symhaptic.book.tex.forms import running
from symhaptic.book.tex.words import anchor, literally, prose
from symhaptic.notation import SYMBOLS
from symhaptic.notation.predicates import MEANINGS
from symhaptic.notation.written import defined, written
from symhaptic.proof.theorems.axioms import AXIOMS

TITLES = {
    "kernel": "Logic: the rules of the kernel",
    "leaves": "What the deciders know",
}
"""Headings of the modules of rules; all others say what predicates mean."""


def believed(entries: Iterable[Entry]) -> dict[str, Any]:
    """What the template of the page needs."""
    counts = used(entry.verdict.rests for entry in entries)
    lists: dict[str, list[tuple[str, str, int]]] = {}
    for module, rules in others().items():
        title = TITLES.get(module, "What the predicates mean of walls and devices")
        lists.setdefault(title, []).extend(_row(name, text, counts) for name, text in rules.items())
    return {
        "rules": [
            {
                "rule": anchor(rule),
                "name": prose(called(rule)),
                "says": f"${running(written(AXIOMS[rule].says))}$"
                if rule in AXIOMS
                else plain(says(rule)),
                "source": plain(source),
                "count": counts[rule],
            }
            for rule, source in classical().items()
        ],
        "lists": list(lists.items()),
        "predicates": [(shown, prose(meaning)) for shown, meaning in map(defined, MEANINGS)],
    }


def symbols() -> list[tuple[str, str, str]]:
    """Every symbol of the notation with its unit and what it means."""
    return [
        (one.latex, "" if one.unit == "1" else one.unit, with_formulas(one.meaning))
        for one in SYMBOLS.values()
    ]


_NAME = re.compile(r"[A-Za-z]\w*")
_KNOWN = {name: one.latex for name, one in SYMBOLS.items()}
_KNOWN |= {"pi": r"\pi", "tan": r"\tan", "sqrt": "sqrt"}


def with_formulas(meaning: str) -> str:
    r"""What a symbol means, with what is a formula between its commas as one.

    >>> with_formulas("virtual stiffness, K T^2/m")
    'virtual stiffness, $K T^2/m$'
    >>> with_formulas("frequency, sqrt(gamma)")
    'frequency, $\\sqrt{\\gamma}$'
    """
    return ", ".join(_in_symbols(part) or plain(part) for part in meaning.split(", "))


def _in_symbols(text: str) -> str:
    """A formula, if nothing else is in it than symbols."""
    if not (found := set(_NAME.findall(text))) or not found <= _KNOWN.keys():
        return ""
    text = re.sub(r"sqrt\(([^()]*)\)", r"\\sqrt{\1}", text)
    return f"${_NAME.sub(lambda name: _KNOWN[name[0]], text)}$"


def _row(name: str, text: str, counts: Counter[str]) -> tuple[str, str, int]:
    return literally(name.replace("_", " ")), plain(text), counts[name]


def plain(text: str) -> str:
    r"""A docstring's plain words and signs for LaTeX.

    >>> plain("p |- p <= 1")
    '$p\\vdash p\\le1$'
    """
    return prose(in_formulas(text.replace("``", "")))

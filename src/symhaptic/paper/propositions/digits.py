"""Numbers that the text quotes, taken from the transcription.

They are typed only once, in the statement; no claim contains a copy.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from sympy import Expr, Rational, Symbol

from symhaptic.paper import STATEMENTS
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import read


def quoted(id: str) -> tuple[Quoted, ...]:
    """Return the numbers that a statement quotes, in their order."""
    return STATEMENTS[id].quoted


def number(of: Quoted, units: int = 0) -> Rational:
    """A quoted number, so many units of its last digit up.

    >>> number(Quoted("about", "987e3")), number(Quoted("above", "17.8"), 1)
    (987000, 179/10)
    """
    return Rational(of.digits) + units * Rational(str(of.unit))


def bounds(of: Quoted) -> list[Callable[[Expr], Expr]]:
    """What a value must meet that is said to be about, below or above so much.

    >>> from sympy import Symbol
    >>> [bound(Symbol("y")) for bound in bounds(Quoted("about", "0.41"))]
    [y >= 81/200, y < 83/200]
    """
    here, half = number(of), Rational(str(of.unit)) / 2
    return {
        "about": [lambda value: value >= here - half, lambda value: value < here + half],
        "below": [lambda value: value < here],
        "above": [lambda value: value > here],
    }[of.how]


def example(id: str) -> dict[Symbol, Expr]:
    """The values that a statement is printed for, in units of kg, m and s.

    >>> example("eq31")
    {m: 1/10, T: 1/1000}
    """
    domain = STATEMENTS[id].domain
    plain = re.sub(r"\\text\{[^{}]*\}", "", domain)
    return {line.lhs: line.rhs for part in plain.split(r",\ ") for line in read(part)}

"""Rational points of the symbols' domains, where a counterexample is looked for."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TypeAlias

import sympy as sp
from sympy import Expr

from symhaptic.notation import SYMBOLS
from symhaptic.proof.names import admissible

Point: TypeAlias = dict[Expr, Expr]

_CHOICES: dict[str, tuple[str, ...]] = {
    "positive": ("1", "2", "1/2", "3", "1/10"),
    "nonnegative": ("1", "2", "1/2", "0", "3", "1/10"),
    "real": ("1", "-1", "2", "1/2", "-3", "0"),
    "complex": ("2", "1/3", "-2", "3"),
    "(0, pi)": ("1", "2", "1/2", "3", "1/10"),
    "(0, pi/2)": ("1", "1/2", "1/3", "1/10"),
    "[0, 1]": ("1/2", "1", "1/3", "0"),
}
_LIMIT = 400


_FURTHER = (
    *(sp.Rational(v) for v in ("2", "1", "3", "1/2", "-1", "-2", "-1/2", "4", "0")),
    sp.sqrt(2),
    -sp.pi,
    sp.I,
    -2 * sp.I,
)
"""Where those of the domain are not what a symbol is assumed to be."""


def choices(symbol: Expr, anywhere: bool = False) -> tuple[Expr, ...]:
    """Simple values of a symbol's domain, of those that it is assumed to have.

    ``anywhere``: real ones beside a domain that has only some of the real numbers.

    >>> choices(sp.Symbol("n", integer=True, positive=True))
    (1, 2, 3, 4)
    """
    entry = SYMBOLS.get(symbol.name)
    if anywhere and entry and entry.domain != "complex":
        entry = None
    known = tuple(sp.Rational(v) for v in _CHOICES[entry.domain if entry else "real"])
    if len(symbol.assumptions0) == 1:  # that it commutes
        return known
    fitting = [v for v in dict.fromkeys((*known, *_FURTHER)) if admissible(symbol, v)]
    inside = [v for v in fitting if v in known]
    return tuple(inside if entry and inside else fitting[:6])


def points(*exprs: Expr, anywhere: bool = False) -> Iterator[Point]:
    """Rational points of the domain, simple ones first, always in the same order."""
    symbols = sorted({s for e in exprs for s in e.free_symbols}, key=str)
    lists = [choices(symbol, anywhere) for symbol in symbols]
    if not all(lists):
        return
    # first a generic point with different values, then all combinations
    order = itertools.chain(
        (
            tuple(choice[(i + shift) % len(choice)] for i, choice in enumerate(lists))
            for shift in range(5)
        ),
        itertools.product(*lists),
    )
    for values in itertools.islice(order, _LIMIT):
        yield dict(zip(symbols, values, strict=True))

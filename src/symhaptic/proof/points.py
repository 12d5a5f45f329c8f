"""Rational points of the symbols' domains, where a counterexample is looked for."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TypeAlias

import sympy as sp
from sympy import Expr

from symhaptic.notation import SYMBOLS

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


def choices(symbol: Expr) -> tuple[Expr, ...]:
    """Simple values of a symbol's domain."""
    entry = SYMBOLS.get(symbol.name)
    return tuple(sp.Rational(v) for v in _CHOICES[entry.domain if entry else "real"])


def points(*exprs: Expr) -> Iterator[Point]:
    """Rational points of the domain, simple ones first, always in the same order."""
    symbols = sorted({s for e in exprs for s in e.free_symbols}, key=str)
    lists = [choices(symbol) for symbol in symbols]
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

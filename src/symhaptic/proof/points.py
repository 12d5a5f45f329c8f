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


_ENDS: dict[str, tuple[Expr | None, bool, Expr | None, bool]] = {
    "positive": (sp.S.Zero, False, None, False),
    "nonnegative": (sp.S.Zero, True, None, False),
    "real": (None, False, None, False),
    "(0, pi)": (sp.S.Zero, False, sp.pi, False),
    "(0, pi/2)": (sp.S.Zero, False, sp.pi / 2, False),
    "[0, 1]": (sp.S.Zero, True, sp.S.One, True),
}
"""Lowest and highest number of a domain, and whether each belongs to it."""


def outside(symbol: Expr, value: Expr) -> bool:
    """Whether a number is known to lie outside of the domain that the notation gives a symbol.

    >>> outside(sp.Symbol("T"), sp.S.Zero), outside(sp.Symbol("d"), sp.S.Zero)
    (True, False)
    """
    entry = SYMBOLS.get(symbol.name) if isinstance(symbol, sp.Symbol) else None
    if entry is None or entry.domain == "complex":
        return False
    low, with_low, high, with_high = _ENDS[entry.domain]
    beyond = value.is_extended_real is False
    for end, belongs, way in ((low, with_low, value), (high, with_high, -value)):
        if end is not None:
            room = way - (end if way is value else -end)
            beyond = beyond or room.is_negative is True or (room.is_zero is True and not belongs)
    return beyond

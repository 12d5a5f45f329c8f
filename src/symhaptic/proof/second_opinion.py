"""A second opinion on a changed claim that a checker confirms: is it wrong, or is it true too?

By other roads than those of the checkers: SymPy's numbers at scattered points, NumPy's roots and
exact fractions.  It may call a wrong claim true, never a true one wrong; it settles nothing.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from fractions import Fraction

import numpy as np
import sympy as sp
from flint import arb
from sympy import Expr
from sympy.core.relational import Relational

from symhaptic.notation import SYMBOLS
from symhaptic.paper.quoted import Quoted

_RANGES = {
    "positive": (Fraction(1, 10), Fraction(3)),
    "nonnegative": (Fraction(1, 10), Fraction(3)),
    "(0, pi)": (Fraction(1, 10), Fraction(3)),
    "(0, pi/2)": (Fraction(1, 10), Fraction(3, 2)),
    "[0, 1]": (Fraction(0), Fraction(1)),
}
_ELSEWHERE = (Fraction(-3), Fraction(3))
_CLOSE = sp.Float("1e-20")
_DIGITS = 40


def scattered(symbols: set[Expr], count: int) -> Iterator[dict[Expr, Expr]]:
    """Points of the symbols' domains, the same ones every time."""
    dice = random.Random(0)
    for _ in range(count):
        point = {}
        for symbol in sorted(symbols, key=str):
            entry = SYMBOLS.get(symbol.name)
            low, high = _RANGES.get(entry.domain if entry else "", _ELSEWHERE)
            value = low + (high - low) * Fraction(dice.randint(1, 999), 1000)
            point[symbol] = sp.Rational(value.numerator, value.denominator)
        yield point


def number(expr: Expr, point: Mapping[Expr, Expr]) -> Expr | None:
    """The value at a point, an unknown function taken for one that we know; None if undefined."""
    known = expr.replace(
        lambda part: isinstance(part, sp.core.function.AppliedUndef),
        lambda part: sum((k + 2) * arg**2 + arg for k, arg in enumerate(part.args)) / 7,
    )
    value = sp.N(known.xreplace(dict(point)), _DIGITS)
    return value if value.is_number and value.is_finite else None


def alike(
    left: tuple[Expr, ...],
    right: tuple[Expr, ...],
    given: Mapping[Expr, Expr] | None = None,
    count: int = 6,
) -> bool:
    """Whether two forms agree wherever they are tried; relations up to a positive factor.

    >>> x = sp.Symbol("x")
    >>> alike((sp.sin(x)**2,), (1 - sp.cos(x)**2,)), alike((x < 1,), (2*x < 2,))
    (True, True)
    >>> alike((x < 1,), (x <= 1,)), alike((sp.sin(x),), (x,))
    (False, False)
    """
    return len(left) == len(right) and all(
        _agree(one, other, dict(given or {}), count) for one, other in zip(left, right, strict=True)
    )


def _agree(left: Expr, right: Expr, given: dict[Expr, Expr], count: int) -> bool:
    if isinstance(left, Relational) != isinstance(right, Relational):
        return False
    if not isinstance(left, Relational):
        pairs = _values(left, right, given, count)
        return all(abs(one - other) < _CLOSE * (1 + abs(one)) for one, other in pairs)
    less = (sp.StrictLessThan, sp.LessThan)
    left, right = (r.reversed if isinstance(r, less) else r for r in (left, right))
    if left.func != right.func:
        return False
    amounts = _values(left.lhs - left.rhs, right.lhs - right.rhs, given, count)
    ratios = [other / one for one, other in amounts if abs(one) > _CLOSE]
    signed = isinstance(left, (sp.Eq, sp.Ne))
    return bool(ratios) and all(
        abs(r - ratios[0]) < _CLOSE * abs(ratios[0]) and (signed or sp.re(r) > 0) for r in ratios
    )


def _values(
    left: Expr, right: Expr, given: dict[Expr, Expr], count: int
) -> Iterator[tuple[Expr, Expr]]:
    left, right = left.xreplace(given), right.xreplace(given)
    for point in scattered(left.free_symbols | right.free_symbols, count):
        values = number(left, point), number(right, point)
        if None not in values:
            yield values


def largest_root(
    polynomial: Expr, at: Mapping[Expr, Expr], given: Mapping[Expr, Expr], half: bool
) -> float:
    """The largest modulus of the roots, of those on the right with ``half``; not enclosed."""
    placed = polynomial.subs({s: v for s, v in at.items() if v.is_Integer})
    values = {s: sp.N(v) for s, v in at.items()}
    values |= {s: sp.N(v.xreplace(values)) for s, v in given.items()}
    (variable,) = placed.free_symbols - set(values)
    coefficients = sp.Poly(placed, variable).all_coeffs()
    numbers = [complex(sp.N(c.xreplace(values))) for c in coefficients]
    roots = np.roots(np.trim_zeros(numbers))
    return float(max((abs(r) for r in roots if not half or r.real > 0), default=0.0))


def says(quoted: Quoted, ball: arb) -> bool | None:
    """Whether a quoted number is right, from the ends of the ball in exact fractions.

    >>> says(Quoted("about", "0.41"), arb("0.414 +/- 0.0001")), says(Quoted("below", "3"), arb(4))
    (True, False)
    """
    ends = [_fraction(ball.lower()), _fraction(ball.upper())]
    printed, half = Fraction(quoted.digits), Fraction(quoted.unit) / 2
    answers = {
        {
            "about": abs(end - printed) < half,
            "below": end < printed,
            "above": end > printed,
        }[quoted.how]
        for end in ends
    }
    return answers.pop() if len(answers) == 1 else None


def _fraction(number: arb) -> Fraction:
    mantissa, exponent = number.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)

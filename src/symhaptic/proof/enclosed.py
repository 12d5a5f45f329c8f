"""Numbers in balls, with what shows that they lie there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp
from flint import arb
from sympy import Expr

from symhaptic.proof.ball import ball, is_real
from symhaptic.proof.certificate import Certificate, Zero
from symhaptic.proof.roots import (
    BITS,
    Algebraic,
    NoSuchRoot,
    between_decimals,
    is_minimal,
    root_between,
)


@dataclass(frozen=True)
class Enclosed:
    """A real number in a ball that the package computed, from what it could check."""

    ball: arb
    certificates: tuple[Certificate, ...] = ()
    """Of the zeros and signs that the ball rests on."""


Source: TypeAlias = Expr | Zero | Algebraic | Enclosed
"""What a number can come from: an expression without symbols, a certified zero, an algebraic number
with its minimal polynomial, or what was computed from such."""


def enclosed(source: Source) -> Enclosed:
    """A number with what shows it.

    Raises :class:`TypeError` for a bare ball, which nothing shows, and
    :class:`~symhaptic.proof.roots.NoSuchRoot` for an expression that is no real number.

    >>> print(enclosed(sp.sqrt(2)).ball.str(10))
    [1.414213562 +/- 3.74e-10]
    """
    if isinstance(source, Enclosed):
        return source
    if isinstance(source, Zero):
        return Enclosed(source.ball, (source,))
    if isinstance(source, Algebraic):
        if not is_minimal(source):
            raise NoSuchRoot(f"{source.minimal} is not shown to be a minimal polynomial")
        return Enclosed(source.ball, ())
    if isinstance(source, arb):
        raise TypeError(
            f"a bare ball {source.str(5)} shows nothing; give the expression whose value it is, a "
            "Zero, an Algebraic, or what `value` of symhaptic.proof.enclosed makes of them"
        )
    return value(sp.sympify(source))


def value(expr: Expr, at: Mapping[Expr, Source] | None = None) -> Enclosed:
    """The value of an expression, its symbols standing for numbers that are shown.

    >>> x = sp.Symbol("x")
    >>> print(value(x**2, {x: sp.pi}).ball.str(10, radius=False))
    9.869604401
    """
    expr, known = sp.sympify(expr), {s: enclosed(v) for s, v in (at or {}).items()}
    if unknown := expr.free_symbols - set(known):
        raise NoSuchRoot(f"{expr} has no value without {', '.join(sorted(map(str, unknown)))}")
    found = ball(expr, {s: v.ball for s, v in known.items()}, BITS)
    if not (found.is_finite() and (found.imag.is_zero() or is_real(expr))):
        raise NoSuchRoot(f"{expr} is not shown to be a real number")
    below = {id(c): c for number in known.values() for c in number.certificates}
    return Enclosed(found.real, tuple(below.values()))


def root(polynomial: Expr, lower: Expr, upper: Expr) -> Enclosed:
    """The only root of a rational polynomial between two numbers."""
    return Enclosed(root_between(polynomial, lower, upper), ())


def sign_change(
    function: Callable[[sp.Rational], arb], lower: Expr, upper: Expr, places: int = 24
) -> Enclosed:
    """Two neighbouring decimals between which a continuous function changes its sign."""
    return Enclosed(between_decimals(function, lower, upper, places), ())


def given(balls: Mapping[Expr, Enclosed]) -> dict[Expr, arb]:
    """The balls alone, as box and recheck take them."""
    return {symbol: number.ball for symbol, number in balls.items()}

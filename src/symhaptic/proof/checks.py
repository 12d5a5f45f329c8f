"""What a chapter asks of the checkers, kept with its arguments so that it can be asked again.

The page keeps each question that was answered with yes; :mod:`symhaptic.proof.changes` asks it
again with something changed, and the answer must then be no.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from typing import Protocol

import sympy as sp
from flint import arb, ctx
from sympy import Expr

from symhaptic.proof.ball import differs_from_zero, largest_root
from symhaptic.proof.decide import compare, equal
from symhaptic.proof.normal import is_zero
from symhaptic.proof.points import Point, points
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.roots import BITS, Algebraic, NoSuchRoot, rational_polynomial, real_roots
from symhaptic.proof.series import limit
from symhaptic.proof.box import NotShown
from symhaptic.proof.sign import Fact
from symhaptic.proof.units import UnitError, dimension_of

REFUSALS = (NotShown, NoSuchRoot, UnitError, Unsupported, Undefined)
"""What a checker raises that does not confirm what it was asked."""


class Check(Protocol):
    """A question that a checker answers."""

    def holds(self) -> bool:
        """Whether the checker confirms it; raising one of the refusals is a no."""
        ...


def confirmed(check: Check) -> bool:
    """The answer to a question.

    >>> x = sp.Symbol("x")
    >>> confirmed(Same((2 * x,), (x + x,))), confirmed(Limit(1 / x, x, sp.S.Zero, sp.S.Zero))
    (True, False)
    """
    try:
        return bool(check.holds())
    except REFUSALS:
        return False


@dataclass(frozen=True)
class Same:
    """Two forms say the same."""

    left: tuple[Expr, ...]
    right: tuple[Expr, ...]

    def holds(self) -> bool:
        """By the normal form."""
        return equal(self.left, self.right)


@dataclass(frozen=True)
class Different:
    """Two forms do not say the same."""

    left: tuple[Expr, ...]
    right: tuple[Expr, ...]

    def holds(self) -> bool:
        """By a point where they differ."""
        return compare(self.left, self.right).equal is False


@dataclass(frozen=True)
class Limit:
    """An expression tends to a value."""

    expr: Expr
    variable: sp.Symbol
    at: Expr
    value: Expr

    def holds(self) -> bool:
        """By exact series."""
        return equal(limit(self.expr, self.variable, self.at), self.value)


@dataclass(frozen=True)
class Free:
    """An expression that contains a symbol does not change with it, or does."""

    expr: Expr
    symbol: sp.Symbol
    free: bool = True

    def holds(self) -> bool:
        """By the normal form of the difference at two values; not by the derivative.

        That is zero for floor(x) and for atan(x) + atan(1/x), too, which jump.
        """
        if self.symbol not in self.expr.free_symbols:
            return False
        if self.free:
            other = sp.Dummy(self.symbol.name, **self.symbol.assumptions0)
            return is_zero(self.expr - self.expr.xreplace({self.symbol: other}))
        slope = sp.diff(self.expr, self.symbol)
        tried = itertools.islice(points(slope), 9)
        return any(differs_from_zero(slope, point) for point in tried)


@dataclass(frozen=True)
class Roots:
    """All roots of a polynomial in z lie inside the unit circle, or one lies outside."""

    polynomial: Expr
    at: Point = field(default_factory=dict)
    given: Mapping[Expr, Expr] = field(default_factory=dict)
    half: bool = False
    inside: bool = True

    def largest(self) -> arb:
        """The largest modulus; with ``half`` of those that have, or may have, Re z > 0."""
        half, inside = self.half, self.inside
        return largest_root(
            self.polynomial,
            self.at,
            self.given,
            lambda z: not half or (not z.real < 0 if inside else z.real > 0),
        )

    def holds(self) -> bool:
        """By balls around the roots."""
        return bool(self.largest() < 1 if self.inside else self.largest() > 1)


@dataclass(frozen=True)
class AllZeros:
    """The real zeros of a polynomial in an interval are these, one in each ball, and no other."""

    coefficients: tuple[arb, ...]
    """The lowest first."""
    between: tuple[arb, arb]
    zeros: tuple[arb, ...]

    def holds(self) -> bool:
        """By balls around all of its roots."""
        low, high = self.between
        found = [y for y in real_roots(self.coefficients) if not (y < low or y > high)]
        return len(found) == len(self.zeros) and all(
            one.overlaps(other) for one, other in zip(found, self.zeros, strict=True)
        )


@dataclass(frozen=True)
class Decimals:
    """A number begins with these decimals."""

    value: arb
    text: str

    def holds(self) -> bool:
        """By the ball around it."""
        unit = Decimal(1).scaleb(int(Decimal(self.text).as_tuple().exponent))
        with ctx.workprec(BITS):
            lower, upper = arb(self.text), arb(str(Decimal(self.text) + unit))
            return bool(self.value >= lower.lower() and self.value < upper.upper())


@dataclass(frozen=True)
class Minimal:
    """A number has this minimal polynomial, and is its smallest positive root."""

    number: Algebraic

    def holds(self) -> bool:
        """By its factors over the rationals, and balls around its roots."""
        polynomial = rational_polynomial(self.number.minimal)
        if [count for _, count in polynomial.factor()[1]] != [1]:
            return False
        with ctx.workprec(BITS):
            roots = [r.real for r, _ in polynomial.complex_roots() if r.imag.is_zero()]
        found = [r for r in roots if r > 0 and not r > self.number.ball]
        return len(found) == 1 and bool(found[0].overlaps(self.number.ball))


@dataclass(frozen=True)
class Units:
    """The units of an expression agree."""

    meaning: Expr

    def holds(self) -> bool:
        """By dimensional analysis."""
        dimension_of(self.meaning)
        return True


@dataclass(frozen=True)
class Sign:
    """A fact follows by the rule that it was made by."""

    fact: Fact

    def holds(self) -> bool:
        """Made again, it says no less and rests on no more."""
        if self.fact.made is None:
            return False
        made = self.fact.made
        again = made.rule(*made.args, **made.named)
        return (
            again.expr == self.fact.expr
            and (again.strict or not self.fact.strict)
            and again.rests <= self.fact.rests
        )

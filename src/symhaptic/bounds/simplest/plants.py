"""Sampled plants whose spring, damper and virtual damping lie in intervals.

A formula in the plant's numbers, whose balls are those of :mod:`symhaptic.proof.plants`, is a
SymPy expression of :mod:`symhaptic.model`, turned into operations on balls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple, TypeAlias

import sympy as sp
from flint import arb
from sympy import Expr
from sympy.printing.pycode import PythonCodePrinter

from symhaptic.bounds.balls import exact
from symhaptic.notation import delta, gamma
from symhaptic.proof.derivative import derivative
from symhaptic.proof.plants import AT_ONE, LATE, LOSS, TOGETHER, with_slopes

BITS = 96
"""Working precision."""

NAMES = (LOSS, TOGETHER, LATE, AT_ONE, gamma, delta)
"""What a formula may contain beside its own variables."""


class NotEnclosed(ValueError):
    """Nothing is shown on a box; on a smaller one it may be."""


class NotCovered(NotEnclosed):
    """Nothing is shown on a box, and would not be on a part of it; the message says why."""


class Interval(NamedTuple):
    """Numbers between two exact ones."""

    low: Fraction
    high: Fraction

    @property
    def middle(self) -> Fraction:
        """The number half way."""
        return (self.low + self.high) / 2

    @property
    def ball(self) -> arb:
        """A ball around all of it."""
        return exact(self.low).union(exact(self.high))

    @property
    def point(self) -> Interval:
        """The middle alone."""
        return Interval(self.middle, self.middle)

    def halves(self) -> tuple[Interval, Interval]:
        """The lower and the upper half."""
        return Interval(self.low, self.middle), Interval(self.middle, self.high)


NOTHING = Interval(Fraction(0), Fraction(0))
"""The interval of what is left out."""

Box: TypeAlias = tuple[Interval, ...]
"""Intervals of gamma and delta, and of beta where the virtual damping is given."""


class Found(NamedTuple):
    """A stiffness limit on a box: its values, its slopes by each interval, and where it is."""

    value: arb
    slopes: tuple[arb, ...]
    hint: object = None
    """What a smaller box may start from."""


Limit: TypeAlias = Callable[[Box, object], Found]
"""Finds a stiffness limit on a box; raises :class:`NotEnclosed`."""


class Numbers(NamedTuple):
    """Balls of ``NAMES``, and of their slopes by gamma and by delta."""

    values: tuple[arb, ...]
    by_gamma: tuple[arb, ...]
    by_delta: tuple[arb, ...]


@lru_cache(maxsize=4096)
def numbers(spring: Interval, damper: Interval) -> Numbers:
    """The plant's numbers for all springs and dampers of two intervals.

    Those of the middle, and the slopes times the way from there, are closer than those of the
    whole intervals.
    """
    wide = _numbers(spring.ball, damper.ball)
    middle = _numbers(exact(spring.middle), exact(damper.middle))
    ways = spring.ball - exact(spring.middle), damper.ball - exact(damper.middle)
    along = zip(middle.values, wide.by_gamma, wide.by_delta, strict=True)
    return wide._replace(values=tuple(v + g * ways[0] + f * ways[1] for v, g, f in along))


def _numbers(g: arb, dl: arb) -> Numbers:
    nil, one = arb(0), arb(1)
    found = (*with_slopes(g, dl, (gamma, delta)), (g, one, nil), (dl, nil, one))
    return Numbers(*zip(*found, strict=True))


class _Printer(PythonCodePrinter):  # type: ignore[misc]
    def _print_Rational(self, expr: Expr) -> str:
        return f"(arb({expr.p})/{expr.q})"  # a fraction of Python's would be a float

    def _print_Pow(self, expr: Expr, rational: bool = False) -> str:
        if expr.exp.is_Integer:
            return f"power({self._print(expr.base)}, {expr.exp})"
        return str(super()._print_Pow(expr, rational=rational))

    def _print_Pi(self, expr: Expr) -> str:
        return "arb.pi()"


def _power(base: arb, exponent: int) -> arb:
    """A whole power; python-flint's own takes a logarithm, which a ball around 0 has not."""
    product = arb(1)
    for _ in range(abs(exponent)):
        product = product * base
    return product if exponent > 0 else 1 / product


_FUNCTIONS = {
    "arb": arb,
    "power": _power,
    "sin": lambda x: arb(x).sin(),
    "cos": lambda x: arb(x).cos(),
    "tan": lambda x: arb(x).tan(),
    "sqrt": lambda x: arb(x).sqrt(),
}


def compiled(exprs: Sequence[Expr], given: Sequence[sp.Symbol] = NAMES) -> Callable[..., list[arb]]:
    """Balls of expressions, for balls of the symbols ``given``."""
    formulas = [sp.sympify(x) for x in exprs]
    for x in formulas:
        if x.has(sp.Float) or x.free_symbols - set(given):
            raise ValueError(f"{x} is no formula in {given}")
    printer = _Printer({"fully_qualified_modules": False, "user_functions": {}})
    made: Callable[..., list[arb]] = sp.lambdify(
        given, formulas, modules=[_FUNCTIONS], printer=printer, cse=True, docstring_limit=0
    )
    return made


class Formula:
    """An expression in one variable and the plant's numbers, with its slopes, in balls."""

    def __init__(self, expr: Expr, variable: sp.Symbol) -> None:
        slope = derivative(expr, variable)
        asked = [expr], [slope], [derivative(slope, variable)], [derivative(expr, n) for n in NAMES]
        made = (compiled(exprs, (variable, *NAMES)) for exprs in asked)
        self._values, self._slopes, self._bends, self._parts = made

    def value(self, at: arb, x: Numbers) -> arb:
        """The expression."""
        return self._values(at, *x.values)[0]

    def slope(self, at: arb, x: Numbers) -> arb:
        """Its derivative by the variable."""
        return self._slopes(at, *x.values)[0]

    def bend(self, at: arb, x: Numbers) -> arb:
        """Its second derivative by the variable."""
        return self._bends(at, *x.values)[0]

    def by_plant(self, at: arb, x: Numbers) -> tuple[arb, arb]:
        """Its derivatives by gamma and delta."""
        parts = self._parts(at, *x.values)
        return chained(parts, x.by_gamma), chained(parts, x.by_delta)


def chained(parts: Sequence[arb], slopes: Sequence[arb]) -> arb:
    """A derivative by the chain rule."""
    return sum((p * s for p, s in zip(parts, slopes, strict=True)), arb(0))

"""Power series of the device, for slow poles: sums of both of their powers."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial

import sympy as sp
from sympy import Expr, Symbol, factorial
from sympy.logic.boolalg import Boolean

from symhaptic.export.pairs import exact, minus, rounded, scaled
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine
from symhaptic.export.steps import Steps
from symhaptic.notation import delta, gamma

NEAR = sp.Rational(9, 4)
"""Up to this size of the larger real pole power series are used."""

TINY = sp.Rational(1, 8)
"""Up to this size fewer terms do: a haptic device has slow poles."""

_CAREFUL = 4
"""Last terms of a series with signs that are added up to twice the precision."""

w, h = sp.symbols("w h")


def _sizes(precision: Precision, ahead: Callable[[Expr, int], Expr]) -> tuple[int, int]:
    """Terms that serve for slow poles and for all; ``ahead`` bounds those of a size from k on."""
    few, all_ = (precision.terms(partial(ahead, size)) for size in (TINY, NEAR))
    return few, all_


def _simplex(size: Expr, k: int) -> Expr:
    """Of a divided difference of exp at three nodes: the sum of k + 1 products is over (k + 2)!."""
    return 2 * (k + 1) * size**k / factorial(k + 2)


def _square(first: int, size: Expr, k: int) -> Expr:
    """The same of an even or an odd function of two squares."""
    return 2 * (k + 1) * size ** (2 * k) / factorial(2 * k + first)


def _slow(half: Expr, square: Expr) -> Boolean:
    """Whether half + sqrt |square| is at most TINY."""
    return sp.And(half < TINY / 2, sp.Abs(square) < TINY**2 / 4)


def _powers(
    do: Steps, slow: Boolean, start: tuple[str, ...], terms: tuple[int, int], first: range,
    step: Callable[[Steps, tuple[Symbol, ...], Expr], Iterable[Expr]],
) -> tuple[Symbol, ...]:  # fmt: skip
    """Horner's scheme from the last term on; for slow poles from an earlier one.

    ``first`` are the n of the first two terms, each of which has the coefficient 1/n!.
    """
    few, all_ = (first.start + (count - 1) * first.step for count in terms)
    factorials = range(all_, first.start - 1, -first.step)
    return do.sum(dict.fromkeys(start, sp.S.Zero), step, factorials, slow, few)


def plant_n1_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of exp at h, sqrt w and -sqrt w, less 1/2."""
    do = Steps()
    few, all_ = _sizes(precision, _simplex)

    def step(do: Steps, states: tuple[Symbol, ...], number: Expr) -> Iterable[Expr]:
        total, one, two = states
        even = do("even", number + w * two)
        return even + h * total, even, one

    names, terms = ("total", "one", "two"), (few - 1, all_ - 1)
    total, _, two = _powers(do, _slow(h, w), names, terms, range(3, 5), step)
    return do.routine("PlantN1Series", "divided difference of exp at h and +-sqrt(w), less 1/2",
                      (h, w), w * two + h * total)  # fmt: skip


def plant_n0_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of exp at 0, p and q, with p + q = delta and p q = gamma, less 1/2."""
    do = Steps()
    few, all_ = (size - _CAREFUL for size in _sizes(precision, _simplex))

    def step(do: Steps, states: tuple[Symbol, ...], number: Expr) -> Iterable[Expr]:
        one, two = states
        return number + delta * one - gamma * two, one

    first = range(_CAREFUL + 2, _CAREFUL + 4)
    one, two = _powers(do, _slow(delta / 2, gamma), ("one", "two"), (few, all_), first, step)
    one_low: Expr = sp.S.Zero
    two_low: Expr = sp.S.Zero
    for k in range(_CAREFUL - 1, -1, -1):
        number = 1 / factorial(k + 2) if k else sp.S.Zero
        given = gamma, delta, one, one_low, two, two_low, number
        two, two_low = one, one_low
        one, one_low = do.several(("one", "one_low"), "PlantN0Term", *given)
    return do.routine("PlantN0Series", "divided difference of exp at 0, p and q, less 1/2",
                      (gamma, delta), rounded((one, one_low)))  # fmt: skip


def plant_n0_term() -> Routine:
    """The step of Horner's scheme for PlantN0Series, to twice the precision."""
    do = Steps()
    given = sp.symbols("one one_low two two_low number")
    one, one_low, two, two_low, number = given
    grown, less = scaled(do, delta, (one, one_low)), scaled(do, gamma, (two, two_low))
    total, low = minus(do, minus(do, grown, less), exact(-number))
    return do.routine("PlantN0Term", "number + delta one - gamma two and what it misses, of pairs",
                      (gamma, delta, *given), {"total": total, "total_low": low})  # fmt: skip


def numerator_at_one_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of cosh(sqrt) at h^2 and w, less 1/2."""
    do = Steps()
    found = _mixed(do, 2, precision)
    return do.routine("NumeratorAtOneSeries",
                      "divided difference of cosh(sqrt) at h^2 and w, less 1/2",
                      (h, w), found)  # fmt: skip


def _mixed(do: Steps, first: int, precision: Precision) -> Expr:
    """Sum over i and j, not both 0, of (h^2)^j w^i/(2 (i + j) + first)!."""
    few, all_ = _sizes(precision, partial(_square, first))
    y = do("y", h * h)

    def step(do: Steps, states: tuple[Symbol, ...], number: Expr) -> Iterable[Expr]:
        total, inner = states
        inner = do("own", number + w * inner)
        return inner + y * total, inner

    names, terms = ("total", "inner"), (few - 1, all_ - 1)
    total, inner = _powers(do, _slow(h, w), names, terms, range(first + 2, first + 6, 2), step)
    return w * inner + y * total


def numerator_gap_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6."""
    do = Steps()
    _, missed = precision.parts(sp.Rational(1, 6))
    found = _mixed(do, 3, precision)
    return do.routine("NumeratorGapSeries", "divided difference of sinh(sqrt)/sqrt at h^2 and w, "
                      "less the float next to 1/6", (h, w), found + missed)  # fmt: skip


PRECISE = (plant_n1_series, plant_n0_series, numerator_at_one_series, numerator_gap_series)
ROUTINES = (plant_n0_term,)

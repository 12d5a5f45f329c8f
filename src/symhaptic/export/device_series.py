"""Power series of the device, for slow poles: sums of both of their powers."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import sympy as sp
from sympy import Expr, factorial
from sympy.logic.boolalg import Boolean

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import (
    Routine,
    Steps,
    choose,
    difference,
    product,
)
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


def rise_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of exp at h, sqrt w and -sqrt w, less 1/2."""
    do = Steps()

    def added(terms: int) -> Expr:
        even = [sp.S.Zero] * (terms + 2)
        total: Expr = sp.S.Zero
        for k in range(terms - 1, -1, -1):
            own = 1 / factorial(k + 2) if k else sp.S.Zero
            even[k] = do(f"e{k}", own + w * even[k + 2])
            total = do(f"b{k}", even[k] + h * total)
        return total

    few, all_ = map(added, _sizes(precision, _simplex))
    return do.routine("RiseSeries", "divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2",
                      (h, w), choose(_slow(h, w), few, all_))  # fmt: skip


def fall_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of exp at 0, p and q, with p + q = delta and p q = gamma, less 1/2."""
    do = Steps()

    def added(terms: int) -> Expr:
        one: Expr = sp.S.Zero
        two: Expr = sp.S.Zero
        for k in range(terms - 1, _CAREFUL - 1, -1):
            one, two = do(f"b{k}", 1 / factorial(k + 2) + delta * one - gamma * two), one
        one_low: Expr = sp.S.Zero
        two_low: Expr = sp.S.Zero
        for k in range(_CAREFUL - 1, -1, -1):
            own = 1 / factorial(k + 2) if k else sp.S.Zero
            grown, grown_low = product(do, delta, one, one_low)
            less, less_low = product(do, gamma, two, two_low)
            total, lost = difference(do, grown, less)
            total, more = difference(do, total, -own)
            low = do("low", lost + more + (grown_low - less_low))
            one, one_low, two, two_low = total, low, one, one_low
        return one + one_low

    few, all_ = map(added, _sizes(precision, _simplex))
    return do.routine("FallSeries", "divided difference of exp at 0, p and q, less 1/2",
                      (gamma, delta), choose(_slow(delta / 2, gamma), few, all_))  # fmt: skip


def together_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of cosh(sqrt) at h^2 and w, less 1/2."""
    do = Steps()
    few, all_ = (
        _mixed(do, [1 / factorial(2 * k + 2) for k in range(terms)])
        for terms in _sizes(precision, partial(_square, 2))
    )
    return do.routine("TogetherSeries", "divided difference of cosh(sqrt) at h^2 and w, less 1/2",
                      (h, w), choose(_slow(h, w), few, all_))  # fmt: skip


def _mixed(do: Steps, coefficients: list[Expr]) -> Expr:
    """Sum over i and j of (h^2)^j w^i times coefficient i + j, less the first."""
    y = do("y", h * h)
    inner: Expr = sp.S.Zero
    total: Expr = sp.S.Zero
    for k in range(len(coefficients) - 1, -1, -1):
        inner = do(f"e{k}", (coefficients[k] if k else sp.S.Zero) + w * inner)
        total = do(f"b{k}", inner + y * total)
    return total


def apart_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6."""
    do = Steps()
    _, missed = precision.parts(sp.Rational(1, 6))
    few, all_ = (
        _mixed(do, [1 / factorial(2 * k + 3) for k in range(terms)])
        for terms in _sizes(precision, partial(_square, 3))
    )
    return do.routine("ApartSeries", "divided difference of sinh(sqrt)/sqrt at h^2 and w, less the "
                      "float next to 1/6", (h, w),
                      choose(_slow(h, w), few + missed, all_ + missed))  # fmt: skip


PRECISE = (rise_series, fall_series, together_series, apart_series)
ROUTINES: tuple[Callable[[], Routine], ...] = ()

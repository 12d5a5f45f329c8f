r"""Exponentials and waves as a float and what it misses.

The libraries' exp, expm1, sin and cos are off by half a last place and more, which differences
magnify.  Where such a function is close to 1, its series below is exact to a small part of that:
the leading terms are added without rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, cos, exp, factorial, sin

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, Steps, choose, fast_sum, product, quotient

BRIEF = sp.Rational(3, 4)
"""Up to this rate 1 - exp(-rate) is found from its series, beyond it from exp(-rate)."""

SLOW = sp.Rational(3, 2)
"""The same for the squared angle of a wave: cos is still above 1/4."""

x, w = sp.symbols("x w")


@dataclass(frozen=True)
class Fading:
    """exp(-rate) and (1 - exp(-rate))/rate."""

    fall: Expr
    fall_low: Expr
    mean: Expr
    mean_low: Expr


def briefly(do: Steps, given: Expr, low: Expr) -> tuple[Expr, ...]:
    """Both of Fading and what they miss, for a rate up to BRIEF."""
    first, lost = fast_sum(do, sp.S.One, -given / 2)
    curved = do("curved", given * given * sp.Function("DecaySeries")(given))
    mean, more = fast_sum(do, first, curved)
    mean_low = do("mean_low", (lost + more) - low * (sp.S.Half - given / 3 + given * given / 8))
    gone, off = product(do, given, mean, mean_low)
    fall, rest = fast_sum(do, sp.S.One, -gone)
    fall_low = do("fall_low", rest - (off + low * mean))
    return fall, fall_low, mean, mean_low


def fallen(do: Steps, rate: Expr) -> tuple[Expr, Expr]:
    """exp(-rate) and what it misses, for a rate up to twice BRIEF: the square of that of half."""
    fall, low, _, _ = briefly(do, do("given", rate / 2), sp.S.Zero)
    return product(do, fall, fall, 2 * low)


def fading(do: Steps, rate: Expr, low: Expr) -> Fading:
    """The pair for rate + low."""
    brief = do("rate", rate) < BRIEF
    given = do("given", choose(brief, rate, 0))
    fall, fall_low, mean, mean_low = briefly(do, given, low)
    sunk = do("sunk", exp(-rate))
    sunk_low = do("sunk_low", -sunk * low)
    top, top_low = fast_sum(do, sp.S.One, -sunk)
    bottom = do("bottom", choose(brief, 1, rate))
    far, far_low = quotient(do, top, bottom, top_low - sunk_low, low)
    return Fading(
        do("fall", choose(brief, fall, sunk)),
        do("fall_low", choose(brief, fall_low, sunk_low)),
        do("mean", choose(brief, mean, far)),
        do("mean_low", choose(brief, mean_low, far_low)),
    )


@dataclass(frozen=True)
class Wave:
    """cos(angle) and sin(angle)/angle."""

    even: Expr
    even_low: Expr
    odd: Expr
    odd_low: Expr


def waving(do: Steps, square: Expr, square_low: Expr, angle: Expr, angle_low: Expr) -> Wave:
    """The pair for angle + angle_low, whose square, taken negative, is square + square_low."""
    square = do("square", square)
    slow = square > -SLOW
    given = do("given", choose(slow, square, 0))
    first, lost = fast_sum(do, sp.S.One, given / 2)
    curved = do("curved", given * given * sp.Function("CosSeries")(given))
    even, more = fast_sum(do, first, curved)
    even_low = do("even_low", lost + more + square_low / 2)
    bent = do("bent", given * sp.Function("SinSeries")(given))
    odd, rest = fast_sum(do, sp.S.One, bent)
    odd_low = do("odd_low", rest + square_low / 6)
    sine, cosine = do("sine", sin(angle)), do("cosine", cos(angle))
    some = do("some", choose(slow, 1, angle))
    ratio, missed = quotient(do, sine, some, angle_low * cosine, angle_low)
    return Wave(
        do("even", choose(slow, even, cosine)),
        do("even_low", choose(slow, even_low, -angle_low * sine)),
        do("odd", choose(slow, odd, ratio)),
        do("odd_low", choose(slow, odd_low, missed)),
    )


def polynomial(do: Steps, at: Expr, coefficients: list[Expr]) -> Expr:
    """The sum of coefficient k times at^k, its even and its odd half side by side."""
    square = do("square", at * at)
    halves: list[Expr] = [sp.S.Zero, sp.S.Zero]
    for k in range(len(coefficients) - 1, -1, -1):
        halves[k % 2] = do(f"b{k}", coefficients[k] + square * halves[k % 2])
    return halves[0] + at * halves[1]


def decay_series(precision: Precision = DOUBLE) -> Routine:
    """From its third term on."""
    do = Steps()
    count = precision.terms(lambda k: BRIEF**k / factorial(k + 3))
    total = polynomial(do, -x, [1 / factorial(k + 3) for k in range(count)])
    return do.routine("DecaySeries", "((1 - exp(-x))/x - 1 + x/2)/x^2", (x,), total)


def cos_series(precision: Precision = DOUBLE) -> Routine:
    """From its third term on."""
    do = Steps()
    count = precision.terms(lambda k: SLOW**k / factorial(2 * k + 4))
    total = polynomial(do, w, [1 / factorial(2 * k + 4) for k in range(count)])
    return do.routine("CosSeries", "(cosh(sqrt(w)) - 1 - w/2)/w^2", (w,), total)


def sin_series(precision: Precision = DOUBLE) -> Routine:
    """From its second term on."""
    do = Steps()
    count = precision.terms(lambda k: SLOW**k / factorial(2 * k + 3))
    total = polynomial(do, w, [1 / factorial(2 * k + 3) for k in range(count)])
    return do.routine("SinSeries", "(sinh(sqrt(w))/sqrt(w) - 1)/w", (w,), total)


PRECISE = (decay_series, cos_series, sin_series)
ROUTINES: tuple[Callable[[], Routine], ...] = ()

r"""Exponentials and waves as a float and what it misses.

The libraries' exp, expm1, sin and cos are off by half a last place and more, which differences
magnify.  Where such a function is close to 1, its series below is exact to a small part of that:
the leading terms are added without rounding.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Symbol, cos, exp, factorial, sin

from symhaptic.export.pairs import (
    Pair,
    exact,
    fast_two_sum,
    one_minus,
    one_plus,
    over,
    squared,
    times,
)
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, TwoProdError, choose
from symhaptic.export.steps import Steps

BRIEF = sp.Rational(3, 4)
"""Up to this rate 1 - exp(-rate) is found from its series, beyond it from exp(-rate)."""

SLOW = sp.Rational(3, 2)
"""The same for the squared angle of a wave: cos is still above 1/4."""

x, w, rate, low = sp.symbols("x w rate rate_low")


@dataclass(frozen=True)
class Fading:
    """exp(-rate) and (1 - exp(-rate))/rate."""

    fall: Pair
    mean: Pair

    @property
    def flat(self) -> tuple[Expr, ...]:
        """Both, and what they miss."""
        return (*self.fall, *self.mean)


_FADING = "fall", "fall_low", "mean", "mean_low"


def _fading(do: Steps, routine: str, rate: Pair) -> Fading:
    fall, fall_low, mean, mean_low = do.several(_FADING, routine, *rate)
    return Fading((fall, fall_low), (mean, mean_low))


def briefly(do: Steps, rate: Pair) -> Fading:
    """Both of Fading and what they miss, for a rate up to BRIEF."""
    return _fading(do, "BriefFading", rate)


def brief_fading() -> Routine:
    """From the series of the mean."""
    do = Steps()
    first, lost = fast_two_sum(do, sp.S.One, -rate / 2)
    curved = do("curved", rate * rate * sp.Function("DecaySeries")(rate))
    mean, more = fast_two_sum(do, first, curved)
    bent = do("bent", low * (sp.S.Half - rate / 3 + rate * rate / 8))
    whole = mean, do("mean_low", (lost + more) - bent)
    found = Fading(one_minus(do, times(do, (rate, low), whole)), whole)
    return do.routine("BriefFading", "exp(-rate), (1 - exp(-rate))/rate and what they miss, for a "
                      "rate up to 3/4", (rate, low), dict(zip(_FADING, found.flat, strict=True)),
                      "Fading")  # fmt: skip


def fallen(do: Steps, rate: Expr) -> Pair:
    """exp(-rate) and what it misses, for a rate up to twice BRIEF: the square of that of half."""
    return squared(do, briefly(do, exact(rate / 2)).fall)


def fading(do: Steps, rate: Pair) -> Fading:
    """The same for any rate."""
    return _fading(do, "FadingPair", rate)


def fading_pair() -> Routine:
    """Beyond its series, from exp."""
    do = Steps()
    brief = rate < BRIEF
    near = briefly(do, (do("given", choose(brief, rate, 0)), low))
    sunk = do("sunk", exp(-rate))
    fall = sunk, do("sunk_low", -sunk * low)
    bottom = do("bottom", choose(brief, 1, rate))
    far = Fading(fall, over(do, one_minus(do, fall), (bottom, low)))
    found = {name: choose(brief, one, two)
             for name, one, two in zip(_FADING, near.flat, far.flat, strict=True)}  # fmt: skip
    return do.routine("FadingPair", "exp(-rate), (1 - exp(-rate))/rate and what they miss",
                      (rate, low), found, "Fading")  # fmt: skip


@dataclass(frozen=True)
class Wave:
    """cos(angle) and sin(angle)/angle."""

    even: Pair
    odd: Pair


_WAVE = "even", "even_low", "odd", "odd_low"


def root_low(square: Expr, square_low: Expr, root: Expr) -> Expr:
    """What the root of the size of square + square_low misses."""
    return sp.Function("RootMiss")(square, square_low, root)


def root_miss() -> Routine:
    """From what is left of the square, which is exact."""
    do = Steps()
    square, square_low, root = given = sp.symbols("square square_low root")
    sign_low = do("sign_low", choose(square < 0, -square_low, square_low))
    left = do("left", sp.Abs(square) - root * root)
    left = do("left", left - TwoProdError(root, root))
    left = do("left", left + sign_low)
    return do.routine("RootMiss", "what the root of |square + square_low| misses", given,
                      left / do.nonzero(root) / 2)  # fmt: skip


def waving(do: Steps, square: Pair, angle: Expr) -> Wave:
    """Of the root of minus a square, of which the float is known."""
    even, even_low, odd, odd_low = do.several(_WAVE, "WavingPair", *square, angle)
    return Wave((even, even_low), (odd, odd_low))


def waving_pair() -> Routine:
    """Beyond their series, from cos and sin."""
    do = Steps()
    square, square_low, angle = given = sp.symbols("square square_low angle")
    slow = square > -SLOW
    small = do("small", choose(slow, square, 0))
    first, lost = fast_two_sum(do, sp.S.One, small / 2)
    curved = do("curved", small * small * sp.Function("CosSeries")(small))
    even, more = fast_two_sum(do, first, curved)
    both = do("both", lost + more)
    odd = one_plus(do, (do("bent", small * sp.Function("SinSeries")(small)), square_low / 6))
    near = even, both + square_low / 2, *odd
    angle_low = do("angle_low", root_low(square, square_low, angle))
    sine, cosine = do("sine", sin(angle)), do("cosine", cos(angle))
    some = do("some", choose(slow, 1, angle))
    far = cosine, -angle_low * sine, *over(do, (sine, angle_low * cosine), (some, angle_low))
    found = {name: choose(slow, one, two) for name, one, two in zip(_WAVE, near, far, strict=True)}
    return do.routine("WavingPair", "cos(angle), sin(angle)/angle and what they miss, where "
                      "-square is the square of the angle", given, found, "Wave")  # fmt: skip


def polynomial(do: Steps, at: Expr, factorials: range) -> Expr:
    """The sum of at^k/n! for the n of a range, its even and its odd half side by side."""
    square = do("square", at * at)

    def step(inner: Steps, states: tuple[Symbol, ...], number: Symbol) -> Iterable[Expr]:
        one, two = states
        return inner("both", number + square * two), one

    start = dict.fromkeys(("one", "two"), sp.S.Zero)
    one, two = do.sum(start, step, factorials[:0:-1])
    return 1 / factorial(factorials[0]) + at * one + square * two


def decay_series(precision: Precision = DOUBLE) -> Routine:
    """From its third term on."""
    do = Steps()
    count = precision.terms(lambda k: BRIEF**k / factorial(k + 3))
    total = polynomial(do, -x, range(3, count + 3))
    return do.routine("DecaySeries", "((1 - exp(-x))/x - 1 + x/2)/x^2", (x,), total)


def cos_series(precision: Precision = DOUBLE) -> Routine:
    """From its third term on."""
    do = Steps()
    count = precision.terms(lambda k: SLOW**k / factorial(2 * k + 4))
    total = polynomial(do, w, range(4, 2 * count + 4, 2))
    return do.routine("CosSeries", "(cosh(sqrt(w)) - 1 - w/2)/w^2", (w,), total)


def sin_series(precision: Precision = DOUBLE) -> Routine:
    """From its second term on."""
    do = Steps()
    count = precision.terms(lambda k: SLOW**k / factorial(2 * k + 3))
    total = polynomial(do, w, range(3, 2 * count + 3, 2))
    return do.routine("SinSeries", "(sinh(sqrt(w))/sqrt(w) - 1)/w", (w,), total)


PRECISE = (decay_series, cos_series, sin_series)
ROUTINES = (brief_fading, fading_pair, root_miss, waving_pair)

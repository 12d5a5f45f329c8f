"""The force that moves the sampled device, as routines: the differences in A/z and M are exact.

That is, rounded once: what the boundary of stability loses there it magnifies.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import And, Expr, cos, exp, sin, tan

from symhaptic.export.double_word import root_low
from symhaptic.export.pairs import (
    Pair,
    exact,
    fast_two_sum,
    minus,
    one_minus,
    plus,
    rounded,
    scaled,
    times,
    two_diff,
)
from symhaptic.export.routine import Routine, TwoProdError, choose, expm1
from symhaptic.export.steps import Steps
from symhaptic.notation import psi

_PART = "part of A/(z M), M over A being the device, at z = exp(2 j psi)"
_DEVICE = sp.symbols("at_one at_minus_one loss together apart across")


def less(do: Steps, one: Expr, factor: Expr, square: Expr, low: Expr) -> Pair:
    """one - factor (square + low), the larger part first.

    In numbers, not in pairs: the routine has to be short enough for compilers to find its tangent
    together with that of its caller.
    """
    taken = do("taken", factor * square)
    total, lost = two_diff(do, one, taken)
    missed = do("missed", TwoProdError(factor, square) + factor * low)
    return fast_two_sum(do, total, do("lost", lost - missed))


@dataclass(frozen=True)
class _Force:
    """A/z and M at z = exp(2 j psi), over cos(psi)^2, with what their floats miss."""

    above: Expr
    above_low: Expr
    above_j: Expr
    below: Expr
    below_low: Expr
    below_j: Expr
    size: Expr
    """The squared size of M."""


def _force(do: Steps) -> _Force:
    at_one, at_minus_one, loss, together, apart, across = _DEVICE
    t = do("t", tan(psi))
    square, low = do("square", t * t), do("low", TwoProdError(t, t))
    above, above_low = less(do, at_one, at_minus_one, square, low)
    below, below_low = less(do, together, apart, square, low)
    above_j, below_j = do("above_j", 2 * t * loss), do("below_j", t * across)
    rest = do("rest", below_j * below_j + 2 * below * below_low)
    size = do("size", below * below + rest)
    return _Force(above, above_low, above_j, below, below_low, below_j, size)


def in_phase() -> Routine:
    """The real part."""
    do = Steps()
    f = _force(do)
    low = do("low", f.above_low * f.below + f.above * f.below_low)
    found = do("found", f.above * f.below + (do("rest", f.above_j * f.below_j + low)))
    return do.routine("InPhase", f"the real {_PART}",
                      (psi, *_DEVICE), found / f.size)  # fmt: skip


def ahead() -> Routine:
    """The imaginary part."""
    do = Steps()
    f = _force(do)
    low = do("low", f.above_j * f.below_low - f.above_low * f.below_j)
    found = do("found", f.above_j * f.below - f.above * f.below_j)
    return do.routine("Ahead", f"the imaginary {_PART}",
                      (psi, *_DEVICE), do("found", found + low) / f.size)  # fmt: skip


def fractional_numerator_gap() -> Routine:
    """A sum of four, one of them a product of four, rounded once."""
    do = Steps()
    given = sp.symbols("epsilon x x_low y y_low first last turned")
    epsilon, x, x_low, y, y_low, first, last, turned = given
    share = scaled(do, epsilon, one_minus(do, exact(epsilon)))
    found, low = times(do, share, times(do, (x, x_low), (y, y_low)))
    left = minus(do, exact(first), (2 * found, 2 * low))
    left = plus(do, minus(do, left, exact(last)), exact(turned))
    about = "m2 - m1 + m0 of the device behind a fraction of a period"
    return do.routine("FractionalNumeratorGap", about, given, rounded(left))


_GIVEN = sp.symbols("found gamma delta part")
_MOTION = ("half", "w", "w_low", "root", "reach")


def half_turned() -> Routine:
    """Only a device that swings half a turn and more, hardly damped, has to be looked at."""
    do = Steps()
    found, gamma, delta, _ = _GIVEN
    half, w, _, root, _ = do.several(_MOTION, "DeviceMotion", gamma, delta)
    swings = And(w < 0, root > 3, half < _LIGHT)
    return do.routine("HalfTurned", "m2 - m1 + m0 behind a fraction of a period", _GIVEN,
                      choose(swings, sp.Function("HalfTurnedSwing")(*_GIVEN[1:]), found),
                      )  # fmt: skip


def half_turned_swing() -> Routine:
    """Of half the angles that the device turns in a period and in its two parts.

    Without damping it is a product, and each other term is as small as the damping.
    """
    do = Steps()
    _, gamma, delta, part = _GIVEN
    half, w, w_low, root, _ = do.several(_MOTION, "DeviceMotion", gamma, delta)
    angle = do("angle", root / 2), do("angle_low", root_low(w, w_low, root) / 2)
    odd, even = _waves(do, angle)
    rest = fast_two_sum(do, sp.S.One, -part)
    (sine_1, cosine_1), (sine_2, cosine_2) = (
        _waves(do, times(do, angle, share)) for share in (rest, exact(part))
    )
    along = do("along", cosine_1 * cosine_2 + sine_1 * sine_2)
    across = do("across", sine_1 * cosine_2 - cosine_1 * sine_2)
    before = do("before", sp.S.Half - part)
    step = do("step", expm1(half / 2))
    weak = do("weak", (step + step / (1 + step)) / 2)
    more = do("more", step * step / (1 + step) / 2)  # by which the cosine is larger than 1
    strong = do("strong", 1 + more)
    fallen = do("fallen", expm1(-half * before))
    grown = do("grown", 1 + fallen)
    ratio = do("ratio", half / do.divisor(root))
    lost = do("lost", weak * weak - even * along * (fallen * strong + more))
    turned = do("turned", grown * weak * odd * (across - ratio * along))
    kept = do("kept", grown * strong * even * ratio * across)
    total = do("total", lost + (turned - kept) - 2 * even * sine_1 * sine_2)
    return do.routine("HalfTurnedSwing", "m2 - m1 + m0 of a device that swings, hardly damped",
                      _GIVEN[1:], 4 * exp(-half) * total / do.divisor(gamma))  # fmt: skip


_LIGHT = sp.Rational(1, 4)
"""Half the damping up to which the sum of small terms rounds less."""


def _waves(do: Steps, angle: Pair) -> tuple[Expr, Expr]:
    """Sine and cosine of an angle, and of what its float misses."""
    wave, still = do("wave", sin(angle[0])), do("still", cos(angle[0]))
    return do("sine", wave + angle[1] * still), do("cosine", still - angle[1] * wave)


ROUTINES = (in_phase, ahead, fractional_numerator_gap, half_turned, half_turned_swing)
PRECISE = ()

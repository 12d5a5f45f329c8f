r"""n1 and n0 of a device that has just swung whole turns in a period, without their cancellation.

With the damping h = delta/2, E = exp(-h), eta = root - 2 pi k and c = 1 - cos(eta),

    gamma n1 = h (Decay(h) - E sin(eta)/root) + E c,
    gamma n0 = E (c - h (Decay(h) - sin(eta)/root)),
    gamma (n1 + n0) = (1 - E)^2 + 2 E c,

where root^2 = gamma - h^2: the closed forms, which take cos(root) from 1, rounded.  All terms of n1
are positive; those of n0 differ, it changes its sign at delta near eta^2.  What decides is eta:
root^2 - (2 pi k)^2 over root + 2 pi k, with (2 pi)^2 in three floats, as no float is (2 pi k)^2.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy import And, Expr, floor, pi

from symhaptic.export.double_word import BRIEF, SLOW, Fading, briefly, root_low
from symhaptic.export.pairs import (
    Pair,
    exact,
    fast_two_sum,
    minus,
    one_minus,
    over,
    plus,
    rounded,
    scaled,
    squared,
    times,
    two_diff,
)
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps

half, square, square_low, root, stiff = GIVEN = sp.symbols("half square square_low root stiff")


@dataclass(frozen=True)
class Turned:
    """What both are made of, each as a float and what it misses."""

    fade: Fading
    """exp(-h) and Decay(h)."""
    lifted: Pair
    """E c."""
    lift: Pair
    """c."""
    wave: Pair
    """sin(eta)/root."""


_FOUND = "near", "risen", "sunk", "moved"


def turned(do: Steps, *given: Expr) -> tuple[Expr, Expr, Expr, Expr]:
    """1 if a device swings and is near whole turns; n1, n0 and n1 + n0 there, else nothing."""
    near, risen, sunk, moved = do.several(_FOUND, "WholeTurns", *given)
    return near, risen, sunk, moved


def whole_turns(precision: Precision) -> Routine:
    """Of root^2 = -square - square_low; what decides is the angle beyond whole turns."""
    do = Steps()
    swings = And(root > 3, root < 2 ** (precision.bits // 2), half < BRIEF)  # so far k^2 is exact
    count = do("count", floor(root / (2 * pi) + sp.S.Half))
    missed = do("missed", root_low(square, square_low, root))
    eta, eta_low = _beyond(do, count, missed, precision)
    far = do("far", eta * eta)
    near = And(count > 0, far < SLOW)
    eta, eta_low = do("eta", choose(near, eta, 0)), do("eta_low", choose(near, eta_low, 0))
    y, y_low = squared(do, (eta, eta_low))
    bent = do("bent", y * y * sp.Function("CosSeries")(-y))
    lift, lost = fast_two_sum(do, y / 2, -bent)
    flat, flat_low = one_minus(do, exact(y * sp.Function("SinSeries")(-y)))
    rise = lift, do("lift_low", lost + y_low * flat / 2)
    sine, sine_low = scaled(do, eta, (flat, flat_low))
    some = do("some", choose(near, root, 1))
    wave = over(do, (sine, sine_low + eta_low * (1 - lift)), (some, missed))
    fade = briefly(do, exact(half))
    t = Turned(fade, times(do, fade.fall, rise), rise, wave)
    some = do.divisor(stiff)
    moved = _risen(do, t, half), _fallen(do, t, half), _both(do, t)
    found = sp.S.One, *(rounded(over(do, pair, exact(some))) for pair in moved)
    results = {name: choose(swings, choose(near, value, 0), 0)
               for name, value in zip(_FOUND, found, strict=True)}  # fmt: skip
    return do.routine("WholeTurns", "whether the device has nearly swung whole turns; n1, n0 and "
                      "n1 + n0 there", GIVEN, results, "Turns")  # fmt: skip


def _beyond(do: Steps, count: Expr, missed: Expr, precision: Precision) -> Pair:
    """Root - 2 pi count."""
    large, middle, small = precision.parts(4 * pi**2, 3)
    turns = do("turns", count * count)
    most, most_low = scaled(do, turns, exact(large))
    more, more_low = scaled(do, turns, exact(middle))
    left, one = two_diff(do, -square, most)
    left, two = two_diff(do, left, most_low)
    left, three = two_diff(do, left, more)
    left, four = two_diff(do, left, square_low)
    turned = do("turned_low", turns * small)
    low = do("low", one + two + three + four - (more_low + turned))
    left, low = two_diff(do, left, -low)
    once, once_low = precision.parts(2 * pi)
    way, way_low = scaled(do, count, exact(once))
    both, lost = two_diff(do, root, -way)
    back = do("back", count * once_low)
    both_low = do("both_low", lost + (way_low + back) + missed)
    return over(do, (left, low), (do.divisor(both), both_low))


def _risen(do: Steps, t: Turned, given: Expr) -> Pair:
    """n1, times gamma."""
    rest = minus(do, t.fade.mean, times(do, t.fade.fall, t.wave))
    return plus(do, scaled(do, given, rest), t.lifted)


def _fallen(do: Steps, t: Turned, given: Expr) -> Pair:
    """n0, times gamma."""
    rest = minus(do, t.fade.mean, t.wave)
    total, low = minus(do, t.lift, scaled(do, given, rest))
    return times(do, t.fade.fall, two_diff(do, total, -low))


def _both(do: Steps, t: Turned) -> Pair:
    """n1 + n0, times gamma: (1 - E)^2 and 2 E c."""
    gone = fast_two_sum(do, *one_minus(do, t.fade.fall))
    return plus(do, squared(do, gone), (2 * t.lifted[0], 2 * t.lifted[1]))


ROUTINES: tuple[Callable[[], Routine], ...] = ()
PRECISE = (whole_turns,)

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

from dataclasses import dataclass

import sympy as sp
from sympy import And, Expr, floor, pi
from sympy.logic.boolalg import Boolean

from symhaptic.export.pairs import BRIEF, SLOW, briefly
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Steps, choose, difference, fast_sum, product, quotient


@dataclass(frozen=True)
class Turned:
    """What both are made of, each as a float and what it misses."""

    near: Boolean
    """Whether the device swings, and is near whole turns."""
    half: Expr
    fall: Expr
    fall_low: Expr
    mean: Expr
    """Decay(h)."""
    mean_low: Expr
    lift: Expr
    """c."""
    lift_low: Expr
    wave: Expr
    """sin(eta)/root."""
    wave_low: Expr


def turned(
    do: Steps, half: Expr, square: Expr, square_low: Expr, root: Expr, root_low: Expr,
    precision: Precision,
) -> Turned:  # fmt: skip
    """The steps that find them, of root^2 = -square - square_low; harmless where it is not near."""
    swings = And(square < 0, root < 2 ** (precision.bits // 2))  # so far k^2 is exact
    count = do("count", choose(swings, floor(root / (2 * pi) + sp.S.Half), 0))
    eta, eta_low = _beyond(do, count, square, square_low, root, root_low, precision)
    far = do("far", eta * eta)
    near = And(count > 0, far < SLOW, half < BRIEF)
    eta, eta_low = do("eta", choose(near, eta, 0)), do("eta_low", choose(near, eta_low, 0))
    y, y_low = product(do, eta, eta, 2 * eta_low)
    bent = do("bent", y * y * sp.Function("CosSeries")(-y))
    lift, lost = fast_sum(do, y / 2, -bent)
    flat, flat_low = fast_sum(do, sp.S.One, -y * sp.Function("SinSeries")(-y))
    lift_low = do("lift_low", lost + y_low * flat / 2)
    sine, sine_low = product(do, eta, flat, flat_low)
    some = do("some", choose(near, root, 1))
    wave, wave_low = quotient(do, sine, some, sine_low + eta_low * (1 - lift), root_low)
    given = do("given", choose(near, half, 0))
    fall, fall_low, mean, mean_low = briefly(do, given, sp.S.Zero)
    return Turned(
        near, given, fall, fall_low, mean, mean_low, lift, lift_low, wave, wave_low
    )  # fmt: skip


def _beyond(
    do: Steps, count: Expr, square: Expr, square_low: Expr, root: Expr, root_low: Expr,
    precision: Precision,
) -> tuple[Expr, Expr]:  # fmt: skip
    """Root - 2 pi count."""
    large, middle, small = precision.parts(4 * pi**2, 3)
    turns = do("turns", count * count)
    most, most_low = product(do, turns, large)
    more, more_low = product(do, turns, middle)
    left, one = difference(do, -square, most)
    left, two = difference(do, left, most_low)
    left, three = difference(do, left, more)
    left, four = difference(do, left, square_low)
    low = do("low", one + two + three + four - (more_low + turns * small))
    left, low = difference(do, left, -low)
    once, once_low = precision.parts(2 * pi)
    way, way_low = product(do, count, once)
    both, lost = difference(do, root, -way)
    both_low = do("both_low", lost + (way_low + count * once_low) + root_low)
    return quotient(do, left, do.nonzero(both), low, both_low)


def risen(do: Steps, t: Turned, stiff: Expr) -> Expr:
    """n1."""
    back, lost = product(do, t.fall, t.wave, t.wave_low)
    rest, low = difference(do, t.mean, back)
    low = do("low", low + (t.mean_low - (lost + t.fall_low * t.wave)))
    moved, moved_low = product(do, t.half, rest, low)
    lifted, lost = product(do, t.fall, t.lift, t.lift_low)
    total, low = difference(do, moved, -lifted)
    return _over(do, total, low + (moved_low + (lost + t.fall_low * t.lift)), stiff)


def fallen(do: Steps, t: Turned, stiff: Expr) -> Expr:
    """n0."""
    rest, low = difference(do, t.mean, t.wave)
    moved, moved_low = product(do, t.half, rest, low + (t.mean_low - t.wave_low))
    total, low = difference(do, t.lift, moved)
    total, low = difference(do, total, -do("low", low + (t.lift_low - moved_low)))
    kept, lost = product(do, t.fall, total, low)
    return _over(do, kept, lost + t.fall_low * total, stiff)


def both(do: Steps, t: Turned, stiff: Expr) -> Expr:
    """n1 + n0: (1 - E)^2 and 2 E c."""
    gone, lost = fast_sum(do, sp.S.One, -t.fall)
    gone, gone_low = fast_sum(do, gone, do("low", lost - t.fall_low))
    square, square_low = product(do, gone, gone, 2 * gone_low)
    lifted, lost = product(do, t.fall, t.lift, t.lift_low)
    total, low = difference(do, square, -2 * lifted)
    return _over(do, total, low + (square_low + 2 * (lost + t.fall_low * t.lift)), stiff)


def _over(do: Steps, total: Expr, low: Expr, stiff: Expr) -> Expr:
    found, missed = quotient(do, total, stiff, do("low", low))
    return found + missed

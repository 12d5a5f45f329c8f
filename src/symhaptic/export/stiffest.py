"""The angle at which the explicit boundary reaches farthest, as a routine: it is searched for."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy import And, Expr, Max, Or, atan2, cos, pi, sin, sqrt

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, Steps, choose, difference, product
from symhaptic.export.search import crossing
from symhaptic.forms import stiffest
from symhaptic.forms.counted import LateRoots, Stable, WholeRoots
from symhaptic.forms.stability_forms import curve
from symhaptic.forms.stiffest_angle import STIFFEST_ARGUMENTS, STIFFEST_SPRING
from symhaptic.notation import theta

gamma, delta, d, steps, part, first, last, at_one, at_minus_one, loss, together, apart = (
    STIFFEST_ARGUMENTS
)

_PARTS = 24
"""Of what is looked at for the first maximum."""


def end_slope() -> Routine:
    """Its terms cancel where the maximum is next to pi: each is known twice as well as a float."""
    do = Steps()
    _, r, loss, s, a, late = stiffest.EARLY
    side, side_low = difference(do, s, 4 * late)
    square, square_low = product(do, side, side, 2 * side_low)
    across, across_low = product(do, a, s)
    gap, gap_low = difference(do, across, square)
    gap_low = do("gap_low", gap_low + (across_low - square_low))
    lean, lean_low = difference(do, square, 2 * across)
    lean_low = do("lean_low", lean_low + (square_low - 2 * across_low))
    one, one_low = product(do, side, lean, lean_low)
    two, two_low = product(do, a, across, across_low)
    bent, bent_low = difference(do, one, -two)
    bent_low = do("bent_low", bent_low + (one_low + side_low * lean + two_low))
    one, one_low = product(do, r, bent, bent_low)
    part, part_low = product(do, a, gap, gap_low)
    two, two_low = product(do, loss, part, part_low)
    rest, rest_low = difference(do, 2 * a, side)
    wide, wide_low = product(do, a, a)
    three, three_low = product(do, wide, rest, rest_low - side_low)
    three_low = do("three_low", three_low + wide_low * rest)
    found, lost = difference(do, 4 * three, one)
    found, more = difference(do, found, 2 * two)
    low = do("low", (lost + more) + (4 * three_low - (one_low + 2 * two_low)))
    return do.routine("EndSlope", "has the sign of the slope of the boundary's alpha next to pi",
                      stiffest.EARLY[1:], found + low)  # fmt: skip


def early_slope() -> Routine:
    """The sign of the slope for delays below one period, of the coefficients of a quartic."""
    do = Steps()
    coefficients = sp.symbols("k4 k3 k2 k1 k0")
    sine, cosine = do("sine", sin(theta / 2)), do("cosine", cos(theta / 2))
    up, along = do("up", sine * sine), do("along", cosine * cosine)
    found, power = coefficients[0], sp.S.One
    for k in coefficients[1:]:
        power = do("power", power * along)
        found = do("found", found * up + k * power)
    return do.routine("EarlySlope", "has the sign of the slope of the boundary's alpha, d < 1",
                      (theta, *coefficients), found)  # fmt: skip


def undelayed_angle() -> Routine:
    """Without delay: where a parabola changes its sign first, or pi where it does not."""
    do = Steps()
    square = do("k", sp.Function("EndSlope")(*stiffest.UNDELAYED[1:], 0))
    middle, last = (do("k", k) for k in do.common(*stiffest.undelayed()[1:]))
    discriminant = do("discriminant", middle * middle - 4 * square * last)
    root = do("root", sqrt(Max(discriminant, 0)))
    falls = choose(discriminant < 0, 0, root - middle)
    above = do("above", choose(middle > 0, middle + root, 2 * last))
    below = do("below", choose(middle > 0, Max(-2 * square, 0), falls))
    return do.routine("UndelayedAngle", "the angle of the largest stiffness without delay",
                      stiffest.UNDELAYED, 2 * atan2(sqrt(above), sqrt(below)))  # fmt: skip


def boundary_slope() -> Routine:
    """The sign of the slope of alpha along the boundary."""
    do = Steps()
    return do.routine("BoundarySlope", "has the sign of the slope of the boundary's alpha",
                      stiffest.SLOPE_ARGUMENTS, *do.common(stiffest.slope()[0]))  # fmt: skip


def _first_maximum(
    do: Steps, end: Expr, slope: Callable[[Expr], Expr], precision: Precision, rising: Expr
) -> Expr:
    """Where a slope that is positive at 0 changes its sign first; or what holds if it does not."""

    def angle(count: Expr) -> Expr:
        return count * end / _PARTS

    def scan(inner: Steps, states: tuple[sp.Symbol, ...]) -> tuple[Expr, ...]:
        count, _ = states
        rises = inner("rises", slope(angle(count)))
        return choose(rises > 0, count + 1, count), choose(rises > 0, 0, 1)

    count, found = do.repeat(
        {"count": sp.S.One, "found": sp.S.Zero},
        scan,
        lambda states: Or(states[1] > 0, states[0] > _PARTS),
        _PARTS,
    )
    high = do("high", angle(count))
    low = do("low", Max(angle(count - 1), high / 1000))
    root = crossing(do, lambda _, at: slope(at), low, high, precision.close, found > 0)
    return choose(found > 0, root, rising)


def early_angle(precision: Precision = DOUBLE) -> Routine:
    """For delays below one period; pi where the stiffness rises all the way."""
    do = Steps(taken={symbol.name for symbol in stiffest.EARLY})
    end = sp.Function("EndSlope")(*stiffest.EARLY[1:])
    quartic = [do("k", k) for k in (end, *do.common(*stiffest.early()[1:]))]
    found = _first_maximum(
        do, pi, lambda at: sp.Function("EarlySlope")(at, *quartic), precision, pi
    )
    return do.routine("EarlyAngle", "the angle of the largest stiffness for delays below a period",
                      stiffest.EARLY, found)  # fmt: skip


def later_angle(precision: Precision = DOUBLE) -> Routine:
    """For all others; NaN where the stiffness rises for the first half turn of the delay."""
    given = d, *stiffest.SLOPE_ARGUMENTS[1:]
    do = Steps(taken={symbol.name for symbol in given})
    _, *numbers = given
    turn = do("turn", pi / (d + 1))
    found = _first_maximum(
        do, turn, lambda at: sp.Function("BoundarySlope")(at, *numbers), precision, sp.nan
    )
    return do.routine("LaterAngle", "the angle of the largest stiffness for a period and more",
                      given, found)  # fmt: skip


def stiffest_angle(precision: Precision = DOUBLE) -> Routine:
    """The first maximum of alpha on the boundary, if it borders the stable region, else NaN."""
    do = Steps(taken={symbol.name for symbol in STIFFEST_ARGUMENTS})
    whole = sp.Eq(part, 0)
    across = do("across", choose(whole, first, first - last))
    numbers = at_one, at_minus_one, loss, together, apart
    early = sp.Function("EarlyAngle")(*numbers, last)
    later = sp.Function("LaterAngle")(d, steps, *numbers, across)
    undelayed = sp.Function("UndelayedAngle")(*numbers)
    top = do("theta", choose(sp.Eq(d, 0), undelayed, choose(d < 1, early, later)))
    stiffness, damping = do.common(*curve((*numbers, 2 * across), top, steps))
    stiffness, damping = do("stiffness", stiffness), do("damping", damping)
    # a little inside a wall must be stable, so that the boundary borders the region
    inside = do("inside", stiffness - 10 * precision.flat * (stiffness + gamma))
    wall = inside, damping
    outside = choose(
        whole,
        WholeRoots(*wall, steps, first, last, *numbers),
        LateRoots(*wall, steps, first, last, *numbers),
    )
    outside = do("outside", outside)
    soft = sqrt(gamma) * (d + 1) <= pi
    known = And(gamma <= STIFFEST_SPRING, Or(soft, d <= 1))
    # with damping and no stiff spring, comparison found no maximum that lies elsewhere
    sure = And(soft, delta > 0, stiffness > -gamma)
    good = do("good", choose(sure, 1, Stable(outside, *wall, gamma, delta)))
    return do.routine("StiffestAngle", "the angle of the wall of largest stable stiffness, or NaN",
                      STIFFEST_ARGUMENTS,
                      choose(known, choose(good > 0, top, sp.nan), sp.nan))  # fmt: skip


ROUTINES = (boundary_slope, early_slope, end_slope, undelayed_angle)
PRECISE = (early_angle, later_angle, stiffest_angle)

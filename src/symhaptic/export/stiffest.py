"""The angle at which the explicit boundary reaches farthest, as a routine: it is searched for."""

from __future__ import annotations

import sympy as sp
from sympy import And, Expr, Max, Or, atan2, pi, sqrt

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, Steps, choose
from symhaptic.export.search import crossing
from symhaptic.model import stiffest
from symhaptic.model.counted import LateRoots, Stable, UnstableRoots
from symhaptic.model.searched import STIFFEST_ARGUMENTS, STIFFEST_SPRING
from symhaptic.model.stability_forms import curve

gamma, delta, d, steps, part, first, last, at_one, at_minus_one, loss, together, apart = (
    STIFFEST_ARGUMENTS
)

_PARTS = 24
"""Of the first half turn of the delay, at which the first maximum is looked for."""


def undelayed_angle() -> Routine:
    """Without delay: where a parabola changes its sign first, or pi where it does not."""
    do = Steps()
    square, middle, last = (do("k", k) for k in do.common(*stiffest.undelayed()))
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


def stiffest_angle(precision: Precision = DOUBLE) -> Routine:
    """The first maximum of alpha on the boundary, if it borders the stable region, else NaN."""
    do = Steps(taken={symbol.name for symbol in STIFFEST_ARGUMENTS})
    whole = sp.Eq(part, 0)
    across = do("across", choose(whole, first, first - last))
    turn = do("turn", pi / (d + 1))
    numbers = at_one, at_minus_one, loss, together, apart, across

    def slope(_: Steps, at: Expr) -> Expr:
        return sp.Function("BoundarySlope")(at, steps, *numbers)

    def angle(count: Expr) -> Expr:
        return count * turn / _PARTS

    def scan(inner: Steps, states: tuple[sp.Symbol, ...]) -> tuple[Expr, ...]:
        count, _ = states
        rises = inner("rises", slope(inner, angle(count)))
        return choose(rises > 0, count + 1, count), choose(rises > 0, 0, 1)

    at_once = sp.Eq(d, 0)
    count, found = do.repeat(
        {"count": do("start", choose(at_once, _PARTS + 1, 1)), "found": sp.S.Zero},
        scan,
        lambda states: Or(states[1] > 0, states[0] > _PARTS),
        _PARTS,
    )
    high = do("high", angle(count))
    low = do("low", Max(angle(count - 1), high / 1000))
    inner_maximum = found > 0
    root = crossing(do, slope, low, high, precision.close, inner_maximum)
    early = sp.Function("UndelayedAngle")(at_one, at_minus_one, loss, together, apart)
    theta = do("theta", choose(at_once, early, choose(inner_maximum, root, sp.nan)))
    stiffness, damping = do.common(*curve((*numbers[:-1], 2 * across), theta, steps))
    stiffness, damping = do("stiffness", stiffness), do("damping", damping)
    # a little inside a wall must be stable, so that the boundary borders the region
    inside = do("inside", stiffness - 10 * precision.flat * (stiffness + gamma))
    device = at_one, at_minus_one, loss, together, apart
    wall = inside, damping
    outside = choose(
        whole,
        UnstableRoots(*wall, steps, first, last, *device),
        LateRoots(*wall, steps, first, last, *device),
    )
    outside = do("outside", outside)
    known = And(gamma <= STIFFEST_SPRING, Or(sqrt(gamma) * (d + 1) <= pi, d <= 1))
    good = do("good", Stable(outside, *wall, gamma, delta))
    return do.routine("StiffestAngle", "the angle of the wall of largest stable stiffness, or NaN",
                      STIFFEST_ARGUMENTS,
                      choose(known, choose(good > 0, theta, sp.nan), sp.nan))  # fmt: skip


ROUTINES = (boundary_slope, undelayed_angle)
PRECISE = (stiffest_angle,)

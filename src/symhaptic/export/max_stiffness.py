"""The angle at which the explicit boundary reaches farthest, as a routine: it is searched for."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy import And, Expr, Max, Or, atan2, cos, pi, sin, sqrt

from symhaptic.export.pairs import (
    Pair,
    exact,
    minus,
    plus,
    rounded,
    scaled,
    squared,
    times,
    two_diff,
)
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.search import crossing
from symhaptic.export.steps import Steps
from symhaptic.forms import max_stiffness_slope
from symhaptic.forms.max_stiffness_angle import MAX_STIFFNESS_ARGUMENTS, MAX_STIFFNESS_SPRING
from symhaptic.forms.root_count import FractionalRoots, Stable, WholeRoots
from symhaptic.forms.stability_forms import curve
from symhaptic.notation import theta

gamma, delta, d, steps, part, first, last, at_one, at_minus_one, loss, together, apart = (
    MAX_STIFFNESS_ARGUMENTS
)

_PARTS = 24
"""Of what is looked at for the first maximum."""


def _times(number: int, pair: Pair) -> Pair:
    """So often, by a power of two, which rounds nothing."""
    return number * pair[0], number * pair[1]


def end_slope() -> Routine:
    """Its terms cancel where the maximum is next to pi: each is known twice as well as a float."""
    do = Steps()
    _, r, loss, s, a, late = max_stiffness_slope.EARLY
    side = two_diff(do, s, 4 * late)
    square, across = squared(do, side), scaled(do, a, exact(s))
    gap, lean = minus(do, across, square), minus(do, square, _times(2, across))
    bent = plus(do, times(do, side, lean), scaled(do, a, across))
    rest = minus(do, exact(2 * a), side)
    two = scaled(do, loss, scaled(do, a, gap))
    three = times(do, squared(do, exact(a)), rest)
    found = minus(do, _times(4, three), scaled(do, r, bent))
    found = minus(do, found, _times(2, two))
    return do.routine("EndSlope", "has the sign of the slope of the boundary's alpha next to pi",
                      max_stiffness_slope.EARLY[1:], rounded(found))  # fmt: skip


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
    square = do("k", sp.Function("EndSlope")(*max_stiffness_slope.UNDELAYED[1:], 0))
    middle, last = (do("k", k) for k in do.common(*max_stiffness_slope.undelayed()[1:]))
    discriminant = do("discriminant", middle * middle - 4 * square * last)
    root = do("root", sqrt(Max(discriminant, 0)))
    falls = choose(discriminant < 0, 0, root - middle)
    above = do("above", choose(middle > 0, middle + root, 2 * last))
    below = do("below", choose(middle > 0, Max(-2 * square, 0), falls))
    return do.routine("UndelayedAngle", "the angle of the largest stiffness without delay",
                      max_stiffness_slope.UNDELAYED,
                      2 * atan2(sqrt(above), sqrt(below)))  # fmt: skip


def boundary_slope() -> Routine:
    """The sign of the slope of alpha along the boundary."""
    do = Steps()
    return do.routine("BoundarySlope", "has the sign of the slope of the boundary's alpha",
                      max_stiffness_slope.SLOPE_ARGUMENTS,
                      *do.common(max_stiffness_slope.slope()[0]))  # fmt: skip


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
    do = Steps(taken={symbol.name for symbol in max_stiffness_slope.EARLY})
    end = sp.Function("EndSlope")(*max_stiffness_slope.EARLY[1:])
    quartic = [do("k", k) for k in (end, *do.common(*max_stiffness_slope.early()[1:]))]
    found = _first_maximum(
        do, pi, lambda at: sp.Function("EarlySlope")(at, *quartic), precision, pi
    )
    return do.routine("EarlyAngle", "the angle of the largest stiffness for delays below a period",
                      max_stiffness_slope.EARLY, found)  # fmt: skip


def later_angle(precision: Precision = DOUBLE) -> Routine:
    """For all others; NaN where the stiffness rises for the first half turn of the delay."""
    given = d, *max_stiffness_slope.SLOPE_ARGUMENTS[1:]
    do = Steps(taken={symbol.name for symbol in given})
    _, *numbers = given
    turn = do("turn", pi / (d + 1))
    found = _first_maximum(
        do, turn, lambda at: sp.Function("BoundarySlope")(at, *numbers), precision, sp.nan
    )
    return do.routine("LaterAngle", "the angle of the largest stiffness for a period and more",
                      given, found)  # fmt: skip


def max_stiffness_angle(precision: Precision = DOUBLE) -> Routine:
    """The first maximum of alpha on the boundary, if it borders the stable region, else NaN."""
    do = Steps(taken={symbol.name for symbol in MAX_STIFFNESS_ARGUMENTS})
    whole = sp.Eq(part, 0)
    across = do("across", choose(whole, first, first - last))
    numbers = at_one, at_minus_one, loss, together, apart
    early = sp.Function("EarlyAngle")(*numbers, last)
    later = sp.Function("LaterAngle")(d, steps, *numbers, across)
    undelayed = sp.Function("UndelayedAngle")(*numbers)
    top = do("theta", choose(sp.Eq(d, 0), undelayed, choose(d < 1, early, later)))
    known = gamma, *numbers[1:]
    roots = choose(
        whole,
        WholeRoots(*_INSIDE, steps, first, last, *known),
        FractionalRoots(*_INSIDE, steps, first, last, *known, first - last),
    )
    found = _bordering(do, top, across, steps, roots, precision)
    return do.routine("MaxStiffnessAngle",
                      "the angle of the wall of largest stable stiffness, or NaN",
                      MAX_STIFFNESS_ARGUMENTS, found)  # fmt: skip


_INSIDE = sp.symbols("inside damping")


def _bordering(
    do: Steps, top: Expr, across: Expr, steps: Expr, roots: Expr, precision: Precision
) -> Expr:
    """The angle if its wall borders the stable region, else NaN; ``roots`` are those of a wall."""
    numbers = at_one, at_minus_one, loss, together, apart
    stiffness, damping = do.common(*curve((*numbers, 2 * across), top, steps))
    stiffness, damping = do("stiffness", stiffness), do("damping", damping)
    # a little inside a wall must be stable, so that the boundary borders the region; farther inside
    # where the count is not certain
    counts, stables = [], []
    for inward in (10 * precision.flat, sp.Rational(1, 2**8)):
        wall = do("inside", stiffness - inward * (stiffness + gamma)), damping
        counted = roots.xreplace(dict(zip(_INSIDE, wall, strict=True)))
        counts.append(do("outside", counted))
        stables.append(Stable(counts[-1], *wall, gamma, delta))
    soft = sqrt(gamma) * (d + 1) <= pi
    known = And(gamma <= MAX_STIFFNESS_SPRING, Or(soft, d <= 1))
    # with damping and no stiff spring, comparison found no maximum that lies elsewhere
    sure = And(soft, delta > 0, stiffness > -gamma)
    good = do("good", choose(sure, 1, choose(counts[0] < 0, *stables[::-1])))
    return choose(known, choose(good > 0, top, sp.nan), sp.nan)


def max_stiffness_whole_angle(precision: Precision = DOUBLE) -> Routine:
    """Of a whole delay, which is none or one period and more."""
    given = gamma, delta, d, first, last, at_one, at_minus_one, loss, together, apart
    do = Steps(taken={symbol.name for symbol in given})
    numbers = at_one, at_minus_one, loss, together, apart
    later = sp.Function("LaterAngle")(d, d, *numbers, first)
    undelayed = sp.Function("UndelayedAngle")(*numbers)
    top = do("theta", choose(sp.Eq(d, 0), undelayed, later))
    roots = WholeRoots(*_INSIDE, d, first, last, gamma, *numbers[1:])
    found = _bordering(do, top, first, d, roots, precision)
    return do.routine("MaxStiffnessWholeAngle",
                      "the angle of the wall of largest stable stiffness, or NaN",
                      given, found)  # fmt: skip


ROUTINES = (boundary_slope, early_slope, end_slope, undelayed_angle)
PRECISE = (early_angle, later_angle, max_stiffness_angle, max_stiffness_whole_angle)

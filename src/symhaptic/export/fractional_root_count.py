r"""Roots outside the unit circle behind a delay that is no whole number of periods.

As in symhaptic.export.root_count, but with a cubic in :math:`y=4\sin^2(\theta/2)`; chapter
s6b_fractional_stability.  The cubic is expanded about y = 0, about the device's own frequency and
about y = 4; between these points it is cut where it has an extremum or an inflection, and on each
piece Newton's method goes to the root from the end from which it never overshoots.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import And, Expr, Max, Min, Or, sqrt
from sympy.logic.boolalg import Boolean

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.root_count import (
    BEYOND,
    CENTER,
    LEADS,
    LOOP,
    _Wall,
    at_the_end,
    counted,
    faint,
    flat,
    point_off,
    turned_off,
    unit,
)
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps
from symhaptic.forms.root_count import FRACTIONAL_ARGUMENTS

alpha, beta, d, m2, m0, gamma, at_minus_one, loss, together, apart, across = FRACTIONAL_ARGUMENTS
center, beyond = CENTER, BEYOND
k0, k1, k2, k3 = TERMS = sp.symbols("k0 k1 k2 k3")
low, high, at_low, at_high, zone = sp.symbols("low high at_low at_high zone")

_LOOP = (*LOOP, center, beyond)
"""As in the count for whole delays, with m2 - m0 for n1."""

_STEPS = 1000
"""At most so many; a root that is far smaller than the piece is approached by halves, and the
faintest wall that is counted has one of 2^-800."""

NEAR, OWN, FAR = range(3)
"""Zones: y, y - center and 4 - y are the variable."""

Terms = tuple[Expr, Expr, Expr, Expr]


def _value(k: Terms, y: Expr) -> Expr:
    return ((k[3] * y + k[2]) * y + k[1]) * y + k[0]


@dataclass(frozen=True)
class _Products:
    """What all expansions have."""

    lost: Expr
    square: Expr
    """m2 m0."""
    size: Expr
    """(m2 - m0)^2."""


def _about(
    do: Steps, name: str, both: _Products, first: Expr, at: Expr, top: Expr, force: Expr, tilt: Expr
) -> tuple[Terms, Expr]:
    """|A|^2 - |M|^2 |W|^2 about an end, from its value and those of A, M and W there.

    And the second coefficient with all terms positive.
    """
    lost, square, even = both.lost, both.square, do("even", top * (m2 + m0))
    linear, push = do("linear", both.size - even), do("push", force**2)
    terms = (
        do(f"{name}0", first),
        do(f"{name}1", lost - at * (2 - loss) - linear * push - top**2 * tilt),
        do(f"{name}2", 1 - loss - square * push - linear * tilt),
        do(f"{name}3", -square * tilt),
    )
    sizes = lost, at * (2 - loss), (both.size + sp.Abs(even)) * push, top**2 * sp.Abs(tilt)
    return terms, do("most", sp.Add(*sizes))


def _own(do: Steps, both: _Products, middle: Expr, rest: Expr, v: _Wall) -> Terms:
    """The same about the device's own frequency."""
    sine, tilt = do("sine", middle * rest / 4), do("tilt", (rest - middle) / 4)
    real = do("real", (together * rest - apart * middle) / 4)
    size, lost, three = both.size, both.lost, both.square
    one = do("one", real**2 + size * sine)
    two = do("two", size * tilt - (m2 + m0) * real)
    wave = do("wave", (alpha * rest - v.far * middle) / 4)
    wall = do("wall", wave**2 + v.slope**2 * sine)
    return (
        do("own0", lost * sine - one * wall),
        do("own1", lost * tilt - two * wall - one * v.force),
        do("own2", 1 - loss - three * wall - two * v.force),
        do("own3", -three * v.force),
    )


def _leads(k: Terms) -> Boolean:
    """Whether the wall leads next to the end: the first coefficient that is not 0 is negative."""
    leads = k[3] < 0
    for c in k[2::-1]:
        leads = Or(c < 0, And(sp.Eq(c, 0), leads))
    return leads


def _blurs(do: Steps, at_one: Expr, last: Expr) -> tuple[Expr, Expr]:
    """By how much M(-1) and m2 - m0 may be off: the first near half turns, that near whole ones.

    There each term of their sums is as small as the root of A(-1) or of A(1).
    """
    size = do("size", m2 + sp.Abs(m0) + together)
    near_half = do("near_half", sqrt(Min(at_minus_one, 1)))
    stiff = And(gamma > _STIFF, loss < sp.S.Half)
    near_whole = choose(stiff, 2 * sqrt(Min(at_one, 1)) / do.nonzero(gamma), size / 8)
    return do("apart_off", 8 * last * size * near_half), do("n1_off", 16 * last * near_whole)


_STIFF = sp.Integer(10)
"""A device that is stiffer, and is damped little, turns more than half a turn in a period."""


def fractional_roots(precision: Precision = DOUBLE) -> Routine:
    """The number of roots outside the unit circle, -1 where floats do not tell it."""
    do = Steps()
    weak, last = faint(do, precision), unit(precision)
    v = _Wall(do("slope", alpha + beta), sp.S.Zero, do("wall_far", alpha + 2 * beta))
    v = _Wall(v.slope, do("force", v.slope * beta), v.far)
    both = _Products(do("lost", loss * loss), do("square", m2 * m0), do("size", across * across))
    at_one = do("at_one", gamma * together)
    apart_off, n1_off = _blurs(do, at_one, last)
    a_off = do("a_off", turned_off(precision, at_minus_one))
    first = do("apart_one", (gamma - alpha) * (gamma + alpha)) * do("even", together * together)
    near, most = _about(do, "near", both, first, at_one, together, alpha, v.force)
    blurred = do("blurred", (2 * sp.Abs(across) + n1_off) * n1_off)
    end_unsure, least = at_the_end(do, v.far, last, a_off, apart_off)
    unsure = [weak, end_unsure]
    unsure += [flat(do, near, sp.Abs(near[0]), most, last, blurred * alpha**2)]
    pushed = do("pushed", apart * v.far)
    first = (at_minus_one - pushed) * (at_minus_one + pushed)
    far_, most = _about(do, "far", both, first, at_minus_one, apart, v.far, -v.force)
    blurred += do("even", apart_off * (m2 + sp.Abs(m0)))
    more = blurred * v.far**2 + (2 * sp.Abs(apart) + apart_off) * apart_off * sp.Abs(v.force)
    unsure += [flat(do, far_, least, most, last, more + 2 * a_off)]
    middle = do("middle", 2 * at_one / (2 - loss))
    rest = do("rest", 2 * at_minus_one / (2 - loss))
    own = _own(do, both, middle, rest, v)
    one, two = do("one", middle / 2), do("two", rest / 2)
    before, after = do("before", _value(own, -one)), do("after", _value(own, two))
    loop = (
        alpha, v.slope, v.far, d, across, loss, together, apart, apart_off, n1_off, a_off,
        middle, rest,
    )  # fmt: skip
    turns = sp.Function("ZoneTurns")
    zones = [do("zone", sp.Integer(number)) for number in (NEAR, OWN, FAR)]
    found = turns(*near, zones[0], one, near[0], before, zones[0], *loop)
    found += turns(*own, -one, two, before, after, zones[1], *loop)
    found += turns(*far_, zones[0], two, far_[0], after, zones[2], *loop)
    side = do("side", choose(v.slope >= 0, 1, -1))
    begin = choose(alpha > 0, 0, side)
    end = choose(v.far > 0, side, 0) - (d + 3)
    end = do("end", end + choose(apart > 0, choose(across >= 0, 1, -1), 0))
    total = do("total", found + choose(_leads(near), begin, 0))
    total = do("total", total - choose(_leads(far_), end, 0))
    return do.routine("FractionalRoots", "roots outside the unit circle behind a fractional delay, "
                      "-1 where that is not certain", FRACTIONAL_ARGUMENTS,
                      counted(do, Or(*unsure), total))  # fmt: skip


def _inside(do: Steps, top: Expr, bottom: Expr) -> Expr:
    """The quotient if it lies between the ends, else the low end."""
    small = sp.Abs(top) < 8 * sp.Abs(bottom)
    some = do("some", choose(small, bottom, 1))
    at = do("at", top / some)
    return do("cut", choose(And(small, at > low, at < high), at, low))


def zone_turns() -> Routine:
    """What the crossings of one zone add to the count."""
    do = Steps()
    disc = do("disc", k2 * k2 - 3 * k3 * k1)
    root = do("root", sqrt(Max(disc, 0)))
    q = do("q", -(k2 + choose(k2 < 0, -root, root)))
    bend = _inside(do, -k2, 3 * k3)
    one, two = _inside(do, q, 3 * k3), _inside(do, k1, q)  # without extrema, cuts like any other
    less, more = do("less", Min(one, two)), do("more", Max(one, two))
    first, middle = do("first", Min(less, bend)), do("middle", Max(less, bend))
    last = do("last", Max(middle, more))
    middle = do("middle", Min(middle, more))
    cuts = [low, first, middle, last, high]
    values = [at_low, *(do("p", _value(TERMS, c)) for c in cuts[1:-1]), at_high]
    piece = sp.Function("PieceTurns")
    found: Expr = sp.S.Zero
    for extremum in (one, two):
        value = do("value", _value(TERMS, extremum))
        here = sp.Function("ZoneTouches")(value, extremum, zone, *_LOOP)
        touches = choose(extremum > low, here, 0)
        found = do("found", found + touches)
    for i in range(4):
        ends = (cuts[i], cuts[i + 1], values[i], values[i + 1])
        found = do("found", found + piece(*TERMS, *ends, zone, *_LOOP))
    return do.routine("ZoneTurns", "what the crossings between two points add to the count",
                      (*TERMS, low, high, at_low, at_high, zone, *_LOOP), found,
                      takes=("Loop",))  # fmt: skip


def _point(do: Steps, x: Expr, last: Expr) -> tuple[Expr, ...]:
    """y, 4 - y and y - center of a point of a zone, and how much these may be off."""
    near, own = sp.Eq(zone, NEAR), sp.Eq(zone, OWN)
    y = do("y", choose(near, x, choose(own, center + x, 4 - x)))
    rest = do("rest", choose(near, 4 - x, choose(own, beyond - x, x)))
    off = do("off", choose(near, x - center, choose(own, x, beyond - x)))
    loose = do("loose", choose(own, *point_off(last)))
    return y, rest, off, loose, do("free", choose(own, 0, last * choose(near, center, beyond)))


def zone_touches(precision: Precision = DOUBLE) -> Routine:
    """At an extremum of the surplus, which may be so small that its sign is not certain."""
    do, x = Steps(), sp.Symbol("x")
    return do.routine("ZoneTouches", "NaN where the wall may be as strong as the device at an "
                      "extremum of both, else 0", (LEADS, x, zone, *_LOOP),
                      sp.Function("Touches")(LEADS, *_point(do, x, unit(precision)), *LOOP),
                      takes=("Loop",))  # fmt: skip


def piece_turns(precision: Precision = DOUBLE) -> Routine:
    """The same for a piece on which the cubic has neither extremum nor inflection.

    At an end of the circle it may be 0, which is no crossing.
    """
    do = Steps()
    there = And(high > low, sp.Or(And(at_low < 0, at_high >= 0), And(at_low >= 0, at_high < 0)),
                sp.Or(sp.Ne(low, 0), sp.Ne(at_low, 0)))  # fmt: skip
    x = do("x", sp.Function("CubicRoot")(*TERMS, low, high, at_high - at_low))
    point = _point(do, x, unit(precision))
    inner = And(point[0] > 0, point[1] > 0)
    found = do("found", sp.Function("PhaseTurns")(*point, *LOOP))
    rises = do("rises", choose(at_high > at_low, 1, -1) * choose(sp.Eq(zone, FAR), -1, 1))
    turned = choose(inner, -2 * rises * found, sp.nan)
    return do.routine("PieceTurns", "what the crossing on a piece, if there is one, adds",
                      (*TERMS, low, high, at_low, at_high, zone, *_LOOP),
                      choose(there, turned, 0), takes=("Loop",))  # fmt: skip


def cubic_root() -> Routine:
    """The root on such a piece."""
    do = Steps()
    rise = sp.Symbol("rise")
    convex = do("convex", choose(3 * k3 * (low + high) + 2 * k2 > 0, 1, -1))
    down = do("down", choose(rise * convex > 0, 1, -1))  # from this end it never overshoots

    def step(inner: Steps, states: tuple[sp.Symbol, ...]) -> tuple[Expr, ...]:
        y, _ = states
        steep = inner("steep", (3 * k3 * y + 2 * k2) * y + k1)
        some = inner("some", choose(sp.Eq(steep, 0), 1, steep))
        move = inner("move", choose(sp.Eq(steep, 0), 0, _value(TERMS, y) / some))
        new = inner("new", Min(y - move, high))
        new = inner("new", Max(new, low))
        return new, choose((y - new) * down > 0, 1, 0)

    y, _ = do.repeat(
        {"y": choose(down > 0, high, low), "moves": sp.S.One},
        step,
        lambda states: sp.Eq(states[1], 0),
        _STEPS,
    )
    return do.routine("CubicRoot", "the root of a cubic on a piece where it bends one way",
                      (*TERMS, low, high, rise), y)  # fmt: skip


ROUTINES = (zone_turns, cubic_root)
PRECISE = (zone_touches, piece_turns, fractional_roots)

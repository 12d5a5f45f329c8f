r"""Roots outside the unit circle, counted at a cost that does not grow with the delay.

On the circle a root needs :math:`|A|=|M||W|` of the device and the wall, a quadratic in
:math:`y=4\sin^2(\theta/2)` that does not contain the delay; between its solutions one side leads
and takes the argument along.  Chapter s4d_roots_counted derives this.  The quadratic is expanded
about y = 0, about the device's own frequency and about y = 4, and each root taken from the nearest.

The count is certain or it is NaN.  At each crossing A, M and W are computed with bounds of their
errors.  What is left of |A| - |M||W| there, and the derivative of its logarithm, bound how far
the true crossing is; that and the errors of the three arguments bound the error of the phase.
Where an odd number of half turns is within that bound, a root may be on either side of the circle.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp
from sympy import And, Expr, Max, Min, Or, atan2, floor, pi, sqrt
from sympy.logic.boolalg import Boolean

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps
from symhaptic.forms.root_count import ARGUMENTS

alpha, beta, d, n1, n0, gamma, at_minus_one, loss, together, apart = ARGUMENTS
roots, delta = sp.symbols("roots delta")


def unit(precision: Precision) -> Expr:
    """By so much of themselves the numbers of a device may be off, with a margin.

    In half last places 8; tests measure 4 at most, and 6 for M(-1).
    """
    return 4 * precision.last


def turned_off(precision: Precision, at_minus_one: Expr) -> Expr:
    """By so much more A(-1) may be off near half turns: its root to twice the digits of a float."""
    return 32 * precision.last**2 * sqrt(gamma * at_minus_one)


@dataclass(frozen=True)
class _Wall:
    slope: Expr
    force: Expr
    far: Expr
    """alpha + 2 beta."""


@dataclass(frozen=True)
class _Quadratic:
    c: Expr
    b: Expr
    a: Expr


@dataclass(frozen=True)
class _Angle:
    """halves pi + rest of a complex number, with its size."""

    halves: Expr
    rest: Expr
    size: Expr
    per: Expr
    """1 over the size."""
    off: Expr
    """The most by which it is off, in parts of its size."""
    blur: Expr
    """The most by which the angle is off."""


def _about(do: Steps, e: Expr, v: _Wall) -> tuple[_Quadratic, _Quadratic, _Quadratic, Expr, Expr]:
    """The quadratic about 0, the own frequency and 4, and that frequency's y and 4 - y.

    At y = 0 it is (gamma^2 - alpha^2) (n1 + n0)^2: its sign is that of two exact differences.
    """
    cross, lost = do("cross", n1 * n0), do("lost", loss * loss)
    square, at_one = do("square", e + cross * v.force), do("at_one", gamma * together)
    even = do("even", together * together)
    pull = do("pull", apart * v.far)
    near = _Quadratic(
        do("near0", do("apart_one", (gamma - alpha) * (gamma + alpha)) * even),
        do("near1", lost - at_one * (1 + e) + cross * alpha**2 - even * v.force),
        square,
    )
    far = _Quadratic(
        do("far0", (at_minus_one - pull) * (at_minus_one + pull)),
        do("far1", lost - at_minus_one * (1 + e) - cross * v.far**2 + apart**2 * v.force),
        square,
    )
    center, beyond = do("center", 2 * at_one / (1 + e)), do("beyond", 2 * at_minus_one / (1 + e))
    sine, tilt = do("sine", center * beyond / 4), do("tilt", (beyond - center) / 4)
    real = do("real", (together * beyond - apart * center) / 4)
    m0, m1 = do("m0", real**2 + n1**2 * sine), do("m1", n1**2 * tilt - n1 * real)
    wave = do("wave", (alpha * beyond - v.far * center) / 4)
    wall = do("wall", wave**2 + v.slope**2 * sine)
    own = _Quadratic(
        do("own0", lost * sine - m0 * wall),
        do("own1", lost * tilt - m1 * wall - m0 * v.force),
        do("own2", e - m1 * v.force),
    )
    return near, own, far, center, beyond


def _root(do: Steps, parts: tuple[_Quadratic, ...]) -> tuple[Expr, Expr]:
    """The root of the discriminant, from the point where its terms are smallest, and its sign."""
    discs, sizes = [], []
    for k in parts:
        square, product = do("square", k.b * k.b), do("product", 4 * k.c * k.a)
        discs.append(do("disc", square - product))
        sizes.append(do("size", square + sp.Abs(product)))
    first = And(sizes[1] <= sizes[0], sizes[1] <= sizes[2])
    third = And(sizes[2] < sizes[0], sizes[2] < sizes[1])
    disc = do("disc", choose(first, discs[1], choose(third, discs[2], discs[0])))
    positive = do("positive", choose(disc >= 0, disc, 0))
    return do("root", sqrt(positive)), disc


def quadratic_roots() -> Routine:
    """The quotient of the two makes the second one; -1 stands for what is infinite."""
    do = Steps()
    c, b, a, root = given = sp.symbols("c b a root")
    upper = b >= 0
    q = do("q", -(b + choose(upper, root, -root)) / 2)
    lead, own = do("lead", choose(sp.Eq(a, 0), 1, a)), do("own", choose(sp.Eq(q, 0), 1, q))
    one = do("one", choose(sp.Eq(a, 0), -1, q / lead))
    two = do("two", choose(sp.Eq(q, 0), -1, c / own))
    found = {"low": choose(upper, one, two), "high": choose(upper, two, one)}
    return do.routine("QuadraticRoots", "(-b - root)/(2 a) and (-b + root)/(2 a), without "
                      "cancellation; -1 for what is infinite", given, found, "Roots")  # fmt: skip


def _solved(do: Steps, k: _Quadratic, root: Expr) -> tuple[Expr, Expr]:
    low, high = do.several(("low", "high"), "QuadraticRoots", k.c, k.b, k.a, root)
    return low, high


_X_OFF, _Y_OFF = sp.symbols("x_off y_off")


def _extremum(do: Steps, k: _Quadratic) -> Expr:
    """Where a quadratic is largest or smallest; -1 for what is infinite."""
    return choose(sp.Eq(k.a, 0), -1, -k.b / (2 * do.nonzero(k.a)))


def turn_angle() -> Routine:
    """Where up keeps its sign, which is + for 0; with bounds of the errors of both parts."""
    do = Steps()
    x, y = sp.symbols("x y")
    halves = choose(x < 0, choose(y < 0, -1, 1), 0)
    rest = atan2(choose(x < 0, -y, y), sp.Abs(x))
    most, least = do("most", Max(sp.Abs(x), sp.Abs(y))), do("least", Min(sp.Abs(x), sp.Abs(y)))
    ratio = do("ratio", least / do.nonzero(most))
    size = do("size", most * do("longer", sqrt(1 + ratio * ratio)))
    per = do("per", 1 / do.nonzero(size))
    one, two = do("one", sp.Abs(x) * per), do("two", sp.Abs(y) * per)
    along, across = do("along", _X_OFF * per), do("across", _Y_OFF * per)
    away = do("away", along + across)
    found = {
        "halves": halves,
        "rest": rest,
        "size": size,
        "per": per,
        # what is left of the number is at least three quarters of its size
        "off": one * along + two * across + away * away,
        "blur": choose(4 * away < 1, (one * across + two * along) * (1 + 2 * away), _WIDE),
    }
    return do.routine("TurnAngle", "the angle of x + j y in half turns and the rest, the size and "
                      "its inverse, and the most by which size and angle are off",
                      (x, y, _X_OFF, _Y_OFF), found, "Angle")  # fmt: skip


_WIDE = sp.Integer(4)
"""More than half a turn: nothing is known of an angle that is so far off."""

_Y, _REST, _OFF, LOOSE, FREE = POINT = sp.symbols("y rest off loose free")
"""y, 4 - y and y - center; the parts of the first two, and how much of the last, may be off."""

SLOPE, FAR, FORCE = sp.symbols("slope far force")
APART_OFF, N1_OFF, A_OFF = OFFS = sp.symbols("apart_off n1_off a_off")
LOOP = alpha, SLOPE, FAR, FORCE, d, n1, loss, together, apart, *OFFS
"""What a crossing is told of wall and device: besides their last places M and A at z = -1 and n1
may be off by the last three."""
CENTER, BEYOND = sp.symbols("center beyond")
"""The own frequency of the device, as y and 4 - y."""


@dataclass(frozen=True)
class _Part:
    """A, M or W, four times as large, as a function of y."""

    real: Expr
    up: Expr
    angle: _Angle
    steep: Expr
    """The derivative of the real part."""
    even: Expr
    """The derivative of its squared size, divided by 16."""
    most: Expr
    """The same with all terms positive."""
    bend: Expr
    """The most of the second derivative."""


def _part(
    do: Steps, real: Expr, up: Expr, off: Expr, up_off: Expr, steep: Expr, *squared: Expr
) -> _Part:
    real, up = do("real", real), do("up", up)
    names = ("halves", "turned", "size", "per", "away", "blur")
    halves, turned, size, per, away, blur = do.several(names, "TurnAngle", real, up, off, up_off)
    return _Part(real, up, _Angle(halves, turned, size, per, away, blur), steep, *squared)


def _parts(
    do: Steps, y: Expr, rest: Expr, unit: Expr
) -> tuple[tuple[_Part, _Part, _Part], Expr]:
    """A/z, M/z and W at a point, with what the device, the point and three roundings may miss.

    And 4 sin(theta).
    """
    sine, tilt = do("sine", 2 * sqrt(y * rest)), do("tilt", (rest - y) / 4)
    total, lost = do("total", 2 - loss), do("lost", loss * loss)
    square, whole = do("square", total * total / 2), do("whole", (rest + y) / 4)
    steep, sharp = do("steep", together + sp.Abs(apart)), do("falls", together + apart)
    own = do("own", n1 * n1)
    plain, made = do("plain", LOOSE + unit / 2), do("made", LOOSE + unit * 3 / 2)
    size = do("size_off", made * sp.Abs(n1) + N1_OFF)
    below = _part(
        do, -2 * total * _OFF, loss * sine, total * (unit * sp.Abs(_OFF) + 2 * FREE) + 4 * A_OFF,
        made * loss * sine, -2 * total, square * _OFF + lost * tilt,
        square * sp.Abs(_OFF) + lost * whole, square + lost / 2,
    )  # fmt: skip
    late = do("late", together * rest - apart * y)
    above = _part(
        do, late, n1 * sine, made * (together * rest + sp.Abs(apart) * y) + APART_OFF * y,
        size * sine, -sharp, own * tilt - late * sharp / 8, sp.S.Zero,
        steep**2 / 8 + own / 2,
    )  # fmt: skip
    above = replace(above, most=above.angle.size * steep / 8 + own * whole)
    force = _part(
        do, alpha * rest - FAR * y, SLOPE * sine,
        plain * (sp.Abs(alpha) * rest + sp.Abs(FAR) * y), plain * sp.Abs(SLOPE) * sine,
        -(alpha + FAR), FORCE, sp.Abs(FORCE), sp.S.Zero,
    )  # fmt: skip
    return (below, above, force), sine


def _gap(do: Steps, parts: tuple[_Part, _Part, _Part], unit: Expr) -> tuple[Expr, Expr]:
    """1 - |M W/A|, and the most by which that is off; finding the sizes rounds, too."""
    below, above, force = (part.angle for part in parts)
    ratio = do("ratio", above.size * below.per)
    gap = do("gap", 1 - ratio * force.size / 4)
    return gap, do("rough", below.off + above.off + force.off + 3 * unit / 2)


def touches(precision: Precision = DOUBLE) -> Routine:
    """At an extremum of |A|^2 - |M W|^2, whose sign tells whether there are crossings."""
    do = Steps()
    y, rest = do("at", Max(_Y, 0)), do("still", Max(_REST, 0))
    last = unit(precision)
    gap, rough = _gap(do, _parts(do, y, rest, last)[0], last)
    inner = And(_Y > 0, _REST > 0)
    return do.routine("Touches", "NaN where wall and device may be equally strong, else 0",
                      (*POINT, *LOOP),
                      choose(And(inner, sp.Abs(gap) <= 2 * rough), sp.nan, 0),
                      takes=("Loop",))  # fmt: skip


def _reach(
    do: Steps, parts: tuple[_Part, _Part, _Part], edge: Expr, unit: Expr
) -> tuple[Expr, Boolean, Expr]:
    """How far from this point in y the crossing is at most, whether that is sure, and how fast the
    logarithms of the parts change; all in units of the distance to the nearer end.

    By Newton and Kantorovich, of 2 ln |A/(M W)|: its derivative is the sum of those of the parts.
    """
    gap, rough = _gap(do, parts, unit)
    slope, off, bend, fast = sp.S.Zero, sp.S.Zero, sp.S.Zero, sp.S.Zero
    for sign, part in zip((1, -1, -1), parts, strict=True):
        per, near = part.angle.per, do("near", part.angle.per * edge)
        steep, most = (
            do("t", do("t", 16 * x * per) * near) if x != 0 else x for x in (part.even, part.most)
        )
        bent = do("t", 16 * part.bend * near) * near if part.bend != 0 else part.bend
        slope += sign * steep
        off += most * (unit + 3 * part.angle.off)
        bend += bent + most * most
        fast += most
    slope = do("sure_slope", sp.Abs(do("log_slope", slope)) - do("slope_off", off))
    reach = do("reach", 9 * (sp.Abs(gap) + rough) / (4 * do.nonzero(slope)))
    return reach, And(slope > 0, 8 * do("bend", bend) * reach < slope), do("fast", fast)


def phase_turns(precision: Precision = DOUBLE) -> Routine:
    """Of wall and delay beside the device; NaN where the phase may be an odd number of half turns."""
    do, last = Steps(), unit(precision)
    y, rest = do("at", Max(_Y, 0)), do("still", Max(_REST, 0))
    parts, sine = _parts(do, y, rest, last)
    edge = do("edge", Min(y, rest))
    reach, sure, fast = _reach(do, parts, edge, last)
    below, above, force = (part.angle for part in parts)
    far = y > 2
    half = do("half", atan2(sqrt(choose(far, rest, y)), sqrt(choose(far, y, rest))))
    late = do("late", d + 2)
    halves = do("halves", above.halves + force.halves - below.halves - choose(far, late, 0))
    turned = above.rest + force.rest - below.rest - late * choose(far, -2 * half, 2 * half)
    share = do("share", turned / (2 * pi))
    even = do("even", floor(halves / 2))
    left = do("left", halves / 2 - even)
    odd = sp.Eq(left, sp.S.Half)  # the sign of the rest decides, however small it is
    found = do("found", even + choose(odd, floor(share) + 1, floor(share + left + sp.S.Half)))
    near = do("near", sp.Abs(share - floor(share + sp.S.Half)))
    apart_ = do("distance", choose(odd, near, sp.S.Half - near))
    # the phase turns by so much with y; the waves in it go with the root of y and of 4 - y
    low, high = do("low", edge / do.nonzero(y)), do("high", edge / do.nonzero(rest))
    tilt = do("wave_tilt", (low - high) / 2)
    delayed = do("delayed", 2 * late * edge / do.nonzero(sine))
    turning, most, off = -delayed, delayed, last * delayed
    blur = late * (last + LOOSE) * half
    for sign, part in zip((-1, 1, 1), parts, strict=True):
        along = do("along", part.real * part.angle.per)
        across = do("across", part.up * part.angle.per)
        steep = do("two", part.steep * do("near", part.angle.per * edge))
        one, two = do("one", along * across * tilt), do("two", across * steep)
        turning += sign * (one - two)
        size = do("most", sp.Abs(one) + sp.Abs(two))
        most += size
        off += size * (last + 3 * part.angle.off)
        blur += part.angle.blur + last * sp.Abs(part.angle.rest) / 2
    far_off = do("far_off", 2 * reach * most * (low + high + fast))
    blur += reach * (sp.Abs(do("turning", turning)) + off + far_off)
    good = And(sure, 4 * reach < 1, do("blur", blur) < 6 * apart_)
    good = do("good", choose(good, 1, 0)) > 0
    return do.routine("PhaseTurns", "the nearest whole number of turns in the phase at a crossing, "
                      "NaN where that is not certain",
                      (*POINT, *LOOP), choose(good, found, sp.nan),
                      takes=("Loop",))  # fmt: skip


def nearest_point(precision: Precision = DOUBLE) -> Routine:
    """A point that is known about y = 0, about the own frequency and about 4, from the nearest."""
    do, last = Steps(), unit(precision)
    y, rest, off = POINT[:3]
    small = y < rest
    edge = do("edge", choose(small, y, rest))
    there = And(y > 0, rest > 0, edge < 4)
    inside = And(sp.Abs(off) < edge, CENTER + off > 0, BEYOND - off > 0)
    inside = do("inside", choose(inside, 1, 0)) > 0
    found = {
        "at": choose(inside, CENTER + off, choose(small, y, 4 - rest)),
        "still": choose(inside, BEYOND - off, choose(small, 4 - y, rest)),
        "away": choose(inside, off, choose(small, y - CENTER, BEYOND - rest)),
        "loose": choose(inside, *point_off(last)),
        "free": choose(inside, 0, last * choose(small, CENTER, BEYOND)),
        "there": choose(there, 1, 0),
    }
    return do.routine("NearestPoint", "a point that is known about three, and whether it is on the "
                      "circle", (y, rest, off, CENTER, BEYOND), found, "Point",
                      takes=("Loop",))  # fmt: skip


def point_off(unit: Expr) -> tuple[Expr, Expr]:
    """The parts of y and 4 - y that may be off: those of the own frequency, which is at most y
    twice, and next to the ends of a rounding."""
    return 2 * unit, unit / 4


def _of_nearest(name: str, about: str, routine: str) -> Routine:
    do, given = Steps(), POINT[:3]
    names = ("at", "still", "away", "loose", "free", "there")
    *point, there = do.several(names, "NearestPoint", *given, CENTER, BEYOND)
    point[:2] = (do(s.name, choose(there > 0, s, 2)) for s in point[:2])
    return do.routine(name, about, (*given, CENTER, BEYOND, *LOOP),
                      choose(there > 0, sp.Function(routine)(*point, *LOOP), 0),
                      takes=("Loop",))  # fmt: skip


def crossing_turns() -> Routine:
    """From the point of expansion that is nearest."""
    about = "the turns at a crossing, if there is one"
    return _of_nearest("CrossingTurns", about, "PhaseTurns")


def bottom_touches() -> Routine:
    """The same of the extremum, where there is no crossing."""
    about = "NaN where the wall may be as strong as the device at an extremum of both, else 0"
    return _of_nearest("BottomTouches", about, "Touches")


def _leads(k: _Quadratic) -> Expr:
    """Whether the wall leads next to the end: the first coefficient that is not 0 is negative."""
    zero = sp.Eq(k.c, 0)
    return Or(k.c < 0, And(zero, Or(k.b < 0, And(sp.Eq(k.b, 0), k.a < 0))))


def faint(do: Steps, precision: Precision, spring: Expr = gamma) -> sp.Basic:
    """Whether squares vanish that decide: those of wall and damping, or of the stiffnesses.

    Of a wall and a damping neither is seen to lead then, of the stiffnesses not at z = 1.
    """
    strength = do("strength", sp.Abs(alpha) + sp.Abs(beta))
    stiffest = do("stiffest", Max(sp.Abs(alpha), spring))
    weak = precision.vanishing
    return And(strength > 0, Or(strength + loss < weak, And(stiffest > 0, stiffest < weak)))


def at_the_end(
    do: Steps, far: Expr, unit: Expr, a_off: Expr, apart_off: Expr = sp.S.Zero
) -> Boolean:
    """Whether the wall may be as strong as the device at z = -1, where a root may be then."""
    pull = do("pull", sp.Abs(apart * far))
    off = do("end_off", 2 * unit * (at_minus_one + pull) + apart_off * sp.Abs(far) + a_off)
    return sp.Abs(at_minus_one - pull) <= off


def whole_roots(precision: Precision = DOUBLE) -> Routine:
    """The number of roots outside the unit circle, -1 where floats do not tell it."""
    do = Steps()
    weak = faint(do, precision)
    e = do("e", 1 - loss)
    v = _Wall(do("slope", alpha + beta), sp.S.Zero, do("wall_far", alpha + 2 * beta))
    v = _Wall(v.slope, do("force", v.slope * beta), v.far)
    near, own, far, center, beyond = _about(do, e, v)
    a_off = do("a_off", turned_off(precision, at_minus_one))
    unsure = Or(weak, at_the_end(do, v.far, unit(precision), a_off))
    root, disc = _root(do, (near, own, far))
    ys, offs = _solved(do, near, root), _solved(do, own, root)
    rests = _solved(do, far, root)[::-1]
    loop = (
        alpha, v.slope, v.far, v.force, d, n1, loss, together, apart, sp.S.Zero, sp.S.Zero, a_off,
    )  # fmt: skip
    one, two = (
        sp.Function("CrossingTurns")(y, rest, off, center, beyond, *loop)
        for y, off, rest in zip(ys, offs, rests, strict=True)
    )
    bottoms = (do("bottom", _extremum(do, k)) for k in (near, far, own))
    none = sp.Function("BottomTouches")(*bottoms, center, beyond, *loop)
    total = do("total", choose(disc >= 0, 2 * (one - two), none))
    side = do("side", choose(v.slope >= 0, 1, -1))
    begin = choose(alpha > 0, 0, side)
    end = do(
        "end", choose(v.far > 0, side, 0) - (d + 3) + choose(apart > 0, choose(n1 >= 0, 1, -1), 0)
    )
    total = do("total", total + choose(_leads(near), begin, 0))
    total = do("total", total - choose(_leads(far), end, 0))
    return do.routine("WholeRoots", "roots outside the unit circle, -1 where that is not certain",
                      ARGUMENTS, counted(do, unsure, total))  # fmt: skip


def counted(do: Steps, unsure: Boolean, total: Expr) -> Expr:
    """A count that is certain, else -1; without a wall none is outside."""
    bare = And(sp.Eq(alpha, 0), sp.Eq(beta, 0))
    known = do("known", total)
    return choose(bare, 0, choose(unsure, -1, choose(known >= 0, known, -1)))


def stable(precision: Precision = DOUBLE) -> Routine:
    """No root outside, none at 1, and no device that swings on whatever the wall does."""
    do = Steps()
    swing = do("swing", sqrt(gamma))
    free = And(sp.Eq(alpha, 0), sp.Eq(beta, 0), sp.Eq(delta, 0), gamma > 0)
    bound = 2 * precision.last * swing
    stuck = And(delta < 5 * precision.last, gamma > 1, sp.Abs(sp.sin(swing)) <= bound)
    good = And(sp.Eq(roots, 0), alpha > -gamma, sp.Not(free), sp.Not(stuck))
    return do.routine("Stable", "1 where the loop is stable, else 0",
                      (roots, alpha, beta, gamma, delta), choose(good, 1, 0))  # fmt: skip


ROUTINES = (quadratic_roots, turn_angle, crossing_turns, bottom_touches)
PRECISE = (nearest_point, phase_turns, touches, whole_roots, stable)

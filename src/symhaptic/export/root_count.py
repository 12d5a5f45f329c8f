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

from dataclasses import dataclass

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
    most: Expr = sp.S.Zero
    """b with all terms positive."""


def summed(do: Steps, name: str, *terms: Expr) -> tuple[Expr, Expr]:
    """The sum, and that of the sizes."""
    return do(name, sp.Add(*terms)), do(f"{name}_size", sp.Add(*map(sp.Abs, terms)))


def flat(
    do: Steps,
    terms: tuple[Expr, ...],
    least: Expr,
    size: Expr,
    unit: Expr,
    more: Expr = sp.S.Zero,
) -> Boolean:
    """Whether c + b y + a y^2 (+ k y^3) may have two roots next to y = 0, and may have none.

    A product of up to four numbers of the device is off by 4 units at most; ``more`` of b is lost
    besides.  Where c and a differ in sign there is one root.  The size of c is at least ``least``:
    where it exceeds what the other terms take from it, y <= 4, there is none.
    """
    c, b, a, *k = terms
    room, product = do("room", 4 * unit * size + more), do("product", 4 * c * a)
    takes = 4 * room + sum(64 * sp.Abs(x) for x in k)
    return And(sp.Abs(b) <= room, product >= 0, product <= room * room, least <= 2 * takes)


def _about(do: Steps, e: Expr, v: _Wall) -> tuple[_Quadratic, _Quadratic, _Quadratic, Expr, Expr]:
    """The quadratic about 0, the own frequency and 4, and that frequency's y and 4 - y.

    At y = 0 it is (gamma^2 - alpha^2) (n1 + n0)^2: its sign is that of two exact differences.
    """
    cross, lost = do("cross", n1 * n0), do("lost", loss * loss)
    square, at_one = do("square", e + cross * v.force), do("at_one", gamma * together)
    even = do("even", together * together)
    pull = do("pull", apart * v.far)
    b, most = summed(do, "near1", lost, -at_one * (1 + e), cross * alpha**2, -even * v.force)
    first = do("near0", do("apart_one", (gamma - alpha) * (gamma + alpha)) * even)
    near = _Quadratic(first, b, square, most)
    terms = lost, -at_minus_one * (1 + e), -cross * v.far**2, apart**2 * v.force
    b, most = summed(do, "far1", *terms)
    first = do("far0", (at_minus_one - pull) * (at_minus_one + pull))
    far = _Quadratic(first, b, square, most)
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


def _extremum(do: Steps, k: _Quadratic) -> Expr:
    """Where a quadratic is largest or smallest; -1 for what is infinite."""
    return choose(sp.Eq(k.a, 0), -1, -k.b / (2 * do.nonzero(k.a)))


_WIDE = sp.Integer(4)
"""More than half a turn: nothing is known of an angle that is so far off."""

_Y, _REST, _OFF, LOOSE, FREE = POINT = sp.symbols("y rest off loose free")
"""y, 4 - y and y - center; the parts of the first two, and how much of the last, may be off."""

SLOPE, FAR = sp.symbols("slope far")
APART_OFF, N1_OFF, A_OFF = OFFS = sp.symbols("apart_off n1_off a_off")
LOOP = alpha, SLOPE, FAR, d, n1, loss, together, apart, *OFFS
"""What a crossing is told of wall and device: besides their last places M and A at z = -1 and n1
may be off by the last three."""
CENTER, BEYOND = sp.symbols("center beyond")
"""The own frequency of the device, as y and 4 - y."""


@dataclass(frozen=True)
class _Part:
    """A, M or W, four times as large: its results by :func:`crossing_part`."""

    halves: Expr
    rest: Expr
    size: Expr
    per: Expr
    """1 over the size."""
    off: Expr
    """The most by which the size is off, in parts of itself."""
    blur: Expr
    """The most by which the angle is off."""
    slope: Expr
    """The derivative of 2 ln(size)."""
    fast: Expr
    """The same with all terms positive."""
    bend: Expr
    """The most of its second derivative."""
    turn: Expr
    """The derivative of the angle."""
    spread: Expr
    """The same with all terms positive."""


def crossing_part(precision: Precision = DOUBLE) -> Routine:
    """A number x + j u whose real part is linear in y, and whose u goes with sin(theta).

    Derivatives are those by y, times the distance to the nearer end of the circle, which makes
    edge/y ``low`` and edge/(4 - y) ``high``.
    """
    do = Steps()
    x, u, x_off, u_off, steep, low, high = given = sp.symbols("x u x_off u_off steep low high")
    most, least = do("most", Max(sp.Abs(x), sp.Abs(u))), do("least", Min(sp.Abs(x), sp.Abs(u)))
    ratio = do("ratio", least / do.nonzero(most))
    size = do("size", most * do("longer", sqrt(1 + ratio * ratio)))
    per = do("per", 1 / do.nonzero(size))
    real, up = do("real", x * per), do("up", u * per)
    along, across = do("along", x_off * per), do("across", u_off * per)
    away = do("away", along + across)
    one, two = do("one", sp.Abs(real)), do("two", sp.Abs(up))
    blur = do("blur", (one * across + two * along) * (1 + 2 * away))
    rest = do("rest", atan2(choose(x < 0, -u, u), sp.Abs(x)))
    falls, tilt = do("falls", steep * per), do("tilt", (low - high) / 2)
    square = do("square", up * up)
    fast = do("fast", 2 * sp.Abs(falls) + square * (low + high))
    found = {
        # where u keeps its sign, which is + for 0
        "halves": choose(x < 0, choose(u < 0, -1, 1), 0),
        "rest": rest,
        "size": size,
        "per": per,
        "off": choose(size > 0, one * along + two * across + away * away, 1),
        # what is left of the number is at least three quarters of its size
        "blur": choose(4 * away < 1, blur + unit(precision) * sp.Abs(rest) / 2, _WIDE),
        "slope": 2 * (real * falls + square * tilt),
        "fast": fast,
        "bend": 2 * (falls * falls + square * low * high) + fast * fast,
        "turn": up * (real * tilt - falls),
        "spread": two * (one * sp.Abs(tilt) + sp.Abs(falls)),
    }
    return do.routine("CrossingPart", "of x + j u: half turns and the rest of the angle, the size "
                      "and its inverse, how far both may be off, and how they change with y",
                      given, found, "Part")  # fmt: skip


def _parts(
    do: Steps, y: Expr, rest: Expr, unit: Expr, moving: bool = True
) -> tuple[tuple[_Part, _Part, _Part], Expr, Expr]:
    """A/z, M/z and W at a point, with what the device, the point and three roundings may miss.

    And 4 sin(theta), and the distance to the nearer end.
    """
    sine, total = do("sine", 2 * sqrt(y * rest)), do("total", 2 - loss)
    plain, made = do("plain", LOOSE + unit / 2), do("made", LOOSE + unit * 3 / 2)
    edge = do("edge", Min(y, rest))
    ends = [do(name, edge / do.nonzero(end)) for name, end in (("low", y), ("high", rest))]

    def part(x: Expr, u: Expr, x_off: Expr, u_off: Expr, steep: Expr) -> _Part:
        moved = (edge * steep, *ends) if moving else (0, 0, 0)
        names = ("halves", "turned", "size", "per", "away", "blur", "rise", "fast", "bend", "turn",
                 "spread")  # fmt: skip
        return _Part(*do.several(names, "CrossingPart", x, u, x_off, u_off, *moved))

    below = part(
        do("ahead", -2 * total * _OFF), do("up", loss * sine),
        total * (unit * sp.Abs(_OFF) + 2 * FREE) + 4 * A_OFF, made * loss * sine, -2 * total,
    )  # fmt: skip
    above = part(
        together * rest - apart * y, n1 * sine,
        made * (together * rest + sp.Abs(apart) * y) + APART_OFF * y,
        (made * sp.Abs(n1) + N1_OFF) * sine, -(together + apart),
    )  # fmt: skip
    force = part(
        alpha * rest - FAR * y, SLOPE * sine,
        plain * (sp.Abs(alpha) * rest + sp.Abs(FAR) * y), plain * sp.Abs(SLOPE) * sine,
        -(alpha + FAR),
    )  # fmt: skip
    return (below, above, force), sine, edge


def _gap(do: Steps, parts: tuple[_Part, _Part, _Part], unit: Expr) -> tuple[Expr, Expr]:
    """1 - |M W/A|, and the most by which that is off; finding the sizes rounds, too."""
    below, above, force = parts
    ratio = do("ratio", above.size * below.per)
    gap = do("gap", 1 - ratio * force.size / 4)
    return gap, do("rough", below.off + above.off + force.off + 3 * unit / 2)


LEADS = sp.Symbol("leads")
"""Of the sign of |A|^2 - |M W|^2."""


def touches(precision: Precision = DOUBLE) -> Routine:
    """At an extremum of |A|^2 - |M W|^2, whose sign tells whether there are crossings."""
    do, last = Steps(), unit(precision)
    y, rest = do("at", Max(_Y, 0)), do("still", Max(_REST, 0))
    gap, rough = _gap(do, _parts(do, y, rest, last, moving=False)[0], last)
    gap = do("signed", choose(LEADS > 0, gap, -gap))
    good = do("good", choose(gap > 2 * rough, 1, 0))  # not where the gap is NaN
    return do.routine("Touches", "NaN where it is not certain that the device is stronger if leads "
                      "is positive, and else the wall, else 0",
                      (LEADS, *POINT, *LOOP), choose(And(_Y > 0, _REST > 0, good < 1), sp.nan, 0),
                      takes=("Loop",))  # fmt: skip


def phase_turns(precision: Precision = DOUBLE) -> Routine:
    """Of wall and delay beside the device; NaN where the phase may be an odd number of half turns.

    How far the crossing is from this point at most follows by Newton and Kantorovich, of
    2 ln |A/(M W)|.
    """
    do, last = Steps(), unit(precision)
    y, rest = do("at", Max(_Y, 0)), do("still", Max(_REST, 0))
    parts, sine, edge = _parts(do, y, rest, last)
    below, above, force = parts
    gap, rough = _gap(do, parts, last)
    gap = do("distant", sp.Abs(gap))
    miss = [do("miss", last + 3 * part.off) for part in parts]
    slope_off = sum(part.fast * off for part, off in zip(parts, miss, strict=True))
    slope = do("sure", sp.Abs(below.slope - above.slope - force.slope) - slope_off)
    reach = do("reach", 9 * (gap + rough) / (4 * do.nonzero(slope)))
    bend = do("bends", below.bend + above.bend + force.bend)
    known = And(slope > 0, 8 * bend * reach < slope, 4 * reach < 1)
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
    distance = do("distance", choose(odd, near, sp.S.Half - near))
    # the phase turns by so much over the reach; what goes with sin(theta) has roots of y and 4 - y
    delayed = do("delayed", 2 * late * edge / do.nonzero(sine))
    turning = sp.Abs(above.turn + force.turn - below.turn - delayed)
    most = do("most", delayed + below.spread + above.spread + force.spread)
    fast = 2 + below.fast + above.fast + force.fast
    off = sum(part.spread * off for part, off in zip(parts, miss, strict=True))
    moved = reach * (turning + off + last * delayed + 2 * reach * most * fast)
    blur = below.blur + above.blur + force.blur + late * (last + LOOSE) * half
    good = And(known, do("blur_", blur + moved) < 6 * distance)
    good = do("good", choose(good, 1, 0)) > 0
    return do.routine("PhaseTurns", "the nearest whole number of turns in the phase at a crossing, "
                      "NaN where that is not certain",
                      (*POINT, *LOOP), choose(good, found, sp.nan),
                      takes=("Loop",))  # fmt: skip


def _on_circle(y: Expr, rest: Expr) -> Boolean:
    """Whether a root is there, of y and 4 - y that are known apart; -1 is infinite."""
    return And(y > 0, rest > 0, Min(y, rest) < 4)


def nearest_point(precision: Precision = DOUBLE) -> Routine:
    """A point that is known about y = 0, about the own frequency and about 4, from the nearest."""
    do, last = Steps(), unit(precision)
    y, rest, off = POINT[:3]
    small = y < rest
    edge = do("edge", choose(small, y, rest))
    there = _on_circle(y, rest)
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


def _of_nearest(name: str, about: str, routine: str, *first: sp.Symbol) -> Routine:
    do, given = Steps(), POINT[:3]
    names = ("at", "still", "away", "loose", "free", "there")
    *point, there = do.several(names, "NearestPoint", *given, CENTER, BEYOND)
    point[:2] = (do(s.name, choose(there > 0, s, 2)) for s in point[:2])
    return do.routine(name, about, (*first, *given, CENTER, BEYOND, *LOOP),
                      choose(there > 0, sp.Function(routine)(*first, *point, *LOOP), 0),
                      takes=("Loop",))  # fmt: skip


def crossing_turns() -> Routine:
    """From the point of expansion that is nearest."""
    about = "the turns at a crossing, if there is one"
    return _of_nearest("CrossingTurns", about, "PhaseTurns")


def bottom_touches() -> Routine:
    """The same of the extremum, where there is no crossing."""
    about = "NaN where the wall may be as strong as the device at an extremum of both, else 0"
    return _of_nearest("BottomTouches", about, "Touches", LEADS)


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
) -> tuple[Boolean, Expr]:
    """Whether the wall may be as strong as the device at z = -1, where a root may be then.

    And the least size of A(-1)^2 - (M W)(-1)^2, where it is not.
    """
    pull = do("pull", sp.Abs(apart * far))
    off = do("end_off", 2 * unit * (at_minus_one + pull) + apart_off * sp.Abs(far) + a_off)
    apart_by = do("end_apart", sp.Abs(at_minus_one - pull) - off)
    return apart_by <= 0, do("end_least", apart_by * (at_minus_one + pull))


def whole_roots(precision: Precision = DOUBLE) -> Routine:
    """The number of roots outside the unit circle, -1 where floats do not tell it."""
    do = Steps()
    weak = faint(do, precision)
    e = do("e", 1 - loss)
    v = _Wall(do("slope", alpha + beta), sp.S.Zero, do("wall_far", alpha + 2 * beta))
    v = _Wall(v.slope, do("force", v.slope * beta), v.far)
    near, own, far, center, beyond = _about(do, e, v)
    a_off = do("a_off", turned_off(precision, at_minus_one))
    last = unit(precision)
    end_unsure, least = at_the_end(do, v.far, last, a_off)
    unsure = [
        weak,
        end_unsure,
        flat(do, (near.c, near.b, near.a), sp.Abs(near.c), near.most, last),
        flat(do, (far.c, far.b, far.a), least, far.most, last, 2 * a_off),
    ]
    root, disc = _root(do, (near, own, far))
    ys, offs = _solved(do, near, root), _solved(do, own, root)
    rests = _solved(do, far, root)[::-1]
    loop = (
        alpha, v.slope, v.far, d, n1, loss, together, apart, sp.S.Zero, sp.S.Zero, a_off,
    )  # fmt: skip
    one, two = (
        sp.Function("CrossingTurns")(y, rest, off, center, beyond, *loop)
        for y, off, rest in zip(ys, offs, rests, strict=True)
    )
    bottoms = (do("bottom", _extremum(do, k)) for k in (near, far, own))
    none = sp.Function("BottomTouches")(near.a, *bottoms, center, beyond, *loop)
    inside = [choose(And(disc >= 0, _on_circle(*at)), 1, 0) for at in zip(ys, rests, strict=True)]
    sides = [choose(_leads(k), 1, 0) for k in (near, far)]
    odd = [do("odd", sp.Abs(one - two)) for one, two in (inside, sides)]
    total = do("total", choose(disc >= 0, 2 * (one - two), none))
    side = do("side", choose(v.slope >= 0, 1, -1))
    begin = choose(alpha > 0, 0, side)
    end = do(
        "end", choose(v.far > 0, side, 0) - (d + 3) + choose(apart > 0, choose(n1 >= 0, 1, -1), 0)
    )
    total = do("total", total + choose(_leads(near), begin, 0))
    total = do("total", total - choose(_leads(far), end, 0))
    return do.routine("WholeRoots", "roots outside the unit circle, -1 where that is not certain",
                      ARGUMENTS, counted(do, Or(*unsure, sp.Ne(*odd)), total))  # fmt: skip


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


ROUTINES = (quadratic_roots, crossing_turns, bottom_touches)
PRECISE = (crossing_part, nearest_point, phase_turns, touches, whole_roots, stable)

r"""Roots outside the unit circle, counted at a cost that does not grow with the delay.

On the circle a root needs :math:`|A|=|M||W|` of the device and the wall, a quadratic in
:math:`y=4\sin^2(\theta/2)` that does not contain the delay; between its solutions one side leads
and takes the argument along.  Chapter s4d_roots_counted derives this.  The quadratic is expanded
about y = 0, about the device's own frequency and about y = 4, and each root taken from the nearest.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import And, Expr, Max, Or, atan2, floor, pi, sqrt

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps
from symhaptic.forms.root_count import ARGUMENTS

alpha, beta, d, n1, n0, at_one, at_minus_one, loss, together, apart = ARGUMENTS
roots, gamma, delta = sp.symbols("roots gamma delta")


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
    """halves pi + rest."""

    halves: Expr
    rest: Expr


def _about(do: Steps, e: Expr, v: _Wall) -> tuple[_Quadratic, _Quadratic, _Quadratic, Expr, Expr]:
    """The quadratic about 0, the own frequency and 4, and that frequency's y and 4 - y."""
    cross, lost = do("cross", n1 * n0), do("lost", loss * loss)
    square = do("square", e + cross * v.force)
    push, pull = do("push", together * alpha), do("pull", apart * v.far)
    near = _Quadratic(
        do("near0", (at_one - push) * (at_one + push)),
        do("near1", lost - at_one * (1 + e) + cross * alpha**2 - together**2 * v.force),
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


def turn_angle() -> Routine:
    """Where up keeps its sign, which is + for 0."""
    do = Steps()
    x, y = sp.symbols("x y")
    halves = choose(x < 0, choose(y < 0, -1, 1), 0)
    rest = atan2(choose(x < 0, -y, y), sp.Abs(x))
    return do.routine("TurnAngle", "the angle of x + j y in half turns, and the rest", (x, y),
                      {"halves": halves, "rest": rest}, "Angle")  # fmt: skip


def _angle(do: Steps, real: Expr, up: Expr) -> _Angle:
    """Angle of real + j up."""
    return _Angle(*do.several(("halves", "turned"), "TurnAngle", real, up))


_Y, _REST, _OFF = sp.symbols("y rest off")
SLOPE, FAR = sp.symbols("slope far")
LOOP = alpha, SLOPE, FAR, d, n1, loss, together, apart
"""What a crossing is told of wall and device."""
CENTER, BEYOND = sp.symbols("center beyond")
"""The own frequency of the device, as y and 4 - y."""


def turns(y: Expr, rest: Expr, off: Expr, *loop: Expr) -> Expr:
    """The nearest whole number of turns in the phase at a crossing."""
    return sp.Function("PhaseTurns")(y, rest, off, *loop)


def phase_turns() -> Routine:
    """Of wall and delay beside the device."""
    do = Steps()
    y, rest = do("at", Max(_Y, 0)), do("still", Max(_REST, 0))
    sine = do("sine", 2 * sqrt(y * rest))
    below = _angle(do, -2 * (2 - loss) * _OFF, loss * sine)
    above = _angle(do, together * rest - apart * y, n1 * sine)
    force = _angle(do, alpha * rest - FAR * y, SLOPE * sine)
    far = y > 2
    half = do("half", atan2(sqrt(choose(far, rest, y)), sqrt(choose(far, y, rest))))
    late = do("late", d + 2)
    halves = do("halves", above.halves + force.halves - below.halves - choose(far, late, 0))
    turned = above.rest + force.rest - below.rest - late * choose(far, -2 * half, 2 * half)
    share = do("share", turned / (2 * pi))
    even = do("even", floor(halves / 2))
    left = do("left", halves / 2 - even)
    odd = sp.Eq(left, sp.S.Half)  # the sign of the rest decides, however small it is
    found = even + choose(odd, floor(share) + 1, floor(share + left + sp.S.Half))
    return do.routine("PhaseTurns", "the nearest whole number of turns in the phase at a crossing",
                      (_Y, _REST, _OFF, *LOOP), found, takes=("Loop",))  # fmt: skip


def crossing_turns() -> Routine:
    """From the point of expansion that is nearest."""
    do = Steps()
    center, beyond = CENTER, BEYOND
    small = _Y < _REST
    edge = do("edge", choose(small, _Y, _REST))
    there = And(_Y > 0, _REST > 0, edge < 4)
    inside = And(sp.Abs(_OFF) < edge, center + _OFF > 0, beyond - _OFF > 0)
    inside = do("inside", choose(inside, 1, 0)) > 0
    at = do("at", choose(inside, center + _OFF, choose(small, _Y, 4 - _REST)))
    still = do("still", choose(inside, beyond - _OFF, choose(small, 4 - _Y, _REST)))
    away = do("away", choose(inside, _OFF, choose(small, _Y - center, beyond - _REST)))
    at, still = do("at", choose(there, at, 2)), do("still", choose(there, still, 2))
    return do.routine("CrossingTurns", "the turns at a crossing, if there is one",
                      (_Y, _REST, _OFF, center, beyond, *LOOP),
                      choose(there, turns(at, still, away, *LOOP), 0),
                      takes=("Loop",))  # fmt: skip


def _leads(k: _Quadratic) -> Expr:
    """Whether the wall leads next to the end: the first coefficient that is not 0 is negative."""
    zero = sp.Eq(k.c, 0)
    return Or(k.c < 0, And(zero, Or(k.b < 0, And(sp.Eq(k.b, 0), k.a < 0))))


def faint(do: Steps, precision: Precision) -> sp.Basic:
    """Whether the squares of wall and damping vanish together: then neither is seen to lead."""
    strength = do("strength", sp.Abs(alpha) + sp.Abs(beta))
    return And(strength > 0, strength + loss < precision.vanishing)


def whole_roots(precision: Precision = DOUBLE) -> Routine:
    """The number of roots outside the unit circle, -1 where floats do not tell it."""
    do = Steps()
    weak = faint(do, precision)
    e = do("e", 1 - loss)
    v = _Wall(do("slope", alpha + beta), sp.S.Zero, do("wall_far", alpha + 2 * beta))
    v = _Wall(v.slope, do("force", v.slope * beta), v.far)
    near, own, far, center, beyond = _about(do, e, v)
    root, disc = _root(do, (near, own, far))
    ys, offs = _solved(do, near, root), _solved(do, own, root)
    rests = _solved(do, far, root)[::-1]
    loop = alpha, v.slope, v.far, d, n1, loss, together, apart
    one, two = (
        sp.Function("CrossingTurns")(y, rest, off, center, beyond, *loop)
        for y, off, rest in zip(ys, offs, rests, strict=True)
    )
    total = 2 * (one - two)
    total = do("total", choose(disc >= 0, total, 0))
    side = do("side", choose(v.slope >= 0, 1, -1))
    begin = choose(alpha > 0, 0, side)
    end = do(
        "end", choose(v.far > 0, side, 0) - (d + 3) + choose(apart > 0, choose(n1 >= 0, 1, -1), 0)
    )
    total = do("total", total + choose(_leads(near), begin, 0))
    total = do("total", total - choose(_leads(far), end, 0))
    return do.routine("WholeRoots", "roots outside the unit circle, -1 where that is not known",
                      ARGUMENTS, choose(weak, -1, total))  # fmt: skip


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


ROUTINES = (quadratic_roots, turn_angle, phase_turns, crossing_turns)
PRECISE = (whole_roots, stable)

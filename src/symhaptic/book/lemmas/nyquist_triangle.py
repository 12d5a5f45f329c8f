"""With a spring at the Nyquist frequency the stable walls without delay are a triangle.

One zero of the polynomial is -f, f = exp(-delta/2), whatever the wall; the others are those of
z^2 + (f + nu (alpha + beta)) z - nu beta, where nu = (1 + f)/gamma.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.springs_alike import line_and_curve
from symhaptic.book.lemmas.stiffest_stable import no_stiffer
from symhaptic.paper.propositions.plots import (
    ARMS,
    BESIDE,
    DAMPERS,
    LEFT,
    NYQUIST,
    TIMES,
    triangle,
    undelayed,
)
from symhaptic.proof import box
from symhaptic.proof.theorems.definitions import loop_substituted
from symhaptic.proof.theorems.leaves import on_box as on_plain_box

f, NU = LEFT, (1 + LEFT) / NYQUIST
SIDES = 1 + f + NU * alpha, 1 + NU * beta, 1 - f - NU * (alpha + 2 * beta)
"""Each is positive on its side of a line."""


@cache
def damped() -> Given:
    """0 < f < 1 and 0 < nu, for a damper."""
    here = Given(delta > 0)
    here.have(f > 0)
    here.have(1 - f > 0, rising(exp, -delta / 2, S.Zero))
    for claim in NYQUIST > 0, NU > 0, 1 + f > 0:
        here.have(claim)
    return here


POLE = -delta / 2 + I * pi
N_1 = -I * ((-1 - f) / POLE - (-1 - f) / mirror(POLE)) / (2 * pi)
"""n1 by the two poles; n0 is f n1."""


@cache
def inequalities() -> Theorem:
    """stable <=> Jury's inequalities of the loop with this spring."""
    by_poles = loop_substituted([alpha, beta, NYQUIST, delta, S.Zero], z, 1)
    loop = z * (z**2 + 2 * z * e + e**2) + (z * (alpha + beta) - beta) * (z * x + e * x)
    there = Predicate("stable", (z,), (loop.xreplace({e: f, x: s}),))
    alike = Iff((by_poles.conclusion.of[0], there))  # type: ignore[attr-defined]
    found = subst(alike, s, by_poles, identity(N_1, NU))
    found = chained(found, inst(jury(loop, z), {e: f, x: NU}))
    nyquist = damped().show(NYQUIST > 0)
    poles = [
        factor(pole, combined(sp.expand(pole * other) > 0, [nyquist]), other)
        for pole, other in ((POLE, mirror(POLE)), (mirror(POLE), POLE))
    ]
    return closed(found, fact(whole(S.Zero)), show(Ne(NYQUIST, 0), nyquist), *poles)


def needed() -> Theorem:
    """The wall of a stable loop is inside the triangle."""
    found = mp(inequalities(), assume(undelayed(spring=NYQUIST)))
    known = [conjunct(found, p) for p in conjuncts(found.conclusion)]
    here, (one, three, two) = damped().and_(), SIDES
    right = here.have(one > 0, over(one > 0, show((1 + f) * one > 0, known[0]), 1 + f > 0))
    top = here.have(two > 0, over(two > 0, show((1 - f) * two > 0, known[2]), 1 - f > 0))
    rest = f * two + (1 - f) * (1 - f + f * three)
    room = here.have(rest > 0, known[1], degree=3)
    low = here.have(three > 0, over(three > 0, show(three * rest > 0, known[3]), room))
    sides = [
        over(p, show(NU * (p.gts - p.lts) > 0, t), NU > 0)
        for p, t in zip(triangle(), (right, low, top), strict=True)
    ]
    return here.closed(conj(*sides))


def enough() -> Theorem:
    """A wall inside the triangle makes a stable loop."""
    loop, here = inequalities(), damped()
    right, low, top = (here.show(side > 0, p) for side, p in zip(SIDES, triangle(), strict=True))
    more, lost, left = (here.show(e > 0) for e in (1 + f, 1 - f, f))
    wanted = conjuncts(loop.conclusion.of[1])  # type: ignore[attr-defined]
    known = [
        show(wanted[0], more, right),
        show(wanted[1], more, low, lost, right),
        show(wanted[2], lost, top),
        combined(wanted[3], [low, left, top], [low, lost, lost], [low, lost, left, low]),
    ]
    found = mp(loop, conj(*known))
    return here.closed(found)


@cache
def is_triangle() -> Theorem:
    """stable <=> inside the triangle, for a damper."""
    return either_way(needed(), enough(), undelayed(spring=NYQUIST), both(triangle()))


WALL = Rational(95, 10), -Rational(49, 10)
"""Near the sharp corner, for all dampers of (23)."""


def reached() -> Theorem:
    """This wall is stable."""
    here, wall = damped().and_(), dict(zip((alpha, beta), WALL, strict=True))
    far = number(Relation(S.Zero, "<", pi**2 - 2 * -WALL[1]))
    low = here.show(NYQUIST + WALL[1] * (1 + f) > 0, far, square(delta))
    low = over(NYQUIST / (1 + f) + WALL[1] > 0, low, 1 + f > 0)
    known = low, here.show(NYQUIST / (1 + f) > 0)
    return here.closed(mp(inst(is_triangle(), wall), here.show(both(triangle()).at(wall), *known)))


def stiffer() -> Theorem:
    """It is 13 times as stiff as every stable wall with a spring of (23)."""
    limit = no_stiffer(0, (Rational(72, 100), Rational(83, 100)), RANGES)
    given = [*map(proposition, ARMS), undelayed()]
    gap = combined(
        Relation(TIMES * alpha, "<", WALL[0]), [TIMES, limit], [WALL[0] - TIMES * Rational(72, 100)]
    )
    others = for_all((alpha, beta, gamma), given, add_assum(gap, *given))
    wanted = taken_apart(shape_and_size().parts[2])[2]
    return exists(conj(reached(), others), wanted, dict(zip(BESIDE, WALL, strict=True)))


@cache
def other_shape_and_size() -> Theorem:
    """All three parts."""
    shape = for_all((alpha, beta, delta), DAMPERS, add_assum(is_triangle(), *DAMPERS))
    size = for_all((delta,), DAMPERS, add_assum(stiffer(), *DAMPERS))
    return conj(line_and_curve(), shape, size)


@cache
def hardly_moved() -> Theorem:
    """The triangle for every damper of (23), and that its sides move by less than 0.05."""
    shape, sides = CLAIMED["s5c-delta-hardly-visible"](()).parts
    kept = as_claimed(shape, is_triangle())
    goals = taken_apart(sides)[2]
    known = []
    for goal in conjuncts(goals):
        gap = goal.right - goal.left  # type: ignore[attr-defined]
        known.append(combined(goal, [on_plain_box(box.positive(gap, {delta: (0, DAMPED)}))]))
    ends = positive(delta >= 0, delta > 0)
    moved = as_claimed(sides, closed(conj(*known), ends))
    return conj(kept, moved)


def shape_and_size() -> Proposition:
    """What is claimed."""
    return CLAIMED["s5c-shape"](())

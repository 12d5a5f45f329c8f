"""On the boundary of the stable walls near the origin Jury's largest minor is zero, d = 0 and 1.

All is said of an arm's four numbers, inside (23), and of walls with alpha > -gamma and a damping
between two bounds.  There the largest of Jury's minors is what fails first, and it falls with the
stiffness.
"""

from symhaptic.book.lemmas.arm_numbers import pushed, together
from symhaptic.book.lemmas.line_crossing import AT_REST, TOTAL, divided, slow
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import WIDEST, damping_between, inequalities, on_box
from symhaptic.paper.propositions.linear_error import on_boundary_at as here
from symhaptic.proof.theorems.kernel import spec

LOW, HIGH = -Rational(3, 100), Rational(1, 10)
"""The virtual dampings of which all this is said; no stable wall with alpha > -gamma has less."""

TOP = {0: Rational(3, 10), 1: Rational(1, 10)}
"""No stable wall with so much damping at most is as stiff."""

PUSH = beta * TOTAL + 1 - e + gamma * n_0
"""(beta + s_1) (n_1 + n_0)."""


def box(delay: int) -> dict[Symbol, tuple[Any, Any]]:
    """Arms and walls."""
    return {**RANGES, alpha: (-STIFF, TOP[delay]), beta: (LOW, HIGH)}


def minor(delay: int) -> Expr:
    """The largest of Jury's minors, as a function of alpha and beta."""
    *_, last = conjuncts(by_inequalities(delay).conclusion.of[1])  # type: ignore[attr-defined]
    value: Expr = last.right  # type: ignore[attr-defined]
    return value


@cache
def static() -> Theorem:
    """a = 1 + e - gamma (n_1 + n_0)."""
    return combined(Relation(a, "=", AT_REST), [device_static(assume(DEVICE)), -1])


def turn(value: Expr) -> list[Any]:
    """What the value of a gives for this polynomial."""
    return [static(), -divided(value, a, AT_REST)]


@cache
def least(delay: int) -> Theorem:
    """-0.03 <= beta of a stable wall with -gamma < alpha, no stiffer than the top."""
    low, _, _ = damping_between(delay, RANGES)
    known = inequalities(delay)[-1]
    wide = {**RANGES, alpha: (-STIFF, TOP[delay]), beta: (-WIDEST, LOW)}
    fails = Given(beta < LOW).closed(on_box(-minor(delay), wide), low)
    found = by_contradiction(beta >= LOW, known, show(minor(delay) <= 0, fails))
    return closed(of_every_plant(found), soft())


@cache
def unstable_at_the_top(delay: int) -> Theorem:
    """Falsehood, from a stable wall at the top with beta <= 0.1."""
    there = {alpha: S(TOP[delay])}
    low, _, _ = (inst(t, there) for t in damping_between(delay, RANGES))
    value = minor(delay).subs(there)
    wide = on_box(-value, {**RANGES, beta: (-WIDEST, HIGH)})
    known = inst(inequalities(delay)[-1], there)
    contrary = not_intro(known, show(value <= 0, wide))
    return closed(of_every_plant(contrary), low)


def soft() -> Theorem:
    """-0.001 <= alpha for -gamma < alpha."""
    return positive(alpha >= -STIFF, -gamma < alpha, gamma <= STIFF)


@cache
def enough(delay: int) -> Theorem:
    """A wall with a positive minor is stable: -gamma < alpha, inside the box."""
    loop = by_inequalities(delay)
    goals = conjuncts(loop.conclusion.of[1])  # type: ignore[attr-defined]
    above = -gamma < alpha
    shown = []
    for place, goal in enumerate(goals):
        value = goal.right  # type: ignore[attr-defined]
        if place == 0:
            known = positive(goal, [together(), above], turn(value))
        elif place == len(goals) - 1:
            known = assume(goal)
        elif (delay, place) == (0, 1):
            known = positive(goal, [2, _push()], [pushed()[2], above], turn(value))
        else:
            known = combined(goal, [on_box(value, box(delay))])
        shown.append(known)
    return closed(mp(loop, conj(*shown)), slow(), soft())


def _push() -> Theorem:
    """0 < (beta + s_1) (n_1 + n_0) where the minor without delay is positive."""
    value = minor(0)
    inside, toward = 1 - n_0 * beta, 1 + n_1 * beta
    room, way = (on_box(f, box(0)) for f in (inside, toward))
    products = [value > 0], [pushed()[1], way, -gamma < alpha], turn(inside * PUSH - value)
    product = positive(inside * PUSH > 0, *products)
    return closed(over(PUSH > 0, product, room), positive(Ne(inside, 0), [room]))


def softer(delay: int) -> Expr:
    """-(f(x) - f(alpha))/(x - alpha) of the minor f."""
    value = minor(delay)
    return -divided(value, alpha, x)


@cache
def falls(delay: int) -> Theorem:
    """0 < (f(x) - f(alpha))/(alpha - x): the minor f falls with the stiffness."""
    wide = box(delay)
    return on_box(softer(delay), {**wide, x: wide[alpha]})


@cache
def on_it(delay: int) -> Theorem:
    """A wall of the boundary with beta <= 0.1 is in the box: alpha <= its top, -0.03 <= beta."""
    boundary = assume(here(delay))
    left, _, every = (conjunct(boundary, claim) for claim in conjuncts(here(delay)))
    middle = (alpha - gamma) / 2
    above, top = Given(gamma >= 0).and_(left), TOP[delay]
    damped = closed(inst(least(delay), {alpha: middle}), _at(every, middle))
    wrong = contr(closed(unstable_at_the_top(delay), _at(every, S(top))), alpha <= top)
    stiff = above.closed(disj_cases(ordered(top, alpha), wrong, assume(alpha <= top)))
    return conj(stiff, above.closed(damped, stiff))


def _at(every: Theorem, stiffness: Expr) -> Theorem:
    """The wall x of the same damping is stable, for -gamma < x < alpha."""
    known = conj(assume(-gamma < stiffness), assume(stiffness < alpha))
    return mp(spec(every, {x: stiffness}), known)


@cache
def level(delay: int) -> Theorem:
    """The minor of a wall on the boundary is zero, for beta <= 0.1."""
    boundary, value = assume(here(delay)), minor(delay)
    left, unstable, every = (conjunct(boundary, claim) for claim in conjuncts(here(delay)))
    before = closed(inst(inequalities(delay)[-1], {alpha: x}), _at(every, x))
    end = tends(value.xreplace({alpha: x}), x, alpha, value)
    above = closed(in_the_limit(before, x, -gamma, alpha, end), left)
    stable = closed(enough(delay), left, *_inside(delay))
    return both_ways(by_contradiction(value <= 0, stable, unstable), above)


def _inside(delay: int) -> tuple[Theorem, ...]:
    found = on_it(delay)
    return tuple(conjunct(found, claim) for claim in conjuncts(found.conclusion))


@cache
def reached(delay: int) -> Theorem:
    """A wall whose minor is zero is on the boundary: -gamma < alpha, inside the box."""
    value = minor(delay)
    zero, left = assume(Eq(value, 0)), assume(-gamma < alpha)
    wall = here(delay).of[1].of[0]  # type: ignore[attr-defined]
    known = closed(inequalities(delay)[-1], assume(wall))
    unstable = not_intro(known, zero, wall)
    more = positive(value.xreplace({alpha: x}) > 0, [x < alpha, falls(delay)], [zero, -1])
    less = Given(-gamma < x, x < alpha, alpha <= TOP[delay], gamma <= STIFF)
    found = less.closed(closed(inst(enough(delay), {alpha: x}), more))
    every = gen(disch(found, -gamma < x, x < alpha), x)
    return closed(conj(left, unstable, every), soft())

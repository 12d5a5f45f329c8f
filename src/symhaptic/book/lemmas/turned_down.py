"""A stable wall without delay stays stable while its stiffness falls, beside soft springs."""

from symhaptic.book.lemmas.arm_numbers import pushed
from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import (
    damping_between,
    inequalities,
    of_every_plant,
    towards,
)
from symhaptic.paper.propositions.comparison import STABLE

WIDE = {gamma: (S.Zero, Rational(1, 100)), delta: (S.Zero, Rational(1, 10))}
FARTHEST = Rational(5, 2)
"""No stable wall has a larger virtual damping, of either sign, as 1 < 2.5 n_0."""

TOTAL = n_1 + n_0
DAMPING = (1 - e + gamma * n_0) / TOTAL
"""s_1, the damping of the arm near z = 1."""


def claim() -> Proposition:
    """With gamma <= 0.01 and delta <= 0.1 a stable wall is stable at any stiffness above -gamma."""
    arm = [bound for s, (low, high) in WIDE.items() for bound in (s >= low, s <= high)]
    here = STABLE.at({d: S.Zero})
    given = [*arm, -gamma < x, x <= alpha, here]
    return ForAll((alpha, beta, gamma, delta, x), implied(given, here.at({alpha: x})))


@cache
def turned_down() -> Theorem:
    """The wall (x, beta) is stable where (alpha, beta) is, for -gamma < x <= alpha."""
    *planes, minor = inequalities(0)
    low, high, inside = damping_between(0, WIDE, FARTHEST)
    toward = towards(planes, minor, inside, {**WIDE, beta: (-FARTHEST, FARTHEST)})
    first, second, less = pushed()
    total = positive(TOTAL > 0, [first], [second])
    above, fall = positive(x + gamma > 0, -gamma < x), positive(alpha - x >= 0, x <= alpha)
    there = positive(alpha + gamma > 0, [above], [fall])
    turn = combined(Relation(a, "=", 1 + e - gamma * TOTAL), [device_static(assume(DEVICE)), -1])
    # the minor is (n_1 + n_0) (1 - n_0 beta) (beta + s_1) - n_0 (1 + n_1 beta) (alpha + gamma)
    left = (1 - n_0 * beta) * (beta * TOTAL + 1 - e + gamma * n_0)
    product = combined(left > 0, [minor], [second, toward, there], [turn, n_0 * beta])
    push = over(beta * TOTAL + 1 - e + gamma * n_0 > 0, product, inside)
    push = closed(push, positive(Ne(1 - n_0 * beta, 0), [inside]))
    heavier = positive(n_1 - n_0 >= 0, [less])
    rows = (
        ([total, above], [turn, S.One]),
        ([2, push], [heavier, above], [turn, S.One]),
        ([planes[2]], [heavier, fall]),
        ([minor], [second, toward, fall]),
    )
    loop = inst(by_inequalities(0), {alpha: x})
    goals = conjuncts(loop.conclusion.of[1])  # type: ignore[attr-defined]
    shown = [combined(goal, *known) for goal, known in zip(goals, rows, strict=True)]
    found = closed(mp(loop, conj(*shown)), low, high)
    return closed(of_every_plant(found), _slow())


def _slow() -> Theorem:
    """These arms do not swing by half a turn in a period."""
    soft = WIDE[gamma][1]
    far = number(Relation(soft, "<", pi**2))
    return positive(
        gamma - delta**2 / 4 < pi**2, [gamma <= soft], [far], [Rational(1, 4), square(delta)]
    )

"""Each wall of the envelope leaves all angles 0 < N psi < pi a margin, for every N > 2."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import cosine, not_zero, sine, sine_of_larger
from symhaptic.book.lemmas.envelope import (
    LOWER,
    TURN,
    UPPER,
    apart,
    damping,
    divisors_at,
    line,
    same_side,
    stiffness,
    turned,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.tip import (
    STIFFEST,
    at_tip,
    below_tip,
    by_three,
    divisors_at_tip,
    level,
    tip,
    wave,
)

WALL = stiffness(phi), damping(phi)
GOAL = line(*WALL) >= 0


@cache
def other_side(side: int) -> Theorem:
    """0 <= F of the wall (U, W)(phi), on one side of N psi = pi/2, at psi on the other."""
    stiff = stiffness(phi)
    less = positive(STIFFEST - stiff > 0, [inst(below_tip(side), {psi: phi})])
    cotangent, other = (_cotangent(angle) for angle in (psi, phi))
    share = over(
        -cos(N * psi) / cos(N * phi) > 0,
        positive(-side * cos(N * psi) > 0, [turned(-side)]),
        turned(side, phi),
    )
    found = positive(
        line(stiff, damping(phi)) >= 0,
        [tip()],
        [less, cotangent, sine_of_larger()],
        [share, inst(tip(), {psi: phi})],
        [share, less, other, sine_of_larger(phi)],
    )
    return closed(
        found, *divisors_at(phi, side), *divisors_at(psi, -side), apart(phi), *divisors_at_tip()
    )


def _cotangent(angle: Expr) -> Theorem:
    """0 < cot psi."""
    found = over(cos(angle) / sin(angle) > 0, cosine(angle), sine(angle))
    return closed(found, not_zero(sine(angle)))


@cache
def one_side(side: int) -> Theorem:
    """0 <= F of the wall (U, W)(phi) at psi, both on one side of N psi = pi/2."""
    after, before = (positive(GOAL, [same_side(side, first)]) for first in (True, False))
    there = combined(line(*WALL, phi) >= 0, [identity(line(*WALL, phi), S.Zero), S.NegativeOne])
    same = subst(proposition(GOAL).at({psi: x}), x, there, assume(Eq(phi, psi)))
    equal = combined(Eq(phi, psi), [assume(Eq(psi, phi)), S.NegativeOne])
    same = closed(same, equal, apart(phi), not_zero(sine(phi)), not_zero(sine()))
    less = strictly(assume(psi <= phi), assume(Ne(psi, phi)))
    return disj_cases(
        ordered(phi, psi), after, disj_cases(decided(psi, phi), same, closed(before, less))
    )


@cache
def seen_from_tip(side: int) -> Theorem:
    """0 <= F of the wall (U, W)(phi) at N psi = pi/2."""
    less = positive(STIFFEST - WALL[0] > 0, [inst(below_tip(side), {psi: phi})])
    cotangent = over(cos(TURN) / sin(TURN) > 0, level(), wave())
    there = positive(line(*WALL, TURN) >= 0, [less, cotangent])
    found = at_tip(GOAL, there)
    divisors = not_zero(wave()), apart(phi), not_zero(sine(phi)), not_zero(sine())
    return closed(found, *divisors, *divisors_at_tip())


@cache
def from_tip() -> Theorem:
    """0 <= F at psi of the wall (U, W)(phi) with N phi = pi/2."""
    goal = proposition(GOAL).at({phi: x})
    there = combined(goal.at({x: TURN}), [tip()])
    equation = combined(Eq(TURN, phi), [assume(Eq(N * phi, pi / 2)), -1 / N])
    found = subst(goal, x, there, equation)
    return closed(found, *divisors_at_tip(), apart(phi), not_zero(sine()))


@cache
def touches() -> Theorem:
    """0 <= F of the wall (U, W)(phi) at psi, for N > 2 and 0 < N phi < pi, 0 < N psi < pi."""
    lower = by_three(GOAL, one_side(LOWER), seen_from_tip(LOWER), other_side(LOWER))
    upper = by_three(GOAL, other_side(UPPER), seen_from_tip(UPPER), one_side(UPPER))
    return by_three(GOAL, lower, from_tip(), upper, phi)

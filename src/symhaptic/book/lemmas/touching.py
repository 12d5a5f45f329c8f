"""Each wall of the envelope leaves all angles 0 < N psi < pi a margin, for every N > 2."""

from symhaptic.book.lemmas.chords import HERE, cosine, sine, sine_of_larger, width
from symhaptic.book.lemmas.envelope import (
    LOWER,
    TURN,
    UPPER,
    beside,
    damping,
    line,
    same_side,
    stiffness,
    turned,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.tip import STIFFEST, at_tip, below_tip, by_three, known_at_tip, tip

WALL = stiffness(phi), damping(phi)
GOAL = line(*WALL) >= 0
BOTH = HERE.and_(phi > 0, N * phi < pi)


def _known(*angles: Expr) -> list[Theorem]:
    """The signs at the tip and at angles."""
    signs = cosine, sine, sine_of_larger, width
    return [*known_at_tip(), *(f(angle) for angle in angles for f in signs)]


@cache
def other_side(side: int) -> Theorem:
    """0 <= F of the wall (U, W)(phi), on one side of N psi = pi/2, at psi on the other."""
    here = BOTH.and_(beside(side, phi), beside(-side, psi))
    known = *_known(phi, psi), turned(-side), turned(side, phi)
    less = here.closed(show(STIFFEST - WALL[0] > 0, inst(below_tip(side), {psi: phi})))
    cotangent, other = (here.show(cos(v) / sin(v) > 0, *known) for v in (psi, phi))
    share = here.show(-cos(N * psi) / cos(N * phi) > 0, *known)
    found = positive(
        GOAL,
        [tip()],
        [less, cotangent, sine_of_larger()],
        [share, inst(tip(), {psi: phi})],
        [share, less, other, sine_of_larger(phi)],
    )
    return here.closed(found, *known)


@cache
def one_side(side: int) -> Theorem:
    """0 <= F of the wall (U, W)(phi) at psi, both on one side of N psi = pi/2."""
    after, before = (show(GOAL, same_side(side, first)) for first in (True, False))
    there = BOTH.show(line(*WALL, phi) >= 0, *_known(phi))
    same = subst(proposition(GOAL).at({psi: x}), x, there, show(Eq(phi, psi), Eq(psi, phi)))
    less = strictly(assume(psi <= phi), assume(Ne(psi, phi)))
    below = disj_cases(decided(psi, phi), same, closed(before, less))
    return BOTH.closed(disj_cases(ordered(phi, psi), after, below), *_known(phi, psi))


@cache
def seen_from_tip(side: int) -> Theorem:
    """0 <= F of the wall (U, W)(phi) at N psi = pi/2."""
    here = Given(N > 2, phi > 0, N * phi < pi, beside(side, phi))
    known = *_known(phi), inst(below_tip(side), {psi: phi})
    cotangent = here.show(cos(TURN) / sin(TURN) > 0, *known)
    there = here.show(line(*WALL, TURN) >= 0, *known, cotangent)
    return BOTH.closed(at_tip(GOAL, there), *_known(phi, psi))


@cache
def from_tip() -> Theorem:
    """0 <= F at psi of the wall (U, W)(phi) with N phi = pi/2."""
    goal = proposition(GOAL).at({phi: x})
    there = combined(goal.at({x: TURN}), [tip()])
    equation = combined(Eq(TURN, phi), [assume(Eq(N * phi, pi / 2)), -1 / N])
    return BOTH.closed(subst(goal, x, there, equation), *_known(phi, psi))


@cache
def touches() -> Theorem:
    """0 <= F of the wall (U, W)(phi) at psi, for N > 2 and 0 < N phi < pi, 0 < N psi < pi."""
    lower = by_three(GOAL, one_side(LOWER), seen_from_tip(LOWER), other_side(LOWER))
    upper = by_three(GOAL, other_side(UPPER), seen_from_tip(UPPER), one_side(UPPER))
    return by_three(GOAL, lower, from_tip(), upper, phi)

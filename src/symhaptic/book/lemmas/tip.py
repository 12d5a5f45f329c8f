"""The tip of the envelope, where N psi = pi/2, leaves all angles 0 < N psi < pi a margin."""

from symhaptic.book.lemmas.chords import HERE, lowest_coefficients, sine, size, width
from symhaptic.book.lemmas.envelope import (
    LOWER,
    TURN,
    UPPER,
    beside,
    border,
    divisor,
    line,
    rises,
    stiffness,
    turned,
)
from symhaptic.book.lemmas.prelude import *

STIFFEST, ITS_DAMPING = tan(TURN), 2 / (N * sin(pi / N))
"""The tip of the envelope, where N psi = pi/2."""
DELAYED = Given(N > 2)
wave = DELAYED.lemma(sin(TURN) > 0)
level = DELAYED.lemma(cos(TURN) > 0)
double = DELAYED.lemma(sin(pi / N) > 0)


def known_at_tip() -> tuple[Theorem, ...]:
    """The signs at the tip."""
    return size(), wave(), level(), double()


def _beside(side: int, angle: Expr = psi) -> list[Theorem]:
    """The signs at the tip and at an angle on one side of it."""
    return [*known_at_tip(), sine(angle), width(angle), turned(side, angle)]


def _here(side: int) -> Given:
    return Given(N > 2, psi > 0, N * psi < pi, beside(side, psi))


@cache
def below_tip(side: int) -> Theorem:
    """U(psi) < tan(pi/(2N)) on either side of the tip."""
    tip = {psi: TURN} if side == LOWER else {phi: TURN, psi: psi}
    moved = inst(rises(side), {**tip, phi: psi} if side == LOWER else tip)
    return _here(side).show(stiffness() < STIFFEST, *_beside(side), moved)


@cache
def tip_beside(side: int) -> Theorem:
    """0 < F of the tip at an angle on either side of it."""
    here, inside = _here(side), Given(N > 2, x > 0, x < TURN)
    there = TURN - side * x
    moved = border(STIFFEST) + ITS_DAMPING
    slope = over(
        -derivative(moved, psi) > 0,
        divisor() * (STIFFEST - stiffness()) > 0,
        2 * sin(psi) ** 2 * cos(N * psi) ** 2 > 0,
    )
    slope = inst(here.closed(slope, *_beside(side), below_tip(side)), {psi: there})
    curve = side * moved.xreplace({psi: there})
    slope = inside.show(derivative(curve, x) > 0, *_beside(side, there), slope)
    rising = increases(curve, x, S.Zero, TURN, slope, *inside.defined(curve, *_beside(side, there)))
    found = above_its_start(rising, tends(curve, x, S.Zero, S.Zero))
    found = closed(found, *lowest_coefficients(found, wave(), TURN))
    found = here.closed(inst(found, {x: side * (TURN - psi)}), *_beside(side))
    return here.show(line(STIFFEST, ITS_DAMPING) > 0, *_beside(side), found)


@cache
def tip() -> Theorem:
    """0 <= F of the tip, for 0 < N psi < pi."""
    goal, there = line(STIFFEST, ITS_DAMPING) >= 0, line(STIFFEST, ITS_DAMPING, x)
    low, high = (show(goal, tip_beside(side)) for side in (LOWER, UPPER))
    middle = at_tip(goal, DELAYED.show(there.xreplace({x: TURN}) >= 0, *known_at_tip()))
    return by_three(goal, low, HERE.closed(middle, sine(), *known_at_tip()), high)


def at_tip(goal: Any, there: Theorem) -> Theorem:
    """A relation at N psi = pi/2 from the one at psi = pi/(2N)."""
    equation = combined(Eq(TURN, psi), [assume(Eq(N * psi, pi / 2)), -1 / N])
    found = subst(proposition(goal).at({psi: x}), x, there, equation)
    return DELAYED.closed(found, *known_at_tip())


def by_three(goal: Any, below: Theorem, at: Theorem, above: Theorem, angle: Expr = psi) -> Theorem:
    """A relation for N psi < pi/2, for N psi = pi/2 and beyond."""
    apart_ = strictly(assume(pi / 2 <= N * angle), assume(Ne(N * angle, pi / 2)))
    beyond = disj_cases(decided(N * angle, pi / 2), at, closed(above, apart_))
    return disj_cases(ordered(N * angle, pi / 2), below, beyond)

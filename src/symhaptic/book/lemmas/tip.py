"""The tip of the envelope, where N psi = pi/2, leaves all angles 0 < N psi < pi a margin."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, lowest_coefficients, not_zero, sine, size, width
from symhaptic.book.lemmas.envelope import (
    LOWER,
    TURN,
    UPPER,
    apart,
    border,
    divisor,
    divisors_at,
    line,
    rises,
    stiffness,
    turned,
)
from symhaptic.book.lemmas.prelude import *

HALF_PI = number(Relation(S.Zero, "<", pi / 2))
STIFFEST, ITS_DAMPING = tan(TURN), 2 / (N * sin(pi / N))
"""The tip of the envelope, where N psi = pi/2."""


@cache
def below_tip(side: int) -> Theorem:
    """U(psi) < tan(pi/(2N)) on either side of the tip."""
    tip = {psi: TURN} if side == LOWER else {phi: TURN, psi: psi}
    moved = inst(rises(side), {**tip, phi: psi} if side == LOWER else tip)
    found = positive(stiffness() < STIFFEST, [moved])
    return closed(found, *divisors_at_tip(), apart(), inside_tip(side))


@cache
def divisors_at_tip() -> list[Theorem]:
    """What the tip divides by is not zero, for N > 2, and where it lies."""
    angle = over(pi / N > 0, PI, size())
    rest = over(pi - pi / N > 0, positive(pi * (N - 1) > 0, [PI, N > 2], [PI]), size())
    double = closed(sign_of(sin, pi / N), angle, positive(pi / N < pi, [rest]))
    middle = number(Relation(pi / 2, "<", pi)), number(Relation(pi / 2, "<=", pi / 2))
    known = [double, level(), positive(N * sin(pi / N) > 0, [size(), double])]
    known += [size(), positive(2 * N > 0, [2, size()]), wave()]
    return [*middle, over(TURN > 0, HALF_PI, size()), *map(not_zero, known)]


def inside_tip(side: int) -> Theorem:
    """An angle on one side of the tip lies on that side of pi/(2N)."""
    if side == LOWER:
        return over(psi < TURN, positive(pi / 2 - N * psi > 0, N * psi < pi / 2), size())
    return over(psi > TURN, positive(N * psi - pi / 2 > 0, N * psi > pi / 2), size())


@cache
def tip_beside(side: int) -> Theorem:
    """0 < F of the tip at an angle on either side of it."""
    there = TURN - side * x
    moved = border(STIFFEST) + ITS_DAMPING
    top = positive(divisor() * (STIFFEST - stiffness()) > 0, [width(), below_tip(side)])
    squared = 2 * sin(psi) ** 2 * cos(N * psi) ** 2
    bottom = positive(squared > 0, [2, sine(), sine(), turned(side), turned(side)])
    slope = over(-derivative(moved, psi) > 0, top, bottom)
    divisors = [*divisors_at_tip(), *divisors_at(psi, side)]
    slope = closed(slope, not_zero(bottom), *divisors)
    inside = _beside_tip(side)
    curve = side * moved.xreplace({psi: there})
    slope = positive(derivative(curve, x) > 0, [inst(slope, {psi: there})])
    shown = [inst(t, {psi: there}) for t in divisors_at(psi, side)]
    # SymPy takes a sign out of sin(a - x), which may stand in a divisor with either
    shown += [positive(Ne(-t.conclusion.left, 0), [t]) for t in shown]  # type: ignore[attr-defined]
    shown = [closed(t, *inside, *divisors_at_tip()) for t in shown]
    slope = closed(slope, *shown, *inside, *divisors_at_tip())
    rising = increases(curve, x, S.Zero, TURN, slope, *shown)
    found = above_its_start(rising, tends(curve, x, S.Zero, S.Zero))
    found = closed(found, *lowest_coefficients(found, wave(), TURN), *divisors_at_tip())
    found = inst(found, {x: side * (TURN - psi)})
    found = positive(line(STIFFEST, ITS_DAMPING) > 0, [turned(side), found])
    ends = [
        positive(side * (TURN - psi) > 0, [inside_tip(side)]),
        positive(side * (TURN - psi) < TURN, psi > 0)
        if side == LOWER
        else over(psi - TURN < TURN, positive(pi - N * psi > 0, N * psi < pi), size()),
    ]
    return closed(found, *ends, *divisors, positive(Ne(-sin(psi), 0), [sine()]))


@cache
def wave() -> Theorem:
    """0 < sin(pi/(2N))."""
    low = over(TURN > 0, HALF_PI, size())
    high = over(pi > TURN, positive(pi * (N - HALF) > 0, [PI, N > 2], [3 * HALF, PI]), size())
    return closed(
        sign_of(sin, TURN), low, high, *map(not_zero, [size(), positive(2 * N > 0, [2, size()])])
    )


def _beside_tip(side: int) -> list[Theorem]:
    """What holds of the angle x before or after the tip, 0 < x < pi/(2N)."""
    there = TURN - side * x
    near = positive(N * x < pi / 2, [size(), assume(x < TURN)])
    if side == LOWER:
        return [
            positive(there > 0, x < TURN),
            positive(N * there < pi / 2, [size(), x > 0]),
            positive(N * there < pi, [size(), x > 0], [HALF, PI]),
        ]
    turn = over(TURN > 0, HALF_PI, size())
    return [
        positive(there > 0, [turn], x > 0),
        positive(N * there > pi / 2, [size(), x > 0]),
        positive(N * there < pi, [near]),
    ]


@cache
def tip() -> Theorem:
    """0 <= F of the tip, for 0 < N psi < pi."""
    goal = line(STIFFEST, ITS_DAMPING) >= 0
    low, high = (positive(goal, [tip_beside(side)]) for side in (LOWER, UPPER))
    there = closed(
        identity(line(STIFFEST, ITS_DAMPING, x).xreplace({x: TURN}), S.Zero),
        *divisors_at_tip(),
    )
    there = combined(line(STIFFEST, ITS_DAMPING, TURN) >= 0, [there, S.NegativeOne])
    return by_three(
        goal, low, closed(at_tip(goal, there), *divisors_at_tip(), not_zero(sine())), high
    )


def at_tip(goal: Any, there: Theorem) -> Theorem:
    """A relation at N psi = pi/2 from the one at psi = pi/(2N)."""
    equation = combined(Eq(TURN, psi), [assume(Eq(N * psi, pi / 2)), -1 / N])
    pattern = proposition(goal).at({psi: x})
    return closed(subst(pattern, x, there, equation), not_zero(size()), *divisors_at_tip())


def by_three(goal: Any, below: Theorem, at: Theorem, above: Theorem, angle: Expr = psi) -> Theorem:
    """A relation for N psi < pi/2, for N psi = pi/2 and beyond."""
    apart_ = strictly(assume(pi / 2 <= N * angle), assume(Ne(N * angle, pi / 2)))
    beyond = disj_cases(decided(N * angle, pi / 2), at, closed(above, apart_))
    return disj_cases(ordered(N * angle, pi / 2), below, beyond)


@cache
def level() -> Theorem:
    """0 < cos(pi/(2N))."""
    low = over(TURN > 0, HALF_PI, size())
    rest = positive(pi * (N - 1) / 2 > 0, [HALF, PI, N > 2], [HALF, PI])
    high = positive(pi / 2 > TURN, [over(pi / 2 - TURN > 0, rest, size())])
    return closed(sign_of(cos, TURN), positive(-pi / 2 < TURN, [low], [HALF, PI]), high)

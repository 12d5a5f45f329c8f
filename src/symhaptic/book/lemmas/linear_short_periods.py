"""For short periods the boundary tends to the line: the terms of second order in SI units."""

from symhaptic.book.lemmas.linear_far import quotient
from symhaptic.book.lemmas.linear_second_order import near_the_line
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.linear import LATE
from symhaptic.paper.propositions.linear_error import (
    CONSTANT,
    NEAR,
    SMALL,
    UNITS,
    left_of_line,
    on_boundary_at,
)


@cache
def tends_to_the_line(delay: int) -> Theorem:
    """The claim for a wall on the boundary, of one delay."""
    period, mass, soft = assume(T > 0), assume(m > 0), assume(y >= K * T)
    boundary = assume(on_boundary_at(delay).at(UNITS))
    pulled = conjunct(boundary, conjuncts(boundary.conclusion)[0])
    found = closed(inst(near_the_line(delay), UNITS), boundary, *_inside(mass, period, soft))
    above, below = (conjunct(found, c) for c in conjuncts(found.conclusion))
    unit = quotient(mass, period)
    share = quotient(period, mass)
    spring = combined((K + k) * T > 0, [unit, pulled])
    gap, stiff, damped = assume(y >= K * T), assume(k >= 0), assume(b >= 0)
    most, least = left_of_line(delay)
    shown = conj(
        combined(
            most, [unit, above], [CONSTANT, share, gap, gap], [2 * CONSTANT, share, gap, spring]
        ),
        combined(
            least,
            [unit, below],
            [CONSTANT, share, damped, gap],
            [CONSTANT, share, stiff, period, gap],
        ),
    )
    apart = [positive(Ne(s, 0), [s > 0]) for s in (m, T)]
    return closed(shown, *apart)


def _inside(mass: Theorem, period: Theorem, soft: Theorem) -> list[Theorem]:
    """The loop is near the origin, with an arm of (23)."""
    tops = {
        alpha: positive(SMALL * m - K * T**2 >= 0, [period, soft], y * T <= SMALL * m),
        beta: positive(NEAR * m - B * T >= 0, NEAR * m >= B * T),
        gamma: positive(STIFF * m - k * T**2 >= 0, k * T**2 <= STIFF * m),
        delta: positive(DAMPED * m - b * T >= 0, b * T <= DAMPED * m),
    }
    ends = {alpha: SMALL, beta: NEAR, gamma: STIFF, delta: DAMPED}
    found = [combined(UNITS[s] <= ends[s], [quotient(top, mass)]) for s, top in tops.items()]
    spring = over(UNITS[gamma] >= 0, positive(k * T**2 >= 0, [k >= 0, period, period]), mass)
    damper = over(UNITS[delta] >= 0, positive(b * T >= 0, [b >= 0, period]), mass)
    return [*found, spring, damper]


@cache
def all_tend() -> Theorem:
    """What the claim ``short_periods`` concludes, under its hypotheses."""
    found = (disch(tends_to_the_line(n), on_boundary_at(n).at(UNITS)) for n in LATE)
    return conj(*found)

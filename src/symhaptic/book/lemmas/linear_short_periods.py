"""For short periods the boundary tends to the line: the terms of second order in SI units."""

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
    boundary = assume(on_boundary_at(delay).at(UNITS))
    pulled = conjunct(boundary, conjuncts(boundary.conclusion)[0])
    small = y * T <= SMALL * m, NEAR * m >= B * T, k * T**2 <= STIFF * m, b * T <= DAMPED * m
    here = Given(T > 0, m > 0, y >= K * T, k >= 0, b >= 0, *small)
    found = here.closed(closed(inst(near_the_line(delay), UNITS), boundary))
    above, below = (conjunct(found, c) for c in conjuncts(found.conclusion))
    unit, share, gap = here.show(m / T > 0), here.show(T / m > 0), y >= K * T
    spring = combined((K + k) * T > 0, [unit, pulled])
    most, least = left_of_line(delay)
    more = [CONSTANT, share, gap, gap], [2 * CONSTANT, share, gap, spring]
    less = [CONSTANT, share, b >= 0, gap], [CONSTANT, share, k >= 0, T > 0, gap]
    shown = conj(positive(most, [unit, above], *more), positive(least, [unit, below], *less))
    return here.closed(shown)


@cache
def all_tend() -> Theorem:
    """What the claim ``short_periods`` concludes, under its hypotheses."""
    return conj(*(disch(tends_to_the_line(n), on_boundary_at(n).at(UNITS)) for n in LATE))

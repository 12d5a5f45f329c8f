"""Without delay the upper part of the boundary is b = KT/2 + B, for B >= 0 and K >= 0."""

from symhaptic.book.lemmas.extent import sine
from symhaptic.book.lemmas.linear_part import known
from symhaptic.book.lemmas.lower_boundary import border_needs, of_border
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import bordering, first_half, limits, pushes, sufficient
from symhaptic.paper.propositions.passivity import UPPER

NONE, STIFF, DAMPED, FULL = UPPER.parts
LEAST = K * T / 2 + B
"""The damping that these walls need."""


@cache
def enough() -> Theorem:
    """Without delay a wall with K >= 0 and B >= 0 is passive beside the damping KT/2 + B."""
    there = {b: LEAST, d: S.Zero}
    always = first_half().at(there)
    given, goal = always.body.of  # type: ignore[attr-defined]
    margin = combined(goal, [assume(DAMPED), inst(known()[2], {d: S.Zero})])
    margin = for_all([phi], given.of, Given(phi * 2 < pi, phi > 0).closed(margin, sine(phi)))
    found = Given(K >= 0, T > 0).closed(closed(inst(sufficient(), there), margin))
    pattern = PASSIVE.at({b: LEAST, d: x})
    return subst(pattern, x, found, show(Eq(S.Zero, d), NONE))


@cache
def on_it() -> Theorem:
    """Such a wall with b = KT/2 + B is on the boundary."""
    full = assume(FULL)
    passive = subst(PASSIVE.at({b: x}), x, enough(), show(Eq(LEAST, b), full))
    least = show(b <= x, inst(limits()[0], {b: x}), full)
    return bordering(passive, least)


@cache
def its_damping() -> Theorem:
    """A wall of the boundary with B >= 0 is one of them."""
    stiff = of_border(pushes())
    force = show(LEAST >= 0, stiff, T > 0, DAMPED)
    need = border_needs(LEAST, closed(enough(), stiff), force)
    full = both_ways(need, show(b >= LEAST, of_border(limits()[0])))
    return conj(assume(NONE), stiff, assume(DAMPED), full)

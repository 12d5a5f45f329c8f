"""Walls that no boundary separates from a stable wall are stable, for every plant and integer
delay."""

from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.plots import enclosed
from symhaptic.paper.propositions.stability import START, WAY


@cache
def enclosed_walls_are_stable() -> Theorem:
    """The claim ``enclosed``: on the way no zero crosses the circle, so that all stay inside."""
    given = taken_apart(enclosed())[1]
    _, begin, free = given
    loop = by_zeros(*LOOP)
    there: Any = loop.conclusion.parts[1].terms[0]
    here = there.subs(dict(zip((alpha, beta), START, strict=True)), simultaneous=True)
    first = inst(loop, dict(zip((alpha, beta), START, strict=True)))
    inside = mp(first, assume(begin))
    share, angle = WAY, theta
    way = [assume(share > 0), assume(share <= 1)]
    circle = [positive(angle >= 0, angle > 0), assume(angle <= pi)]
    crossing = at(assume(free), {share: share, angle: angle}, *way, *circle)
    ends = [number(Relation(S.Zero, "<=", S.Zero)), number(Relation(S.Zero, "<=", pi))]
    static = at(assume(free), {share: share, angle: S.Zero}, *way, *ends)
    found = roots_stay(here, there - here, z, share, angle, crossing, static, inside)
    return as_claimed(enclosed(), closed(mp(loop, found), *LATER_WHOLE))

"""The passive wall of maximum stiffness, (11), is stable with every spring, with every integer
delay."""

from symhaptic.book.lemmas.passive_is_stable import passive_is_stable
from symhaptic.book.lemmas.passivity import passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import bound, slope, stiffest_wall, waves
from symhaptic.book.lemmas.stiffness_claims import ELEVEN, Wall


def at_unit(*given: Any) -> Given:
    """What is known of (11) for the period 1 and a whole d."""
    return waves(whole(d), *map(proposition, given))


UNIT = {b: delta, T: S.One}


@cache
def passive_wall() -> Theorem:
    """The wall (11) is passive; 0 <= b, 0 < T, d whole."""
    walls = {line.lhs: line.rhs for line in ELEVEN}
    best = inst(stiffest_wall(*map(assume, ELEVEN)), walls)
    best = closed(best, *(identity(v, v) for v in walls.values()))
    return conjunct(best, best.conclusion.parts[0])


@cache
def is_passive() -> Theorem:
    """The wall (11) for b = delta and T = 1 is passive; 0 <= delta, d whole."""
    return at_unit().closed(inst(passive_wall(), UNIT))


@cache
def passive_tip() -> tuple[Theorem, Wall]:
    """That wall is stable; 0 <= gamma, 0 < delta, d whole.  And its stiffness and damping."""
    best, unit = passive_wall(), UNIT
    passive: Any = best.conclusion
    angles = inst(passive_by_angle(), dict(zip((K, B), passive.of[:2], strict=True)))
    always = inst(mp(angles, best), unit)
    _, every = conjuncts(always.conclusion)
    stiffness, damping = (v.xreplace(unit) for v in passive.of[:2])
    here = at_unit(delta > 0, gamma >= 0)
    stiff = here.show(stiffness > 0, inst(slope(), UNIT))
    loop = inst(conjunct(passive_is_stable(), STABLE), {alpha: stiffness, beta: damping})
    return here.closed(closed(loop, conjunct(always, every)), stiff), (stiffness, damping)


@cache
def softer_than_the_tip() -> Theorem:
    """alpha <= (11) of a passive wall; 0 <= delta, d whole."""
    found = inst(bound(), {K: alpha, B: beta, b: delta, T: S.One})
    return at_unit().closed(show(alpha <= passive_tip()[1][0], found))

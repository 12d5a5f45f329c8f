"""The stiffest passive wall, (11), is stable with every spring, behind every whole delay."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.passive_is_stable import passive_is_stable
from symhaptic.book.lemmas.passivity import passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import bound, divisors, slope, stiffest_wall, waves
from symhaptic.book.lemmas.stiffness_claims import ELEVEN, Wall
from symhaptic.notation import b
from symhaptic.paper.propositions.comparison import STABLE


@cache
def known() -> tuple[Theorem, ...]:
    """What (11) and its bound divide by is not zero, and the period is 1; d is not negative."""
    wave = waves()["double"]
    turns = {t for line in ELEVEN for t in line.rhs.atoms(sin, cos) if _divides(line.rhs, t)}
    more = positive(d + 1 > 0, d >= 0, [1])
    apart = [positive(Ne(turn, 0), [wave]) for turn in turns]
    unit = fact(Relation(S.One, "!=", S.Zero))
    late = not_negative(assume(whole(d)))
    four = not_zero(positive(4 * d + 4 > 0, [4, more]))
    return (*apart, *divisors(), four, one(), unit, late)


def _divides(expr: Expr, turn: Expr) -> bool:
    """Whether an expression has this factor in its denominator."""
    return bool(expr.as_numer_denom()[1].has(turn))


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
    return closed(inst(passive_wall(), UNIT), *known())


@cache
def passive_tip() -> tuple[Theorem, Wall]:
    """That wall is stable; 0 <= gamma, 0 < delta, d whole.  And its stiffness and damping."""
    best, unit = passive_wall(), UNIT
    passive: Any = best.conclusion
    angles = inst(passive_by_angle(), dict(zip((K, B), passive.of[:2], strict=True)))
    always = inst(mp(angles, best), unit)
    _, every = conjuncts(always.conclusion)
    stiffness, damping = (v.xreplace(unit) for v in passive.of[:2])
    stiff = positive(stiffness > 0, [inst(slope(), unit), delta > 0])
    loop = inst(conjunct(passive_is_stable(), STABLE), {alpha: stiffness, beta: damping})
    pushes = positive(stiffness + gamma > 0, [stiff], gamma >= 0)
    damped = positive(delta >= 0, delta > 0)
    found = closed(loop, conjunct(always, every), pushes, *known(), damped)
    return closed(found, *known(), damped), (stiffness, damping)


@cache
def softer_than_the_tip() -> Theorem:
    """alpha <= (11) of a passive wall; 0 <= delta, d whole."""
    found = inst(bound(), {K: alpha, B: beta, b: delta, T: S.One})
    wanted = alpha <= passive_tip()[1][0]
    return closed(positive(wanted, [found]), *known())

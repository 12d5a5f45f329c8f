"""How many times as stiff, and as damped, stable walls can be as passive ones, in numbers."""

from symhaptic.book.lemmas.near_tip import FINE, none_above, wall_below
from symhaptic.book.lemmas.passive_tip import at_unit, is_passive, passive_tip, softer_than_the_tip
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import LIMIT, SPRUNG, least
from symhaptic.book.lemmas.region import limits, pushes
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffness_claims import beside, from_bound
from symhaptic.paper.propositions import far_higher
from symhaptic.paper.propositions.far_higher import (
    LEFT,
    RATIOS,
    SIZES,
    UNIT,
    between,
    stiffer_than_passive,
)
from symhaptic.paper.propositions.ratio import BEST, RATE, WALL, outdoes, passive, stable


@cache
def at_least() -> Theorem:
    """With every integer delay some stable wall is as stiff as all passive ones: that of (11)."""
    some = taken_apart(stiffer_than_passive())[2]
    stable, tip = passive_tip()
    found = at_unit().closed(beside(some, stable, tip, lambda wanted: softer_than_the_tip()))
    return as_claimed(stiffer_than_passive(), found)


@cache
def beside_the_tip() -> Theorem:
    """alpha < rho x for all stable walls, of the passive wall x of (11), where L <= rho x and all
    stable walls have alpha < L."""
    claim = outdoes(passive(d, BEST), stable(d), alpha < RATE * x)
    _, tip = passive_tip()
    bounded = assume(every(WALL, [stable(d)], alpha < LIMIT))
    softer = at(bounded, {s: s for s in WALL}, assume(stable(d)))
    room = assume(RATE * tip[0] >= LIMIT)
    found = beside(claim, is_passive(), tip, lambda wanted: positive(wanted, [softer], [room]))
    return at_unit().closed(found)


@cache
def in_numbers(spring: Expr, delay: int) -> Theorem:
    """The ratio of one arm and delay, between two decimals."""
    arm = spring, DAMPED
    more, less = between(spring, delay).of  # type: ignore[attr-defined]
    low = Rational(RATIOS[spring][delay])
    wall, held = wall_below(arm, delay, FINE)
    limit, softer = none_above(arm, delay, FINE)
    here = {d: S(delay), RATE: low + UNIT, LIMIT: limit, gamma: spring, delta: DAMPED}
    under = inst(beside_the_tip(), here)
    stable_ = stable(delay).at({gamma: spring, delta: DAMPED})
    rest = [fact(p) for p in under.hypotheses if isinstance(p, (Relation, Predicate))]
    under = closed(under, for_all(WALL, [stable_], softer), *rest)
    assert under.conclusion == less
    return conj(beside(more, held, wall, from_bound(least(delay))), under)


@cache
def by_how_much() -> Theorem:
    """All of it."""
    return conj(at_least(), *(in_numbers(g, n) for g, rows in RATIOS.items() for n in rows))


@cache
def more_damped(delay: int) -> Theorem:
    """For the arm of Fig. 11 some stable wall is many times as damped as all passive ones."""
    claim = CLAIMED["s5a-much-smaller"](()).of[2 * list(SIZES).index(delay) + 1]  # type: ignore[attr-defined]
    times = SIZES[delay]
    damping = times * DAMPED * Rational(1003, 1000)
    wall = Rational(1, 10**4), damping
    point: dict[Any, Expr] = {alpha: wall[0], beta: wall[1], gamma: STIFF, delta: DAMPED}
    here = {K: alpha, B: beta, b: DAMPED, T: S.One, d: S(delay)}
    high, low = (numbers_known(inst(t, here)) for t in (limits()[0], pushes()))
    rest = damping - times * DAMPED
    return beside(
        claim,
        stable_at({**point, d: S(delay)}),
        wall,
        lambda wanted: combined(wanted, [times, high], [times * S.Half, low], [rest]),
    )


@cache
def dimensions() -> Theorem:
    """Stiffness and damping, for five delays."""
    parts = []
    for delay in SIZES:
        parts += [in_numbers(SPRUNG[0], delay), more_damped(delay)]
    return conj(*parts)


@cache
def left_by_one_period() -> Theorem:
    """What one period of delay leaves of the stable stiffness, of two arms."""
    claims = iter(far_higher.left_by_one_period().of)  # type: ignore[attr-defined]
    parts = []
    for arm in LEFT:
        walls = {n: wall_below(arm, n, FINE) for n in (0, 1)}
        bounds = {n: none_above(arm, n, FINE) for n in (0, 1)}
        for late, other in ((1, 0), (0, 1)):
            (wall, held), (_, softer) = walls[late], bounds[other]
            parts.append(beside(next(claims), held, wall, from_bound(softer)))
    return conj(*parts)

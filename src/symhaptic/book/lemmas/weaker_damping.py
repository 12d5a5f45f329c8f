"""How the ratio of passive to stable stiffness changes with the damper, for one spring.

Without delay and with one period of delay two linear functions of the damping enclose the largest
stable stiffness on all of (23), near enough for dampings that are two percent apart.
"""

import itertools

from symhaptic.book.lemmas.marginal import LIMIT, NEAR, behind
from symhaptic.book.lemmas.near_tip import Arm, none_above, rounded, wall_below
from symhaptic.book.lemmas.one_plane import right_of_the_line
from symhaptic.book.lemmas.passive_tip import at_unit, is_passive, passive_tip
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import FREE, least, passive_wall
from symhaptic.book.lemmas.ratio_peak import LIMIT as MOST
from symhaptic.book.lemmas.stiffest_stable import no_stiffer, stable_wall
from symhaptic.book.lemmas.stiffness_claims import (
    ELEVEN,
    LATE,
    UNDELAYED,
    beside,
    from_bound,
    passive_walls,
)
from symhaptic.paper.propositions import ratio
from symhaptic.paper.propositions.ratio import BEST, RATE, SPRINGS, WALL, stable
from symhaptic.paper.propositions.stability import HEAVIER

APART = Rational(102, 100)
"""One damping is at least so many times the other."""

HIGH = {0: LIMIT, 1: Rational("0.1447") + Rational("0.56") * delta}
NEAR_TIP = {0: NEAR, 1: Rational("0.424")}
WALLS = {0: UNDELAYED, 1: LATE}
SHORT = Or(
    tuple(And((proposition(Eq(d, late)), proposition(APART * delta <= HEAVIER))) for late in (0, 1))
)
"""No delay, or one of a period, and dampings that are two percent apart."""


def _bound(delay: int) -> Theorem:
    """alpha < HIGH of every stable wall."""
    return no_stiffer(delay, (HIGH[delay], NEAR_TIP[delay]), RANGES)


def _of_delay(claim: Any, delay: int) -> Theorem:
    """eta(delta) < rho < eta(delta') for one delay, with rho between two quotients."""
    place = {delta: HEAVIER}
    wall, high = WALLS[delay], HIGH[delay].subs(place)
    low, damper = wall[0], assume(delta > 0)
    passive, least_, best = passive_walls(delay, ELEVEN)
    share = best[0].subs(delta, 1)
    heavier = positive(HEAVIER > 0, [damper], delta < HEAVIER)
    ends = _positive(low, delta, damper), _positive(high, HEAVIER, heavier)
    gap = _gap(low, high, damper, heavier)
    half = share / 2
    weight = number(Relation(S.Zero, "<", half))
    more = [over(gap.conclusion.right / end.conclusion.right > 0, gap, end) for end in ends]  # type: ignore[attr-defined]
    rate = half * (delta / low + HEAVIER / high)
    parts = over(delta / low > 0, damper, ends[0]), over(HEAVIER / high > 0, heavier, ends[1])
    positive_ = positive(rate > 0, *([weight, p] for p in parts))
    bounded = inst(_bound(delay), place)
    some = claim.at({d: S(delay)})
    under, above = some.body.at({RATE: rate}).of
    stable = stable_wall(delay, wall, RANGES)
    there = passive_at(passive, place)

    found = conj(
        beside(under, stable, wall, lambda w: positive(w, [least_], [weight, more[1]])),
        beside(
            above,
            there,
            tuple(v.subs(place) for v in best),
            lambda w: positive(w, [positive_, bounded], [weight, more[0]]),
        ),
    )
    found = exists(found, some, {RATE: rate})
    apart = [not_zero(end) for end in ends]
    known = [positive(HEAVIER >= 0, [heavier]), positive(delta >= 0, [damper])]
    low_ = [positive(delta <= DAMPED, delta < HEAVIER, HEAVIER <= DAMPED)]
    return behind(delay, claim, closed(found, *apart, *known, *low_, *apart))


def _positive(line: Expr, symbol: Symbol, above: Theorem) -> Theorem:
    """0 < a + b x for 0 < x."""
    start = number(Relation(S.Zero, "<", line.subs(symbol, 0)))
    return positive(line > 0, [start], [line.coeff(symbol), above])


def passive_at(passive: Theorem, values: Any) -> Theorem:
    """The passive wall of maximum stiffness beside another damper."""
    return numbers_known(inst(passive, values))


def _gap(low: Expr, high: Expr, damper: Theorem, heavier: Theorem) -> Theorem:
    """0 < delta' low(delta) - delta high(delta'), of dampings that are two percent apart."""
    start, end = low.subs(delta, 0), high.subs(HEAVIER, 0)
    bend = low.coeff(delta) - high.coeff(HEAVIER)
    return positive(
        HEAVIER * low - delta * high > 0,
        [start, assume(APART * delta <= HEAVIER)],
        [APART * start - end, damper],
        [bend, damper, heavier],
    )


@cache
def further() -> Theorem:
    """What is claimed of two dampings, under SHORT."""
    claim = taken_apart(CLAIMED["s5a-smaller-delta"](()))[2]
    return disj_cases(assume(SHORT), *(_of_delay(claim, n) for n in (0, 1)))


FAR = {gamma: S.Zero, delta: Rational(1, 100), HEAVIER: DAMPED, d: S(200)}
"""Two dampings behind a long delay."""
OTHER = symbols("x_1 y_1")


def nearer(some: Any) -> Theorem:
    """Not so behind this delay: with less damping passive walls have the larger share."""
    late = int(FAR[d])
    limit, bounded = none_above((FAR[gamma], FAR[delta]), late)
    (stiffness, damping), held = wall_below(FREE, late)
    passive, wall = passive_wall(late, FAR[delta])
    under, above = (assume(p) for p in some.body.of)
    best, others = (assume(p) for p in under.conclusion.body.of)  # type: ignore[attr-defined]
    other: Any = Exists(OTHER, above.conclusion.body.at(dict(zip(BEST, OTHER, strict=True))))  # type: ignore[attr-defined]
    above = conjunct(above, other)
    tip, rest = (assume(p) for p in other.body.of)
    here = dict(zip(WALL, BEST, strict=True))
    softer = at(others, dict(zip(WALL, wall, strict=True)), passive)
    line = inst(right_of_the_line(), {**here, **FAR})
    line = closed(line, *(fact(p) for p in line.hypotheses if not p.free), best)
    pushes = positive(x > 0, [line])
    number_ = number(Relation(S.Zero, "<", wall[0]))
    rate = over(RATE > 0, positive(RATE * x > 0, [softer], [number_]), pushes)
    rate = closed(rate, not_zero(pushes))
    under_limit = closed(inst(bounded, here), best)
    most = closed(inst(least(late), dict(zip(WALL, OTHER, strict=True))), tip)
    over_wall = at(rest, {alpha: stiffness, beta: damping}, held)
    top = most.conclusion.right  # type: ignore[attr-defined]
    sum_ = limit * top - stiffness * wall[0]
    found = positive(
        Relation(S.Zero, "<", sum_),
        [stiffness, softer],
        [stiffness, rate, under_limit],
        [limit, over_wall],
        [limit, most],
    )
    wrong = not_intro(found, number(Relation(sum_, "<=", S.Zero)))
    wrong = choose(under, choose(above, wrong))
    return reductio(choose(assume(some), wrong), some)


@cache
def not_short() -> Theorem:
    """Nor is it a short delay."""
    claim: Any = SHORT.at(FAR)
    return none_of(claim, *(not_all(p, number(negated(p.of[0]))) for p in claim.of))


# -- longer delays, in numbers ---------------------------------------------------------------------

DELAYS, DAMPERS = (2, 4, 8), tuple(Rational(n, 200) for n in (1, 2, 3, 4))
"""The other integer delays of Fig. 11, and dampers up to 0.02."""


def steps() -> Proposition:
    """eta(delta) < eta(delta') for neighbouring dampers, at both ends of the range of gamma."""
    parts = []
    for spring in SPRINGS:
        for delay in DELAYS:
            for damper, heavier in itertools.pairwise(DAMPERS):
                under = ratio.below(RATE, delay).at({delta: damper})
                over_ = ratio.above(RATE, delay).at({delta: heavier})
                parts.append(Exists((RATE,), both([under, over_])).at({gamma: spring}))
    return both(parts)


@cache
def above_the_rate() -> Theorem:
    """eta(d) > rho of the passive wall (11), where rho L is less than it and no stable wall has
    alpha >= L."""
    claim = ratio.above(RATE, d)
    _, best = passive_tip()
    bounded, rate = assume(every(WALL, [stable(d)], alpha < MOST)), assume(RATE > 0)
    softer = at(bounded, {s: s for s in WALL}, assume(stable(d)))
    room = assume(best[0] > RATE * MOST)
    found = beside(claim, is_passive(), best, lambda w: positive(w, [rate, softer], [room]))
    return at_unit().closed(found)


@cache
def step_by_step() -> Theorem:
    """:func:`steps`."""
    found = []
    claims = iter(steps().of)  # type: ignore[attr-defined]
    for spring in SPRINGS:
        for delay in DELAYS:
            for damper, heavier in itertools.pairwise(DAMPERS):
                found.append(_step(next(claims), (spring, damper), (spring, heavier), delay))
    return conj(*found)


def _step(some: Any, arm: Arm, other: Arm, delay: int) -> Theorem:
    """Of two dampers."""
    wall, held = wall_below(arm, delay)
    limit, bounded = none_above(other, delay)
    most = least(delay, arm[1])
    low: Any = most.conclusion.right / wall[0]  # type: ignore[attr-defined]
    high: Any = least(delay, other[1]).conclusion.right / limit  # type: ignore[attr-defined]
    share = rounded(float(low + high) / 2)
    under, _ = some.body.at({RATE: share}).of
    first = beside(under, held, wall, from_bound(most))
    here = {d: S(delay), RATE: share, MOST: limit, gamma: other[0], delta: other[1]}
    second = inst(above_the_rate(), here)
    rest = [fact(p) for p in second.hypotheses if isinstance(p, (Relation, Predicate))]
    stable_ = stable(delay).at({gamma: other[0], delta: other[1]})
    second = closed(second, for_all(WALL, [stable_], bounded), *rest)
    return exists(conj(first, second), some, {RATE: share})

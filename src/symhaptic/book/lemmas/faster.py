"""What faster sampling gains at the same delay: little at ten periods, much at one."""

from symhaptic.book.lemmas.counted_delays import counted
from symhaptic.book.lemmas.figure9 import valued
from symhaptic.book.lemmas.near_tip import Arm, none_above, wall_below
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import least
from symhaptic.book.lemmas.stiffness_claims import ELEVEN, beside, from_bound, passive_walls
from symhaptic.paper.propositions.conclusion import FASTER, LITTLE
from symhaptic.paper.propositions.ratio import BEST, WALL

LATE, TIMES = 10, 10
"""So many periods of delay, and at most so many times as fast."""
ARMS: tuple[Arm, ...] = ((S.Zero, S.Zero), (STIFF, DAMPED))
"""A free mass, and the arm of Figs. 11 and 12."""
DEVICES = Or(tuple(And((proposition(Eq(gamma, g)), proposition(Eq(delta, v)))) for g, v in ARMS))
SLOW = Or((And((DEVICES, proposition(Eq(d, LATE)), proposition(FASTER <= TIMES))),))
"""One of two devices, ten periods of delay, and at most ten times as fast sampling."""


@cache
def gained() -> Theorem:
    """What is claimed of faster sampling, under SLOW."""
    *_, claim = taken_apart(CLAIMED["s6-faster-sampling"](()))
    here = {d: S(LATE)}
    cases = []
    for spring, damper in ARMS:
        sprung = claim.at({**here, gamma: spring})
        known = {**here, gamma: spring, delta: damper}
        found = valued(sprung, delta, damper, _each_rate(claim, known))
        cases.append(valued(claim.at(here), gamma, spring, found))
    found = valued(claim, d, S(LATE), disj_cases(assume(DEVICES), *cases))
    apart = positive(Ne(FASTER, 0), FASTER >= 1, [S.One])
    return disj_cases(assume(SLOW), closed(found, apart))


def _each_rate(claim: Any, known: dict[Any, Expr]) -> Theorem:
    """For one device, q = 1, 2, ... 10."""
    then = claim.at(known)
    cover = inst(counted(TIMES + 1), {d: FASTER})
    none, *rates, more = cover.conclusion.of  # type: ignore[attr-defined]
    low = not_intro(assume(none), positive(FASTER > 0, FASTER >= 1, [S.One]))
    high = not_intro(assume(more), positive(FASTER < TIMES + 1, FASTER <= TIMES, [S.One]))
    shown = (valued(then, FASTER, p.right, _at({**known, FASTER: p.right}, claim)) for p in rates)
    return disj_cases(cover, contr(low, then), *shown, contr(high, then))


def _at(point: dict[Any, Expr], claim: Any) -> Theorem:
    """For one device and rate, by numbers."""
    passive_, stable_ = claim.at(point).of
    times, damper, late = point[FASTER], point[delta], int(point[d])
    later: Arm = (point[gamma] / times**2, damper / times)
    best, _, wall = passive_walls(late, ELEVEN)
    best = inst(best, {delta: damper})
    best = numbers_known(best)
    values: Any = tuple(v.xreplace({delta: damper}) for v in wall)
    softest = least(late * int(times), later[1])
    held, stable = wall_below((point[gamma], damper), late)
    _, bounded = none_above(later, late * int(times))
    return conj(
        beside(passive_, best, values, from_bound(softest)),
        beside(stable_, stable, held, from_bound(bounded)),
    )


SOON = {gamma: S.Zero, delta: S.Zero, d: S.One, FASTER: S(100)}
"""A free mass with one period of delay, and sampled a hundred times as fast."""


def much(then: Any) -> Theorem:
    """There it is not so of the stable walls."""
    _, stable_ = then.of
    arm: Arm = (S.Zero, S.Zero)
    limit, bounded = none_above(arm, 1)
    (stiffness, damping), held = wall_below(arm, 100)
    best, others = (assume(p) for p in stable_.body.of)
    softer = closed(inst(bounded, dict(zip(WALL, BEST, strict=True))), best)
    more = at(others, {alpha: stiffness, beta: damping}, held)
    under = positive(Relation(10**4 * stiffness, "<", LITTLE * limit), [more], [LITTLE, softer])
    wrong = not_intro(under, number(Relation(LITTLE * limit, "<=", 10**4 * stiffness)))
    return not_all(then, reductio(choose(assume(stable_), wrong), stable_))


@cache
def not_slow() -> Theorem:
    """Nor is the delay one of ten periods."""
    claim: Any = SLOW.at(SOON)
    late = Relation(S.One, "=", S(LATE))
    return none_of(claim, *(not_all(p, number(negated(late))) for p in claim.of))


def slow(point: Any) -> Theorem:
    """SLOW at a point of the first device."""
    devices, *rest = SLOW.of[0].at(point).of  # type: ignore[attr-defined]
    device = conj(*map(number, devices.of[0].of))
    return disj(conj(disj(device, devices), *map(number, rest)), SLOW.at(point))


@cache
def farthest() -> Theorem:
    """How stiff a free mass can be behind the longest of these delays."""
    return none_above(ARMS[0], LATE * TIMES)[1]

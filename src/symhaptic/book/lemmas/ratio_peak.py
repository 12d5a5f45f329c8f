"""How near the largest passive stiffness comes to the largest stable one, with every integer
delay.

For the arm of Figs. 11 and 12.  Each delay has a stable wall next to the tip of its region; all
long ones have the wall (0.00059, 0).
"""

from symhaptic.book.lemmas.counted_delays import each_delay
from symhaptic.book.lemmas.marginal import behind
from symhaptic.book.lemmas.near_tip import Arm, none_above, wall_below
from symhaptic.book.lemmas.outweighed import LATE, stable_behind_every_delay
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import limits, pushes
from symhaptic.book.lemmas.stiffest_passive import bound, stiffest_wall
from symhaptic.book.lemmas.stiffness_claims import ELEVEN, beside, from_bound, passive_walls
from symhaptic.paper.propositions import ratio
from symhaptic.paper.propositions.passivity import PASSIVE
from symhaptic.paper.propositions.ratio import BEST, END, RATE, WALL, stable

PEAK, SHARE = 40, Rational(9998, 10**4)
"""The delay at which eta is largest, and a number between that and all others."""
LIMIT = Symbol("L")
LONG, FAR = 53, 68
"""From the one on the wall (0.00059, 0) is taken, and from the other for all delays at once."""

SPRUNG: Arm = (STIFF, DAMPED)
FREE: Arm = (S.Zero, DAMPED)


def at_arm(claim: Proposition, arm: Arm) -> Proposition:
    """A claim for one gamma and delta."""
    return claim.at(dict(zip((gamma, delta), arm, strict=True)))


def below(share: Expr, delay: Any = d, arm: Arm = SPRUNG) -> Any:
    """eta(d) < share, for one arm."""
    return at_arm(ratio.below(share, delay), arm)


def above(share: Expr, delay: Any, arm: Arm = SPRUNG) -> Any:
    """eta(d) > share, for one arm."""
    return at_arm(ratio.above(share, delay), arm)


@cache
def least(delay: int, damper: Expr = DAMPED) -> Theorem:
    """alpha <= 2 delta tan(pi/(4 (d+1))) of a passive wall."""
    return numbers_known(inst(bound(), {K: alpha, B: beta, b: damper, T: S.One, d: S(delay)}))


def of_delay(claim: Any, delay: int, arm: Arm = SPRUNG) -> Theorem:
    """One delay's :func:`below`, of a wall next to the tip or of the one for long delays."""
    if arm == SPRUNG and delay >= LONG:
        wall: tuple[Expr, Expr] = (LATE, S.Zero)
        held = closed(inst(stable_behind_every_delay(), {d: S(delay)}), fact(whole(S(delay))))
    else:
        wall, held = wall_below(arm, delay)
    return beside(claim, held, wall, from_bound(least(delay, arm[1])))


def late(claim: Any) -> Theorem:
    """The same for all delays from FAR on: a passive wall has alpha (d+1) <= 2 delta."""
    high, low = (inst(t, {K: alpha, B: beta, b: DAMPED, T: S.One}) for t in limits())
    known = [
        positive(d >= 0, d >= FAR, [FAR]),
        *(fact(p) for t in (high, low) for p in t.hypotheses if not p.free),
    ]
    high, low = (closed(t, *known) for t in (high, low))

    def softer(wanted: Any) -> Theorem:
        gap = wanted.right - wanted.left
        room = wanted.right * (FAR + 1) - 2 * DAMPED
        many = positive(d + 1 > 0, d >= FAR, [FAR + 1])
        products = [high], [low], [wanted.right, d >= FAR], [room]
        return positive(wanted, [by_multiple(gap > 0, many, *products)])

    return beside(claim, stable_behind_every_delay(), (LATE, S.Zero), softer)


@cache
def elsewhere() -> Theorem:
    """eta < SHARE with every integer delay but PEAK."""
    other, claim = proposition(Ne(d, PEAK)), below(SHARE)

    def build(delay: int) -> Theorem:
        here = {d: S(delay)}
        if delay != PEAK:
            return disch(add_assum(of_delay(claim.at(here), delay), other.at(here)), other.at(here))
        none = not_intro(assume(other.at(here)), number(Relation(S(PEAK), "=", S(PEAK))))
        return disch(contr(none, claim.at(here)), other.at(here))

    far = disch(add_assum(late(claim), other), other)
    found = each_delay(Implies((other, claim)), FAR, build, far)
    given = [whole(d), other]
    return for_all([d], given, undisch(found))


@cache
def by_limit() -> Theorem:
    """eta(d) > rho > 0 where rho L is less than (11), and L more than every stable stiffness."""
    walls = {line.lhs: line.rhs for line in ELEVEN}
    unit = {b: DAMPED, T: S.One}
    found = inst(stiffest_wall(*map(assume, ELEVEN)), walls)
    found = closed(found, *(identity(v, v) for v in walls.values()))
    values = tuple(walls[s].subs(unit) for s in (K, B))
    passive_ = conjunct(inst(found, unit), PASSIVE.at({K: values[0], B: values[1], **unit}))
    stable_ = stable(d).at({delta: DAMPED})
    bounded, rate = assume(every(WALL, [stable_], alpha < LIMIT)), assume(RATE > 0)
    softer = at(bounded, {s: s for s in WALL}, assume(stable_))
    rest = assume(values[0] > RATE * LIMIT)
    return beside(
        ratio.above(RATE, d).at({delta: DAMPED}),
        passive_,
        values,
        lambda wanted: positive(wanted, [rate, softer], [rest]),
    )


def at_peak(delay: int, share: Expr, arm: Arm) -> Theorem:
    """eta(d) > share, of the passive wall of maximum stiffness and a bound next to the tip."""
    limit, bounded = none_above(arm, delay)
    here = {d: S(delay), RATE: share, LIMIT: limit, gamma: arm[0]}
    found = inst(by_limit(), here)
    stable_ = at_arm(stable(delay), arm)
    return closed(
        found,
        for_all(WALL, [stable_], bounded),
        *(fact(p) for p in found.hypotheses if isinstance(p, (Relation, Predicate))),
    )


@cache
def passive_wall(delay: int, damper: Expr = DAMPED) -> tuple[Theorem, tuple[Expr, Expr]]:
    """The passive wall of maximum stiffness, of the figures or beside another damper."""
    found, _, wall = passive_walls(delay, ELEVEN)
    found = inst(found, {delta: damper})
    values: Any = tuple(v.subs(delta, damper) for v in wall)
    return numbers_known(found), values


RATIOS = Rational(9999, 10**4), Rational(91, 100)
"""Without a spring eta is more than the one at d = 122, and less than the other at d = 1000."""


def instead() -> Any:
    """What holds of the arms of Fig. 12 instead."""
    apart = ForAll((d,), implied([whole(d), Ne(d, PEAK)], below(SHARE)))
    peak = above(SHARE, S(PEAK)), below(S.One, S(PEAK))
    free = above(RATIOS[0], S(122), FREE), below(RATIOS[1], S(1000), FREE)
    return both([apart, *peak, *free])


@cache
def near_one() -> Theorem:
    """:func:`instead`."""
    _, _, under, _, fallen = instead().of
    return conj(
        elsewhere(),
        at_peak(PEAK, SHARE, SPRUNG),
        of_delay(under, PEAK),
        at_peak(122, RATIOS[0], FREE),
        of_delay(fallen, 1000, FREE),
    )


def never_met(some: Any) -> Theorem:
    """Behind no integer delay D is a passive wall as stiff as all stable ones."""
    late, same, _ = (assume(p) for p in some.body.of)
    other = symbols("x_1 y_1")
    met: Any = same.conclusion
    met = conjunct(same, Exists(other, met.body.at(dict(zip(BEST, other, strict=True)))))
    best, rest = (assume(p) for p in met.conclusion.body.of)
    unit = {K: other[0], B: other[1], b: DAMPED, T: S.One, d: END}
    least_ = inst(pushes(), unit)
    least_ = numbers_known(least_)

    def contrary(share: Expr) -> Theorem:
        claim = below(share).at({d: END})
        held, others = (assume(p) for p in claim.body.of)
        softer = at(others, dict(zip(WALL, other, strict=True)), best)
        far = positive(x > 0, [1 / share, softer], [1 / share, least_])
        more = [[1 - share, far]] if share < 1 else []
        equal = at(rest, dict(zip(WALL, BEST, strict=True)), held)
        wrong = not_intro(positive(other[0] < x, [softer], *more), equal)
        return choose(met, choose(assume(claim), wrong))

    _, _, under, *_ = instead().of
    elsewhere_ = at(elsewhere(), {d: END}, conj(late, assume(proposition(Ne(END, PEAK)))))
    of_peak = behind(PEAK, below(S.One), of_delay(under, PEAK))
    cases = (closed(contrary(S.One), inst(of_peak, {d: END})), closed(contrary(SHARE), elsewhere_))
    false = disj_cases(decided(END, S(PEAK)), *cases)
    return reductio(choose(assume(some), false), some)

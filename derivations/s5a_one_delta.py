r"""Can one damping describe a device with an arm, for passivity and for stability?

By (2) the damping of the loop is the sum of the dampings of device and arm. By (3) only the
damping of the device counts for passivity. Figs. 11 to 13 and the ratio $\eta$ use the same
$\delta$ for passivity and stability.
"""

from symhaptic.book.lemmas.near_tip import CLOSE, none_above, wall_below
from symhaptic.book.lemmas.passive_is_stable import passive_is_stable
from symhaptic.book.lemmas.passive_tip import at_unit, passive_tip
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.rates import moved
from symhaptic.book.lemmas.ratio_peak import least, passive_wall
from symhaptic.book.lemmas.stiffest_passive import bound
from symhaptic.book.lemmas.stiffest_stable import stable_wall
from symhaptic.book.lemmas.stiffness_claims import LATE, UNDELAYED, beside, from_bound, linear
from symhaptic.book.lemmas.walls import damped, divisors, margins
from symhaptic.paper.propositions.comparison import passive
from symhaptic.paper.propositions.one_delta import (
    ARM,
    DEVICE,
    FIGURES,
    LIMITS,
    MASS,
    MEETS,
    OWN,
    SPRING,
    UNITS,
    WHOLE,
    drawn,
    instead,
    kept,
    outdone,
    oversized,
    ratios,
    still_true,
)
from symhaptic.paper.propositions.ratio import BEST


def derive(page):
    page.say(
        "Let a device with the mass $m_D$ and the damping $b_D$ be held by an arm with the mass "
        "$m_H$, the damping $b_H$ and the stiffness $k_H$. The total mass of (2) normalises the "
        r"wall: $\alpha=KT^2/(m_D+m_H)$ and $\beta=BT/(m_D+m_H)$. In these units the damping of "
        r"the loop is $\delta$, and that of the device is $\delta_D$:"
    )
    page.define(
        r"The parameter $\delta$ is the damping of device and arm",
        delta,
        T * (b_D + b_H) / (m_D + m_H),
    )
    page.define(
        r"The parameter $\delta_D$ is the damping of the device", r"\delta_D", T * b_D / (m_D + m_H)
    )
    page.lemma(
        "The wall meets (5) with the damping $b_D$ of (3) if and only if it meets (5) in the "
        "normalised plane with $\\delta_D$",
        right(),
        because=r"condition (5) is linear in $K$, $B$ and $b$, and $\omega T$ is the normalised "
        "angle",
    )
    page.say(
        r"So the passive walls of a device with an arm are those that (5) gives for $\delta_D$. "
        r"The region that (5) gives for $\delta$ is $1+b_H/b_D$ times as large in each "
        "direction. A passive wall is still stable, and some stable walls are at least this "
        "factor stiffer than every passive wall."
    )
    page.lemma(
        "A wall with $K>0$ that meets (5) with the damping of the device is stable with every arm",
        stays_stable(),
        because="a wall that meets (5) with the damping of the device also satisfies (5) with "
        "the larger damping of device and arm together. Every wall that satisfies this "
        "condition is stable with every spring",
    )
    page.lemma(
        "With every arm some stable wall is at least $1+b_H/b_D$ times as stiff as all passive "
        "walls",
        outdone_by_the_arm(),
        because="the wall (11) for the damping of device and arm together is stable with the "
        "arm; no passive wall is stiffer than (11) for the damping of the device",
        boxed=True,
    )
    page.say(
        r"So $\eta\le b_D/(b_D+b_H)$ for every integer delay. The ratio comes near 1 only for an "
        "arm without damping. Fig. 12 reaches a ratio of 0.9998 at $d=40$, but no device with a "
        "damped arm has this ratio."
    )
    numbers(page)
    page.settle(
        "one-delta",
        shown(),
        instead=instead(),
        corrected=(
            r"\text{passive:}\ (5)\ \text{with}\ \delta_D=\frac{b_DT}{m_D+m_H}",
            r"\text{stable:}\ \delta=\frac{(b_D+b_H)T}{m_D+m_H}",
            r"\eta\le\frac{b_D}{b_D+b_H}",
        ),
        misprint=False,
        unless=[counterexample_of()],
        shows="a device of 1 kg and 0.625 Ns/m, coupled to an arm of 1 kg and 14.6 Ns/m, $T=1$ "
        r"ms and $K=10\,000$ N/m: (5) holds with $\delta$ and fails with $b_D$",
        note="the figures are right for an arm without damping. It remains true that passive walls "
        "are stable with every spring, and that the ratio of stable to passive stiffness exceeds "
        r"17.8 at $d=0$ and 9.3 at $d=1$. It is not true that $\eta$ comes near 1, and the passive "
        "regions of Figs. 11 and 13 are too large",
    )


def numbers(page):
    """Numbers for an arm at the limits of (21), and for the figures."""
    page.say(
        r"Take an example at the limits of the paper: $b_D/m_D=0.625\,\mathrm s^{-1}$, "
        r"$b_H/m_H=14.6\,\mathrm s^{-1}$, $k_H/m_H=710\,\mathrm s^{-2}$, $m_D=m_H$ and $T=1$ ms. "
        r"Then $\gamma=0.000355$, $\delta=0.0076125$ and $\delta_D=0.0003125$."
    )
    page.state(
        "one-delta-ratio",
        "for this arm and $d=0$ the largest stable stiffness is between 45.7 and 45.8 times the "
        "stiffness that (5) allows with $\\delta$, and between 1114 and 1115 times the largest "
        "passive stiffness, which is that of $\\delta_D$",
        claim=ratios(),
    )
    page.settle("one-delta-ratio", in_numbers(), enclosed=True)
    page.say(
        "Figs. 11 and 13 draw the passive walls for $\\delta=0.02$. At 1 kHz no device of Sec. "
        "IV-C has more than $\\delta_D=0.000625$:"
    )
    claim = oversized()
    page.state(
        "one-delta-figures",
        "for $b_D/m_D\\le0.625\\,\\mathrm s^{-1}$ and $T\\le1$ ms a wall that is 32 times as large "
        "as a passive wall still meets (5) with $\\delta=0.02$",
        claim=claim,
    )
    page.settle("one-delta-figures", drawn_too_large(), example=easy(claim))
    page.say(
        "The two bounds of Sec. V-B for the ratio remain true, since the ratio becomes larger:"
    )
    claim = still_true()
    page.state(
        "one-delta-kept",
        "on all of (23), if the damping of the device is at most that of device and arm, some "
        "stable wall is more than 17.8 times as stiff as all passive walls at $d=0$, and more than "
        "9.3 times as stiff at $d=1$",
        claim=claim,
    )
    page.settle("one-delta-kept", ratios_kept(), example=easy(claim))
    page.say(
        "To tune a device, use $b_D$ for passivity and $b_D+b_H$ for stability. If the damping "
        "of the arm is included in $b$ of (5), walls that are $1+b_H/b_D$ times too stiff "
        "appear to be passive. In the example this factor is 24. Such a wall can deliver energy "
        "as soon as the grip loosens."
    )


# The damping of a device with an arm: b_D for passivity, and b_D + b_H for the loop.

HELD = Given(T > 0, m_D > 0, m_H >= 0, b_D >= 0, b_H >= 0, k_H >= 0)
for claim in MASS > 0, T / MASS > 0, MASS / T > 0, T**2 / MASS > 0, SPRING >= 0, WHOLE - OWN >= 0:
    HELD.have(claim)


@cache
def in_units() -> tuple[Theorem, Theorem]:
    """(5) with delta_D follows from (5) with b_D, and conversely."""
    plane = drawn(OWN)
    there = moved(MEETS, plane, omega / T, HELD.show(T / MASS > 0), HELD.show(1 / T > 0))
    back = moved(plane, MEETS, omega * T, HELD.show(MASS / T > 0), assume(T > 0))
    return HELD.closed(there), HELD.closed(back)


@cache
def right() -> Theorem:
    """(5) with delta_D <=> (5) with b_D."""
    there, back = in_units()
    claim: Any = instead().parts[0]
    then = taken_apart(claim)[2]
    return as_claimed(claim, either_way(back, there, *then.of))


@cache
def more_damped() -> Theorem:
    """(5) with the delta of device and arm follows from (5) with delta_D."""
    claim: Any = drawn()
    given = conjuncts(claim.body.of[0])
    there = at(assume(drawn(OWN)), {omega: omega}, *map(assume, given))
    eased = show(claim.body.of[1], there, HELD.show(WHOLE - OWN >= 0))
    return for_all([omega], given, _on_the_circle(eased))


def _on_the_circle(theorem: Theorem) -> Theorem:
    """The denominator of (5) is not zero."""
    return HELD.closed(closed(theorem, *divisors(omega)))


@cache
def stays_stable() -> Theorem:
    """A wall that meets (5) with b_D is stable with every arm."""
    loop = taken_apart(kept())[2]
    here = {**UNITS, gamma: SPRING, delta: WHOLE}
    known = HELD.and_(K > 0)
    known.have(UNITS[alpha] > 0)
    own = known.closed(inst(damped(passive()), {**UNITS, delta: OWN}))
    robust = inst(conjunct(passive_is_stable(), STABLE), here)
    every = inst(margins(passive()), here)
    found = closed(robust, every, show(WHOLE > 0, own, HELD.show(WHOLE - OWN >= 0)))
    found = known.closed(closed(known.closed(found), more_damped(), in_units()[0]))
    found = known.closed(closed(found, more_damped(), in_units()[0]))
    assert loop
    return as_claimed(kept(), found)


@cache
def outdone_by_the_arm() -> Theorem:
    """With delta, (11) gives a stable wall 1 + b_H/b_D times as stiff as all passive ones."""
    claim = outdone()
    some = taken_apart(claim)[2]
    together = assume(b_D + b_H > 0)
    stable, tip = passive_tip()
    loop = {gamma: SPRING, delta: WHOLE}
    wall = tuple(v.xreplace(loop) for v in tip)
    # a passive wall is softer than (11) with the damping of the device
    values = dict(zip(BEST, wall, strict=True))
    _, others = some.body.at(values).of
    passive_, wanted = others.body.of
    softer = show(wanted, HELD.show(T**2 / MASS > 0), together, inst(bound(), {b: b_D}), degree=3)
    bare = for_all([K, B], [passive_], at_unit().closed(softer))
    held = HELD.closed(inst(stable, loop), together)
    found = HELD.closed(at_unit().closed(exists(conj(held, bare), some, values)))
    return as_claimed(claim, found)


def shown() -> Theorem:
    """The three theorems that replace the claim."""
    return conj(right(), stays_stable(), outdone_by_the_arm())


# -- numbers -------------------------------------------------------------------------------------


@cache
def in_numbers() -> Theorem:
    """Bounds of the ratio for the arm at the limits, with one delta and with two."""
    arm = ARM[gamma], ARM[delta]
    held, stable = wall_below(arm, 0, CLOSE)
    _, softer = none_above(arm, 0)
    claims_ = iter(ratios().of)
    found = []
    for damper in (ARM[delta], DEVICE):
        found.append(beside(next(claims_), stable, held, from_bound(least(0, damper))))
        passive_, wall = passive_wall(0, damper)
        found.append(beside(next(claims_), passive_, wall, from_bound(softer)))
    return conj(*found)


@cache
def drawn_too_large() -> Theorem:
    """A wall 32 times as large as a passive one meets (5) with the delta of the figures."""
    plane = taken_apart(oversized())[2]
    inside = conjuncts(plane.body.of[0])
    there = at(assume(drawn(OWN)), {omega: omega}, *map(assume, inside))
    here = HELD.and_(b_D <= LIMITS[b_D] * m_D, LIMITS[T] >= T)
    light = here.show(LIMITS[b_D] * MASS - b_D >= 0)
    room = positive(
        DAMPED * MASS - FIGURES * T * b_D >= 0,
        [FIGURES, T > 0, light],
        [FIGURES * LIMITS[b_D], show(LIMITS[T] - T >= 0, LIMITS[T] >= T), HELD.show(MASS > 0)],
    )
    more = over(DAMPED - FIGURES * OWN >= 0, room, MASS > 0)
    wanted = show(plane.body.of[1], there, more)
    found = for_all([omega], inside, _on_the_circle(here.closed(wanted)))
    found = HELD.closed(closed(found, in_units()[0]))
    return as_claimed(oversized(), found)


@cache
def ratios_kept() -> Theorem:
    """The ratios also exceed 17.8 and 9.3 if only b_D counts for passivity."""
    both_ = taken_apart(still_true())[2]
    parts = []
    for claim, delay, wall in zip(both_.of, (0, 1), (UNDELAYED, LATE), strict=True):
        softer = inst(bound(), {K: alpha, B: beta, T: S.One, d: S(delay)})
        softer = numbers_known(softer)
        slope_ = softer.conclusion.right.subs(b, 1)
        size = number(Relation(S.Zero, "<", slope_))

        def less(wanted: Any, softer: Theorem = softer, size: Theorem = size) -> Theorem:
            share = wanted.left.coeff(alpha)
            rest = wanted.right - share * size.conclusion.right * delta
            more = [share, size, assume(b <= delta)]
            return positive(wanted, [share, softer], more, *linear(rest, RANGES[delta]))

        parts.append(beside(claim, stable_wall(delay, wall, RANGES), wall, less))
    return as_claimed(still_true(), conj(*parts))


def easy(claim: Any) -> Case:
    """A device of 1 kg with a spring of 1 N/m meets all hypotheses."""
    symbols, given, _ = taken_apart(claim)
    light = {**dict.fromkeys(symbols, S.Zero), **LIMITS, m_H: S.Zero, b_H: S.Zero, K: S.One}
    point = {s: light[s] for s in symbols}
    known = []
    if MEETS in given:
        below: Any = MEETS.at(point)
        inside, period = conjuncts(below.body.of[0]), LIMITS[T]
        turn = period * omega
        room = LIMITS[b_D] - period / 2
        met = closed(combined(below.body.of[1], [room]), *divisors(turn))
        met = Given(*inside).closed(met)
        known.append(for_all([omega], inside, met))
    return example(point, given, *known)


def counterexample_of() -> Case:
    """At the limits, 10 000 N/m meets (5) with delta and not with b_D."""
    claim = CLAIMED["one-delta"](())
    _, given, same = taken_apart(claim)
    values = {**{s: LIMITS[s] for s in (T, m_D, m_H, b_D, b_H)}, K: S(10**4), B: S.Zero, d: S.Zero}
    there: Any = same.at(values)
    plane, device = there.of
    inside = conjuncts(plane.body.of[0])
    wanted = plane.body.of[1]
    needed = plane.body.of[1].left.xreplace({omega: pi / 2})
    met = closed(combined(wanted, [wanted.right - needed]), *divisors(omega))
    held = for_all([omega], inside, met)
    angle = {omega: pi / (2 * LIMITS[T])}
    ends = [fact(p.at(angle)) for p in conjuncts(device.body.of[0])]
    short = at(assume(device), angle, *ends)
    contrary = negated(relation(short))
    fails = not_intro(short, number(contrary), device)
    both_ways = assume(there)
    differ = not_intro(mp(both_ways, held), fails, there)
    assert given
    return counterexample(claim, values, differ)

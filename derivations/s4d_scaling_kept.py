"""Is four times the stiffness stable at twice the sampling rate?

By Table I, walls scale with the period and the mass if $bT/m$ and $kT^2/m$ stay the same. With a
constant damper or spring the walls do not scale. One wall inside (23) shows this for each of them.
"""

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.scaling import (
    KEPT,
    NOTHING,
    RATE,
    at_twice_the_rate,
    for_another_mass_and_rate,
    free_mass,
    never,
    none_as_damped,
    none_as_stiff,
    with_the_mass,
    with_the_rate,
)
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.paper.propositions.stability import HEAVY, SOON, STIFFER, STRONGER
from symhaptic.proof.enclosed import value

DAMPED, SPRUNG = Rational(1, 50), Rational(1, 1000)
"""delta and gamma within (23); at half the period they are 1/100 and 1/4000."""

STIFF = {alpha: Rational(713, 1000), beta: Rational(33, 40)}
"""This wall is stable with the damper; with half as much damping per mass no such wall is."""
LIMIT = {alpha: Rational(686, 1000), beta: Rational(8283, 10000)}
"""This wall is stable with a quarter of the spring; without a spring no such wall is."""
BRAKED = {alpha: Rational(1, 1000), beta: Rational(101, 50)}
HELD = {alpha: -Rational(95, 100000), beta: Rational(200006, 100000)}
"""The corresponding walls for the damping, with the damper and with the spring."""


def derive(page):
    stiffness(page)
    bound(page)
    _changed(page)


def stiffness(page):
    """Half the period allows four times the stiffness at some damping."""
    claim = page.claim("s4d-quadratic-in-period")
    kept = page.lemma(
        "With constant $bT/m$ and $kT^2/m$, half the period allows four times the stiffness",
        at_twice_the_rate(),
    )
    loop = {T: S.One, m: S.One, b: S.Zero, k: S.Zero, d: S.Zero}
    damped = loop | {b: DAMPED, K: STIFF[alpha], STIFFER: 4 * STIFF[alpha]}
    sprung = loop | {k: SPRUNG, K: LIMIT[alpha], STIFFER: 4 * LIMIT[alpha]}
    page.settle(
        "s4d-quadratic-in-period",
        free_mass(kept, RATE),
        example=loop | {K: S.One, STIFFER: S(4)},
        unless={
            NOTHING[0]: one_sided(claim, damped, 0, B, STIFF[beta], never),
            NOTHING[1]: one_sided(claim, sprung, 1, B, 2 * LIMIT[beta], none_as_stiff),
        },
        shows=r"for $d=0$, $k=0$ and $\delta=\tfrac1{50}$ the wall $\alpha=0.713$ can be stable; "
        r"at $\delta=\tfrac1{100}$, for the same damper at half the period, it cannot",
        note="the factor 4 is exact if $bT/m$ and $kT^2/m$ are constant; with this constant damper "
        "the factor is less than 3.93",
    )


def bound(page):
    """The bound of the damping is proportional to mass and rate, at some stiffness."""
    claim = page.claim("s4d-damping-bound")
    kept = page.lemma(
        "With constant $bT/m$ and $kT^2/m$ the bound of $BT/m$ is the same for every period and "
        "mass",
        for_another_mass_and_rate(),
    )
    loop = dict.fromkeys((b, k, d), S.Zero) | {T: S.One, m: S.One, HEAVY: S.One, SOON: S.Half}
    damped = loop | {b: DAMPED, B: BRAKED[beta], STRONGER: 2 * BRAKED[beta]}
    sprung = loop | {k: SPRUNG, B: HELD[beta], STRONGER: 2 * HELD[beta]}
    page.settle(
        "s4d-damping-bound",
        free_mass(kept, KEPT),
        example=loop | {B: S.One, STRONGER: S(2)},
        unless={
            NOTHING[0]: one_sided(claim, damped, 0, K, BRAKED[alpha], never),
            NOTHING[1]: one_sided(claim, sprung, 0, K, HELD[alpha], none_as_damped),
        },
        shows=r"for $d=0$, $k=0$ and $\delta=\tfrac1{50}$ the wall $\beta=2.02$ can be stable; "
        r"at $\delta=\tfrac1{100}$, for the same damper at half the period, it cannot",
        note="the proportion is exact if $bT/m$ and $kT^2/m$ are constant; for small $b$ the bound "
        r"without delay is $2m/T+\tfrac43b$",
    )


def one_sided(claim, values, side, free, value, denied):
    """Before (side 0) or after the change (side 1) a wall is stable, and on the other side none."""
    same = taken_apart(claim)[2].at(values)
    stable, lost = same.parts[side], same.parts[1 - side]
    wall = dict(zip(LOOP, stable.body.at({free: value}).terms, strict=True))
    there = exists(stable_at(wall), stable, {free: value})
    return values, not_intro(mp(assume(same), there), denied(free, lost.body), same)


ARM = plant.sampled(plant.normalised(Parts(stiffness=False)))
BEFORE, AFTER = Rational(1, 50), Rational(1, 100)
"""delta within (23), and for the same damper with half the period or twice the mass."""


def _changed(page):
    page.say(
        "From Table I the paper infers how the stable walls change with the period $T$ and the "
        "mass $m$, for a constant delay factor $d$. If the operator's $b$ and $k$ change in "
        "proportion, the normalised loop stays the same. If $b$ and $k$ are constant, the "
        r"normalised loop changes. A damped mass without spring and delay, $\gamma=0$ and $d=0$, "
        "shows by how much."
    )
    all_scaled(page)
    bare = {gamma: S.Zero, delta: BEFORE, d: S.Zero}
    page.say(
        r"Now keep $b$ constant. Take two walls at $\delta=\frac1{50}$, the end of the range "
        "(23):"
    )
    page.lemma(
        r"The wall $\alpha=0.713$, $\beta=0.825$ is stable for $\gamma=0$, $\delta=\frac1{50}$",
        stable_at({**bare, **STIFF}),
    )
    page.lemma(
        r"The wall $\alpha=0.001$, $\beta=2.02$ is stable for $\gamma=0$, $\delta=\frac1{50}$",
        stable_at({**bare, **BRAKED}),
    )
    page.enclosed(
        r"Intervals contain the largest damping and stiffness for $\delta=\frac1{100}$",
        [
            (r"\alpha_{\max}", value(boundary.largest_undelayed(ARM), {delta: AFTER})),
            (r"1/n_0\big|_{\delta=0.01}", value(1 / ARM.n0, {delta: AFTER})),
        ],
        because="these parameters belong to the same damper with half the period. So the first "
        r"wall with four times its stiffness is unstable with every $\beta$, and the second wall "
        r"with twice its damping is unstable with every $\alpha$",
    )
    page.lemma(
        r"All stable walls are less stiff than this bound for $\gamma=0$, $\delta=\frac1{100}$",
        none_above((S.Zero, AFTER), 0)[1],
        because="therefore the stiffness becomes less than 3.93 times as large: four times this "
        r"bound is less than $3.93\cdot0.713$. Twice the mass with the same damper also gives "
        r"$\delta=\frac1{100}$",
    )


def all_scaled(page):
    """Stability is unchanged if all parameters are scaled with the period or the mass."""
    page.lemma(
        "Stability does not change if all parameters are scaled with half the period",
        numbers_known(inst(with_the_rate(STIFFER, STRONGER), {y: S(2)})),
        because="the statement holds for every delay in periods",
    )
    heavier = inst(with_the_mass(STIFFER, STRONGER), {HEAVY: 2 * m})
    page.lemma(
        "Stability does not change if the mass and all other parameters are doubled",
        closed(heavier, positive(2 * m > 0, [2, m > 0]), positive(Ne(m, 0), m > 0)),
    )

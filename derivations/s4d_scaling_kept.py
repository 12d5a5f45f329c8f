r"""What has to be kept for the limits to scale with the period and the mass?

A loop in SI units is one in those of Table I, so that walls scale where $bT/m$ and $kT^2/m$ stay
the same. We show this for all that some damping or some stiffness can make stable, and by a wall
each that neither of the two can be left out.
"""

from sympy import Rational, S, pi

from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.scaling import (
    KEPT,
    RATE,
    at_twice_the_rate,
    for_another_mass_and_rate,
    never,
)
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.notation import B, K, T, alpha, b, beta, d, k, m
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.stability import DAMPER, HEAVY, SOON, SPRING, STIFFER, STRONGER
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import (
    absurd,
    applied,
    assume,
    weakened,
    witnessed,
)
from symhaptic.proof.theorems.tactics import counterexample, example, for_all

BEFORE = Rational(1, 50)
"""delta within (23); with half the period or twice the mass but the same damper it is 1/100."""

STIFF = {alpha: Rational(713, 1000), beta: Rational(33, 40)}
BRAKED = {alpha: Rational(1, 1000), beta: Rational(101, 50)}
LITTLE = {alpha: Rational(1, 10), beta: S.One}
"""A wall that is stable beside a free mass; a spring that swings once per period hides from it."""


def derive(page):
    stiffness(page)
    bound(page)


def stiffness(page):
    """Four times the stiffness at half the period, beside some damping."""
    claim = CLAIMED["s4d-quadratic-in-period"](())
    symbols, given, _ = taken_apart(claim)
    same = page.lemma(
        "With $bT/m$ and $kT^2/m$ kept, half the period allows four times the stiffness",
        at_twice_the_rate(),
    )
    loop_ = {T: S.One, m: S.One, b: S.Zero, k: S.Zero, d: S.Zero, DAMPER: S.Zero, SPRING: S.Zero}
    kept = loop_ | {K: STIFF[alpha], b: BEFORE, DAMPER: BEFORE, STIFFER: 4 * STIFF[alpha]}
    swung = loop_ | {K: LITTLE[alpha], SPRING: 16 * pi**2, STIFFER: 4 * LITTLE[alpha]}
    page.settle(
        "s4d-quadratic-in-period",
        for_all(symbols, [*given, *RATE], weakened(same, *given)),
        example=example(kept | {DAMPER: 2 * BEFORE}, [*given, *RATE]),
        unless=[
            lost(claim, kept, RATE, 0, B, STIFF[beta]),
            lost(claim, swung, RATE, 1, B, LITTLE[beta]),
        ],
        shows=r"$d=0$, $k=0$: at $\delta=\tfrac1{50}$ the wall $\alpha=0.713$ can be stable, at "
        r"$\tfrac1{100}$ it cannot",
        note="both are kept for $b=k=0$; with the same damper less than four times, for this arm",
    )


def bound(page):
    """Damping in proportion to mass and rate, beside some stiffness."""
    claim = CLAIMED["s4d-damping-bound"](())
    symbols, given, _ = taken_apart(claim)
    same = page.lemma(
        "With $bT/m$ and $kT^2/m$ kept, $BT/m$ has the same bound for every period and mass",
        for_another_mass_and_rate(),
    )
    loop_ = dict.fromkeys((b, k, d, DAMPER, SPRING), S.Zero) | {T: S.One, m: S.One, HEAVY: S.One}
    kept = loop_ | {B: BRAKED[beta], b: BEFORE, SOON: Rational(1, 2), DAMPER: BEFORE}
    kept[STRONGER] = 2 * BRAKED[beta]
    swung = loop_ | {B: LITTLE[beta], SOON: S.One, SPRING: 4 * pi**2, STRONGER: LITTLE[beta]}
    page.settle(
        "s4d-damping-bound",
        for_all(symbols, [*given, *KEPT], weakened(same, *given)),
        example=example(kept | {DAMPER: 2 * BEFORE}, [*given, *KEPT]),
        unless=[
            lost(claim, kept, KEPT, 0, K, BRAKED[alpha]),
            lost(claim, swung, KEPT, 1, K, LITTLE[alpha]),
        ],
        shows=r"$d=0$, $k=0$: at $\delta=\tfrac1{50}$ the wall $\beta=2.02$ can be stable, at "
        r"$\tfrac1{100}$ it cannot",
        note=r"both are kept for $b=k=0$; for small $b$ the bound without delay is "
        r"$2m/T+\tfrac43b$",
    )


def lost(claim, values, kept, order, free, value):
    """A loop that is stable for a value of ``free``, and for none after the change."""
    same = taken_apart(claim)[2].at(values)
    before, after = same.parts
    wall = dict(zip(LOOP, before.body.at({free: value}).terms, strict=True))
    some = witnessed(stable_at(wall), before, {free: value})
    none = never(free, after.body)
    differ = absurd(applied(assume(same), some), none, same)
    return counterexample(claim, values, differ, holds=[kept[1 - order]], but=kept[order])

r"""How do the sampling rate and the mass scale what is passive and what is stable?

Passivity knows neither mass nor operator, so that its limits scale without conditions. A stable
loop is one in the units of Table I: it scales where the operator's numbers there stay the same,
and not where the damper or the spring is simply kept.
"""

from sympy import Rational, S, pi

from symhaptic.book.lemmas.mass import no_mass_differs
from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.rates import with_damping_and_rate
from symhaptic.book.lemmas.scaling import (
    FASTER,
    HELD,
    with_the_mass,
    with_the_rate,
    with_the_stiffness,
)
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.book.lemmas.walls import unstable
from symhaptic.notation import B, K, T, b, d, k, m, y
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.stability import DAMPER, HEAVY, SPRING, STIFFER, STRONGER
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import absurd, applied, assume, conjoined, part, weakened
from symhaptic.proof.theorems.tactics import counterexample, example, for_all

STILL = dict.fromkeys((b, k, d, DAMPER, SPRING), S.Zero) | {T: S.One, m: S.One}
BRAKED = STILL | {K: Rational(713, 1000), B: Rational(33, 40), b: Rational(1, 50)}
"""Stable, and not with half the damping per mass."""

SWUNG = STILL | {K: Rational(1, 10), B: S.One}
"""Stable, and not with a spring that swings once per period."""


def derive(page):
    faster = page.lemma(
        "At $y$ times the rate $y^2K$ and $yB$ are stable where $K$ and $B$ were",
        with_the_rate(STIFFER, STRONGER),
    )
    passive = page.lemma(
        "At $y$ times the rate $yK$ meets (5) where $K$ did",
        with_damping_and_rate()[1],
        because="at frequencies that are $y$ times as high",
    )
    settled(
        page,
        "s6-sampling",
        conjoined(passive, faster),
        FASTER,
        _grown(BRAKED | {y: S(2), DAMPER: Rational(1, 50)}, S(4), S(2)),
        _grown(SWUNG | {y: S.One, SPRING: 4 * pi**2}, S.One, S.One),
        shows="as for four times the stiffness",
        note="with $b$ kept the passive side is exact and the stable one is not",
    )
    heavier = page.lemma("A stable wall grows with the mass", with_the_mass(STIFFER, STRONGER))
    settled(
        page,
        "s6-mass",
        conjoined(heavier, no_mass_differs(m, HEAVY)),
        HELD,
        _grown(BRAKED | {HEAVY: S(2), DAMPER: Rational(1, 50)}, S(2), S(2)),
        _grown(SWUNG | {HEAVY: S.One, SPRING: 4 * pi**2}, S.One, S.One),
        shows="twice the mass with the same damper gives less than twice the stiffness",
        note="the passive region is free of the mass, without condition",
    )

    performance(page)


def _grown(point, stiffness, damping):
    """With a wall so many times as stiff and as damped."""
    return point | {STIFFER: stiffness * point[K], STRONGER: damping * point[B]}


def performance(page):
    """Stiffness per mass, and all else in proportion."""
    symbols, given, _ = taken_apart(CLAIMED["s6-performance"](()))
    found = page.lemma(
        "Stiffness and mass that grow equally gain nothing", with_the_stiffness(STIFFER)
    )
    point = STILL | {K: S.One, B: S.One, HEAVY: S(2), STIFFER: S(2)}
    page.settle(
        "s6-performance",
        for_all(symbols, given, weakened(found, *given)),
        example=example(point, given),
        note="if wall, damper and spring grow with the mass the loop moves as before",
    )


def settled(page, id, found, kept, damped, sprung, **words):
    """Right if damper and spring are kept in the units of Table I, and each has to be."""
    claim = CLAIMED[id](())
    symbols, given, _ = taken_apart(claim)
    page.settle(
        id,
        for_all(symbols, [*given, *kept], weakened(found, *given)),
        example=example(damped | {DAMPER: 2 * damped[b]}, [*given, *kept]),
        unless=[
            lost(claim, damped, unstable_at, holds=kept[1], but=kept[0]),
            lost(claim, sprung, unstable, holds=kept[0], but=kept[1]),
        ],
        **words,
    )


def lost(claim, values, denied, holds, but):
    """A wall that is stable before the change and not after it."""
    then = taken_apart(claim)[2].at(values)
    same = next(p for p in then.of if getattr(p.of[0], "name", "") == STABLE.name)
    before, after = (dict(zip(LOOP, p.terms, strict=True)) for p in same.of)
    there = applied(part(assume(then), same), stable_at(before))
    differ = absurd(there, denied(after), then)
    return counterexample(claim, values, differ, holds=[holds], but=but)

r"""How do the passive and the stable walls scale with the sampling rate and the mass?

Passivity depends neither on the mass nor on the operator, so its limits scale without
conditions. The stable walls scale if $\gamma$ and $\delta$ of Table I stay the same, but not if the
damper or the spring of the operator is constant.
"""

from symhaptic.book.lemmas.mass import no_mass_differs
from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.rates import with_damping_and_rate
from symhaptic.book.lemmas.scaling import (
    FASTER,
    HELD,
    NOTHING,
    free_mass,
    lighter_hands,
    with_the_mass,
    with_the_rate,
    with_the_stiffness,
)
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.paper.propositions.stability import HEAVY, STIFFER, STRONGER

STILL = dict.fromkeys((b, k, d), S.Zero) | {T: S.One, m: S.One}
BRAKED = STILL | {K: Rational(713, 1000), B: Rational(33, 40), b: Rational(1, 50)}
"""A wall that is stable with this damper, and not with half the damping per mass."""

SPRUNG = STILL | {K: Rational(686, 1000), B: Rational(8283, 10000), k: Rational(1, 1000)}
"""A wall that is not stable with this spring, and stable with a quarter of it per mass."""


def derive(page):
    faster = page.lemma(
        "With constant $bT/m$ and $kT^2/m$ the wall $y^2K$, $yB$ at $y$ times the rate is stable "
        "if $K$, $B$ is",
        with_the_rate(STIFFER, STRONGER),
    )
    passive = page.lemma(
        "At $y$ times the rate the stiffness $yK$ satisfies (5) if $K$ does at the old rate",
        with_damping_and_rate()[1],
        because="the condition is the same at frequencies that are $y$ times as high",
    )
    settled(
        page,
        "s6-sampling",
        conj(passive, free_mass(faster, FASTER)),
        [_grown(point | {y: S(2)}, S(4), S(2)) for point in (BRAKED, SPRUNG)],
        shows=r"at twice the rate the wall $\alpha=0.713$ with $\delta=0.02$ becomes unstable, as "
        "for four times the stiffness",
        note="the part on passivity is exact for every device",
    )
    heavier = page.lemma(
        "With constant $b/m$ and $k/m$ a stable wall grows in proportion to the mass",
        with_the_mass(STIFFER, STRONGER),
    )
    settled(
        page,
        "s6-mass",
        conj(free_mass(heavier, HELD), no_mass_differs(m, HEAVY)),
        [_grown(BRAKED | {HEAVY: S(2)}, S(2), S(2)), _grown(SPRUNG | {HEAVY: S(4)}, S(4), S(4))],
        shows="twice the mass with the same damper gives less than twice the stiffness",
        note="the passive region does not depend on the mass",
    )
    performance(page)
    light(page)


def _grown(point, stiffness, damping):
    """Multiply the stiffness and the damping of the wall by two factors."""
    return point | {STIFFER: stiffness * point[K], STRONGER: damping * point[B]}


def performance(page):
    """Stiffness, damping and mass are multiplied by the same factor."""
    found = page.lemma(
        "Multiplying stiffness and mass by the same factor has no benefit",
        with_the_stiffness(STIFFER),
    )
    point = STILL | {K: S.One, B: S.One, HEAVY: S(2), STIFFER: S(2)}
    page.settle(
        "s6-performance",
        found,
        example=point,
        note="if $K$, $B$, $b$ and $k$ are multiplied by the same factor as the mass, the motion "
        "of the loop is unchanged",
    )


def light(page):
    """A light device with a smaller mass of the hand."""
    page.say(
        "A loose grip adds less mass to the device. Without damper and spring, the stable walls "
        "shrink by the factor $(m_D+ym_H)/(m_D+m_H)$ if only the share $y$ of the arm's mass is "
        "added:"
    )
    found = page.lemma(
        "The factor $(m_D+ym_H)/(m_D+m_H)$ is larger for a heavier device", lighter_hands()
    )
    page.settle(
        "s6-light-device",
        found,
        note="the statement is proved for devices without damper and spring, whose stable walls "
        "are proportional to the mass; which mass is sensible is a matter of judgement",
    )


def settled(page, id, found, cases, **words):
    """Settle a scaling that is right for a free mass and wrong with a damper or a spring."""
    claim = page.claim(id)
    one = cases[0]
    same = one | {b: S.Zero}
    page.settle(
        id,
        found,
        example=same,
        unless={NOTHING[n]: one_sided(claim, values, n) for n, values in enumerate(cases)},
        **words,
    )


def one_sided(claim, values, order):
    """Either before or after the change the loop is stable, but not both."""
    then = taken_apart(claim)[2].at(values)
    same = next(p for p in then.of if getattr(p.of[0], "name", "") == STABLE.name)
    loops = [dict(zip(LOOP, p.terms, strict=True)) for p in same.of]
    stable, lost = loops if order == 0 else loops[::-1]
    there = mp(conjunct(assume(then), same), stable_at(stable))
    return values, not_intro(there, unstable_at(lost), then)

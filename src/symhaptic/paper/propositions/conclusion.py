"""The claims of Sec. VI and the slips of the text."""

from __future__ import annotations

import sympy as sp
from sympy import Rational, Symbol

from symhaptic.notation import B, K, T, alpha, b, d, delta, gamma, k, k_H, m, omega, v, x, y
from symhaptic.notation.proposition import ForAll, Iff, Predicate, Proposition, both, implied, whole
from symhaptic.paper.propositions.comparison import ABOUT, DAMPED, SWINGS, transcribed
from symhaptic.paper.propositions.digits import number, quoted
from symhaptic.paper.propositions.passivity import FIVE, WALL, at_every_frequency
from symhaptic.paper.propositions.ratio import BEST, outdoes, passive, stable
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.propositions.stability import (
    HEAVY,
    LOOPS,
    STIFFER,
    STRONGER,
    in_units,
)
from symhaptic.paper.reading import Printed


@claims("s6-human-10000")
def _springs_against_arms(printed: Printed) -> Proposition:
    """A spring that swings with the Nyquist frequency has about 10000 times an arm's stiffness."""
    swings = SWINGS.at({omega: sp.pi / T})
    [about] = quoted("s5c-human-10000")
    times = number(about)
    near = [ABOUT[0] * times * k_H <= k, k <= ABOUT[1] * times * k_H]
    given = [m > 0, T > 0, k_H > 0, *DAMPED, swings]
    return ForAll((m, b, k, k_H, T), implied(given, both(near)))


@claims("s6-sampling")
def _linear_and_quadratic_in_the_rate(printed: Printed) -> Proposition:
    """At y times the rate y K is passive where K was, and K' = y^2 K with B' = y B stable.

    Passive is what meets (5).  Arm and device are the same, m, b and k.
    """
    walls = at_every_frequency(FIVE)
    passive = Iff((walls, walls.at({K: y * K, T: T / y})))
    after = in_units(STIFFER, STRONGER, T / y, m, b, k)
    stable = Iff((in_units(K, B, T, m, b, k), after))
    wall = sp.Eq(STIFFER, y**2 * K), sp.Eq(STRONGER, y * B)
    symbols = (K, B, T, m, b, k, d, y, STIFFER, STRONGER)
    return ForAll(symbols, implied([*LOOPS, y > 0, *wall], both([passive, stable])))


@claims("s6-mass")
def _mass_scales_stability_alone(printed: Printed) -> Proposition:
    """A wall is stable where the one grown like the mass is; passive with both masses or none.

    That is K' = (m'/m) K and B' = (m'/m) B, with the same damper and spring, b and k.
    """
    after = in_units(STIFFER, STRONGER, T, HEAVY, b, k)
    stable = Iff((in_units(K, B, T, m, b, k), after))
    devices = (Predicate("passive_device", (v,), (x * v**2 / 2, *WALL)) for x in (m, HEAVY))
    wall = sp.Eq(STIFFER, K * HEAVY / m), sp.Eq(STRONGER, B * HEAVY / m)
    symbols = (K, B, T, m, b, k, d, HEAVY, STIFFER, STRONGER)
    given = [*LOOPS, HEAVY > 0, *wall]
    return ForAll(symbols, implied(given, both([stable, Iff(tuple(devices))])))


@claims("s6-performance")
def _stiffness_per_mass_is_kept(printed: Printed) -> Proposition:
    """Performance is K/m, as the paper says: where both grow equally K'/m' = K/m.

    And nothing else is gained: with damper, spring and B in the same proportion the wall is
    stable where it was.
    """
    grown = HEAVY / m
    after = in_units(STIFFER, B * grown, T, HEAVY, b * grown, k * grown)
    stable = Iff((in_units(K, B, T, m, b, k), after))
    given = [*LOOPS, HEAVY > 0, sp.Eq(STIFFER, K * grown)]
    same = sp.Eq(STIFFER / HEAVY, K / m)
    symbols = (K, B, T, m, b, k, d, HEAVY, STIFFER)
    return ForAll(symbols, implied(given, both([same, stable])))


HARDLY = Rational(105, 100)
"""What is less than 1.05 times as much is hardly more."""


@claims("s6-damping-marginal")
def _damper_hardly_counts(printed: Printed) -> Proposition:
    """On (23) a damper makes walls stable that are hardly stiffer than some wall without it.

    For every whole delay; both with the same spring.
    """
    undamped = stable(d, BEST).at({delta: sp.S.Zero})
    some = outdoes(undamped, stable(d), alpha < HARDLY * x)
    given = [*transcribed("eq23"), whole(d)]
    return ForAll((gamma, delta, d), implied(given, some))


@claims("s6-stiffness-marginal")
def _spring_hardly_counts(printed: Printed) -> Proposition:
    """On (23) a spring makes no wall stable that is much stiffer than some wall without it.

    Nor does its absence.  For every whole delay; both with the same damper.
    """
    free, other = {gamma: sp.S.Zero}, alpha < HARDLY * x
    with_it = outdoes(stable(d, BEST).at(free), stable(d), other)
    without = outdoes(stable(d, BEST), stable(d).at(free), other)
    given = [*transcribed("eq23"), whole(d)]
    return ForAll((gamma, delta, d), implied(given, both([with_it, without])))


FASTER = Symbol("q")
"""How many times as fast is sampled."""
LITTLE = Rational(5, 4)
"""What is at most a quarter more is not significantly more."""


@claims("s6-faster-sampling")
def _faster_sampling_gains_little(printed: Printed) -> Proposition:
    """Sampled q times as fast at the same delay, a wall is at most a quarter stiffer than some now.

    Said of passive and of stable walls.  The delay outweighs the hold of half a period, 1 < 2 d.
    In the units of the faster sampling K is q^2 alpha, and the same device has gamma/q^2, delta/q,
    and the delay q d.  The device is one of (23), delay and q are whole.
    """
    later = {gamma: gamma / FASTER**2, delta: delta / FASTER, d: FASTER * d}
    then = FASTER**2 * alpha <= LITTLE * x
    parts = [outdoes(kind(d, BEST), kind(d).at(later), then) for kind in (passive, stable)]
    given = [*transcribed("eq23"), whole(d), 2 * d > 1, whole(FASTER), FASTER >= 1]
    return ForAll((gamma, delta, d, FASTER), implied(given, both(parts)))

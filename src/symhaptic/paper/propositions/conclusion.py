"""The claims of Sec. VI and the slips of the text."""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import x, y
from symhaptic.notation.proposition import whole
from symhaptic.paper.propositions.comparison import ABOUT, DAMPED, SWINGS
from symhaptic.paper.propositions.digits import number, quoted
from symhaptic.paper.propositions.passivity import FIVE, WALL, at_every_frequency
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.ratio import BEST, outdoes, passive, stable
from symhaptic.paper.propositions.stability import HEAVY, LOOPS, STIFFER, STRONGER, in_units
from symhaptic.paper.ranges import DAMPED as DAMPER_END
from symhaptic.paper.ranges import STIFF as SPRING_END


@claims("s6-human-10000")
def _springs_against_arms(printed: Printed) -> Proposition:
    """A spring at the Nyquist frequency is about 10000 times as stiff as an arm."""
    swings = SWINGS.at({omega: sp.pi / T})
    [about] = quoted("s5c-human-10000")
    times = number(about)
    near = [ABOUT[0] * times * k_H <= k, k <= ABOUT[1] * times * k_H]
    given = [m > 0, T > 0, k_H > 0, *DAMPED, swings]
    return ForAll((m, b, k, k_H, T), implied(given, both(near)))


@claims("s6-sampling")
def _linear_and_quadratic_in_the_rate(printed: Printed) -> Proposition:
    """At y times the rate, y K is passive if K is, and y^2 K with y B is stable if K, B is.

    Passive means that the wall meets (5). Arm and device are the same, m, b and k.
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
    """Walls scale with the mass for stability, and do not depend on it for passivity.

    The scaled wall is K' = (m'/m) K and B' = (m'/m) B, with the same damper and spring, b and k.
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
    """Performance is K/m, as in the paper: if both grow by the same factor, K'/m' = K/m.

    Nothing else changes: with damper, spring and B in the same proportion, stability is the same.
    """
    grown = HEAVY / m
    after = in_units(STIFFER, B * grown, T, HEAVY, b * grown, k * grown)
    stable = Iff((in_units(K, B, T, m, b, k), after))
    given = [*LOOPS, HEAVY > 0, sp.Eq(STIFFER, K * grown)]
    same = sp.Eq(STIFFER / HEAVY, K / m)
    symbols = (K, B, T, m, b, k, d, HEAVY, STIFFER)
    return ForAll(symbols, implied(given, both([same, stable])))


CHANGES = {
    gamma: {
        S.Zero: ("0.0770", "0.3364", "0.7710", "1.3841", "2.1802", "3.1656", "4.3478", "5.7364"),
        DAMPER_END: (
            "0.0728",
            "0.3041",
            "0.6645",
            "1.1365",
            "1.7051",
            "2.3567",
            "3.0791",
            "3.8612",
        ),
    },
    delta: {
        S.Zero: ("3.921", "7.150", "10.642", "14.205", "17.818", "21.475", "25.171", "28.907"),
        SPRING_END: ("3.926", "7.185", "10.759", "14.484", "18.368", "22.435", "26.712", "31.234"),
    },
}
"""Relative differences of the largest stable stiffness between the ends of one range, in per cent.

The differences are for both ends of the other range and d = 0 to 7, with truncated decimals.
"""


def changed(parameter: Symbol, other: Expr, delay: int) -> Proposition:
    """The ratio of the larger to the smaller of the two largest stiffnesses, in two inequalities.

    The stiffness is larger without a spring, and with a damper.
    """
    digits = CHANGES[parameter][other][delay]
    low = 1 + Rational(digits) / 100
    high = low + Rational(1, 10 ** (2 + len(digits.partition(".")[2])))
    rest, end = (delta, SPRING_END) if parameter == gamma else (gamma, DAMPER_END)
    strong, weak = (S.Zero, end) if parameter == gamma else (end, S.Zero)
    above, below = {parameter: strong, rest: other}, {parameter: weak, rest: other}
    more = outdoes(stable(delay, BEST).at(above), stable(delay).at(below), low * alpha < x)
    less = outdoes(stable(delay, BEST).at(below), stable(delay).at(above), alpha < high * x)
    return both([more, less])


def changes(parameter: Symbol) -> Proposition:
    """The changes with one parameter."""
    rows = CHANGES[parameter]
    return both(
        changed(parameter, other, n) for other, row in rows.items() for n in range(len(row))
    )


@claims("s6-damping-marginal")
def _what_the_damper_adds(printed: Printed) -> Proposition:
    """The increase of the largest stable stiffness from delta = 0 to 0.02, for d = 0 to 7.

    The claim is for both ends of the range of gamma.
    """
    return changes(delta)


@claims("s6-stiffness-marginal")
def _what_the_spring_takes(printed: Printed) -> Proposition:
    """The increase of the largest stable stiffness from gamma = 0.001 to 0, for d = 0 to 7.

    The claim is for both ends of the range of delta.
    """
    return changes(gamma)


FACTOR = Symbol("c")


def within_a_factor(best: Proposition, others: Proposition) -> Proposition:
    """Some stable wall is exceeded by no other wall by more than some factor."""
    return Exists((FACTOR,), both([FACTOR > 0, outdoes(best, others, alpha < FACTOR * x)]))


@claims("s6-damping-any-delay")
def _damper_matters_by_a_factor(printed: Printed) -> Proposition:
    """Some factor bounds the effect of a damper of (23) on the largest stable stiffness.

    Both loops have the same spring, and d is an integer.
    """
    undamped = stable(d, BEST).at({delta: S.Zero})
    given = [*transcribed("eq23"), whole(d)]
    return ForAll((gamma, delta, d), implied(given, within_a_factor(undamped, stable(d))))


@claims("s6-stiffness-any-delay")
def _spring_matters_by_a_factor(printed: Printed) -> Proposition:
    """Some factor bounds the effect of a spring of (23) on the largest stable stiffness.

    The factor bounds increase and decrease, for every integer delay; both loops have the same
    damper.
    """
    free = {gamma: S.Zero}
    with_it = within_a_factor(stable(d, BEST).at(free), stable(d))
    without = within_a_factor(stable(d, BEST), stable(d).at(free))
    given = [*transcribed("eq23"), whole(d)]
    return ForAll((gamma, delta, d), implied(given, both([with_it, without])))


FASTER = Symbol("q")
"""The factor of the sampling rate."""
LITTLE = Rational(5, 4)
"""An increase by at most a quarter is not significant."""


@claims("s6-faster-sampling")
def _faster_sampling_gains_little(printed: Printed) -> Proposition:
    """Sampling q times as fast at the same delay raises the stiffness by at most a quarter.

    The claim is for passive and for stable walls. The delay outweighs the half period of the hold,
    1 < 2 d. In the units of the faster sampling, K is q^2 alpha, and the same device has gamma/q^2,
    delta/q and the delay q d. The device is one of (23); the delay and q are integers.
    """
    later = {gamma: gamma / FASTER**2, delta: delta / FASTER, d: FASTER * d}
    then = FASTER**2 * alpha <= LITTLE * x
    parts = [outdoes(kind(d, BEST), kind(d).at(later), then) for kind in (passive, stable)]
    given = [*transcribed("eq23"), whole(d), 2 * d > 1, whole(FASTER), FASTER >= 1]
    return ForAll((gamma, delta, d, FASTER), implied(given, both(parts)))

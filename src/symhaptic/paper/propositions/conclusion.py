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
"""By how much per cent the largest stable stiffness differs between the ends of the range of one
parameter, for the ends of the other one and d = 0 to 7; decimals cut off."""


def changed(parameter: Symbol, other: Expr, delay: int) -> Proposition:
    """The larger of the largest stiffnesses at both ends over the smaller one, in two inequalities.

    Without a spring the stiffness is larger, and with a damper.
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
    """All changes with one parameter."""
    rows = CHANGES[parameter]
    return both(
        changed(parameter, other, n) for other, row in rows.items() for n in range(len(row))
    )


@claims("s6-damping-marginal")
def _what_the_damper_adds(printed: Printed) -> Proposition:
    """By how much delta = 0.02 raises the largest stable stiffness of delta = 0, for d = 0 to 7.

    For both ends of the range of gamma.
    """
    return changes(delta)


@claims("s6-stiffness-marginal")
def _what_the_spring_takes(printed: Printed) -> Proposition:
    """By how much gamma = 0 raises the largest stable stiffness of gamma = 0.001, for d = 0 to 7.

    For both ends of the range of delta.
    """
    return changes(gamma)


FACTOR = Symbol("c")


def within_a_factor(best: Proposition, others: Proposition) -> Proposition:
    """Some stable wall is not outdone by more than some factor."""
    return Exists((FACTOR,), both([FACTOR > 0, outdoes(best, others, alpha < FACTOR * x)]))


@claims("s6-damping-any-delay")
def _damper_matters_by_a_factor(printed: Printed) -> Proposition:
    """On (23) a damper raises the largest stable stiffness by some factor; d is whole.

    Both with the same spring.
    """
    undamped = stable(d, BEST).at({delta: S.Zero})
    given = [*transcribed("eq23"), whole(d)]
    return ForAll((gamma, delta, d), implied(given, within_a_factor(undamped, stable(d))))


@claims("s6-stiffness-any-delay")
def _spring_matters_by_a_factor(printed: Printed) -> Proposition:
    """On (23) a spring changes the largest stable stiffness by some factor, with every delay.

    Up or down, and both with the same damper.  The delay is whole.
    """
    free = {gamma: S.Zero}
    with_it = within_a_factor(stable(d, BEST).at(free), stable(d))
    without = within_a_factor(stable(d, BEST), stable(d).at(free))
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

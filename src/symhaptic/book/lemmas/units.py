"""The loop in units of its mass and of its period, with the five numbers of Table I."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.renaming import renamed
from symhaptic.book.lemmas.sampled import PARTS, positive_square
from symhaptic.proof.theorems.axioms import answers, transfer
from symhaptic.proof.theorems.familiar import in_units
from symhaptic.proof.theorems.samples import one_answer, turns

DELAYED = answers(transfer(PARTS, t_d, s), s, z, X, T)
"""X is the answer of the device behind the delay t_d."""
SCALED = answers(transfer((1, delta, gamma), d, s), s, z, m / T**2 * X, 1)
"""m X/T^2 is that of the device of Table I behind d periods of 1."""
TABLE = Eq(d, t_d / T), Eq(gamma, k * T**2 / m), Eq(delta, b * T / m)
WALL = Eq(alpha, K * T**2 / m), Eq(beta, B * T / m)


@cache
def in_own_units() -> Theorem:
    """DELAYED <=> SCALED, by Table I, for m and T > 0."""
    units = in_units(PARTS, t_d, z, X, T, (T, m / T**2))
    mass, period = positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0)
    force = positive(Ne(m / T**2, 0), [assume(m > 0), positive_square()])
    named = renamed(units, Iff((DELAYED, SCALED)), *map(assume, TABLE))
    return closed(named, force, mass, period)


def same_loop(other: Terms) -> Theorem:
    """X H of one loop is that of another with the same numbers, its symbols put for these."""
    here = mp(in_own_units(), assume(DELAYED))
    equal = one_answer(here, inst(here, other))
    alive = turns(assume(DELAYED))
    wall = K + B * (z - 1) / (T * z)
    sides = [(wall * X).xreplace(values) for values in ({}, other)]
    share = (z - 1) / z
    unit = (wall * T**2 / m).xreplace(dict(other))
    answer = m / T**2 * X
    rules = [(assume(WALL[0]), answer), (assume(WALL[1]), answer * share)]
    back = [(inst(rule, other), factor) for rule, factor in rules]
    found = combined(
        Eq(*sides, evaluate=False),
        [equal, unit],
        *([rule, factor] for rule, factor in back),
        *([rule, -factor] for rule, factor in rules),
    )
    lengths = [positive(Ne(v, 0), v > 0) for v in (m, T, other[m], other[T])]
    return closed(found, alive, *lengths)


def scaled_wall(claim: Proposition) -> Theorem:
    """H T^2/m = alpha + beta (z - 1)/z."""
    share = (z - 1) / z
    found = combined(claim, [assume(WALL[0]), -S.One], [assume(WALL[1]), -share])
    return closed(found, positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0))


SEVEN = {p: S(2) for p in (m, b, k, T, K, B, t_d, z, X)} | {
    d: S.One,
    alpha: S(4),
    beta: S(2),
    gamma: S(4),
    delta: S(2),
}
"""A loop with its five numbers."""

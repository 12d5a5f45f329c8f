"""The claims of the rules for other loops than the paper's, in SI units, each with its loop.

A filter, a virtual mass, a simulator or a counted position is written here as the computation from
sample to sample. Chapters derive the same from the parts in :mod:`symhaptic.loops`.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy import Expr

from symhaptic.notation import (
    B,
    Delta_x,
    K,
    T,
    alpha,
    b,
    beta,
    d,
    f_c,
    f_v,
    gamma,
    k,
    m,
    m_v,
    t_d,
    tau_a,
    tau_f,
    y,
    z,
)
from symhaptic.notation.proposition import ForAll, Iff, Predicate, Proposition, both, implied, whole
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed
from symhaptic.rules.claims import STABLE, UNITS

POLE = (f_v >= 0, f_v < 1)
"""The pole of an exponential average; f_v = 0 means no average."""

AVERAGED = Predicate("passive", (z,), (K + B * (1 - f_v) * (z - 1) / (T * (z - f_v)), b / T))
"""A wall with v_k = f_v v_(k-1) + (1 - f_v)(x_k - x_(k-1))/T as velocity, without delay."""

LATE_AVERAGED = Predicate("passive", (z,), (AVERAGED.of[0] * z**-d, b / T))
"""The wall with averaged velocity and an integer delay."""

PULLS_NOT = (T > 0, b >= 0, K >= 0)


@claims("rules:average-damping")
def _filtered_damping(printed: Printed) -> Proposition:
    """A wall with K >= 0 is passive if and only if it meets both bounds."""
    given = [*PULLS_NOT, *POLE]
    return ForAll((K, B, b, T, f_v), implied(given, Iff((both(printed), AVERAGED))))


@claims("rules:plain-damping")
def _undelayed_damping(printed: Printed) -> Proposition:
    """The condition without filter and delay is sufficient with both."""
    given = [*PULLS_NOT, *POLE, whole(d), *printed]
    return ForAll((K, B, b, T, f_v, d), implied(given, LATE_AVERAGED))


HEAVY = Predicate("passive", (z,), (K + B * (1 - 1 / z) / T + m_v * (1 - 1 / z) ** 2 / T**2, b / T))
"""A wall with a virtual mass: the second difference of the position, without delay."""

FREELY = Predicate("stable", (z,), (z ** (d + 2) + m_v / (2 * m) * (z + 1),))
"""A free mass with a virtual mass alone comes to rest except for its drift; d periods of delay."""


@claims("rules:virtual-mass", "rules:virtual-wall")
def _virtual_mass(printed: Printed) -> Proposition:
    """For every spring and damper of the wall."""
    given = [*PULLS_NOT, B >= 0, m_v >= 0]
    return ForAll((K, B, b, T, m_v), implied(given, Iff((both(printed), HEAVY))))


@claims("rules:virtual-mass-stable", "coupling:stable-mass")
def _virtual_mass_stable(printed: Printed) -> Proposition:
    given = [m > 0, m_v >= 0, whole(d)]
    return ForAll((m_v, m, d), implied(given, Iff((both(printed), FREELY))))


def _fades(polynomial: Expr) -> Predicate:
    """All zeros of a polynomial in Table I's units lie inside."""
    return Predicate("stable", (z,), (polynomial.subs(UNITS),))


def all_inside(*step: tuple[Any, ...]) -> Predicate:
    """The matrix from sample to sample, in Table I's units, has all eigenvalues inside."""
    moved = z * sp.eye(len(step)) - sp.Matrix(step)
    return _fades(sp.collect(sp.expand(moved.det(method="berkowitz")), z))


SIMULATED = (T > 0, m > 0, K > 0, B > 0)

SEMI_IMPLICIT = all_inside((1 - alpha, 1 - beta), (-alpha, 1 - beta))
"""v' = v - (alpha x + beta v) and x' = x + v'."""

EXPLICIT = all_inside((1, 1), (-alpha, 1 - beta))
"""v' = v - (alpha x + beta v) and x' = x + v."""

MEASURED = all_inside((1 - alpha / 2, 1 - beta / 2), (-alpha, 1 - beta))
"""A free mass under the force -(alpha x + beta v), held for a period."""


AVERAGING = _fades(
    (z - 1) ** 2 * (z - f_v) + (z + 1) / 2 * (alpha * (z - f_v) + beta * (1 - f_v) * (z - 1))
)
"""A free mass at the wall with averaged velocity."""

LOW_PASS = AVERAGING.at({f_v: tau_f / (T + tau_f)})
"""The exponential average that corresponds to 1/(tau s + 1) by backward Euler."""

FADING, LAG = sp.symbols("q lag")
"""The symbols for exp(-T/tau) and tau/T."""

FOLLOWING = _fades(
    z * (z - 1) ** 2 * (z - FADING)
    + (
        (z + 1) * (z - FADING) / 2
        - LAG * (z - 1) * (z - FADING)
        + LAG**2 * (1 - FADING) * (z - 1) ** 2
    )
    * ((alpha + beta) * z - beta)
)
"""A free mass at the paper's wall, with an actuator force u that satisfies tau u' = F - u."""

BEHIND = {FADING: sp.exp(-T / tau_a), LAG: tau_a / T}

LAGGING = FOLLOWING.at(BEHIND)

_TURN, _RISE = sp.cos(sp.sqrt(gamma)), sp.sqrt(gamma) * sp.sin(sp.sqrt(gamma))

SWINGING = _fades(
    gamma * (1 + gamma * LAG**2) * z * (z**2 - 2 * _TURN * z + 1) * (z - FADING)
    + (
        (1 - _TURN) * (z + 1) * (z - FADING)
        - _RISE * LAG * (z - 1) * (z - FADING)
        + gamma * LAG**2 * (1 - FADING) * (z**2 - 2 * _TURN * z + 1)
    )
    * ((alpha + beta) * z - beta)
)
"""An undamped mass on a spring, with the same wall and actuator."""


def _decides(printed: Printed, stable: Proposition) -> Proposition:
    """A loop is stable if and only if it meets the bounds."""
    return ForAll((K, B, T, m), implied([T > 0, m > 0], Iff((both(printed), stable))))


@claims("rules:semi-implicit-euler")
def _semi_implicit(printed: Printed) -> Proposition:
    return _decides(printed, SEMI_IMPLICIT)


@claims("rules:euler-explicit")
def _explicit(printed: Printed) -> Proposition:
    return _decides(printed, EXPLICIT)


@claims("rules:known-velocity")
def _measured(printed: Printed) -> Proposition:
    return _decides(printed, MEASURED)


@claims("rules:low-pass-mass")
def _filtered_mass(printed: Printed) -> Proposition:
    given = [T > 0, m > 0, tau_f >= 0]
    return ForAll((K, B, T, m, tau_f), implied(given, Iff((both(printed), LOW_PASS))))


@claims("rules:filter-as-delay")
def _filter_as_delay(printed: Printed) -> Proposition:
    given = [*SIMULATED, tau_f >= 0, *printed]
    return ForAll((K, B, T, m, tau_f), implied(given, LOW_PASS))


@claims("rules:lag-as-delay")
def _lag_as_delay(printed: Printed) -> Proposition:
    """A wall that is stable with the lag meets the bound."""
    given = [*SIMULATED, tau_a > 0, LAGGING]
    return ForAll((K, B, T, m, tau_a), implied(given, both(printed)))


@claims("rules:lag-below-delay")
def _lag_below_delay(printed: Printed) -> Proposition:
    """For a mass on a spring and integer delays, t_d = d T."""
    rules = [rule.subs(t_d, d * T) for rule in printed]
    given = [*SIMULATED, k > 0, tau_a > 0, whole(d), *rules, STABLE.at({b: sp.S.Zero})]
    return ForAll((K, B, T, m, k, tau_a, d), implied(given, SWINGING.at(BEHIND)))


@claims("rules:both-below-two")
def _both_below_two(printed: Printed) -> Proposition:
    """Both simulators are stable, for all K > 0 and B > 0."""
    then = both([SEMI_IMPLICIT, EXPLICIT])
    return ForAll((K, B, T, m), implied([*SIMULATED, *printed], then))


@claims("rules:one-mass")
def _one_mass(printed: Printed) -> Proposition:
    """A simulator with semi-implicit Euler is stable, for every damper."""
    return ForAll((K, B, T, m), implied([*SIMULATED, *printed], SEMI_IMPLICIT))


SPRING, WALL = K * y, K * (y + sp.Abs(y)) / 2
"""The force at a counted position: of a spring, and of a wall that only pushes."""


@claims("rules:counts-and-friction")
def _counts_and_friction(printed: Printed) -> Proposition:
    """A spring, or a wall that only pushes, is passive if and only if it meets both bounds."""
    both_ways = [
        Iff((both(printed), Predicate("passive_counted", (y,), (force, b, f_c, T, Delta_x))))
        for force in (SPRING, WALL)
    ]
    given = [T > 0, Delta_x > 0, b >= 0, f_c >= 0, K >= 0]
    return ForAll((K, b, f_c, T, Delta_x), implied(given, both(both_ways)))


UNDAMPED = Predicate("passive_wall", (), (K, sp.S.Zero, b, T, d))
"""A spring with a delay of d periods."""


@claims("rules:energy-leak", "rules:delay-damping")
def _undamped(printed: Printed) -> Proposition:
    """For a spring with K > 0 and every real delay t_d = d T."""
    given = [T > 0, b > 0, d >= 0, K >= 0]
    rules = [rule.subs(t_d, d * T) for rule in printed]
    return ForAll((K, b, T, d), implied(given, Iff((both(rules), UNDAMPED))))

"""The claim of each rule: every wall that it allows is stable, in SI units.

Stability is exact, for every real delay. A rule that does not name the delay, the arm or the damper
is meant for all of them. A wall has K > 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, k, m, t_d
from symhaptic.notation.proposition import ForAll, Predicate, Proposition, implied, whole
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.propositions.stability import LOOPS
from symhaptic.paper.reading import Printed

UNITS = {alpha: K * T**2 / m, beta: B * T / m, gamma: k * T**2 / m, delta: b * T / m}
"""Table I."""

EXACT = Predicate("stable_loop", (), (alpha, beta, gamma, delta, d))
STABLE = EXACT.at(UNITS)


def allowed(printed: Sequence[Any], *given: Any) -> Proposition:
    """Every wall with K > 0 that the rule allows is stable."""
    return ForAll((K, B, T, m, b, k, d), implied([*LOOPS, K > 0, *given, *printed], STABLE))


@claims("rules:damping-over-delay")
def _damping_over_delay(printed: Printed) -> Proposition:
    """For every B, arm and integer delay, t_d = d T."""
    return allowed([rule.subs(t_d, d * T) for rule in printed], whole(d))


@claims("rules:twice-damping", "rules:four-masses", "rules:two-masses")
def _springs(printed: Printed) -> Proposition:
    """For B = 0, every mass, damper, spring and delay."""
    return allowed(printed, sp.Eq(B, 0))


@claims("rules:damped-contact", "rules:euler-for-devices", "rules:two-dampings")
def _damped_contact(printed: Printed) -> Proposition:
    """For a free mass without delay, if B > 0."""
    return allowed(printed, B > 0, sp.Eq(b, 0), sp.Eq(k, 0), sp.Eq(d, 0))

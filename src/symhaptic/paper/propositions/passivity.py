"""The claims of Sec. III: passivity."""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import B, K, T, b, d, omega
from symhaptic.notation.proposition import (
    ForAll,
    Iff,
    Predicate,
    Proposition,
    both,
    implied,
    proposition,
)
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed

WALL = (K, B, b, T, d)
LOOP = (T > 0, b >= 0, d >= 0)
PASSIVE = Predicate("passive_wall", (), WALL)


def at_every_frequency(*conditions: sp.Expr) -> Proposition:
    """The conditions for 0 < omega < omega_N."""
    return ForAll((omega,), implied([omega > 0, omega < sp.pi / T], both(conditions)))


@claims("eq5")
def _condition_is_sufficient(printed: Printed) -> Proposition:
    return ForAll(WALL, implied([*LOOP, at_every_frequency(*printed)], PASSIVE))


@claims("s3a-undelayed")
def _summary_of_the_undelayed_form(printed: Printed) -> Proposition:
    """The form for d = 0 says the same as (6), its summary."""
    return ForAll(WALL[:-1], implied(LOOP[:-1], _summed_up(printed)))


@claims("eq6")
def _condition_without_delay(printed: Printed) -> Proposition:
    """(6) sums up the form for d = 0, and a wall that meets it is passive."""
    [six] = map(proposition, printed)
    sufficient = implied([six], PASSIVE.at({d: sp.S.Zero}))
    return ForAll(WALL[:-1], implied(LOOP[:-1], both([_summed_up((UNDELAYED,), six), sufficient])))


UNDELAYED = b > K * T / 2 - B * sp.cos(omega * T)
SIX = b > K * T / 2 + sp.Abs(B)


def _summed_up(printed: Printed, six: sp.Expr | Proposition = SIX) -> Proposition:
    return Iff((at_every_frequency(*printed), proposition(six)))

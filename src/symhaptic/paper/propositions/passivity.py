"""The claims of Sec. III: passivity."""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import B, K, T, b, d, omega, x, y
from symhaptic.notation.proposition import (
    ForAll,
    Iff,
    Not,
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


RANGE = (-b <= B, B <= d * b / (2 * d + 3))
"""The damping for which (9) is printed."""

BORDER = both(
    [PASSIVE, ForAll((x,), implied([x >= 0, x < b], Not((PASSIVE.at({b: x}),))))],
)
"""A wall is passive, and it is not with less damping of the device."""

STIFFEST = both([PASSIVE, ForAll((x, y), implied([PASSIVE.at({K: x, B: y})], x <= K))])
"""A wall is passive, and no passive one is stiffer."""


@claims("eq7")
def _envelope_is_the_boundary(printed: Printed) -> Proposition:
    """Each wall that (7) gives for a frequency is on the boundary."""
    inside = omega > 0, omega < sp.pi / T
    return ForAll((*WALL, omega), implied([*LOOP, *inside, *printed], BORDER))


@claims("eq8")
def _line_is_the_boundary(printed: Printed) -> Proposition:
    """Each wall of the line is on the boundary."""
    return ForAll((*WALL, y), implied([*LOOP, y >= 0, y <= 1, *printed], BORDER))


@claims("eq9")
def _linear_condition_decides(printed: Printed) -> Proposition:
    """For the damping that is named, (9) says which walls are passive."""
    return ForAll(WALL, implied([*LOOP, *RANGE], Iff((both(printed), PASSIVE))))


@claims("eq10")
def _ratio_decides(printed: Printed) -> Proposition:
    """In words no damping is named."""
    return ForAll(WALL, implied(LOOP, Iff((both(printed), PASSIVE))))


@claims("eq11")
def _wall_is_the_stiffest(printed: Printed) -> Proposition:
    return ForAll(WALL, implied([*LOOP, *printed], STIFFEST))

"""The claims of Sec. III: passivity."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from symhaptic.notation import B, K, T, b, d, omega, w, x, y
from symhaptic.notation.proposition import (
    Exists,
    ForAll,
    Iff,
    Not,
    Predicate,
    Proposition,
    both,
    implied,
    proposition,
)
from symhaptic.paper.equations import EQUATIONS
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed

WALL = (K, B, b, T, d)
LOOP = (T > 0, b >= 0, d >= 0)
PASSIVE = Predicate("passive_wall", (), WALL)


[FIVE] = next(s.printed for s in EQUATIONS if s.id == "eq5")


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


RANGE = (-b <= B, d * b / (2 * d + 3) >= B)
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


def printed_of(id: str) -> Printed:
    """The print of another equation, to which a text refers."""
    return next(s.printed for s in EQUATIONS if s.id == id)


def tends(expr: sp.Expr, variable: sp.Symbol, at: object, to: sp.Expr) -> Predicate:
    """The limit of an expression."""
    return Predicate("limit", (variable,), (expr, sp.sympify(at), to))


@claims("s3c-lower-part")
def _lower_part(printed: Printed) -> Proposition:
    """On the line (8) the condition is just met at low frequencies, and (7) tends to its points."""
    curve, line = (printed_of(id) for id in ("eq7", "eq8"))
    limits = [tends(c.rhs, omega, 0, e.rhs) for c, e in zip(curve, line, strict=True)]
    along = [proposition(e).at({y: x}) for e in line]
    margin = b - FIVE.rhs
    met = [at_every_frequency(margin >= 0), tends(margin, omega, 0, sp.S.Zero)]
    straight = ForAll((K, B, x), implied([x >= 0, x <= 1, *along], both(met)))
    given = [T > 0, b >= 0, d >= 0, y >= 0, y <= 1]
    return ForAll((b, T, d, y), implied(given, both([straight, *limits])))


@claims("s3c-kmax-frequency")
def _damping_does_nothing(printed: Printed) -> Proposition:
    """There the coefficient of B vanishes, first of all frequencies, and (11) just meets (5)."""
    need = FIVE.rhs
    coefficient = sp.diff(need, B)
    none = proposition(sp.Eq(coefficient, 0))
    first = ForAll((x,), implied([x > 0, x < omega], sp.Ne(coefficient.subs(omega, x), 0)))
    largest = printed_of("eq11")[0]
    touched = ForAll((K, B, b), implied([b >= 0, largest], sp.Eq(b, need)))
    inside = omega > 0, omega < sp.pi / T
    given = [T > 0, d >= 0, *printed]
    return ForAll((T, d, omega), implied(given, both([*inside, none, first, touched])))


def largest_stiffness(stiffness: sp.Expr, delay: int) -> list[Proposition]:
    """A wall of this stiffness is passive with some damping, and no stiffer one is."""
    here, other = PASSIVE.at({K: stiffness, d: sp.S(delay)}), PASSIVE.at({K: w, d: sp.S(delay)})
    return [Exists((B,), here), ForAll((w, B), implied([other], w <= stiffness))]


def _share(delay: int, *bounds: Callable[[sp.Expr], sp.Expr]) -> Proposition:
    """The largest passive stiffness y of a delay, over that without delay, x."""
    given = [T > 0, b > 0, *largest_stiffness(x, 0), *largest_stiffness(y, delay)]
    return ForAll((b, T, x, y), implied(given, both([bound(y / x) for bound in bounds])))


@claims("s3c-kmax-41")
def _about_41_percent(printed: Printed) -> Proposition:
    """Rounded to a hundredth it is 0.41."""
    low, high = sp.Rational(405, 1000), sp.Rational(415, 1000)
    return _share(1, lambda share: share >= low, lambda share: share < high)


@claims("s3c-kmax-27")
def _below_27_percent(printed: Printed) -> Proposition:
    return _share(2, lambda share: share < sp.Rational(27, 100))

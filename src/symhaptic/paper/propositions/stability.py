"""The claims of Sec. IV-D: stability.

A wall is stable in the sense of the paper: every zero of (18) lies inside the circle, with z = w^q
for a delay of d = p/q periods. A region is larger than another one if it contains all of its walls.
"""

from __future__ import annotations

import sympy as sp
from sympy import I, cos, exp, sin

from symhaptic.notation.proposition import And, whole
from symhaptic.paper.propositions.comparison import LOOP, STABLE
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.ranges import DAMPED

PLANT = (gamma >= 0, delta >= 0)
LATER = Symbol("d'")

NUMBERS = (n_1, n_0, a, e)
DEVICE = Predicate("device", (), (gamma, delta, *NUMBERS))


SQUARE = n_1**2 + n_0**2 + 2 * n_1 * n_0 * cos(theta)
"""|N|^2 at z = exp(j theta)."""

TERMS = {2: n_0, 1: n_1 - a * n_0, 0: e * n_0 - a * n_1, -1: e * n_1}
"""A times the conjugate of N, by powers of z."""


def stiffness(delay: Expr = d) -> Expr:
    """alpha(theta) abs(N)^2 cos(theta/2), with a zero of the loop at exp(j theta)."""
    return -sp.Add(*(c * cos((delay + k + S.Half) * theta) for k, c in TERMS.items()))


def damping(delay: Expr = d) -> Expr:
    """beta(theta) abs(N)^2 sin(theta)."""
    return -sp.Add(*(c * sin((delay + k) * theta) for k, c in TERMS.items()))


def on_boundary(delay: Expr = d) -> Proposition:
    """alpha = alpha(theta) and beta = beta(theta)."""
    return And(
        (
            Relation(alpha, "=", stiffness(delay) / (cos(theta / 2) * SQUARE)),
            Relation(beta, "=", damping(delay) / (sin(theta) * SQUARE)),
        )
    )


def at_angle() -> Proposition:
    """The loop has a zero at exp(j theta), for real delays on the principal sheet."""
    turn = exp(I * theta)
    plant, numerator = turn**2 - a * turn + e, n_1 * turn + n_0
    wall = (alpha + beta) * turn - beta
    return Relation(exp(I * (d + 1) * theta) * plant + numerator * wall, "=", S.Zero)


def explicit() -> Proposition:
    """At each angle the walls with a zero there are those of the two formulas."""
    inside = [theta > 0, theta < pi, Relation(SQUARE, "!=", S.Zero)]
    walls = (alpha, beta, *NUMBERS, theta)
    return ForAll(walls, implied([DEVICE, *inside], Iff((at_angle(), on_boundary()))))


@claims("s4d-delay-shrinks")
def _delay_shrinks_the_region(printed: Printed) -> Proposition:
    """A wall that is stable with a larger delay is stable with a smaller one."""
    given = [*PLANT, d >= 0, d <= LATER, STABLE.at({d: LATER})]
    return ForAll((*LOOP, LATER), implied(given, STABLE))


HEAVIER = Symbol("delta'")
"""A larger damper."""


START = sp.symbols("alpha_1 beta_1")
"""A wall, the start of a path in any direction."""
WAY = Symbol("x")
"""The share of the path to (alpha, beta)."""


def reached() -> Proposition:
    """All walls on the path to (alpha, beta) are stable."""
    on_it = {
        end: begin + WAY * (end - begin) for begin, end in zip(START, (alpha, beta), strict=True)
    }
    return ForAll((WAY,), implied([WAY >= 0, WAY < 1], STABLE.at(on_it)))


@claims("s4d-delta-grows")
def _damping_enlarges_the_region(printed: Printed) -> Proposition:
    """A stable wall stays stable with a larger damper, and the region grows in every direction.

    The claim is for the arms of (23) without delay, as in Fig. 7, to which the sentence refers. On
    a path from a stable wall in any direction, let the stable walls end to the right of alpha =
    -gamma. The wall at this end is stable with the larger damper. On the left the region does not
    grow, because every stable wall lies to the right of alpha = -gamma.
    """
    more = STABLE.at({delta: HEAVIER})
    wider = ForAll(START, implied([alpha > -gamma, reached()], more))
    kept = implied([more], alpha > -gamma)
    then = both([implied([STABLE], more), wider, kept]).at({d: S.Zero})
    given = [*transcribed("eq23"), delta < HEAVIER, HEAVIER <= DAMPED]
    return ForAll((alpha, beta, gamma, delta, HEAVIER), implied(given, then))


def damping_can_destabilise() -> Proposition:
    """With a stiff spring, gamma = 5, a wall is stable with a damper, not with a larger one."""
    wall = {gamma: S(5), d: S.Zero}
    lost = Not((STABLE.at({delta: HEAVIER}),))
    some = both([delta < HEAVIER, STABLE.at(wall), lost.at(wall)])
    return Exists((alpha, beta, delta, HEAVIER), some)


PHYSICAL = (K, B, T, m, b, k, d)
MORE = tuple(Symbol(f"{s}'") for s in (m, b, k))
"""Mass, damper and spring of another arm."""

LOOPS = (T > 0, m > 0, b >= 0, k >= 0, d >= 0)


def in_units(
    stiffness: Expr, damping: Expr, period: Expr, mass: Expr, damper: Expr, spring: Expr
) -> Proposition:
    """A loop in SI units is stable, by Table I."""
    units = {
        alpha: stiffness * period**2 / mass,
        beta: damping * period / mass,
        gamma: spring * period**2 / mass,
        delta: damper * period / mass,
    }
    return STABLE.at(units)


@claims("s4d-all-stabilising")
def _more_of_each_part_is_stable(printed: Printed) -> Proposition:
    """A stable wall stays stable with more mass, more damping and a stiffer spring."""
    mass, damper, spring = MORE
    before, after = in_units(K, B, T, m, b, k), in_units(K, B, T, mass, damper, spring)
    more = [mass >= m, damper >= b, spring >= k]
    return ForAll((*PHYSICAL, *MORE), implied([*LOOPS, *more, before], after))


MOST, AFTER = Symbol("x"), Symbol("beta_1")


@claims("s4d-too-much-damping")
def _damping_is_bounded_and_can_destabilise(printed: Printed) -> Proposition:
    """For an arm and a delay one bound of beta holds; more beta can destabilise a wall."""
    bounded = Exists((MOST,), ForAll((alpha, beta), implied([STABLE], beta < MOST)))
    always = ForAll((gamma, delta, d), implied([*PLANT, d >= 0], bounded))
    return both([always, lost_by_damping()])


def lost_by_damping() -> Exists:
    """Some wall is stable, and is not stable with more virtual damping."""
    wall = [*PLANT, d >= 0, beta >= 0, beta < AFTER]
    return Exists((*LOOP, AFTER), both([*wall, STABLE, Not((STABLE.at({beta: AFTER}),))]))


SOON, HEAVY = Symbol("T'"), MORE[0]
"""Period and mass of another loop."""


STIFFER, STRONGER = Symbol("K'"), Symbol("B'")
"""The wall with another mass or at another rate."""


@claims("s4d-quadratic-in-period")
def _four_times_the_stiffness_at_twice_the_rate(printed: Printed) -> Proposition:
    """Some B makes K stable at T if and only if some B makes K' = 4 K stable at T/2.

    Arm and device are the same, m, b and k.
    """
    before = Exists((B,), in_units(K, B, T, m, b, k))
    after = Exists((B,), in_units(STIFFER, B, T / 2, m, b, k))
    given = [*LOOPS, sp.Eq(STIFFER, 4 * K)]
    return ForAll((K, T, m, b, k, d, STIFFER), implied(given, Iff((before, after))))


@claims("s4d-damping-bound")
def _linear_in_mass_and_rate(printed: Printed) -> Proposition:
    """For some K, B is stable if and only if B' = B (m'/T')/(m/T) is stable with m' and T'.

    The damper and the spring are the same, b and k.
    """
    before = Exists((K,), in_units(K, B, T, m, b, k))
    scaled = B * (HEAVY / SOON) / (m / T)
    after = Exists((K,), in_units(K, STRONGER, SOON, HEAVY, b, k))
    given = [*LOOPS, SOON > 0, HEAVY > 0, sp.Eq(STRONGER, scaled)]
    symbols = (B, T, m, b, k, d, SOON, HEAVY, STRONGER)
    return ForAll(symbols, implied(given, Iff((before, after))))


SHARE = Symbol("y")
"""Ratio of the mass of a lighter hand to that of a heavier one."""


def left_over(device: Expr = m_D) -> Expr:
    """Ratio of the moving mass with the lighter hand to that with the heavier one."""
    return (device + SHARE * m_H) / (device + m_H)


HANDS = [T > 0, m_D > 0, m_H > 0, SHARE >= 0, SHARE < 1, d >= 0]


def lighter_hand() -> Proposition:
    """A wall is stable with the heavier hand <=> this share of it is with the lighter hand."""
    heavy = in_units(K, B, T, m_D + m_H, S.Zero, S.Zero)
    rest = left_over()
    light = in_units(K * rest, B * rest, T, m_D + SHARE * m_H, S.Zero, S.Zero)
    return ForAll((K, B, T, m_D, m_H, SHARE, d), implied(HANDS, Iff((heavy, light))))


@claims("s6-light-device")
def _light_device(printed: Printed) -> Proposition:
    """Without dampers and springs, the remaining share rises with the mass of the device."""
    given = [m_D > 0, m_H > 0, SHARE >= 0, SHARE < 1, m_D < HEAVY]
    rises = ForAll((m_D, m_H, SHARE, HEAVY), implied(given, left_over() < left_over(HEAVY)))
    return both([lighter_hand(), rises])


OTHER = Symbol("alpha_1")


PIECE = Rational(1, 4), Rational(1, 2)
"""The dampings beta between which the region reaches the line."""


@claims("s4d-left-bound")
def _region_ends_on_the_left_line(printed: Printed) -> Proposition:
    """For the arms of (23) every stable wall lies to the right of the published line.

    This is for integer delays. Without delay, as in Fig. 7, the line is the bound: for 1/4 <= beta
    <= 1/2, stable walls come arbitrarily close to it.
    """
    [line] = map(proposition, printed)
    stable = STABLE.at({alpha: OTHER})
    right = ForAll((OTHER, beta, d), implied([whole(d), stable], alpha < OTHER))
    near = Exists((OTHER,), both([alpha + MOST > OTHER, stable.at({d: S.Zero})]))
    between = [MOST > 0, beta >= PIECE[0], beta <= PIECE[1]]
    piece = ForAll((MOST, beta), implied(between, near))
    given = [*transcribed("eq23"), line]
    return ForAll((alpha, gamma, delta), implied(given, both([right, piece])))


REACH = Symbol("y")
"""Half of the height over which the region reaches the line."""


def damped_region_ends_on_the_line() -> Proposition:
    """For a damped arm the region ends on alpha = -gamma: without delay, and for d = 1.

    No stable wall lies on this line or to the left of it. For some y and each beta between -y and
    y, stable walls come arbitrarily close to the line. For d = 1 the spring is soft.
    """
    stable = STABLE.at({alpha: OTHER})
    right = ForAll((OTHER, beta), implied([stable], alpha < OTHER))
    near = Exists((OTHER,), both([alpha + MOST > OTHER, stable]))
    between = [MOST > 0, beta >= -REACH, beta <= REACH]
    piece = Exists((REACH,), both([REACH > 0, ForAll((MOST, beta), implied(between, near))]))
    soft = [both([delta > 0, sp.Eq(d, 0)]), both([delta > 0, sp.Eq(d, 1), gamma < 2 * delta])]
    given = [*PLANT, sp.Eq(alpha, -gamma), Or(tuple(soft))]
    return ForAll((alpha, gamma, delta, d), implied(given, both([right, piece])))

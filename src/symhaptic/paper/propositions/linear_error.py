"""The claims of Sec. IV-E on the error (26) of the linear condition along the exact boundary.

The error compares stiffnesses at the same damping. A wall is on the boundary if it is not stable,
and all walls with less stiffness, down to alpha = -gamma, are stable. The claims are for the delays
of Fig. 10, d = 0 and d = 1, and for all arms of (23).
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from symhaptic.notation import alpha_lin, x, y
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.linear import LATE, on_the_line_of_25
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.ranges import DAMPED

ARMS = tuple(map(proposition, transcribed("eq23")))
"""The ranges of gamma and delta."""
LATER = sp.symbols("alpha_1 beta_1")
"""A wall farther along the boundary."""
LEVEL = Rational(2, 100)


def on_boundary() -> Proposition:
    """A wall with alpha > -gamma is not stable, and all less stiff walls are stable."""
    softer = implied([-gamma < x, x < alpha], STABLE.at({alpha: x}))
    return both([-gamma < alpha, Not((STABLE,)), ForAll((x,), softer)])


def on_boundary_at(delay: int) -> Proposition:
    """A wall is on the boundary for this delay in periods."""
    return on_boundary().at({d: S(delay)})


@cache
def error(delay: Expr | int = d) -> Expr:
    """(alpha_lin - alpha)/(alpha + gamma), with alpha_lin on the line; its magnitude is (26)."""
    signed: Expr = (on_the_line_of_25(alpha) - alpha) / (alpha + gamma)
    return signed.subs(d, delay)


@cache
def size(delay: Expr | int = d) -> Expr:
    """(26), as published."""
    [printed] = transcribed("eq26")
    return sp.sympify(printed).xreplace({alpha_lin: on_the_line_of_25(alpha)}).subs(d, delay)


def beside(of: Expr) -> Expr:
    """The error of the other wall."""
    return of.subs(dict(zip((alpha, beta), LATER, strict=True)), simultaneous=True)


def rises() -> Proposition:
    """Of two walls on the boundary, the one with more damping has the larger error, below 2 %.

    The claim is for virtual damping that is not positive.
    """
    _, damping = LATER
    given = [*ARMS, beta < damping, damping <= 0]
    every = []
    for n in LATE:
        here = on_boundary_at(n)
        walls = [here, here.at(dict(zip((alpha, beta), LATER, strict=True)))]
        ahead = beside(error(n))
        every.append(implied(walls, both([error(n) < ahead, ahead < LEVEL])))
    symbols: tuple[Symbol, ...] = (alpha, beta, *LATER, gamma, delta)
    return ForAll(symbols, implied(given, both(every)))


SMALL, NEAR = Rational(3, 100), Rational(1, 10)
"""Up to this alpha, which no device that the paper names exceeds, and to this beta."""
CONSTANT = 3
"""The factor of the terms of second order."""


def second_order(delay: int) -> tuple[Relation, Relation]:
    """beta + delta - (d + 1/2) alpha lies between products of two small numbers."""
    [line] = transcribed("eq25")
    surplus = (line.lhs - line.rhs).subs(d, delay)
    above, below = CONSTANT * (alpha + gamma) ** 2, CONSTANT * (delta + gamma) * (alpha + 2 * gamma)
    return Relation(surplus, "<=", above), Relation(-below, "<=", surplus)


@claims("s4e-linearised")
def _line_for_small_numbers(printed: Printed) -> Proposition:
    """Near the origin the boundary differs from the line of (25) by terms of second order.

    The difference is at most 3 (alpha + gamma)^2 above and 3 (delta + gamma) (alpha + 2 gamma)
    below. The claim is for all arms of (23), both delays of Fig. 10 and alpha up to the 0.03 of
    Sec. IV-E.
    """
    every = [implied([on_boundary_at(n)], both(second_order(n))) for n in LATE]
    given = [*ARMS, alpha <= SMALL, beta <= NEAR]
    return ForAll((alpha, beta, gamma, delta), implied(given, both(every)))


UNITS = {alpha: K * T**2 / m, beta: B * T / m, gamma: k * T**2 / m, delta: b * T / m}
"""The parameters of Table I."""


def left_of_line(delay: int) -> tuple[Relation, Relation]:
    """b + B - K (t_d + T/2) lies between two numbers of order T, if K T <= y."""
    [line] = transcribed("eq24")
    surplus = b + B - K * sp.denom(line.rhs).subs(t_d, delay * T)
    above = CONSTANT * (y + k * T) ** 2 * T / m
    below = CONSTANT * (b + k * T) * (y + 2 * k * T) * T / m
    return Relation(surplus, "<=", above), Relation(-below, "<=", surplus)


def short_periods() -> Proposition:
    """For T to zero, with K T <= y and t_d = d T, the boundary tends to the line of (24).

    The difference is of order T. The claim is for d = 0 and d = 1, and for periods so short that
    the loop is near the origin and the arm is one of (23).
    """
    short = [y * T <= SMALL * m, NEAR * m >= B * T, k * T**2 <= STIFF * m, b * T <= DAMPED * m]
    given = [T > 0, m > 0, b >= 0, k >= 0, y >= K * T, *short]
    every = [implied([on_boundary_at(n).at(UNITS)], both(left_of_line(n))) for n in LATE]
    return ForAll((K, B, m, b, k, T, y), implied(given, both(every)))


PUSHING = (alpha >= 0, beta < 0)
"""Walls with K >= 0 and a negative virtual damping."""
THRESHOLD = Rational(15, 1000)
"""The damping that the paper gives."""


def far() -> Exists:
    """For some wall on the boundary with alpha >= 0 and beta < 0, (26) exceeds 2 per cent."""
    return Exists((alpha, beta), both([on_boundary(), *PUSHING, size() > LEVEL]))


def far_in_the_corner() -> Exists:
    """For some wall on the boundary with beta < 0, (26) exceeds 2 per cent."""
    return Exists((alpha, beta), both([on_boundary(), beta < 0, size() > LEVEL]))


@claims("s4e-two-percent")
def _far_for_negative_damping(printed: Printed) -> Proposition:
    """Above the given damping the error exceeds 2 per cent for some wall with beta < 0.

    The claim is for the spring of Fig. 10, for each larger damping of (23), and for both delays.
    """
    every = both(far_in_the_corner().at({gamma: STIFF, d: S(n)}) for n in LATE)
    return ForAll((delta,), implied([delta > THRESHOLD, delta <= DAMPED], every))


def corner() -> Proposition:
    """The error exceeds 2 per cent in the corner for every arm with spring and damper."""
    every = both(far_in_the_corner().at({d: S(n)}) for n in LATE)
    return ForAll((gamma, delta), implied([*ARMS, gamma > 0, delta > 0], every))


BETWEEN = {0: (Rational(1743, 10**5), Rational(1744, 10**5))}
BETWEEN |= {1: (Rational(1480, 10**5), Rational(1481, 10**5))}
"""Intervals of the damping above which the error exceeds 2 per cent, for gamma = 0.001."""


def nowhere() -> Proposition:
    """For no wall on the boundary with alpha >= 0 and beta < 0, (26) exceeds 2 per cent."""
    return ForAll((alpha, beta), implied([on_boundary(), *PUSHING], size() <= LEVEL))


def threshold() -> Proposition:
    """With the spring of Fig. 10 the error exceeds 2 per cent above one damping, for each delay."""
    every = []
    for n, (low, high) in BETWEEN.items():
        arm = {gamma: STIFF, d: S(n)}
        every += [implied([delta <= low], nowhere().at(arm))]
        every += [implied([delta >= high], far().at(arm))]
    return ForAll((delta,), implied([delta >= 0, delta <= DAMPED], both(every)))


HALF_WAY = Rational(1, 20)
"""The largest error that Fig. 10 marks."""
RANGE = {0: Rational(9, 100), 1: Rational(26, 1000)}
"""The alpha up to which the error stays below this level, for each delay of Fig. 10."""


def close(delay: int) -> Proposition:
    """(26) is at most 5 per cent, for alpha between 0 and the end of RANGE."""
    given = [on_boundary_at(delay), alpha >= 0, alpha <= RANGE[delay]]
    return implied(given, size(delay) <= HALF_WAY)


@claims("s6-linear-small-error")
def _small_over_a_range(printed: Printed) -> Proposition:
    """The error is at most 5 per cent on the boundary near the origin, for all arms of (23).

    The claim excludes walls with a virtual damping of more than 0.1.
    """
    given = [*ARMS, beta <= NEAR]
    return ForAll((alpha, beta, gamma, delta), implied(given, both(map(close, LATE))))

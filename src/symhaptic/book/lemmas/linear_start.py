"""The error (26) of the linear condition where the boundary starts: it has no bound there."""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy import Expr, Ne, S, Symbol, cos, sin

from symhaptic.book.lemmas.arm_numbers import ARM, NUMBERS, TOTAL, signs, together
from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.notation import a, d, delta, e, gamma, n_0, n_1, s_1, s_2, theta
from symhaptic.notation.proposition import And, Predicate, Proposition, Relation
from symhaptic.paper.propositions.stability import SQUARE, damping, stiffness
from symhaptic.proof.theorems.familiar import device_static
from symhaptic.proof.theorems.kernel import (
    Theorem,
    applied,
    assume,
    conjoined,
    part,
    substituted,
)
from symhaptic.proof.theorems.leaves import combined, tends
from symhaptic.proof.theorems.tactics import closed, every, for_all, positive

HALF = S.Half
GIVEN = (*ARM[1:], gamma * delta > 0, d >= 0)
DEVICE_NUMBERS = (n_1, n_0, a, e)
ACROSS = stiffness() / (cos(theta / 2) * SQUARE)
UP = damping() / (sin(theta) * SQUARE)
APART = (UP + delta) / (d + HALF) - ACROSS
"""alpha_lin - alpha at the damping of the boundary."""

_WIDTH = (s_2 + (d + 1) * s_1 + d * (d + 1) * gamma / 2).xreplace(NUMBERS)
_PLACE = Symbol("q")
_FREE = 1 + e - gamma * TOTAL
"""What a is, by the other numbers."""


def unbounded() -> Proposition:
    """At theta -> 0 the reciprocal of alpha_lin - alpha over alpha + gamma tends to zero.

    The error itself is defined near the start, as alpha + gamma is of order theta^2 there.
    """
    near = And(
        (
            _limit((ACROSS + gamma) / theta**2, _WIDTH),
            Relation(S.Zero, "<", _WIDTH),
            _limit((ACROSS + gamma) / APART, S.Zero),
        )
    )
    return every((gamma, delta, d), GIVEN, every(DEVICE_NUMBERS, ARM[:1], near))


def _limit(expr: Expr, value: Expr) -> Predicate:
    return Predicate("limit", (theta,), (expr, S.Zero, value))


@cache
def no_bound() -> Theorem:
    """The theorem of :func:`unbounded`, but for its outer quantifier, as hypotheses."""
    found = conjoined(
        _tends((ACROSS + gamma) / theta**2, _WIDTH),
        width(),
        _tends((ACROSS + gamma) / APART, S.Zero),
    )
    return for_all(DEVICE_NUMBERS, ARM[:1], found)


def _tends(expr: Expr, value: Expr) -> Theorem:
    """A limit at the start, with a by the other numbers of the device at rest."""
    static = device_static(assume(DEVICE))
    limit = closed(tends(expr.xreplace({a: _FREE}), theta, S.Zero, value), *divisors())
    equal = combined(Relation(_FREE, "=", a), [static, S.One])
    pattern = _limit(expr.xreplace({a: _PLACE}), value)
    return closed(substituted(pattern, _PLACE, limit, equal), *divisors())


@cache
def width() -> Theorem:
    """0 < s_2 + (d+1) s_1 + d (d+1) gamma/2."""
    known = signs()
    mass, line = (part(known, p) for p in known.conclusion.parts[2:4])
    first = positive(NUMBERS[s_1] >= 0, [line], [delta >= 0], [HALF, gamma >= 0])
    sprung = [HALF, d >= 0, d >= 0, gamma >= 0], [HALF, d >= 0, gamma >= 0]
    found = positive(_WIDTH > 0, [mass], [d >= 0, first], [first], *sprung)
    return closed(found, *divisors())


@cache
def divisors() -> tuple[Theorem, ...]:
    """n_1 + n_0, d + 1/2 and, for 0 < gamma delta, the gap are not zero."""
    total, known = together(), signs()
    above = applied(part(known, known.conclusion.parts[4]), assume(gamma * delta > 0))
    apart = positive(Ne(TOTAL, 0), [total])
    start = 2 * delta * n_0 + 2 * delta * n_1 + 2 * e - gamma * n_0 + gamma * n_1 - 2
    below = closed(positive(start < 0, [2, above, total]), apart)
    return (
        apart,
        positive(Ne(sp.expand(TOTAL**2), 0), [total, total]),
        positive(Ne(sp.expand(2 * TOTAL**2), 0), [2, total, total]),
        positive(Ne(d + HALF, 0), [d >= 0], [HALF]),
        positive(Ne(start, 0), [below]),
    )

"""Points of the stable region, and the walls that put a zero of the loop on the circle."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import sympy as sp
from sympy import Expr, Ne, S, Symbol, cos, sin

from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.notation import a, alpha, beta, d, delta, e, gamma, n_0, n_1, theta, z
from symhaptic.notation.proposition import And, Predicate, Proposition, Relation
from symhaptic.proof.theorems.definitions import device_at_rest, loop_substituted
from symhaptic.proof.theorems.kernel import (
    Theorem,
    applied,
    assume,
    conjoined,
    part,
    substituted,
    whole,
)
from symhaptic.proof.theorems.leaves import combined, root_outside, roots_inside, tends
from symhaptic.proof.theorems.tactics import closed, denied_by, fact, positive

SQUARE = n_1**2 + n_0**2 + 2 * n_1 * n_0 * cos(theta)
"""|N|^2 at z = exp(j theta)."""

TERMS = {2: n_0, 1: n_1 - a * n_0, 0: e * n_0 - a * n_1, -1: e * n_1}
"""A times the conjugate of N, by powers of z."""


def stiffness(delay: Expr = d) -> Expr:
    """alpha(theta) |N|^2 cos(theta/2), with a zero of the loop at exp(j theta)."""
    return -sp.Add(*(c * cos((delay + k + S.Half) * theta) for k, c in TERMS.items()))


def damping(delay: Expr = d) -> Expr:
    """beta(theta) |N|^2 sin(theta)."""
    return -sp.Add(*(c * sin((delay + k) * theta) for k, c in TERMS.items()))


def on_boundary(delay: Expr = d) -> Proposition:
    """alpha = alpha(theta) and beta = beta(theta)."""
    return And(
        (
            Relation(alpha, "=", stiffness(delay) / (cos(theta / 2) * SQUARE)),
            Relation(beta, "=", damping(delay) / (sin(theta) * SQUARE)),
        )
    )


def polynomial_at(point: Mapping[Symbol, Expr]) -> Theorem:
    """stable <=> all zeros inside, of the loop of a point; a part that is zero is not there."""
    values = [point[s] for s in (alpha, beta, gamma, delta, d)]
    parts = {"stiffness": point[gamma] != 0, "damping": point[delta] != 0}
    share = sp.Rational(point[d]).q
    found = loop_substituted(values, z, share, **parts)
    return closed(found, fact(whole(share * point[d])))


def stable_at(point: Mapping[Symbol, Expr]) -> Theorem:
    """That a loop is stable, by balls around its zeros."""
    loop = polynomial_at(point)
    zeros: Any = loop.conclusion.of[1]  # type: ignore[attr-defined]
    return applied(loop, roots_inside(zeros.of[0], z, {}))


def unstable_at(point: Mapping[Symbol, Expr]) -> Theorem:
    """That it is not, by a ball around a zero outside."""
    loop = polynomial_at(point)
    zeros: Any = loop.conclusion.of[1]  # type: ignore[attr-defined]
    return denied_by(loop, root_outside(zeros.of[0], z))


CORNER = -(2 - a - gamma * n_1) / (n_1 + n_0) - gamma * d
"""The damping with which the boundary begins, on alpha = -gamma."""


def begins(delay: Expr = d, corner: Expr = CORNER) -> Proposition:
    """At theta -> 0 the boundary is at (-gamma, corner)."""
    across = stiffness(delay) / (cos(theta / 2) * SQUARE)
    up = damping(delay) / (sin(theta) * SQUARE)
    return And(
        (
            Predicate("limit", (theta,), (across, S.Zero, -gamma)),
            Predicate("limit", (theta,), (up, S.Zero, corner)),
        )
    )


@cache
def begins_there(delay: Expr = d, lower: Expr = S.Zero) -> Theorem:
    """Where the boundary begins, of a damped device with its four numbers."""
    static, pushed = at_rest()
    total = n_1 + n_0
    apart = positive(Ne(total, 0), [pushed]), positive(Ne(sp.expand(total**2), 0), [pushed, pushed])
    wanted = begins(delay, CORNER - lower)
    found = []
    for claim in wanted.parts:
        expr, start, value = claim.terms
        raw = -(1 - a + e) / total
        if value != -gamma:
            raw = -(2 - a + delay * (1 - a + e)) / total + n_1 * (1 - a + e) / total**2
        limit = closed(tends(expr, theta, start, raw), *apart)
        # both values differ by a multiple of what is zero
        share = sp.cancel(sp.diff(raw - value, gamma) / sp.diff(static_difference(), gamma))
        equal = closed(combined(Relation(raw, "=", value), [static, -share]), *apart)
        place = Symbol("q")
        pattern = Predicate("limit", (theta,), (expr, start, place))
        found.append(closed(substituted(pattern, place, limit, equal), *apart))
    return conjoined(*found)


def static_difference() -> Expr:
    """gamma (n_1 + n_0) - (1 - a + e), which is zero."""
    return gamma * (n_1 + n_0) - (1 - a + e)


def at_rest() -> tuple[Theorem, Theorem]:
    """1 - a + e = gamma (n_1 + n_0) and 0 < n_1 + n_0, of a damped device."""
    rest = device_at_rest(assume(DEVICE))
    static, pushed, _ = (part(rest, claim) for claim in rest.conclusion.parts)
    return static, pushed

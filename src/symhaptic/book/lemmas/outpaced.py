"""No stable wall is stiffer than this: by one point of the circle, for any whole delay.

Of p with its zeros inside, n |p|^2 < 2 Re conj(p) z p' on the circle (``outpaces``).  Both sides
are quadratic in the wall, and the left one wins for every damping once the stiffness is large.  At
the angle of the tip of the stable region this bound is the tip itself.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp
from sympy import Expr, S, cos

from symhaptic.book.lemmas.passive_is_stable import NUMBERS
from symhaptic.book.lemmas.stiffest_stable import Ranges, of_every_plant
from symhaptic.model.circle import powers
from symhaptic.notation import a, alpha, beta, d, delta, e, gamma, n_0, n_1, theta
from symhaptic.notation.proposition import Relation, whole
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, LATE, named
from symhaptic.proof.theorems.familiar import loop_of_device, ordered, square
from symhaptic.proof.theorems.kernel import (
    Theorem,
    absurd,
    anything,
    applied,
    assume,
    by_cases,
    part,
    placed,
)
from symhaptic.proof.theorems.leaves import combined, is_whole, on_plants
from symhaptic.proof.theorems.roots import outpaces
from symhaptic.proof.theorems.tactics import closed, fact, positive

POWERS = {
    d + 3: S.One,
    d + 2: -a,
    d + 1: e,
    S(2): n_1 * (alpha + beta),
    S.One: n_0 * (alpha + beta) - n_1 * beta,
    S.Zero: -n_0 * beta,
}
"""The characteristic polynomial of whole delays by its powers."""

ROOM = sp.Add(
    *(
        c * f * (k + m - (d + 3)) * cos((k - m) * theta)
        for k, c in POWERS.items()
        for m, f in POWERS.items()
    )
)
"""2 Re conj(p) z p' - n |p|^2 at z = exp(j theta)."""


@cache
def room() -> Theorem:
    """0 < ROOM of a stable wall, for a whole d and every theta."""
    readings = loop_of_device(NUMBERS, (alpha, beta, gamma, delta, d))
    loop: Any = part(readings, readings.conclusion.parts[1])
    zeros = applied(loop, assume(loop.conclusion.of[0]))
    found = combined(Relation(S.Zero, "<", ROOM), [outpaces(zeros, theta)])
    steps = [is_whole(d + n, assume(whole(d))) for n in (1, 2, 3)]
    return closed(found, *steps)


@cache
def beyond() -> dict[str, Expr]:
    """-ROOM at alpha + u and beta: its coefficients of powers of u, and of v for beta."""
    plain = {c: sp.Dummy() for c in ROOM.atoms(cos)}
    form = powers(-ROOM.xreplace(plain), alpha)
    back = {c: f for f, c in plain.items()}
    one, u, v, uu, uv, vv = (
        powers(form[i], beta).get(j, S.Zero).xreplace(back)
        for i, j in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    )
    raised = {"": one + u * alpha + uu * alpha**2, "u": u + 2 * uu * alpha, "v": v + uv * alpha}
    return {**raised, "uu": uu, "uv": uv, "vv": vv}


def at_point(expr: Expr, ranges: Ranges) -> Theorem:
    """0 < f of the plant's numbers on a small box, by balls."""
    return on_plants(box.positive(sp.sympify(expr), ranges, named({**BALLS, n_0: LATE})))


def softer_than(limit: Expr, delay: int, angle: Expr, ranges: Ranges) -> Theorem:
    """alpha < ``limit`` for every stable wall and all plants of the box."""
    there = {d: S(delay), theta: angle}
    known = placed(room(), there)
    known = closed(known, fact(whole(S(delay))))
    value = known.conclusion.right  # type: ignore[attr-defined]
    of = {n: c.xreplace({**there, alpha: limit}) for n, c in beyond().items()}
    bend, stiff = of["vv"], assume(alpha >= limit)
    rest = {
        "": 4 * bend * of[""] - of["v"] ** 2,
        "u": 4 * bend * of["u"] - 2 * of["uv"] * of["v"],
        "uu": 4 * bend * of["uu"] - of["uv"] ** 2,
    }
    signs = {n: at_point(f, ranges) for n, f in rest.items()}
    turn = at_point(bend, ranges)
    less = combined(
        Relation(4 * bend * value, "<=", S.Zero),
        [square(2 * bend * beta + of["uv"] * (alpha - limit) + of["v"])],
        [signs[""]],
        [signs["u"], stiff],
        [signs["uu"], stiff, stiff],
    )
    above = Relation(S.Zero, "<", 4 * bend * value)
    contrary = absurd(positive(above, [4, turn, known]), less)
    wanted = Relation(alpha, "<", limit)
    found = by_cases(ordered(alpha, limit), assume(wanted), anything(contrary, wanted))
    return of_every_plant(found)

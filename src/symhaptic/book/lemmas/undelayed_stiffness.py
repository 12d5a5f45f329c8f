"""The largest stable stiffness without delay in closed form, for all arms of a box.

With w^2 = n_0 (n_0 + e n_1 - gamma n_0 n_1) it is (n_1 + n_0 - w)^2/(n_0 n_1^2) - gamma: no stable
wall reaches it, and every smaller alpha > -gamma is stable with the damping (w/n_0 - 1)/n_1.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp
from sympy import Eq, Expr, Ne, Rational, S

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import (
    Ranges,
    damping_between,
    inequalities,
    on_box,
    towards,
)
from symhaptic.notation import a, alpha, beta, delta, e, gamma, n_0, n_1, w
from symhaptic.notation.proposition import Relation
from symhaptic.proof.derivative import derivative
from symhaptic.proof.theorems.familiar import device_static, square
from symhaptic.proof.theorems.kernel import Theorem, applied, assume, conjoined, placed
from symhaptic.proof.theorems.leaves import combined
from symhaptic.proof.theorems.tactics import closed, fact, over, positive

TOTAL = n_1 + n_0
SQUARE = n_0 * (n_0 + e * n_1 - gamma * n_0 * n_1)
LARGEST = (TOTAL - w) ** 2 / (n_0 * n_1**2) - gamma
"""The largest stable stiffness."""
DAMPING = (w / n_0 - 1) / n_1
"""The damping of the stiffest walls."""
ROOT = Eq(w**2, SQUARE)

Sides = tuple[tuple[sp.Symbol, tuple[Any, Any]], ...]
SOFT: Sides = ((gamma, (0, Rational(1, 100))), (delta, (0, Rational(1, 10))))
"""Ten times the springs and five times the dampers of (23)."""
FREE: Sides = ((gamma, (0, 0)), (delta, (0, Rational(1, 3))))
"""No spring, and dampers up to 1/3."""
WIDEST = S(3)


def _with(claim: Any, known: Theorem, *products: Any) -> Theorem:
    """A relation from another one, a sum of products, and what a and w are."""
    value = sum((sp.Mul(*(_right(f) for f in p)) for p in products), _right(known))
    rest = claim.right - claim.left - value
    by_trace = derivative(rest, a)
    at_rest = rest.subs(a, 1 + e - gamma * TOTAL)
    by_root = sp.cancel(at_rest / (SQUARE - w**2))
    static = device_static(assume(DEVICE))
    return combined(
        claim, [known], *products, [static, sp.factor(by_trace)], [assume(ROOT), by_root]
    )


def _right(of: Any) -> Expr:
    if not isinstance(of, Theorem):
        return sp.sympify(of)
    claim: Any = of.conclusion
    found: Expr = claim.right - claim.left
    return found


@cache
def none_reaches(sides: Sides) -> Theorem:
    """alpha < LARGEST for a stable wall."""
    arms = dict(sides)
    low, high, inside = damping_between(0, arms, WIDEST)
    *planes, minor = inequalities(0)
    toward = towards(planes, minor, inside, {**arms, beta: (-WIDEST, WIDEST)})
    toward = closed(toward, low, high)
    late, first = on_box(n_0, arms), on_box(n_1, arms)
    weight = positive(n_0 * n_1**2 > 0, [late, first, first])
    per_weight = over(1 / (n_0 * n_1**2) > 0, fact(Relation(S.Zero, "<", S.One)), weight)
    near = n_0 * (1 + n_1 * beta)
    margin = _with(
        Relation(S.Zero, "<", near * (LARGEST - alpha)),
        minor,
        [on_box(TOTAL, arms), square(near - w), per_weight],
    )
    near_ = positive(near > 0, [late, toward])
    found = positive(alpha < LARGEST, [over(LARGEST - alpha > 0, margin, near_)])
    return closed(found, *map(not_zero, (late, first, toward, weight, near_)))


ROOTS = {
    SOFT: (Rational(6, 10), Rational(3, 4)),
    FREE: (Rational(53, 100), Rational(3, 4)),
}
"""The positive w lies between these, so that the damping of the stiffest walls is known, too."""
MOST = S(3)
"""More than LARGEST."""


def _root_between(sides: Sides) -> list[Theorem]:
    """ROOTS for a positive w."""
    arms, (low, high) = dict(sides), ROOTS[sides]
    root, up = assume(ROOT), assume(w > 0)
    above = positive(w**2 - low**2 > 0, [on_box(SQUARE - low**2, arms)], [root, -1])
    below = positive(high**2 - w**2 > 0, [on_box(high**2 - SQUARE, arms)], [root, 1])
    found = [
        over(w - low > 0, above, positive(w + low > 0, [up], [low])),
        over(high - w > 0, below, positive(high + w > 0, [up], [high])),
    ]
    apart = positive(Ne(w + low, 0), [up], [low]), positive(Ne(high + w, 0), [up], [high])
    return [
        closed(positive(claim, [side]), *apart)
        for claim, side in zip((w >= low, w <= high), found, strict=True)
    ]


@cache
def all_softer_reach(sides: Sides) -> Theorem:
    """The wall with DAMPING and -gamma < alpha < LARGEST is stable, w being positive."""
    arms = dict(sides)
    softest = -sp.sympify(arms[gamma][1])
    wide = {**arms, w: ROOTS[sides], alpha: (softest, MOST)}
    late, first = on_box(n_0, arms), on_box(n_1, arms)
    weight = positive(n_0 * n_1**2 > 0, [late, first, first])
    up, soft, held = assume(w > 0), assume(alpha < LARGEST), assume(alpha > -gamma)
    loop = placed(by_inequalities(0), {beta: DAMPING})
    at_one, second, third, minor = loop.conclusion.of[1].parts  # type: ignore[attr-defined]
    stiff = positive(TOTAL * (alpha + gamma) > 0, [on_box(TOTAL, arms), held])
    room = on_box(sp.expand(n_0 * n_1**2 * (MOST - LARGEST)), {**arms, w: ROOTS[sides]})
    ends = [
        positive(alpha >= softest, [held], gamma <= -softest),
        positive(alpha <= MOST, [soft], [over(MOST - LARGEST > 0, room, weight)]),
    ]
    found = conjoined(
        _with(at_one, stiff),
        _on(second, wide),
        _on(third, wide),
        _with(minor, positive(w * (LARGEST - alpha) > 0, [up, soft])),
    )
    found = applied(loop, found)
    return closed(found, *ends, *_root_between(sides), *map(not_zero, (late, first, weight)))


def _on(claim: Any, ranges: Ranges) -> Theorem:
    return combined(claim, [on_box(claim.right, ranges)])

"""Which walls behind a whole delay are passive: sufficient on the first half turn, and needed.

A wall is measured by u = KT/2 and w = B + KT/2, its delay by N = 2(d+1).
"""

from __future__ import annotations

from functools import cache
from typing import Any

from sympy import Expr, Ne, S, pi, sin

from symhaptic.book.lemmas.chords import HALF, not_zero
from symhaptic.book.lemmas.extent import extent, first_half_turn
from symhaptic.book.lemmas.passivity import INSIDE, every_margin, passive_by_angle
from symhaptic.model import passivity
from symhaptic.notation import B, K, N, T, b, d, phi, psi, theta, u, w
from symhaptic.notation.proposition import Proposition, Relation
from symhaptic.proof.theorems.analysis import in_the_limit
from symhaptic.proof.theorems.kernel import Theorem, applied, assume, part, placed, whole
from symhaptic.proof.theorems.leaves import tends
from symhaptic.proof.theorems.tactics import at, closed, follows, for_all, positive, sine_of_half

WHOLE_WALL = {u: K * T / 2, w: B + K * T / 2, N: 2 * (d + 1)}


def first_half(wall: Any = WHOLE_WALL) -> Proposition:
    """The margin of a wall for 0 < phi < pi/(2 (d+1)), phi = omega T/2."""
    return first_half_turn().at(wall)


@cache
def at_every_angle() -> Theorem:
    """The margin at every angle, from that on the first half turn; for every real d >= 0."""
    found = placed(extent(), {**WHOLE_WALL, psi: theta / 2})
    half = sine_of_half(theta)
    margin = positive(passivity.margin() >= 0, [found])
    ends = [
        positive(theta / 2 > 0, [HALF, theta > 0]),
        positive(theta / 2 < pi / 2, [HALF, theta < pi]),
        positive(2 * (d + 1) >= 2, [2, d >= 0]),
        positive(K * T / 2 >= 0, [HALF, K >= 0, T > 0]),
        not_zero(half),
    ]
    return for_all([theta], INSIDE, closed(margin, *ends))


@cache
def sufficient() -> Theorem:
    """A wall is passive, that does not pull and has a margin on the first half turn; d whole."""
    return follows(passive_by_angle(), assume(K >= 0), at_every_angle())

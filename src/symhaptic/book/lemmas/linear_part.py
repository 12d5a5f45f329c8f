"""The line of low frequencies: its walls are on the boundary, and it decides for small damping."""

from __future__ import annotations

from functools import cache
from typing import Any

from sympy import Ne, S, cos, pi

from symhaptic.book.lemmas.chords import HALF, not_zero
from symhaptic.book.lemmas.corners import corner
from symhaptic.book.lemmas.region import bordering, first_half, limits, measured, on_first_half, sufficient
from symhaptic.notation import B, K, N, T, b, d, phi, psi, x, y
from symhaptic.notation.proposition import Relation, proposition
from symhaptic.proof.theorems.kernel import Theorem, assume, discharged, placed
from symhaptic.proof.theorems.leaves import bounded, combined, square, strictly
from symhaptic.proof.theorems.tactics import closed, either_way, follows, for_all, over, positive

TURN = phi * (2 * d + 2)
ONE = S.One
LOW = (b + B) / ((HALF + d) * T)
"""Damping over delay."""


@cache
def known() -> tuple[Theorem, ...]:
    """The corner's margin, 0 <= 1 - cos N phi and 0 <= 1 + cos N phi."""
    turn = bounded(cos, TURN)
    flat, steep = (
        combined(1 + s * cos(TURN) >= 0, [HALF, square(1 + s * cos(TURN))], [HALF, turn])
        for s in (-1, 1)
    )
    found = placed(corner(), {psi: phi, N: 2 * d + 2})
    return closed(found, positive(2 * d + 2 >= 2, [2, d >= 0])), flat, steep


@cache
def shares() -> tuple[Theorem, ...]:
    """0 < (d + 1), (2d + 1) and (2d + 3), for d >= 0."""
    return tuple(positive(e > 0, [c, d >= 0], [r]) for e, c, r in ((d + 1, 1, ONE), (2 * d + 1, 2, ONE), (2 * d + 3, 2, S(3))))


@cache
def divisors() -> tuple[Theorem, ...]:
    """What (8) and (9) divide by is not zero."""
    more, low, high = shares()
    period = assume(T > 0)
    products = [
        more, low, high, period,
        positive(T * (2 * d + 1) > 0, [period, low]),
        positive((d + HALF) * T > 0, [HALF, period, low]),
        positive(d + HALF > 0, [HALF, low]),
        positive((2 * d + 1) * (2 * d + 3) > 0, [low, high]),
        positive(2 * (2 * d + 2) ** 2 - 2 > 0, [2, low, high]),
    ]
    return tuple(map(not_zero, products))


def on_line(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (8), 0 <= y <= 1, is passive and needs all of the damping; d is whole."""
    found, flat, _ = known()
    more, low, high = shares()
    some, rest, device = assume(y >= 0), positive(1 - y >= 0, y <= 1), assume(b >= 0)
    margin = measured(stiffness, damping, [device, some, found], [device, rest, flat])
    always = on_first_half(closed(margin, *divisors()))
    slope = over(
        6 * (d + 1) / (T * (2 * d + 1) * (2 * d + 3)) > 0,
        positive(6 * (d + 1) > 0, [6, more]),
        positive(T * (2 * d + 1) * (2 * d + 3) > 0, [T > 0, low, high]),
    )
    pushes = combined(K >= 0, [device, some, slope], [stiffness, -ONE])
    passive = closed(sufficient(), always, pushes, *divisors())
    least = placed(limits()[1], {b: x})
    least = combined(
        b <= x,
        [least],
        [stiffness, -T * (d + HALF)],
        [damping, ONE],
    )
    return closed(bordering(passive, closed(least, *divisors())), *divisors())


def decides() -> Theorem:
    """K < (b + B)/((d + 1/2) T) <=> passive, for K >= 0 and B <= b d/(2d+3), apart from equality."""
    found, flat, steep = known()
    more, low, high = shares()
    nine = assume(K < LOW)
    delay = positive((d + HALF) * T > 0, [HALF, T > 0, low])
    room = positive(b + B - K * T * (d + HALF) >= 0, [delay, nine])
    part = over((2 * d + 3) / (d + 1) > 0, high, more)
    of_corner = over((2 * d + 1) * (2 * d + 3) / (d + 1) > 0, positive((2 * d + 1) * (2 * d + 3) > 0, [low, high]), more)
    third = ONE / 3
    rest = positive(b * d / (2 * d + 3) - B >= 0, B <= d * b / (2 * d + 3))
    upper = over(
        1 + d * cos(TURN) / (2 * d + 3) >= 0,
        positive(2 * d + 3 + d * cos(TURN) >= 0, [d >= 0, steep], [more], [2]),
        high,
    )
    margin = positive(
        first_half().body.of[1],  # type: ignore[attr-defined]
        [third * HALF, assume(K >= 0), assume(T > 0), of_corner, found],
        [third, part, room, upper],
        [third, part, rest, flat],
    )
    margin = closed(margin, *divisors())
    always = on_first_half(margin)
    passive = closed(sufficient(), always)
    weak = over(K <= LOW, positive(b + B - K * T * (d + HALF) >= 0, [limits()[1]]), delay)
    strict = strictly(closed(weak, *divisors()), assume(Ne(K, LOW)))
    return passive, strict

"""The line of low frequencies: its walls are on the boundary, and it decides for small damping."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, not_zero
from symhaptic.book.lemmas.corners import corner
from symhaptic.book.lemmas.passivity import PASSIVE, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    at_every_angle,
    bordering,
    first_half,
    limits,
    measured,
    on_first_half,
    sufficient,
)
from symhaptic.notation import b, w
from symhaptic.proof.theorems.familiar import bounded

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
    found = inst(corner(), {psi: phi, N: 2 * d + 2})
    return closed(found, positive(2 * d + 2 >= 2, [2, d >= 0])), flat, steep


@cache
def shares() -> tuple[Theorem, ...]:
    """0 < (d + 1), (2d + 1) and (2d + 3), for d >= 0."""
    return tuple(
        positive(e > 0, [c, d >= 0], [r])
        for e, c, r in ((d + 1, 1, ONE), (2 * d + 1, 2, ONE), (2 * d + 3, 2, S(3)))
    )


@cache
def divisors() -> tuple[Theorem, ...]:
    """What (8) and (9) divide by is not zero."""
    more, low, high = shares()
    period = assume(T > 0)
    products = [
        more,
        low,
        high,
        period,
        positive(T * (2 * d + 1) > 0, [period, low]),
        positive((d + HALF) * T > 0, [HALF, period, low]),
        positive(d + HALF > 0, [HALF, low]),
        positive((2 * d + 1) * (2 * d + 3) > 0, [low, high]),
        positive(2 * (2 * d + 2) ** 2 - 2 > 0, [2, low, high]),
    ]
    return tuple(map(not_zero, products))


def met_on_line(stiffness: Theorem, damping: Theorem) -> tuple[Theorem, Theorem]:
    """On the line (8) the margin is not negative at any angle, and 0 <= K; for every d >= 0."""
    found, flat, _ = known()
    more, low, high = shares()
    some, rest, device = assume(y >= 0), positive(1 - y >= 0, y <= 1), assume(b >= 0)
    margin = measured(stiffness, damping, [device, some, found], [device, rest, flat])
    slope = over(
        6 * (d + 1) / (T * (2 * d + 1) * (2 * d + 3)) > 0,
        positive(6 * (d + 1) > 0, [6, more]),
        positive(T * (2 * d + 1) * (2 * d + 3) > 0, [T > 0, low, high]),
    )
    pushes = closed(combined(K >= 0, [device, some, slope], [stiffness, -ONE]), *divisors())
    always = on_first_half(closed(margin, *divisors()))
    return closed(at_every_angle(), always, pushes), pushes


def on_line(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (8), 0 <= y <= 1, is passive and needs all of the damping; d is whole."""
    always, pushes = met_on_line(stiffness, damping)
    passive = follows(passive_by_angle(), pushes, always)
    least = inst(limits()[1], {b: x})
    least = combined(
        b <= x,
        [least],
        [stiffness, -T * (d + HALF)],
        [damping, ONE],
    )
    return closed(bordering(passive, closed(least, *divisors())), *divisors())


@cache
def decides() -> tuple[Theorem, Theorem]:
    """(9) makes passive, for K >= 0 and B <= b d/(2d+3), and is needed but for equality."""
    delay = positive((d + HALF) * T > 0, [HALF, T > 0, shares()[1]])
    room = positive(b + B - K * T * (d + HALF) >= 0, [delay, assume(K < LOW)])
    weak = over(K <= LOW, positive(b + B - K * T * (d + HALF) >= 0, [limits()[1]]), delay)
    strict = strictly(closed(weak, *divisors()), assume(Ne(K, LOW)))
    return closed(passive_below(room), *divisors()), strict


def passive_below(room: Theorem) -> Theorem:
    """A wall with 0 <= b + B - K T (d + 1/2), K >= 0 and B <= b d/(2d+3) is passive; d whole."""
    return closed(sufficient(), _half_below(room))


def margin_below(room: Theorem) -> Theorem:
    """Such a wall has a margin at every angle, for every real d >= 0."""
    return closed(at_every_angle(), _half_below(room))


def _half_below(room: Theorem) -> Theorem:
    found, flat, steep = known()
    more, low, high = shares()
    share = over((2 * d + 3) / (d + 1) > 0, high, more)
    of_corner = over(
        (2 * d + 1) * (2 * d + 3) / (d + 1) > 0,
        positive((2 * d + 1) * (2 * d + 3) > 0, [low, high]),
        more,
    )
    third = ONE / 3
    rest = positive(b * d / (2 * d + 3) - B >= 0, d * b / (2 * d + 3) >= B)
    upper = over(
        1 + d * cos(TURN) / (2 * d + 3) >= 0,
        positive(2 * d + 3 + d * cos(TURN) >= 0, [d >= 0, steep], [more], [2]),
        high,
    )
    margin = positive(
        first_half().body.of[1],  # type: ignore[attr-defined]
        [third * HALF, assume(K >= 0), assume(T > 0), of_corner, found],
        [third, share, room, upper],
        [third, share, rest, flat],
    )
    return on_first_half(closed(margin, *divisors()))


def met_at_every_frequency(straight: Any) -> Theorem:
    """On the line (8) the condition (5) is met weakly at each frequency, and just so at none."""
    along, (frequencies, limit) = straight.body.of[0].of, straight.body.of[1].of
    always, _ = met_on_line(*map(assume, (e.at({x: y}) for e in along[-2:])))
    always = closed(inst(always, {y: x}))
    angle = omega * T
    inside = positive(angle > 0, [omega > 0, T > 0]), positive(angle < pi, [T > 0, omega < pi / T])
    there = closed(at(always, {theta: angle}, *inside), *divisors())
    half = closed(sine_of_half(angle), *inside)
    apart = not_zero(half), not_zero(positive(2 - 2 * cos(angle) > 0, [4, half, half]))
    met = closed(positive(frequencies.body.of[1], [there]), *apart)
    met = for_all([omega], frequencies.body.of[0].of, closed(met, *divisors()))
    rest = b + B - K * T * (d + HALF)
    near = closed(tends(limit.of[0], omega, S.Zero, rest), *divisors())
    *_, stiffness, damping = map(assume, along)
    zero = combined(Eq(rest, 0), [stiffness, -T * (d + HALF)], [damping, ONE])
    pattern = Predicate("limit", (omega,), (limit.of[0], S.Zero, w))
    near = subst(pattern, w, near, closed(zero, *divisors()))
    return for_all(straight.over, along, add_assum(conj(met, near), *along))


def ends_at_corner(limit: Any, one: Theorem) -> Theorem:
    """The envelope tends to the point y = 1 of the line."""
    expr, start, value = limit.of
    pattern = Predicate("limit", (omega,), (expr, start, value.xreplace({y: w})))
    found = tends(expr, omega, start, value.xreplace({y: ONE}))
    more, low, high = shares()
    cubic = positive(
        T**3 * (d + 1) * (2 * d + 1) * (2 * d + 3) > 0, [*3 * [T > 0], more, low, high]
    )
    third = [
        combined(Ne(claim.left, 0), [cubic, -ONE / 3])
        for claim in found.hypotheses
        if isinstance(claim, Relation) and claim.left.has(T**3)
    ]
    square = not_zero(positive(T * (4 * d**2 + 8 * d + 3) > 0, [T > 0, low, high]))
    square = positive(Ne(4 * T * d**2 + 8 * T * d + 3 * T, 0), [square])
    found = closed(found, *third, square, *divisors())
    return subst(pattern, w, found, combined(Eq(ONE, y), [one, -ONE]))


def at_corner(printed: Any, point: Terms) -> Theorem:
    """The wall of a point is passive, since it is the corner, y = 1 of the line."""
    found = conjunct(on_line(*map(assume, printed)), PASSIVE)
    there = inst(found, {**point, y: ONE})
    return closed(there, *map(fact, there.hypotheses))

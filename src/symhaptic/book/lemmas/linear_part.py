"""The line of low frequencies: its walls are on the boundary, and it decides for small damping."""

from symhaptic.book.lemmas.corners import corner
from symhaptic.book.lemmas.passivity import PASSIVE, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    DELAY,
    at_every_angle,
    bordering,
    first_half,
    limits,
    measured,
    on_first_half,
    sufficient,
)

TURN = phi * (2 * d + 2)
ONE = S.One
LOW = (b + B) / ((HALF + d) * T)
"""Damping over delay."""


@cache
def known() -> tuple[Theorem, ...]:
    """The corner's margin, 0 <= 1 - cos N phi and 0 <= 1 + cos N phi."""
    flat, steep = (
        show(1 + s * cos(TURN) >= 0, square(1 + s * cos(TURN)), bounded(cos, TURN)) for s in (-1, 1)
    )
    return DELAY.closed(inst(corner(), {psi: phi, N: 2 * d + 2})), flat, steep


def met_on_line(stiffness: Theorem, damping: Theorem) -> tuple[Theorem, Theorem]:
    """On the line (8) the margin is not negative at any angle, and 0 <= K; for every d >= 0."""
    found, flat, _ = known()
    some, rest, device = assume(y >= 0), show(1 - y >= 0, y <= 1), assume(b >= 0)
    margin = measured(stiffness, damping, [device, some, found], [device, rest, flat])
    pushes = DELAY.and_(b >= 0, y >= 0).show(K >= 0, stiffness)
    return closed(at_every_angle(), on_first_half(DELAY.closed(margin)), pushes), pushes


def on_line(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (8), 0 <= y <= 1, is passive and needs all of the damping; d is whole."""
    always, pushes = met_on_line(stiffness, damping)
    passive = follows(passive_by_angle(), pushes, always)
    least = inst(limits()[1], {b: x})
    return DELAY.closed(bordering(passive, show(b <= x, stiffness, damping, least)))


@cache
def decides() -> tuple[Theorem, Theorem]:
    """(9) makes passive, for K >= 0 and B <= b d/(2d+3), and is needed but for equality."""
    late = DELAY.show((d + HALF) * T > 0)
    room = show(b + B - K * T * (d + HALF) >= 0, K < LOW, late)
    weak = show(K <= LOW, limits()[1], late)
    return DELAY.closed(passive_below(room)), strictly(DELAY.closed(weak), assume(Ne(K, LOW)))


def passive_below(room: Theorem) -> Theorem:
    """A wall with 0 <= b + B - K T (d + 1/2), K >= 0 and B <= b d/(2d+3) is passive; d whole."""
    return closed(sufficient(), _half_below(room))


def margin_below(room: Theorem) -> Theorem:
    """Such a wall has a margin at every angle, for every real d >= 0."""
    return closed(at_every_angle(), _half_below(room))


def _half_below(room: Theorem) -> Theorem:
    found, flat, steep = known()
    share, of_corner, upper = (
        DELAY.show(e, steep)
        for e in (
            (2 * d + 3) / (d + 1) > 0,
            (2 * d + 1) * (2 * d + 3) / (d + 1) > 0,
            1 + d * cos(TURN) / (2 * d + 3) >= 0,
        )
    )
    third = ONE / 3
    rest = show(b * d / (2 * d + 3) - B >= 0, d * b / (2 * d + 3) >= B)
    margin = positive(
        first_half().body.of[1],  # type: ignore[attr-defined]
        [third * HALF, assume(K >= 0), assume(T > 0), of_corner, found],
        [third, share, room, upper],
        [third, share, rest, flat],
    )
    return on_first_half(DELAY.closed(margin))


def met_at_every_frequency(straight: Any) -> Theorem:
    """On the line (8) the condition (5) is met weakly at each frequency, and just so at none."""
    along, (frequencies, limit) = straight.body.of[0].of, straight.body.of[1].of
    always, _ = met_on_line(*map(assume, (e.at({x: y}) for e in along[-2:])))
    always = closed(inst(always, {y: x}))
    angle, here = omega * T, DELAY.and_(omega > 0, omega < pi / T)
    there = at(always, {theta: angle}, here.show(angle > 0), here.show(angle < pi))
    met = show(frequencies.body.of[1], there)
    met = for_all([omega], frequencies.body.of[0].of, here.closed(met, sine_of_half(angle)))
    rest = b + B - K * T * (d + HALF)
    near = tends(limit.of[0], omega, S.Zero, rest)
    pattern = Predicate("limit", (omega,), (limit.of[0], S.Zero, w))
    zero = show(Eq(rest, 0), *along[-2:])
    near = DELAY.closed(subst(pattern, w, near, zero))
    return for_all(straight.over, along, add_assum(conj(met, near), *along))


def ends_at_corner(limit: Any, one: Theorem) -> Theorem:
    """The envelope tends to the point y = 1 of the line."""
    expr, start, value = limit.of
    pattern = Predicate("limit", (omega,), (expr, start, value.xreplace({y: w})))
    found = DELAY.closed(tends(expr, omega, start, value.xreplace({y: ONE})))
    return subst(pattern, w, found, show(Eq(ONE, y), one))


def at_corner(printed: Any, point: Terms) -> Theorem:
    """The wall of a point is passive, since it is the corner, y = 1 of the line."""
    there = inst(conjunct(on_line(*map(assume, printed)), PASSIVE), {**point, y: ONE})
    return closed(there, *map(fact, there.hypotheses))

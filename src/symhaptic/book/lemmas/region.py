"""Which walls with an integer delay are passive: sufficient on the first half turn, and needed.

A wall is measured by u = KT/2 and w = B + KT/2, its delay by N = 2(d+1).
"""

from symhaptic.book.lemmas.extent import ends, extent, first_half_turn
from symhaptic.book.lemmas.passivity import PASSIVE, every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *

WHOLE_WALL = {u: K * T / 2, w: B + K * T / 2, N: 2 * (d + 1)}
DELAY = Given(d >= 0, T > 0)
TURN = DELAY.and_(phi > 0, phi * (2 * d + 2) < pi)
"""The first half turn."""


def first_half(wall: Any = WHOLE_WALL) -> Proposition:
    """The margin of a wall for 0 < phi < pi/(2 (d+1)), phi = omega T/2."""
    return first_half_turn().at(wall)


@cache
def at_every_angle() -> Theorem:
    """The margin at every angle, from that on the first half turn; for every real d >= 0."""
    found = show(passivity.margin() >= 0, inst(extent(), {**WHOLE_WALL, psi: theta / 2}))
    here = DELAY.and_(K >= 0, *INSIDE)
    return for_all([theta], INSIDE, here.closed(found, sine_of_half(theta)))


@cache
def sufficient() -> Theorem:
    """A wall is passive, that does not pull and has a margin on the first half turn; d whole."""
    return follows(passive_by_angle(), assume(K >= 0), at_every_angle())


@cache
def needed() -> Theorem:
    """A passive wall has a margin on the first half turn; d whole."""
    always = conjunct(mp(passive_by_angle(), assume(PASSIVE)), every_margin())
    inside = TURN.show(2 * phi > 0), TURN.show(2 * phi < pi)
    there = at(always, {theta: 2 * phi}, *inside)
    return on_first_half(show(first_half().body.of[1], there))  # type: ignore[attr-defined]


@cache
def pushes() -> Theorem:
    """A passive wall does not pull."""
    return conjunct(mp(passive_by_angle(), assume(PASSIVE)), K >= 0)


@cache
def limits() -> tuple[Theorem, Theorem]:
    """B <= b - KT/2 and KT (d + 1/2) <= b + B for a passive wall; d whole."""
    claims = b - K * T / 2 >= B, K * T * (d + HALF) <= b + B
    found = (show(claim, inst(end, WHOLE_WALL)) for claim, end in zip(claims, ends(), strict=True))
    return tuple(DELAY.closed(t, needed()) for t in found)  # type: ignore[return-value]


def bordering(passive: Theorem, least: Theorem) -> Theorem:
    """A wall is passive, and with less damping it is not.

    ``least`` concludes that a passive wall needs the damping b, of one with the damping x.
    """
    lesser = not_intro(least, assume(x < b), PASSIVE.at({b: x}))
    return conj(passive, for_all([x], [x >= 0, x < b], add_assum(lesser, x >= 0, x < b)))


def on_first_half(margin: Theorem) -> Theorem:
    """The margin for all angles of the first half turn, from that at one."""
    found = TURN.closed(margin, TURN.show(sin(phi) > 0))
    return for_all([phi], first_half().body.of[0].of, found)  # type: ignore[attr-defined]


def measured(stiffness: Theorem, damping: Theorem, *products: Any) -> Theorem:
    """The margin on the first half turn of a wall whose stiffness and damping are given."""
    goal = first_half().body.of[1]  # type: ignore[attr-defined]
    of_damping = cos(phi * (2 * d + 2))
    of_stiffness = T / 2 * (of_damping - cos(phi) * sin(phi * (2 * d + 2)) / sin(phi))
    return combined(goal, *products, [stiffness, -of_stiffness], [damping, -of_damping])

"""Around the origin the stable walls without delay lie above beta = alpha/2 - delta.

Jury's minor is S (1 - n_0 beta) (beta + delta - alpha/2) but for little.
"""

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import inequalities, of_every_plant, on_box
from symhaptic.book.lemmas.undelayed_curve import (
    BETWEEN,
    ROOM,
    TOTAL,
    enough,
    needed,
    plants,
)
from symhaptic.paper.propositions.plots import CURVE, FINE, FRAME

ABOVE = beta - alpha / 2 + delta
SEEN = {**RANGES, alpha: (-STIFF, FRAME[0]), beta: (-FRAME[1], FRAME[1])}
LITTLE = Rational(4, 10**5)


@cache
def rest(sign: int) -> tuple[Theorem, Theorem, Theorem]:
    """What the minor is more or less than S (1 - n_0 beta) (beta + delta - alpha/2)."""
    lag = TOTAL / 2 * ROOM - n_0 * (1 + beta * n_1)
    most = (FINE * TOTAL - LITTLE) * ROOM + sign * (alpha * lag - gamma * n_0 * beta * TOTAL)
    slow = LITTLE + sign * (1 - e - delta * TOTAL)
    return on_box(most, SEEN), on_box(slow, RANGES), on_box(ROOM, SEEN)


def above() -> Theorem:
    """A stable wall lies above the line, or hardly below."""
    minor, total = inequalities(0)[3], plants()["total"]
    most, slow, room = rest(-1)
    goal = ABOVE + FINE
    product = combined(
        TOTAL * ROOM * goal > 0, [minor], [most], [slow, room], [plants()["static"], _share()]
    )
    weight = positive(TOTAL * ROOM > 0, [total, room])
    found = combined(ABOVE > -FINE, [over(goal > 0, product, weight)])
    return closed(found, not_zero(weight), not_zero(total), not_zero(room))


@cache
def origin() -> Theorem:
    """Both, for every arm of (23)."""
    symbols, given, then = taken_apart(CLAIMED["fig8"](()))
    inside, above_ = then.of  # type: ignore[attr-defined]
    left = combined(alpha >= -STIFF, [assume(alpha > -gamma)], [assume(gamma <= STIFF)])
    right = of_every_plant(conjunct(needed(), BETWEEN.parts[0]))
    down = combined(beta > -1, [assume(-FRAME[1] <= beta)], [1 - FRAME[1]])
    right = closed(right, down)
    below = of_every_plant(closed(above(), closed(left, right)))
    there = disch(conj(right, below), inside.of[0])
    back = disch(of_every_plant(closed(is_filled(), left, down)), above_.of[0])
    return for_all(symbols, given, add_assum(conj(there, back), *given))


def _share() -> Expr:
    return -beta * n_0


def is_filled() -> Theorem:
    """A wall above the line, right of alpha = -gamma, is stable."""
    minor, known = inequalities(0)[3].conclusion, plants()
    most, slow, room = rest(1)
    high = positive(ABOVE - FINE > 0, ABOVE > FINE)
    inner = combined(
        minor, [known["total"], room, high], [most], [slow, room], [known["static"], -_share()]
    )
    curve = combined(alpha < CURVE, [over(CURVE - alpha > 0, inner, known["weight"])])
    apart = [not_zero(known[n]) for n in ("weight", "late", "toward")]
    return closed(enough(), closed(curve, *apart))

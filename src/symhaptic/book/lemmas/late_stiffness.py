"""How stiff is a passive wall at most, that is late by a fraction of a period?  At each angle."""

from symhaptic.book.lemmas.late_passivity import EVERY_MARGIN, GIVEN, LATE, WALL, passive_late
from symhaptic.book.lemmas.passivity import INSIDE, at_every_angle
from symhaptic.book.lemmas.prelude import *

SHARE = epsilon * (1 - epsilon)
UP = (1 - epsilon) * sin((l + 1) * theta) + epsilon * sin((l + 2) * theta)
ALONG = (1 - epsilon) * cos((l + 1) * theta) + epsilon * cos((l + 2) * theta)
BOUND = proposition(SHARE * K * T * sin(theta) <= 2 * b * (1 - UP))
"""What an angle allows."""


def below_the_bound() -> Proposition:
    """No passive wall is stiffer, at any angle."""
    return every(WALL, GIVEN, implied([LATE], at_every_angle(BOUND)))


@cache
def bounded_at_every_angle() -> Theorem:
    """The margin is a square short of the square of what is left, which is not negative then."""
    always = conjunct(mp(passive_late(), assume(LATE)), EVERY_MARGIN)
    margin = at(always, {theta: theta}, *(assume(p) for p in INSIDE))
    half = sine_of_half(theta)
    left = b * (1 - UP) - SHARE * K * T * sin(theta / 2) * cos(theta / 2)
    across = SHARE * (K * T + 2 * B) * sin(theta / 2) ** 2 - b * ALONG
    share = epsilon >= 0, positive(1 - epsilon >= 0, epsilon <= 1)
    squares = [square(left)], [square(across)], [4, *share, half, half, margin]
    found = positive(2 * b * left >= 0, *squares)
    found = positive(BOUND, [found, over(1 / b > 0, one(), b > 0)])
    apart = positive(Ne(sin(theta / 2), 0), [half]), positive(Ne(b, 0), b > 0)
    always = for_all([theta], INSIDE, closed(found, *apart))
    return for_all(WALL, GIVEN, add_assum(disch(always, LATE), *GIVEN))

"""A passive wall stays passive while its stiffness is taken away and its damping is kept."""

from symhaptic.book.lemmas.chords import PI
from symhaptic.book.lemmas.passive_is_stable import EVERY_MARGIN, MARGIN, margin_to_the_end
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *


@cache
def within_the_damper() -> tuple[Theorem, Theorem]:
    """-delta <= beta and beta <= delta, from the margin at every angle, 0 <= alpha and 0 <= d."""
    start = delta + beta - alpha * (d + S.Half)
    below = at(assume(EVERY_MARGIN), {theta: theta}, *map(assume, INSIDE))
    slow = in_the_limit(below, theta, S.Zero, pi, tends(MARGIN, theta, S.Zero, start))
    late = positive(d + S.Half > 0, d >= 0, [S.Half])
    low = positive(beta + delta >= 0, [prove_hyp(slow, PI)], [alpha >= 0, late])
    angle = pi / (d + 1)
    more = positive(d + 1 > 0, d >= 0, [S.One])
    inside = over(angle > 0, PI, more)
    end = positive(angle <= pi, [over(pi - angle >= 0, positive(pi * d >= 0, [PI, d >= 0]), more)])
    there = inst(margin_to_the_end(), {theta: angle})
    # there the cosine is -1, and the quotient of the sines 1/2
    high = positive(beta <= delta, [there], [S.Half, alpha >= 0])
    return low, closed(high, inside, end, positive(Ne(d + 1, 0), [more]))


@cache
def stays_passive() -> Theorem:
    """The margin at every angle of y alpha, from that of alpha, 0 <= y <= 1 and 0 <= alpha."""
    low, high = within_the_damper()
    turn = cos((d + 1) * theta)
    bound = bounded(cos, (d + 1) * theta)
    one, other = (
        positive(1 + s * turn >= 0, *([S.Half, x] for x in (square(1 + s * turn), bound)))
        for s in (1, -1)
    )
    eased = positive(delta + beta * turn >= 0, [S.Half, low, one], [S.Half, high, other])
    there = at(assume(EVERY_MARGIN), {theta: theta}, *map(assume, INSIDE))
    wanted = MARGIN.xreplace({alpha: y * alpha})
    share = positive(1 - y >= 0, y <= 1)
    found = positive(wanted >= 0, [y >= 0, there], [share, eased])
    apart = positive(Ne(sin(theta / 2), 0), [sine_of_half(theta)])
    return for_all([theta], INSIDE, closed(found, apart))

"""The linear condition beside passivity: it is (9), and its walls are passive in a range of B."""

from symhaptic.book.lemmas.linear_part import passive_below
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import DELAY
from symhaptic.model import lag
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.linear import on_or_below_the_line


def same_condition(linear: Any, passive: Any) -> Theorem:
    """(24) <=> (9), where t_d = d T."""
    here = DELAY.and_(Eq(t_d, d * T))
    here.have((d + HALF) * T > 0)
    here.have(lag.DELAY > 0)
    room = here.show(b + B - K * (d + HALF) * T > 0, linear)
    back = here.show(b + B - K * lag.DELAY > 0, passive)
    there, back = here.show(passive, room), here.show(linear, back)
    return either_way(there, back, linear, passive)


@cache
def passive_on_the_line() -> Theorem:
    """A wall with (25), or on its border, is passive: d whole, alpha >= 0 and delta = b_D T/m.

    That is for beta <= delta d/(2d+3).
    """
    here = Given(m > 0, T > 0, *normalised(alpha, beta, d), Eq(delta, b_D * T / m))
    spring, damper = here.have(m / T**2 > 0), here.have(m / T > 0)
    below = assume(b + B - K * T * (d + HALF) >= 0)
    found = inst(passive_below(below), {b: b_D})
    stiff, damped, _ = map(assume, normalised(alpha, beta, d))
    lossy = assume(Eq(delta, b_D * T / m))
    pushes = combined(K >= 0, [spring, assume(alpha >= 0)], [stiff, m / T**2])
    room = combined(
        b_D + B - K * T * (d + HALF) >= 0,
        [damper, assume(on_or_below_the_line())],
        [damped, m / T],
        [lossy, m / T],
        [stiff, -m / T * (HALF + d)],
    )
    share = d / (2 * d + 3)
    small = combined(
        d * b_D / (2 * d + 3) >= B,
        [damper, assume(d / (2 * d + 3) * delta >= beta)],
        [damped, -m / T],
        [lossy, m / T * share],
    )
    ahead = here.show(d >= 0, t_d >= 0)
    return here.closed(closed(found, room, pushes, small), ahead)

"""The linear condition beside passivity: it is (9), and its walls are passive in a range of B."""

from __future__ import annotations

from symhaptic.book.lemmas.linear_part import divisors, passive_below, shares
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.notation import b
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.linear import on_or_below_the_line

HALF = Rational(1, 2)


def same_condition(linear: Any, passive: Any) -> Theorem:
    """(24) <=> (9), where t_d = d T."""
    late = assume(Eq(t_d, d * T))
    period = positive((d + HALF) * T > 0, [HALF, T > 0, shares()[1]])
    lag_ = combined(lag.DELAY > 0, [period], [late, -S.One])
    one, other = assume(linear), assume(passive)
    room = combined(b + B - K * (d + HALF) * T > 0, [lag_, one], [late, -K])
    back = combined(b + B - K * lag.DELAY > 0, [period, other], [late, K])
    apart = [*divisors(), positive(Ne(lag.DELAY, 0), [lag_])]
    there = closed(over(passive, room, period), *apart)
    return either_way(there, closed(over(linear, back, lag_), *apart), linear, passive)


@cache
def passive_on_the_line() -> Theorem:
    """A wall with (25), or on its border, is passive: d whole, alpha >= 0 and delta = b_D T/m.

    That is for beta <= delta d/(2d+3).
    """
    stiff, damped, late = map(assume, normalised(alpha, beta, d))
    lossy, period, mass = assume(Eq(delta, b_D * T / m)), assume(T > 0), assume(m > 0)
    square = positive(T**2 > 0, [period, period])
    spring, damper = over(m / T**2 > 0, mass, square), over(m / T > 0, mass, period)
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
    ahead = combined(d >= 0, [over(t_d / T >= 0, t_d >= 0, period)], [late, -S.One])
    apart = [positive(Ne(e, 0), [e > 0]) for e in (m, T)]
    apart += [positive(Ne(T**2, 0), [period, period])]
    below = assume(b + B - K * T * (d + HALF) >= 0)
    found = inst(passive_below(below), {b: b_D})
    return closed(found, room, pushes, small, ahead, *apart, *divisors())

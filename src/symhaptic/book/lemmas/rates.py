"""Walls that meet (5) at every frequency: in proportion to the damping, and to the rate."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.passivity import scaled


@cache
def with_damping_and_rate() -> tuple[Theorem, Theorem]:
    """(5) with y K, y B, y b <=> (5), and with y K, T/y <=> (5), for y, T > 0."""
    share, factor = over(1 / y > 0, one(), y > 0), assume(y > 0)
    then: Any = taken_apart(scaled(T / y))[2]
    damped, faster = (
        either_way(moved(*same.of, *first), moved(*same.of[::-1], *second), *same.of)
        for same, first, second in (
            (then.of[0], (omega, factor, S.One), (omega, share, S.One)),
            (then.of[1], (omega / y, S.One, share), (omega * y, S.One, factor)),
        )
    )
    apart = [positive(Ne(e, 0), e > 0) for e in (T, y)]
    return closed(damped, *apart), closed(faster, *apart)


def moved(known: Any, wanted: Any, frequency: Expr, times: Any, stretch: Any) -> Theorem:
    """(5) for one wall at every frequency, from that for another one, times a factor."""
    low, high = wanted.body.of[0].of
    ends: tuple[Proposition, ...] = known.body.of[0].at({omega: frequency}).of
    inside = [positive(end, [stretch, assume(p)]) for end, p in zip(ends, (low, high), strict=True)]
    there = at(assume(known), {omega: frequency}, *inside)
    return for_all([omega], [low, high], positive(wanted.body.of[1], [times, there]))

"""The claim of the interval of Sec. V-C, and its correction."""

from __future__ import annotations

from symhaptic.paper.propositions.prelude import *

END = Rational(1, 50)
"""Largest delta of (23)."""
ENDS = pi**2, pi**2 + Rational(1, 10000)
"""The published interval."""
SPRINGS = (gamma >= 0, delta >= 0, delta <= END)


def below(end: Expr) -> Proposition:
    """By (30) gamma is at most ``end``, for the dampers of (23)."""
    [thirty] = transcribed("eq30")
    return ForAll(
        (gamma, delta), implied(SPRINGS, Iff((proposition(thirty), proposition(gamma <= end))))
    )


@claims("s5c-interval")
def _below_an_interval(printed: Printed) -> Proposition:
    """Below an interval means below its lower end or below its upper end."""
    return Or(tuple(below(end) for end in ENDS))


def within() -> Proposition:
    """(30) bounds gamma by a number in the interval."""
    [thirty] = transcribed("eq30")
    limit = pi**2 + delta**2 / 4
    then = [
        Iff((proposition(thirty), proposition(gamma <= limit))),
        ENDS[0] <= limit,
        limit <= ENDS[1],
    ]
    return ForAll((gamma, delta), implied(SPRINGS, both(then)))

"""The delay that may be added to a wall until an arm of the range makes it unstable."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from symhaptic.bounds.safe import check, find, prove
from symhaptic.bounds.safe.arms import Loops
from symhaptic.bounds.safe.prove import Columns
from symhaptic.numeric.tracing.margin import max_delay

_LONGEST = 40
"""Periods beyond which no delay is looked at."""

_MASSES = 3
"""So many arms by mass are asked where to stop."""

_PIECES = 600
"""So many for each range of delays that is tried."""

_SHORTEST = Fraction(1, 2000)
"""Shorter ranges are not tried, in periods."""


def guessed(loops: Loops, K: float, B: float) -> float:
    """The largest delay in periods with which a wall is stable for some arms; not proved."""
    period = float(loops.period)
    masses, (least, _), stiffnesses = loops.hands
    loops = loops._replace(
        hands=(masses, (least, least), stiffnesses)
    )  # those of the least damping
    mass, damping, stiffness = np.array(list(find.arms(loops, _MASSES))).T
    heavy = period / mass
    found = max_delay(K * period * heavy, B * heavy, stiffness * period * heavy, damping * heavy)
    return min(float(np.min(found)), float(_LONGEST))


def borne(loops: Loops, K: float, B: float) -> tuple[Fraction, list[check.Certificate]]:
    """A delay in periods up to which a wall is stable for every arm, and what shows it.

    The wall is stable at the delay of the loops; from there on ranges of delays are shown.
    """
    at, step = loops.periods[0], Fraction(1, 16)
    goal = Fraction(0.985 * guessed(loops, K, B)).limit_denominator(10**6)
    column = Columns((B, B), (K,), K)
    shown: list[check.Certificate] = []
    while at < goal and step > _SHORTEST:
        end = min(goal, Fraction(int(at) + 1), at + step)
        ahead = loops._replace(periods=(at, end))
        found = prove.shown(ahead, column, _PIECES, 2**-10)
        claim = check.Certificate(ahead, column, found.cuts, found.angles, ((K, B),))
        if found.columns == column and check.recheck(claim):
            shown.append(claim)
            at, step = end, 2 * step
        else:
            step /= 2
    return at, shown

"""The claims of the words far higher, clearly larger and much smaller, with numbers."""

from __future__ import annotations

from symhaptic.notation import x, y
from symhaptic.notation.proposition import whole
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.ratio import BEST, outdoes, passive, stable
from symhaptic.paper.ranges import DAMPED

RATIOS = {
    S.Zero: {
        0: "17.830157",
        1: "9.343018",
        2: "6.444742",
        4: "4.121539",
        8: "2.579471",
        40: "1.149886",
    },
    STIFF: {
        0: "17.817170",
        1: "9.314686",
        2: "6.402199",
        4: "4.052440",
        8: "2.463848",
        40: "1.000181",
    },
}
"""Ratio of the largest stable to the largest passive stiffness for delta = 0.02, truncated."""
UNIT = Rational(1, 10**6)


def stiffer_than_passive() -> Proposition:
    """With every integer delay some stable wall is at least as stiff as all passive ones."""
    given = [gamma >= 0, delta > 0, whole(d)]
    some = outdoes(stable(d, BEST), passive(d), alpha <= x)
    return ForAll((gamma, delta, d), implied(given, some))


def between(spring: Rational, delay: int) -> Proposition:
    """The ratio for one arm and one delay lies between two neighbouring decimals."""
    low = Rational(RATIOS[spring][delay])
    more = outdoes(stable(delay, BEST), passive(delay), low * alpha < x)
    less = outdoes(passive(delay, BEST), stable(delay), alpha < (low + UNIT) * x)
    return both([more, less]).at({gamma: spring, delta: DAMPED})


@claims("s0-far-higher", "s5b-clearly-larger")
def _by_how_much(printed: Printed) -> Proposition:
    """Some stable wall is at least as stiff as all passive walls, and the ratio has these bounds.

    The numbers are for the arms of Fig. 12, delta = 0.02 without a spring and with gamma = 0.001,
    and for six integer delays.
    """
    numbers = [between(spring, delay) for spring, rows in RATIOS.items() for delay in rows]
    return both([stiffer_than_passive(), *numbers])


SIZES = {0: 100, 1: 41, 2: 27, 4: 16, 8: 9}
"""Lower bounds of the ratio of stable to passive damping, in Fig. 11."""


@claims("s5a-much-smaller")
def _dimensions_of_the_regions(printed: Printed) -> Proposition:
    """The ratios of stiffness and damping, for the arm and the five integer delays of Fig. 11.

    The ratio of the stiffnesses lies between two decimals. Some stable wall has more than the given
    multiple of the largest passive damping.
    """
    parts = []
    for delay, times in SIZES.items():
        damped = outdoes(stable(delay, BEST), passive(delay), times * beta < y)
        parts += [between(STIFF, delay), damped.at({gamma: STIFF, delta: DAMPED})]
    return both(parts)


LEFT = {(STIFF, DAMPED): "0.21654783", (S.Zero, S.Zero): "0.21050726"}
"""Ratio of the largest stable stiffness at d = 1 to that at d = 0, for two arms, truncated."""


def left_by_one_period() -> Proposition:
    """The share of the stable stiffness at one period of delay lies between two decimals."""
    parts = []
    for (spring, damper), digits in LEFT.items():
        low, unit = Rational(digits), Rational(1, 10**8)
        more = outdoes(stable(1, BEST), stable(0), low * alpha < x)
        less = outdoes(stable(0, BEST), stable(1), alpha < (low + unit) * x)
        parts += [p.at({gamma: spring, delta: damper}) for p in (more, less)]
    return both(parts)

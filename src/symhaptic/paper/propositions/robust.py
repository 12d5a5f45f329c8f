"""The claims of Sec. V-C on robustly stable walls, which are stable with every spring of (30)."""

from __future__ import annotations

from itertools import pairwise

import sympy as sp

from symhaptic.notation import x
from symhaptic.notation.proposition import whole
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.ratio import BEST, WALL, outdoes, passive, stable
from symhaptic.paper.propositions.stability import HEAVIER, LATER
from symhaptic.paper.ranges import DAMPED

NYQUIST = sp.pi**2 + delta**2 / 4
"""The spring of (30) as an equation."""


def robust(delay: Expr | int = d, wall: Sequence[Expr] = WALL) -> Proposition:
    """A wall is stable with every spring up to that of the Nyquist frequency."""
    springs = [gamma >= 0, gamma <= NYQUIST]
    return ForAll((gamma,), implied(springs, stable(delay, wall)))


@claims("s5c-every-spring")
def _no_stiffer_spring_destabilises(printed: Printed) -> Proposition:
    """A wall that is stable with every spring of (30) is stable with every spring.

    The claim is for every integer delay.
    """
    every = ForAll((gamma,), implied([gamma >= 0], STABLE))
    given = [delta >= 0, whole(d), robust()]
    return ForAll((alpha, beta, delta, d), implied(given, every))


@claims("s5c-robust-shrinks-sets")
def _delay_takes_robust_walls(printed: Printed) -> Proposition:
    """A wall that is robustly stable with an integer delay is so with a smaller one."""
    given = [delta >= 0, whole(d), whole(LATER), d <= LATER, robust(LATER)]
    return ForAll((alpha, beta, delta, d, LATER), implied(given, robust()))


@claims("s5c-robust-grows-sets")
def _damping_adds_robust_walls(printed: Printed) -> Proposition:
    """Inside (23) a robustly stable wall stays so with more damping, for an integer d."""
    given = [delta >= 0, delta < HEAVIER, HEAVIER <= DAMPED, whole(d), robust()]
    more = robust().at({delta: HEAVIER})
    return ForAll((alpha, beta, delta, HEAVIER, d), implied(given, more))


LONGEST = 8
"""The longest delay of Fig. 11."""


def stiffer(best: Proposition, others: Proposition) -> Proposition:
    """Some wall of the first kind is stiffer than all walls of the second kind."""
    return outdoes(best, others, alpha < x)


@claims("s5c-robust-shrinks")
def _stiffness_falls_with_the_delay(printed: Printed) -> Proposition:
    """The largest robustly stable stiffness falls with each period, for delta = 0.02, d = 0 to 8.

    Some robustly stable wall at d is stiffer than all such walls at d + 1.
    """
    parts = (stiffer(robust(n, BEST), robust(n + 1)) for n in range(LONGEST))
    return both(parts).at({delta: DAMPED})


DAMPERS = tuple(Rational(n, 200) for n in (1, 2, 4))
DELAYS = (0, 1, 2, 4, 8)


@claims("s5c-robust-grows")
def _stiffness_rises_with_the_damper(printed: Printed) -> Proposition:
    """The largest robustly stable stiffness rises from delta = 0.005 to 0.01 and 0.02.

    The claim is for the integer delays of Fig. 11.
    """
    parts = []
    for delay in DELAYS:
        for light, heavy in pairwise(DAMPERS):
            best, others = robust(delay, BEST), robust(delay)
            parts.append(stiffer(best.at({delta: heavy}), others.at({delta: light})))
    return both(parts)


CONSERVATIVE = {0: ("1.11", "1.118"), 1: ("1.053", "1.0532")}
"""Bounds of the ratio of the largest robustly stable to the largest passive stiffness."""
AT_MOST = {2: "1.0232", 4: "1.0083", 8: "1.0026"}
"""Upper bounds of the ratio for longer delays."""


def between(delay: int) -> Proposition:
    """The ratio for one delay, delta = 0.02, lies between these bounds."""
    low, high = map(Rational, CONSERVATIVE[delay])
    more = outdoes(robust(delay, BEST), passive(delay), low * alpha < x)
    return both([more.at({delta: DAMPED}), below(delay, high)])


def below(delay: int, high: Rational) -> Proposition:
    """This multiple of some passive wall is stiffer than all robustly stable walls."""
    less = outdoes(passive(delay, BEST), robust(delay), alpha < high * x)
    return less.at({delta: DAMPED})


@claims("s6-why-conservative")
def _stiff_springs_make_it_conservative(printed: Printed) -> Proposition:
    """Walls that are stable with all springs of (30) are hardly stiffer than passive walls.

    The claim gives numbers for delta = 0.02: two bounds for d = 0 and d = 1, and an upper bound for
    d = 2, 4 and 8.
    """
    longer = (below(delay, Rational(high)) for delay, high in AT_MOST.items())
    return both([*map(between, CONSERVATIVE), *longer])

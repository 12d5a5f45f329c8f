"""The claims on how much stiffer a stable wall can be than a passive one, Sec. V-B and VI.

The stable walls have no stiffest one, for their region is open.  That the largest stable stiffness
is more than c times the largest passive one says: there is a stable wall, of stiffness x, that is
more than c times as stiff as every passive wall.  That it is less than c times says: there is a
passive wall such that every stable one is less than c times as stiff.

All of it is in the units of Table I, with m = T = 1; delays are whole.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy import Rational, S

from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, x, y
from symhaptic.notation.proposition import Exists, ForAll, Proposition, Terms, both, implied
from symhaptic.paper.propositions.comparison import STABLE, transcribed
from symhaptic.paper.propositions.passivity import PASSIVE
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.ranges import DAMPED, STIFF
from symhaptic.paper.reading import Printed

WALL, BEST = (alpha, beta), (x, y)
ARM: Terms = {gamma: STIFF, delta: DAMPED}
"""The arm of Figs. 11 and 12, with the spring."""


def stable(delay: sp.Expr | int, wall: Sequence[sp.Expr] = WALL) -> Proposition:
    """A wall is stable with an arm of gamma and delta."""
    return STABLE.at({alpha: wall[0], beta: wall[1], d: S(delay)})


def passive(delay: sp.Expr | int, wall: Sequence[sp.Expr] = WALL) -> Proposition:
    """A wall is passive with a damper of delta."""
    return PASSIVE.at({K: wall[0], B: wall[1], b: delta, T: S.One, d: S(delay)})


def outdoes(best: Proposition, others: Proposition, *bounds: sp.Expr) -> Proposition:
    """There is a wall (x, y) such that for all other walls (alpha, beta) these bounds hold."""
    return Exists(BEST, both([best, ForAll(WALL, implied([others], both(bounds)))]))


def stiffer(delay: int, *bounds: sp.Expr) -> Proposition:
    """A stable wall beside all passive ones."""
    return outdoes(stable(delay, BEST), passive(delay), *bounds)


def not_stiffer(delay: int, *bounds: sp.Expr) -> Proposition:
    """A passive wall beside all stable ones, for the arm of the figures."""
    return outdoes(passive(delay, BEST), stable(delay), *bounds).at(ARM)


def on_the_range(*then: Proposition) -> Proposition:
    """For all gamma and delta of (23)."""
    return ForAll((gamma, delta), implied(transcribed("eq23"), both(then)))


@claims("s5b-eta-d0")
def _without_delay(printed: Printed) -> Proposition:
    """More than 17.8 times as stiff, eta < 0.0562, on all of (23).

    In the figures, where both numbers are read, it is less than 17.9 times, and eta > 0.0561.
    """
    times, eta = Rational("17.8"), Rational("0.0562")
    more = stiffer(0, times * alpha < x, alpha < eta * x)
    digits = not_stiffer(0, alpha < Rational("17.9") * x, Rational("0.0561") * alpha < x)
    return on_the_range(more, digits)


@claims("s5b-eta-d1")
def _one_period_late(printed: Printed) -> Proposition:
    """More than 9.3 times as stiff, eta < 0.1074, on all of (23).

    In the figures, where both numbers are read, it is less than 9.4 times, and eta > 0.1073.
    """
    times, eta = Rational("9.3"), Rational("0.1074")
    more = stiffer(1, times * alpha < x, alpha < eta * x)
    digits = not_stiffer(1, alpha < Rational("9.4") * x, Rational("0.1073") * alpha < x)
    return on_the_range(more, digits)


@claims("s6-stable-22")
def _stiffness_left_by_one_period(printed: Printed) -> Proposition:
    """Without delay some wall is stable such that with d = 1 all are below 22 % of it, on (23).

    In the figures, from which it is read, it rounds to 22 %: more than 21.5 % is left.
    """
    below = outdoes(stable(0, BEST), stable(1), alpha < Rational("0.22") * x)
    digits = outdoes(stable(1, BEST), stable(0), Rational("0.215") * alpha < x).at(ARM)
    return on_the_range(below, digits)

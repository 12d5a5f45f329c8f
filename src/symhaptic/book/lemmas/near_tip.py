"""The tip of a stable region between two stiffnesses: a stable wall, and none that is stiffer.

Where the tip is comes from a search; what is said of it is shown.
"""

from __future__ import annotations

from functools import cache

from sympy import Expr, Rational

from symhaptic.book.lemmas.outpaced import softer_than
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffest_stable import no_stiffer, numbers_known
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.numeric.tracing.extremes import max_stable_stiffness
from symhaptic.proof.theorems.kernel import Theorem, placed

Arm = tuple[Expr, Expr]
"""gamma and delta."""

CLOSE = Rational(1, 10**5)
"""How far the bound lies above the tip, as a share of it; the wall lies ten times as far below."""


def rounded(value: float, digits: int = 6) -> Rational:
    """A number with this many digits."""
    places = 10 ** (digits - len(str(int(abs(value)))) + 4)
    return Rational(round(value * places), places)


@cache
def tip(arm: Arm, delay: int) -> tuple[Rational, Rational, Rational]:
    """alpha, beta and theta of the tip, about."""
    spring, damper = map(float, arm)
    found = max_stable_stiffness(spring, damper, delay)
    return (rounded(float(found.alpha)), rounded(float(found.beta)), rounded(float(found.theta)))


@cache
def wall_below(arm: Arm, delay: int, share: Expr = 10 * CLOSE) -> tuple[tuple[Expr, Expr], Theorem]:
    """A wall that is softer than the tip by this share, and that it is stable."""
    stiffness, damping, _ = tip(arm, delay)
    wall = rounded(float(stiffness * (1 - share))), damping
    point = dict(zip((alpha, beta, gamma, delta, d), (*wall, *arm, Rational(delay)), strict=True))
    return wall, stable_at(point)


@cache
def none_above(arm: Arm, delay: int, share: Expr = CLOSE) -> tuple[Expr, Theorem]:
    """A stiffness above the tip by this share, and that alpha is smaller of every stable wall."""
    stiffness, damping, angle = tip(arm, delay)
    limit = rounded(float(stiffness * (1 + share)))
    here = dict(zip((gamma, delta), arm, strict=True))
    ranges = {s: (v, v) for s, v in here.items()}
    if delay == 0:  # one point of the circle is not enough
        found = placed(no_stiffer(0, (limit, damping), ranges), here)
    else:
        found = placed(softer_than(limit, delay, angle, ranges), here)
    return limit, numbers_known(found)

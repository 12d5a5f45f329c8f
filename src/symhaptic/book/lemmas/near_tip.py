"""The tip of a stable region between two stiffnesses: a stable wall, and none that is stiffer.

Where the tip is comes from a search; what is said of it is shown.
"""

from math import log

from symhaptic.book.lemmas.outpaced import softer_than
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffest_stable import no_stiffer
from symhaptic.numeric.tracing.extremes import max_stable_stiffness

Arm = tuple[Expr, Expr]
"""gamma and delta."""

CLOSE = Rational(1, 10**5)
"""How far the bound lies above the tip, as a share of it; the wall lies ten times as far below."""

FINE = Rational(1, 10**9)
"""The same where many digits are wanted."""


def rounded(value: float, digits: int = 9) -> Rational:
    """A number with this many decimals."""
    return Rational(round(value * 10**digits), 10**digits)


@cache
def tip(arm: Arm, delay: int, digits: int = 9) -> tuple[Rational, Rational, Rational]:
    """alpha, beta and theta of the tip, about."""
    spring, damper = map(float, arm)
    found = max_stable_stiffness(spring, damper, delay)
    stiffness, damping, angle = (
        rounded(float(v), digits) for v in (found.alpha, found.beta, found.theta)
    )
    return stiffness, damping, angle


def _digits(share: Expr) -> int:
    """Decimals that tell a tip from one that is this share away, and at least nine."""
    return max(9, 4 - int(log(abs(share), 10)))


@cache
def wall_below(arm: Arm, delay: int, share: Expr = 10 * CLOSE) -> tuple[tuple[Expr, Expr], Theorem]:
    """A wall that is softer than the tip by this share, and that it is stable."""
    digits = _digits(share)
    stiffness, damping, _ = tip(arm, delay, digits)
    wall = rounded(float(stiffness * (1 - share)), digits), damping
    point = dict(zip((alpha, beta, gamma, delta, d), (*wall, *arm, Rational(delay)), strict=True))
    return wall, stable_at(point)


@cache
def none_above(arm: Arm, delay: int, share: Expr = CLOSE) -> tuple[Expr, Theorem]:
    """A stiffness above the tip by this share, and that alpha is smaller of every stable wall."""
    digits = _digits(share)
    stiffness, damping, angle = tip(arm, delay, digits)
    limit = rounded(float(stiffness * (1 + share)), digits)
    here = dict(zip((gamma, delta), arm, strict=True))
    ranges = {s: (v, v) for s, v in here.items()}
    if delay == 0:  # one point of the circle is not enough
        found = inst(no_stiffer(0, (limit, damping), ranges), here)
    else:
        found = inst(softer_than(limit, delay, angle, ranges), here)
    return limit, numbers_known(found)

"""What a wall needs at its worst angle, as routines: that angle is searched for."""

from __future__ import annotations

import sympy as sp
from sympy import Expr, atan2, cos, floor, pi, sin, sqrt

from symhaptic.export.routine import Routine, Steps, choose
from symhaptic.export.search import crossing
from symhaptic.model import worst
from symhaptic.notation import alpha, beta, d, epsilon, l, psi

FLAT = sp.Rational(1, 2**31)
"""Relative distance to which a worst angle is found: what is needed is flat there."""

_WALL = (alpha, beta, l, epsilon)

_whole = sp.Eq(epsilon, 0)


def need() -> Routine:
    """The damping that the wall needs at an angle."""
    do = Steps()
    early, late = do("early", worst.straight(l)), worst.straight(l + 1)
    n = do("n", worst.between(early, late))
    root = do("root", sqrt(n * n + worst.extra()))
    return do.routine("Need", "the damping that the wall needs at the angle 2 psi",
                      worst.ARGUMENTS, choose(_whole, early, (n + root) / 2))  # fmt: skip


def steepness() -> Routine:
    """Whether that grows with the angle; negative beyond the angle in phase."""
    do = Steps()
    early, late = do("early", do.shared(worst.steepness(l))[0]), worst.steepness(l + 1)
    steep = do("steep", worst.between(early, late))
    rising = do("rising", worst.rising(sp.Function("Need")(*worst.ARGUMENTS), steep))
    double = 2 * psi
    delayed = atan2(epsilon * sin(double), 1 - epsilon + epsilon * cos(double))
    own = atan2(alpha * cos(psi), (alpha + 2 * beta) * sin(psi))
    phase = do("phase", (2 * (l + 1) * psi - pi) + delayed + own)
    fractional = choose(phase > 0, -sp.Abs(rising), rising)
    return do.routine("Steepness", "has the sign of the slope of Need, up to the angle in phase",
                      worst.ARGUMENTS, choose(_whole, early, fractional))  # fmt: skip


def worst_angle() -> Routine:
    """Half of the angle at which the wall needs most."""
    do = Steps()
    size = do("size", sp.Abs(alpha) + sp.Abs(beta))
    scale = do.nonzero(size)
    wall = do("stiffness", alpha / scale), do("damping", beta / scale)

    def slope(inner: Steps, at: Expr) -> Expr:
        return sp.Function("Steepness")(*wall, l, epsilon, at)

    psi = crossing(do, slope, sp.S.Zero, pi / (2 * (l + 1)), FLAT)
    return do.routine("WorstAngle", "half of the angle at which the wall needs most damping",
                      _WALL, psi)  # fmt: skip


def largest_need() -> Routine:
    """The damping that the wall needs, infinite if it pulls."""
    do = Steps()
    whole = do("whole", floor(d))
    part = do("part", d - whole)
    psi = do("psi", sp.Function("WorstAngle")(alpha, beta, whole, part))
    found = sp.Function("Need")(alpha, beta, whole, part, psi)
    return do.routine("LargestNeed", "the damping that the wall needs at its worst angle",
                      (alpha, beta, d), choose(alpha < 0, sp.oo, found))  # fmt: skip


def pushed() -> Routine:
    """A need, infinite if the wall pulls."""
    do, need = Steps(), sp.Symbol("need")
    return do.routine("Pushed", "the need, infinite for alpha < 0", (alpha, need),
                      choose(alpha < 0, sp.oo, need))  # fmt: skip


def whole_part() -> Routine:
    """Whole periods of a delay."""
    return Steps().routine("WholePart", "whole periods of a delay", (d,), floor(d))


def late_part() -> Routine:
    """The rest of them."""
    return Steps().routine("LatePart", "the fraction of a period in a delay", (d,), d - floor(d))


ROUTINES = (whole_part, late_part, need, steepness, worst_angle, largest_need, pushed)

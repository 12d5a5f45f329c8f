"""The largest stiffness of the explicit boundary in a ball, for a given plant and delay.

That the stable walls end there is shown in derivations/s5b_stiffest_undelayed.py and
s5b_stiffest_wall.py; here is only the arithmetic.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

import sympy as sp
from flint import arb, ctx
from sympy import Expr

from symhaptic.model import boundary, plant
from symhaptic.notation import a, e, n_0, n_1, phi, t
from symhaptic.numeric.tracing.extremes import max_stable_stiffness
from symhaptic.proof import box
from symhaptic.proof.ball import ball
from symhaptic.proof.certificate import Certificate, Known, Zero
from symhaptic.proof.derivative import derivative
from symhaptic.proof.enclosed import Enclosed, Source, value
from symhaptic.proof.recheck import confirm
from symhaptic.proof.roots import BITS, NoSuchRoot, zero

DEVICE = plant.Sampled(n_1, n_0, a, e)
"""A plant by the names of its numbers."""

STIFFNESS = boundary.stiffness(DEVICE, t, phi)
"""alpha on the boundary from t = tan(theta/2) and phi = (d+1) theta."""

_TOP, _BOTTOM = sp.symbols("top bottom")


@dataclass(frozen=True)
class Peak:
    """The largest value of a function on an interval, where it is, and what shows it."""

    at: arb
    value: arb
    certificates: tuple[Certificate, ...] = ()


@cache
def numbers(stiffness: Expr, damping: Expr) -> dict[Expr, arb]:
    """The plant's n_1, n_0, a and e in narrow balls, for one gamma and delta."""
    exact = plant.numbers(sp.sympify(stiffness), sp.sympify(damping))
    return {name: ball(value, None, BITS).real for name, value in exact.items()}


def undelayed(stiffness: Expr, damping: Expr) -> Enclosed:
    """The largest stable alpha without delay.

    >>> print(undelayed(sp.S.Zero, sp.Rational(1, 50)).ball.str(20, radius=False))
    0.71320631852136363205
    """
    exact = plant.numbers(sp.sympify(stiffness), sp.sympify(damping))
    return value(boundary.largest_undelayed(DEVICE), exact)


def over(one: Source, other: Source) -> Enclosed:
    """The ratio of two numbers.

    >>> print(over(sp.S.One, sp.Integer(3)).ball.str(20, radius=False))
    0.33333333333333333333
    """
    return value(_TOP / _BOTTOM, {_TOP: one, _BOTTOM: other})


def passive(damping: Expr, delay: int) -> Expr:
    """The largest passive alpha, (11): 2 delta tan(pi/(4 (d+1)))."""
    return 2 * damping * sp.tan(sp.pi / (4 * (delay + 1)))


@cache
def most(stiffness: Expr, damping: Expr, delay: int) -> Enclosed:
    """The largest stable alpha for one gamma, delta and whole delay.

    >>> print(most(sp.S.Zero, sp.Rational(1, 50), 122).ball.str(20, radius=False))
    0.00025542115172973515845
    """
    if delay == 0:
        return undelayed(stiffness, damping)
    tip = max_stable_stiffness(float(stiffness), float(damping), delay)
    peak = largest(stiffness, damping, delay, float(tip.theta) * (delay + 1))
    return Enclosed(peak.value, peak.certificates)


def largest(stiffness: Expr, damping: Expr, delay: int, near: float) -> Peak:
    """The largest alpha of the boundary for 0 < theta <= pi/(d + 1/2), and its angle.

    Next to ``near`` (d+1) theta the slope has one zero, by Newton's interval step, and falls; left
    and right of that the stiffness is smaller, by balls.  Raises where one of them fails.

    >>> print(largest(sp.S.Zero, sp.Rational(1, 50), 1, 1.1).value.str(20, radius=False))
    0.15480020462918854310
    """
    known = numbers(stiffness, damping)
    whole = sp.Integer(delay + 1)
    alpha, slope = _curve(delay)
    low, high, turn = _turning(slope, near, known)
    angle = turn.ball
    height = ball(alpha, {**known, phi: angle}, BITS).real
    confirm([turn])
    given = Known(known | {_TOP: height})
    shown = [
        box.positive(sign * slope, {phi: (side[0], side[1])}, given)
        for sign, side in ((1, low), (-1, high))
    ]
    end = sp.pi * whole / (whole - sp.S.Half)
    shown += [
        box.positive(_TOP - alpha, {phi: side}, given)
        for side in ((sp.S.Zero, low[0]), (high[1], end))
    ]
    confirm(shown)
    with ctx.workprec(BITS):
        return Peak(angle / int(whole), height, (turn, *shown))


@cache
def _curve(delay: int) -> tuple[Expr, Expr]:
    """The stiffness of the boundary at phi = (d+1) theta, and its slope there."""
    along = {t: sp.tan(phi / (2 * (delay + 1)))}
    by_t, by_phi = _slopes()
    slope = by_t * (1 + t**2) / (2 * (delay + 1)) + by_phi
    return STIFFNESS.xreplace(along), slope.xreplace(along)


@cache
def _slopes() -> tuple[Expr, Expr]:
    """The slope of the stiffness by t and by phi."""
    return derivative(STIFFNESS, t), derivative(STIFFNESS, phi)


Side: TypeAlias = tuple[Expr, Expr]


def _turning(slope: Expr, near: float, known: dict[Expr, arb]) -> tuple[Side, Side, Zero]:
    """The zero of the slope, with an interval to its left and one to its right."""
    middle = sp.Rational(round(near * 10**4), 10**4)
    for part in (10, 30, 100, 300):
        left, right = (middle * (1 + sp.Rational(s, part)) for s in (-1, 1))
        try:
            found = zero(slope, phi, left, right, known)
        except NoSuchRoot:
            continue
        return (middle * sp.Rational(3, 4), left), (right, middle * sp.Rational(5, 4)), found
    raise NoSuchRoot(f"no largest stiffness is shown near {near}")

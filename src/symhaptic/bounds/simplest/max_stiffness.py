"""The largest stable stiffness of all plants of a box, for a whole delay, in one ball.

Without delay it is a closed form (derivations/s5b_stiffest_undelayed.py).  With a delay the largest
value of the explicit boundary up to theta = pi/(d + 1/2) is taken: by the theorem of
s5b_stiffest_wall.py no stable wall is stiffer than a tip of the boundary.  That walls just below
the tip are stable is not shown in general.  The inequalities between the plant's numbers that keep
the boundary in shape are checked on the box itself.
"""

from __future__ import annotations

import math
from functools import lru_cache

import sympy as sp
from flint import arb
from sympy import Expr

from symhaptic.balls.zeros import narrowed
from symhaptic.bounds.balls import TooMany, pieces
from symhaptic.bounds.simplest.plants import (
    NAMES,
    Box,
    Formula,
    Found,
    Limit,
    NotCovered,
    NotEnclosed,
    Numbers,
    chained,
    compiled,
    numbers,
)
from symhaptic.bounds.walls import DEVICE, STIFFNESS
from symhaptic.model import boundary, jury
from symhaptic.notation import a, alpha, beta, e, gamma, n_0, n_1, phi, t
from symhaptic.numeric.tracing.extremes import max_stable_stiffness
from symhaptic.proof.derivative import derivative
from symhaptic.proof.plants import AT_ONE, BALLS, TOGETHER

_SOFT = 9
"""Below this gamma, and so below pi^2, n_1 >= n_0 (s4d_explicit_boundary_signs)."""


@lru_cache(maxsize=64)
def stiffest(delay: int) -> Limit:
    """The largest stable alpha behind a whole delay, on boxes of gamma and delta."""
    return _undelayed() if delay == 0 else _delayed(delay)


def _undelayed() -> Limit:
    largest = boundary.largest_undelayed(DEVICE).subs(gamma, AT_ONE / TOGETHER).subs(BALLS)
    value = compiled([largest])
    parts = compiled([derivative(largest, name) for name in NAMES])
    holds = compiled(_needs_undelayed())

    def limit(box: Box, hint: object = None) -> Found:
        x = numbers(*box[:2])
        _demand(holds(*x.values), box)
        by = parts(*x.values)
        slopes = chained(by, x.by_gamma), chained(by, x.by_delta)
        return Found(value(*x.values)[0], slopes)

    return limit


def _needs_undelayed() -> list[Expr]:
    """Positive: what s5b_stiffest_undelayed asks for, there shown on a box of its own."""
    _, second, third, _ = jury.criterion(jury.coefficients(0)).expressions
    rise = n_1 + n_0
    best = sp.sqrt(n_0 * (n_0 + e * n_1 - gamma * n_0 * n_1))
    top = {alpha: (rise - best) ** 2 / (n_0 * n_1**2) - gamma, beta: (best / n_0 - 1) / n_1}
    damping = rise * (1 - e) + gamma * n_0 * rise
    needs = (n_0, n_1, 4 * n_0 - damping, second.subs(top), third.subs(top), top[alpha])
    return [x.subs(BALLS) for x in needs]


def _needs_delayed(delay: int) -> list[Expr]:
    """Positive: what keeps the boundary in shape up to its tip."""
    rise = n_1 + n_0
    size = n_1 + (a + 2) * n_0
    turned = sp.cos(sp.pi / (2 * (delay + 1)))
    needs = (
        n_0**2 * (1 + a + e) - (n_1 - n_0) * size,
        rise * (1 + a + e) - 4 * (1 + e) * (n_1 - n_0),
        2 * n_0 - n_1,
        a - (1 + e) * turned,
        a,
        n_0,
    )
    return [x.subs(BALLS) for x in needs]


def _demand(values: list[arb], box: Box) -> None:
    if not box[0].high < _SOFT:
        raise NotCovered(f"gamma = k T^2/m up to {float(box[0].high):.3g}: no proof from 9 on")
    if any(value <= 0 for value in values):
        raise NotCovered("the spring or damper is too strong for the bounds of the stiffest wall")
    if not all(value > 0 for value in values):
        raise NotEnclosed("an inequality is not decided on the box")


def _delayed(delay: int) -> Limit:
    turn = STIFFNESS.subs(BALLS).subs(t, sp.tan(phi / (2 * (delay + 1))))
    curve = Formula(turn, phi)
    holds = compiled(_needs_delayed(delay))

    def limit(box: Box, hint: object = None) -> Found:
        x = numbers(*box[:2])
        _demand(holds(*x.values), box)
        tips = hint if isinstance(hint, arb) else _search(curve, x, delay, box)
        tips = _narrowed(curve, x, tips)
        middle = tips.mid()
        value = curve.value(middle, x).lower().union(curve.value(tips, x).upper())
        return Found(value, curve.by_plant(tips, x), tips)

    return limit


def _search(curve: Formula, x: Numbers, delay: int, box: Box) -> arb:
    """A ball of (d+1) theta with the largest alpha of every plant of the box in it.

    A largest value is not below one that is known, and has no slope.
    """
    spring, damper = (float(interval.middle) for interval in box[:2])
    near = float(max_stable_stiffness(spring, damper, delay).theta) * (delay + 1)
    end = math.nextafter(2 * math.pi * (delay + 1) / (2 * delay + 1), math.inf)
    if not 0 < near < end:
        raise NotEnclosed("no largest stiffness near the middle of the box")
    known = curve.value(arb(near), x).lower()
    if not (known > 0 and curve.value(arb(end), x) < known):
        raise NotEnclosed("the largest stiffness is not told from the end of the boundary")

    def may_be_largest(piece: arb) -> bool:
        slope = curve.slope(piece, x)
        return not (curve.value(piece, x) < known or slope > 0 or slope < 0)

    try:
        kept = pieces(end, may_be_largest)
    except TooMany:
        raise NotEnclosed("too many pieces of the boundary") from None
    if not kept:
        raise NotEnclosed("no largest stiffness between 0 and the end")
    return kept[0].union(kept[-1])


def _narrowed(curve: Formula, x: Numbers, tips: arb) -> arb:
    """The same by Newton's interval step, where the slope falls."""
    if not curve.bend(tips, x) < 0:
        return tips
    found = narrowed(lambda at: curve.slope(at, x), lambda at: curve.bend(at, x), tips)
    if found is None:
        raise NotEnclosed("no largest stiffness where it was sought")
    return found

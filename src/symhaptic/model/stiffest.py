r"""Where the explicit boundary reaches farthest: the slope of its stiffness, without divisions.

With :math:`t=\tan(\theta/2)`, A/z and M/z as in the form of the boundary, and
:math:`F=z^{l+3/2}A/M`, the stiffness on the boundary is
:math:`\alpha=-\Re F/\cos(\theta/2)`; chapter s5b_stiffest_wall.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy import Expr, Rational, cos, tan

from symhaptic.model import boundary, delayed
from symhaptic.model.entire import CosNext, SinNext
from symhaptic.model.plant import Sampled
from symhaptic.notation import a, d, e, l, m_0, m_1, m_2, n_0, n_1, theta

SLOPE_ARGUMENTS = (theta, l, *sp.symbols("at_one at_minus_one loss together apart across"))
"""The angle, the whole delay, and the device; across is n1, or m2 - m0."""


def slope() -> tuple[Expr, Expr]:
    """Has the sign of the derivative of alpha; and the positive number it has to be divided by."""
    angle, steps, at_one, at_minus_one, loss, together, apart, across = SLOPE_ARGUMENTS
    t = tan(angle / 2)
    above, above_j = at_one - at_minus_one * t**2, 2 * t * loss
    below, below_j = together - apart * t**2, 2 * t * across
    size, weight = above**2 + above_j**2, below**2 + below_j**2
    real, imaginary = above * below + above_j * below_j, above_j * below - above * below_j
    turned, grown = size * weight, 1 + t**2
    turns = (steps + Rational(3, 2)) * turned + grown * (
        loss * (at_one + at_minus_one * t**2) * weight - across * (together + apart * t**2) * size
    )
    swells = grown * (
        (2 * loss**2 - at_minus_one * above) * weight - (2 * across**2 - apart * below) * size
    )
    along, up = CosNext(2 * steps + 2, angle / 2), SinNext(2 * steps + 2, angle / 2)
    found = turns * (real * up + imaginary * along)
    found -= t * (swells + turned / 2) * (real * along - imaginary * up)
    return found, turned * weight * cos(angle / 2)


UNDELAYED = SLOPE_ARGUMENTS[2:7]
"""The device without a delay."""


def undelayed() -> tuple[Expr, Expr, Expr]:
    """The slope without delay as a parabola in tan(theta/2)^2, its square's coefficient first.

    Its last coefficient is positive: the stiffness rises at 0.
    """
    at_one, at_minus_one, loss, together, apart = UNDELAYED
    rest = 2 * apart - together
    turn = at_minus_one * rest + 2 * loss * apart
    square = turn * together**2 - apart**2 * (
        2 * at_minus_one * (together - apart) - at_one * rest + 4 * loss * (together - apart)
    )
    middle = 2 * together * (turn * together + at_one * apart**2)
    whole = at_minus_one * together**2 + at_one * ((together - apart) ** 2 + together**2)
    return square, middle, together * (whole + 2 * loss * together * (2 * together - apart))


@cache
def derived() -> tuple[tuple[Expr, Expr], ...]:
    """The slopes beside the derivatives of the derived boundary."""
    rise, factor = slope()
    numbers = (1 - a + e, 1 + a + e, 1 - e, m_2 + m_1 + m_0, m_2 - m_1 + m_0, m_2 - m_0)
    named = dict(zip(SLOPE_ARGUMENTS[2:], numbers, strict=True))
    t = tan(theta / 2)
    together, apart = UNDELAYED[3:]
    parabola = sum(k * t ** (4 - 2 * i) for i, k in enumerate(undelayed()))
    weight = (1 + t**2) * (together**2 + apart**2 * t**2) ** 2
    whole = dict(zip(UNDELAYED, (*numbers[:3], n_1 + n_0, n_1 - n_0), strict=True))
    early = (t * parabola / weight).xreplace(whole)
    exact = boundary.wall(Sampled(n_1, n_0, a, e))[0].subs(d, 0).diff(theta)
    return (
        ((rise / factor).xreplace(named), delayed.wall()[0].diff(theta)),
        (early, exact),
    )

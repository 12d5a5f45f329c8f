r"""Where the explicit boundary reaches farthest: the slope of its stiffness, without divisions.

With :math:`t=\tan(\theta/2)`, A/z and M/z as in the form of the boundary, and
:math:`F=z^{l+3/2}A/M`, the stiffness on the boundary is
:math:`\alpha=-\Re F/\cos(\theta/2)`; chapter s5b_stiffest_wall.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

import sympy as sp
from sympy import Expr, Rational, cos, tan

from symhaptic.forms import fractional_delay
from symhaptic.forms.entire import CosNext, SinNext
from symhaptic.model import boundary
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

EARLY = *UNDELAYED, sp.Symbol("last")
"""The device behind less than a period; last is m0, and 0 without a delay."""


def end() -> Expr:
    """Has the sign of the slope next to pi for delays below one period.

    Where it is small the maximum is next to pi, and a last place of it moves the maximum by many.
    """
    _, at_minus_one, loss, together, apart, last = EARLY
    side = together - 4 * last
    bent = side * (side**2 - 2 * apart * together) + apart**2 * together
    found = 4 * apart**2 * (2 * apart - side) - at_minus_one * bent
    return found - 2 * loss * apart * (apart * together - side**2)


def early() -> tuple[Expr, ...]:
    """The slope for delays below one period, as a quartic in tan(theta/2)^2, highest power first.

    Its last coefficient is positive: the stiffness rises at 0.  Made of m0, not of m2 - m0, and
    with 1 - a + e + 1 + a + e + 2 (1 - e) = 4, so that little cancels.
    """
    q, r, loss, s, apart, last = EARLY
    lean = r + 2 * loss
    third = (
        128 * r,
        -32 * (3 * r * s - 2 * apart * loss),
        -16 * (6 * apart**2 + apart * s * lean - 2 * r * s**2),
        4 * (4 * apart**3 - apart**2 * s * lean + 2 * apart * s**2 * (r + loss) - r * s**3),
    )
    second = (
        -64 * (3 * r + 4 * q + 8 * loss),
        16 * (apart * (8 * (r + q) + 18 * loss) + s * (5 * r + 9 * q + 16 * loss)),
        -4 * (28 * apart**2 + 8 * apart * s + s**2 * (r + 7 * q + 14 * loss)),
        2 * (4 * apart**3 - apart**2 * s * (lean - 2 * q) + apart * s**2 * (5 * r - q + 4 * loss))
        + 2 * s**3 * (q + 2 * loss - 2 * r),
    )
    first = (
        32 * q * s,
        -8 * s * (2 * apart * q + 12 * s),
        4 * s * (apart**2 * q + apart * s * (r - q) + s**2 * (q + 2 * loss)),
    )
    whole = (
        16 * q * s,
        4 * s * (s * (q + 2 * loss) - 2 * apart * q),
        s * (apart**2 * q - 2 * apart * s * (q + loss) + s**2 * (r + 2 * q + 4 * loss)),
    )
    return end(), *(_polynomial(c, last) for c in (third, second, first, whole))


def leaning(angle: Expr, numbers: Mapping[Expr, Expr]) -> Expr:
    """How far the zero of the quartic moves with its first coefficient, as an angle."""
    coefficients = [k.xreplace(dict(numbers)) for k in early()]
    slopes = [(4 - i) * k for i, k in enumerate(coefficients[:-1])]
    t = tan(angle / 2)
    return -(t**8) / (_polynomial(slopes, t**2) * t * (1 + t**2))


def _polynomial(coefficients: Iterable[Expr], at: Expr) -> Expr:
    """By Horner's rule, the highest power first."""
    found = sp.S.Zero
    for coefficient in coefficients:
        found = found * at + coefficient
    return found


def undelayed() -> tuple[Expr, Expr, Expr]:
    """The slope without delay as a parabola in tan(theta/2)^2, its square's coefficient first.

    Its last coefficient is positive: the stiffness rises at 0.
    """
    at_one, at_minus_one, loss, together, apart = UNDELAYED
    turn = at_minus_one * (2 * apart - together) + 2 * loss * apart
    middle = 2 * together * (turn * together + at_one * apart**2)
    whole = at_minus_one * together**2 + at_one * ((together - apart) ** 2 + together**2)
    last = together * (whole + 2 * loss * together * (2 * together - apart))
    return end().xreplace({EARLY[-1]: sp.S.Zero}), middle, last


@cache
def derived() -> tuple[tuple[Expr, Expr], ...]:
    """The slopes beside the derivatives of the derived boundary."""
    rise, factor = slope()
    numbers = (1 - a + e, 1 + a + e, 1 - e, m_2 + m_1 + m_0, m_2 - m_1 + m_0, m_2 - m_0)
    late = dict(zip((*SLOPE_ARGUMENTS[2:], EARLY[-1]), (*numbers, m_0), strict=True))
    whole = dict(zip(UNDELAYED, (*numbers[:3], n_1 + n_0, n_1 - n_0), strict=True))
    square = tan(theta / 2) ** 2
    together, apart, across = SLOPE_ARGUMENTS[5:]
    below = (together - apart * square) ** 2 + 4 * square * across**2
    quartic = _polynomial(early(), square) / ((1 + square) * below**2)
    below = (1 + square) * (together**2 + apart**2 * square) ** 2
    parabola = _polynomial(undelayed(), square) / below
    wall, without = fractional_delay.wall()[0], boundary.wall(Sampled(n_1, n_0, a, e))[0].subs(d, 0)
    return (
        ((rise / factor).xreplace(late), wall.diff(theta)),
        ((tan(theta / 2) * quartic).xreplace(late), wall.subs(l, 0).diff(theta)),
        ((tan(theta / 2) * parabola).xreplace(whole), without.diff(theta)),
    )

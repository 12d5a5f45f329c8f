r"""The stiffest wall that is passive at a fraction of a period, made of its worst angle.

With :math:`S=(1-\varepsilon)\sin(\ell+1)\theta+\varepsilon\sin(\ell+2)\theta`, the same of cosines
:math:`C` and :math:`\varrho=\delta/(\varepsilon(1-\varepsilon)\sin(\theta/2))` the walls that need
:math:`\delta` at an angle lie on a circle,

.. math:: (\alpha\cos(\theta/2)+\varrho S)^2+((\alpha+2\beta)\sin(\theta/2)-\varrho C)^2=\varrho^2,

as :math:`S^2+C^2+4\varepsilon(1-\varepsilon)\sin^2(\theta/2)=1`.  No wall of it is stiffer than
:math:`2\delta(1-S)/(\varepsilon(1-\varepsilon)\sin\theta)`, and so no passive wall is, whatever the
angle: the least of these bounds counts, where :math:`(1-S)\cos\theta+S'\sin\theta` vanishes.  There
what cancels next to a whole delay is known from :math:`S'`; chapter s6f_stiffest_passive_wall.
"""

from __future__ import annotations

from functools import cache

from sympy import Expr, S, cos, sin

from symhaptic.forms.entire import CosNext, SinNext, written_out
from symhaptic.forms.required_damping import between
from symhaptic.model import fractional
from symhaptic.notation import B, K, T, alpha, b, beta, delta, epsilon, l, theta

SHARE = epsilon * (1 - epsilon)
DELAYED = l + epsilon + 1
"""The delay and a period."""


def sine() -> Expr:
    """S."""
    return between(SinNext(l, theta), SinNext(l + 1, theta))


def cosine() -> Expr:
    """C."""
    return between(CosNext(l, theta), CosNext(l + 1, theta))


def falling(up: Expr, along: Expr) -> Expr:
    """Minus the slope of the bound, of S and C, times what is positive."""
    turning = DELAYED * along - SHARE * (CosNext(l, theta) - CosNext(l + 1, theta))
    return (1 - up) * cos(theta) + turning * sin(theta)


def wall(angle: Expr) -> tuple[Expr, Expr]:
    """The wall at the angle of the least bound."""
    half = sin(theta / 2)
    apart = 2 * half * SinNext(2 * l + 2, theta / 2)  # of both cosines
    top = 4 * DELAYED * half**2 + cosine() * apart
    share = top / (DELAYED * (1 + sine()) * sin(theta) + cosine() * cos(theta))
    damping = (apart - share * (1 + 2 * (l + epsilon) * half**2)) / (2 * DELAYED * half**2)
    known = {theta: angle}
    return 2 * delta * share.xreplace(known), delta * damping.xreplace(known)


@cache
def derived() -> tuple[tuple[Expr, Expr], ...]:
    """Pairs that are equal, of the wall that has the bound at any angle.

    It needs delta, with as much or as little damping not less, and its stiffness falls as
    :func:`falling` says; by as much as that is not 0 the computed wall is another one.
    """
    units = {K: alpha, B: beta, T: S.One, b: delta}
    margin = fractional.margin().xreplace(units)
    up, along, slope = map(written_out, (sine(), cosine(), falling(sine(), cosine())))
    stiffness = 2 * delta * (1 - up) / (SHARE * sin(theta))
    damping = (delta * along / (SHARE * sin(theta / 2) ** 2) - stiffness) / 2
    at = {alpha: stiffness, beta: damping}
    ours, other = map(written_out, wall(theta))
    below = DELAYED * (1 + up) * sin(theta) + along * cos(theta)
    off = 2 * delta * along * slope / (SHARE * sin(theta) * below)
    rest = 2 * delta * slope / (SHARE * sin(theta)) - off * cos(theta)
    return (
        (margin.xreplace(at), S.Zero),
        (margin.diff(beta).xreplace(at), S.Zero),
        (stiffness.diff(theta), -2 * delta * slope / (SHARE * sin(theta) ** 2)),
        (ours, stiffness - off),
        (ours + 2 * other, stiffness + 2 * damping - rest / (2 * DELAYED * sin(theta / 2) ** 2)),
    )

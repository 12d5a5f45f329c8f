r"""A loop in continuous time whose hold and delay are one first-order lag.

Delay :math:`t_d` and the half period of the hold make :math:`1/(1+t_es)` with
:math:`t_e=t_d+T/2`, and the backward difference becomes the derivative: the force is
:math:`(K+Bs)/(1+t_es)` times the position.
"""

from __future__ import annotations

import sympy as sp
from sympy import Expr

from symhaptic.model.plant import Plant
from symhaptic.notation import B, K, T, d, s, t_d, t_e

DELAY = t_d + T / 2
"""What t_e stands for."""

WALL = K + B * s
"""The wall without a sampler."""


def held() -> Expr:
    """The delay and the hold as they are, (1 - exp(-s T))/(s T) exp(-t_d s)."""
    return sp.exp(-t_d * s) * (1 - sp.exp(-s * T)) / (s * T)


def characteristic(device: Plant) -> tuple[Expr, ...]:
    """Coefficients of the loop's characteristic polynomial, the highest power of s first.

    >>> characteristic(Plant(stiffness=None))
    (m*t_e, b*t_e + m, B + b, K)
    """
    polynomial = device.characteristic * (1 + t_e * s) + WALL
    return tuple(sp.collect(c, t_e) for c in sp.Poly(polynomial, s).all_coeffs())


def margin(device: Plant) -> Expr:
    """Hurwitz' determinant per mass: positive where the third condition holds."""
    first, second, third, last = characteristic(device)
    return (second * third - first * last) / device.mass


def line(beta: Expr, delta: Expr, delay: Expr = d) -> Expr:
    """The alpha at which the linear condition is an equality, (beta + delta)/(delay + 1/2)."""
    return (beta + delta) / (delay + sp.Rational(1, 2))

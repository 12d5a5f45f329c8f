r"""The stability boundary beside the line of the linear condition.

Near :math:`z=1` every sampled device is
:math:`1/P=\gamma+s_1(z-1)+s_2(z-1)^2/(\nu+(1-\nu)z)`, and for a whole delay all that happens on
the unit circle is a polynomial in :math:`y=4\sin^2(\theta/2)`.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import sympy as sp
from sympy import Expr

from symhaptic.model import circle
from symhaptic.model.plant import Sampled
from symhaptic.notation import alpha, beta, d, delta, gamma, nu, s_1, s_2, z

CHORD = sp.Symbol("y")
"""4 sin(theta/2)^2, the square of the distance of a root on the circle from 1."""

GAP = s_1 - delta - gamma / 2
"""How far the boundary starts below the line."""

_TOP = nu + (1 - nu) * z


def surplus(stiffness: Expr = alpha, damping: Expr = beta, delay: Expr = d) -> Expr:
    """How far a wall lies above the line, beta + delta - (d + 1/2) alpha."""
    return damping + delta - (delay + sp.Rational(1, 2)) * stiffness


def near() -> Expr:
    """1/P in the numbers gamma, s_1, s_2 and nu."""
    return gamma + s_1 * (z - 1) + s_2 * (z - 1) ** 2 / _TOP


def numbers(device: Sampled) -> dict[Expr, Expr]:
    """nu, s_1 and s_2 of a sampled device with the spring gamma."""
    total = device.n1 + device.n0
    share, damping = device.n0 / total, (1 - device.e + gamma * device.n0) / total
    return {nu: share, s_1: damping, s_2: 1 / total - (1 - share) * damping}


class Arc(NamedTuple):
    """The boundary for a whole delay, times |nu + (1 - nu) z|^2: polynomials in the chord."""

    right: Expr
    """alpha + gamma."""
    up: Expr
    """beta."""
    above: Expr
    """beta + delta - (d + 1/2) alpha, the surplus over the line."""
    size: Expr
    """|nu + (1 - nu) z|^2 itself."""

    def coefficients(self, polynomial: Expr) -> list[Expr]:
        """Lowest power first."""
        return list(_coefficients(polynomial))


@lru_cache(maxsize=64)
def _coefficients(polynomial: Expr) -> tuple[Expr, ...]:
    found = circle.powers(polynomial, CHORD)
    return tuple(found.get(power, sp.S.Zero) for power in range(max(found) + 1))


@lru_cache(maxsize=16)
def arc(delay: int) -> Arc:
    """The boundary for a delay of so many whole periods.

    >>> arc(0).right.subs({gamma: 0, s_1: 0, s_2: 1, nu: sp.Rational(1, 2)})  # a free mass
    -y**2/2 + y
    """
    forced = (gamma + s_1 * (z - 1)) * _TOP + s_2 * (z - 1) ** 2
    product = circle.expanded(-(z**delay) * forced * _TOP.subs(circle.MIRRORED))
    size = circle.in_chord(circle.square(_TOP), CHORD)
    damping = circle.in_chord(circle.height(product), CHORD)
    stiffness = circle.in_chord(circle.real(product), CHORD) - damping * CHORD / 2
    above = damping + delta * size - (delay + sp.Rational(1, 2)) * stiffness
    return Arc(
        *(
            sp.collect(circle.expanded(part), CHORD)
            for part in (stiffness + gamma * size, damping, above, size)
        )
    )


def on_the_line(stiffness: Expr, delay: Expr | int) -> Expr:
    """The damping of the wall on the line, beta = (d + 1/2) alpha - delta."""
    return (delay + sp.Rational(1, 2)) * stiffness - delta

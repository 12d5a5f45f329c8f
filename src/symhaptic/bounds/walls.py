"""The largest stiffness of the explicit boundary without delay, and the passive one, in balls.

That the stable walls end there is shown in derivations/s5b_stiffest_undelayed.py; here is only the
arithmetic.
"""

from __future__ import annotations

import sympy as sp
from sympy import Expr

from symhaptic.model import boundary, plant
from symhaptic.notation import a, e, n_0, n_1, phi, t
from symhaptic.proof.enclosed import Enclosed, Source, value

DEVICE = plant.Sampled(n_1, n_0, a, e)
"""A plant by the names of its numbers."""

STIFFNESS = boundary.stiffness(DEVICE, t, phi)
"""alpha on the boundary from t = tan(theta/2) and phi = (d+1) theta."""

_TOP, _BOTTOM = sp.symbols("top bottom")


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

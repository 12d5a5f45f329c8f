r"""The wall that puts a root of the loop on the unit circle.

A root of the loop is a point where the wall equals -1/P, so that
alpha + beta (1 - 1/z) = Q with Q = -z^d/P(z).  On the unit circle, z = exp(j theta), real and
imaginary part give both parameters: each angle has one wall.
"""

from __future__ import annotations

import sympy as sp
from sympy import Expr

from symhaptic.model.passivity import on_circle, real_part
from symhaptic.model.plant import Sampled
from symhaptic.notation import d, theta, z


def needed(device: Sampled, delay: Expr = d) -> Expr:
    """Q = -z^d/P(z), what the wall must be at a root z."""
    return -(z**delay) / device.transfer


def solved(turned: Expr, angle: Expr = theta) -> tuple[Expr, Expr]:
    """(alpha, beta) of the wall that is ``turned`` = Q at z = exp(j angle).

    The coefficients of ``turned`` are real but for the exponentials.
    """
    real = real_part(turned)
    damping = (turned - real) / (sp.I * sp.sin(angle))
    return real - damping * (1 - sp.cos(angle)), damping


def wall(device: Sampled, angle: Expr = theta, delay: Expr = d) -> tuple[Expr, Expr]:
    """(alpha, beta) with a root at exp(j angle), for every real delay on the principal sheet.

    >>> from symhaptic.model.parts import Parts
    >>> from symhaptic.model import plant
    >>> free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    >>> [round(complex(value).real, 6) for value in wall(free, sp.pi/3, 0)]
    [0.666667, 0.666667]
    """
    return solved(on_circle(needed(device, delay), angle), angle)


def stiffness(device: Sampled, half: Expr, turn: Expr) -> Expr:
    r"""alpha of :func:`wall` in ``half`` = tan(theta/2) and ``turn`` = (d+1) theta, real.

    Written without cancellation where theta, damping and stiffness are small, so that balls see
    it; derivations/s5b_stiffest_wall.py shows that it is the same.

    >>> from symhaptic.model.parts import Parts
    >>> from symhaptic.model import plant
    >>> free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    >>> stiffness(free, *sp.symbols("t x"))
    4*t**2*cos(x)
    """
    total, apart = device.n1 + device.n0, device.n1 - device.n0
    loss, static = 1 - device.e, 1 - device.a + device.e
    heavy = (2 * (1 + device.e) - static) * half**2 - static
    along = total * sp.cos(turn) + apart * half * sp.sin(turn)
    across = total * sp.sin(turn) - apart * half * sp.cos(turn)
    return (heavy * along + 2 * loss * half * across) / (total**2 + apart**2 * half**2)


def largest_undelayed(device: Sampled) -> Expr:
    """Largest stable alpha without delay, of a mass with a damper and no or a soft spring.

    (n1 + n0 - sqrt(n0 r))^2/(n0 n1^2) - gamma with r = n0 + e n1 - gamma n0 n1 and
    gamma = (1 - a + e)/(n1 + n0), a supremum over all beta; derived in
    derivations/s4d_mass_with_damper.py and, with a spring, in s5b_stiffest_undelayed.py, for
    gamma <= 0.01 and delta <= 0.1.  It is too large for heavy damping, delta above about 3.5.

    >>> from symhaptic.model.parts import Parts
    >>> from symhaptic.model import plant
    >>> free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    >>> sp.expand(largest_undelayed(free))
    12 - 8*sqrt(2)
    """
    total = device.n1 + device.n0
    spring = (1 - device.a + device.e) / total
    rest = device.n0 + device.e * device.n1 - spring * device.n0 * device.n1
    root = sp.sqrt(device.n0 * rest)
    return (total - root) ** 2 / (device.n0 * device.n1**2) - spring

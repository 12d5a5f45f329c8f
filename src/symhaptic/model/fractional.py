r"""A delay that is no whole number of periods, :math:`t_d=(\ell+\varepsilon)T`.

The force that belongs to a sample arrives :math:`\ell` periods and a fraction
:math:`\varepsilon` of one later, so that it changes inside a period: the device is pushed by the
force before for :math:`\varepsilon T` and by the new one for the rest.  Nothing is approximated.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Matrix

from symhaptic.model import passivity, wall
from symhaptic.model.parts import FULL, Parts
from symhaptic.model.passivity import mirror, on_circle, real_part
from symhaptic.model.plant import Plant, Sampled, normalised, sampled
from symhaptic.notation import B, K, T, alpha, b, beta, d, epsilon, l, theta, z


@dataclass(frozen=True)
class Late:
    """P(z) = M(z)/(z A(z)) z^-l: position at the samples, from a force that arrives late."""

    m2: Expr
    m1: Expr
    m0: Expr
    device: Sampled
    """The same plant without delay, whose poles are the same."""

    @property
    def numerator(self) -> Expr:
        """M(z) = m2 z^2 + m1 z + m0."""
        return self.m2 * z**2 + self.m1 * z + self.m0

    @property
    def transfer(self) -> Expr:
        """P(z)."""
        return self.numerator / (z ** (l + 1) * self.device.denominator)


def late(plant: Plant, part: Expr = epsilon, split: Expr | None = None) -> Late:
    """Exact discrete equivalent of the plant (in units of the period) behind a late force.

    The state after one period is Phi(1) (x, v) + Phi(1 - part) Gamma(part) F_before
    + Gamma(1 - part) F, with F_before = F/z.
    """
    phi = plant.transition(sp.S.One, split)
    first = plant.held(1 - part, split)
    second = plant.transition(1 - part, split) * plant.held(part, split)
    # the first row of the adjugate of z - Phi is (z - Phi_22, Phi_12)
    return Late(
        m2=first[0],
        m1=phi[0, 1] * first[1] - phi[1, 1] * first[0] + second[0],
        m0=phi[0, 1] * second[1] - phi[1, 1] * second[0],
        device=sampled(plant, split=split),
    )


def characteristic(parts: Parts = FULL, part: Expr = epsilon, split: Expr | None = None) -> Expr:
    """The monic characteristic polynomial z^(l+2) A(z) + M(z) ((alpha+beta) z - beta)."""
    device = late(normalised(parts), part, split)
    push = (alpha + beta) * z - beta
    return z ** (l + 2) * device.device.denominator + device.numerator * push


# -- passivity ---------------------------------------------------------------------------


def between(left: Expr, right: Expr) -> Expr:
    """``left`` at the fraction 0, ``right`` at the fraction 1, and the straight line between."""
    return (1 - epsilon) * left + epsilon * right


def energy_form(angle: Expr = theta) -> Matrix:
    r"""The energy at one angle as a Hermitian matrix in p and q, per period.

    While one force is held the device moves by p, and the sample that this force belongs to a
    delay later is taken when a straight motion would have covered (1 - epsilon) p; q is how far
    the device is off then.  The damper burns at least b/T (p^2 + q^2/(epsilon (1 - epsilon))),
    and the force works H z^-(l+1) ((1/(z-1) + 1 - epsilon) p + q) on the displacement p.
    """
    force = wall.transfer() * z ** (-l - 1)
    straight = real_part(on_circle(force * (1 / (z - 1) + 1 - epsilon), angle))
    half = on_circle(force, angle) / 2
    return Matrix([[b / T + straight, half], [mirror(half), b / (T * epsilon * (1 - epsilon))]])


def required_straight(angle: Expr = theta) -> Expr:
    """The damping that straight motions need: on the line between two whole delays."""
    need = passivity.dirichlet_form(angle)
    return between(need.subs(d, l), need.subs(d, l + 1))


def stiffness_squared(angle: Expr = theta) -> Expr:
    """T^2 |H|^2 on the unit circle, an N^2 s^2/m^2: (K T)^2 + 4 B (K T + B) sin^2(theta/2)."""
    return (K * T) ** 2 + 4 * B * (K * T + B) * sp.sin(angle / 2) ** 2


def margin(angle: Expr = theta) -> Expr:
    """b^2 - b n - epsilon (1 - epsilon) T^2 |H|^2/4: not negative at any angle if passive."""
    extra = epsilon * (1 - epsilon) * stiffness_squared(angle) / 4
    return b**2 - b * required_straight(angle) - extra

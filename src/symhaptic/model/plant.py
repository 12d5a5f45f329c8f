r"""The mass-spring-damper, driven by a force that a zero-order hold keeps constant.

Newton's law :math:`m\ddot x + b\dot x + kx = F` as a state equation, its transition matrix by
Putzer's formula (no inverse, no Jordan form), and the exact samples of the response to a held
force.  Parts that are absent (``None``) do not occur; each case has its own poles.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy import Expr, Matrix

from symhaptic.model.parts import Parts
from symhaptic.notation import a, b, delta, e, gamma, k, m, n_0, n_1, s, t, z


@dataclass(frozen=True)
class Plant:
    """A mass with or without damper and spring; ``None`` stands for a part that is not there."""

    mass: Expr = m
    damping: Expr | None = b
    stiffness: Expr | None = k

    @property
    def characteristic(self) -> Expr:
        """m s^2 + b s + k, made of the parts that are there."""
        return self.mass * s**2 + s * (self.damping or 0) + (self.stiffness or 0)

    @property
    def state_matrix(self) -> Matrix:
        """A of d/dt (x, v) = A (x, v) + (0, 1/m) F, from Newton's law."""
        return Matrix(
            [[0, 1], [-(self.stiffness or 0) / self.mass, -(self.damping or 0) / self.mass]]
        )

    @property
    def input_matrix(self) -> Matrix:
        """The column by which the force enters the state."""
        return Matrix([0, 1 / self.mass])

    @property
    def split(self) -> Expr:
        """Difference of the two poles."""
        rate = (self.damping or 0) / self.mass
        if self.stiffness is None:
            return sp.sympify(rate)
        if self.damping is None:
            return 2 * sp.I * sp.sqrt(self.stiffness / self.mass)
        return sp.sqrt(rate**2 - 4 * self.stiffness / self.mass)

    def poles(self, split: Expr | None = None) -> tuple[Expr, Expr]:
        """The roots of the characteristic polynomial; ``split`` may name their difference."""
        rate = (self.damping or 0) / self.mass
        apart = self.split if split is None else split
        return (-rate + apart) / 2, (-rate - apart) / 2

    # -- motion under a constant force -------------------------------------------------

    def transition(self, time: Expr = t, split: Expr | None = None) -> Matrix:
        """exp(A t) by Putzer's formula: r1 + r2 (A - s1), for the poles s1 and s2."""
        one, two = self.poles(split)
        grows = sp.exp(one * time)
        shared = time * grows if one == two else (grows - sp.exp(two * time)) / (one - two)
        return sp.eye(2) * grows + (self.state_matrix - one * sp.eye(2)) * shared

    def held(self, time: Expr = t, split: Expr | None = None) -> Matrix:
        """State at ``time`` after rest, under a unit force: the integral of exp(A t) (0, 1/m)."""
        one, two = self.poles(split)
        if one == two:
            velocity = time * sp.exp(one * time)
            position = (
                time**2 / 2 if one == 0 else (1 + (one * time - 1) * sp.exp(one * time)) / one**2
            )
        else:
            velocity = (sp.exp(one * time) - sp.exp(two * time)) / (one - two)
            position = (_grown(one, time) - _grown(two, time)) / (one - two)
        return Matrix([position, velocity]) / self.mass


def _grown(pole: Expr, time: Expr) -> Expr:
    """The integral of exp(pole * tau) for tau from 0 to ``time``."""
    return time if pole == 0 else (sp.exp(pole * time) - 1) / pole


def normalised(parts: Parts) -> Plant:
    """The plant in units of the mass and the sampling period (Table I): 1, delta, gamma."""
    return Plant(sp.S.One, delta if parts.damping else None, gamma if parts.stiffness else None)


@dataclass(frozen=True)
class Sampled:
    """P(z) = (n1 z + n0)/(z^2 - a z + e): position at the samples, from the held force."""

    n1: Expr
    n0: Expr
    a: Expr
    e: Expr

    @property
    def numerator(self) -> Expr:
        """n1 z + n0."""
        return self.n1 * z + self.n0

    @property
    def denominator(self) -> Expr:
        """A(z) = z^2 - a z + e."""
        return z**2 - self.a * z + self.e

    @property
    def transfer(self) -> Expr:
        """P(z)."""
        return self.numerator / self.denominator


@cache
def sampled(plant: Plant, period: Expr = sp.S.One, split: Expr | None = None) -> Sampled:
    """Exact discrete equivalent of the plant behind a zero-order hold.

    The state after one period is Phi (x, v) + Gamma F, so that
    P(z) = (1, 0) (z - Phi)^-1 Gamma.
    """
    phi, force = plant.transition(period, split), plant.held(period, split)
    return Sampled(
        n1=force[0],
        n0=phi[0, 1] * force[1] - phi[1, 1] * force[0],
        a=phi[0, 0] + phi[1, 1],
        e=sp.exp(-period * (plant.damping or 0) / plant.mass),
    )


def numbers(stiffness: Expr, damping: Expr) -> dict[Expr, Expr]:
    """n_1, n_0, a and e of given gamma and delta; a part that is zero is not modelled."""
    found = sampled(normalised(Parts(stiffness=stiffness != 0, damping=damping != 0)))
    values = {gamma: sp.sympify(stiffness), delta: sp.sympify(damping)}
    four = {n_1: found.n1, n_0: found.n0, a: found.a, e: found.e}
    return {name: sp.sympify(value).xreplace(values) for name, value in four.items()}

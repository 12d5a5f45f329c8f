"""The virtual wall: a spring and a backward-difference damper, evaluated once per period."""

from __future__ import annotations

from sympy import Expr

from symhaptic.model.parts import Parts
from symhaptic.notation import B, K, T, alpha, beta, d, z


def force(now: Expr, before: Expr) -> Expr:
    """K x_k + B (x_k - x_(k-1))/T."""
    return K * now + B * (now - before) / T


def transfer() -> Expr:
    """H(z): the z-transform of the force, where a period of delay is a factor 1/z."""
    return force(1, 1 / z)


def delayed(delay: Expr = d) -> Expr:
    """H(z) z^-d."""
    return transfer() * z ** (-delay)


def normalised(parts: Parts) -> tuple[Expr, Expr]:
    """Numerator and denominator of T^2/m H(z) z^-d, as small as the scene admits.

    Without virtual damping there is no pole at 0 to share; without delay no factor z^d.
    """
    steps = d if parts.delay else 0
    if parts.virtual_damping:
        return (alpha + beta) * z - beta, z ** (steps + 1)
    return alpha, z**steps

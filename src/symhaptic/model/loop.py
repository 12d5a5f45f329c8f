r"""The closed loop: held wall force on the sampled plant, and its characteristic polynomial."""

from __future__ import annotations

from sympy import Expr

from symhaptic.model import plant, wall
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import T, a, alpha, beta, d, e, m, n_0, n_1, z


def characteristic(parts: Parts = FULL, split: Expr | None = None) -> Expr:
    """The monic characteristic polynomial A(z) z^(d+1) + (n1 z + n0) ((alpha+beta) z - beta).

    Each scene's polynomial is made of its own sampled plant and its own wall.  ``split`` may
    name the difference of the plant's poles, sqrt(delta^2 - 4 gamma).
    """
    return closing(plant.sampled(plant.normalised(parts), split=split), parts)


def closing(device: plant.Sampled, parts: Parts = FULL) -> Expr:
    """The same polynomial for a sampled plant whose numbers are given."""
    top, bottom = wall.normalised(parts)
    return device.denominator * bottom + device.numerator * top


def closed(parts: Parts = FULL, split: Expr | None = None) -> Expr:
    """Transfer function from the external force to the position: P/(1 + P H z^-d)."""
    device = plant.sampled(plant.normalised(parts), split=split)
    top, bottom = wall.normalised(parts)
    return T**2 / m * device.transfer / (1 + device.transfer * top / bottom)


def named() -> Expr:
    """The characteristic polynomial with the plant's numbers by name: a, e, n_1 and n_0."""
    return z ** (d + 1) * (z**2 - a * z + e) + (n_1 * z + n_0) * ((alpha + beta) * z - beta)

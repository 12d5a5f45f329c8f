"""gamma = k T^2/m, delta = b T/m, d = t_d/T: a device without units."""

from __future__ import annotations

from typing import Any, NamedTuple


class Dimensionless(NamedTuple):
    """The plant and the delay in units of the mass and the sampling period (Table I)."""

    gamma: float
    """k T^2/m, of device and arm together."""
    delta: float
    """b T/m, of device and arm together."""
    delay: float
    """t_d/T."""


def units(mass: Any, period: Any) -> tuple[Any, Any]:
    """m/T^2 and m/T: so large are a stiffness and a damping of 1."""
    return mass / period**2, mass / period


def per_unit(mass: Any, period: Any) -> tuple[Any, Any]:
    """T^2/m and T/m, by which a stiffness in N/m and a damping in Ns/m lose their units."""
    scale = period / mass
    return scale * period, scale

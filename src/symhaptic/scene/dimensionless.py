"""gamma = k T^2/m, delta = b T/m, d = t_d/T: a scene without units, and limits back in SI units."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache
from numbers import Real
from typing import TYPE_CHECKING, Any, NamedTuple

from symhaptic.notation.quantities import decimal, nearest, shown
from symhaptic.notation.sizes import LARGEST, LONGEST, STIFFEST
from symhaptic.scene.limit import Limit

if TYPE_CHECKING:
    from symhaptic.scene.scene import Scene


class Dimensionless(NamedTuple):
    """The plant and the delay in units of the mass and the sampling period (Table I)."""

    gamma: float
    """k T^2/m, of device and arm together."""
    delta: float
    """b T/m, of device and arm together."""
    delay: float
    """t_d/T."""


_WIDEST = 1e300
"""The largest unit of stiffness, and its inverse the smallest: beyond, no float holds a wall."""


def periods(scene: Scene) -> Fraction:
    """The delay in sampling periods, exactly; 0 if there is none."""
    if scene.delay_samples is not None:
        return decimal(scene.delay_samples)
    delay, period = scene.delay or 0.0, scene.sampling_period
    exact = decimal(delay) / decimal(period)
    # 3 * 1e-4 is not the number that 3e-4 is, but it is what three periods are in floats
    whole = Fraction(round(exact))
    return whole if nearest(whole) * period == delay else exact


@lru_cache(maxsize=256)
def dimensionless(scene: Scene) -> Dimensionless:
    """gamma and delta of device and arm together, and the delay in periods."""
    moved = scene.coupled
    period, mass = decimal(scene.sampling_period), decimal(moved.mass)
    if not all(1 / _WIDEST <= size <= _WIDEST for size in (period**2, mass / period**2)):
        raise ValueError(
            f"sampling_period: {scene.sampling_period!r} with mass={moved.mass!r} is not allowed; "
            f"T^2 and m/T^2 from {1 / _WIDEST:g} to {_WIDEST:g} are, in s^2 and N/m"
        )
    found = Dimensionless(
        gamma=nearest(decimal(moved.stiffness or 0) * period**2 / mass),
        delta=nearest(decimal(moved.damping or 0) * period / mass),
        delay=nearest(scene.periods),
    )
    late = "delay" if scene.delay_samples is None else "delay_samples"
    for name, own, formula, value, most in (
        ("stiffness", moved.stiffness, "k T^2/m", found.gamma, STIFFEST),
        ("damping", moved.damping, "b T/m", found.delta, LARGEST),
        (late, getattr(scene, late), "t_d/T", found.delay, LONGEST),
    ):
        if value > most:
            of = f"with mass={moved.mass!r} and sampling_period={scene.sampling_period!r}"
            given = f"{name}: {own!r} {of}"
            raise ValueError(f"{given} is not allowed; {formula} <= {most:g} is")
    return found


def units(mass: Any, period: Any) -> tuple[Any, Any]:
    """m/T^2 and m/T: so large are a stiffness and a damping of 1."""
    return mass / period**2, mass / period


def per_unit(mass: Any, period: Any) -> tuple[Any, Any]:
    """T^2/m and T/m, by which a stiffness in N/m and a damping in Ns/m lose their units."""
    scale = period / mass
    return scale * period, scale


@lru_cache(maxsize=256)
def wall_units(scene: Scene) -> tuple[float, float]:
    """T^2/m and T/m of device and arm together."""
    stiff, damped = per_unit(scene.coupled.mass, scene.sampling_period)
    return stiff, damped


def limit(scene: Scene, alpha: Any, beta: Any, theta: Any) -> Limit:
    """K = alpha m/T^2 in N/m, B = beta m/T in Ns/m, f = theta/(2 pi T) in Hz."""
    given = {"alpha": alpha, "beta": beta, "theta": theta}
    for name, value in given.items():
        if not isinstance(value, Real) and getattr(value, "shape", None) != ():
            raise ValueError(f"{name}: {shown(value)} is not allowed; one number is")
    period = scene.sampling_period
    unit_K, unit_B = units(scene.coupled.mass, period)
    return Limit(
        float(alpha) * unit_K,
        float(beta) * unit_B,
        float(theta) / (2 * math.pi * period),
    )

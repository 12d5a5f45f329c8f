"""A scene as a system of other tools: the sampled device with its arm and its delay, from N to m.

Exact for fractional delays, too: the held force then changes inside a period, which gives one more
coefficient (modified z-transform).
"""

from __future__ import annotations

import math
from typing import Any

from symhaptic.kernels import haptic
from symhaptic.notation.extras import needed
from symhaptic.notation.quantities import decimal
from symhaptic.scene.loop import DeviceLoop

_OF_THE_WALL = ("velocity", "virtual_mass")
"""Parts that are no part of the device."""


def coefficients(scene: DeviceLoop) -> tuple[list[float], list[float]]:
    """Numerator and denominator in z, the highest power first, of position over force in m/N.

    >>> from symhaptic.scene.scene import Scene
    >>> coefficients(Scene(mass=1.0, sampling_period=1.0, delay=1.0))
    ([0.5, 0.5], [1.0, -2.0, 1.0, 0.0])
    """
    scene.refuse_further("a system of another tool", *_OF_THE_WALL)
    gamma, delta, _ = scene.dimensionless
    steps = math.floor(scene.periods)
    part = float(scene.periods - steps)
    found = (
        haptic.discretize_fractional(gamma, delta, part)
        if part
        else haptic.discretize(gamma, delta)
    )
    *force, a, e = map(float, found)
    scale = scene.sampling_period**2 / scene.coupled.mass
    top = [scale * v for v in force]
    return top, [1.0, -a, e] + [0.0] * (steps + (part > 0))


def control_system(scene: DeviceLoop) -> Any:
    """As a ``control.TransferFunction``; needs python-control."""
    needed("Scene.to_control", "control")
    import control

    return control.TransferFunction(*coefficients(scene), scene.sampling_period)


def scipy_system(scene: DeviceLoop) -> Any:
    """As a ``scipy.signal.dlti``, which when it is made leaves out first coefficients below 1e-14.

    The numerator, in m/N, is therefore set afterwards; what converts it leaves them out with a
    warning.
    """
    from scipy.signal import dlti

    top, bottom = coefficients(scene)
    system = dlti([1.0], bottom, dt=scene.sampling_period)
    system.num = top
    return system


def sympy_system(scene: DeviceLoop) -> Any:
    """As an exact ``TransferFunction`` of SymPy, in z; floats are the decimals that they print as.

    >>> from symhaptic.scene.scene import Scene
    >>> system = sympy_system(Scene(mass=2.0, sampling_period=1.0, delay=1.0))
    >>> system.num, system.den
    (z/4 + 1/4, z*(z**2 - 2*z + 1))
    """
    import sympy as sp
    from sympy.physics.control import TransferFunction

    from symhaptic.model import fractional, plant
    from symhaptic.notation import z

    scene.refuse_further("a system of another tool", *_OF_THE_WALL)
    mass, damping, stiffness = map(_exact, scene.coupled)
    period = _exact(scene.sampling_period)
    exact = plant.Plant(
        sp.S.One, damping * period / mass or None, stiffness * period**2 / mass or None
    )
    delay = sp.Rational(*scene.periods.as_integer_ratio())
    steps = sp.floor(delay)
    if delay == steps:
        device = plant.sampled(exact)
        top, bottom = device.numerator, device.denominator * z**steps
    else:
        late = fractional.late(exact, part=delay - steps)
        top, bottom = late.numerator, late.device.denominator * z ** (steps + 1)
    return TransferFunction(sp.expand(period**2 / mass * top), bottom, z)


def _exact(value: float | None) -> Any:
    import sympy as sp

    return sp.Rational(*decimal(value or 0.0).as_integer_ratio())

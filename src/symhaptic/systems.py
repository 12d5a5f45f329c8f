"""A scene as a system of other tools: the device, sampled behind its delay, from N to m.

Exact, a fraction of a period included: the held force then changes inside a period, which gives
one more coefficient (modified z-transform), not an approximation of the delay.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.numeric.plant import device

if TYPE_CHECKING:
    from symhaptic.scene import Scene


def coefficients(scene: Scene) -> tuple[list[float], list[float]]:
    """Numerator and denominator in z, the highest power first, of position over force in m/N.

    >>> from symhaptic.scene import Scene
    >>> coefficients(Scene(mass=1.0, sampling_period=1.0, delay=1.0))
    ([0.5, 0.5], [1.0, -2.0, 1.0, 0.0])
    """
    gamma, delta, delay = scene.dimensionless
    steps = int(np.floor(delay))
    part = delay - steps
    given = np.atleast_1d(gamma), np.atleast_1d(delta), np.atleast_1d(part)
    x = device(*given)
    scale = scene.sampling_period**2 / scene.mass
    top = [scale * float(v[0]) for v in ((x.m2, x.m1, x.m0) if part else (x.m2, x.m1))]
    return top, [1.0, -float(x.a[0]), float(x.e[0])] + [0.0] * (steps + (part > 0))


def control_system(scene: Scene) -> Any:
    """As a ``control.TransferFunction``; needs python-control."""
    import control

    return control.TransferFunction(*coefficients(scene), scene.sampling_period)


def scipy_system(scene: Scene) -> Any:
    """As a ``scipy.signal.dlti``."""
    from scipy.signal import dlti

    return dlti(*coefficients(scene), dt=scene.sampling_period)


def sympy_system(scene: Scene) -> Any:
    """As an exact SymPy expression in z: the scene's numbers are taken as the fractions they are.

    >>> from symhaptic.scene import Scene
    >>> sympy_system(Scene(mass=2.0, sampling_period=1.0))
    (z/2 + 1/2)/(2*(z**2 - 2*z + 1))
    """
    import sympy as sp

    from symhaptic.model import fractional, plant
    from symhaptic.notation import delta, epsilon, gamma, l

    period, mass = (sp.Rational(v) for v in (scene.sampling_period, scene.mass))
    own = plant.normalised(scene.parts)
    given = {
        gamma: sp.Rational(scene.stiffness or 0) * period**2 / mass,
        delta: sp.Rational(scene.damping or 0) * period / mass,
    }
    damping = None if own.damping is None else given[delta]
    stiffness = None if own.stiffness is None else given[gamma]
    exact = plant.Plant(sp.S.One, damping or None, stiffness or None)
    delay = sp.Rational(scene.delay or 0) / period
    steps = sp.floor(delay)
    if delay == steps:
        from symhaptic.notation import z

        found = plant.sampled(exact).transfer * z**-steps
    else:
        found = fractional.late(exact, part=delay - steps).transfer.subs({l: steps})
    return period**2 / mass * found.subs(epsilon, delay - steps)

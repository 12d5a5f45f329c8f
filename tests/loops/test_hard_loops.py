"""Loops whose polynomials lose digits: modes far apart, walls near z = -1, touching curves."""

import mpmath as mp
import numpy as np
import pytest
from loops.oracle import device, difference_equation, matrix
from scipy import signal

from symhaptic import Average, Filter, LinearDevice, Scene
from symhaptic.loops import count
from symhaptic.loops.actuator import Lag
from symhaptic.loops.engine import Engine


@pytest.fixture(params=["compiled", "numpy"])
def either(request, monkeypatch):
    """Both implementations of the count."""
    if request.param == "numpy":
        monkeypatch.setattr(count, "_count", None)


def test_modes_from_8_hz_to_2_khz_keep_their_digits():
    """The poles of the sampled device are exp(s T) of those of the device."""
    period, poles = mp.mpf("0.00025"), []
    top, bottom = np.zeros(1), np.ones(1)
    for hz, ratio in ((8.0, 0.002), (17.0, 0.2), (73.0, 0.01), (400.0, 0.3), (1600.0, 0.08)):
        omega = 2 * np.pi * hz
        top = np.polyadd(np.polymul(top, [1, 2 * ratio * omega, omega**2]), bottom)
        bottom = np.polymul(bottom, [1, 2 * ratio * omega, omega**2])
    poles = mp.polyroots([mp.mpf(x) for x in bottom], maxsteps=200, extraprec=200)
    dynamics = LinearDevice.of(signal.lti(top, bottom))
    loop = Scene(dynamics=dynamics, sampling_period=float(period)).engine.loop
    wanted = [mp.mpc(1)]
    for pole in poles:  # times w + 1 - exp(s T)
        less = -mp.expm1(pole * period)
        wanted = [less * a + b for a, b in zip([*wanted, 0], [0, *wanted], strict=True)]
    np.testing.assert_allclose(loop.A, [float(mp.re(x)) for x in wanted], rtol=1e-12)


@pytest.mark.usefixtures("either")
def test_a_stiff_wall_next_to_a_root_at_minus_one():
    """|W| nearly vanishes at z = -1, and its square has no digits left there: two roots outside."""
    above = (1.304547655, 2.591456634, 3.812027182, 1.470247616, 0.284291830, 0.031276102)
    below = (1.0, 2.317847125, 2.802499876, 2.329607922, 1.022428065, 0.018132040, 0.005009259)
    above = tuple(x * sum(below) / sum(above) for x in above)
    engine = Engine(1.3e-3, 5e-4, 0.0, 1.0, 1.0, Filter(above, below), virtual_mass=0.007)
    wall, kind = difference_equation(above, below)
    kind = {**kind, "past": max(kind["past"], 3)}
    for K in 10 ** np.linspace(2, 5, 25):
        roots = np.linalg.eigvals(
            matrix(*device(1.3e-3, 5e-4), K, 1e-4, 0.0, wall, kind, virtual_mass=0.007)
        )
        assert np.sum(np.abs(roots) > 1) == engine.unstable_roots(K, 1e-4), K


@pytest.mark.usefixtures("either")
@pytest.mark.parametrize("beyond", [1e-9, 1e-7, 1e-5])
def test_curves_that_just_touch(beyond):
    """|A| = |W| at two angles next to each other, between which a resonance leaves the circle."""
    scene = Scene(
        mass=0.3568822014687973,
        damping=35.665115107632495,
        stiffness=4978390.55531729,
        sampling_period=1e-4,
        velocity=Average(5),
        actuator=Lag(time_constant=0.0018928039027348395),
    )
    B = 0.00618314265581244
    limit = scene.limit_at(B).K
    assert limit == pytest.approx(956450.1309876227, rel=1e-13)  # bisected with 80 digits
    assert scene.is_stable(limit * (1 - beyond), B)
    assert not scene.is_stable(limit * (1 + beyond), B)

"""Passive walls with a filtered velocity, beside (4) of the paper in 40 digits and closed forms."""

import mpmath as mp
import numpy as np
import pytest
from loops.test_boundary import filters

from symhaptic import Average, Filter, LowPass, Scene, Window
from symhaptic.loops.engine import Engine
from symhaptic.loops.passive import Needs
from symhaptic.loops.velocity import Difference

VELOCITIES = {
    "difference": Difference(),
    "Tustin": LowPass(time_constant=2.5, mapping="Tustin"),
    "second order": LowPass(time_constant=2.0, order=2),
    "long window": Window(12),
}


@pytest.mark.parametrize("delay", [0, 3])
@pytest.mark.parametrize("name", VELOCITIES)
def test_what_each_angle_needs_is_condition_4(name, delay):
    """T/(2 (1 - cos theta)) Re{(1 - exp(-j theta)) exp(-j d theta) H}, printed in the paper."""
    needs = Needs(VELOCITIES[name], delay, 1.0, virtual_mass=0.2)
    for theta in (1e-7, 1e-3, 0.4, 2.0, 3.14):
        with mp.workdps(40):
            z = mp.expj(mp.mpf(theta))
            turn = (1 - 1 / z) * z**-delay / (2 * (1 - mp.cos(mp.mpf(theta))))
            wanted = [mp.re(turn * h) for h in (1, filters(z)[name], (1 - 1 / z) ** 2 / 5)]
        found = needs.at(np.array([theta]))
        for told, true in zip(found, wanted, strict=True):
            assert told[0] == pytest.approx(float(true), rel=1e-13, abs=1e-15)


@pytest.mark.parametrize("pole", [0.0, 0.5, 0.9, 0.99, 1 - 2**-20, 1 - 2**-34, 1 - 2**-50])
def test_an_exponential_average(pole):
    """b >= K T/2 + B (1 - f)/(1 + f) for B >= 0, and b >= K T/2 + |B| for B < 0.

    The second one is that of ever slower motions, which the slowest filter passes.
    """
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, velocity=LowPass(weight=1 - pole))
    for B in (0.3, 0.0, -0.3):
        need = B * (1 - pole) / (1 + pole) if B >= 0 else -B
        limit = 2 * (0.5 - need) / 1e-3
        assert scene.max_passive_stiffness(B=B) == pytest.approx(limit, rel=1e-12)
        assert scene.is_passive(limit * (1 - 1e-9), B)
        assert not scene.is_passive(limit * (1 + 1e-9), B)
    assert not scene.is_passive(-1.0, 0.0)


@pytest.mark.parametrize("samples", [2, 4, 5, 50, 200])
def test_means_of_any_length(samples):
    """A mean and the window are one filter; no wall needs less than a thousand angles say."""
    wall = 0.01, 0.2
    needs = [Needs(one(samples), 2, 1.0).required(*map(np.array, wall))[0][0]
             for one in (Average, Window)]  # fmt: skip
    assert needs[0] == needs[1]
    theta = np.linspace(1e-4, np.pi, 1000)
    z = np.exp(1j * theta)
    force = wall[0] + wall[1] * (1 - z**-samples) / samples
    each = ((1 - 1 / z) * z**-2 * force).real / (2 - 2 * np.cos(theta))
    assert each.max() * (1 - 1e-9) <= needs[0] <= each.max() * 1.001


def test_a_virtual_mass_is_passive_up_to_half_of_b_t():
    for M, passive in ((2.49e-4, True), (2.51e-4, False)):
        scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, virtual_mass=M)
        assert scene.is_passive(0.0, 0.0) == passive


def test_the_stiffest_wall_is_the_largest_limit():
    engine = Engine(0.0, 0.5, 2.0, 1.0, 1.0, LowPass(weight=0.3))
    K, B, _ = engine.needs.stiffest(0.5)
    others, _ = engine.needs.limits(np.linspace(*engine.needs.without_stiffness(0.5), 40), 0.5)
    assert np.nanmax(others) <= K * (1 + 1e-12)
    assert engine.is_passive(np.array(K), np.array(B))


@pytest.mark.parametrize(
    ("part", "why"),
    [
        ({"delay": 0.0015}, "with a filter condition (4) needs an integer delay"),
        ({"integrator": "explicit Euler"}, "a simulator is no device"),
    ],
)
def test_where_passivity_cannot_be_told_it_says_so(part, why):
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, velocity=LowPass(weight=0.5), **part)
    with pytest.raises(ValueError, match="passivity is not computed, ask for stability") as caught:
        scene.is_passive(1.0, 0.0)
    assert why in str(caught.value)
    assert "not computed" in scene.describe()


@pytest.mark.parametrize("delay", [0, 2])
@pytest.mark.parametrize(
    "velocity", [LowPass(time_constant=1e12), LowPass(time_constant=1e12, order=2)]
)
def test_a_negative_damping_is_not_passive_however_slow_the_filter(velocity, delay):
    """Ever slower motions need -B + K T (d + 1/2): H is K + B (1 - 1/z)/T there."""
    scene = Scene(
        mass=0.1, damping=0.5, sampling_period=1e-3, delay_samples=delay, velocity=velocity
    )
    assert not scene.is_passive([0.0, 1.0], -0.5 * (1 + 1e-12)).any()
    assert scene.passivity_margin(0.0, -1.0) == pytest.approx(-0.5, rel=1e-12)
    limit = 0.2 / (1e-3 * (delay + 0.5))
    assert scene.max_passive_stiffness(B=-0.3) <= limit * (1 + 1e-12)


def test_what_slow_motions_need_is_that_of_the_coefficients_as_given():
    """Their sums are equal, so that the filter passes ever slower motions as they are.

    As floats the sum below is 1.87922016241515e-05: 2e-11 less.
    """
    below = [1.0, 1.4595808554542, -0.004299457318180555, -1.4612177772405268, -0.9940448286938681]
    needs = Needs(Filter([1.8792201624545e-05], below), 0, 1.0)
    assert needs.at(np.zeros(1))[1][0] == -1.0


def test_a_filter_is_stable_by_its_coefficients_as_given():
    """Their sum is -1e-16, p(1), and p(z) > 0 for large z: there is a root z > 1.

    Roots in floats all have |z| < 1 - 1e-6.
    """
    with pytest.raises(ValueError, match="give a stable filter"):
        Filter([-1e-16], [1.0, -2.999972624, 2.9999452480602855, -0.9999726240602856])


@pytest.mark.parametrize("apart", [1e-2, 1e-4, 1e-6])
@pytest.mark.parametrize("angle", [0.1, 0.8, 2.5])
def test_a_resonance_of_the_filter_is_not_missed(angle, apart):
    """Its peak is as narrow as its pole is near to the circle; a wall needs what it needs there."""
    pole = 1 - apart
    below = [1.0, -2 * pole * np.cos(angle), pole**2]
    needs = Needs(Filter([sum(below)], below), 1, 1.0)
    theta = angle + apart * np.linspace(-30, 30, 2001)
    z = np.exp(1j * theta)
    V = (1 - 1 / z) * sum(below) / (below[0] + below[1] / z + below[2] / z**2)
    for K, B in ((0.1, 0.3), (0.1, -0.3)):
        each = ((1 - 1 / z) / z * (K + B * V)).real / (2 - 2 * np.cos(theta))
        assert needs.required(np.array(K), np.array(B))[0][0] >= each.max() * (1 - 1e-6)

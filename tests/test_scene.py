"""Scenes in SI units beside the eigenvalues of the loop built in SI units, and what they refuse."""

import numpy as np
import pytest
from scipy.linalg import expm

from symhaptic import Scene


def spectral_radius(K, B, m, b, k, T, periods):
    """State matrix of the sampled loop in SI units: x, v, the last x and the forces under way."""
    moved = expm(np.array([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]]) * T)
    size = 3 + periods
    loop = np.zeros((size, size))
    loop[:2, :2], loop[2, 0] = moved[:2, :2], 1
    force = np.zeros(size)
    force[0], force[2] = -(K + B / T), B / T
    if periods:
        loop[:2, 2 + periods] += moved[:2, 2]
        loop[3] = force
        for i in range(1, periods):
            loop[3 + i, 2 + i] = 1
    else:
        loop[:2] += np.outer(moved[:2, 2], force)
    return np.abs(np.linalg.eigvals(loop)).max()


DEVICE = {"mass": 0.15, "damping": 0.3, "stiffness": 40.0, "sampling_period": 0.0012}


@pytest.mark.parametrize("periods", [0, 1, 2, 5])
def test_the_largest_stiffness_is_lost_by_a_little_more_of_it(periods):
    scene = Scene(**DEVICE, delay=periods * DEVICE["sampling_period"])
    gamma, delta, delay = scene.dimensionless
    assert delay == pytest.approx(periods)
    K = scene.max_stable_stiffness()
    m, b, k, T = (DEVICE[n] for n in ("mass", "damping", "stiffness", "sampling_period"))

    def largest(factor):  # the best damping B for K, among many
        trial = np.linspace(0, 3 * m / T, 400)
        return min(spectral_radius(factor * K, B, m, b, k, T, periods) for B in trial)

    assert gamma == pytest.approx(k * T**2 / m)
    assert delta == pytest.approx(b * T / m)
    assert largest(0.97) < 1 < largest(1.001)


def test_the_delay_margin_in_seconds():
    """K and B that bear 4.4 ms, by eigenvalues at 4 and at 5 whole periods of 1 ms."""
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
    margin = scene.delay_margin(K=1000.0, B=5.0)
    assert 4e-3 < margin < 5e-3
    assert spectral_radius(1000.0, 5.0, 0.1, 0.5, 0.0, 1e-3, 4) < 1
    assert spectral_radius(1000.0, 5.0, 0.1, 0.5, 0.0, 1e-3, 5) > 1


def test_twice_the_sampling_frequency_four_times_the_stiffness():
    """s4d-quadratic-in-period, for a free mass without delay."""
    once = Scene(mass=0.1, sampling_period=1e-3).max_stable_stiffness()
    twice = Scene(mass=0.1, sampling_period=0.5e-3).max_stable_stiffness()
    assert twice == pytest.approx(4 * once, rel=1e-12)


def test_the_passive_stiffness_is_two_dampings_per_period():
    """Colgate and Schenkel without delay: b > K T/2."""
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
    assert scene.max_passive_stiffness() == pytest.approx(2 * 0.5 / 1e-3, rel=1e-9)


def test_what_is_left_out_is_not_modelled():
    scene = Scene(mass=1.0, sampling_period=1e-3, damping=0.0)
    assert scene.parts.damping
    assert not scene.parts.stiffness
    assert not scene.parts.delay
    assert scene.dimensionless == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("name", ["mass", "sampling_period", "damping", "stiffness", "delay"])
@pytest.mark.parametrize("bad", [-1.0, np.nan, np.inf, "1", 1j, [1.0]])
def test_an_impossible_number_is_named(name, bad):
    given = {"mass": 1.0, "sampling_period": 1e-3} | {name: bad}
    with pytest.raises(ValueError, match=f"^{name}: .+ is not allowed; finite numbers >=? 0 are$"):
        Scene(**given)


@pytest.mark.parametrize("name", ["mass", "sampling_period"])
def test_no_mass_and_no_period_are_impossible(name):
    given = {"mass": 1.0, "sampling_period": 1e-3} | {name: 0}
    with pytest.raises(ValueError, match=f"^{name}: 0 is not allowed; finite numbers > 0 are$"):
        Scene(**given)


@pytest.mark.parametrize("bad", [np.nan, np.inf, "1", None])
def test_a_wall_of_no_number_is_named(bad):
    scene = Scene(mass=1.0, sampling_period=1e-3)
    with pytest.raises(ValueError, match=r"^K: .+ is not allowed; finite numbers are$"):
        scene.delay_margin(K=bad, B=1.0)
    with pytest.raises(ValueError, match=r"^B: .+ is not allowed; finite numbers are$"):
        scene.delay_margin(K=1.0, B=bad)

"""The passivity margin at one angle, and the device behind a fraction of a period."""

import math

import mpmath
import numpy as np
import pytest

import symhaptic
from symhaptic import discretize, discretize_fractional, passivity_margin, passivity_margin_at
from symhaptic.kernels import haptic

RNG = np.random.default_rng(19)
WALLS = [(1.0, 0.3, 0.4), (0.02, 0.5, 0.1), (0.3, -0.7, 1.0), (-0.2, 0.1, 0.5), (0.0, 0.0, 0.2)]


def printed(theta, alpha, beta, delta, delay):
    """(5) of the paper: b > K T sin((d + 1/2) theta)/(2 sin(theta/2)) - B cos((d + 1) theta)."""
    theta, alpha, beta, delta = map(mpmath.mpf, (theta, alpha, beta, delta))
    spring = alpha * mpmath.sin((delay + 0.5) * theta) / (2 * mpmath.sin(theta / 2))
    return delta - spring + beta * mpmath.cos((delay + 1) * theta)


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("delay", [0, 1, 2, 7])
def test_whole_delays_are_as_printed(wall, delay):
    """As numbers and as arrays; within some last places of a sum of terms of this size."""
    angles = RNG.uniform(0.01, 3.13, 40)
    with mpmath.workdps(40):
        right = np.array([float(printed(t, *wall, delay)) for t in angles.tolist()])
    last = 8 * 2**-52 * (abs(wall[0]) * (delay + 1) + abs(wall[1]) + wall[2])
    for found in (
        passivity_margin_at(angles, *wall, delay),
        [passivity_margin_at(t, *wall, delay) for t in angles.tolist()],
        passivity_margin_at(angles.tolist(), *wall, np.full(40, float(delay))),
        passivity_margin_at(angles, *wall, delay, sheet="principal"),
    ):
        assert np.abs(found - right).max() <= last


@pytest.mark.parametrize("delay", [3e8, 1e10 + 1, 871244595628127.0, 1e15])
def test_long_delays_lose_no_digits(delay):
    """What rounding (d + 1) theta misses is no small angle there, and is turned back as it is."""
    angles = RNG.uniform(0.5, 3.13, 40)
    with mpmath.workdps(60):
        right = np.array([float(printed(t, 1.0, 0.3, 0.4, delay)) for t in angles.tolist()])
    for found in (
        passivity_margin_at(angles, 1.0, 0.3, 0.4, delay),
        haptic.passivity_margin_at(angles, *(np.array(v) for v in (1.0, 0.3, 0.4, delay))),
    ):
        assert np.abs(found - right).max() <= 8 * 2**-52 * 4


@pytest.mark.parametrize("delay", [0.5, 1.25, 2.9])
def test_the_principal_sheet_is_as_printed_behind_fractions_too(delay):
    found = passivity_margin_at(0.7, 1.0, 0.3, 0.4, delay, sheet="principal")
    assert found == pytest.approx(float(printed(0.7, 1.0, 0.3, 0.4, delay)), abs=1e-14)
    assert found != passivity_margin_at(0.7, 1.0, 0.3, 0.4, delay)


@pytest.mark.parametrize("wall", [w for w in WALLS if w[0] >= 0])
@pytest.mark.parametrize("delay", [0.0, 0.1, 0.5, 1.0, 1.5, 3.7])
def test_no_angle_has_less_than_the_worst_one(wall, delay):
    """And one of many comes close, by the square of their distance."""
    angles = np.linspace(1e-4, math.pi - 1e-4, 20_001)
    least = passivity_margin_at(angles, *wall, delay).min()
    worst = passivity_margin(*wall, delay)
    assert worst - 1e-14 <= least <= worst + 1e-5


def test_whole_and_fractional_delays_may_stand_beside_each_other():
    delays = np.array([0.0, 0.5, 1.0, 1.5])
    found = passivity_margin_at(0.7, 1.0, 0.3, 0.4, delays)
    alone = [passivity_margin_at(0.7, 1.0, 0.3, 0.4, d) for d in delays.tolist()]
    assert np.abs(found - alone).max() < 8 * 2**-52


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ((0.0, 1.0, 1.0, 1.0, 0), "theta: 0.0 is not allowed; give numbers 0 < theta < pi"),
        ((3.1416, 1.0, 1.0, 1.0, 0), "theta: 3.1416 is not allowed"),
        ((1.0, math.inf, 1.0, 1.0, 0), "alpha: inf is not allowed; give finite numbers"),
        ((1.0, 1.0, 1.0, -1.0, 0.5), "delta: -1.0 is not allowed"),
        ((1.0, 1.0, 1.0, 1.0, -0.5), "delay: -0.5 is not allowed"),
    ],
)
@pytest.mark.parametrize("shape", [(), (3,)])
def test_what_is_no_angle_or_wall_is_refused(given, said, shape):
    with pytest.raises(ValueError, match=said):
        passivity_margin_at(*[np.full(shape, v) if shape else v for v in given])


def test_nan_gives_nan():
    for i in range(5):
        given = [0.5] * 5
        given[i] = math.nan
        assert math.isnan(passivity_margin_at(*given))


@pytest.mark.parametrize("epsilon", [0.0, 0.25, 0.999])
def test_a_device_behind_a_fraction_is_pushed_as_far_in_the_end(epsilon):
    """The modified z-transform of a free mass: (1 - e)^2/2, 1/2 + e (1 - e), e^2/2."""
    m2, m1, m0, a, e = discretize_fractional(0.0, 0.0, epsilon)
    late = 1 - epsilon
    assert (m2, m0, a, e) == (late * late / 2, pytest.approx(epsilon**2 / 2, rel=1e-15), 2.0, 1.0)
    assert m1 == pytest.approx(0.5 + epsilon * late, rel=1e-15)
    gamma, delta = RNG.uniform(0, 9, 50), RNG.uniform(0, 3, 50)
    n1, n0, a, e = discretize(gamma, delta)
    found = discretize_fractional(gamma, delta, epsilon)
    assert np.allclose(found[0] + found[1] + found[2], n1 + n0, rtol=1e-13)
    assert np.array_equal(found[3:], (a, e))


@pytest.mark.parametrize("epsilon", [-0.1, 1.0, 1.5, math.inf])
def test_a_fraction_is_less_than_a_period(epsilon):
    for value in (epsilon, np.array([0.5, epsilon])):
        with pytest.raises(ValueError, match=r"epsilon: .* .*; give numbers 0 <= epsilon"):
            symhaptic.discretize_fractional(0.1, 0.1, value)

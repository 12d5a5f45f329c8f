"""Scenes in SI units beside the eigenvalues of the loop built in SI units, and what they refuse."""

import pickle
import warnings
from fractions import Fraction

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


BAD = [-1.0, np.nan, np.inf, "1e999", 1j, [1.0], True, np.True_, 10**400, -(10**6000)]


@pytest.mark.parametrize("name", ["mass", "sampling_period", "damping", "stiffness", "delay"])
@pytest.mark.parametrize("bad", BAD, ids=range(len(BAD)))
def test_an_impossible_number_is_named(name, bad):
    given = {"mass": 1.0, "sampling_period": 1e-3} | {name: bad}
    allowed = "(finite numbers >=? 0|a number and a unit that converts to .+)"
    with pytest.raises(ValueError, match=f"^{name}: .+ is not allowed; give {allowed}$"):
        Scene(**given)


@pytest.mark.parametrize("name", ["mass", "sampling_period"])
def test_no_mass_and_no_period_are_impossible(name):
    given = {"mass": 1.0, "sampling_period": 1e-3} | {name: 0}
    with pytest.raises(ValueError, match=f"^{name}: 0 is not allowed; give finite numbers > 0$"):
        Scene(**given)


@pytest.mark.parametrize("bad", [np.inf, "1", None])
def test_a_wall_of_no_number_is_named(bad):
    scene = Scene(mass=1.0, sampling_period=1e-3)
    with pytest.raises(ValueError, match=r"^K: .+ is not allowed; give (finite|real|a) number"):
        scene.delay_margin(K=bad, B=1.0)
    with pytest.raises(ValueError, match=r"^B: .+ is not allowed; give (finite|real|a) number"):
        scene.delay_margin(K=1.0, B=bad)
    assert np.isnan(scene.delay_margin(K=np.nan, B=1.0))


def test_decimals_count_as_they_are_written():
    """Whole multiples of the period are whole delays; ratios are rounded once."""
    for period in ("1e-4", "0.0007", "1.1e-3", "0.03", "0.1"):
        for count in range(1, 60):
            late = float(count * Fraction(period))
            scene = Scene(mass=1.0, sampling_period=float(period), delay=late)
            assert scene.dimensionless.delay == count
            assert scene.periods == count
    assert Scene(mass=0.3, sampling_period=0.1, damping=0.7, delay=0.25).dimensionless == (
        0.0, 7 / 30, 2.5,
    )  # fmt: skip


def test_a_delay_computed_as_whole_periods_is_whole():
    """3 * 1e-4 is 0.00030000000000000003: a fraction as a decimal, three periods in floats."""
    for period in (1e-4, 3e-4, 0.0007, 2.5e-4, 1 / 3000):
        for count in range(60):
            scene = Scene(mass=1.0, sampling_period=period, delay=count * period)
            assert scene.periods == count
    late = Scene(mass=1.0, sampling_period=1e-4, delay=np.nextafter(3 * 1e-4, 1))
    assert late.periods > 3  # and what is not, is not
    with pytest.warns(UserWarning, match="sampling periods"):
        assert Scene(mass=1.0, sampling_period=1e-300, delay=1e300).periods > 10**599


@pytest.mark.parametrize(("mass", "period"), [(1e-15, 1e-155), (1e-160, 1e80), (1e160, 1e-80)])
def test_a_period_whose_squares_are_hardly_floats_is_told(mass, period):
    scene = Scene(mass=mass, sampling_period=period)
    with pytest.raises(ValueError, match=r"^sampling_period: .* give T\^2 and m/T\^2 from 1e-300"):
        scene.dimensionless  # noqa: B018


def test_a_delay_in_periods():
    late = Scene(mass=0.1, sampling_period=3e-4, delay_samples=7)
    assert late.dimensionless.delay == 7
    assert late.parts.delay
    same = Scene(mass=0.1, sampling_period=3e-4, delay=2.1e-3)
    assert late.max_stable_stiffness() == same.max_stable_stiffness()
    with pytest.raises(ValueError, match=r"^delay_samples: 2.0 and delay=0.001 exclude"):
        Scene(mass=1.0, sampling_period=1e-3, delay=1e-3, delay_samples=2)


def test_a_delay_that_was_meant_in_periods_is_warned_of():
    with pytest.warns(
        UserWarning, match=r"^delay: 1.5 s are 1500 sampling periods; .*_samples=1.5$"
    ):
        Scene(mass=0.1, sampling_period=1e-3, delay=1.5)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Scene(mass=0.1, sampling_period=1e-3, delay=0.1)
        Scene(mass=0.1, sampling_period=1e-3, delay_samples=500)


def test_every_number_is_a_float64():
    """A mass in single precision is the decimal that it was made of."""
    single = Scene(mass=np.float32(0.1), sampling_period=np.float32(1e-3), damping=np.int64(2))
    assert single == Scene(mass=0.1, sampling_period=1e-3, damping=2.0)
    assert {type(v) for v in (single.mass, single.sampling_period, single.damping)} == {float}
    assert {type(v) for v in single.dimensionless} == {float}


def test_the_limits_tell_the_damping_that_they_need():
    """The largest stiffness is lost with less damping, by eigenvalues; alone it is much less."""
    T, m, b = 1e-3, 0.1, 0.5
    scene = Scene(mass=m, damping=b, sampling_period=T, delay=2 * T)
    best = scene.max_stable_stiffness()
    assert isinstance(best, float)
    assert best == best.K
    assert pickle.loads(pickle.dumps(best)).B == best.B
    assert spectral_radius(0.999 * best, best.B, m, b, 0.0, T, 2) < 1
    assert spectral_radius(1.001 * best, best.B, m, b, 0.0, T, 2) > 1
    assert spectral_radius(0.999 * best, 0.9 * best.B, m, b, 0.0, T, 2) > 1
    assert best == pytest.approx(scene.limit_at(best.B).K, rel=1e-9)
    passive = scene.max_passive_stiffness()
    # (7) at the worst angle pi/(2 (d + 1)), (11)
    assert passive.frequency_hz == pytest.approx(1 / (4 * 3 * T))
    assert passive == pytest.approx(2 * b / T * np.tan(np.pi / 12))


@pytest.mark.parametrize("periods", [0, 1, 3])
@pytest.mark.parametrize("B", [-0.2, 0.0, 3.0, 20.0])
def test_the_limit_at_a_damping(periods, B):
    """Eigenvalues just below and above it, whose angle there is the frequency."""
    m, b, k, T = (DEVICE[n] for n in ("mass", "damping", "stiffness", "sampling_period"))
    scene = Scene(**DEVICE, delay_samples=periods)
    K, damping, frequency = scene.limit_at(B=B)
    assert damping == B
    assert spectral_radius(K - 1e-4 * (K + k), B, m, b, k, T, periods) < 1
    for more in (1e-4, 1e-2, 0.3, 1, 10):
        assert spectral_radius(K + more * (K + k), B, m, b, k, T, periods) > 1
    assert 0 < frequency <= 0.5 / T


@pytest.mark.parametrize("B", [0.1, 5.0, 83.0, 150.0])
def test_the_largest_stiffness_at_a_damping_has_the_name_that_is_looked_for(B):
    """A free mass without delay, by the Jury conditions of z (z - 1)^2 and its wall by hand.

    alpha < 2 beta (2 - beta)/(2 + beta) keeps the pair inside, alpha < 4 - 2 beta the root at -1.
    """
    m, T = 0.1, 1e-3
    scene = Scene(mass=m, sampling_period=T)
    found = scene.max_stable_stiffness(B=B)
    beta = B * T / m
    pair = 2 * beta * (2 - beta) / (2 + beta)
    assert found == pytest.approx(min(pair, 4 - 2 * beta) * m / T**2, rel=1e-9, abs=1e-6)
    assert (found.K, found.B, found.frequency_hz) == scene.limit_at(B)
    assert isinstance(found, float)
    assert scene.max_stable_stiffness() >= found


def needed(alpha, beta, d):
    """The printed (5) at many angles: what a wall needs, and the angle at which it needs most."""
    theta = np.linspace(1e-6, np.pi, 400_001)[:, None]
    need = alpha * np.sin((d + 0.5) * theta) / (2 * np.sin(theta / 2))
    need = need - beta * np.cos((d + 1) * theta)
    return need.max(axis=0), theta[need.argmax(axis=0), 0]


@pytest.mark.parametrize("d", [0, 1, 2, 5])
def test_the_largest_passive_stiffness_at_a_damping(d):
    m, b, T = 0.1, 0.5, 1e-3
    scene = Scene(mass=m, damping=b, sampling_period=T, delay_samples=d)
    B = np.array([-0.45, -0.1, 0.0, 0.1, 0.3, 0.49])
    found = scene.max_passive_stiffness(B)
    assert found.B.tolist() == B.tolist()
    alpha = found.K * T**2 / m
    need, theta = needed(alpha, B * T / m, d)
    np.testing.assert_allclose(need, b * T / m, rtol=1e-9)
    more, _ = needed(1.001 * alpha, B * T / m, d)
    assert np.all(more > b * T / m)
    if d:
        np.testing.assert_allclose(found.frequency_hz, theta / (2 * np.pi * T), atol=0.02)
    else:  # Colgate and Schenkel: b > K T/2 + |B|
        np.testing.assert_allclose(found.K, 2 * (b - abs(B)) / T, rtol=1e-12)
    one = scene.max_passive_stiffness(B=0.1)
    assert (one.K, one.B, one.frequency_hz) == tuple(x[3] for x in found)
    best = scene.max_passive_stiffness()
    assert scene.max_passive_stiffness(best.B) == pytest.approx(best, rel=1e-9)


@pytest.mark.parametrize("samples", [0, 0.3, 1, 2.5])
def test_no_wall_of_too_much_damping_is_passive(samples):
    """At K = 0 a wall of damping B > b/(1 - d) and more needs more than there is."""
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, delay_samples=samples)
    for B in (-0.6, 0.8, 1e6, -1e6):
        found = scene.max_passive_stiffness(B)
        assert np.isnan(found.K)
        assert np.isnan(found.frequency_hz)
        assert found.B == B
    free = Scene(mass=0.1, sampling_period=1e-3, delay_samples=samples)
    assert free.max_passive_stiffness(B=0.0) == 0
    assert np.isnan(free.max_passive_stiffness(B=0.1))


@pytest.mark.parametrize("name", ["max_stable_stiffness", "max_passive_stiffness"])
@pytest.mark.parametrize("bad", [np.nan, np.inf, "5", True, 1j, [1.0, np.inf], ["a"]])
def test_a_damping_of_no_number_is_named(name, bad):
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, delay=1e-3)
    with pytest.raises(ValueError, match=r"^B: .+ is not allowed; give (finite|real|a) number"):
        getattr(scene, name)(bad)


def test_a_damping_that_no_stiffness_makes_stable():
    found = Scene(mass=0.1, sampling_period=1e-3).limit_at(B=1e6)
    assert np.isnan(found.K)
    assert found.B == 1e6
    with pytest.raises(ValueError, match=r"^B: nan is not allowed; give finite numbers$"):
        Scene(mass=0.1, sampling_period=1e-3).limit_at(B=np.nan)


def test_quantities_of_pint_are_converted():
    unit = pytest.importorskip("pint", reason="no Pint here: its quantities are not tried")
    unit = unit.UnitRegistry()
    scene = Scene(mass=100 * unit.g, sampling_period=1 * unit.ms, damping=0.5 * unit("N*s/m"))
    assert scene == Scene(mass=0.1, sampling_period=1e-3, damping=0.5)
    margin = scene.delay_margin(K=1 * unit("N/mm"), B=5 * unit("N*s/m"))
    assert margin.m_as("s") == scene.delay_margin(K=1000.0, B=5.0)
    with pytest.raises(
        ValueError, match=r"^mass: .+ is not allowed; give a quantity that converts to kg$"
    ):
        Scene(mass=1 * unit.s, sampling_period=1e-3)
    with pytest.raises(
        ValueError, match=r"^K: .+ is not allowed; give a quantity that converts to N/m$"
    ):
        scene.delay_margin(K=1 * unit.N, B=1.0)


def test_help_tells_units_and_ranges():
    for told in ("kg", "Ns/m", "N/m", "periods", "gamma = k T^2/m", "> 0", ">= 0"):
        assert told in Scene.__doc__


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"stiffness": 1e25}, r"^stiffness: 1e\+25 with mass=0\.1 and sampling_period=0\.001 is "),
        ({"damping": 1e80}, r"^damping: 1e\+80 with .* is not allowed; give b T/m <= 1e\+70$"),
        ({"delay_samples": 2e16}, r"^delay_samples: 2e\+16 with .*; give t_d/T <= 1e\+15$"),
        ({"sampling_period": 1e-200}, r"^sampling_period: 1e-200 with mass=0\.1 .* N/m$"),
        ({"sampling_period": 1e200}, r"^sampling_period: 1e\+200 with mass=0\.1 .* N/m$"),
    ],
)
def test_a_device_of_which_a_float_tells_nothing_is_told_by_what_was_given(more, told):
    scene = Scene(**{"mass": 0.1, "sampling_period": 1e-3, **more})
    asked = (scene.max_stable_stiffness, scene.max_passive_stiffness, scene.describe,
             scene.stable_region, scene.to_scipy, lambda: scene.is_stable(1.0, 1.0))  # fmt: skip
    for ask in asked:
        with pytest.raises(ValueError, match=told):
            ask()


@pytest.mark.parametrize("name", ["mass", "sampling_period"])
def test_without_a_mass_or_a_period_there_is_no_loop(name):
    with pytest.raises(ValueError, match=f"^{name}: is missing; give {name} or "):
        Scene(**{"mass": 0.1, "sampling_period": 1e-3, name: None})


def test_a_wall_has_the_same_stiffness_wherever_units_are_given_to_it():
    """alpha m/T^2 is rounded in one order."""
    scene = Scene(mass=0.3, damping=0.7, sampling_period=0.003, delay_samples=1)
    unit = 0.3 / 0.003**2
    for alpha in (n / 7 for n in range(1, 40)):
        assert alpha * unit == scene.limit(alpha, 0.0, 1.0).K

"""Loops whose polynomials lose digits: modes far apart, walls near z = -1, touching curves."""

import mpmath as mp
import numpy as np
import pytest
from loops.oracle import device, difference_equation, low_pass, matrix, under_force
from scipy import signal

from symhaptic import (
    Average,
    Difference,
    Filter,
    Lag,
    LinearDevice,
    LowPass,
    Measured,
    Oversampled,
    Scene,
    SecondMass,
)
from symhaptic.loops import count
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


def test_states_that_are_mixed_keep_their_digits():
    """The coefficients of det(w + 1 - exp(A T)), by mpmath from the same entries of A."""
    mixed = np.array([[1.0, 2, 3, 4], [1, 3, 5, 6], [2, 5, 9, 10], [1, 2, 4, 6]])
    modes = np.zeros((4, 4))
    modes[:2, :2], modes[2:, 2:] = [[0, 1], [-1.44e6, -1.7]], [[0, 1], [-900.0, -0.01]]
    A = mixed @ modes @ np.linalg.inv(mixed)
    device = LinearDevice(A, mixed @ [0, 1, 0, 1], np.linalg.inv(mixed)[0])
    loop = Scene(dynamics=device, sampling_period=0.001).engine.loop
    with mp.workdps(60):
        step = mp.expm(mp.matrix(A.tolist()) * mp.mpf(0.001)) - mp.eye(4)
        wanted, adjugate = [mp.mpf(1)], mp.eye(4)  # by Faddeev and LeVerrier
        for n in range(1, 5):
            turned = step * adjugate
            wanted.append(-sum(turned[i, i] for i in range(4)) / n)
            adjugate = turned + wanted[-1] * mp.eye(4)
    np.testing.assert_allclose(loop.A, [float(x) for x in wanted[::-1]], rtol=1e-12)


@pytest.mark.usefixtures("either")
@pytest.mark.parametrize("modes", [3, 4])
def test_one_of_many_modes_gains_energy(modes):
    """Modes of nearly one frequency: the root exp(s T) of one is outside, by s of its device."""
    dice = np.random.default_rng(modes)
    for _ in range(8):
        A, B, C = (np.zeros(n) for n in ((2 * modes, 2 * modes), 2 * modes, 2 * modes))
        middle, spread, ratio = 10 ** dice.uniform((1, -6, -9), (3.4, -2, -2))
        for i, omega in enumerate(middle * (1 + spread * dice.uniform(-1, 1, modes))):
            gains = -0.1 if i == 0 else 1.0
            A[2 * i, 2 * i + 1] = B[2 * i + 1] = C[2 * i] = 1.0
            A[2 * i + 1, 2 * i : 2 * i + 2] = -(omega**2), -2 * gains * ratio * omega
        scene = Scene(dynamics=LinearDevice(A, B, C), sampling_period=0.001)
        assert not scene.is_stable(0.0, 0.0), (middle, spread, ratio)
        A[1::2, 1::2] = np.diag([-2 * 0.2 * middle] * modes)
        damped = Scene(dynamics=LinearDevice(A, B, C), sampling_period=0.001)
        assert damped.is_stable(0.0, 0.0), (middle, spread)


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


MIXED, BACK = np.array([[1.0, 2.0], [3.0, 5.0]]), np.array([[-5.0, 2.0], [3.0, -1.0]])


@pytest.mark.usefixtures("either")
@pytest.mark.parametrize("velocity", [None, Average(5), Measured(), Oversampled(Difference(), 4)])
def test_a_wall_without_stiffness_does_not_hold_a_free_device(velocity):
    """At rest at one place it stays at every other one: a root is 1, whatever is rounded."""
    given = {"sampling_period": 0.001, "delay_samples": 1.25, "velocity": velocity}
    for at in (0.02, 0.03, 0.07, 0.1, 0.4):
        handle = SecondMass(mass=at, stiffness=5000.0, damping=0.5)
        step = MIXED @ [[0.0, 1.0], [0.0, -20 * at]] @ BACK
        for scene in (
            Scene(mass=0.1, damping=0.5, structure=handle, **given),
            Scene(mass=0.1, damping=0.5, structure=handle, actuator=Lag(time_constant=at), **given),
            Scene(mass=0.1, structure=handle, stiffness=1e-15, **given),  # beside 5000 N/m
            Scene(dynamics=LinearDevice(step, MIXED[:, 1], BACK[0]), **given),
        ):
            assert not scene.is_stable([0.0] * 3, [0.0, 1.0, 5.0]).any(), scene


@pytest.mark.usefixtures("either")
@pytest.mark.parametrize("samples", [2, 5, 200])
def test_the_count_ends_for_a_free_device_with_a_virtual_mass_alone(samples):
    """Device and wall vanish at z = 1 as (z - 1)^2, and in powers of z that is lost in rounding."""
    device = {"mass": 0.1, "sampling_period": 0.001, "velocity": Average(samples)}
    for more in ({}, {"damping": 0.5}, {"integrator": "explicit Euler"}, {"delay": 0.0015}):
        scene = Scene(**device, virtual_mass=0.01, **more)
        assert not scene.is_stable([0.0, 0.0, -1e-9], [0.0, 1e-9, 0.0]).any()


def test_an_undamped_free_mass_with_a_long_mean_has_no_limit():
    """Without damping every wall is unstable; the wall has no roots to look at."""
    assert np.isnan(Scene(mass=1.0, sampling_period=1.0, velocity=Average(7)).limit_at(0.0).K)


MARGINS = {
    "a wall without damping": (
        {"damping": 0.2, "stiffness": 0.005, "velocity": Average(3)},
        *(0.315, 0.0, 0.5),
    ),
    "with a fraction": (
        {"damping": 0.42, "stiffness": 2e-4, "delay_samples": 1.035, "velocity": Average(3)},
        *(0.102, 0.0, 5.0),
    ),
    "with a lag": (
        {
            **{"damping": 0.0235, "stiffness": 11.5, "velocity": Average(3)},
            "actuator": Lag(time_constant=0.113),
        },
        *(-4.53, 0.0, 0.5),
    ),
    "a window that begins and ends in a cell": (
        {
            **{"damping": 0.07, "stiffness": 7.305, "delay_samples": 1.0},
            "velocity": LowPass(time_constant=0.9756),
            "actuator": Lag(time_constant=2.93),
        },
        *(18.794, 0.0, 0.05),
    ),
    "a long mean": (
        {
            **{"damping": 0.0, "stiffness": 11.57, "velocity": Average(5)},
            "actuator": Lag(time_constant=1.209),
        },
        *(-8.6, 0.0011, 0.1),
    ),
}
"""Scenes in units of the mass and the period; K, B and a delay beyond the margin."""


# beside its margin a long mean costs many halvings
@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=[pytest.mark.ci] * (n == "a long mean")) for n in MARGINS]
)
def test_a_margin_beside_eigenvalues(name):
    """Stable before the margin and unstable next to it, by eigenvalues of one period."""
    given, K, B, beyond = MARGINS[name]
    scene = Scene(mass=1.0, sampling_period=1.0, **given)
    lag = scene.actuator.time_constant if scene.actuator else None
    plant = device(given["stiffness"], given["damping"], lag)
    if isinstance(scene.velocity, Average):
        filtered = difference_equation([1 / scene.velocity.samples] * scene.velocity.samples, [1])
    else:
        filtered = difference_equation(*low_pass(scene.velocity.time_constant, 1, "backward Euler"))

    def radius(more):
        delay = (scene.delay_samples or 0.0) + more
        return np.abs(np.linalg.eigvals(matrix(*plant, K, B, delay, *filtered))).max()

    margin = scene.delay_margin(K, B)
    assert 0 < margin < beyond
    assert all(radius(x) < 1 for x in np.linspace(0, margin * (1 - 1e-6), 60))
    assert radius(margin * (1 + 1e-6)) > 1


def test_a_wall_that_never_reaches_the_device_has_no_margin():
    """|A| > |W| on the whole circle at each fraction: the extrema of both are no crossings."""
    given = {"damping": 1.304, "stiffness": 7.5655, "actuator": Lag(time_constant=0.7844)}
    scene = Scene(mass=1.0, sampling_period=1.0, **given)
    theta = np.linspace(1e-3, np.pi, 2000)
    A, b, x, _ = device(7.5655, 1.304, 0.7844)
    for part in np.linspace(0, 0.95, 20):
        step, early = under_force(A, b, 1.0)[0], under_force(A, b, 1.0 - part)
        late = early[0] @ under_force(A, b, part)[1]
        z = np.exp(1j * theta)[:, None, None]
        force = early[1] + late / z[..., 0]
        gain = x @ np.linalg.solve(z * np.eye(3) - step, force[..., None])
        assert (np.abs(7 * gain) < 1).all()
    assert np.isinf(scene.delay_margin(-7.0, 0.0))

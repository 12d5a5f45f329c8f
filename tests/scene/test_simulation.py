"""Simulated motions beside matrices, integrators and filters that were built apart."""

import time

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.signal import bilinear, lfilter

from symhaptic import (
    Arm,
    Average,
    Difference,
    Encoder,
    Filter,
    Lag,
    LinearDevice,
    LowPass,
    Measured,
    Scene,
    SecondMass,
    Window,
)
from symhaptic.loops.controller import Wall, controller

T = 1e-3
M, D = 0.1, 0.5


def period_map(K, B, m, b, k, T):
    """The loop 1.5 periods late: half a period by half a period, in SI units."""
    state = np.array([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]])
    half = expm(state * T / 2)
    step, push = half[:2, :2], half[:2, 2]

    def period(start):
        """Position, speed, the position one sample ago, and the forces of the last two samples."""
        x, before, one, two = start[:2], start[2], start[3], start[4]
        force = -K * x[0] - B * (x[0] - before) / T
        middle = step @ x + push * two
        return np.r_[step @ middle + push * one, x[0], force, one]

    return np.column_stack([period(row) for row in np.eye(5)])


@pytest.mark.parametrize("share", [0.5, 0.95, 1.05, 1.5])
def test_a_wall_below_its_limit_decays_and_one_above_it_grows_as_its_largest_root(share):
    scene = Scene(mass=M, damping=D, stiffness=30.0, sampling_period=T, delay=1.5 * T)
    K = share * scene.limit_at(B=5.0).K
    found = scene.simulate(K, 5.0, duration=2.0, position0="1 mm", velocity0=0.2)
    loop, state = period_map(K, 5.0, M, D, 30.0, T), np.r_[1e-3, 0.2, 1e-3 - 0.2 * T, 0, 0]
    for x, v in zip(found.position, found.velocity, strict=True):
        assert (x, v) == pytest.approx(state[:2], rel=1e-9, abs=1e-9 * np.abs(state[:2]).max())
        state = loop @ state
    radius = np.abs(np.linalg.eigvals(loop)).max()
    early, late = (np.abs(found.position[n : n + 100]).max() for n in (900, 1900))
    assert (late / early) ** 1e-3 == pytest.approx(radius, rel=5e-4)
    assert (radius < 1) == (share < 1)


VELOCITIES = [
    Difference(),
    LowPass(cutoff=50),
    LowPass(cutoff=80, mapping="exact pole"),
    LowPass(time_constant=2e-3, mapping="Tustin"),
    LowPass(cutoff=100, order=2),
    LowPass(cutoff=100, order=2, mapping="Tustin"),
    Average(3),
    Window(20),
    Filter([0.2, 0.1], [1, -0.9, 0.2]),
    Filter([0.0, 0.5, 0.5]),
    Measured(),
]


PARTS = [
    {"delay_samples": 0.5},
    {"actuator": Lag(time_constant=1e-3), "delay_samples": 1},
    {"structure": SecondMass(mass=0.02, stiffness=2e4, damping=2.0, sensor="handle")},
    {"integrator": "semi-implicit Euler", "delay_samples": 1},
    {"integrator": "explicit Euler"},
    {"virtual_mass": 0.01},
]


@pytest.mark.parametrize(
    ("velocity", "more"),
    [
        pytest.param(velocity, more, marks=[] if i % len(PARTS) == j else pytest.mark.slow)
        for i, velocity in enumerate(VELOCITIES)
        for j, more in enumerate(PARTS)
    ],
)
def test_the_limits_are_where_the_motion_begins_to_grow(velocity, more):
    scene = Scene(mass=M, damping=D, sampling_period=T, velocity=velocity, **more)
    limit = scene.limit_at(B=1.0)
    for share, grows in ((0.95, False), (1.05, True)):
        found = scene.simulate(share * limit.K, 1.0, duration=3.0, position0=1e-3).position
        early, late = (np.abs(found[n : n + 1000]).max() for n in (1000, 2000))
        assert (late > early) == grows


def test_the_filters_are_scipys():
    """In its own coefficients: a filter of second order by Tustin, a mean, and a low-pass."""
    x = np.cumsum(np.random.default_rng(3).normal(size=300))
    differences = np.diff(x, prepend=x[0]) / T
    tau, ratio = 1 / (2 * np.pi * 100), np.sqrt(0.5)
    for velocity, above, below in (
        (Difference(), [1], [1]),
        (LowPass(cutoff=100), [T / (tau + T)], [1, -tau / (tau + T)]),
        (LowPass(cutoff=100, mapping="Tustin"), *bilinear([1], [tau, 1], 1 / T)),
        (
            LowPass(cutoff=100, order=2, mapping="Tustin"),
            *bilinear([1], [tau**2, 2 * ratio * tau, 1], 1 / T),
        ),
        (Average(20), np.full(20, 1 / 20), [1]),
        (Filter([0, 0.5, 0.5]), [0, 0.5, 0.5], [1]),
    ):
        law = controller(Wall(0.0, T), velocity, T, (x[0], 0.0))
        commands = [law(place, np.nan)[1] / T**2 for place in x]
        assert commands == pytest.approx(-lfilter(above, below, differences), rel=1e-9, abs=1e-6)


def test_a_gripper_of_a_simulator_grows():
    """Of a MuJoCo model: J = 2.2e-4, 9 ms of hold, kp = 2, kd = 0.1, a spectral radius of 3.29."""
    gripper = Scene(inertia=2.2e-4, sampling_period=9e-3, velocity=Measured())
    found = gripper.simulate(2.0, 0.1, duration="0.5 s", position0="1 deg").position
    device = expm(np.array([[0, 1, 0], [0, 0, 1 / 2.2e-4], [0, 0, 0]]) * 9e-3)[:2]
    roots = np.linalg.eigvals(device[:, :2] - np.outer(device[:, 2], [2.0, 0.1]))
    assert np.abs(roots).max() == pytest.approx(3.29, abs=0.005)
    assert found[-1] / found[-2] == pytest.approx(roots[np.abs(roots).argmax()])


@pytest.mark.parametrize(
    ("integrator", "kp", "kd", "told"),
    [("explicit Euler", 1.0, 0.5, 1.23), ("semi-implicit Euler", 0.5, 1.9, 1.17)],
)
def test_gains_below_two_are_unstable_in_simulators(integrator, kp, kd, told):
    """The rule that kp dt^2/M and kd dt/M are below 2 accepts both."""
    scene = Scene(mass=1.0, sampling_period=T, velocity=Measured(), integrator=integrator)
    x = scene.simulate(kp / T**2, kd / T, duration=0.03, position0=1.0).position
    p = np.linalg.lstsq(np.c_[x[1:-1], x[:-2]], x[2:], rcond=None)[0]  # x+ = p_0 x + p_1 x-
    assert np.abs(np.roots([1, *-p])).max() == pytest.approx(told, abs=0.01)
    assert not scene.is_stable(kp / T**2, kd / T)


STEP, STIFF = 61.4e-6, 400.0
COURSE = {"mass": 0.04, "damping": 0.8, "sampling_period": T, "encoder": Encoder(resolution=STEP)}
"""A course's device; 2 b/T are 1600 N/m."""


def test_a_quantised_wall_below_the_bound_swings_for_ever_without_friction():
    """A swing of 0.48 counts, pushed to the middle of two counts."""
    scene = Scene(**COURSE)
    assert scene.is_passive(STIFF, 0.0)
    assert scene.max_quantised_stiffness() == 0
    found = scene.simulate(
        STIFF, 0.0, duration=20.0, external_force=10.5 * STIFF * STEP, samples_between=9
    )
    for start in (100_000, 180_000):
        swing = np.ptp(found.position[start : start + 20_000]) / STEP
        assert swing == pytest.approx(0.48, abs=0.03)
    given = np.diff(found.wall_energy[[100_000, 200_000]])
    burnt = np.diff(found.damper_energy[[100_000, 200_000]])
    assert 0 < burnt == pytest.approx(given, rel=1e-2)


@pytest.mark.parametrize("counts", [0.2, 3.5, 10.9])
def test_friction_of_half_a_count_ends_the_swing(counts):
    """f_c >= K Delta/2 (Abbott and Okamura 2005).

    With half of it, a device that is pushed to the middle of two counts still swings.
    """
    found = {}
    for share in (0.5, 1.0, 1.3):
        scene = Scene(**COURSE, coulomb_friction=share * STIFF * STEP / 2)
        push = counts * STIFF * STEP
        found[share] = scene.simulate(STIFF, 0.0, duration=3.0, external_force=push, velocity0=0.02)
        assert (scene.max_quantised_stiffness() >= STIFF * (1 - 1e-12)) == (share >= 1)
    assert not found[1.0].velocity[-100:].any()
    assert not found[1.3].velocity[-100:].any()
    if counts % 1 == 0.5:
        assert found[0.5].velocity[-100:].any()


def reference(A, wall, outside, friction, law, times, forces, start):
    """Held forces and Coulomb friction on the second state, by an adaptive integrator with events.

    ``wall`` and ``outside`` are columns; ``law`` is from a sampled state to a command that acts
    at once, ``forces`` from outside, one a period.  States at ``times``, all in SI units.
    """
    x, told, m = np.array(start, dtype=float), [], M
    for k, force in enumerate(forces):
        command = law(x)
        t, end = k * T, (k + 1) * T
        here = [each for each in times if t <= each < end]
        while t < end:
            pull = m * (A[1] @ x + wall[1] * command + outside[1] * force)
            stuck = x[1] == 0 and abs(pull) <= friction
            sense = np.sign(x[1] or pull)

            def slope(_, x, stuck=stuck, sense=sense, command=command, force=force):
                found = A @ x + wall * command + outside * force
                found[1] = 0 if stuck else found[1] - sense * friction / m
                return found

            def event(_, x, stuck=stuck, command=command, force=force):
                if not stuck:
                    return x[1]
                return friction - m * abs(A[1] @ x + wall[1] * command + outside[1] * force)

            event.terminal, event.direction = True, -1 if stuck else -sense
            run = solve_ivp(
                slope, (t, end), x, "DOP853", events=event, dense_output=True, rtol=1e-12,
                atol=1e-15, max_step=T / 4,
            )  # fmt: skip
            told += [run.sol(each) for each in here if t <= each < run.t[-1]]
            t, x = run.t[-1], run.y[:, -1]
            if run.status == 1 and not stuck:
                x[1] = 0.0
            elif run.status == 1:  # just beyond, so that it slides
                x[1] = 1e-13 * np.sign(m * (A[1] @ x + wall[1] * command + outside[1] * force))
    return np.array(told)


@pytest.mark.parametrize("k", [40.0, pytest.param(0.0, marks=pytest.mark.ci)])
@pytest.mark.parametrize(
    "part",
    [None, Lag(time_constant=4e-4), Lag(time_constant=5e-3),
     SecondMass(mass=0.05, stiffness=800.0, damping=0.2)],
    ids=str,
)  # fmt: skip
def test_stick_and_slip_are_those_of_an_integrator_with_events(part, k):
    """A device that is dragged to and fro, so that it stops and breaks away several times."""
    K, B, f_c = 300.0, 0.5, 0.4
    name = "structure" if isinstance(part, SecondMass) else "actuator"
    scene = Scene(
        mass=M, damping=D, stiffness=k, sampling_period=T, coulomb_friction=f_c,
        encoder=Encoder(resolution=1e-4), velocity=Measured(), **{name: part},
    )  # fmt: skip
    forces = 0.9 * np.sin(np.arange(300) / 30.0)
    found = scene.simulate(
        K, B, duration=0.3, position0=1e-3, velocity0=0.05, external_force=forces, samples_between=3
    )
    A, start = np.array([[0, 1.0], [-k / M, -D / M]]), [1e-3, 0.05]
    wall = outside = np.array([0, 1 / M])
    if isinstance(part, Lag):
        lag = part.time_constant
        A = np.array([[*A[0], 0], [*A[1], 1 / M], [0, 0, -1 / lag]])
        wall, outside = np.array([0, 0, 1 / lag]), np.array([0, 1 / M, 0])
        start = [*start, 0.0]
    elif part is not None:
        between = np.array([part.stiffness, part.damping])
        A = np.block([[A, np.zeros((2, 2))], [np.zeros((2, 4))]])
        A[2, 3] = 1.0
        A[1] += np.r_[-between, between] / M
        A[3] = np.r_[between, -between] / part.mass
        wall, outside = np.array([0, 1 / M, 0, 0]), np.array([0, 0, 0, 1 / part.mass])
        start = [*start, *start]

    def law(x):
        return -K * 1e-4 * np.round(x[0] / 1e-4) - B * x[1]

    states = reference(A, wall, outside, f_c, law, found.time[:-1], forces, start)
    assert found.position[:-1] == pytest.approx(states[:, 0], abs=1e-10)
    assert found.velocity[:-1] == pytest.approx(states[:, 1], abs=1e-8)
    assert (found.velocity == 0).sum() > 100
    way = np.abs(np.diff(found.position)).sum()
    assert found.friction_energy[-1] == pytest.approx(f_c * way, rel=1e-2)


def scenes():
    """Devices with all sorts of parts."""
    more = [
        {},
        {"stiffness": 200.0, "delay_samples": 2.3},
        {"actuator": Lag(time_constant=3e-4), "coulomb_friction": 0.05},
        {"structure": SecondMass(mass=0.03, stiffness=2000.0, damping=0.3)},
        {
            "structure": SecondMass(mass=0.03, stiffness=900.0, damping=0.1, sensor="handle"),
            "actuator": Lag(time_constant=2e-3),
            "coulomb_friction": 0.02,
            "delay_samples": 0.7,
        },
        {"arm": Arm(mass=0.5, damping=3.0, stiffness=60.0), "coulomb_friction": 0.3},
    ]
    for parts in more:
        yield Scene(mass=M, damping=D, sampling_period=T, **parts)
        yield Scene(mass=M, damping=D, sampling_period=T, encoder=Encoder(resolution=2e-5), **parts)


@pytest.mark.parametrize("scene", [*scenes()], ids=str)
@pytest.mark.parametrize("between", [0, 4])
def test_energies_balance(scene, between):
    found = scene.simulate(
        900.0, 0.4, duration=1.0, position0=-2e-3, velocity0=0.3, unilateral=True, saturation=2.0,
        external_force=lambda t: 0.3 * np.sin(40 * t), samples_between=between,
    )  # fmt: skip
    gained = found.device_energy - found.device_energy[0]
    given = found.wall_energy + found.external_energy
    burnt = found.damper_energy + found.friction_energy
    assert np.abs(gained - given + burnt).max() <= 1e-12 * (found.device_energy + burnt).max()
    assert (np.diff(found.damper_energy) >= 0).all()
    assert (np.diff(found.friction_energy) >= 0).all()
    assert (found.friction_energy[-1] > 0) == (scene.coulomb_friction is not None)
    assert found.integrator_energy is None


@pytest.mark.parametrize("more", [{}, {"actuator": Lag(time_constant=2e-3)}], ids=str)
def test_a_device_by_its_matrices_moves_as_the_same_mass(more):
    """In states of its own, turned by a matrix; the energies are not known of them."""
    turned = np.array([[1.0, 2.0], [-0.5, 0.7]])
    back = np.linalg.inv(turned)
    A = turned @ [[0, 1], [-30.0 / M, -D / M]] @ back
    matrices = LinearDevice(A, turned @ [0, 1 / M], [1, 0] @ back)
    loop = {"sampling_period": T, "delay_samples": 1.3, "encoder": Encoder(resolution=1e-5), **more}
    given = Scene(dynamics=matrices, **loop)
    scene = Scene(mass=M, damping=D, stiffness=30.0, **loop)
    push = {"duration": 0.5, "external_force": lambda t: np.cos(30 * t), "samples_between": 2}
    one, other = (each.simulate(200.0, 1.0, **push) for each in (scene, given))
    assert other.position == pytest.approx(one.position, abs=1e-12)
    assert other.velocity == pytest.approx(one.velocity, abs=1e-10)
    assert other.force == pytest.approx(one.force, abs=1e-9)
    assert np.isnan(other.device_energy).all()
    assert np.isnan(other.wall_energy).all()
    pytest.importorskip("matplotlib")
    assert len(other.plot()[1].lines) == 0
    for name, scene in (
        ("position0 or velocity0", given),
        ("coulomb_friction", Scene(dynamics=matrices, coulomb_friction=1.0, **loop)),
    ):
        with pytest.raises(ValueError, match=f"{name}: cannot be used with dynamics"):
            scene.simulate(1.0, 0.0, duration=0.01, velocity0=0.1)


def test_each_energy_is_the_integral_of_its_power():
    """By Simpson's rule on many times between the samples."""
    scene = Scene(
        mass=M, damping=D, stiffness=200.0, sampling_period=T, delay_samples=0.5,
        structure=SecondMass(mass=0.03, stiffness=900.0, damping=0.4),
        actuator=Lag(time_constant=T),
    )  # fmt: skip
    found = scene.simulate(
        900.0, 0.4, duration=0.1, position0=1e-3, external_force=0.2, samples_between=31
    )
    from scipy.integrate import simpson

    assert found.wall_energy[-1] == pytest.approx(
        simpson(found.force * found.velocity, x=found.time), rel=1e-5
    )
    handle = Scene(
        mass=M, damping=D, stiffness=200.0, sampling_period=T, delay_samples=0.5,
        structure=SecondMass(mass=0.03, stiffness=900.0, damping=0.4, sensor="handle"),
        actuator=Lag(time_constant=T),
    )  # fmt: skip
    # open loop, so that both sensors see one motion
    at_motor, at_handle = (
        one.simulate(0.0, 0.0, duration=0.1, velocity0=0.1, external_force=0.2, samples_between=31)
        for one in (scene, handle)
    )
    assert at_handle.external_energy[-1] == pytest.approx(0.2 * at_handle.position[-1])
    power = D * at_motor.velocity**2 + 0.4 * (at_motor.velocity - at_handle.velocity) ** 2
    assert at_motor.damper_energy[-1] == pytest.approx(simpson(power, x=at_motor.time), rel=1e-8)
    assert np.array_equal(at_motor.damper_energy, at_handle.damper_energy)


@pytest.mark.parametrize("integrator", ["semi-implicit Euler", "explicit Euler"])
def test_an_integrator_adds_energy(integrator):
    """Explicit Euler's steps add energy to a spring: k T^2/m of it in each step."""
    scene = Scene(mass=M, stiffness=30.0, sampling_period=T, integrator=integrator)
    found = scene.simulate(0.0, 0.0, duration=1.0, position0=1e-2)
    if integrator == "explicit Euler":
        factor = (1 + 30.0 * T**2 / M) ** 1000
        assert found.device_energy[-1] == pytest.approx(factor * found.device_energy[0])
    else:
        assert np.abs(found.integrator_energy).max() < 0.02 * found.device_energy[0]
    gained = found.device_energy - found.device_energy[0]
    assert gained == pytest.approx(found.integrator_energy)


@pytest.mark.parametrize("integrator", ["semi-implicit Euler", "explicit Euler"])
def test_friction_stops_a_simulated_device(integrator):
    """From v it comes to rest after m v/f_c, and stays."""
    scene = Scene(mass=M, sampling_period=T, integrator=integrator, coulomb_friction=0.2)
    found = scene.simulate(0.0, 0.0, duration=1.0, velocity0=1.0)
    assert found.time[found.velocity == 0][0] == pytest.approx(M * 1.0 / 0.2, abs=T)
    assert found.friction_energy[-1] == pytest.approx(M / 2, rel=5e-3)


def test_friction_alone_stops_a_device_where_its_energy_ends():
    """m v^2/2 = f_c x, after m v/f_c, which is inside a period."""
    scene = Scene(mass=M, sampling_period=T, coulomb_friction=0.3)
    found = scene.simulate(0.0, 0.0, duration=0.2, velocity0=0.4001)
    assert found.position[-1] == pytest.approx(M * 0.4001**2 / 2 / 0.3, rel=1e-13)
    assert found.velocity[-1] == 0
    assert (found.velocity > 0).sum() == np.ceil(M * 0.4001 / 0.3 / T)


def test_a_unilateral_wall_only_pushes():
    scene = Scene(mass=M, damping=D, sampling_period=T, delay_samples=1)
    found = scene.simulate(
        2000.0,
        8.0,
        duration=0.3,
        position0=-0.01,
        velocity0=0.5,
        unilateral=True,
        samples_between=1,
    )
    sampled = slice(0, None, 2)
    place, force = found.position[sampled], found.force[sampled]
    assert found.force.max() == 0 > found.force.min()
    assert (force[1:][place[:-1] <= 0] == 0).all()  # a period late
    # it leaves the wall, slower than it came
    assert -0.5 < found.velocity[-1] < 0 > found.position[-1]
    both = scene.simulate(2000.0, 8.0, duration=0.3, position0=-0.01, velocity0=0.5)
    assert both.force.max() > 0


def test_the_command_saturates():
    scene = Scene(mass=M, damping=D, sampling_period=T)
    found = scene.simulate(5000.0, 5.0, duration=0.2, position0=1e-2, saturation="5 N")
    assert found.force.min() == -5.0
    assert found.force.max() == 5.0


def test_a_rotary_device_moves_as_one_along_a_line():
    own = {"damping": D, "sampling_period": T, "coulomb_friction": 0.01, "delay_samples": 0.5}
    line = Scene(mass=M, encoder=Encoder(resolution="1 mm"), **own)
    knob = Scene(inertia=M, encoder=Encoder(resolution="1e-3 rad"), **own)
    start = {"duration": 0.2, "position0": 0.02, "external_force": 0.1}
    one, other = (each.simulate(200.0, 1.0, **start) for each in (line, knob))
    assert np.array_equal(one.position, other.position)
    pytest.importorskip("xarray")
    units = {name: each.attrs["units"] for name, each in other.to_xarray().items()}
    expected = {"position": "rad", "velocity": "rad/s", "force": "N m", "device_energy": "J"}
    assert expected.items() <= units.items()
    assert one.to_xarray().force.attrs["units"] == "N"
    assert list(one.to_xarray().dims) == ["time"]
    degrees = knob.simulate("200 N m/rad", "1 N m s/rad", duration="0.2 s", position0="90 deg")
    assert degrees.position[0] == pytest.approx(np.pi / 2)
    assert degrees.measured_position[0] == pytest.approx(1.571)
    for resolution, scene in (("1 mm", {"inertia": 1.0}), ("1 deg", {"mass": 1.0})):
        with pytest.raises(ValueError, match="encoder: a resolution in "):
            Scene(**scene, sampling_period=T, encoder=Encoder(resolution=resolution))


def test_what_is_told_between_samples_lies_on_one_motion():
    scene = Scene(mass=M, damping=D, sampling_period=T, delay_samples=0.3, coulomb_friction=0.02)
    start = {"duration": 0.1, "position0": 1e-3, "external_force": np.linspace(-1, 1, 100)}
    few, many = (scene.simulate(900.0, 1.0, **start, samples_between=n) for n in (0, 6))
    assert len(few.time) == 101
    assert many.time[::7] == pytest.approx(few.time)
    for name in ("position", "velocity", "force", "measured_position", "wall_energy"):
        assert getattr(many, name)[::7] == pytest.approx(getattr(few, name), rel=1e-9, abs=1e-15)


def test_beyond_the_range_of_floats_there_is_nothing():
    for more in ({}, {"coulomb_friction": 0.1}, {"integrator": "explicit Euler"}):
        scene = Scene(mass=M, sampling_period=T, encoder=Encoder(resolution=1e-6), **more)
        found = scene.simulate(1e6, 0.0, duration=5.0, position0=1e-3)
        grown = np.isnan(found.position)
        assert grown[-1]
        assert not grown[:100].any()
        assert (np.diff(grown.astype(int)) >= 0).all()


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"duration": 0}, "duration: 0 is not allowed; give finite numbers > 0"),
        ({"duration": "1 m"}, "duration: '1 m' is not allowed"),
        ({"duration": 1e9}, "duration: 1000000000.0 s are 1000000000000 sampling periods"),
        ({"position0": "1 s"}, "position0: '1 s' is not allowed"),
        ({"velocity0": np.nan}, "velocity0: nan is not allowed"),
        ({"external_force": [1.0, 2.0]}, "external_force: an array of shape .2,. is not allowed"),
        ({"external_force": [0.0] * 99}, "external_force: an array of shape .99,. is not allowed"),
        ({"external_force": lambda t: np.inf}, "external_force: inf is not allowed"),
        ({"saturation": -1}, "saturation: -1 is not allowed"),
        ({"samples_between": 1.5}, "samples_between: 1.5 is not allowed"),
        ({"samples_between": -1}, "samples_between: -1 is not allowed"),
        ({"K": np.inf}, "K: inf is not allowed"),
    ],
)
def test_what_is_refused(given, told):
    with pytest.raises(ValueError, match=told):
        Scene(mass=M, sampling_period=T).simulate(**{"K": 1.0, "B": 0.0, "duration": 0.01, **given})


def test_a_simulator_has_no_time_between_its_steps():
    scene = Scene(mass=M, sampling_period=T, integrator="explicit Euler")
    with pytest.raises(ValueError, match="samples_between: 1 is not allowed; give 0"):
        scene.simulate(1.0, 0.0, duration=0.01, samples_between=1)
    with pytest.raises(ValueError, match=r"delay: 0\.5 periods"):
        Scene(mass=M, sampling_period=T, integrator="explicit Euler", delay_samples=0.5).simulate(
            1.0, 0.0, duration=0.01
        )
    fast = Scene(mass=M, sampling_period=T, actuator=Lag(time_constant=1e-12), coulomb_friction=0.1)
    with pytest.raises(ValueError, match="coulomb_friction: a period would need "):
        fast.simulate(1.0, 0.0, duration=0.01)


def test_a_duration_is_rounded_up_to_periods():
    scene = Scene(mass=M, sampling_rate="3 kHz")
    assert len(scene.simulate(1.0, 0.0, duration="1 s").time) == 3001
    assert len(scene.simulate(1.0, 0.0, duration=1e-3 + 1e-6).time) == 5


def test_ten_thousand_periods_are_quick():
    scene = Scene(**COURSE)
    scene.simulate(400.0, 1.0, duration=0.1, position0=1e-3)
    start = time.process_time()
    scene.simulate(400.0, 1.0, duration=10.0, position0=1e-3)
    assert time.process_time() - start < 1.0


def test_a_picture():
    pytest.importorskip("matplotlib")
    scene = Scene(**COURSE, coulomb_friction=0.01)
    found = scene.simulate(400.0, 0.0, duration=0.1, position0=1e-3)
    above, below = found.plot()
    assert above.get_ylabel() == "position in m"
    names = [text.get_text() for text in below.get_legend().get_texts()]
    assert names == ["device", "wall", "damper", "friction"]
    assert found.plot((above, below)) == (above, below)
    assert repr(found) == "Simulation(K=400.0, B=0.0, 101 times to 0.1 s)"


@pytest.mark.parametrize(
    ("duration", "samples"),
    [
        (0.1, 301),
        (0.1 * (1 + 1e-12), 301),
        (0.1 * (1 + 1e-7), 302),
        (0.1 * (1 - 1e-7), 301),
        (1e-9, 2),
    ],
)
def test_a_last_period_by_round_off_alone_is_none(duration, samples):
    """300 periods of 1/3000 s, a trifle more or less, and a part of one."""
    scene = Scene(mass=M, damping=D, sampling_period=1 / 3000)
    assert len(scene.simulate(10.0, 0.1, duration=duration, position0=1e-3).time) == samples

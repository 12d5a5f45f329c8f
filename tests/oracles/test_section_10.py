"""Loops of other parts, by eigenvalues of matrices written apart, and by the energy of motions."""

import numpy as np
import oracle
import pytest
from oracles import energy
from oracles.guarding import guards
from oracles.motion import held
from oracles.subject import page
from scipy.linalg import expm
from sympy import sympify

pytestmark = pytest.mark.ci

DICE = 1810


def radius(matrix):
    """Spectral radius."""
    return np.abs(np.linalg.eigvals(matrix)).max()


def scenes(seed, number=200):
    """T and m, over the decades that devices have."""
    dice = np.random.default_rng(DICE + seed)
    for _ in range(number):
        yield dice, 10 ** dice.uniform(-4, -2), 10 ** dice.uniform(-2, 1)


def filtered(f, K, B, T, taps=140):
    """Answers of a wall whose damper takes the exponential average, sample by sample."""
    speed, found = 0.0, []
    for k in range(taps):
        speed = f * speed + (1 - f) * ((k == 0) - (k == 1)) / T
        found.append(K * (k == 0) + B * speed)
    return found


@guards("s10a_filtered_velocity")
def test_the_counterexample_gives_energy_away_behind_its_delay():
    at = page("s10a_filtered_velocity").settled["rules:plain-damping"].verdict.counterexample
    K, B, b, T, f, d = (eval(at[name]) for name in ("K", "B", "b", "T", "f_v", "d"))
    law = [0.0] * d + filtered(f, K, B, T)
    assert b > K * T / 2 + abs(B)
    assert energy.left_of(law, b, T) < 0 < energy.left_of(law[d:], b, T)


@guards("s10b_virtual_mass")
@pytest.mark.parametrize(("K", "B", "M"), [(0, 0, 0.5), (1.2, 0, 0.3), (0.4, 0.6, 0.2), (0, 1, 0)])
def test_a_virtual_mass_takes_its_damping_beside_spring_and_damper(K, B, M):
    T = 0.5
    needed = K * T / 2 + B + 2 * M / T
    law = [K + B / T + M / T**2, -B / T - 2 * M / T**2, M / T**2]
    assert energy.left_of(law, 1.0001 * needed, T) > 0
    assert energy.left_of(law, 0.98 * needed, T) < 0


def with_virtual_mass(M, m, delay):
    """What is left of a free mass that drifts, by the differences of its position."""
    free, push = held(m, 0.0, 0.0, 1.0)
    # of x, v and the last positions; both zeros at 1 are the drift
    size = 4 + delay
    step = np.zeros((size, size))
    step[:2, :2] = free
    for age, weight in enumerate((-1, 2, -1)):
        place = age + delay
        step[:2, 0 if place == 0 else 1 + place] += weight * M * push
    step[2, 0] = 1
    for i in range(3, size):
        step[i, i - 1] = 1
    zeros = np.linalg.eigvals(step)
    return np.abs(zeros[np.abs(zeros - 1) > 1e-3]).max()


@guards("s10b_virtual_mass")
def test_a_virtual_mass_is_stable_up_to_twice_the_mass():
    for m in (0.1, 1.0, 7.0):
        assert with_virtual_mass(1.999 * m, m, 0) < 1 < with_virtual_mass(2.001 * m, m, 0)
    assert with_virtual_mass(1.23, 1, 1) < 1 < with_virtual_mass(1.24, 1, 1)
    assert with_virtual_mass(1.5, 1, 1) > 1


def euler(K, B, T, m, implicit):
    """The steps of a simulator, as it makes them."""

    def step(place, speed):
        faster = speed - T / m * (K * place + B * speed)
        return place + T * (faster if implicit else speed), faster

    return np.transpose([step(1.0, 0.0), step(0.0, 1.0)])


@guards("s10c_simulators")
def test_simulators_are_stable_up_to_their_bounds():
    for dice, T, m in scenes(1):
        B = dice.uniform(0.01, 1.99) * m / T
        for near in (1 - 1e-6, 1 + 1e-6):
            limit = 4 * m / T**2 - 2 * B / T
            assert (radius(euler(near * limit, B, T, m, True)) < 1) == (near < 1)
            assert (radius(euler(near * B / T, B, T, m, False)) < 1) == (near < 1)
        B = dice.uniform(2.01, 3.9) * m / T
        low = 2 * B / T - 4 * m / T**2
        assert radius(euler(1.001 * low, B, T, m, False)) < 1
        assert radius(euler(0.999 * low, B, T, m, False)) > 1
    assert radius(euler(1, 0.5, 1, 1, False)) == pytest.approx(1.2247, abs=1e-4)
    assert radius(euler(0.5, 1.9, 1, 1, True)) == pytest.approx(1.1695, abs=1e-4)


@guards("s10c_simulators")
def test_a_quarter_of_the_bound_is_stable_with_little_damping():
    for dice, T, m in scenes(2):
        B = dice.uniform(0.001, 1.5) * m / T
        assert radius(euler(0.999 * m / T**2, B, T, m, True)) < 1


def measured(K, B, T, m):
    """A free mass under a force that is held, from its place and its velocity."""
    free, push = held(m, 0.0, 0.0, T)
    return free - np.outer(push, [K, B])


@guards("s10d_measured_velocity")
def test_a_measured_velocity_is_stable_just_within_its_bounds():
    for dice, T, m in scenes(3):
        B = dice.uniform(0.01, 1.99) * m / T
        for near in (1 - 1e-6, 1 + 1e-6):
            assert (radius(measured(near * 2 * B / T, B, T, m)) < 1) == (near < 1)
        K = dice.uniform(0.01, 4) * m / T**2
        assert radius(measured(K, 2.0001 * m / T, T, m)) > 1
    gripper = measured(2.0, 0.1, 0.009, 2.2e-4)
    assert radius(gripper) == pytest.approx(3.29, abs=0.01)


def left_by(steps, K, b, f_c, T, counts, only_pushes):
    """Energy that a motion in steps leaves, of a position that is rounded to counts."""
    place, left = 0.0, 0.0
    for way in steps:
        count = counts * np.round(place / counts)
        force = K * (max(count, 0.0) if only_pushes else count)
        left += force * way + b * way**2 / T + f_c * abs(way)
        place += way
    return left


@guards("s10e_counts_and_friction")
@pytest.mark.parametrize("only_pushes", [False, True])
def test_no_motion_gains_energy_within_the_bounds(only_pushes):
    dice = np.random.default_rng(DICE)
    for _ in range(400):
        T, counts = 10 ** dice.uniform(-4, -2), 10 ** dice.uniform(-6, -3)
        b, f_c = 10 ** dice.uniform(-3, 1), 10 ** dice.uniform(-3, 0)
        K = min(2 * b / T, 2 * f_c / counts)
        steps = counts * 10 ** dice.uniform(-2, 2) * dice.normal(size=60)
        scale = K * counts**2 + K * np.abs(steps).max() ** 2
        assert left_by(steps, K, b, f_c, T, counts, only_pushes) > -1e-12 * scale


@guards("s10e_counts_and_friction")
@pytest.mark.parametrize("only_pushes", [False, True])
def test_a_swing_gains_energy_beyond_either_bound(only_pushes):
    T = counts = 1.0
    edge = [0.5 - 1e-3, *50000 * [2e-3, -2e-3]]
    assert left_by(edge, 1.02, 1.0, 0.5, T, counts, only_pushes) < 0
    assert left_by(edge, 0.999, 1.0, 0.5, T, counts, only_pushes) > 0
    wide = [1e4, -1e4]
    assert left_by(wide, 1.001, 0.5, 3.0, T, counts, only_pushes) < 0
    assert left_by(wide, 0.999, 0.5, 3.0, T, counts, only_pushes) > 0


def filtered_mass(K, B, T, m, tau):
    """Place, velocity, the place before and the filtered velocity, from sample to sample."""
    free, push = held(m, 0.0, 0.0, T)
    f = tau / (T + tau)
    speed = np.array([(1 - f) / T, 0, -(1 - f) / T, f])
    step = np.zeros((4, 4))
    step[:2, :2] = free
    step[:2] -= np.outer(push, [K, 0, 0, 0] + B * speed)
    step[2, 0] = 1
    step[3] = speed
    return step


@guards("s10f_filtered_mass")
def test_a_filtered_mass_is_stable_just_within_its_bound():
    for dice, T, m in scenes(4):
        tau, B = T * 10 ** dice.uniform(-2, 1.5), dice.uniform(0.01, 1.99) * m / T
        square, slope = tau * (T + 2 * tau), 2 * m + B * (T + 4 * tau)
        limit = np.roots([square, slope, -2 * B * (2 * m - B * T) / T]).max()
        for near in (1 - 1e-6, 1 + 1e-6):
            assert (radius(filtered_mass(near * limit, B, T, m, tau)) < 1) == (near < 1)
        assert limit < 2 * B / T
        little = dice.uniform(0.01, 1) * 2 * m * tau / (T * (T + 4 * tau))
        assert radius(filtered_mass(0.9999 * little / (T / 2 + tau), little, T, m, tau)) < 1
        for K in (0.01, 0.3, 2.0):
            assert radius(filtered_mass(K * m / T**2, -B, T, m, tau)) > 1
    assert radius(filtered_mass(0.5, 1, 1, 1, 1)) > 1


def lagging_mass(K, B, T, m, tau, k=0.0):
    """Place, velocity, force of the actuator and the place before."""
    motion = np.zeros((4, 4))
    motion[0, 1], motion[1, 2], motion[2, 2:] = 1, 1 / m, [-1 / tau, 1 / tau]
    motion[1, 0] = -k / m
    moved = expm(motion * T)
    step = np.zeros((4, 4))
    step[:3, :3] = moved[:3, :3]
    step[:3] -= np.outer(moved[:3, 3], [K + B / T, 0, 0, -B / T])
    step[3, 0] = 1
    return step


@guards("s10g_actuator_lag")
def test_no_wall_above_the_line_is_stable_with_a_lag():
    for dice, T, m in scenes(5, 400):
        tau, B = T * 10 ** dice.uniform(-1.5, 1.5), 10 ** dice.uniform(-2, 0.5) * m / T
        line = B / (T / 2 + tau)
        assert radius(lagging_mass(dice.uniform(1, 3) * line, B, T, m, tau)) > 1
    # at the origin the line is the tangent
    assert radius(lagging_mass(0.99 * 1e-3 / 1.5, 1e-3, 1, 1, 1)) < 1


@guards("s10g_actuator_lag")
def test_the_same_delay_costs_more_than_the_lag():
    for tau, K, B in ((1, 0.18, 0.56), (5, 0.04, 0.5)):
        assert radius(lagging_mass(K, B, 1, 1, tau)) < 1
        assert not oracle.stable(K, B, 0, 0, tau)
    assert radius(lagging_mass(0.2, 0.56, 1, 1, 1)) > 1


@guards("s10g_actuator_lag")
def test_a_delay_of_three_quarters_of_a_swing_costs_less_than_the_lag():
    k = np.pi**2 / 4
    assert oracle.stable(k / 10, k / 20, k, 0, 3)
    assert radius(lagging_mass(k / 10, k / 20, 1, 1, 3, k)) > 1
    assert not oracle.stable(k / 10, k / 20, k, 0, 4)  # a whole swing brakes nothing


@guards("s10h_energy_leak")
@pytest.mark.parametrize("late", [0, 1, 3])
def test_a_spring_takes_the_damping_of_hold_and_delay(late):
    K, T = 0.8, 0.5
    needed = K * T * (0.5 + late)
    law = [0.0] * late + [K]
    assert energy.left_of(law, 1.0001 * needed, T) > -1e-12
    assert energy.left_of(law, 0.98 * needed, T, periods=300) < 0


@guards("s10h_energy_leak")
def test_half_a_period_takes_more_than_the_rule():
    assert energy.left(1.0, 0.0, b=1.01, late=0.5) < 0
    assert energy.left(1.0, 0.0, b=1.01, late=0.0) > 0


@guards("s10i_virtual_coupling")
def test_a_coupling_takes_damping_of_the_device():
    """At its counterexample the energy is negative, and at the corrected bound it is not."""
    at = page("s10i_virtual_coupling").settled["coupling:damper"].verdict.counterexample
    K, B, b, T = (float(sympify(at[name])) for name in ("K", "B", "b", "T"))
    law = [K + B / T, -B / T]
    assert B >= T * K / 2
    assert energy.left_of(law, b, T) < 0 < energy.left_of(law, 1.001 * (K * T / 2 + B), T)

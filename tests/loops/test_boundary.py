"""Boundaries, limits and windows of loops with further parts.

The reference is mpmath's matrix exponential of 40 digits: 1 + P(z) (K + B V(z)) = 0 solved at an
angle, with V(z) as control texts write the filter.
"""

import math
from itertools import product

import mpmath as mp
import numpy as np
import pytest
from loops.oracle import device, difference_equation, low_pass, matrix, sizes
from loops.test_count import PARTS, VELOCITIES

from symhaptic import Difference, Lag, LowPass, Measured, Scene, SecondMass, Window
from symhaptic.loops.engine import Engine

mp.mp.dps = 40

FILTERED = {
    "difference": Difference(),
    "Tustin": LowPass(time_constant=2.5, mapping="Tustin"),
    "second order": LowPass(time_constant=2.0, order=2),
    "long window": Window(12),
}
WITH = {
    "plain": ((), {}),
    "lag": ((Lag(time_constant=1.7),), {"lag": 1.7}),
    "motor": (
        (SecondMass(mass=3.0, stiffness=0.8, damping=0.1), Lag(time_constant=0.4)),
        {"second": (3.0, 0.8, 0.1, "motor"), "lag": 0.4},
    ),
}


def filters(z):
    """V(z) of four velocities, periods of 1."""
    difference = 1 - 1 / z
    s, backward = 2 * (z - 1) / (z + 1), 1 - 1 / z
    ratio = mp.sqrt(mp.mpf(1) / 2)
    tau, double = mp.mpf("2.5"), mp.mpf(2)
    return {
        "difference": difference,
        "Tustin": difference / (tau * s + 1),
        "second order": difference / (double**2 * backward**2 + 2 * ratio * double * backward + 1),
        "long window": (1 - z**-12) / 12,
    }


def exact(gamma, delta, delay, own, name, theta):
    """K and B, exact to many digits."""
    A, b, x, _ = device(gamma, delta, **own)
    n, whole = len(b), int(delay)
    part, z = mp.mpf(delay) - whole, mp.expj(mp.mpf(theta))

    def under(time):
        both = mp.zeros(n + 1)
        for i in range(n):
            for j in range(n):
                both[i, j] = mp.mpf(float(A[i, j])) * time
            both[i, n] = mp.mpf(float(b[i])) * time
        both = mp.expm(both)
        return both[:n, :n], both[:n, n]

    step, _ = under(mp.mpf(1))
    on, early = under(1 - part)
    late = on * under(part)[1]
    state = mp.lu_solve(z * mp.eye(n) - step, early + late / z)
    P = sum(mp.mpf(float(x[i])) * state[i] for i in range(n)) * z**-whole
    wanted, V = -1 / P, filters(z)[name]
    B = wanted.imag / V.imag
    return wanted.real - B * V.real, B


BOTH = {
    ("difference", "motor"),
    ("Tustin", "plain"),
    ("second order", "lag"),
    ("long window", "lag"),
}
"""Each velocity and each part once; the other pairs take as long again."""


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        pytest.param(*pair, marks=[] if pair in BOTH else pytest.mark.ci)
        for pair in product(FILTERED, WITH)
    ],
)
def test_the_boundary_to_12_digits_of_its_scale(name, parts):
    rng = np.random.default_rng(3)
    for delay in (0.0, 2.0, 3.25):
        gamma, delta = 10 ** rng.uniform(-5, 0), 10 ** rng.uniform(-4, 0)
        engine = Engine(gamma, delta, delay, 1.0, 1.0, FILTERED[name], WITH[parts][0])
        theta = 10 ** rng.uniform(-3, np.log10(3.1), 3)
        K, B = engine.stability_boundary(theta)
        if parts == "plain":  # as users ask, in Hz
            loop = {"sampling_period": 1.0, "delay": delay, "velocity": FILTERED[name]}
            scene = Scene(mass=1.0, damping=delta, stiffness=gamma, **loop)
            K, B = scene.stability_boundary(theta / (2 * np.pi))
        for at, k, c in zip(theta, K, B, strict=True):
            true_K, true_B = exact(gamma, delta, delay, WITH[parts][1], name, at)
            # the determinant of two masses has four rows: its last digits count at small angles
            scale = max(abs(true_K) + abs(true_B), 0.01 if parts == "motor" else 0)
            assert abs(k - true_K) + abs(c - true_B) < 1e-12 * scale, (delay, at)


def test_a_limit_is_a_supremum():
    """Just below it is stable, just above it is not."""
    dice = np.random.default_rng(8)
    for name in ("weight", "second order by Tustin", "window", "measured"):
        for parts in PARTS:
            velocity, _ = VELOCITIES[name](dice)
            given = tuple(part for part, _ in PARTS[parts](dice))
            engine = Engine(0.0, 0.05, 1.5, 1.0, 1.0, velocity, given)
            B = np.linspace(-0.02, 0.3, 9)
            K, _ = engine.trace.limits(B)
            there = ~np.isnan(K)
            assert there.any()
            assert engine.is_stable(K[there] * (1 - 1e-9), B[there]).all()
            assert not engine.is_stable(K[there] * (1 + 1e-9), B[there]).any()
            most = engine.trace.max_stiffness
            assert most.alpha >= np.nanmax(K) * (1 - 1e-12)
            softer = most.alpha * (1 - 1e-9)  # a tip may lean, so that it has another damping
            ((low, high),) = engine.trace.dampings(np.array([softer]))[0]
            assert engine.is_stable(softer, (low + high) / 2)
            assert (low + high) / 2 == pytest.approx(most.beta, rel=1e-4, abs=1e-4)


def test_windows_of_the_delay_beside_eigenvalues():
    """A stiff device has two windows; eigenvalues tell on which side of each end it is stable."""
    scene = Scene(mass=0.1, damping=1.0, stiffness=3e5, sampling_period=0.001)
    windows = scene.stable_delays(K=8e4, B=-90.0, up_to=0.008)
    assert len(windows) == 2
    wall, kind = difference_equation([1.0], [1.0])
    A = device(3.0, 0.01)

    def stable(delay):
        roots = np.linalg.eigvals(matrix(*A, 0.8, -0.9, delay, wall, kind))
        return np.abs(roots).max() < 1

    for low, high in windows:
        for end, inside in ((low, 1), (high, -1)):
            assert stable(1000 * end + 1e-6 * inside)
            assert not stable(1000 * end - 1e-6 * inside)
    told = [any(low < t / 1000 < high for low, high in windows) for t in np.arange(0.05, 8, 0.25)]
    assert told == [stable(t) for t in np.arange(0.05, 8, 0.25)]


def test_a_window_that_begins_where_an_angle_of_equal_parts_comes():
    """At 0.1227 periods |A| = |W| comes in at z = -1; an end next to it is no end of a cell."""
    gamma, delta, alpha, beta = 0.0, 0.21691966406662178, 0.5956560359120588, 2.7000869941962473
    ((low, high),) = Engine(gamma, delta, 0.0, 1.0, 1.0, Measured()).stable_delays(
        alpha, beta, 0.0, 8.0
    )
    kind = {"past": 2, "outs": 0, "measured": True}

    def largest(delay):
        found = matrix(*device(gamma, delta), alpha, beta, delay, None, kind)
        return np.abs(np.linalg.eigvals(found)).max()

    for end in (low, high):
        assert largest(end) == pytest.approx(1, abs=1e-9)
    assert largest(low - 1e-6) > 1 > largest(low + 1e-6)
    assert largest(high - 1e-6) < 1 < largest(high + 1e-6)


def test_the_margin_ends_its_window():
    scene = Scene(
        mass=0.1, damping=1.0, sampling_period=0.001, delay=0.001, velocity=LowPass(cutoff=100)
    )
    margin = scene.delay_margin(K=800.0, B=2.0)
    ((low, high),) = scene.stable_delays(K=800.0, B=2.0, up_to=0.01)
    assert low == 0
    assert high == pytest.approx(0.001 + margin, rel=1e-12)
    assert scene.max_delay(800.0, 2.0) == pytest.approx(high, rel=1e-12)
    assert scene.delay_margin(1e6, 2.0) == 0


def test_a_wall_that_is_weaker_than_the_device_bears_any_delay():
    """By small gain: no step of this overdamped device passes 1/k, and K + 2 B/T < k."""
    scene = Scene(
        mass=1.0, damping=3.0, stiffness=2.0, sampling_period=1.0, velocity=LowPass(weight=0.5)
    )
    assert scene.delay_margin(K=0.05, B=0.01) == math.inf


@pytest.mark.parametrize("spring", [None, 400.0])
def test_region_of_a_paper_loop_is_the_paper_loop_s(spring):
    """A virtual mass of 1e-13 kg changes nothing, but the general engine answers."""
    own = {"mass": 0.1, "damping": 0.5, "sampling_period": 0.001, "delay": 0.0015}
    own["stiffness"] = spring
    mine, paper = Scene(**own, virtual_mass=1e-13).stable_region(), Scene(**own).stable_region()
    assert mine.area == pytest.approx(paper.area, rel=1e-5)
    assert pytest.approx(paper.max_stiffness.K, rel=1e-9) == mine.max_stiffness.K
    assert pytest.approx(paper.max_damping.B, rel=1e-9) == mine.max_damping.B
    assert len(mine.corners) == len(paper.corners)


@pytest.mark.parametrize("delay", [0, 1, 2, 5])
def test_next_to_the_stiffest_wall_there_are_dampings(delay):
    """Of a free mass, a part in 1e9 below: K = 4 t^2 cos((d + 1) theta) with t = tan(theta/2).

    Its walls lie between two angles that differ by less than any grid has.
    """
    n = mp.mpf(delay + 1)
    theta = mp.findroot(lambda x: 2 / mp.sin(x) - n * mp.tan(n * x), 1.07 / n)
    most = 4 * mp.tan(theta / 2) ** 2 * mp.cos(n * theta)
    best = 2 * mp.tan(theta / 2) * mp.sin(n * theta) - most / 2
    trace = Engine(0.0, 0.0, delay, 1.0, 1.0, Difference(), ()).trace
    [[(low, high)]] = trace.dampings(np.array([float(most) * (1 - 1e-9)]))
    assert low < best < high
    assert high - low < 1e-3
    assert trace.dampings(np.array([float(most) * (1 + 1e-9)])) == [[]]


@pytest.mark.parametrize(
    ("order", "mapping", "tau", "stable"),
    [
        (2, "backward Euler", 100.0, (0.0042, -0.42)),
        (2, "Tustin", 200.0, (0.002, -0.3)),
        (2, "backward Euler", 10.0, (0.1021, -1.382)),
        (1, "Tustin", 20.0, (1.8027, -34.7804)),
    ],
)
def test_walls_beside_a_pole_of_the_boundary_are_seen(order, mapping, tau, stable):
    """A slow filter is stable with much negative damping, by eigenvalues; no wall was found."""

    def grows(K, B):
        wall, kind = difference_equation(*low_pass(tau, order, mapping))
        return sizes(matrix(*device(0.0, 7e-5), K, B, 1.0, wall, kind)).max() > 1

    assert not grows(*stable)
    scene = Scene(
        mass=1.0,
        damping=7e-5,
        sampling_period=1.0,
        delay=1.0,
        velocity=LowPass(time_constant=tau, order=order, mapping=mapping),
    )
    stiffest = scene.max_stable_stiffness()
    assert stiffest > stable[0]
    assert not grows(stiffest * (1 - 1e-3), scene.damping_for(stiffest * (1 - 1e-3)))
    assert grows(stiffest * (1 + 1e-3), stiffest.B)
    assert scene.stable_region().contains(*stable)

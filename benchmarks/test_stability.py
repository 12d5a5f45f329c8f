"""Boundaries and root counts beside the paper's grid, eigenvalues, SciPy and python-control.

`.venv/bin/pytest benchmarks/test_stability.py --benchmark-only -s`; ratios within one run count,
since the machine is shared.
"""

import resource
import statistics
import time

import numpy as np
import pytest
from scipy.signal import cont2discrete

from symhaptic import (
    characteristic_polynomial,
    delay_margin,
    is_stable,
    max_stable_stiffness,
    stability_boundary,
    stable_region,
)
from symhaptic.numeric.tracing.grid import grid_boundary

GAMMA, DELTA = 0.001, 0.02
RNG = np.random.default_rng(0)


def seconds(work, rounds=5):
    """Median time of a call."""
    times = []
    for _ in range(rounds):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def say(text):
    print(f"\n    {text}", end="")


@pytest.mark.parametrize("delay", [0, 1, 2, 4, 8])
def test_boundary_points_beside_the_grid(benchmark, delay):
    """The paper's method with 61 x 61 nodes around the region, to 1e-8."""
    left, low, right, high = stable_region(GAMMA, DELTA, delay).polygon.bounds
    wide, tall = right - left, high - low
    alphas = np.linspace(left - 0.1 * wide, right + 0.1 * wide, 61)
    betas = np.linspace(low - 0.1 * tall, high + 0.1 * tall, 61)
    found = grid_boundary(GAMMA, DELTA, delay, alphas, betas, 1e-8)
    slow = seconds(lambda: grid_boundary(GAMMA, DELTA, delay, alphas, betas, 1e-8), 3)
    angles = np.linspace(0.01, 3.1, 10**6)
    benchmark.pedantic(stability_boundary, (angles, GAMMA, DELTA, delay), rounds=5)
    quick = benchmark.stats.stats.median
    ratio = (slow / len(found)) / (quick / angles.size)
    benchmark.extra_info["times faster per point than the grid"] = round(ratio)
    say(
        f"d = {delay}: grid {1e6 * slow / len(found):.0f} us a point ({len(found)} points), "
        f"explicit {1e9 * quick / angles.size:.0f} ns, ratio {ratio:.0f}"
    )


WALLS = 10**6


@pytest.fixture(scope="module")
def walls():
    gamma, delta = RNG.uniform(0, 10, WALLS), RNG.uniform(0, 2, WALLS)
    return RNG.normal(size=WALLS), RNG.normal(size=WALLS), gamma, delta


@pytest.mark.parametrize("delay", [0, 1, 12, 1000, 10**6, 0.5])
def test_is_stable(benchmark, walls, delay):
    benchmark.pedantic(is_stable, (*walls, delay), rounds=5)
    here = benchmark.stats.stats.median
    one = seconds(lambda: is_stable(*walls, 1))
    benchmark.extra_info["time over that of d = 1"] = round(here / one, 2)
    say(f"d = {delay}: {1e6 * here / WALLS:.2f} us a wall, {here / one:.2f} times that of d = 1")


@pytest.mark.parametrize("delay", [0, 1, 12, 100])
def test_is_stable_beside_eigenvalues(benchmark, delay):
    """Companion eigenvalues on stacks, the plant's numbers given; and one wall at a time."""
    count = 2000
    al, be = RNG.normal(size=(2, count)) * 0.1
    rows = np.array(
        [characteristic_polynomial(a, b, GAMMA, DELTA, delay) for a, b in zip(al, be, strict=True)]
    )
    companion = np.zeros((count, delay + 3, delay + 3))
    companion[:, 0] = -rows[:, 1:]
    companion[:, range(1, delay + 3), range(delay + 2)] = 1.0
    slow = seconds(lambda: np.abs(np.linalg.eigvals(companion)).max(axis=1) < 1, 3)
    benchmark.pedantic(is_stable, (al, be, GAMMA, DELTA, delay), rounds=9)
    ratio = slow / benchmark.stats.stats.median
    benchmark.extra_info["times faster than stacked eigenvalues"] = round(ratio)
    say(f"d = {delay}: {1e6 * slow / count:.1f} us a wall by eigenvalues, ratio {ratio:.0f}")


def by_scipy(alpha, beta, gamma, delta, delay):
    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    p = np.concatenate([bottom, np.zeros(delay + 1)])
    p[-3:] += np.convolve(top[0][1:], [alpha + beta, -beta])
    return np.abs(np.roots(p)).max() < 1


def by_control(alpha, beta, gamma, delta, delay):
    control = pytest.importorskip("control")
    device = control.sample_system(control.tf([1], [1, delta, gamma]), 1.0, "zoh")
    wall = control.tf([alpha + beta, -beta], [1] + [0] * (delay + 1), 1.0)
    return np.abs(control.feedback(device, wall).poles()).max() < 1


@pytest.mark.parametrize("peer", [by_scipy, by_control])
def test_one_wall_beside_peers(benchmark, peer):
    """From the plant's parameters to a verdict, as a script would write it."""
    given = (0.1, 0.4, GAMMA, DELTA, 1)
    assert bool(peer(*given)) is bool(is_stable(*given))
    slow = seconds(lambda: peer(*given), 50)
    benchmark.pedantic(is_stable, given, rounds=50)
    ratio = slow / benchmark.stats.stats.median
    benchmark.extra_info[f"times faster than {peer.__name__}"] = round(ratio, 1)
    say(f"{peer.__name__}: {1e3 * slow:.2f} ms, ratio {ratio:.1f}")


@pytest.mark.parametrize("kind", ["whole", "fractional"])
def test_max_stable_stiffness(benchmark, kind):
    """The paper's ranges (23), delays up to 8."""
    gamma, delta = RNG.uniform(0, GAMMA, WALLS), RNG.uniform(0, DELTA, WALLS)
    delay = RNG.integers(0, 9, WALLS) if kind == "whole" else RNG.uniform(0, 8, WALLS)
    benchmark.pedantic(max_stable_stiffness, (gamma, delta, delay), rounds=1)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    say(f"{kind}: {benchmark.stats.stats.median:.1f} s for 10^6 sets, process at {peak:.2f} GB")


def test_max_stable_stiffness_of_stiff_springs(benchmark):
    """gamma up to pi^2 and d up to 8: many regions are traced whole."""
    count = 1000
    gamma, delta = RNG.uniform(0, np.pi**2, count), RNG.uniform(0, DELTA, count)
    delay = RNG.integers(0, 9, count)
    benchmark.pedantic(max_stable_stiffness, (gamma, delta, delay), rounds=1)
    say(f"{1e3 * benchmark.stats.stats.median / count:.2f} ms a set")


def test_delay_margin(benchmark):
    count = 2000
    al, be = RNG.uniform(0, 0.05, count), RNG.uniform(0, 0.5, count)
    benchmark.pedantic(delay_margin, (al, be, GAMMA, DELTA), rounds=1)
    say(f"{1e6 * benchmark.stats.stats.median / count:.0f} us a wall")


@pytest.mark.parametrize("delay", [0, 1, 2, 8, 0.5])
def test_stable_region(benchmark, delay):
    benchmark.pedantic(stable_region, (GAMMA, DELTA, delay), rounds=5)
    say(f"d = {delay}: {1e3 * benchmark.stats.stats.median:.0f} ms")

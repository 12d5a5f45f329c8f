"""Root counts, stiffnesses and margins of many walls.

`.venv/bin/pytest benchmarks/test_stability.py --benchmark-only -s`.  The comparison with the
paper's grid, eigenvalues, SciPy and python-control is part of `symhaptic bench`.
"""

import resource
import statistics
import time

import numpy as np
import pytest

from symhaptic import delay_margin, is_stable, max_stable_stiffness, stable_region

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

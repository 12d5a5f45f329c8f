"""The numeric functions against eigenvalues, certified roots and mpmath, on many loops."""

import numpy as np
import pytest
from oracle import certified, each, loops, mp_outside, radius, residual

from symhaptic import is_stable, stability_boundary, unstable_roots


def random_loops(rng, count, delays):
    """Walls over several sizes and plants over the whole domain, borders included."""
    gamma = rng.choice([0.0, 1e-3, 1.0], count) * rng.random(count)
    wide = rng.random(count) < 0.5
    gamma = np.where(wide, rng.uniform(0, np.pi**2 + 1, count), gamma)
    delta = rng.choice([0.0, 0.02, 2.0, 20.0], count) * rng.random(count)
    size = 10.0 ** rng.uniform(-4, 1, count)
    alpha, beta = rng.normal(size=(2, count)) * size
    return np.where(rng.random(count) < 0.6, np.abs(alpha), alpha), beta, gamma, delta, delays


@pytest.mark.parametrize(
    ("seed", "delays", "count"),
    [(1, np.arange(13.0), 20_000), (2, np.array([0.25, 0.5, 1.3, 2.999, 7.6, 11.01]), 8_000)],
    ids=["whole", "fractional"],
)
def test_stability_is_that_of_the_eigenvalues(seed, delays, count):
    """28 000 loops; those within 1e-9 of the circle are beyond what eigenvalues can tell."""
    rng = np.random.default_rng(seed)
    case = random_loops(rng, count, rng.choice(delays, count))
    largest = radius(*case)
    clear = np.abs(largest - 1) > 1e-9
    assert clear.sum() > 0.9 * count
    wrong = np.flatnonzero(clear & (is_stable(*case) != (largest < 1)))
    assert not wrong.size, [[float(v[wrong[0]]) for v in case], float(largest[wrong[0]])]
    assert 0.1 < np.mean(largest < 1) < 0.9


def test_the_count_is_that_of_the_eigenvalues():
    rng = np.random.default_rng(3)
    count = 6000
    case = random_loops(rng, count, rng.choice([0.0, 1.0, 2.5, 6.0], count))

    def outside(*some):
        sizes = np.abs(np.linalg.eigvals(loops(*some)))
        near = np.min(np.abs(sizes - 1), axis=-1) < 1e-8
        return np.where(near, -1, np.sum(sizes > 1, axis=-1))

    expected = each(outside, *case)
    clear = expected >= 0
    assert clear.sum() > 0.8 * count  # a wall of nothing, an undamped plant leave roots at 1
    assert np.array_equal(unstable_roots(*case)[clear], expected[clear])


def beside_the_boundary(rng, delays):
    """A wall at a relative distance of 1e-12 from a point of the boundary, and its loop."""
    gamma = rng.choice([0.0, rng.uniform(0, 1e-3), rng.uniform(0, np.pi**2)])
    delta = rng.choice([0.0, 0.02, rng.uniform(0, 2)])
    delay, theta = rng.choice(delays), rng.uniform(0.05, 3.09)
    alpha, beta = (float(v) for v in stability_boundary(theta, gamma, delta, delay))
    away = rng.choice([-1, 1]) * 1e-12
    return alpha * (1 + away), beta * (1 + rng.choice([-1, 1]) * away), gamma, delta, delay


def test_within_1e_12_of_the_boundary_the_count_is_the_certified_one():
    """1000 loops with roots in balls of 256 bits; -1 says that floats do not tell."""
    rng = np.random.default_rng(4)
    delays = [0, 1, 2, 3, 5, 8, 0.5, 1.25, 3.9]
    untold = 0
    for _ in range(1000):
        case = beside_the_boundary(rng, delays)
        found = int(unstable_roots(*case))
        untold += found == -1
        assert found in (certified(*case), -1), case
    assert untold < 10


def test_the_certified_count_is_that_of_mpmath_at_60_digits():
    """The oracle itself, by another library."""
    rng = np.random.default_rng(5)
    for _ in range(25):
        case = beside_the_boundary(rng, [0, 1, 2, 0.5])
        assert certified(*case) == mp_outside(*case)


@pytest.mark.parametrize("sheet", ["exact", "principal"])
def test_residual_of_traced_points(sheet):
    """gamma to pi^2, delta to 2, d to 1000, angles close to both ends: at most 1e-13."""
    rng = np.random.default_rng(6)
    for _ in range(100):
        gamma = rng.choice([0.0, 10 ** rng.uniform(-9, 0), rng.uniform(0, np.pi**2), np.pi**2])
        delta = rng.choice([0.0, 10 ** rng.uniform(-9, 0), rng.uniform(0, 2)])
        delay = rng.choice([0, 1, 1000, rng.integers(0, 1001), rng.uniform(0, 1000)])
        theta = rng.choice(
            [rng.uniform(0, np.pi), 10 ** rng.uniform(-5, 0), np.pi - 10 ** rng.uniform(-5, 0)]
        )
        wall = stability_boundary(theta, gamma, delta, delay, sheet=sheet)
        found = residual(*wall, theta, gamma, delta, delay, sheet=sheet)
        assert found <= 1e-13, (theta, gamma, delta, delay)

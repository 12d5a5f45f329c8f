"""The rules in circulation, by eigenvalues of the loop and by simulation."""

import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import page

pytestmark = pytest.mark.ci

RNG_WALLS = 60


def table_1(K, B, T, m, b, k):
    """alpha, beta, gamma and delta."""
    return K * T**2 / m, B * T / m, k * T**2 / m, b * T / m


def arms(seed):
    """T, m, b and k, over the decades that devices have."""
    rng = np.random.default_rng(seed)
    for _ in range(RNG_WALLS):
        yield 10 ** rng.uniform(-4, -2), *10 ** rng.uniform((-2, -2, 0), (1, 1, 3))


@guards("s8a_twice_the_damping")
def test_twice_the_damping_is_stable_without_delay_and_not_with_it():
    for T, m, b, k in arms(1):
        for share in (0.1, 0.9, 1.0):
            wall = table_1(share * 2 * b / T, 0.0, T, m, b, k)
            assert oracle.stable(*wall, 0)
    assert not oracle.stable(1.0, 0.0, 0.0, 0.5, 1)
    assert motion.grows(motion.positions(1.0, 0.0, 1.0, 0.5, 0.0, 1.0, 1, steps=400))


@guards("s8b_damping_over_delay")
def test_damping_over_delay_is_stable_with_little_virtual_damping_only():
    rng = np.random.default_rng(2)
    for T, m, b, k in arms(3):
        d = int(rng.integers(0, 6))
        B = rng.uniform(-0.99, d / (2 * d + 3)) * b
        K = rng.uniform(0.01, 0.999) * (b + B) / ((d + 0.5) * T)
        assert oracle.stable(*table_1(K, B, T, m, b, k), d)
    assert not oracle.stable(1.0, 3.0, 0.0, 1.0, 0)


@guards("s8c_four_masses")
@pytest.mark.parametrize("rule", ["rules:four-masses", "rules:two-masses"])
def test_without_damping_no_stiffness_is_stable(rule):
    for alpha in 10.0 ** np.arange(-6, 1):
        # the two roots of z^2 - (2 - a/2) z + 1 + a/2 have the product 1 + a/2
        roots = np.roots([1, -(2 - alpha / 2), 1 + alpha / 2])
        assert np.prod(roots).real == pytest.approx(1 + alpha / 2)
        assert np.abs(roots).max() > 1
    at = page("s8c_four_masses").settled[rule].verdict.counterexample
    assert motion.grows(motion.positions(*(float(at[s]) for s in "KBmbkT"), 0, steps=400))


@guards("s8e_damped_contact")
def test_the_exact_limit_of_a_free_mass_lies_below_the_rule():
    for beta in np.linspace(0.05, 1.95, 20):
        exact, rule = 2 * beta * (2 - beta) / (2 + beta), 2 * beta - beta**2 / 2
        assert oracle.stable(0.999 * exact, beta, 0, 0, 0)
        assert not oracle.stable(1.001 * exact, beta, 0, 0, 0)
        assert rule > 1.001 * exact
    assert not oracle.stable(1.0, 1.0, 0, 0, 0)


@guards("s8f_which_rule")
def test_every_row_of_the_table_is_safe():
    """Rows one to four at random arms; the fifth is the boundary itself."""
    for T, m, b, k in arms(4):
        for d in (0, 1, 3):
            best = 2 * b / T * np.tan(np.pi / (4 * (d + 1)))
            x = np.pi / (2 * (d + 1))
            B = b * (np.cos(x) - d / (d + 1)) / np.sin(x)
            assert oracle.stable(*table_1(best, B, T, m, b, k), d)
        B = 0.7 * m / T
        K = 0.99 * 2 * B * (2 * m - B * T) / (T * (2 * m + B * T))
        assert oracle.stable(*table_1(K, B, T, m, 0.0, 0.0), 0)

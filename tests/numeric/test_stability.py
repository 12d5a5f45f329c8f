"""Root counts where they are hard: weak walls, double roots, the principal sheet, the boundary."""

from fractions import Fraction

import numpy as np
import pytest
from oracle import certified, principal

from symhaptic import is_stable, stability_boundary, unstable_roots


@pytest.mark.parametrize("delta", [0.0, 1e-10, 1e-6, 1e-3])
@pytest.mark.parametrize("part", [0.0, 0.375])
def test_walls_that_hardly_touch_a_spring_without_damping(delta, part):
    """|A| at the spring's own frequency is as small as the wall, down to 1e-12."""
    rng = np.random.default_rng(91)
    for size in (1e-2, 1e-6, 1e-8, 1e-10, 1e-12):
        for _ in range(12):
            alpha, beta = (float(v) for v in rng.normal(size=2) * size)
            case = alpha, beta, rng.uniform(0.01, 9.8), delta, rng.integers(0, 9) + part
            assert int(unstable_roots(*case)) == certified(*case), case


WEAK = [  # alpha, beta, gamma, delta
    (1.1846412522561189e-4, 2.6941183355201387e-4, 2.763245321481284, 1.6408720287e-4),
    (-4.3255876351941456e-4, -2.006717262228217e-4, 4.294311055789182, 2.92149798e-4),
]


@pytest.mark.parametrize(("which", "delay"), [(0, 0.25198146964470475), (1, 1.772162413996871)])
def test_delays_next_to_the_loss_of_a_weak_wall(which, delay):
    """Two crossings beside the spring's own frequency, 4e-4 apart."""
    loop = WEAK[which]
    for step in (1e-6, 1e-8, 1e-9):
        for late in (delay - step, delay + step):
            assert int(unstable_roots(*loop, late)) == certified(*loop, late)


@pytest.mark.parametrize("end", [0.0, np.pi], ids=["root at 1", "root at -1"])
def test_beside_the_boundary_close_to_its_ends(end):
    """300 walls a relative 1e-13 to 1e-12 beside points whose pair nearly meets at 1 or at -1.

    At right angles to the boundary: along it a wall may come back to it.
    """
    rng = np.random.default_rng(92)
    for _ in range(300):
        size = 10 ** rng.uniform(-4, -2)
        gamma, delta, delay = rng.uniform(0, 9.5), rng.uniform(0.05, 2), int(rng.integers(0, 9))
        angles = np.abs(end - size * np.array([0.999, 1, 1.001]))
        walls = np.array(stability_boundary(angles, gamma, delta, delay))
        along = (walls[:, 2] - walls[:, 0]) / walls[:, 1]
        aside = np.array([-along[1], along[0]]) / np.hypot(*along)
        away = rng.choice([-1, 1]) * 10 ** rng.uniform(-13, -12) * aside
        alpha, beta = (float(v) for v in walls[:, 1] * (1 + away))
        case = alpha, beta, gamma, delta, delay
        assert int(unstable_roots(*case)) == certified(*case), (size, case)


def test_principal_sheet_beside_the_roots_in_the_cut_plane():
    """Roots of the polynomial in z^(1/q) with |arg z| < pi, for delays in eighths and sevenths."""
    rng = np.random.default_rng(93)
    compared = 0
    for _ in range(600):
        delay = Fraction(int(rng.integers(0, 40)), int(rng.choice([7, 8])))
        if delay.denominator == 1:
            continue
        gamma = rng.choice([0.0, rng.uniform(0, np.pi**2)])
        delta = rng.choice([0.0, rng.uniform(0, 2)])
        alpha, beta = (float(v) for v in rng.normal(size=2) * 10 ** rng.uniform(-4, 1))
        sizes = principal(alpha, beta, gamma, delta, delay)
        if np.min(np.abs(sizes - 1), initial=1) < 1e-7:
            continue
        compared += 1
        found = unstable_roots(alpha, beta, gamma, delta, float(delay), sheet="principal")
        assert int(found) == np.sum(sizes > 1), (alpha, beta, gamma, delta, delay)
    assert compared > 300


def test_the_principal_sheet_of_a_whole_delay_is_the_delay_itself():
    rng = np.random.default_rng(94)
    count = 20_000
    loops = (*rng.normal(size=(2, count)) * 5, rng.uniform(0, 10, count), rng.uniform(0, 2, count))
    delay = rng.integers(0, 6, count)
    exact = unstable_roots(*loops, delay)
    assert np.array_equal(unstable_roots(*loops, delay, sheet="principal"), exact)
    odd = exact % 2 == 1  # a real root left of -1 or right of 1, which a sheet might lose
    assert odd.sum() > 1000
    assert not is_stable(*loops, delay, sheet="principal")[odd].any()


@pytest.mark.parametrize("delay", [0, 3, 0.5])
def test_points_of_the_boundary_themselves(delay):
    """On the circle but for rounding: an answer, and one of those of both sides."""
    theta = np.linspace(0.05, 3.1, 200)
    alpha, beta = stability_boundary(theta, 1.7, 0.3, delay)
    here = unstable_roots(alpha, beta, 1.7, 0.3, delay)
    sides = [
        unstable_roots(alpha + a, beta + b, 1.7, 0.3, delay)
        for a in (-1e-6, 0, 1e-6)
        for b in (-1e-6, 0, 1e-6)
    ]
    assert np.all(here >= np.min(sides, axis=0))
    assert np.all(here <= np.max(sides, axis=0))

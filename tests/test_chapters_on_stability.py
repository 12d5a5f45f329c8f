"""The chapters on stability, seen by another road: companion eigenvalues and time-domain energy."""

from fractions import Fraction

import numpy as np
import pytest
from scipy.signal import cont2discrete

RNG = np.random.default_rng(20)


def polynomial(alpha, beta, gamma, delta, d):
    """Characteristic polynomial from SciPy's zero-order hold, highest power first."""
    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    n1, n0 = top[0][1], top[0][2]
    p = np.concatenate([bottom, np.zeros(d + 1)])
    p[-3:] += np.convolve([n1, n0], [alpha + beta, -beta])
    return p


def margin(theta, alpha, beta, delta, d):
    """delta - (alpha (1/2 + sum of cos i theta) - beta cos (d+1) theta), Fejer's textbook form."""
    kernel = 0.5 + sum(np.cos(i * theta) for i in range(1, d + 1))
    return delta - alpha * kernel + beta * np.cos((d + 1) * theta)


@pytest.mark.parametrize("d", [0, 1, 2, 5])
def test_passive_walls_are_stable_for_every_spring(d):
    """s5a-subset and s5c-robust-subset: eigenvalues of 50 random passive walls per delay."""
    theta = np.linspace(1e-3, np.pi, 4000)
    found = 0
    while found < 50:
        delta = RNG.uniform(0.01, 2)
        alpha, beta = RNG.uniform(0, 2.1 * delta), RNG.uniform(-delta, delta)
        # 1e-2: away from the border, so that a fine grid decides it
        if margin(theta, alpha, beta, delta, d).min() < 1e-2 * delta:
            continue
        found += 1
        for gamma in (1e-3, RNG.uniform(0, 12)):
            assert np.abs(np.roots(polynomial(alpha, beta, gamma, delta, d))).max() < 1


@pytest.mark.parametrize("d", [0, 1, 3, 7])
def test_each_point_of_the_explicit_boundary_has_a_root_on_the_circle(d):
    """explicit-boundary: Q = -z^d A/N solved by hand for random plants."""
    for _ in range(100):
        gamma, delta, theta = RNG.uniform(0, 9), RNG.uniform(0, 2), RNG.uniform(0.05, 3.1)
        top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
        z = np.exp(1j * theta)
        q = -(z**d) * np.polyval(bottom, z) / np.polyval(top[0][1:], z)
        beta = q.imag / np.sin(theta)
        alpha = q.real - beta * (1 - np.cos(theta))
        p = polynomial(alpha, beta, gamma, delta, d)
        size = np.abs(p).sum()  # rounding of a sum of terms of this size
        assert abs(np.polyval(p, z)) < 1e-12 * size


@pytest.mark.parametrize("d", [0, 1, 4])
def test_the_free_mass_in_closed_form(d):
    """alpha = 4 tan(theta/2)^2 cos(d+1) theta and its beta put a root at exp(j theta)."""
    for theta in (0.3, 1.0, 2.0):
        half = np.tan(theta / 2)
        alpha = 4 * half**2 * np.cos((d + 1) * theta)
        beta = 2 * half * np.sin((d + 0.5) * theta) / np.cos(theta / 2)
        # (z-1)^2 z^(d+1) + (z+1)/2 ((alpha+beta) z - beta): the free mass by hand
        z = np.exp(1j * theta)
        value = (z - 1) ** 2 * z ** (d + 1) + (z + 1) / 2 * ((alpha + beta) * z - beta)
        assert abs(value) < 1e-13 * (1 + abs(alpha) + abs(beta))  # a few roundings


def test_without_damping_the_nyquist_spring_leaves_a_root_at_minus_one():
    """s5c-undamped-limit: for gamma = pi^2 the plant is (1 - cos pi)/pi^2 (z+1)/(z+1)^2."""
    for d in (0, 1, 6):
        p = np.concatenate([[1.0, 2.0, 1.0], np.zeros(d + 1)])
        alpha, beta = RNG.normal(size=2)
        p[-3:] += 2 / np.pi**2 * np.convolve([1, 1], [alpha + beta, -beta])
        assert abs(np.polyval(p, -1.0)) < 1e-14 * np.abs(p).sum()


def energy(k, b_wall, b, first, second, periods):
    """Energy that a motion leaves to damper and wall, T = 1, the force half a period late."""
    total, place, before, late = 0, 0, 0, 0
    for sign in [1] * periods + [-1] * periods:
        force = k * place + b_wall * (place - before)
        for step, pushed in ((sign * first, late), (sign * second, force)):
            total += b * step**2 / Fraction(1, 2) + pushed * step  # least loss: constant speed
        place, before, late = place + sign * (first + second), place, force
    assert place == 0
    return total


def test_half_a_period_late_a_wall_that_satisfies_5_gives_energy_away():
    """eq5: -147/20 was found by hand in exact arithmetic, with b = 101/100 > cos(theta/2)."""
    half, one = Fraction(3, 2), Fraction(1)
    assert energy(1, 0, Fraction(101, 100), half, one, 30) == Fraction(-147, 20)


def test_half_a_period_late_the_stiffest_wall_of_11_gives_energy_away():
    """eq11 at d = 1/2: K = 2 tan(pi/6), B = (cos(pi/3) - 1/3)/sin(pi/3) with b = T = 1."""
    stiffness, damping = 2 / np.sqrt(3), (0.5 - 1 / 3) / (np.sqrt(3) / 2)
    assert energy(stiffness, damping, 1.0, Fraction(17, 10), Fraction(1), 30) < -1

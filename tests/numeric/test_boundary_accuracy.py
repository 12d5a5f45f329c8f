"""The explicit boundary keeps its digits near theta = 0 and pi, near half turns, at long delays.

Beside matrix exponentials in mpmath at 60 digits.  A point may be off by what two last places of
its arguments move it, and by two of its own: near a half turn of an undamped device in a period a
last place of gamma moves the boundary by any amount.
"""

import mpmath
import numpy as np
import pytest
from oracle import late_wall, wall

from symhaptic import stability_boundary
from symhaptic.numeric.boundary import tangent
from symhaptic.numeric.plant import device

LOST = (3.1415926535880505, 3562.927169859833, 0.0, 16.427927677033665)
"""19 half turns in a period, fractional: 8 digits of both numbers were lost."""


SMALL = mpmath.mpf(2) ** -70


def off(point):
    """The relative errors of alpha and beta over what is allowed."""
    found, exact = stability_boundary(*point), late_wall(*point)
    allowed = [mpmath.mpf(2)] * 2
    with mpmath.workdps(60):
        for i, x in enumerate(point):
            if x == 0 or (i == 3 and x % 1 == 0):  # exactly: a part that is not there, no fraction
                continue
            near = [x * (1 + SMALL) if j == i else y for j, y in enumerate(point)]
            for k, (moved, there) in enumerate(zip(late_wall(*near), exact, strict=True)):
                allowed[k] += 2 * abs((moved - there) / there) / SMALL
        return max(
            float(abs((float(f) - e) / e) * 2**52 / a)
            for f, e, a in zip(found, exact, allowed, strict=True)
        )


def points(rng, count):
    """Angles near 0 and pi, devices near half turns, hardly damped or not, delays up to 1e12."""
    turns = (rng.integers(1, 40, count) * np.pi) ** 2
    near = turns * (1 + rng.choice([-1, 1], count) * 10 ** rng.uniform(-15, -1, count))
    kind = rng.integers(3, size=count)
    gamma = np.choose(kind, [turns, near, rng.uniform(0, 400, count)])
    delta = np.where(rng.random(count) < 0.4, 0, 10 ** rng.uniform(-16, 1, count))
    small = 10 ** rng.uniform(-12, -0.3, count)
    theta = np.minimum(np.where(rng.random(count) < 0.5, np.pi - small, small), 3.141592653589793)
    delay = np.where(rng.random(count) < 0.5, rng.uniform(0, 40, count),
                     10 ** rng.uniform(0, 12, count))  # fmt: skip
    delay = np.where(rng.random(count) < 0.2, np.floor(delay), delay)
    return [tuple(map(float, row)) for row in zip(theta, gamma, delta, delay, strict=True)]


def test_next_to_pi_and_19_half_turns_no_digit_is_lost():
    found = stability_boundary(*LOST)
    for one, exact in zip(found, late_wall(*LOST), strict=True):
        assert float(abs((float(one) - exact) / exact)) < 1e-15


@pytest.mark.parametrize(("seed", "count"), [(1, 25), pytest.param(2, 100, marks=pytest.mark.slow)])
def test_at_hard_points_it_is_right_to_the_last_places_of_its_arguments(seed, count):
    worst = max(points(np.random.default_rng(seed), count), key=off)
    assert off(worst) < 1, worst


def test_neither_does_the_principal_sheet_lose_digits():
    """Close to pi alpha + 2 beta is far smaller than both: beside mpmath at 60 digits."""
    rng = np.random.default_rng(3)
    for theta, gamma, delta, delay in points(rng, 60):
        exact = wall(theta, gamma, delta, delay)
        found = stability_boundary(theta, gamma, delta, delay, sheet="principal")
        with mpmath.workdps(60):
            turn = theta * (1 + SMALL), gamma, delta, delay
            stiff = theta, gamma * (1 + SMALL), delta, delay
            moved = [wall(*turn), wall(*stiff)]
            for k in range(2):
                allowed = 2 + 2 * sum(abs((m[k] - exact[k]) / exact[k]) for m in moved) / SMALL
                assert abs((float(found[k]) - exact[k]) / exact[k]) * 2**52 < allowed


@pytest.mark.parametrize("delay", [0, 1, 6])
def test_the_tangent_is_the_slope_of_the_boundary(delay):
    """Central differences, to the square of a step of 1e-5."""
    theta, step = np.linspace(0.2, 3.0, 15), 1e-5
    for gamma, delta in ((0.0, 0.0), (0.4, 0.1), (0.2, 2.0)):
        low, high = (stability_boundary(theta + h, gamma, delta, delay) for h in (-step, step))
        slope = (np.array(high) - low) / (2 * step)
        found = tangent(device(np.array(gamma), np.array(delta)), theta, np.array(float(delay)))
        assert np.allclose(found, slope, rtol=1e-6, atol=1e-6 * np.abs(slope).max())

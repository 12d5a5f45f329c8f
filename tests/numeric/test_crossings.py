"""Crossings, the angles at which |A| = |M W|, compared with values in complex numbers."""

import mpmath
import numpy as np
import pytest
from oracle import numbers

from symhaptic.numeric.crossings import crossings, surplus, wall
from symhaptic.numeric.cubic import value
from symhaptic.numeric.plant import device

COUNT = 300


def loops(rng):
    gamma = rng.choice([0.0, 1.0, 9.0, 60.0], COUNT) * rng.random(COUNT)
    delta = rng.choice([0.0, 0.02, 3.0], COUNT) * rng.random(COUNT)
    alpha, beta = rng.normal(size=(2, COUNT)) * rng.choice([0.1, 1.0, 10.0], COUNT)
    return alpha, beta, gamma, delta


def lead(x, alpha, beta, theta):
    """|A|^2 - |M W|^2 at z = exp(j theta), from the coefficients, and the sum of both squares."""
    z = np.exp(1j * theta)
    below = np.abs(z * z - x.a * z + x.e) ** 2
    push = np.abs((x.m2 * z * z + x.m1 * z + x.m0) * ((alpha + beta) * z - beta)) ** 2
    return below - push, below + push


@pytest.mark.parametrize("part", [None, 0.3])
def test_about_each_of_three_points_it_is_the_same_difference_of_squares(part):
    rng = np.random.default_rng(1)
    alpha, beta, gamma, delta = loops(rng)
    x = device(gamma, delta, part)
    s = surplus(x, wall(alpha, beta))
    for theta in rng.uniform(0, np.pi, (5, COUNT)):
        exact, size = lead(x, alpha, beta, theta)
        y = 2 - 2 * np.cos(theta)
        for terms, at in ((s.near, y), (s.own, y - s.center), (s.far, 4 - y)):
            assert (np.abs(value(terms, at) - exact) < 1e-12 * (1 + size + np.abs(beta) ** 2)).all()


@pytest.mark.parametrize("part", [None, 0.3])
def test_between_the_crossings_the_leader_stays_and_at_each_it_changes(part):
    """The sign on a grid of angles changes where a crossing is, to the side that it says."""
    alpha, beta, gamma, delta = loops(np.random.default_rng(2))
    x = device(gamma, delta, part)
    found = crossings(surplus(x, wall(alpha, beta)), part is None)
    theta = np.linspace(1e-3, np.pi - 1e-3, 4000)[:, None]
    signs = lead(x, alpha, beta, theta)[0] > 0
    for rises, way in ((True, 1), (False, -1)):
        at = [
            np.where(c.there & (c.rises == rises), 2 * np.arcsin(np.sqrt(c.y) / 2), 0.0)
            for c in found
        ]
        changes = np.diff(signs.astype(int), axis=0) == way
        between = np.sum([(theta[:-1] < a) & (a <= theta[1:]) for a in at], axis=0)
        assert changes.sum() > COUNT // 3
        assert np.sum(changes != between) <= 2  # pairs closer together than the grid's angles


def next_to_points(rng, count):
    """Weak walls of hardly damped devices that creep, swing and turn by half in a period.

    And large walls next to a root at 1, and next to one at -1.
    """
    kind, sign = rng.integers(0, 5, count), rng.choice([-1, 1], count)
    turn = np.pi * (1 + sign * 10 ** rng.uniform(-6, -4, count))
    free = rng.uniform(0.5, 9, count)
    gamma = np.choose(kind, [np.zeros(count), free, turn**2, free, free])
    delta = np.where(kind < 3, rng.choice([0.0, 1e-9, 1e-7], count), rng.uniform(0.1, 2, count))
    alpha, beta = rng.normal(size=(2, count)) * np.where(kind < 3, 1e-7, 1e5)
    alpha = np.where(kind == 3, -gamma * (1 + sign * 1e-4), alpha)
    x = device(gamma, delta)
    with np.errstate(divide="ignore"):
        line = sign * x.at_minus_one / x.numerator_at_minus_one * (1 + sign * 1e-4)
    return alpha, np.where(kind == 4, (line - alpha) / 2, beta), gamma, delta


def test_next_to_each_of_the_three_points_a_crossing_keeps_its_digits():
    """In mpmath |A| - |M W| has different signs 1e-9 of the least distance before and after it."""
    loops = next_to_points(np.random.default_rng(3), 80)
    found = crossings(surplus(device(*loops[2:]), wall(*loops[:2])), True)
    nearest = []
    for i, (alpha, beta, gamma, delta) in enumerate(np.transpose(loops).tolist()):
        n1, n0, a, e = numbers(gamma, delta)
        with mpmath.workdps(60):
            center = 2 * (1 - a + e) / (1 + e)
            for c in found:
                if c.there[i]:
                    three = [(c.y[i], 0, 1), (c.rest[i], 4, -1), (c.off[i], center, 1)]
                    near, point, way = min(three, key=lambda one: abs(one[0]))
                    signs = set()
                    for beside in (1 - 1e-9, 1 + 1e-9):
                        y = point + way * mpmath.mpf(float(near)) * beside
                        z = mpmath.expj(mpmath.acos(1 - y / 2))
                        push = (n1 * z + n0) * ((mpmath.mpf(alpha) + beta) * z - beta)
                        signs.add(abs(z * z - a * z + e) > abs(push))
                    nearest.append(point)
                    assert len(signs) == 2
    assert nearest.count(0) > 9
    assert nearest.count(4) > 3
    assert len(nearest) > 50

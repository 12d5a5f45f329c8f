"""The characteristic polynomial of each scene has the loop's own poles for roots."""

import numpy as np
import pytest
import sympy as sp
from scipy.signal import cont2discrete

from symhaptic.model import loop
from symhaptic.model.parts import ALL, FULL, Parts

alpha, beta, gamma, delta, d, z, T, m = sp.symbols("alpha beta gamma delta d z T m")
# Chosen: a stable and an unstable wall on a soft arm.
VALUES = {alpha: 0.11, beta: 0.23, gamma: 0.4, delta: 0.3}
STRONG = {alpha: 1.7, beta: -0.6, gamma: 0.05, delta: 0.02}


def step_matrix(parts, values, delay):
    """One period of the loop as a matrix: position, speed, last position, forces on their way."""
    stiffness = values[gamma] if parts.stiffness else 0.0
    damping = values[delta] if parts.damping else 0.0
    law, push = np.array([[0.0, 1.0], [-stiffness, -damping]]), np.array([[0.0], [1.0]])
    phi, held, *_ = cont2discrete((law, push, np.eye(2), np.zeros((2, 1))), 1.0, method="zoh")
    memory = 1 if parts.virtual_damping else 0
    size = 2 + memory + delay
    force = np.zeros(size)
    force[0] = -values[alpha]
    if memory:
        force[0] -= values[beta]
        force[2] = values[beta]
    step = np.zeros((size, size))
    step[:2, :2] = phi
    if memory:
        step[2, 0] = 1.0
    if delay:
        first, last = 2 + memory, size - 1
        step[:2, last] += held[:, 0]
        step[first] = force
        for i in range(first + 1, size):
            step[i, i - 1] = 1.0
    else:
        step[:2] += np.outer(held[:, 0], force)
    return step


def polynomial(parts, values, delay):
    expr = loop.characteristic(parts).subs({d: delay} if parts.delay else {})
    exact = expr.subs({s: sp.Float(repr(v), 40) for s, v in values.items()}).evalf(40)
    coefficients = sp.Poly(sp.expand(exact), z).all_coeffs()
    return np.array([complex(c.evalf(30)) for c in coefficients])


CASES = [(p, n) for p in ALL for n in ([0, 1, 4] if p.delay else [0])]


@pytest.mark.parametrize("values", [VALUES, STRONG], ids=["soft", "strong"])
@pytest.mark.parametrize(("parts", "delay"), CASES, ids=lambda v: getattr(v, "name", str(v)))
def test_polynomial_is_the_determinant_of_the_loop(parts, delay, values):
    step = step_matrix(parts, values, delay)
    found = polynomial(parts, values, delay)
    assert len(found) == len(step) + 1
    assert found[0] == 1
    for point in (1.3, -0.7, 0.4 + 1.1j, -1.9j):
        expected = np.linalg.det(point * np.eye(len(step)) - step)
        # a determinant of at most 7 rows with entries below 3: 1e-13 of its largest products
        assert abs(np.polyval(found, point) - expected) < 1e-13 * 3.0 ** len(step)


@pytest.mark.parametrize("values", [VALUES, STRONG], ids=["soft", "strong"])
@pytest.mark.parametrize("delay", [0, 1, 2, 5])
def test_largest_root_is_the_growth_of_the_loop(values, delay):
    step = step_matrix(FULL, values, delay)
    growth = np.abs(np.linalg.eigvals(step)).max()
    # the largest root is simple in all these cases; double precision leaves some 1e-14
    assert abs(np.abs(np.roots(polynomial(FULL, values, delay))).max() - growth) < 1e-11


@pytest.mark.parametrize("parts", ALL, ids=lambda p: p.name)
def test_scene_decides_the_symbols(parts):
    expected = {alpha, z}
    for name, symbol in (
        ("stiffness", gamma),
        ("damping", delta),
        ("virtual_damping", beta),
        ("delay", d),
    ):
        expected |= {symbol} if getattr(parts, name) else set()
    assert loop.characteristic(parts).free_symbols == expected


def test_the_smallest_scene():
    # by hand for the free mass and a spring: (z - 1)^2 + alpha (z + 1)/2
    made = loop.characteristic(Parts(False, False, False, False))
    assert sp.expand(made - (z - 1) ** 2 - alpha * (z + 1) / 2) == 0


@pytest.mark.parametrize("delay", [0, 2])
def test_closed_loop_answers_like_the_simulated_one(delay):
    values = VALUES | {T: 1.0, m: 1.0}
    transfer = loop.closed().subs(d, delay)
    step = step_matrix(FULL, values, delay)
    held = cont2discrete(
        (
            np.array([[0.0, 1.0], [-values[gamma], -values[delta]]]),
            np.array([[0.0], [1.0]]),
            np.eye(2),
            np.zeros((2, 1)),
        ),
        1.0,
        method="zoh",
    )[1]
    push = np.zeros(len(step))
    push[:2] = held[:, 0]
    for point in (1.5, 1.2 + 0.7j, -1.4):
        simulated = np.linalg.solve(point * np.eye(len(step)) - step, push)[0]
        exact = complex(transfer.subs(values).subs(z, point).evalf(30))
        # condition numbers below 1e3, each digit of which costs one of double precision's 16
        assert abs(exact - simulated) < 1e-12

"""The wall's force is that of a sampled spring and a backward-difference damper."""

import random

import pytest
import sympy as sp

from symhaptic.model import wall
from symhaptic.model.parts import ALL

K, B, T, d, z, alpha, beta, m = sp.symbols("K B T d z alpha beta m")


def difference_equation(positions, stiffness, damping, period, delay):
    """The force of a spring and a damper, sample by sample, ``delay`` samples late."""
    late = [0] * delay + positions
    forces, before = [], 0
    for now in late:
        forces.append(stiffness * now + damping * (now - before) / period)
        before = now
    return forces


@pytest.mark.parametrize("delay", [0, 1, 3])
def test_transfer_function_is_the_difference_equation(delay):
    draw = random.Random(delay)
    positions = [sp.Rational(draw.randrange(-9, 10), 7) for _ in range(6)]
    values = {K: sp.Rational(5, 2), B: sp.Rational(1, 3), T: sp.Rational(1, 10), d: delay}
    expected = difference_equation(positions, *(values[s] for s in (K, B, T)), delay)
    # exact: both are polynomials in 1/z with rational coefficients
    spectrum = sum(x * z**-i for i, x in enumerate(positions))
    product = sp.expand(wall.delayed().subs(values) * spectrum)
    found = [product.coeff(z, -i) for i in range(len(positions) + delay)]
    assert found == expected[: len(found)]


def test_force_of_a_resting_wall_is_that_of_the_spring():
    x = sp.Symbol("x")
    assert wall.force(x, x) == K * x


def test_no_delay_is_the_transfer_function():
    assert sp.simplify(wall.delayed(0) - wall.transfer()) == 0


@pytest.mark.parametrize("parts", ALL)
def test_normalised_wall_is_the_physical_one(parts):
    top, bottom = wall.normalised(parts)
    # Table I turned round
    physical = wall.transfer() * z ** (-d) * T**2 / m
    physical = physical.subs({K: alpha * m / T**2, B: beta * m / T})
    if not parts.virtual_damping:
        physical = physical.subs(beta, 0)
    if not parts.delay:
        physical = physical.subs(d, 0)
    assert sp.simplify(physical - top / bottom) == 0
    present = {alpha, z} | ({beta} if parts.virtual_damping else set())
    present |= {d} if parts.delay else set()
    if not (parts.delay or parts.virtual_damping):
        present -= {z}
    assert (sp.sympify(top) / bottom).free_symbols == present

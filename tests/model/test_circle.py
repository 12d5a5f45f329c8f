"""Laurent polynomials on the unit circle, against complex numbers."""

import cmath

import pytest
import sympy as sp

from symhaptic.model import circle
from symhaptic.notation import z

A, Y = sp.symbols("a y")
SAMPLES = [z**2 + A * z + 3, A / z + 2 * z**3, (z - 1) * (A - 1 / z**2), sp.Integer(7) + 0 * z]


@pytest.mark.parametrize("expr", SAMPLES)
@pytest.mark.parametrize("theta", [0.3, 1.7, 2.9])
def test_parts_are_those_of_the_complex_number(expr, theta):
    point = cmath.exp(1j * theta)
    value = complex(expr.subs({z: point, A: 0.4}))

    def at(form):
        return complex(form.subs({z: point, A: 0.4}))

    assert at(circle.real(expr)) == pytest.approx(value.real)
    assert at(circle.height(expr)) * cmath.sin(theta) == pytest.approx(value.imag)
    assert at(circle.square(expr)) == pytest.approx(abs(value) ** 2)
    chord = circle.in_chord(circle.real(expr), Y)
    y = 4 * cmath.sin(theta / 2) ** 2
    assert complex(chord.subs({Y: y, A: 0.4})) == pytest.approx(value.real)


def test_powers():
    assert circle.powers(A * z**2 - 3 / z + 5) == {2: A, -1: -3, 0: 5}


def test_numbers_need_not_be_rational():
    # |z + pi|^2 = 1 + pi^2 + 2 pi cos theta, by hand
    assert circle.square(z + sp.pi) == sp.pi * z + sp.pi / z + sp.pi**2 + 1
    assert circle.real(sp.sqrt(2) * z) == sp.sqrt(2) * z / 2 + sp.sqrt(2) / (2 * z)

"""Fractional delay: the delayed device by SciPy's matrix exponential, roots by NumPy.

Nothing here uses the modified z-transform: the loop is simulated as a state equation in which the
force changes inside the period, and its eigenvalues are the characteristic roots.
"""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from symhaptic.book.report.breaking import pieces
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL

RNG = np.random.default_rng(37)
GAMMA, DELTA, PART = sp.symbols("gamma delta epsilon")


def motion(gamma, delta, time):
    """exp(A t) and its integral over the input, from one matrix exponential."""
    block = np.zeros((3, 3))
    block[0, 1], block[1] = 1, [-gamma, -delta, 1]
    found = expm(block * time)
    return found[:2, :2], found[:2, 2]


def loop(alpha, beta, gamma, delta, whole, part):
    """One period of the closed loop; state: x, v, the sample before, the forces under way."""
    rest, held = motion(gamma, delta, 1 - part)
    early, first = motion(gamma, delta, part)
    size = 3 + whole + 1
    step = np.zeros((size, size))
    force = np.zeros(size)  # of the newest sample, x_k, and of the one before
    force[0], force[2] = -(alpha + beta), beta
    queue = [force, *np.eye(size)[3:]]  # of the samples k, k-1, ..., k-whole-1
    step[:2, :2] = rest @ early
    step[:2] += np.outer(rest @ first, queue[whole + 1]) + np.outer(held, queue[whole])
    step[2, 0] = 1
    step[3:] = queue[: whole + 1]
    return step


def numbers(gamma, delta, part):
    """m2, m1, m0, a, e from the model."""
    device = fractional.late(plant.normalised(FULL))
    values = {GAMMA: sp.Float(gamma, 30), DELTA: sp.Float(delta, 30), PART: sp.Float(part, 30)}
    exact = (device.m2, device.m1, device.m0, device.device.a, device.device.e)
    return [complex(x.subs(values).evalf(30)).real for x in exact]


def polynomial(alpha, beta, gamma, delta, whole, part):
    """z^(l+2) A + M ((alpha+beta) z - beta), highest power first."""
    m2, m1, m0, a, e = numbers(gamma, delta, part)
    p = np.concatenate([[1, -a, e], np.zeros(whole + 2)])
    p[-4:] += np.convolve([m2, m1, m0], [alpha + beta, -beta])
    return p


CASES = [(0.7, 0.3, 0, 0.5), (2.0, 4.0, 1, 0.25), (9.0, 0.02, 2, 0.9), (0.001, 0.02, 0, 0.1)]


@pytest.mark.parametrize(("gamma", "delta", "whole", "part"), CASES)
def test_polynomial_is_that_of_the_simulated_loop(gamma, delta, whole, part):
    for _ in range(3):
        alpha, beta = RNG.normal(size=2)
        step = loop(alpha, beta, gamma, delta, whole, part)
        # the coefficients of a determinant of this size, from eigenvalues: some 1e-13
        assert np.allclose(
            np.poly(step), polynomial(alpha, beta, gamma, delta, whole, part), atol=1e-11, rtol=0
        )


@pytest.mark.parametrize(("gamma", "delta", "whole", "part"), CASES)
def test_each_point_of_the_explicit_boundary_has_a_root_on_the_circle(gamma, delta, whole, part):
    m2, m1, m0, a, e = numbers(gamma, delta, part)
    for theta in RNG.uniform(0.2, 3.0, size=20):
        z = np.exp(1j * theta)
        q = -(z ** (whole + 1)) * (z**2 - a * z + e) / (m2 * z**2 + m1 * z + m0)
        beta = q.imag / np.sin(theta)
        alpha = q.real - beta * (1 - np.cos(theta))
        roots = np.linalg.eigvals(loop(alpha, beta, gamma, delta, whole, part))
        # a simple root of a matrix with entries up to some 100
        assert np.abs(roots - z).min() < 1e-9


# -- what the chapters lean on -------------------------------------------------------------


def test_a_product_of_two_sums_keeps_its_brackets_when_broken():
    x, y = sp.symbols("x y")
    long = sum(sp.Symbol(f"a_{i}") for i in range(20))
    first = pieces((x - y) * long, 20.0)[0]
    assert first.startswith(("(x-y)", "(-y+x)"))


def test_the_energy_of_the_model_is_that_of_the_motion():
    """The form against a finite motion, summed by hand in exact arithmetic: d = 5/4."""
    stiffness, damping, b, part, whole = Fraction(3, 5), Fraction(1, 7), 1, Fraction(1, 4), 1
    count = 12
    first = [Fraction(int(n), 8) for n in RNG.integers(-8, 9, size=count)]
    second = [Fraction(int(n), 8) for n in RNG.integers(-8, 9, size=count - 1)]
    second.append(-sum(first) - sum(second))  # comes back
    place, force, energy = [Fraction(0)], [Fraction(0)] * (whole + 1), Fraction(0)
    for k in range(count + whole + 2):
        p, q = (first[k], second[k]) if k < count else (0, 0)
        before = place[-2] if k else Fraction(0)
        force.append(stiffness * place[-1] + damping * (place[-1] - before))
        energy += force[k] * p + force[k + 1] * q + b * (p**2 / part + q**2 / (1 - part))
        place.append(place[-1] + p + q)
    # Parseval on a fine circle: the terms are trigonometric polynomials of low order
    angles = 2 * np.pi * (np.arange(400) + 0.5) / 400
    names, given = sp.symbols("K B b T epsilon l"), (stiffness, damping, b, 1, part, whole)
    values = zip(names, given, strict=True)
    symbolic = fractional.energy_form().subs({name: sp.S(value) for name, value in values})
    form = sp.lambdify(sp.Symbol("theta"), list(symbolic))
    total = 0.0
    for theta in angles:
        z = np.exp(1j * theta)
        powers = z ** -np.arange(count)
        p, q = np.dot(np.array(first, float), powers), np.dot(np.array(second, float), powers)
        # while a force is held: first q of a period, then p of the next
        held = q + z * p
        off = q - (1 - float(part)) * held
        entries = np.array(form(theta)).reshape(2, 2)
        vector = np.array([held, off])
        total += float((vector.conj() @ entries @ vector).real) / len(angles)
    assert total == pytest.approx(float(energy), rel=1e-9)

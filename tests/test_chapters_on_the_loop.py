"""What the chapters on the loop say holds for scipy's zero-order hold and NumPy's roots."""

import cmath
import math

import numpy as np
import pytest
import sympy as sp
from scipy.signal import cont2discrete

from symhaptic.paper import STATEMENTS


def held(gamma, delta, period=1.0, mass=1.0):
    """n1, n0, a, e of a sampled mass-spring-damper, from scipy's matrices."""
    law = np.array([[0.0, 1.0], [-gamma / period**2, -delta / period]])
    push = np.array([[0.0], [1.0 / mass]])
    system = (law, push, np.array([[1.0, 0.0]]), np.zeros((1, 1)))
    phi, force, *_ = cont2discrete(system, period, method="zoh")
    n0 = phi[0, 1] * force[1, 0] - phi[1, 1] * force[0, 0]
    return force[0, 0], n0, np.trace(phi), np.linalg.det(phi)


def abbreviations(gamma, delta):
    """c_1, c_2, c_3 of (15)."""
    c1 = cmath.sqrt(delta**2 - 4 * gamma)
    return c1, cmath.exp(-(delta + c1) / 2), cmath.exp(-(delta - c1) / 2)


def printed_value(id, values):
    """The right side of a printed equation in double precision."""
    expr = STATEMENTS[id].printed[0].rhs
    names = sorted(expr.free_symbols, key=str)
    return sp.lambdify(names, expr, "numpy")(*(values[s.name] for s in names))


PHYSICAL = {"m": 1.7, "b": 0.9, "k": 31.0, "T": 0.3}  # chosen: swinging, far from 0/0


def physical_values(z):
    p = PHYSICAL
    gamma, delta = p["k"] * p["T"] ** 2 / p["m"], p["b"] * p["T"] / p["m"]
    c1, c2, c3 = abbreviations(gamma, delta)
    return p | {"gamma": gamma, "delta": delta, "c_1": c1, "c_2": c2, "c_3": c3, "z": z}


@pytest.mark.parametrize("z", [1.6, 0.2 + 1.3j])
def test_sampled_device_as_printed_and_as_corrected(z):
    values = physical_values(z)
    n1, n0, a, e = held(values["gamma"], values["delta"], values["T"], values["m"])
    exact = (n1 * z + n0) / (z**2 - a * z + e)
    # (14) is right: double precision, quotients of condition below 100
    assert abs(printed_value("eq14", values) - exact) < 1e-13
    # (12) is wrong by far more than rounding, and right with b m/T in place of b
    assert abs(printed_value("eq12", values) - exact) > 1e-3 * abs(exact)
    m, b, k, T, c1, c2, c3 = (values[n] for n in ("m", "b", "k", "T", "c_1", "c_2", "c_3"))
    fade = math.exp(-b * T / m)
    right = (
        ((c2 + c3 - 2) * z + c2 + c3 - 2 * fade) * (b**2 - 4 * k * m)
        + b * m / T * c1 * (c3 - c2) * (z - 1)
    ) / (2 * k * (z**2 - (c2 + c3) * z + fade) * (4 * k * m - b**2))
    assert abs(right - exact) < 1e-13


@pytest.mark.parametrize("delay", [0, 1, 3])
def test_printed_polynomial_is_a_multiple_of_the_monic_one(delay):
    gamma, delta, alpha, beta, z = 0.4, 0.3, 0.7, -0.2, 0.8 + 0.9j  # chosen
    c1, c2, c3 = abbreviations(gamma, delta)
    values = {
        "gamma": gamma,
        "delta": delta,
        "alpha": alpha,
        "beta": beta,
        "z": z,
        "d": delay,
        "c_1": c1,
        "c_2": c2,
        "c_3": c3,
    }
    n1, n0, a, e = held(gamma, delta)
    monic = (z**2 - a * z + e) * z ** (delay + 1) + (n1 * z + n0) * ((alpha + beta) * z - beta)
    scale = -2 * c1 * gamma
    # double precision on numbers below 10
    assert abs(printed_value("eq18", values) - scale * monic) < 1e-13
    assert abs(printed_value("eq17", values) - scale * (n1 * z + n0)) < 1e-13


def test_printed_polynomial_vanishes_for_an_ungrabbed_device():
    delta = 0.5
    c1, c2, c3 = abbreviations(0.0, delta)
    values = {
        "gamma": 0.0,
        "delta": delta,
        "alpha": 0.3,
        "beta": 0.1,
        "z": 2.0,
        "d": 1,
        "c_1": c1,
        "c_2": c2,
        "c_3": c3,
    }
    # cancels to rounding of numbers of order 1
    assert abs(printed_value("eq18", values)) < 1e-15
    assert abs(printed_value("eq17", values)) < 1e-15

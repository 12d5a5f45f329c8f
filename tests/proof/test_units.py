"""Units are carried through every formula, and what does not match is named."""

from fractions import Fraction

import pytest
import sympy as sp
from sympy import Abs, Eq, cos, exp, pi, re, sqrt

from symhaptic.notation import UNITS
from symhaptic.proof.units import UnitError, dimension_of, shown

K, B, T, b, m, k, d, s, z, t_d = sp.symbols("K B T b m k d s z t_d")
omega, x, v, F = sp.symbols("omega x v F")
H, P = sp.Function("H"), sp.Function("P")

# Named SI units of each formula, by hand from N = kg m/s^2.
FORMULAS = {
    "spring force": (K * x, "N"),
    "damper force": (b * v, "N"),
    "wall": (K + B * (z - 1) / (T * z), "N/m"),
    "transfer function": (1 / (m * s**2 + b * s + k), "m/N"),
    "work": (F * x, "J"),
    "kinetic energy": (m * v**2 / 2, "J"),
    "normalised stiffness": (K * T**2 / m, "1"),
    "normalised damping": (B * T / m, "1"),
    "natural frequency": (sqrt(k / m - b**2 / (4 * m**2)), "1/s"),
    "delay": (exp(-t_d * s), "1"),
    "power": (z ** (-d), "1"),
    "magnitude": (Abs(B) + re(b), "Ns/m"),
    "loop": (P(z) * H(z) * cos(omega * T), "1"),
    "relation": (b > K * T / 2, "Ns/m"),
    "zero compares with anything": (Eq(k, 0, evaluate=False), "N/m"),
    "number": (pi / 2, "1"),
}


@pytest.mark.parametrize("name", FORMULAS)
def test_unit_of_a_formula(name):
    expr, unit = FORMULAS[name]
    assert dimension_of(expr) == UNITS[unit]
    assert shown(dimension_of(expr)) == unit


WRONG = {
    "stiffness and damping": K + B,
    "stiffness against damping": b > K,
    "mass and a number": m + 1,
    "cosine of a frequency": cos(omega),
    "exponent with a time": exp(-d * T),
    "power with a time": z**T,
    "time to a symbolic power": T**d,
    "argument of H": H(T),
    "missing mass in (12)": b**2 - 4 * k * m + b * sp.Symbol("c_1"),
    "unknown symbol": sp.Symbol("nobody"),
}


@pytest.mark.parametrize("name", WRONG)
def test_units_that_disagree_are_found(name):
    with pytest.raises(UnitError):
        dimension_of(WRONG[name])


def test_error_names_the_two_places():
    with pytest.raises(UnitError, match="adds") as found:
        dimension_of(K + B)
    assert {place for place, _ in found.value.places} == {K, B}
    assert {unit for _, unit in found.value.places} == {UNITS["N/m"], UNITS["Ns/m"]}


def test_unnamed_unit_is_spelled_out():
    # kg^(1/2) is the square root of a mass
    assert dimension_of(sqrt(m)) == (Fraction(1, 2), 0, 0)
    assert shown(dimension_of(sqrt(m))) == "kg^1/2"


def test_units_of_own_symbols():
    length = sp.Symbol("length")
    assert dimension_of(K * length, {"length": UNITS["m"]}) == UNITS["N"]


def test_zero_equals_zero_in_any_unit():
    assert dimension_of(Eq(sp.S.Zero, sp.S.Zero, evaluate=False)) == UNITS["1"]

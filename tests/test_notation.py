"""Every symbol has LaTeX, a unit and a domain of its own, and Table I is as printed."""

from fractions import Fraction

import pytest
import sympy as sp

from symhaptic import notation
from symhaptic.notation import SYMBOLS, TABLE_I, UNITS
from symhaptic.paper.reading import read

DOMAINS = {"real", "positive", "nonnegative", "complex", "(0, pi)", "(0, pi/2)", "[0, 1]"}

# Exponents of kg, m, s from the definitions of the SI: 1 N = 1 kg m/s^2, 1 J = 1 N m.
SI = {
    "1": (0, 0, 0),
    "s": (0, 0, 1),
    "1/s": (0, 0, -1),
    "kg": (1, 0, 0),
    "m": (0, 1, 0),
    "m/s": (0, 1, -1),
    "N": (1, 1, -2),
    "N/m": (1, 0, -2),
    "Ns/m": (1, 0, -1),
    "m/N": (-1, 0, 2),
    "J": (1, 2, -2),
}

# Units of the physical quantities: Sec. II and the heads of Table II.
PHYSICAL = {
    "m": "kg",
    "m_D": "kg",
    "m_H": "kg",
    "b": "Ns/m",
    "b_D": "Ns/m",
    "b_H": "Ns/m",
    "k": "N/m",
    "k_H": "N/m",
    "K": "N/m",
    "B": "Ns/m",
    "T": "s",
    "t_d": "s",
    "F_E": "N",
    "x": "m",
    "omega": "1/s",
    "omega_N": "1/s",
    "s": "1/s",
}
PURE = ("d", "z", "alpha", "beta", "gamma", "delta", "c_1", "c_2", "c_3", "y", "omega_hat")


@pytest.mark.parametrize("name", SYMBOLS)
def test_symbol_is_complete(name):
    entry = SYMBOLS[name]
    assert entry.name == name
    assert entry.latex.strip()
    assert entry.meaning.strip()
    assert entry.unit in UNITS
    assert entry.domain in DOMAINS


def test_no_latex_stands_for_two_symbols():
    spelled = [entry.latex for entry in SYMBOLS.values()]
    assert len(set(spelled)) == len(spelled)


@pytest.mark.parametrize(("unit", "exponents"), SI.items())
def test_unit_has_its_si_dimension(unit, exponents):
    assert UNITS[unit] == tuple(Fraction(n) for n in exponents)


def test_all_units_are_checked_above():
    assert set(UNITS) == set(SI)


@pytest.mark.parametrize(("name", "unit"), PHYSICAL.items())
def test_physical_quantity_has_its_unit(name, unit):
    assert SYMBOLS[name].unit == unit


@pytest.mark.parametrize("name", PURE)
def test_normalised_quantity_is_dimensionless(name):
    assert SYMBOLS[name].unit == "1"


@pytest.mark.parametrize("name", [n for n in SYMBOLS if n.isidentifier()])
def test_symbol_is_the_plain_sympy_symbol(name):
    assert getattr(notation, name) == sp.Symbol(name)


def test_unknown_symbol_is_an_attribute_error():
    with pytest.raises(AttributeError, match="lambda_"):
        _ = notation.lambda_


def test_rows_of_table_one():
    # Table I, columns "parameter" and "variable", row by row.
    assert [(row.parameter, row.variable) for row in TABLE_I] == [
        ("sampling period", "T"),
        ("mass", "m"),
        ("delay", "t_d"),
        ("virtual stiffness", "K"),
        ("virtual damping", "B"),
        ("physical stiffness", "k"),
        ("physical damping", "b"),
    ]


def test_definitions_of_table_one():
    d, t_d, T, m, K, B, k, b = sp.symbols("d t_d T m K B k b")
    alpha, beta, gamma, delta = sp.symbols("alpha beta gamma delta")
    # Table I, column "dimensionless variable"; the first two rows have a dash.
    right = [
        None,
        None,
        (d, t_d / T),
        (alpha, K * T**2 / m),
        (beta, B * T / m),
        (gamma, k * T**2 / m),
        (delta, b * T / m),
    ]
    found = [
        None if row.dimensionless is None else read(row.dimensionless)[0].args for row in TABLE_I
    ]
    assert found == right

"""What a formula says of itself, and how it serves somebody's own test."""

import re

import pytest
from sympy import Rational, cos, exp, pi, symbols, tan

from symhaptic import formula, prove

b, d, T, K, B = symbols("b d T K B")


def test_a_right_formula_of_ones_own():
    # tan(x/2) = (1 - cos x)/sin x with x = pi/(2(d+1)): any table of half-angle formulas
    mine = 2 * b / T * tan(pi / (4 * (d + 1)))
    assert prove(mine, formula("eq11").derived[0].rhs)


def test_a_wrong_formula_of_ones_own_comes_with_a_point():
    verdict = prove(2 * b / T * (1 - cos(pi / (2 * (d + 1)))), formula("eq11").derived[0].rhs)
    assert not verdict
    assert verdict.kind == "refuted"
    assert set(verdict.counterexample) == {"b", "d", "T"}


def test_symbols_units_and_domain():
    eq5 = formula("eq5")
    assert {s.name for s in eq5.symbols} == {"b", "B", "K", "T", "d", "omega"}
    assert eq5.units == ("Ns/m",)
    assert eq5.domain == r"0 < \omega < \omega_N"
    assert all(entry.meaning for entry in eq5.symbols.values())


def test_the_form_for_computing_is_dimensionless():
    # by hand: (25) with alpha = K T^2/m, beta = B T/m, delta = b T/m; a free mass keeps e^-delta
    beta, delta = symbols("beta delta")
    (limit,) = formula("eq25").stable
    assert prove(limit, (beta + delta) / (d + Rational(1, 2)))
    *_, kept = formula("eq14").stable
    assert prove(kept, exp(-delta))
    assert formula("eq18").stable == ()


def test_units_say_where_a_misprint_is():
    assert formula("eq12").units[0].startswith("adds")


def test_latex_in_a_notebook():
    shown = formula("eq11")._repr_latex_()
    assert shown.startswith("$")
    assert "operatorname" not in shown


@pytest.mark.parametrize("id", ["eq99", "fig7", "tab2"])
def test_what_is_no_formula_yet_is_named(id):
    with pytest.raises(ValueError, match=id):
        formula(id)


@pytest.mark.parametrize("id", [11, None, ["eq11"], {}])
def test_an_id_that_is_no_word_is_refused_as_one_that_is_not_known(id):
    with pytest.raises(ValueError, match=rf"^id: {re.escape(repr(id))} is not a formula"):
        formula(id)

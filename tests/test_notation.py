"""Every symbol has LaTeX, a unit and a domain of its own, and Table I is as printed."""

from fractions import Fraction

import pytest
import sympy as sp

from symhaptic import notation
from symhaptic.notation import SYMBOLS, TABLE_I, UNITS
from symhaptic.notation.proposition import (
    And,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    conjuncts,
    proposition,
)
from symhaptic.notation.written import written
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


def test_symbols_are_complete():
    for name, entry in SYMBOLS.items():
        assert entry.name == name
        assert entry.latex.strip(), name
        assert entry.meaning.strip(), name
        assert entry.unit in UNITS, name
        assert entry.domain in DOMAINS, name


def test_no_latex_stands_for_two_symbols():
    spelled = [entry.latex for entry in SYMBOLS.values()]
    assert len(set(spelled)) == len(spelled)


def test_units_have_their_si_dimensions():
    assert {unit: tuple(map(Fraction, exponents)) for unit, exponents in SI.items()} == UNITS


def test_physical_quantities_have_their_units():
    assert {name: SYMBOLS[name].unit for name in PHYSICAL} == PHYSICAL


def test_normalised_quantities_are_dimensionless():
    assert {SYMBOLS[name].unit for name in PURE} == {"1"}


def test_symbols_are_plain_sympy_symbols():
    names = [name for name in SYMBOLS if name.isidentifier()]
    assert [getattr(notation, name) for name in names] == list(map(sp.Symbol, names))


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


def test_what_is_denied_is_not_told_from_a_part_of_it_by_its_place():
    """That not both hold was printed as that the one does not, and the other does."""
    stiff, fast = map(proposition, (notation.K > 0, notation.T < 1))
    assert written(Not((And((stiff, fast)),))) == r"\text{not}\ (K>0,\ T<1)"
    assert written(And((Not((stiff,)), fast))) == r"\text{not}\ K>0,\ T<1"
    chain = And((stiff, proposition(notation.K < notation.T)))
    assert written(Not((chain,))) == r"\text{not}\ 0<K<T"


@pytest.mark.parametrize(
    ("name", "terms", "said"),
    [
        # a slash binds less than what stands beside it: m delta/T times x', not m delta/(T x')
        ("swings", "m, m*delta/T, K - b, omega", r"m\ddot x+(m\delta/T)\dot x+(K-b)x=0"),
        (
            "device",
            "gamma, delta, n_1 + n_0, -n_0, a + 1, e",
            r"\frac{(n_1+n_0)z+(-n_0)}{z^2-(a+1)z+e}",
        ),
        ("answers", "1/s, 1 + z, X/T, T", r"1/s\ \text{answers }(z+1)^k\text{, held every }T"),
        ("answers", "1/s, z, X/T, T", r"\text{, by }(X/T)\,z^k"),
        ("limit", "x + K, 0, b", r"\lim_{x\to 0} (K+x)=b"),
    ],
)
def test_a_term_of_a_predicate_is_printed_as_one(name, terms, said):
    of = sp.sympify(f"({terms})", locals={n: getattr(notation, n) for n in SYMBOLS})
    over = (notation.x,) if name == "limit" else (notation.s,) if name == "answers" else ()
    assert said in written(Predicate(name, over, tuple(of)))


def test_propositions_of_two_meanings_are_printed_in_two_ways():
    parts = [proposition(r) for r in (notation.K > 0, notation.T < 1, notation.B > 0)]
    for _ in range(2):
        pairs = [(p, q) for p in parts[:24] for q in parts[:24] if p is not q]
        made = [kind(pair) for kind in (Or, Implies, Iff) for pair in pairs]
        parts += [*made, *(Not((p,)) for p in parts), *(And((p, q)) for p, q in pairs)]
    meant = {}
    for part in parts:
        both = conjuncts(part) if isinstance(part, And) else part
        assert meant.setdefault(written(part), both) == both

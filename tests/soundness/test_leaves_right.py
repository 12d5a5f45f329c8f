"""Zeros outside and to the right, by balls: what is not so is refused."""

import pytest
import sympy as sp
from sympy import I, Rational, pi, sqrt, symbols

from symhaptic.notation import s, z
from symhaptic.notation.proposition import And, ForAll, Implies, Not, Relation
from symhaptic.notation.terms import NoTerm
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.theorems.leaves import none_right, one_right, root_outside, roots_inside

x, y, v, p = symbols("x y v p")


def outside_right(value):
    given = And((Relation(0, "<", x), Relation(1, "<=", x**2 + y**2)))
    return ForAll((x, y), Implies((given, Relation(value, "!=", 0))))


def test_what_the_leaves_say():
    found = none_right((v + 2) * (v - Rational(1, 2)), v, x, y)
    assert not found.hypotheses
    assert found.conclusion == outside_right((x + I * y + 2) * (x + I * y - Rational(1, 2)))
    found = one_right(v**2 - 2 * v + pi, v, x, y)
    assert found.conclusion == Not((outside_right((x + I * y) ** 2 - 2 * (x + I * y) + pi),))


WITH_ONE = [
    v - 2,
    v - 1,  # on the circle
    v**2 - 2 * v + 2,
    (v - Rational(3, 5)) ** 2 + Rational(16, 25),  # on the circle, to the right
    v**2 + 4,  # on the axis: no ball shows that it is not to the right
    v - 1 - Rational(1, 10**25),
    pi * v - 4,
    v - I - 2,
]
WITHOUT = [
    v + 2,
    v - Rational(1, 2),
    v - 1,  # not shown to be outside
    (v + 1) ** 2 + 4,
    v**2 + 4,
    v - 1 + Rational(1, 10**25),
    4 * v - pi,
    v + 2 - I,
]


@pytest.mark.parametrize("polynomial", WITH_ONE)
def test_a_zero_that_may_be_there_is_not_denied(polynomial):
    with pytest.raises(NotShown):
        none_right(polynomial, v, x, y)


@pytest.mark.parametrize("polynomial", WITHOUT)
def test_a_zero_that_may_not_be_there_is_not_claimed(polynomial):
    with pytest.raises(NotShown):
        one_right(polynomial, v, x, y)


@pytest.mark.parametrize("leaf", [none_right, one_right])
@pytest.mark.parametrize(
    "given",
    [
        (p * v + 2, v, x, y),  # a coefficient without a value
        (sp.S.One, v, x, y),
        (sqrt(v) + 2, v, x, y),
        (1 / v + v, v, x, y),
        (sp.exp(v) + v, v, x, y),
        (sp.Abs(v) + 2, v, x, y),
        (v + 2, v, x, x),  # x + j x only
        (v + 2, v, z, y),  # complex
        (v + 2, v, x, s),
        (v + 2, z, x, y),
        (v**p + 2, v, x, y),
    ],
)
def test_what_is_no_polynomial_in_numbers_at_two_real_symbols_is_refused(leaf, given):
    with pytest.raises((NotShown, NoTerm)):
        leaf(*given)


@pytest.mark.parametrize(
    "zero",
    [
        (v - 1) ** 2 - v**2 + 2 * v - 1,
        sp.Mul(0, v, evaluate=False),
        (v - 1) ** 2 - v**2 + 2 * v - 2 + sp.sin(1) ** 2 + sp.cos(1) ** 2,
        v * (sp.sin(1) ** 2 + sp.cos(1) ** 2 - 1),
    ],
)
def test_a_polynomial_that_is_zero_is_zero_everywhere(zero):
    for leaf in (none_right, one_right):
        with pytest.raises((NotShown, Unsupported)):
            leaf(zero, v, x, y)
    with pytest.raises((NotShown, Unsupported)):
        root_outside(zero, v)
    with pytest.raises(NotShown):
        roots_inside(zero, v, {})

"""Relations, boxes and certificates that are made to be confirmed falsely."""

from dataclasses import replace

import pytest
import sympy as sp
from sympy import Rational
from sympy.abc import x, y

from symhaptic import enclose, enclose_maximum, prove, recheck
from symhaptic.proof.certificate import Positive, Zero
from symhaptic.proof.roots import NoSuchRoot, zero
from symhaptic.proof.verdict import Kind

ROOT = sp.sqrt(2)


@pytest.mark.parametrize("ends", [(ROOT, 2), (ROOT, ROOT)])
def test_no_counterexample_lies_outside_of_a_box_with_an_irrational_end(ends):
    # x^2 >= 2 holds for every x >= sqrt(2); a rational middle may lie below sqrt(2)
    assert prove(x**2 >= 2, {x: ends}).kind == Kind.UNDECIDED


COMPLEX = [
    sp.Gt(sp.exp(sp.I * x), 0, evaluate=False),
    sp.Gt(sp.I * x + 1, 0, evaluate=False),
    sp.Gt(sp.I * (x - Rational(1, 2)) + 1, 0, evaluate=False),
    sp.Gt(1 + sp.I * x / 10**40, 0, evaluate=False),
]


@pytest.mark.parametrize("relation", COMPLEX)
def test_what_is_not_real_is_not_ordered(relation):
    assert prove(relation, {x: (0, 1)}).kind == Kind.UNDECIDED
    assert not recheck(Positive(relation.lhs, {x: (0, 1)}, ".", 96))


def test_what_jumps_is_not_judged_by_its_slope():
    # 2 sin(x/2) up to pi, where the principal root changes its sign, and below 0 beyond
    jumps = -sp.I * (sp.sqrt(sp.exp(sp.I * x)) - sp.sqrt(sp.exp(-sp.I * x)))
    beyond = {x: (3, Rational(31415926535897932385, 10**19))}
    assert prove(sp.Gt(jumps, -1, evaluate=False), beyond).kind == Kind.UNDECIDED


def test_a_real_part_without_an_imaginary_one_has_no_zero():
    with pytest.raises(NoSuchRoot):
        zero(x**2 - 2 + sp.I, x, sp.S.One, sp.Integer(2))
    found = zero(x**2 - 2, x, sp.S.One, sp.Integer(2))
    assert recheck(found)
    assert not recheck(Zero(x**2 - 2 + sp.I, x, found.between, found.ball, found.bits))


@pytest.mark.parametrize(
    "relation",
    [
        x + sp.E > 2,
        sp.pi**x > Rational(1, 2),
        x**x > Rational(1, 2),
        x ** Rational(1, 3) > Rational(1, 5),
        sp.Abs(x - Rational(1, 2)) < 1,
        sp.tanh(1000 * x) < 2,
        sp.tanh(100 * x - 50) < Rational(11, 10),
        sp.cot(x) > Rational(-1, 10),
        sp.sinh(x) < 2,
    ],
)
def test_all_that_is_found_is_checked_again(relation):
    verdict = prove(relation, {x: (Rational(1, 10), Rational(3, 2) if relation.has(sp.cot) else 1)})
    assert verdict.kind == Kind.ENCLOSED
    assert recheck(verdict.certificate)


def test_a_maximum_with_powers_and_moduli_is_checked_again():
    for expr in (sp.E * x, 2**x, sp.Abs(x) - x**2):
        assert recheck(enclose_maximum(expr, {x: (-1, 1)}, digits=3))


@pytest.mark.parametrize("cuts", ["", "..", "0.", "9..", "1..", "x", "0..0", "²..", "-1", ":" * 3])
def test_a_tree_that_is_none_shows_nothing(cuts):
    assert not recheck(Positive(x + 1, {x: (0, 1)}, cuts, 64))


def test_a_changed_certificate_shows_nothing():
    good = prove(x * (1 - x) < Rational(26, 100), {x: (0, 1)}).certificate
    assert recheck(good)
    assert not recheck(replace(good, expr=good.expr - Rational(1, 50)))
    assert not recheck(replace(good, box={y: (0, 1)}))
    assert not recheck(replace(good, box={x: (0, 1000)}, expr=good.expr - 1))
    with pytest.raises(TypeError, match="is no certificate"):
        recheck(None)


def test_a_box_keeps_to_what_its_symbols_are_assumed_to_be():
    # sympy has sqrt(p^2) = p for a positive p, and n (n - 1) >= 0 for every integer n
    p, n = sp.Symbol("p", positive=True), sp.Symbol("n", integer=True)
    with pytest.raises(ValueError, match="assumed not to be"):
        prove(sp.sqrt(p**2) + sp.sin(p) > -2, {p: (-5, 1)})
    with pytest.raises(ValueError, match="assumed not to be"):
        prove(n * (n - 1) >= 0, {n: (0, 1)})
    assert prove(p**2 + 1 > p, {p: (0, 1)})


@pytest.mark.parametrize(
    ("ask", "error"),
    [
        (lambda: prove(x > 0, {x: (None, 1)}), ValueError),
        (lambda: prove(x > 0, {x: (0.5, 1)}), ValueError),
        (lambda: enclose_maximum(x, [1]), TypeError),
        (lambda: enclose_maximum([x], {x: (0, 1)}), ValueError),
        (lambda: enclose_maximum(x / 2.0, {x: (0, 1)}), ValueError),
        (lambda: enclose(1 / (sp.sin(1) ** 2 + sp.cos(1) ** 2 - 1)), ValueError),
    ],
)
def test_nonsense_is_refused_in_a_line(ask, error):
    with pytest.raises(error) as caught:
        ask()
    assert "\n" not in str(caught.value)
    assert ":" in str(caught.value)

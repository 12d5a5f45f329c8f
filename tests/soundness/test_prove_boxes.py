"""An inequality is enclosed only where both sides are defined and real, and never unchecked."""

import pytest
import sympy as sp
from sympy import Abs, I, Rational, S, cos, cot, exp, log, sin, sqrt, tan

from symhaptic import enclose, enclose_maximum, prove, recheck
from symhaptic.proof import box as boxes
from symhaptic.proof.box import NotShown
from symhaptic.proof.certificate import Positive
from symhaptic.proof.verdict import Kind

x, y = sp.symbols("x y")
HALF = Rational(1, 2)
TINY = Rational(1, 10**20)


def test_a_slope_that_lost_its_singularity_encloses_nothing():
    # sqrt(x^2)/x is -1 below 0; SymPy's derivative of it is 0 everywhere
    assert not prove(sqrt(x**2) / x > -HALF, {x: (-TINY, 1)})
    assert not prove(sqrt((x - y) ** 2) / (x - y) > -HALF, {x: (-TINY, 1), y: (0, TINY)})
    with pytest.raises(NotShown):
        boxes.positive(sqrt(x**2) / x + HALF, {x: (-TINY, 1)})
    with pytest.raises(NotShown):
        boxes.maximum(-sqrt(x**2) / x, {x: (-TINY, 1)}, Rational(1, 10))


UNDEFINED = [
    (sqrt(x) + 1 > sqrt(x), (-2, -1)),
    (tan(x) + 1 > tan(x), (0, 2)),  # a pole at pi/2
    (1 / x + 1 > 1 / x, (-1, 1)),
    (log(x) + 1 > log(x), (-1, 1)),
    (cot(x) < cot(x) + 1, (-1, 1)),
    (sp.Gt(sqrt(x) + 1, sqrt(x) - x**2), (-1, 1)),
    (sp.Gt(1 / x, sp.Add(1 / x, -1, evaluate=False)), (-1, 1)),
    (sp.Gt(x ** Rational(1, 3) + 2, x ** Rational(1, 3)), (-1, 1)),
    (sp.Gt(sp.acos(x) + 1, sp.acos(x)), (0, 2)),
    (sp.Gt(sp.Function("f")(x) + 1, sp.Function("f")(x)), (0, 2)),
    (sp.Gt(sp.I * x + 1, sp.I * x), (0, 1)),
    (sp.Gt(sp.I + 1, sp.I, evaluate=False), (0, 1)),
]


@pytest.mark.parametrize("of", [1 / x, log(x), tan(1 / x), x ** Rational(1, 3)])
def test_what_is_not_defined_is_not_one_to_the_power_of_zero(of):
    """Balls of all numbers, and of none, were 1 to the power of 0."""
    power = sp.Pow(of, 0, evaluate=False)
    assert not prove(sp.Lt(power, 2, evaluate=False), {x: (0, 1)})
    assert not recheck(Positive(2 - power, {x: (0, 1)}, ".", 96))
    assert prove(sp.Lt(power, 2, evaluate=False), {x: (Rational(3, 4), Rational(7, 8))})
    with pytest.raises(ValueError, match=r"^enclose: expr: "):
        enclose(sp.Pow(of.xreplace({x: sin(1) ** 2 + cos(1) ** 2 - 1}), 0, evaluate=False))


@pytest.mark.parametrize(("relation", "ends"), UNDEFINED)
def test_sides_that_are_not_defined_do_not_cancel(relation, ends):
    assert not prove(sp.Gt(*(relation.gts, relation.lts), evaluate=False), {x: ends})


@pytest.mark.parametrize(("relation", "ends"), UNDEFINED[:5])
def test_where_they_are_defined_they_cancel(relation, ends):
    verdict = prove(relation, {x: (HALF, 1)})
    assert verdict.kind == Kind.ENCLOSED
    assert verdict.certificate.defined
    assert recheck(verdict.certificate)


def test_a_certificate_that_hides_a_pole_is_not_confirmed():
    sides = (tan(x) + 1, -tan(x))
    assert not recheck(Positive(S.One, {x: (0, 2)}, ".", 96, defined=sides))
    assert recheck(Positive(S.One, {x: (0, 1)}, ".", 96, defined=sides))
    assert not recheck(Positive(S.One, {x: (0, 1)}, ".", 96, defined=(sp.I * x,)))
    assert not recheck(Positive(S.One, {x: (0, 1)}, ".", 96, defined=(y,)))


def test_a_verdict_that_is_not_confirmed_is_undecided(monkeypatch):
    monkeypatch.setattr("symhaptic.proof.prove.recheck", lambda certificate: False)
    assert prove(exp(x) > x, {x: (0, 1)}).kind == Kind.UNDECIDED
    monkeypatch.setattr("symhaptic.proof.box.recheck", lambda certificate: False)
    with pytest.raises(ValueError, match="not confirmed"):
        enclose_maximum(x, {x: (0, 1)}, digits=2)


def test_symbols_of_one_name_are_one():
    p = sp.Symbol("x", positive=True)
    assert prove(exp(x) > x, {p: (0, 1)})
    assert prove(sp.Gt(exp(p), x, evaluate=False), {x: (0, 1)})
    assert enclose_maximum(p * (1 - x), {x: (0, 1)}, digits=2).upper >= Rational(1, 4)
    with pytest.raises(ValueError, match="two intervals for x"):
        prove(exp(x) > x, {p: (0, 1), x: (0, 1)})
    with pytest.raises(ValueError, match="assumed to be"):
        prove(exp(p) > p, {sp.Symbol("x", negative=True): (-1, 0)})
    with pytest.raises(ValueError, match="assumed not to be"):
        prove(exp(p) > x, {x: (-1, 1)})


def test_a_counterexample_has_what_is_assumed():
    # p (1 - p) > 0 for 0 < p < 1; at 0, which is in the closed interval, p is not
    p = sp.Symbol("p", positive=True)
    assert prove(p - p**2 > -p, {p: (0, 0)}).kind != Kind.REFUTED
    wrong = prove(p**2 > p, {p: (0, 1)})
    assert wrong.kind == Kind.REFUTED
    assert 0 < Rational(wrong.counterexample["p"]) < 1
    odd = sp.Symbol("o", irrational=True)
    assert prove(odd > odd**2, {odd: (HALF, 3)}).kind != Kind.REFUTED  # its points are rational


@pytest.mark.parametrize(
    "relation",
    [
        sp.Gt(Abs(x), -HALF, evaluate=False),
        log(1 + x) < x + HALF,
        sp.atan(x) < x + HALF,
        cos(x) < 2 + sin(x),
    ],
)
def test_what_is_right_is_still_shown(relation):
    verdict = prove(relation, {x: (0, 1)})
    assert verdict.kind == Kind.ENCLOSED
    assert recheck(verdict.certificate)


@pytest.mark.parametrize(
    ("relation", "box"),
    [
        (5 + sqrt(x) > sqrt(x**3), {x: (-1, -1)}),  # 5 + j and j
        (sp.Gt(5 + I * x, I * x * cos(y) ** 2 + I * x * sin(y) ** 2), {x: (1, 2), y: (1, 2)}),
    ],
)
def test_sides_that_are_not_real_have_no_order(relation, box):
    # their difference is real, and each of their terms stands in it
    assert not prove(relation, box)

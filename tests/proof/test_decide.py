"""Two forms are proved equal, told apart by a point that can be checked, or left undecided."""

import re

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Eq, I, Rational, conjugate, cos, exp, pi, sin, sqrt, tan

from symhaptic.proof.decide import compare
from symhaptic.proof.points import points
from symhaptic.proof.prove import prove
from symhaptic.proof.shape import parts
from symhaptic.proof.verdict import Kind

x, y, a, d, z = sp.symbols("x y a d z")
gamma, theta, K, T, b = sp.symbols("gamma theta K T b")
H = sp.Function("H")


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (tan(x / 2), sin(x) / (1 + cos(x))),
        (cos(d * x) - cos((d + 2) * x), 2 * sin(x) * sin((d + 1) * x)),
        ((x**2 - 1) / (x - 1), x + 1),
        (sp.Matrix([sin(2 * x), 1]), [2 * sin(x) * cos(x), cos(x) ** 2 + sin(x) ** 2]),
        (x < y, y > x),
        (x < y, 2 * x < 2 * y),
        (x - y > 0, x > y),
        (Eq(x, y), Eq(-2 * x, -2 * y)),
        (Eq(z, sin(2 * x)), Eq(z, 2 * sin(x) * cos(x))),
        ((x >= 1, Eq(y, 2)), (2 * x >= 2, Eq(y, 1 + sp.S.One))),
        (K * H(z) / T, H(z) / (T / K)),
    ],
)
def test_right_formula_is_proved(left, right):
    verdict = prove(left, right)
    assert verdict.kind == Kind.PROVED
    assert verdict
    assert verdict.method


WRONG = [
    (sin(2 * x), 2 * sin(x)),
    (sqrt(x**2), x),
    (x, x + Rational(1, 10**400)),
    (exp(I * x), exp(-I * x)),
    (sin((d + 1) * theta), sin(d * theta) + sin(theta)),
    (z ** (d + 1), z**d + z),
    (1 / x, 1 / (x + y)),
    ((x**2) ** d, x ** (2 * d)),
    (sin(sin(x)), sin(x)),  # beyond the normal form
    (2 ** (2**x), 4**x),
]


@pytest.mark.parametrize(("left", "right"), WRONG)
def test_wrong_formula_is_refuted_by_a_point_that_fails(left, right):
    verdict = prove(left, right)
    assert verdict.kind == Kind.REFUTED
    assert not verdict
    at = {sp.Symbol(name): sp.sympify(value) for name, value in verdict.counterexample.items()}
    assert set(at) == left.free_symbols | right.free_symbols
    difference = (left - right).subs(at)
    # exact where it is a rational number, 50 digits otherwise; the points are small numbers
    assert difference != 0 if difference.is_Rational else abs(difference.evalf(50)) > 1e-30


RELATIONS = [
    (x < y, x <= y),
    (x < y, x > y),
    (x < y, -x < -y),
    (x < 1, x < 2),
    (Eq(x, y), sp.Ne(x, y)),
    (x * a > y * a, x > y),
    (Eq(x, y), x <= y),
    (x > y, -(x - y) > 0),
]


@pytest.mark.parametrize(("left", "right"), RELATIONS)
def test_wrong_relation_is_refuted_where_just_one_holds(left, right):
    verdict = prove(left, right)
    assert verdict.kind == Kind.REFUTED
    at = {sp.Symbol(name): sp.sympify(value) for name, value in verdict.counterexample.items()}
    assert bool(left.subs(at)) is not bool(right.subs(at))


@pytest.mark.parametrize(
    ("left", "right"),
    [
        # true where the symbols are (gamma >= 0, T > 0), but no identity
        (sqrt(gamma**2), gamma),
        (b > K, b * T > K * T),
        # true, and beyond the normal form
        (sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
        (Eq(x, 0), Eq(x**3, 0)),
    ],
)
def test_what_is_neither_proved_nor_told_apart_is_undecided(left, right):
    verdict = prove(left, right)
    assert verdict.kind == Kind.UNDECIDED
    assert not verdict


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (sp.log(x * y), sp.log(x) + sp.log(y)),  # y is in [0, 1] in the notation
        (sqrt(K * b), sqrt(K) * sqrt(b)),
        (sqrt(gamma**2), gamma),
        (b > K, b * T > K * T),
    ],
)
def test_where_sides_differ_outside_the_domain_is_told(left, right):
    verdict = prove(left, right)
    told = re.search("outside the domains of the notation, at (.*)$", verdict.method)
    pairs = (pair.split(" = ") for pair in told.group(1).split(", "))
    at = {sp.Symbol(name): sp.sympify(value) for name, value in pairs}
    ours, theirs = left.subs(at), right.subs(at)
    if isinstance(ours, sp.Expr):
        assert abs((ours - theirs).evalf(50)) > 1
    else:
        assert bool(ours) is not bool(theirs)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (H(cos(x) ** 2 + sin(x) ** 2), H(1)),
        (H(exp(I * x)), H(cos(x) + I * sin(x))),
        (conjugate(x), x),  # symbols are real
    ],
)
def test_what_is_true_of_an_unknown_function_is_not_refuted(left, right):
    assert prove(left, right).kind in (Kind.PROVED, Kind.UNDECIDED)


@pytest.mark.parametrize(
    "inside",
    [
        sp.Derivative(H(x), x),
        sp.Derivative(sin(x), x),
        sp.Integral(sin(x * y), (x, 0, y)),
        sp.Limit(x * a, x, a),
        sp.Subs(H(x), x, y),
    ],
)
def test_what_a_derivative_is_by_is_no_number(inside):
    assert prove(sp.gamma(inside), x).kind == Kind.UNDECIDED


def test_power_that_may_be_complex_is_not_its_real_part():
    # x = -1, d = 1/2 gives j
    assert prove(sp.re(x**d, evaluate=False), x**d).kind != Kind.PROVED


def test_form_that_divides_by_zero_equals_nothing():
    nothing = 1 / (sin(x) ** 2 + cos(x) ** 2 - 1)
    assert not prove(nothing, x)
    assert not prove(x, nothing)
    assert not prove(nothing, nothing)


def test_number_of_components_must_agree():
    assert not prove([x, y], [x])
    assert not prove([x], [])


def test_no_statement_at_all_is_not_proved():
    assert not prove([], [])


def test_one_wrong_component_is_enough():
    assert compare([x, sin(2 * x)], [x, 2 * sin(x)]).equal is False


def test_two_definitions_are_told_apart_by_their_right_sides():
    verdict = prove(Eq(x, y), Eq(x, -y))
    assert verdict.kind == Kind.REFUTED
    assert sp.sympify(verdict.counterexample["y"]) != 0


def test_unknown_functions_stay_apart():
    assert prove(H(x), H(y)).kind == Kind.REFUTED
    assert prove(H(x), 2 * H(x)).kind == Kind.REFUTED


def test_vectors_unfold():
    assert parts([sp.Matrix([x, y]), (z, Eq(x, y))]) == (x, y, z, Eq(x, y))


def test_points_lie_in_the_domain_of_the_notation():
    for at in points(gamma * T * theta):
        assert at[gamma] >= 0
        assert at[T] > 0
        assert 0 < at[theta] < pi


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.integers(-4, 4), st.integers(1, 4), st.integers(-4, 4), st.integers(1, 3))
def test_strict_and_scaled_inequalities(shift, factor, other, divisor):
    base = x + Rational(shift, divisor) * y
    assert prove(base > other, factor * base > factor * other)
    assert not prove(base > other, factor * base >= factor * other)
    assert not prove(base > other, -factor * base > -factor * other)
    assert not prove(base > other, base > other + Rational(1, divisor))


def test_a_point_where_one_side_is_undefined_refutes_nothing():
    # both sides are (x + 1) e^(x + sqrt x), by hand; the left is 0/0 at 1, and the normal form
    # does not see that sqrt(x) sqrt(x) in the exponent is x
    left = exp(sqrt(x) * (sqrt(x) + 1)) * (x**2 - 1) / (x - 1)
    assert prove(left, (x + 1) * exp(x + sqrt(x))).kind in ("proved", "undecided")


def test_a_lone_symbol_is_a_side_like_any_other():
    # SymPy counts a symbol among the truth values as well
    assert prove(a / (1 - exp(-a)) * (1 - exp(-a)), a)
    assert prove(a, x).kind == Kind.REFUTED

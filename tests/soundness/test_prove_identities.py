"""Identities that are false, or that nobody can know, are not proved; true ones are not refuted."""

import pytest
import sympy as sp
from sympy import Eq, Function, I, Matrix, Rational, cos, exp, pi, re, sin, sqrt, symbols

from symhaptic import formula, prove
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.theorems.leaves import identity
from symhaptic.proof.verdict import Kind

x, y, z, a, b = symbols("x y z a b")
f = Function("f")
ZERO = sin(x) ** 2 + cos(x) ** 2 - 1
A, B = symbols("A B", commutative=False)


@pytest.mark.parametrize(
    "form",
    [
        sp.acos(2),  # 1.317 j
        sp.asin(x),  # complex for |x| > 1
        sp.acosh(x),  # for x < 1
        sp.atanh(x),
        sp.log(x),  # for x < 0
        sp.polylog(2, x),  # for x > 1
        sp.LambertW(x),  # for x < -1/e
        f(x),
        sp.Symbol("w", complex=True),
        sp.Symbol("w", imaginary=True) * x,
        sp.Symbol("w", antihermitian=True),  # the same, or 0
        sqrt(x),
        (-2) ** x,
        x**y,
    ],
)
def test_what_need_not_be_real_is_not_its_own_real_part(form):
    for part in (re(form, evaluate=False), sp.conjugate(form, evaluate=False)):
        assert prove(part, form).kind != Kind.PROVED


def test_the_real_part_of_what_is_real_is_found():
    # all are real wherever they are defined, for real x
    for form in (sin(x), exp(x), sp.tan(x), 2**x, 1 / (1 + x), sp.Abs(x), sp.cosh(x) ** 3):
        assert prove(re(form, evaluate=False), form)


def test_a_paper_name_makes_no_function_of_a_user_real():
    assert not prove(re(Function("H")(x)), Function("H")(x))


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (A * B, B * A),
        (A * B - B * A, 0),
        (sp.MatrixSymbol("M", 2, 2), sp.MatrixSymbol("M", 2, 2)),
        (Matrix([1, 2]), Matrix([[1, 2]])),
        (Matrix([[x, y], [1, 2]]), [x, y, 1, 2]),
        (Matrix([[x, y], [1, 2]]), Matrix([x, y, 1, 2])),
        ([[x, y], [1]], [[x], [y, 1]]),
        (ZERO**y * ZERO ** (x - y), ZERO**x),  # zero to a power of either sign
        (2 * ZERO**y, ZERO**y),
        (0**x, 0**x * 2),
        # one over a product of which one factor vanishes wherever the other does not
        (1 / (sqrt(x**2) - x) / (sqrt(x**2) + x), 2 / (sqrt(x**2) - x) / (sqrt(x**2) + x)),
        (sqrt(ZERO) / sqrt(ZERO + ZERO), 1),
    ],
)
def test_what_is_false_or_undefined_is_not_proved(left, right):
    assert not prove(left, right)


def test_lists_stand_for_rows_columns_and_single_things():
    assert prove([x, y], Matrix([x, y]))
    assert prove(Matrix([[x, y]]), (x, y))
    assert prove([[x, y], [1, 2]], Matrix([[x, y], [1, 2]]))
    assert prove(x, [x])


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (Eq(5, x), Eq(5, 2 * x - 5)),  # both say x = 5
        (Eq(0, x - 1), Eq(0, 3 - 3 * x)),
        (Eq(x**2, -1), Eq(x**2, -2)),  # neither holds for a real x
        (Eq(sp.Symbol("p", positive=True), -1 - y**2), Eq(sp.Symbol("p", positive=True), -2)),
        (Eq(x, sqrt(-1 - y**2)), Eq(x, sqrt(-2 - y**2))),
    ],
)
def test_equations_with_the_same_solutions_are_not_refuted(left, right):
    assert prove(left, right).kind != Kind.REFUTED


n = sp.Symbol("n", integer=True)
p = sp.Symbol("x", positive=True)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (cos(pi * n), (-1) ** n),
        (sin(pi * n / 2) ** 2, (1 - (-1) ** n) / 2),
        (exp(2 * pi * I * n + x), exp(x)),
        (sqrt(p**2), sqrt(x**2)),
        (sp.Abs(x), p),
        ((-1) ** sp.Symbol("m") + sp.Symbol("m", even=True), 1 + sp.Symbol("m")),
        (sqrt(x * y), sqrt(x) * sqrt(sp.Symbol("y", nonnegative=True))),
        (sp.Abs(x), -sp.Symbol("x", negative=True)),
    ],
)
def test_what_holds_where_the_symbols_are_is_not_refuted(left, right):
    assert prove(left, right).kind != Kind.REFUTED


@pytest.mark.parametrize(
    ("left", "right", "assumed"),
    [
        ((-1) ** n, n, "integer"),
        (p**2, p, "positive"),
        (sp.Symbol("x", negative=True) ** 3, sp.Abs(x), "negative"),
        (sp.Symbol("x", prime=True), 4 + x - 4 + (x - 2) * (x - 3), "prime"),
        (sp.Symbol("x", irrational=True) ** 2, 2 + 0 * x, "irrational"),
    ],
)
def test_a_counterexample_has_what_is_assumed(left, right, assumed):
    verdict = prove(left, right)
    if verdict.kind == Kind.REFUTED:
        (at,) = verdict.counterexample.values()
        assert getattr(sp.sympify(at), f"is_{assumed}")
    else:
        assert verdict.kind == Kind.UNDECIDED


def test_an_integer_is_refuted_at_an_integer():
    assert prove((-1) ** n, 1).counterexample == {"n": "1"}  # the first odd number
    assert sp.sympify(prove(n**2, n).counterexample["n"]) not in (0, 1)


def test_a_user_writes_the_stiffness_limit_with_positive_symbols():
    # (11) as corrected, by hand: 2 b/T tan(pi/(4 (d+1)))
    b, d, T = symbols("b d T", positive=True)
    right = formula("eq11").derived[0].rhs
    assert prove(2 * b / T * sp.tan(pi / (4 * (d + 1))), right)
    wrong = prove(2 * b / T * sp.tan(pi / (4 * d + 1)), right)
    assert wrong.kind == Kind.REFUTED
    assert all(sp.Rational(value) > 0 for value in wrong.counterexample.values())


def test_assumptions_of_one_name_add_up():
    whole, positive = sp.Symbol("k", integer=True), sp.Symbol("k", positive=True)
    verdict = prove(whole, positive**2)
    assert verdict.kind == Kind.REFUTED
    at = sp.Rational(verdict.counterexample["k"])
    assert at.is_integer
    assert at > 1


def test_contradicting_assumptions_are_named():
    with pytest.raises(ValueError, match=r"prove: x is assumed to be .* in one place"):
        prove(sp.Symbol("x", negative=True), p)
    with pytest.raises(ValueError, match="prove: x is assumed"):
        prove(sp.Symbol("x", imaginary=True) + p, 0)


def test_a_point_where_sympy_drops_a_pole_refutes_nothing():
    # at x = 0 the left side is not defined; SymPy takes 1/zoo for 0
    assert prove(1 / sp.cot(x) + 1 / x, sp.tan(x) + 1 / x).kind != Kind.REFUTED
    found = prove(1 / sp.cot(x), sp.tan(x) + x)
    assert found.kind == Kind.REFUTED
    assert sp.sympify(found.counterexample["x"]) != 0


def test_order_of_numbers_that_are_not_real_is_no_counterexample():
    # at x < 0 neither relation says anything
    assert prove(sqrt(x) > sqrt(x) - 1, sqrt(x) > sqrt(x) - 2).kind != Kind.REFUTED


def test_unknown_functions_do_not_meet_symbols_of_the_same_name():
    line = sp.Symbol("f_0") + sp.Symbol("f_1") * x
    assert prove(f(x), line).kind == Kind.REFUTED


def test_two_numbers_for_one_symbol_are_told_apart_at_one_of_them():
    assert prove(Eq(x, 1), Eq(x, 2)).counterexample == {"x": "1"}
    negative = sp.Symbol("x", negative=True)
    one, two, other = (Eq(negative, k, evaluate=False) for k in (1, 2, -2))
    assert prove(one, other).counterexample == {"x": "-2"}
    assert prove(one, two).kind != Kind.REFUTED  # neither holds


def test_a_function_keeps_what_is_assumed_of_it():
    positive = Function("f", positive=True)
    assert prove(positive(x), sp.Abs(f(x))).kind == Kind.UNDECIDED
    assert "f_0" not in (prove(positive(x), -1).counterexample or {})


def test_dummies_of_one_name_are_two():
    one, other = sp.Dummy("x"), sp.Dummy("x", positive=True)
    verdict = prove(one, other)
    assert verdict.kind == Kind.REFUTED
    assert set(verdict.counterexample) == {"x", "x_2"}


def test_truths_are_compared():
    assert prove(Eq(x, x), True)
    assert not prove(Eq(x, x), False)
    assert not prove(x > 0, True)


def test_numbers_of_two_kinds_are_compared():
    assert prove(Rational(1, 2), sp.S.Half)
    assert prove(1, 1)
    assert not prove(0.5, sp.S.Half)  # a float is not an exact number


def test_an_exponent_that_sympy_writes_anew_is_undecided():
    # times a logarithm the root of the root of 2 becomes its fourth root
    fourth = sp.Pow(sqrt(2), sp.S.Half, evaluate=False)
    power = sp.Pow(3 + x, fourth, evaluate=False)
    assert prove(power, power + 1).kind in (Kind.REFUTED, Kind.UNDECIDED)


def test_a_root_keeps_its_branch_where_a_tangent_becomes_exponentials():
    """tan 2 < 0: of 1/tan 2 and of tan 2 the powers are -0.31 j and 0.31 j."""
    inverse = sp.Pow(1 / sp.tan(2), Rational(3, 2), evaluate=False)
    assert prove(inverse, sp.tan(2) ** Rational(-3, 2)).kind == Kind.REFUTED
    with pytest.raises(NotShown, match="is not shown by a normal form"):
        identity(inverse, sp.tan(2) ** Rational(-3, 2))

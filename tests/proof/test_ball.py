"""A ball contains the value, is narrow, and never shows more than it contains."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Abs, Eq, I, Rational, cos, exp, pi, re, sin, sqrt, tan

from symhaptic.proof.ball import ball, differs_from_zero, sign, zeros_inside
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.values import value_at

x, y, d = sp.symbols("x y d")

# Decimals to 40 digits from OEIS: A000796, A001113, A002193, A002163.
CONSTANTS = {
    pi: "3.141592653589793238462643383279502884197",
    sp.E: "2.718281828459045235360287471352662497757",
    sqrt(2): "1.414213562373095048801688724209698078570",
    sqrt(5): "2.236067977499789696409173668731276235441",
}


@pytest.mark.parametrize(("constant", "decimals"), CONSTANTS.items())
def test_constant_is_enclosed_narrowly(constant, decimals):
    found = ball(constant, bits=160).real
    with ctx.workprec(256):
        # the decimals are rounded at the 39th place
        assert abs(found - arb(decimals)) < arb("1e-38")
    # 160 bits leave 2^-159 of rounding per operation, times the value
    assert found.rad() < arb(2) ** -150


POINTS = st.fractions(min_value=-3, max_value=3, max_denominator=50)
FORMS = st.sampled_from(
    [
        sin(x) * exp(y) + x**3,
        cos(x * y) / (2 + sin(y)),
        exp(I * x) - tan(y / 7),
        Abs(x - y) + sqrt(4 + y),
        re(exp(I * x) * (y + I)),
        sp.sinh(x) - sp.cosh(y) + sp.tanh(x),
        (5 + x) ** (y / 3),
        sp.conjugate(x + I * y),
    ]
)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(FORMS, POINTS, POINTS)
def test_ball_contains_the_value_and_is_narrow(form, at_x, at_y):
    at = {x: Rational(at_x), y: Rational(at_y)}
    found = ball(form, at, bits=128)
    with mpmath.workdps(60):
        exact = sp.lambdify([x, y], form, "mpmath")(
            *(mpmath.mpf(v.p) / v.q for v in (at[x], at[y]))
        )
        exact = mpmath.mpc(exact)
        decimals = mpmath.nstr(exact.real, 50), mpmath.nstr(exact.imag, 50)
    for part, digits in zip((found.real, found.imag), decimals, strict=True):
        with ctx.workprec(256):
            # 50 decimals are given, of values below 2^10
            assert (part - arb(digits)).abs_lower() < arb("1e-45")
        # values stay below 2^10 here, each of about ten operations rounds at 2^-128
        assert part.rad() < arb(2) ** -105


def test_unknown_function_or_symbol_has_no_ball():
    for expr in (sp.gamma(x), sp.Function("H")(1), x, sp.zoo):
        with pytest.raises(Unsupported):
            ball(expr)


def test_division_by_zero_is_not_finite():
    assert not ball(1 / x, {x: 0}).is_finite()


def test_precision_is_put_back():
    before = ctx.prec
    ball(pi, bits=999)
    assert ctx.prec == before


def test_equal_numbers_are_never_told_apart():
    # tan(pi/8) = sqrt(2) - 1
    assert differs_from_zero(sin(pi / 8) / cos(pi / 8) - sqrt(2) + 1) is None


def test_close_numbers_are_told_apart():
    # 355/113 and pi agree to 2.7e-7; 10^-100 needs more than the first precision
    assert differs_from_zero(pi - Rational(355, 113))
    assert differs_from_zero(sin(1) ** 2 + cos(1) ** 2 - 1 + Rational(1, 10**100))


@pytest.mark.parametrize(
    ("expr", "found"),
    [
        (pi - 3, 1),
        (Rational(22, 7) - pi, 1),  # Archimedes
        (pi - Rational(355, 113), -1),
        (sin(1) ** 2 + cos(1) ** 2 - 1, 0),
        (sin(1) ** 2 + cos(1) ** 2 - 1 - Rational(1, 10**100), -1),
        (exp(pi * sqrt(163)) - 262537412640768744, -1),  # Ramanujan's constant, 7.5e-13 below
        (sp.S.Zero, 0),
    ],
)
def test_sign_of_a_number(expr, found):
    assert sign(expr) == found


def test_number_that_is_not_real_has_no_sign():
    tiny = sin(1) ** 2 + cos(1) ** 2 - 1 + Rational(1, 2**90)
    assert sign(1 + I) is None
    assert sign(1 + I * tiny) is None


@pytest.mark.parametrize(
    ("expr", "at", "value"),
    [
        (x / (x - 1), {x: 1}, None),
        (1 / (sin(x) ** 2 + cos(x) ** 2 - y), {x: 1, y: 1}, None),
        ((x**2 - 1) / (x - 1), {x: 1}, None),  # a removable gap is a gap
        (x ** (-d), {x: 0, d: 1}, None),
        (x ** (-d), {x: 2, d: 3}, Rational(1, 8)),
        (x > 0, {x: 0}, False),
        (x >= 0, {x: 0}, True),
        (x < 1 / y, {x: 0, y: 0}, None),
        (Eq(sin(x) ** 2, 1 - cos(x) ** 2, evaluate=False), {x: 1}, True),
        (Eq(x, pi), {x: Rational(22, 7)}, False),
        (cos(pi * x), {x: 1}, sp.S(-1)),
    ],
)
def test_value_at_a_point(expr, at, value):
    assert value_at(expr, {s: sp.sympify(v) for s, v in at.items()}) == value


def test_equality_at_a_point_is_not_denied_without_a_ball():
    # sqrt(5 + 2 sqrt 6) = sqrt 2 + sqrt 3, by squaring: true, and beyond the normal form
    nested = sp.sqrt(5 + 2 * sp.sqrt(6))
    equation = sp.Eq(nested, sp.sqrt(2) + sp.sqrt(3), evaluate=False)
    try:
        found = value_at(equation, {})
    except Unsupported:
        found = None
    assert found is not False


z = sp.Symbol("z")


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(-9, 9), min_size=2, max_size=9).filter(lambda c: c[0] != 0))
def test_zeros_are_inside_where_numpy_finds_them_there(falling):
    largest = max(abs(np.roots(falling)), default=0.0)
    shown = zeros_inside(sp.Poly(falling, z).as_expr() + 0 * z, z) if any(falling[1:]) else True
    if largest > 1 - 1e-9:
        assert not shown
    elif largest < 1 - 1e-6:
        assert shown


@pytest.mark.parametrize(
    "polynomial",
    [
        z - 1,
        z**2 + 1,
        z - exp(I),
        (z - Rational(1, 2)) * (z - 2),
        z**2 - (1 + Rational(1, 10**400)),
        z**3 / 10**9 + z**2 - Rational(1, 4),
    ],
)
def test_zeros_on_the_circle_or_outside_are_not_inside(polynomial):
    assert not zeros_inside(sp.expand(polynomial), z)


@pytest.mark.parametrize(
    "nothing",
    [
        (z + 1) * (z - 1) - z**2 + 1,
        (z + 1) * (z - 1) - z**2 + sp.sin(1) ** 2 + sp.cos(1) ** 2,
        (z + sp.pi) * (z - sp.pi) - z**2 + sp.pi**2,
    ],
)
def test_the_zeros_of_nothing_are_everywhere(nothing):
    assert not zeros_inside(nothing, z)


def test_a_constant_has_no_zeros():
    assert zeros_inside((z + 1) * (z - 1) - z**2 + 2, z)


def test_zeros_close_to_the_circle_are_inside():
    assert zeros_inside(z**2 - (1 - Rational(1, 10**400)), z)
    assert zeros_inside(z - exp(I) * (1 - Rational(1, 10**40)), z)
    assert zeros_inside(z**300 - Rational(99, 100) * z**7 + Rational(1, 1000), z)

"""Balls around roots contain them, and nothing is taken for what it is not."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx
from sympy import Rational, S, cos, pi, sin, sqrt, tan

from symhaptic.book.page import Page
from symhaptic.book.record import FalseStep
from symhaptic.proof.ball import bound, largest_root
from symhaptic.proof.certificate import Zero
from symhaptic.proof.recheck import recheck
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.roots import (
    NoSuchRoot,
    algebraic,
    between_decimals,
    decimals,
    real_roots,
    root_between,
    rounded,
    zero,
)

x, y, z = sp.symbols("x y z")

ZEROS = {
    # function, interval, and the zero by mpmath's own search
    "cosine": (cos(x), S.One, S(2), lambda v: mpmath.cos(v)),
    "tangent": (2 * cos(x) - x * sin(x), S.One, Rational(6, 5), lambda v: v * mpmath.tan(v) - 2),
    "exponential": (sp.exp(x) - 3, S.One, Rational(6, 5), lambda v: mpmath.exp(v) - 3),
}


@pytest.mark.parametrize("name", ZEROS)
def test_zero_of_a_function(name):
    function, low, high, same = ZEROS[name]
    found = zero(function, x, low, high).ball
    with mpmath.workdps(70):
        expected = mpmath.findroot(same, (float(low) + float(high)) / 2)
        with ctx.workprec(256):
            # mpmath's 70 digits, less some for the search
            assert abs(found - arb(mpmath.nstr(expected, 68))) < arb("1e-60")
    assert found.rad() < arb(2) ** -240  # 256 bits, less a few roundings


@pytest.mark.parametrize(
    ("function", "low", "high"),
    [
        (x**2 + 1, S(-1), S(2)),  # none
        (cos(x), S.Zero, S(6)),  # two, and a slope that vanishes
        (cos(x), S.Zero, S.One),  # outside
        (x**2, S(-1), S.One),  # a double one
        (sp.exp(x) - 3, S.One, S(2)),  # alone, but too wide for one step
        (tan(x), S.One, S(2)),  # a pole changes the sign as well
    ],
)
def test_zero_that_is_not_there_alone(function, low, high):
    with pytest.raises(NoSuchRoot):
        zero(function, x, low, high)


def test_root_between_real_numbers():
    # cos(pi/7) is a root of 8x^3 - 4x^2 - 4x + 1 (textbook), the others are below it
    polynomial = 8 * x**3 - 4 * x**2 - 4 * x + 1
    found = root_between(polynomial, S.Half, S.One)
    with ctx.workprec(256):
        assert found.overlaps((arb.pi() / 7).cos())
    with pytest.raises(NoSuchRoot, match="2 roots"):
        root_between(polynomial, S.Zero, S.One)
    with pytest.raises(NoSuchRoot, match="0 roots"):
        root_between(polynomial, S.One, S(2))
    with pytest.raises(NoSuchRoot, match="at an end"):
        root_between(x**2 - 2, sqrt(2), S(2))
    with pytest.raises(NoSuchRoot, match="2 roots"):
        root_between((x - 1) ** 2, S.Zero, S(2))


def test_minimal_polynomial_of_an_algebraic_number():
    # 2 cos(2 pi/7) has y^3 + y^2 - 2y - 1 (textbook); it is its only positive root
    found = algebraic(2 * x, 8 * x**3 + 4 * x**2 - 4 * x - 1, x, y, S.Half, S.One)
    assert sp.expand(found.minimal - (y**3 + y**2 - 2 * y - 1)) == 0
    assert found.positive_roots_below == 0
    with ctx.workprec(256):
        assert found.ball.overlaps(2 * (2 * arb.pi() / 7).cos())
    # sqrt 2 + 1 and 1/(sqrt 2 + 1) = sqrt 2 - 1: the larger has the other conjugate below zero
    larger = algebraic(x + 3, x**2 - 2, x, y, S.Zero, S(2))
    assert sp.expand(larger.minimal - (y**2 - 6 * y + 7)) == 0
    assert larger.positive_roots_below == 1


@pytest.mark.parametrize(
    ("value", "modulus", "match"),
    [
        (x**2, x**2 - 2, "lower degree"),  # the number 2
        (x, (x**2 - 2) * (x**2 + 1), "lower degree"),  # a modulus that factors
        (1 / (x**2 - 2), x**2 - 2, "vanishes at a root"),
        (x, x**2 - 5, "0 roots"),
    ],
)
def test_number_that_is_not_what_it_should_be(value, modulus, match):
    with pytest.raises(NoSuchRoot, match=match):
        algebraic(value, modulus, x, y, S.Zero, S(2))


def test_decimals_are_cut_off_and_never_guessed():
    with ctx.workprec(128):
        assert decimals(arb(2) / 3, 10) == "0.6666666666"
        assert decimals(arb(1) / 32, 4) == "0.0312"
        assert decimals(arb(12345), 3) == "12345.000"
        for unknown in (arb(2, 1e-3), arb(-1) / 3, arb("1 +/- 1e-30")):
            with pytest.raises(NoSuchRoot):
                decimals(unknown, 6)


def test_a_polynomial_has_no_root_where_a_coefficient_has_no_value():
    nothing = 1 / (sp.sin(1) ** 2 + sp.cos(1) ** 2 - 1)
    cancelled = sp.Add(z * nothing, -z * nothing, z, -2, evaluate=False)
    zero = sp.Mul(0, nothing, z, evaluate=False)
    for polynomial in (cancelled, sp.Add(zero, z, -2, evaluate=False), nothing * z - 2):
        with pytest.raises(Unsupported, match="not isolated"):
            largest_root(polynomial)


def test_largest_root_with_coefficients_that_are_no_fractions():
    # (z - 1/e)(z + 1/2)
    polynomial = z**2 + (S.Half - sp.exp(-1)) * z - sp.exp(-1) / 2
    assert largest_root(polynomial).overlaps(arb("0.5"))
    assert largest_root(z**2 - pi).overlaps(arb.pi().sqrt())


def test_roots_next_to_the_circle_are_narrow():
    close = sp.exp(-Rational(1, 10**8))
    inside = largest_root((z**40 - close) * (z - sp.exp(-1)))
    assert inside < 1
    assert inside.rad() < 1e-15
    assert largest_root((z**3 - 1) * (z - sp.exp(-1))).contains(1)


def test_a_bound_is_never_too_small_or_too_large():
    assert bound(arb(99951) / 100000, above=True) == "0.9996"
    assert bound(arb(100029) / 100000, above=False) == "1.0002"


def test_page_names_the_smallest_positive_root_only():
    small = algebraic(3 - x, x**2 - 2, x, y, S.Zero, S(2))
    large = algebraic(3 + x, x**2 - 2, x, y, S.Zero, S(2))
    page = Page("test")
    page.minimal("numbers", [("a", small)])
    assert page.blocks[-1].verdict == "proved"
    with pytest.raises(FalseStep, match="smaller positive root"):
        page.minimal("numbers", [("a", small), ("b", large)])


def test_page_prints_what_the_ball_knows():
    page = Page("test")
    page.enclosed("root", [("a", sp.sqrt(2))], places=10)
    assert page.blocks[-1].lines == (("a", "=", r"1.4142135623\ldots"),)
    assert page.blocks[-1].verdict == "enclosed"
    wide = Zero(x**2 - 2, x, (S.One, S(2)), arb("1.414213562", 1e-9), 53)
    with pytest.raises(NoSuchRoot):
        page.enclosed("root", [("a", wide)], places=20)


def test_a_rational_zero_is_checked_again():
    """The solutions by hand: Newton's step meets them exactly, and no width is left."""
    for expr, root in ((x - 1, S.One), (3 * x - 2, Rational(2, 3)), (x**3 - 8, S(2)), (x, S.Zero)):
        found = zero(expr, x, root - Rational(1, 20), root + Rational(1, 30))
        assert (found.ball * int(root.q)).contains(int(root.p))
        assert recheck(found)


def test_real_roots_of_planted_polynomials():
    rng = np.random.default_rng(2014)
    for _ in range(50):
        planted = np.sort(rng.choice(np.arange(-20, 21), size=3, replace=False)) / 8
        pair = rng.uniform(-1, 1), rng.uniform(0.1, 1)
        p = np.polymul(np.poly(planted), [1, -2 * pair[0], pair[0] ** 2 + pair[1] ** 2])
        found = real_roots([arb(float(c)) for c in p[::-1]])
        assert [float(r) for r in found] == pytest.approx(planted.tolist(), abs=1e-10)


def test_real_roots_refuses_a_double_root():
    with pytest.raises(NoSuchRoot, match="told apart"):
        real_roots([arb("0.1") ** 2, -2 * arb("0.1"), arb(1)])


def test_rounded_refuses_what_it_does_not_know():
    with pytest.raises(NoSuchRoot, match="may be zero"):
        rounded(arb(0, 1))
    with pytest.raises(NoSuchRoot, match="not known"):
        rounded(arb(1, 0.001))
    assert rounded(-arb(200).sqrt(), 5) == "-14.142"


def test_between_decimals_wants_a_change_of_sign():
    with pytest.raises(NoSuchRoot, match="opposite signs"):
        between_decimals(lambda x: arb(int(x.p), 0) ** 2 + 1, 1, 2, 6)


def test_a_zero_in_a_ball_of_a_parameter():
    """cos(y x) for y within 1/1000 of 1: the zero is within 1/500 of pi/2."""
    at = zero(cos(y * x), x, S.One, S(2), {y: arb(1, 0.001)}).ball
    assert at.contains(arb.pi() / 2)
    assert at.rad() < 0.01

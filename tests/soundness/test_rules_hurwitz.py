"""Hurwitz' criterion: what it says is what the zeros do, and nothing else may be put into it."""

import numpy as np
import pytest
import sympy as sp
from sympy import I, S, symbols

from symhaptic.notation import s
from symhaptic.notation.proposition import Iff, Predicate, Relation
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.theorems.roots import hurwitz

x, y, n, p = symbols("x y n p")
RNG = np.random.default_rng(1895)


def test_the_criterion_of_a_cubic():
    found = hurwitz(x * s**3 + y * s**2 + n * s + p, s)
    assert found.hypotheses == {Relation(S.Zero, "<", x)}
    assert isinstance(found.conclusion, Iff)
    zeros, positive = found.conclusion.of
    assert zeros == Predicate("hurwitz", (s,), (x * s**3 + y * s**2 + n * s + p,))
    product = y * n - x * p
    wanted = [Relation(S.Zero, "<", sp.expand(e)) for e in (y, product, p * product)]
    assert list(positive.of) == wanted


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5])
def test_it_says_where_the_zeros_lie(degree):
    """numpy's zeros of random polynomials, with as many on the left as on the right."""
    names = symbols(f"p_:{degree}")
    polynomial = s**degree + sum(c * s**i for i, c in enumerate(names))
    decide = sp.lambdify(names, [r.right for r in hurwitz(polynomial, s).conclusion.of[1].of])
    seen = set()
    for _ in range(300):
        zeros = RNG.uniform(-2, 0.4, degree // 2) + 1j * RNG.uniform(0, 2, degree // 2)
        alone = RNG.uniform(-2, 0.4, degree % 2)
        all_of_them = [*zeros, *zeros.conj(), *alone]
        coefficients = np.poly(all_of_them).real[::-1][:-1]
        stable = max(z.real for z in all_of_them) < 0
        assert all(v > 0 for v in decide(*coefficients)) == stable
        seen.add(stable)
    assert seen == {True, False}


def test_zeros_on_the_axis_do_not_lie_on_the_left():
    for polynomial in (s**2 + 1, s**3 + s**2 + s + 1, s**2 + s, (s**2 + 1) * (s + 1) ** 2):
        positive = hurwitz(polynomial, s).conclusion.of[1]
        assert not all(sp.sympify(r.right) > 0 for r in positive.of)


def test_a_divisor_of_a_coefficient_is_a_hypothesis():
    found = hurwitz(s**2 + s / x + 1, s)
    assert Relation(x, "!=", S.Zero) in found.hypotheses


def test_a_leading_coefficient_that_is_not_positive_is_not_assumed_away():
    found = hurwitz(-(s**2) - s - 1, s)
    assert found.hypotheses == {Relation(S.Zero, "<", -S.One)}


@pytest.mark.parametrize(
    "polynomial",
    [
        S.One,  # no zero to speak of
        x,
        s**n + x,  # a degree that is no number
        s**2 + 1 / s,
        s**2 + sp.exp(s),
        s**2 + I * s + 1,  # not real
        s**2 + sp.sqrt(x) * s + 1,
        sp.sqrt(s) + 1,
    ],
)
def test_what_is_no_real_polynomial_is_refused(polynomial):
    with pytest.raises(NotShown):
        hurwitz(polynomial, s)

"""Hurwitz' first minors of zeros inside the circle: what they say holds, and no more is said."""

import numpy as np
import pytest
import sympy as sp
from sympy import I, S, symbols

from symhaptic.notation import z
from symhaptic.notation.proposition import Not, Predicate, Relation, proposition, whole
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.theorems.roots import first_minors
from symhaptic.proof.theorems.tactics import zero_beyond

x, y, n, p = symbols("x y n p")
RNG = np.random.default_rng(1877)


def stable(polynomial):
    return Predicate("stable", (z,), (polynomial,))


def test_two_minors_of_a_cubic():
    """(1-s)^3 p((1+s)/(1-s)) for p = z^3 + x z + y, by hand."""
    found = first_minors(assume(stable(z**3 + x * z + y)), 2)
    assert found.hypotheses == {stable(z**3 + x * z + y)}
    c = 1 + x + y, 3 - x - 3 * y, 3 - x + 3 * y, 1 + x - y
    wanted = c[0], c[1], c[1] * c[2] - c[0] * c[3]
    for claim, expr in zip(found.conclusion.parts, wanted, strict=True):
        assert claim.sign == "<"
        assert claim.left == 0
        assert sp.expand(claim.right - expr) == 0


@pytest.mark.parametrize(("degree", "power"), [(1, 0), (2, 0), (3, 0), (4, 0), (1, 2), (2, 3)])
def test_all_minors_are_positive_for_zeros_inside(degree, power):
    """numpy's random zeros; the powers in symbols are those in numbers."""
    names = symbols(f"p_:{degree}")
    lower = sum(c * z**i for i, c in enumerate(names))
    exponent = n if power else S.Zero
    found = first_minors(assume(stable(sp.expand(z**exponent * (z**degree + lower)))), degree)
    assert {h for h in found.hypotheses if h.free & {n}} if power else True
    minors = [claim.right.subs(n, power) for claim in found.conclusion.parts]
    decide = sp.lambdify(names, minors)
    for _ in range(100):
        half = RNG.uniform(0, 0.99, degree // 2) * np.exp(1j * RNG.uniform(0, 3, degree // 2))
        zeros = [*half, *half.conj(), *RNG.uniform(-0.99, 0.99, degree % 2)]
        assert all(v > 0 for v in decide(*np.poly(zeros).real[::-1][:-1]))


def test_a_zero_outside_is_seen_by_one_of_all_minors():
    """A real zero beyond 1 makes the first of them negative."""
    for polynomial in (z - 2, z**2 - 3 * z + 1, z**3 - 2):
        first = first_minors(assume(stable(polynomial)), 1).conclusion.parts[0]
        assert first.right < 0


def test_exponents_are_whole_by_hypothesis():
    found = first_minors(assume(stable(z ** (n + 2) + x * z ** (n + 1) + y)), 2)
    assert {whole(n + 2), whole(n + 1), whole(n)} <= found.hypotheses


def test_a_divisor_of_a_coefficient_is_a_hypothesis():
    found = first_minors(assume(stable(z**2 + z / x)), 1)
    assert Relation(x, "!=", S.Zero) in found.hypotheses


@pytest.mark.parametrize(
    ("polynomial", "count"),
    [
        (z**2 + x, 3),  # more minors than zeros
        (z**n + x, 1),  # there may be no zero
        (z ** (n + 1) + x, 2),
        (z**2 + x, -1),
        (-(z**2) + x, 1),  # not monic
        (x * z**2 + y, 1),
        (z**n + z**p, 0),  # which power is the highest?
        (z**2 + 1 / z, 1),
        (z**2 + I * z + x, 1),  # not real
        (z**2 + sp.sqrt(x) * z, 1),
        (z ** (n / 2 + 2) + z ** (n / 2 + 1) + x, 1),  # n/2 need not be whole
        (z**2 + sp.exp(z), 1),
        (S.Zero, 0),
    ],
)
def test_what_is_no_monic_real_polynomial_is_refused(polynomial, count):
    with pytest.raises(NotShown):
        first_minors(assume(stable(polynomial)), count)


def test_zeros_have_to_lie_inside():
    for claim in (
        Not((stable(z**2 + x),)),
        Predicate("hurwitz", (z,), (z**2 + x,)),
        proposition(x > 0),
    ):
        with pytest.raises(NotShown):
            first_minors(assume(claim), 1)


def test_a_polynomial_that_is_not_positive_at_one_has_a_zero_beyond():
    found = zero_beyond(z**2 - x, z, assume(1 - x <= 0))
    assert found.conclusion == Not((stable(z**2 - x),))
    assert found.hypotheses == {proposition(1 - x <= 0)}
    assert not zero_beyond(z - 2, z, number(Relation(-S.One, "<", S.Zero))).hypotheses
    with pytest.raises(NotShown):
        zero_beyond(z**2 - x, z, assume(1 - x >= 0))

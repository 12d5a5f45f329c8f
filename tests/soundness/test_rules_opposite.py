"""Zeros of p(-z) are those of p, turned by half a circle; only where parities are seen."""

import numpy as np
import pytest
import sympy as sp
from sympy import I, symbols

from symhaptic.notation import z
from symhaptic.notation.proposition import Not, Predicate, Relation, whole
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.roots import opposite

x, y, n = symbols("x y n")
RNG = np.random.default_rng(1637)


def stable(polynomial, variable=z):
    return Predicate("stable", (variable,), (polynomial,))


@pytest.mark.parametrize("degree", [1, 2, 3, 6])
def test_its_zeros_are_the_opposite_ones(degree):
    names = symbols(f"p_:{degree}")
    polynomial = z**degree + sum(c * z**i for i, c in enumerate(names))
    found = opposite(assume(stable(polynomial)))
    assert found.hypotheses == {stable(polynomial)}
    at = dict(zip(names, RNG.normal(size=degree), strict=True))
    ours, theirs = (
        np.roots(sp.Poly(p.subs(at), z).all_coeffs()).astype(complex)
        for p in (polynomial, found.conclusion.of[0])
    )
    assert np.sort_complex(-ours) == pytest.approx(np.sort_complex(theirs), abs=1e-9)


def test_even_multiples_of_what_is_whole_keep_a_sign():
    found = opposite(assume(stable(z ** (4 * n + 3) + x * z ** (2 * n) + y)))
    assert sp.expand(found.conclusion.of[0] - z ** (4 * n + 3) + x * z ** (2 * n) + y) == 0
    assert whole(n) in found.hypotheses


@pytest.mark.parametrize(
    "theorem",
    [
        assume(stable(z ** (n + 1) + x)),  # the parity of n is not known
        assume(stable(z ** (2 * n) + x)),  # n may be 0
        assume(stable(2 * z + x)),  # not monic
        assume(stable(z + I * x)),  # not real
        assume(stable(z + 1 / z)),  # no polynomial
        assume(Not((stable(z - x),))),
        assume(Relation(x, "<", y)),
    ],
)
def test_what_has_no_seen_parity_is_refused(theorem):
    with pytest.raises(NotShown):
        opposite(theorem)

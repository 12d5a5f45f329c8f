"""Zeros inside outpace: n |p|^2 < 2 Re conj(p) z p' on the circle, and no more is said."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from sympy import I, S, pi, symbols

from symhaptic.notation import z
from symhaptic.notation.proposition import Not, Predicate, Relation, whole
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.roots import outpaces

x, y, n, t = symbols("x y n t")
RNG = np.random.default_rng(1966)


def stable(polynomial, variable=z):
    return Predicate("stable", (variable,), (polynomial,))


def test_one_zero():
    """2 Re z (conj z - x) - |z - x|^2 = 1 - x^2, whatever the angle."""
    found = outpaces(assume(stable(z - x)), t)
    assert found.hypotheses == {stable(z - x)}
    assert found.conclusion.sign == "<"
    assert found.conclusion.left == 0
    assert sp.expand(found.conclusion.right) == 1 - x**2


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
def test_it_holds_of_random_zeros_inside_and_is_their_sum(degree):
    for radius in (0.3, 0.9, 0.999):
        half = RNG.uniform(0, radius, size=degree // 2)
        zeros = [
            r * np.exp(s * 1j * u) for r, u in zip(half, half * 9, strict=True) for s in (1, -1)
        ]
        zeros += [RNG.uniform(-radius, radius)] * (degree % 2)
        falling = np.poly(zeros).real
        names = symbols(f"p_:{degree}")
        polynomial = z**degree + sum(c * z**i for i, c in enumerate(names))
        claim = outpaces(assume(stable(polynomial)), t).conclusion
        for angle in RNG.uniform(-3, 3, size=4):
            at = dict(zip(names, map(float, falling[:0:-1]), strict=True)) | {t: float(angle)}
            found = complex(sp.N(claim.right.subs(at)))
            turn = mpmath.expj(float(angle))
            wanted = abs(np.polyval(falling, complex(turn))) ** 2 * sum(
                2 * (complex(turn) / (complex(turn) - zero)).real - 1 for zero in zeros
            )
            assert found.real == pytest.approx(wanted, rel=1e-6, abs=1e-12)
            assert abs(found.imag) < 1e-9
            assert found.real > 0


def test_exponents_in_symbols_are_whole_by_hypothesis():
    found = outpaces(assume(stable(z ** (n + 1) + x)), t)
    assert whole(n + 1) in found.hypotheses
    assert whole(n) in found.hypotheses
    three = found.conclusion.at({n: S(2)})
    assert sp.simplify(three.right - outpaces(assume(stable(z**3 + x)), t).conclusion.right) == 0


def test_that_there_is_a_zero_is_a_hypothesis():
    # of z^(n + 1) alone; n = -1 would leave 1, of which 0 < 0 would be said
    assert whole(n) in outpaces(assume(stable(z ** (n + 1))), t).hypotheses


@pytest.mark.parametrize(
    "theorem",
    [
        assume(stable(S.One * z**0 + 0 * z)),  # no zero at all
        assume(stable(z**n + x)),  # n may be 0
        assume(stable(2 * z + x)),  # not monic
        assume(stable(z + I * x)),  # not real
        assume(stable(z + 1 / z)),  # no polynomial
        assume(Not((stable(z - x),))),
        assume(Relation(x, "<", y)),
    ],
)
def test_what_is_not_a_monic_real_polynomial_with_zeros_inside_is_refused(theorem):
    with pytest.raises(NotShown):
        outpaces(theorem, t)


@pytest.mark.parametrize("angle", [I * t, z, pi * z])
def test_an_angle_is_real_and_not_the_variable(angle):
    with pytest.raises(NotShown):
        outpaces(assume(stable(z - x)), angle)


def test_of_a_zero_outside_it_would_be_false():
    """z - 2 at any angle: 1 - 4 < 0, so that the hypothesis is needed."""
    assert outpaces(assume(stable(z - x)), t).conclusion.at({x: S(2)}).right.expand() == -3

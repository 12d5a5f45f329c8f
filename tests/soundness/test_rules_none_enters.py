"""No zero enters the right half of what lies outside the circle: each hypothesis is needed."""

import numpy as np
import pytest
import sympy as sp
from sympy import I, Ne, Rational, S, exp, log, pi, sqrt, symbols

from symhaptic.notation import z
from symhaptic.notation.proposition import (
    And,
    ForAll,
    Implies,
    Not,
    Predicate,
    Relation,
    proposition,
    whole,
)
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.roots import none_enters

v, q, t, x, y, n, c = symbols("v q t x y n c")
OVER = (v, q, t, x, y)
PLACES = (I * t, S.Zero, t + I * pi / 2)
RNG = np.random.default_rng(1949)


def stable(polynomial, variable=z):
    return Predicate("stable", (variable,), (sp.sympify(polynomial),))


def shown(polynomial, change, share=q, place=t):
    """That p(v^2) + q g(v) is not zero at each place, assumed."""
    path = polynomial.subs(z, v**2) + share * sp.sympify(change)
    for w in PLACES:
        yield assume(Ne(sp.expand(path).subs(v, exp(w)).subs(t, place), 0, evaluate=False))


def entered(polynomial, change, over=OVER):
    return none_enters(assume(stable(polynomial)), change, over, *shown(polynomial, change))


def test_what_it_says():
    with pytest.raises(NotShown, match="a hypothesis is about"):
        entered(z**2 - c, c * v)  # what is assumed knows the share
    border = [Relation(S.Zero, "<", q), Relation(q, "<=", S.One)]
    within = [*border, Relation(S.Zero, "<", t), Relation(t, "<=", pi / 2)]
    path = [((z - c).subs(z, v**2) + q * S(3)).subs(v, exp(w)) for w in PLACES]
    with pytest.raises(NotShown, match="a hypothesis is about"):
        none_enters(assume(stable(z - c)), S(3), OVER, *(assume(Ne(p, 0)) for p in path))
    assert len(within) == 4


def nonzero(value, *given):
    """A theorem that value != 0 under what is given: what the kernel would make of a proof."""
    return assume(proposition(Ne(value, 0, evaluate=False))), given



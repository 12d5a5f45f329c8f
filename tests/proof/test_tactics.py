"""Tactics that take several steps at once: under the hypotheses that are needed, and no others."""

import pytest
import sympy as sp
from sympy import Eq, Ne

from symhaptic.notation.proposition import proposition
from symhaptic.proof.theorems.kernel import NotShown, add_assum, assume
from symhaptic.proof.theorems.tactics import by_contradiction, by_multiple, positive

x, y, z = sp.symbols("x y w")  # the letter z stands for a complex number


@pytest.mark.parametrize(
    ("wanted", "otherwise"),
    [(x < y, x >= y), (x <= y, x > y), (Eq(x, y), Ne(x, y)), (Ne(x, y), Eq(x, y))],
)
def test_by_contradiction_the_negation_is_no_hypothesis_any_more(wanted, otherwise):
    one = add_assum(assume(z < 0), otherwise)
    found = by_contradiction(wanted, one, assume(z >= 0))
    assert found.conclusion == proposition(wanted)
    assert found.hypotheses == {proposition(z < 0), proposition(z >= 0)}


def test_by_contradiction_two_theorems_that_agree_show_nothing():
    with pytest.raises(NotShown):
        by_contradiction(x < y, assume(z < 0), assume(z <= 0))


@pytest.mark.parametrize("claim", [y > z, y >= z])
def test_a_relation_follows_from_a_positive_multiple(claim):
    strict = proposition(claim).sign == "<"
    known = x * y > x * z if strict else x * y >= x * z
    found = by_multiple(claim, assume(x > 0), [known])
    assert found.conclusion == proposition(claim)
    assert found.hypotheses == {proposition(x > 0), proposition(known)}


@pytest.mark.parametrize("weight", [x >= 0, x < 0, Ne(x, 0)])
def test_a_multiple_by_what_need_not_be_positive_shows_nothing(weight):
    with pytest.raises(NotShown):
        by_multiple(y > z, assume(weight), [x * y > x * z])


def test_an_equation_takes_an_expression_as_its_multiplier():
    found = positive(x > y, [z > 0], [Eq(x, y + z), -1])
    assert found.hypotheses == {proposition(z > 0), proposition(Eq(x, y + z))}
    found = positive(x * z > y * z, [z > 0], [Eq(x, y + 1), -z])
    assert found.hypotheses == {proposition(z > 0), proposition(Eq(x, y + 1))}
    with pytest.raises(NotShown):
        positive(x * z > 0, [z > 0, x])

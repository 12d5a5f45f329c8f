"""Mutants change one thing each, are many, and those that are still right do not count."""

import pytest
import sympy as sp
from sympy import Abs, Eq, Rational, cos, re, sin

from symhaptic.proof.decide import compare
from symhaptic.proof.mutants import mutants, wrong

x, y, d, K, B, c_2, c_3 = sp.symbols("x y d K B c_2 c_3")


def forms(*printed):
    return [m.form for m in mutants(printed)]


@pytest.mark.parametrize(
    ("printed", "mutant"),
    [
        (x + y, x - y),  # sign
        (x + y, y),  # dropped term
        (x * y, x),  # dropped factor
        (x * y, x / y),  # inverted factor
        (x * y, 2 * x * y),  # a number
        (sin(x), cos(x)),  # function
        (Abs(B), B),
        (sin(d * x), sin((d + 1) * x)),  # index
        (c_2 * y, c_3 * y),
        (K * y, B * y),  # symbol
        (x**2, x**3),  # exponent
        (Rational(1, 2) * x, Rational(3, 2) * x),  # number
        (re(x * sp.Function("H")(y), evaluate=False), sp.im(x * sp.Function("H")(y))),
    ],
)
def test_each_kind_of_change_is_made(printed, mutant):
    assert (mutant,) in forms(printed)


def test_relations_are_turned_and_their_strictness_changed():
    found = forms(x < y)
    assert (x > y,) in found
    assert (x <= y,) in found
    assert (x < -y,) in found
    assert (x <= y,) in forms(x >= y)
    assert (x > y,) in forms(x >= y)


def test_left_side_of_a_definition_is_kept():
    assert all(m[0].lhs == x for m in forms(Eq(x, 2 * y + 1)))


def test_one_component_changes_or_two_exchange_their_right_sides():
    printed = (Eq(x, y), Eq(K, B + 1))
    for form in forms(*printed):
        changed = sum(one != other for one, other in zip(form, printed, strict=True))
        exchanged = {part.rhs for part in form} == {part.rhs for part in printed}
        assert changed == 1 or (changed == 2 and exchanged)


def test_no_duplicates_and_never_the_original():
    printed = (Eq(x, (y + 1) * sin(d * y) - 2 * y**2),)
    found = forms(*printed)
    assert len(found) == len(set(found))
    assert printed not in found


def test_equivalent_mutants_do_not_count():
    # the cosine of the negated angle is the same cosine
    printed = (x < cos(y),)
    kept = [m.form for m in wrong(printed)]
    assert (x < cos(-y),) not in kept
    assert all(not compare(printed, form).equal for form in kept)


def test_change_is_described():
    assert all(m.change for m in mutants((x < sin(d * y) + 2 * K,)))

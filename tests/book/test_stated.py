"""A theorem in rows: each of its relations is there once and in order, and brackets close."""

import re

import pytest
from sympy import symbols

from symhaptic.book.report.breaking import LINE, width
from symhaptic.book.report.stated import stated
from symhaptic.notation.proposition import And, Iff, Or, Relation
from symhaptic.proof.theorems.kernel import assume

A, B, C, D, E = symbols("a b c d e")
LONG = Relation(sum(symbols("x_10:21")), "<=", C)
SHORT, OTHER = Relation(A, "<", B), Relation(D, "<", E)


@pytest.mark.parametrize(
    "claim",
    [
        Iff((And((SHORT, OTHER)), LONG)),
        Iff((LONG, Or((SHORT, OTHER)))),
        Iff((And((LONG, SHORT)), OTHER)),
        Or((And((SHORT, LONG)), OTHER)),
        Or((LONG, And((OTHER, SHORT)))),
    ],
)
def test_a_long_theorem_says_each_relation_in_order_and_closes_its_brackets(claim):
    rows = stated(assume(claim)).then
    assert len(rows) > 1
    assert all(width(row) <= LINE + 3 for row in rows)
    assert all(row.count(r"\left") == row.count(r"\right") for row in rows)
    brackets = re.findall(r"\\Big([lr])", "".join(rows))
    assert brackets == ["l", "r"] * (len(brackets) // 2)
    words = re.sub(r"\\text\{\w+\}|\\[A-Za-z]+", " ", " ".join(rows))
    said = re.findall(r"[a-e]|x_\{\d\d\}", words)
    assert said == [letter for relation in relations(claim) for letter in letters(relation)]


def relations(claim):
    return [claim] if isinstance(claim, Relation) else [r for p in claim.of for r in relations(p)]


def letters(relation):
    sides = (sorted(map(str, side.free_symbols)) for side in (relation.left, relation.right))
    return [re.sub(r"_(\d+)", r"_{\1}", name) for side in sides for name in side]

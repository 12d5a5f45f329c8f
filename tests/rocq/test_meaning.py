"""A text that says something else to Rocq than to our kernel is found out."""

import pytest
from sympy import Eq, I, Rational, S, cos, exp, im, log, pi, re, sqrt, symbols

from symhaptic.notation import X, d, z
from symhaptic.notation.proposition import ForAll, Implies, Predicate, Relation, proposition, whole
from symhaptic.rocq import meaning
from symhaptic.rocq.meaning import differs
from symhaptic.rocq.reading import Misread, read
from symhaptic.rocq.terms import Names, NotPrinted, complex_, real_text

x, y = symbols("x y")
NEGATIVE = 1 - sqrt(2)


def stable(polynomial):
    return Predicate("stable", (z,), (polynomial,))


RIGHT = [
    proposition(x / y < 1),
    proposition(Eq(x, sqrt(y))),
    Relation(exp(I * x), "!=", S.Zero),
    Relation(X, "=", z ** (d + 1)),
    stable(z**2 - x * z + sqrt(2)),
    stable(z - sqrt(NEGATIVE)),
    stable(z - exp(sqrt(-4 * sqrt(2) + 4) / 2)),
    Predicate("stable_substituted", (), (x, S.Zero, pi**2, 1 / y, d)),
    Predicate("limit", (x,), (x / (x - y), y + 1, y + 1)),
    Predicate("increasing", (x,), (1 / x, S.One, S(2))),
    ForAll((x,), Implies((proposition(x > 0), stable(z - 1 / x)))),
]


@pytest.mark.parametrize("claim", RIGHT)
def test_what_is_printed_says_the_same(claim):
    assert differs([claim]) is None


WRONG = [
    # each text is wrong in one place
    (proposition(x / y < 1), "(y <> 0 /\\ x/y < 2)"),
    (proposition(x / y < 1), "(y <> 0 /\\ y/x < 1)"),
    (proposition(1 / (1 + 1 / x) < 1), "1/(1 + 1/x) <= 2"),
    (Relation(x, "!=", S.Zero), "x = 0"),
    (proposition(x < 3), "x < 3 - x^2"),
    (proposition(x**2 >= 0), "0 < x"),
    (proposition(cos(sqrt(y)) > 1), "(0 <= y /\\ 1 < cos(sqrt(y)))"),  # cos(i) = cosh(1) > 1
    (Relation(x, "!=", sqrt(y)), "(0 <= y /\\ x <> sqrt(y))"),  # x <> i
    (stable(z - sqrt(NEGATIVE)), "(stable (fun z : C => z - sqrt(1 - sqrt(2)))%C)"),
    (
        stable(z - sqrt(NEGATIVE)),
        "(0 <= 1 - sqrt(2) /\\ stable (fun z : C => z - sqrt(1 - sqrt(2)))%C)",
    ),
    (stable(z - sqrt(x)), "(0 <= x /\\ stable (fun z : C => z - sqrt(x))%C)"),
    (stable(z - sqrt(x)), "(stable (fun z : C => z - sqrt(x))%C)"),
    (stable(z - log(cos(S(2)))), "(stable (fun z : C => z - ln(cos(2)))%C)"),
    (stable(z**2 - x), "(stable (fun z : C => z^3 - x)%C)"),
    (stable(z**2 - x), "(stable (fun z : C => z^2 - x)%C (x)%C)"),
    (stable(z ** (d + 1)), "(stable (fun z : C => Craised (z) (d))%C)"),
    (Predicate("limit", (x,), (sqrt(x - 2), S.Zero, sqrt(2) * I)),
     "Ctends (fun x : R => sqrt(x - 2)) (0) (sqrt(2)*Ci)%C"),
    (Predicate("stable_loop", (), (x, y, S.Zero, S.Zero, d)), "(stable_loop (y) (x) (0) (0) (d))"),
    (whole(d + 1), "whole (d)"),
    (stable(z - exp(I * x)), "(stable (fun z : C => z - exp(Ci*x))%C)"),  # Rocq's exp is real
]  # fmt: skip


@pytest.mark.parametrize(("claim", "said"), WRONG)
def test_a_text_that_says_something_else_is_refused(claim, said, monkeypatch):
    monkeypatch.setattr(meaning, "text", lambda claim, names: said)
    assert differs([claim]) is not None


def test_only_points_count_where_what_is_given_holds(monkeypatch):
    said = "(stable (fun z : C => z - sqrt(x))%C)"
    monkeypatch.setattr(meaning, "text", lambda claim, names: said)
    assert differs([stable(z - sqrt(x))], [proposition(x >= 0)]) is None
    assert differs([stable(z - sqrt(x))], [proposition(x >= -3)]) is not None


@pytest.mark.parametrize(
    ("term", "value"),
    # what Rocq computes there: / 0 = 0, sqrt (-4) = 0, ln (-1) = 0, -x^2 = -(x^2)
    [("1/(x - x)", 0), ("sqrt(-4)", 0), ("ln(-1)", 0), ("-x^2", -4), ("-x^2/4*3", -3),
     ("Craised (0) (0)", 1), ("Craised (0) (x)", 0), ("cot(0)", 0), ("Rpower (4) (1/2)", 2)],
)  # fmt: skip
def test_a_term_is_read_as_rocq_computes_it(term, value):
    from flint import acb

    [found] = read(f"{term} < 1")
    assert abs(found.left({"x": acb(2)}) - value) < 1e-12


@pytest.mark.parametrize(
    "said", ["", "x", "x < ", "x < y)", "(x < y", "f(x) < 1", "x ? y", "x < y < 1"]
)
def test_what_is_no_relation_is_not_read(said):
    with pytest.raises(Misread):
        read(said)


def test_a_real_number_has_no_imaginary_part():
    names = Names()
    with names.bound(x := symbols("x")):
        assert real_text(exp(3 * im(x)) * cos(re(x)), names) == "cos(x)"


def test_a_root_of_a_negative_number_is_imaginary_and_its_logarithm_is_refused():
    assert complex_(sqrt(NEGATIVE))
    with pytest.raises(NotPrinted):
        real_text(log(cos(S(2)), evaluate=False), Names())
    fourth = S(-3) ** Rational(1, 4)
    with pytest.raises(NotPrinted):
        real_text(fourth, Names())

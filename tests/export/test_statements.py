"""Blocks in languages with braces: short, and nothing is computed that a condition rules out."""

import pytest
import sympy as sp
from sympy import sin, sqrt

from symhaptic.export.branches import Assign, Choice, Join, Return, Set
from symhaptic.export.statements import braces
from symhaptic.export.targets import TARGETS

x, y, a, b, c = sp.symbols("x y a b c")
ENDS = ["return {0};"]


def written(language, *block):
    target = TARGETS[language]
    declare = {"c": "const double", "cpp": "const double", "rust": "let"}.get(language, "const")
    return [line.strip() for line in braces(target, block, ENDS, declare)]


def test_declarations_share_a_line_where_the_language_has_that():
    block = Assign(a, x + 1), Assign(b, a * x), Return((b,))
    assert written("c", *block) == ["const double a = x + 1.0, b = a*x;", "return b;"]
    assert written("javascript", *block)[0] == "const a = x + 1.0, b = a*x;"
    assert written("rust", *block)[:2] == ["let a = x + 1.0_f64;", "let b = a*x;"]


def test_no_line_of_them_is_long():
    names = sp.symbols("some_name:40")
    lines = written("c", *(Assign(n, sin(x) + k) for k, n in enumerate(names)))
    assert max(map(len, lines)) <= 96  # and four for the indent
    assert sum(line.count("some_name") for line in lines) == 40


def test_a_choice_without_work_is_a_value():
    inner = Join((), x < 1, (Set(a, y),), (Set(a, sp.S(2)),))
    lines = written("c", Join((a,), x < 0, (Set(a, x),), (inner,)), Return((a,)))
    assert lines[0] == "const double a = x < 0.0 ? x : (x < 1.0 ? y : 2.0);"


def test_a_choice_with_work_has_its_branches():
    """Each does its own steps alone; what is chosen in the last stands beside the others."""
    inner = Join((), x < 1, (Assign(b, sin(x)), Set(a, b * b)), (Set(a, sqrt(y)),))
    work = (Assign(c, sin(y)), Set(a, c * c))
    lines = written("c", Join((a,), x < 0, work, (inner,)), Return((a,)))
    assert lines == [
        "double a;",
        "if (x < 0.0) {", "const double c = sin(y);", "a = c*c;",
        "} else if (x < 1.0) {", "const double b = sin(x);", "a = b*b;",
        "} else {", "a = sqrt(y);", "}",
        "return a;",
    ]  # fmt: skip


def test_two_names_are_not_asked_for_twice():
    both = Join((a, b), x < 0, (Set(a, x), Set(b, y)), (Set(a, y), Set(b, x)))
    lines = written("c", both, Return((a + b,)))
    assert sum("x < 0.0" in line for line in lines) == 1
    assert lines[0] == "double a, b;"


@pytest.mark.parametrize("language", ["c", "cpp", "javascript"])
def test_a_short_return_stands_beside_its_condition(language):
    """And of two short ones one expression is made, but of NaN, whose type in C is another."""
    lines = written(language, Choice(x < 0, (Return((y,)),), (Return((x,)),)))
    assert lines == ["return (x < 0.0 ? y : x);"]
    long = sp.Symbol("a_name_that_takes_more_than_half_of_a_short_line")
    lines = written(language, Choice(x < 0, (Return((y,)),), (Return((long,)),)))
    assert lines == ["if (x < 0.0) { return y; }", f"return {long};"]
    lines = written(language, Choice(x < 0, (Return((y,)),), (Return((sp.nan,)),)))
    assert lines[0] == "if (x < 0.0) { return y; }"


@pytest.mark.parametrize("language", ["c", "cpp", "javascript", "rust"])
def test_an_end_that_follows_anyway_is_not_written_inside(language):
    inner = Choice(y < 0, (Assign(b, x * x + y), Return((b * b,))), (Return((x,)),))
    lines = written(language, Choice(x < 0, (inner,), (Return((x,)),)))
    assert [line for line in lines if "return x" in line] == lines[-1:]
    other = Choice(y < 0, (Return((b * b,)),), (Return((y,)),))
    lines = written(language, Choice(x < 0, (other,), (Return((x,)),)))
    assert any("return y" in line or "y : x" in line or ": y" in line for line in lines)


@pytest.mark.parametrize("language", ["c", "cpp", "javascript", "rust"])
def test_a_number_that_another_side_changes_stands_first(language):
    """A name whose other side is computed keeps both sides."""
    square = Assign(b, x * x + y)
    for value, both in ((sp.S.Zero, False), (x * y, True)):
        join = Join((a,), x < 0, (square, Set(a, b * b)), (Set(a, value),))
        text = " ".join(written(language, join, Return((a,))))
        assert ("else" in text) is both
        assert ("a = 0.0" in text) is not both


def test_what_sets_something_else_is_no_value():
    """A step before, in either branch, keeps them."""
    for sides in (
        ((Assign(b, x), Set(a, b)), (Set(a, y),)),
        ((Set(a, y),), (Assign(b, x), Set(a, b))),
    ):
        lines = written("c", Join((a,), x < 0, *sides), Return((a,)))
        assert not any("?" in line for line in lines)


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (y - x, "y - x"),
        (-x - y, "-x - y"),
        (x * x - 2 * y, "x*x - 2.0*y"),
        ((x + y) ** 2 * x, "x*((x + y)*(x + y))"),
        (sp.sin(x * x), "sin(x*x)"),
    ],
)
def test_a_term_without_a_minus_is_first_and_brackets_are_where_they_are_needed(expr, text):
    assert TARGETS["c"].printing().whole(expr) == text

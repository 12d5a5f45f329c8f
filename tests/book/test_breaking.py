"""Long formulas are broken within the line, and lose nothing on the way."""

import re

import pytest
from matplotlib import rc_context
from matplotlib.font_manager import FontProperties
from matplotlib.mathtext import MathTextParser
from sympy import Symbol, cos, sin, symbols

from symhaptic.book.report.breaking import (
    LINE,
    broken,
    in_margin,
    narrow,
    pieces,
    rows_of,
    stack,
    width,
)
from symhaptic.notation import B, K, T, d, theta
from symhaptic.notation.latex import latex

LONG = K * T * (cos(d * theta) - cos((d + 1) * theta)) + B * (
    cos(d * theta) - 2 * cos((d + 1) * theta) + cos((d + 2) * theta)
)


def test_a_short_formula_stays_whole():
    assert pieces(K * T, 20) == [latex(K * T)]


@pytest.mark.parametrize("limit", [12, 16, 24])
def test_each_piece_fits(limit):
    for piece in pieces(LONG, limit):
        assert width(piece) <= limit + 1.5  # one sign and a bracket may hang over


def test_the_pieces_together_are_the_formula():
    terms = sum(symbols("x_1:30"), Symbol("x_0"))
    joined = "".join(pieces(terms, 10))
    assert joined == latex(terms)


def test_every_line_but_the_first_starts_with_a_sign():
    for piece in pieces(sum(symbols("x_1:30")), 10)[1:]:
        assert piece[0] in "+-"


def test_the_print_is_split_at_its_marks():
    assert broken(r"a \br + b") == ["a ", "+ b"]
    (stacked,) = broken(r"\frac{a \br + b}{c}")
    assert r"\begin{gathered}a \\ + b\end{gathered}" in stacked


@pytest.mark.parametrize(
    "tex",
    [
        r"\dfrac{a}{b}",
        r"\dfrac{aaaa + b}{b} - \dfrac{a}{bbbb}",
        r"\cos(d\theta) - 2\cos((d+1)\theta)",
        r"\sqrt{x + y}",
        r"x_{1}+x_{2}+x_{3}",
        r"\left(m + M\right)\omega^{2}",
        r"a \leq b",
        "N,N,N",
    ],
)
def test_widths_are_those_of_computer_modern(tex):
    assert width(tex) == pytest.approx(computer_modern(tex), rel=0.12, abs=0.25)


def computer_modern(tex):
    """Matplotlib sets the same formulas with the metrics of the same fonts, here in 10 points."""
    with rc_context({"mathtext.fontset": "cm"}):
        return MathTextParser("path").parse(f"${tex}$", 72, FontProperties(size=10))[0] / 10


def test_widths_of_names_and_signs_are_those_of_computer_modern():
    names = ("sin", "cos", "tan", "cot", "sinh", "cosh", "lim", "max")
    signs = ("leq", "geq", "in", "to", "cdot", "infty", "partial")
    for command in (*names, *signs, "quad", "qquad", ",", ";", "!"):
        tex = rf"a\{command} b"
        assert width(tex) == pytest.approx(computer_modern(tex), rel=0.12, abs=0.15), tex


def test_a_fraction_with_a_wide_divisor_stacks_its_numerator():
    wide = LONG / (3 + sin(d * theta) - sin((d + 1) * theta) + sin((d + 2) * theta))
    (piece,) = pieces(wide, 22)
    assert "gathered" in piece


def test_a_narrow_screen_parts_no_group_and_loses_nothing():
    above, below, more = ("+".join(3 * one for one in part) for part in ("abcdefgh", "ijk", "lmn"))
    tex = rf"\frac{{{above}}}{{{below}}}+{more},{above}"
    (word,) = narrow(tex)
    assert [piece.startswith("{}+") for piece in word].count(True) >= 1
    assert narrow(25 * "a" + "," + 25 * "b") == [[25 * "a" + ",", 25 * "b"]]
    assert all(piece.count("{") == piece.count("}") for piece in word)
    assert "".join(piece.removeprefix("{}") for piece in word) == tex


def tokens(tex):
    """What is read of LaTeX: without alignment, space, and how large a bracket is."""
    tex = re.sub(r"\\(?:left|right|[bB]ig[lr]|q?quad)(?![a-z])|&|\s", "", tex)
    return re.findall(r"\\[A-Za-z]+|\\.|.", tex)


SUM = sum(symbols("x_10:40"))


@pytest.mark.parametrize("left", ["G", K * T, SUM, Symbol("G" * 20), 1 / sum(symbols("y_10:18"))])
@pytest.mark.parametrize("right", [B, LONG, SUM, sum(symbols("z_10:18"))])
def test_an_equation_of_several_rows_has_each_sign_once_and_in_order(left, right):
    rows = rows_of([(left, "=", right)])
    whole = f"{left if isinstance(left, str) else latex(left)}={latex(right)}"
    assert tokens("".join(rows)) == tokens(whole)
    for row in rows:
        assert row.count("{") == row.count("}")
        assert row.count("&") == 1
        assert width(row.replace("&", "")) <= LINE + 1.5  # one sign and a bracket may hang over


def test_in_a_column_vector_outer_fractions_are_large_and_inner_ones_small():
    inner = [rf"\frac{{\frac{{{a}}}{{b}}}}{{c}}" for a in "xy"]
    shown = stack([r"\begin{pmatrix}" + r" \\ ".join(inner) + r"\end{pmatrix}"])
    for a in "xy":
        assert rf"\dfrac{{\tfrac{{{a}}}{{b}}}}{{c}}" in shown
    assert r"\frac" not in shown


@pytest.mark.parametrize("widths", [(1, 9, 2, 9), (9, 9, 1), (1, 2, 3), (9, 1, 9)])
def test_generators_that_are_left_out_are_shown_by_one_ellipsis(widths):
    """A letter d is some 0.5 em wide, and from 9 em on a generator is left out."""
    given = [
        letter * (25 if size == 9 else size) for letter, size in zip("abcd", widths, strict=False)
    ]
    shown = in_margin(rf"\mathbb{{Q}}({','.join(given)})")
    kept = shown.removeprefix(r"\mathbb{Q}(").removesuffix(")").split(r",\allowbreak ")
    assert [one for one in kept if one != r"\ldots"] == [one for one in given if len(one) < 9]
    assert kept.count(r"\ldots") == (9 in widths)
    first = widths.index(9) if 9 in widths else len(kept)
    assert kept[:first] == given[:first]

"""Long formulas are broken within the line, and lose nothing on the way."""

import pytest
from matplotlib import rc_context
from matplotlib.font_manager import FontProperties
from matplotlib.mathtext import MathTextParser
from sympy import Symbol, cos, sin, symbols

from symhaptic.book.report.breaking import broken, narrow, pieces, width
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
    """Matplotlib sets the same formulas with the metrics of the same fonts, here in 10 points."""
    with rc_context({"mathtext.fontset": "cm"}):
        points = MathTextParser("path").parse(f"${tex}$", 72, FontProperties(size=10))[0]
    assert width(tex) == pytest.approx(points / 10, rel=0.12, abs=0.25)


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

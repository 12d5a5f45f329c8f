"""Formulas are set as an engineer would write them."""

import random

import pytest
from sympy import Add, E, Integer, Mul, Pow, Rational, Symbol, cos, exp, pi, sin, sqrt

from symhaptic.book.report import latex as print_
from symhaptic.book.report.chapter import reference, referred
from symhaptic.book.report.latex import prose
from symhaptic.book.report.latex import referenced as printed
from symhaptic.book.report.tree import place_of, words
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, omega, psi, theta, z
from symhaptic.notation.latex import euler, latex
from symhaptic.paper.reading import Unreadable, read
from symhaptic.proof.decide import compare

# right-hand sides: as written by hand on paper, in the conventions of the module's docstring
BY_HAND = {
    K * T / 2: r"\frac{KT}{2}",
    b + B: "b+B",
    sin(d * theta): r"\sin d\theta",
    cos((d + 1) * theta): r"\cos(d+1)\theta",
    sin((d + 1) * omega * T): r"\sin(d+1)\omega T",
    sin(theta / 2) ** 2: r"\sin^2\tfrac{\theta}{2}",
    cos(theta + psi): r"\cos(\theta+\psi)",
    exp(-delta / 2): r"\mathrm{e}^{-\delta/2}",
    -theta: r"-\theta",
    1 - cos(theta): r"1-\cos\theta",
    z ** (d + 1): "z^{d+1}",
    z**2 - 3 * z + 1: "z^2-3z+1",
    (alpha + beta) * z - beta: r"(\alpha+\beta)z-\beta",
    sqrt(delta**2 - 4 * gamma): r"\sqrt{\delta^2-4\gamma}",
    pi / (2 * (d + 1)): r"\frac{\pi}{2(d+1)}",
    Rational(-1, 2): r"-\tfrac{1}{2}",
    K + B * (z - 1) / (T * z): r"K+\frac{B(z-1)}{Tz}",
}


@pytest.mark.parametrize("expr", BY_HAND, ids=str)
def test_written_as_by_hand(expr):
    assert latex(expr) == BY_HAND[expr]


# "cos(d+1)theta" is how a page is written; the paper itself, and so the reader, uses brackets
BRACKETED = {cos((d + 1) * theta), sin((d + 1) * omega * T)}


@pytest.mark.parametrize("expr", [e for e in BY_HAND if e not in BRACKETED], ids=str)
def test_what_is_written_reads_back_as_the_same(expr):
    (back,) = read(latex(expr).replace(r"\tfrac", r"\frac"))
    assert compare(back, expr).equal


def test_in_a_line_the_half_of_an_angle_is_not_the_half_of_its_sine():
    assert latex(sin(theta / 2), inline=True) == r"\sin(\theta/2)"
    assert latex(sin(theta) / 2, inline=True) == r"(\sin\theta)/2"
    assert latex(T * sin((d + 1) * theta) / 2, inline=True) == r"(T\sin(d+1)\theta)/2"
    assert latex(2 * T * (1 - sin(theta)) / d, inline=True) == r"2T(1-\sin\theta)/d"


def test_a_slash_divides_by_all_that_stands_behind_it():
    other = Symbol("m'")
    assert latex(theta / other, inline=True) == r"\theta/m'"
    assert latex(theta / (T**2 * other), inline=True) == r"\theta/(T^2m')"


def test_the_power_of_a_sum_of_numbers_is_that_of_the_sum():
    assert latex((1 - exp(Rational(-1, 50))) ** 2, inline=True) == r"(1-\mathrm{e}^{-1/50})^{2}"


def test_a_power_of_e_that_is_kept_as_one_is_an_exponential():
    """SymPy takes it for one, whose argument is then e."""
    assert latex(Pow(E, -delta / 2, evaluate=False)) == r"\mathrm{e}^{-\delta/2}"


def test_a_product_is_not_printed_as_a_difference_or_a_mixed_number():
    """What nobody has evaluated: K times -B was K - B, 2 times 3/4 was 2 3/4."""
    assert latex(Mul(K, -B, evaluate=False)) == "K(-B)"
    assert latex(Mul(2, Rational(3, 4), evaluate=False)) == r"2 \cdot \tfrac{3}{4}"
    assert latex(Mul(K, Rational(3, 4), evaluate=False), inline=True) == "(3/4)K"
    left = Mul(K, sin(theta), evaluate=False)
    assert latex(Mul(left, exp(theta), evaluate=False)) == r"(K\sin\theta)\mathrm{e}^{\theta}"
    assert latex(sin(theta) ** 12) == r"\sin^{12}\theta"


def test_a_prime_stands_behind_the_letter():
    assert latex(Symbol("delta'")) == r"\delta'"
    assert latex(Symbol("n_1''")) == "n_1''"
    assert latex(Symbol("K'")) == "K'"


def test_a_function_is_of_all_that_its_bracket_begins():
    """The sine of a square was printed as the square of a sine, and that of a product as one."""
    assert latex(sin((theta + psi) ** 2)) == r"\sin\bigl((\theta+\psi)^{2}\bigr)"
    assert latex(sin((theta + psi) ** d), inline=True) == r"\sin\bigl((\theta+\psi)^{d}\bigr)"
    assert latex(cos((d + 1) * (theta + psi))) == r"\cos\bigl((d+1)(\theta+\psi)\bigr)"
    assert latex(sin(theta * cos(psi))) == r"\sin\bigl(\theta\cos\psi\bigr)"
    assert latex(cos((K + 1) ** 2 * theta)) == r"\cos\bigl((K+1)^{2}\theta\bigr)"


@pytest.mark.parametrize(
    ("id", "shown", "place"),
    [
        ("eq11", "(11)", "eq11"),
        ("tab2", "Table II", "tab2"),
        ("rules:four", r"\texttt{\scriptsize rules:\allowbreak four}", "rules.3a.four"),
        ("tablet", r"\texttt{\scriptsize tablet}", "tablet"),
        ("equal_masses", r"\texttt{\scriptsize equal\_masses}", "equal.5f.masses"),
        (
            "my:5%&#{^~",
            r"\texttt{\scriptsize my:\allowbreak 5\%\&\#\{\^{}\textasciitilde{}}",
            "my.3a.5.25..26..23..7b..5e..7e.",
        ),
        ("a\\b-c", r"\texttt{\scriptsize a\textbackslash{}b-\allowbreak c}", "a.5c.b-c"),
    ],
)
def test_any_id_can_be_printed_and_linked(id, shown, place):
    assert (printed(reference(id)), place_of("statement", id)) == (shown, place)


def test_no_two_ids_have_one_place():
    # a label of the site has no capitals
    ids = ["my:a_b", "my:a-b", "my:a.b", "my:K", "my:k", "my:ä", "my:ö", "my:a__b", "my:a--b"]
    ids += ["my-a_b", "my-k"]
    assert len({place_of("statement", id).lower() for id in ids}) == len(ids)


def test_a_note_has_words_beside_formulas():
    assert prose(r"5 % of $a_b$, 30\,\%") == r"5 \% of $a_b$, 30\,\%"
    assert prose(r"x^2 of $x^2$ at 3 $") == r"x\^{}2 of $x^2$ at 3 \$"
    assert prose("a { or \\emph{b}") == r"a \{ or \emph{b}"
    assert prose(r"5 $x_{1$ of } $x_{1}$") == r"5 \$x\_\{1\$ of \} $x_{1}$"
    assert prose(r"\emph{5 % {x}} -- \texttt{a_b-c} {") == (
        r"\emph{5 \% \{x\}} -{}- \texttt{a\_b-\allowbreak{}c} \{"
    )
    assert print_.inline(referred("a<b")) == (r"\statementlink{a.3c.b}{\texttt{\scriptsize a<b}}")


def some(dice, depth):
    """A random formula, some of it not evaluated."""
    if depth == 0:
        return dice.choice([K, T, theta, d, Integer(2), Rational(3, 4), Integer(-1), pi])
    one, other = (some(dice, dice.randrange(depth)) for _ in range(2))
    kept = {"evaluate": dice.random() < 0.5}
    return dice.choice(
        [
            lambda: Add(one, other, **kept),
            lambda: Mul(one, other, **kept),
            lambda: Mul(one, other, **kept),
            lambda: Pow(one, dice.choice([Integer(2), Integer(-1), Rational(1, 2)]), **kept),
            lambda: dice.choice([sin, cos, exp])(one),
        ]
    )()


def test_what_is_written_is_read_as_the_same_or_not_at_all():
    told = 0
    for seed in range(250):
        formula = some(random.Random(seed), 4)
        for inline in (False, True):
            text = latex(formula, inline).replace(r"\bigl", "").replace(r"\bigr", "")
            try:
                (back,) = read(text)
            except Unreadable:  # it may be read in two ways, or divides by 0
                continue
            assert back == formula or compare(back, formula).equal is not False, text
            told += 1
    assert told > 400


def test_eulers_number_is_not_the_determinant():
    """e is the determinant of a sampled device, an italic letter; Euler's number is upright."""
    e = Symbol("e")
    assert latex(exp(theta) + e) == r"e+\mathrm{e}^{\theta}"
    assert latex(E) == r"\mathrm{e}"
    assert euler(r"A(e^{j\theta})+e") == r"A(\mathrm{e}^{j\theta})+e"
    [emphasis] = words(r"\emph{only $e^{-1}$ counts.}")
    assert emphasis.astext() == r"only \mathrm{e}^{-1} counts."

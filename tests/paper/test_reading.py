"""The LaTeX reader says what the paper prints, and refuses what is no formula."""

import random

import mpmath
import pytest
import sympy as sp
from sympy import Abs, Eq, I, Rational, cos, exp, pi, re, sin, sqrt

from symhaptic.notation.proposition import proposition
from symhaptic.paper import STATEMENTS
from symhaptic.paper.reading import Unreadable, read
from symhaptic.proof.theorems.definedness import conditions

K, B, T, b, d, m, k, s, z, y = sp.symbols("K B T b d m k s z y")
omega, omega_hat, alpha, beta, gamma, delta = sp.symbols("omega omega_hat alpha beta gamma delta")
c_1, c_2, c_3, t_d, second = sp.symbols("c_1 c_2 c_3 t_d second")
m_D, m_H, b_D, b_H, k_H, T_s = sp.symbols("m_D m_H b_D b_H k_H T_s")
H, n, p = sp.Function("H"), sp.Function("n"), sp.Function("p")
wT = omega * T
DIGITS = 30


def fractions_of_envelope(angle):
    """The two fractions printed in (7) and again in (27)."""
    below = sin(2 * (d + 1) * angle) - 2 * (1 + d) * sin(angle)
    return (
        (sin((d + 2) * angle) - 2 * sin((d + 1) * angle) + sin(d * angle)) / below,
        (d * sin((d + 1) * angle) - (1 + d) * sin(d * angle)) / below,
    )


ON_7, ON_27 = fractions_of_envelope(wT), fractions_of_envelope(omega_hat)
PLANT = 1 / (m * s**2 + b * s + k)
HALF = Rational(1, 2)

# Typed from the paper, independently of the package's LaTeX: id, sign, (left, right), ...
BY_HAND = {
    "eq1": ("==", (H(z), K + B * (z - 1) / (T * z))),
    "eq2": ("==", (m, m_D + m_H), (b, b_D + b_H), (k, k_H)),
    "eq5": (
        ">",
        (
            b,
            (
                (cos(d * wT) - cos((d + 1) * wT)) * K * T
                + (cos(d * wT) - 2 * cos((d + 1) * wT) + cos((d + 2) * wT)) * B
            )
            / (2 - 2 * cos(wT)),
        ),
    ),
    "eq6": (">", (b, K * T / 2 + Abs(B))),
    "eq7": ("==", (K, 2 * b * (d + 1) / T * ON_7[0]), (B, 2 * b * ON_7[1])),
    "eq8": (
        "==",
        (K, b / T * 6 * (d + 1) / ((2 * d + 1) * (2 * d + 3)) * y + 0),
        (B, b * (d / (2 * d + 3) + 1) * y - b),
    ),
    "eq9": ("<", (K, (b + B) / ((HALF + d) * T))),
    "eq11": (
        "==",
        (K, b * 2 / T * (1 - cos(pi / (d + 1) / 2)) / cos(pi * d / (d + 1) / 2)),
        (B, b * (sin(pi * d / (d + 1) / 2) - d / (d + 1)) / sin(pi / (d + 1) / 2)),
    ),
    "eq12": (
        "==",
        (
            PLANT,
            (
                ((c_2 + c_3 - 2) * z + (c_2 + c_3 - 2 * exp(-b * T / m))) * (b**2 - 4 * k * m)
                + b * c_1 * (c_3 - c_2) * (z - 1)
            )
            / (2 * k * (z**2 - (c_2 + c_3) * z + exp(-b * T / m)) * (4 * k * m - b**2)),
        ),
    ),
    "eq13": (
        "==",
        (c_1, sqrt((b * T / m) ** 2 - 4 * k * T**2 / m)),
        (c_2, exp(-(b * T / m + c_1) / 2)),
        (c_3, exp(-(b * T / m - c_1) / 2)),
    ),
    "eq14": (
        "==",
        (
            PLANT,
            T**2
            / (2 * m)
            * (
                ((2 - c_2 - c_3) * c_1 + (c_2 - c_3) * delta) * z
                + (2 * exp(-delta) - c_3 - c_2) * c_1
                + (c_3 - c_2) * delta
            )
            / (c_1 * gamma * (z**2 - (c_2 + c_3) * z + exp(-delta))),
        ),
    ),
    "eq15": (
        "==",
        (c_1, sqrt(delta**2 - 4 * gamma)),
        (c_2, exp(-(delta + c_1) / 2)),
        (c_3, exp(-(delta - c_1) / 2)),
    ),
    "eq17": (
        "==",
        (
            n(z),
            ((c_2 + c_3 - 2) * c_1 - (c_2 - c_3) * delta) * z
            + (c_2 + c_3 - 2 * exp(-delta)) * c_1
            + (c_2 - c_3) * delta,
        ),
    ),
    "eq18": (
        "==",
        (
            p(z),
            ((c_3 + c_2 - 2) * c_1 + (c_3 - c_2) * delta) * (alpha + beta) * z**2
            + (
                ((c_3 + c_2 - 2 * exp(-delta)) * c_1 + (c_2 - c_3) * delta) * alpha
                + 2 * ((1 - exp(-delta)) * c_1 + (c_2 - c_3) * delta) * beta
            )
            * z
            - 2 * (z**2 - z * (c_3 + c_2) + exp(-delta)) * c_1 * gamma * z ** (1 + d)
            + ((2 * exp(-delta) - c_3 - c_2) * c_1 + (c_3 - c_2) * delta) * beta,
        ),
    ),
    "eq19": (
        "==",
        (gamma, T**2 * k_H / (m_D + m_H)),
        (delta, T * (b_D + b_H) / (m_D + m_H)),
    ),
    "eq24": ("<", (K, (b + B) / (t_d + T / 2))),
    "eq25": (">", (beta + delta, alpha * (HALF + d))),
    "eq27": ("==", (alpha, delta * 2 * (d + 1) * ON_27[0]), (beta, delta * 2 * ON_27[1])),
    "eq28": ("==", (omega, sqrt(k / m - b**2 / (4 * m**2)))),
    "eq29": ("==", (omega, sqrt(gamma - delta**2 / 4) / T)),
    "eq30": ("<=", (gamma - delta**2 / 4, pi**2)),
    "s3c-bmax-frequency": ("==", (omega, pi / (T * (d + 1)))),
    "s3c-kmax-frequency": ("==", (omega, pi / (2 * T * (d + 1)))),
    "s4a-delay-equivalent": ("==", (exp(-d * T_s), z**-d)),
}


def number(expr, values):
    opaque = {f: sp.Symbol(f.func.__name__) for f in expr.atoms(sp.core.function.AppliedUndef)}
    symbols = [*values, *opaque.values()]
    at = [*values.values(), *(mpmath.mpf(7) for _ in opaque)]
    return sp.lambdify(symbols, expr.xreplace(opaque), "mpmath")(*at)


@pytest.mark.parametrize("id", BY_HAND)
def test_print_is_read_as_typed_by_hand(id):
    sign, *pairs = BY_HAND[id]
    relations = STATEMENTS[id].printed[: len(pairs)]
    assert len(relations) == len(pairs)
    for relation, (left, right) in zip(relations, pairs, strict=True):
        assert relation.rel_op == sign
        assert relation.free_symbols == left.free_symbols | right.free_symbols
        draw = random.Random(id)
        for _ in range(4):
            names = sorted(relation.free_symbols, key=str)
            # ten guard digits against cancellation in the sums of sines and cosines
            with mpmath.workdps(DIGITS + 10):
                values = {v: mpmath.mpf(draw.randrange(1, 10**6)) / 10**6 for v in names}
                for read_side, typed in ((relation.lhs, left), (relation.rhs, right)):
                    ours, theirs = number(read_side, values), number(typed, values)
                    assert abs(ours - theirs) <= mpmath.mpf(10) ** -DIGITS * (1 + abs(theirs))


# Short forms, compared as trees.
SHORT = {
    r"b > \frac{KT}{2} + |B|": b > K * T / 2 + Abs(B),
    r"\frac{1}{2} \frac{\pi}{d+1}": pi / (d + 1) / 2,
    r"e^{-j\omega T}": exp(-I * omega * T),
    r"\alpha := KT^2 / m": Eq(alpha, K * T**2 / m),
    r"k = \pi^2 m/T^2 + b^2/4m": Eq(k, pi**2 * m / T**2 + b**2 / (4 * m)),
    r"\frac{k_H}{m_H} \leq 710 \text{ s}^{-2}": k_H / m_H <= 710 / second**2,
    r"\delta < T \cdot 15.225 \text{ s}^{-1}": delta < T * Rational(15225, 1000) / second,
    r"\gamma \leq 1 \times 10^{-3}": gamma <= Rational(1, 1000),
    r"987\,000": sp.Integer(987000),
    r"\left| \frac{K - B}{K + B} \right|": Abs((K - B) / (K + B)),
    r"-K^2": -(K**2),
    r"b \changed{\frac{m}{T}} c_1": b * m / T * c_1,
    r"K \br + B": K + B,
    r"\frac{d T}{d + 1}": d * T / (d + 1),
    r"\frac{T}{d K}": T / (d * K),
    r"T/dK + d": T / (d * K) + d,
}


@pytest.mark.parametrize(("line", "meant"), SHORT.items())
def test_short_form(line, meant):
    assert read(line) == (meant,)


# Juxtaposition binds more tightly than the slash: Sec. III-C prints \pi/T(d+1) for the angle
# pi = omega T (d+1), and (31) prints b^2/4m for the b^2/(4m) of (28).
SLASHES = {
    r"\pi/T(d+1)": pi / (T * (d + 1)),
    r"\pi/2T(d+1)": pi / (2 * T * (d + 1)),
    r"b^2/4m": b**2 / (4 * m),
    r"KT/2 + B": K * T / 2 + B,
    r"K/B/T": K / (B * T),
    r"K/B \cdot T": K * T / B,
    r"(b + B)/(t_d + T/2)": (b + B) / (t_d + T / 2),
    r"-1/2T": -1 / (2 * T),
    r"e^{-(\delta+c_1)/2}": exp(-(delta + c_1) / 2),
}


@pytest.mark.parametrize(("line", "meant"), SLASHES.items())
def test_slash_divides_by_the_whole_product(line, meant):
    assert read(line) == (meant,)


def test_chain_gives_a_relation_per_link():
    assert read(r"0 \leq \gamma < T") == (sp.Le(0, gamma), sp.Lt(gamma, T))


def test_vectors_give_a_relation_per_component():
    left = r"\begin{pmatrix} K \\ B \end{pmatrix}_{\text{lin}}"
    line = left + r" = \begin{pmatrix} 0 \\ -b \end{pmatrix}"
    assert read(line) == (Eq(K, 0), Eq(B, -b))


def test_real_part_is_kept_as_printed():
    (relation,) = STATEMENTS["eq4"].printed
    right = T / 2 / (1 - cos(wT)) * re((1 - exp(-I * wT)) * H(exp(I * wT)), evaluate=False)
    assert (relation.lhs, relation.rel_op, relation.rhs) == (b, ">", right)


JUNK = [
    "",
    "K +",
    "K ? B",
    "K'",
    "K = ",
    "K < = B",
    ")",
    "(K",
    "K))",
    "(K]",
    "|K",
    "K^",
    "K_",
    "Q",
    "e",
    "K, B",
    r"\sin",
    r"\text{words}",
    r"\Re K",
    r"\frac{K}",
    r"\frac12",
    r"\begin{pmatrix} K \\ B",
    r"K_{\text{lin}",
    "K^2^2",
    r"K \in [0, 1]",
    "1,5",
]


@pytest.mark.parametrize("line", JUNK)
def test_junk_is_unreadable(line):
    with pytest.raises(Unreadable):
        read(line)


# Each of these means something else, or nothing; reading it as a plain product changes numbers.
MISLEADING = [
    ".5 B",
    "K < .5B",
    "K . B",
    "K ; B",
    "987 000",
    "2 3",
    r"\sqrt[3]{T}",
    r"B^23",
    r"B^1.5",
    r"B^(d + 1)",
    r"B^\sin T",
    r"2\sin B 3",
    r"K = \sin^{-1} B",
    r"K = \tan^{-1}(B)",
    r"K = B \quad K > 0",
    r"\frac12 B",
    r"\frac B 2",
    r"K(T) = B",
    r"B(\gamma) = K",
    r"K_{\text{lin}}(d_1)",
    r"K^2(T) = B",
    r"K[d] = B",
    r"K(0) = B",
    r"K\left(T\right) = B",
    r"\sin K(T)",
    "K^d_1",
    r"\sin^d_1 T",
    r"x(t - t_d) = v",
    r"F = Kx[k + 1]",
    # the derivative of x by t, not x/t: d is the delay
    r"v = \frac{dx}{dt}",
    r"v = \frac{d}{dt} x",
    r"v = \frac{d(Kx)}{d\theta}",
    r"v = \frac{d^2x}{dt^2}",
    r"v = dx/dt",
    r"v = K dx/d\theta + B",
    # braces print nothing: 2K + B, sin 2B, a function v of t, (K B) beside each other
    "2{K + B}T",
    "{K + B}^2",
    r"\sin{2}B",
    r"\Re{K}B",
    "v{(t)}",
    r"v{\left(t \right)}",
    r"\frac(K + B)(T)",
    r"\begin{pmatrix} K & B \end{pmatrix}",
    r"\begin{pmatrix} K \\ B \end{pmatrix}_0 = \begin{pmatrix} T \\ b \end{pmatrix}_{b + B}",
    # as a page prints the sine of (d + 1) theta, and no one knows what is halved
    r"\sin(d+1)\theta",
    r"\cos^2(d+1)\theta",
    r"\sin\theta/2",
    r"\sin d\cdot\theta",
    r"\cos\theta\,z",
]


@pytest.mark.parametrize("line", MISLEADING)
def test_misleading_line_is_unreadable(line):
    with pytest.raises(Unreadable):
        read(line)


MISSHAPEN = [
    r"\begin{pmatrix} K \\ B \end{pmatrix} = \begin{pmatrix} 0 \end{pmatrix}",
    r"\begin{pmatrix} K \\ B \end{pmatrix} = K",
    r"K = \begin{pmatrix} K \\ B \end{pmatrix}",
    r"K + \begin{pmatrix} K \\ B \end{pmatrix}",
]


@pytest.mark.parametrize("line", MISSHAPEN)
def test_vectors_that_do_not_match_are_unreadable(line):
    with pytest.raises(Unreadable):
        read(line)


def test_what_a_source_calls_otherwise_has_that_name_alone():
    swapped = read("k = b", (("b", "k"), ("k", "b")))
    assert swapped == (sp.Eq(*sp.symbols("b k")),)
    assert read("jK", (("j", "k"),)) == (sp.prod(sp.symbols("k K")),)
    with pytest.raises(Unreadable, match=r"'b', which the source calls 'c', in 'c = b'"):
        read("c = b", (("c", "b"),))


@pytest.mark.parametrize("name", [r"\pi", "bv", r"\sin", "k_{w}x", "2", r"\text{s}"])
def test_a_source_calls_nothing_what_the_reader_takes_for_something_else(name):
    with pytest.raises(Unreadable, match="is no name"):
        read("K = B", ((name, "B"),))


def test_a_subscript_in_braces_is_the_same_subscript():
    own = (("n_{1}", "K"), ("k_w", "B"))
    assert read("n_1 n_{1} k_{w} k_w", own) == ((K * B) ** 2,)
    assert read(r"\omega_{N} b_{D}") == (sp.Symbol("omega_N") * b_D,)


def test_a_subscript_ends_where_its_braces_do():
    for line in ("n_{1}2", "n_12"):
        with pytest.raises(Unreadable):
            read(line)
    assert read("n_12", (("n_12", "K"),)) == (K,)
    with pytest.raises(Unreadable):
        read("n_{1}2", (("n_12", "K"),))


def test_short_names_of_relations():
    assert read(r"K \le B \ge T") == read(r"K \leq B \geq T")


def test_function_does_not_swallow_the_next_one():
    # sin theta cos theta is a product in print, everywhere
    theta = sp.Symbol("theta")
    assert read(r"\sin\theta\cos\theta") == (sin(theta) * cos(theta),)


@pytest.mark.parametrize(
    "line",
    [
        *(r"\frac{x}{x} = 1", "x/x = 1", r"x x^{-1} = 1", r"\frac{x^2}{x} = x"),
        *(r"\frac{1}{\frac{1}{x}} = x", r"\frac{1}{x} - \frac{1}{x} = 0"),
        *(r"0 \cdot \frac{1}{x} = 0", r"\frac{K}{KT} = 1/T", r"\frac{x}{y} \cdot \frac{y}{x} = 1"),
        *(r"\tan x - \tan x = 0", r"\sin^2(x) \cdot \sin^{-2}(x) = 1", r"|x|/|x| = 1"),
    ],
)
def test_what_is_divided_by_is_not_forgotten(line):
    (relation,) = map(proposition, read(line))
    assert [claim for side in relation.terms for claim in conditions(side)]


def test_a_divisor_that_no_form_keeps_is_not_read():
    vector = r"\begin{pmatrix} x \\ y \end{pmatrix}"
    with pytest.raises(Unreadable, match="a divisor that cancels"):
        read(rf"\frac{{T}}{{T}} {vector} = {vector}")


@pytest.mark.parametrize(
    ("latex", "meant"),
    [
        (r"b\ln(1+K)", b * sp.log(1 + K)),
        (r"\arctan\frac{K}{B}", sp.atan(K / B)),
        (r"m\dot x", m * sp.Symbol("v")),
        (r"b\dot{x}^2", b * sp.Symbol("v") ** 2),
        (r"\mathrm{Re}(H(z))", re(H(z))),
        (r"\operatorname{Re}\{H(z)\}", re(H(z))),
    ],
)
def test_functions_that_sources_use_are_read(latex, meant):
    assert read(latex) == (meant,)


def test_the_least_and_the_largest_of_values_are_read():
    """Of numbers, so that it is no matter how they are written."""
    (least,), (most,) = read(r"\min(K, B)"), read(r"\mathrm{max}\{K, B, T\}")
    for at in ({K: 1, B: 2, T: 3}, {K: 5, B: -1, T: 2}, {K: 4, B: 9, T: 9}):
        assert least.subs(at) == min(at[K], at[B])
        assert most.subs(at) == max(at.values())


@pytest.mark.parametrize("latex", [r"\dot K", r"\min K", r"\max(K)", r"\ln^{-1}(K)", r"\min{K, B}"])
def test_what_has_no_such_meaning_is_refused(latex):
    with pytest.raises(Unreadable):
        read(latex)

"""What a chapter may not have called proved: names, limits, prints and claims."""

import pytest
import sympy as sp
from flint import arb
from sympy import Eq, Rational, S, cos, pi, sin

from symhaptic.book.page import Page
from symhaptic.book.record import FalseStep
from symhaptic.notation import B, F, K, T, alpha, b, beta, d, delta, gamma, m, t, theta, v, x
from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Relation,
    implied,
    proposition,
    whole,
)
from symhaptic.proof.enclosed import enclosed, value
from symhaptic.proof.roots import NoSuchRoot, zero
from symhaptic.proof.theorems.axioms import known
from symhaptic.proof.theorems.kernel import (
    assume,
    conj,
    contr,
    disch,
    imp_antisym,
    not_intro,
)
from symhaptic.proof.theorems.leaves import broken, combined, number
from symhaptic.proof.theorems.tactics import denied, example, for_all, positive
from symhaptic.proof.verdict import Unfounded

a = sp.Symbol("a")
ZERO_IS_ONE = Relation(S.Zero, "=", S.One)


@pytest.fixture
def page():
    return Page("test")


# -- names and numbers ------------------------------------------------------------------


def test_a_name_has_the_unit_of_what_it_stands_for(page):
    # N/m and Ns/m, Table of symbols of the paper
    with pytest.raises(FalseStep, match="K is in N/m, what it stands for in Ns/m"):
        page.define("Wrong", K, B)
    page.define("Right", K, B / T)
    page.define("Text has no unit that could be read", r"\kappa", B)


def test_decimals_are_those_of_the_number_that_is_named(page):
    with pytest.raises(FalseStep, match=r"pi is not 3\.25"):
        page.enclosed("Wrong", [(pi, Rational(13, 4))], places=2)
    with pytest.raises(FalseStep, match=r"is not 1\.414"):
        page.enclosed("Wrong", [(r"\pi", sp.sqrt(2))], places=5)
    with pytest.raises(FalseStep, match="is no name"):
        page.enclosed("Wrong", [(r"\gamma + 1", sp.sqrt(2))], places=5)
    page.enclosed("Right", [(r"\pi", pi), ("x", zero(cos(x), x, S(1), S(2)))], places=3)


def test_a_value_has_no_open_symbols_and_is_real():
    with pytest.raises(NoSuchRoot, match="without x"):
        value(x + 1)
    with pytest.raises(NoSuchRoot, match="real"):
        enclosed(sp.I)


@pytest.mark.parametrize(
    ("name", "chain"),
    [
        ("1+1", (S(3), sp.Integer(3))),
        ("x^2", (S(-1), cos(theta) ** 2 + sin(theta) ** 2 - 2)),
        (x**2, (S(-1), sp.Integer(-1))),
        (cos(theta), (S(2), sp.Integer(2))),
        ("0 = 1", (S(2), sp.Integer(2))),
        ("x < 0", (S(2), sp.Integer(2))),
    ],
)
def test_a_formula_is_no_name(name, chain, page):
    with pytest.raises(FalseStep):
        page.step("Wrong", *chain, name=name)


def test_a_formula_of_defined_names_is_what_it_says(page):
    page.define("A stiffness", K, B / T)
    page.step("Twice", 3 * B - B, 2 * B, name="2KT")
    with pytest.raises(FalseStep):
        page.step("Twice", 3 * B - B, 2 * B, name="3KT")
    page.step("A name of its own", 3 * B - B, 2 * B, name=r"\frac{dz}{d\beta}")


# -- steps and limits -------------------------------------------------------------------


def test_a_step_holds_by_itself_or_by_the_definitions_of_the_page(page):
    with pytest.raises(FalseStep):
        page.step("Before", K * T, B)
    page.define("A stiffness", K, B / T)
    page.step("Behind", K * T, B)
    with pytest.raises(FalseStep):
        page.step("Wrong", K * T, 2 * B)


@pytest.mark.parametrize(
    ("expr", "value", "at"),
    [
        ((a - 1) * x / ((a - 1) * x + x**2), S.One, {a: 1}),
        (d * x / (d * x + x**2), S.One, {d: 0}),
        (
            (gamma - delta**2 / 4) * x / ((gamma - delta**2 / 4) * x + x**2),
            S.One,
            {gamma: 1, delta: 2},
        ),
        ((alpha + beta) * x / ((alpha + beta) * x + x**2), S.One, {alpha: 1, beta: -1}),
        (cos(theta) * x / (cos(theta) * x + x**2), S.One, {theta: pi / 2}),
        ((d * x + x**2) / (d * x + 2 * x**2), S.One, {d: 0}),
    ],
)
def test_a_limit_says_under_which_conditions_it_was_shown(expr, value, at, page):
    """Elsewhere the lowest term of the divisor vanishes: the limit is 0, or one half."""
    theorem = page._tends("Right", expr, x, S.Zero, value)
    assert any(h.at(at).left == 0 for h in theorem.hypotheses)
    page.limit("Right", expr, x, S.Zero, value)
    assert r"\ne0" in page.blocks[-1].text
    with pytest.raises(FalseStep):
        page.limit("Wrong", expr, x, S.Zero, value + 1)


@pytest.mark.parametrize(
    ("expr", "symbol"),
    [
        (K + B, m),  # it was never there
        (x * K, x),
        (sin(x) ** 2 - cos(x) ** 2, x),
    ],
)
def test_not_free_of(expr, symbol, page):
    with pytest.raises(FalseStep):
        page.free_of("something", expr, symbol)


# -- what follows from definitions ------------------------------------------------------


def settled(page, id, printed, *forms, **named):
    page.state(id, "whatever it says", printed)
    return page.settle(id, *forms, **named)


def test_a_print_that_is_a_definition_of_the_page_is_called_one(page):
    page.define("The quantity itself", x, 7 * v * sp.sqrt(m / K))
    verdict = settled(page, "mine", r"x = 7 v \sqrt{\frac{m}{K}}", Eq(x, 7 * v * sp.sqrt(m / K)))
    assert verdict.kind == "definition"
    assert verdict.definitions == (r"x:=7v\sqrt{\frac{m}{K}}",)


@pytest.mark.parametrize("split", [False, True])
def test_a_limit_of_the_stiffness_is_not_proved_by_defining_the_stiffness(split, page):
    if split:
        page.define("A stiffness", F, 17 * b * v)
        page.define("The wall", K, F / (v * T))
    else:
        page.define("The wall", K, 17 * b / T)
    verdict = settled(page, "mine", r"K = \frac{17b}{T}")
    assert verdict.kind == "definition"
    assert any(line.startswith("K:=") for line in verdict.definitions)


def test_what_follows_from_definitions_names_them(page):
    page.define("The damper's force", F, b * v * sp.exp(-b * t / m))
    page.define("The way by the momentum that is lost", x, (m * v - m * F / b) / b)
    right = settled(page, "way", r"x = \frac{mv}{b}(1 - e^{-bt/m})")
    assert right.kind == "proved"
    assert [line.partition(":=")[0] for line in right.definitions] == ["x", "F"]
    assert r"F=bv\mathrm{e}^{-bt/m}" in right.proposition.replace(r"\,", "")
    wrong = settled(page, "half", r"x = \frac{mv}{2b}(1 - e^{-bt/m})", Eq(x, (v - F / b) * m / b))
    assert wrong.kind == "misprint"
    assert wrong.counterexample
    none = settled(page, "none", r"x = \frac{mv}{3b}(1 - e^{-bt/m})")
    assert none.kind == "undecided"


@pytest.mark.parametrize(
    ("printed", "form"),
    [
        ("F = b v", Eq(x, 2 * v * T)),
        (r"x = 3 v T", Eq(S.Zero, S.Zero, evaluate=False)),
        (r"2 x = 6 v T", Eq(x, 2 * v * T)),
    ],
)
def test_no_print_is_a_misprint_because_something_else_is_right(printed, form, page):
    page.define("The way", x, 2 * v * T)
    with pytest.raises(FalseStep, match="keeps no side of the print"):
        settled(page, "mine", printed, form)


@pytest.mark.parametrize("form", [Eq(F, F, evaluate=False), Eq(b * v, b * v, evaluate=False)])
def test_no_print_is_a_misprint_whose_name_the_page_does_not_define(form, page):
    verdict = settled(page, "mine", "F = b v", form)
    assert verdict.kind == "undecided"
    assert "the page does not define F" in verdict.method


def test_each_printed_equation_is_derived_before_one_is_a_misprint(page):
    page.define("The way", x, 2 * v * T)
    page.state("mine", "whatever it says", "x = 2 v T", "F = b v")
    with pytest.raises(FalseStep, match="1 equations are derived, and 2 printed"):
        page.settle("mine", Eq(x, 2 * v * T))


def test_no_counterexample_stands_against_what_follows(page):
    page.define("The way", x, 2 * v * T)
    with pytest.raises(FalseStep, match="a counterexample stands against"):
        settled(page, "mine", "x = v T + v T", unless={v: S.One, T: S.One})


@pytest.mark.parametrize(
    "define",
    [
        lambda page: (page.define("One", x, 2 * v * T), page.define("Other", x, 3 * v * T)),
        lambda page: (page.define("One", x, v * T), page.define("Other", v, x / T)),
    ],
    ids=["two meanings", "a circle"],
)
def test_a_name_stands_for_one_thing_and_not_for_itself(define, page):
    with pytest.raises(FalseStep, match=r"stands for more than one thing|defined by itself"):
        define(page)


@pytest.mark.parametrize(
    ("name", "meaning", "printed"),
    [
        (delta, -1 - beta**2, r"\delta + 2 = 1 - \beta^2"),
        (d, -1 - beta**2, r"d + 1 = -\beta^2"),
        (theta, 4 + beta**2, r"\theta - 4 = \beta^2"),
        # what is divided by is zero, and cancels
        (theta, 2 * alpha, r"\frac{\theta - 2\alpha}{\theta - 2\alpha} = 1"),
        (theta, 2 * alpha, r"\theta (\theta - 2\alpha)/(\theta - 2\alpha) = \theta"),
    ],
)
def test_nothing_follows_from_a_name_outside_of_its_domain(name, meaning, printed, page):
    """A damping below 0, say, of which everything holds and nothing."""
    page.define("A name", name, meaning)
    with pytest.raises(FalseStep, match="in their domains"):
        settled(page, "mine", printed)


@pytest.mark.parametrize(("name", "number"), [(T, 0), (m, 0), (theta, 4), (delta, -pi), (d, -1)])
def test_a_name_is_no_number_outside_of_its_domain(name, number, page):
    with pytest.raises(FalseStep, match="has another domain in the notation"):
        page.define("A number", name, S(number))


def test_a_name_may_be_in_its_domain_for_small_values_alone(page):
    page.define("An angle", theta, 100 * alpha)
    page.define("Another", beta, theta / 2)
    assert settled(page, "mine", r"\beta - \alpha = 49\alpha").kind == "definition"


@pytest.mark.parametrize("right", ["x = x", "3 v T = 3 v T"])
def test_what_holds_of_every_name_corrects_nothing(right, page):
    page.define("The way", x, 2 * v * T)
    page.state("mine", "whatever it says", "x = 3 v T")
    with pytest.raises(FalseStep, match="holds whatever a name means"):
        page.settle("mine", Eq(x, 2 * v * T), corrected=(right,))


@pytest.mark.parametrize("block", ["enclosed", "minimal"])
def test_a_block_without_a_line_shows_nothing(block, page):
    with pytest.raises(FalseStep, match="nothing is shown"):
        getattr(page, block)("Nothing", [])


def test_no_zeros_are_all_of_a_polynomial_that_may_be_zero(page):
    ends = arb(0), arb(1)
    for polynomial in ([], [arb(0)], [arb(0, 1)], [arb(1), arb(0, 1)]):
        with pytest.raises(NoSuchRoot, match="highest coefficient may be zero"):
            page.all_zeros("none", polynomial, *ends, [])
    one = [arb(-1), arb(2)]
    for low, high in ((1, 0), (0, "inf"), ("nan", "nan")):
        with pytest.raises(FalseStep, match="is no interval"):
            page.all_zeros("none", one, arb(low), arb(high), [])
    page.all_zeros("one", one, *ends, [arb("0.5")])


def test_nothing_drops_out_if_nothing_is_named(page):
    with pytest.raises(FalseStep, match="no symbol is given"):
        page.free_of("a formula", K + B)


def test_what_is_no_equation_needs_a_theorem(page):
    page.define("A stiffness", K, B / T)
    with pytest.raises(FalseStep, match="is no equation"):
        settled(page, "mine", "K < B/T")


def test_what_a_symbol_is_assumed_to_be_is_not_on_the_page(page):
    """beta is any real number: the root of its square is beta of a positive one only."""
    own = sp.Symbol("beta", positive=True)
    for write in (
        lambda: page.define("A name", alpha, own),
        lambda: page.step("A step", own * sin(theta) ** 2 + own * cos(theta) ** 2, own, name=alpha),
        lambda: page.limit("Where it ends", own / (1 + T), T, S.Zero, own),
        lambda: settled(page, "own", r"\alpha = 2", Eq(alpha, own), definition=True),
    ):
        with pytest.raises((FalseStep, Unfounded), match="carries assumptions"):
            write()
    with pytest.raises(FalseStep, match="carries assumptions"):
        settled(page, "mine", r"\alpha = \sqrt{\beta^2}", Eq(alpha, own))


@pytest.mark.parametrize(
    ("printed", "form"),
    [
        (r"\pi = 4", Eq(pi, 4, evaluate=False)),
        ("K = B", Eq(K, B)),
        (r"\alpha = 2\alpha", Eq(alpha, 2 * alpha, evaluate=False)),
        ("1 = 2", Eq(1, 2, evaluate=False)),
        ("x < x", sp.Lt(x, x, evaluate=False)),
    ],
)
def test_what_defines_nothing_is_no_definition(printed, form, page):
    assert settled(page, "mine", printed, form, definition=True).kind == "undecided"


# -- what a claim may say of a print ----------------------------------------------------


def _never():
    """not (1 < 0)."""
    return denied(number(sp.Le(0, 1, evaluate=False)), proposition(sp.Lt(1, 0, evaluate=False)))


def _from_nothing():
    """0 = 1 => 0 = 2."""
    premise = assume(ZERO_IS_ONE)
    return disch(combined(Relation(S.Zero, "=", S(2)), [premise, S(2)]), ZERO_IS_ONE)


def _iff():
    """0 = 1 <=> -1 is whole."""
    not_whole, apart = broken(-1), number(sp.Ne(0, 1, evaluate=False))
    there = contr(not_intro(assume(ZERO_IS_ONE), apart), whole(-1))
    back = contr(not_intro(assume(whole(-1)), not_whole), ZERO_IS_ONE)
    return imp_antisym(disch(there, ZERO_IS_ONE), disch(back, whole(-1)))


CLAIMS = [
    ("1 < 0", Not((proposition(sp.Lt(1, 0, evaluate=False)),)), _never),
    ("x < 0", Exists((x,), proposition(x < 0)), None),
    ("0 = 1", Iff((ZERO_IS_ONE, whole(-1))), _iff),
    (
        "0 = 2",
        And((Implies((ZERO_IS_ONE, Relation(S.Zero, "=", S(2)))),)),
        lambda: conj(_from_nothing()),
    ),
    (
        "K < 0",
        ForAll((K,), implied([2 * K < 0], K < 0)),
        lambda: for_all([K], [2 * K < 0], positive(K < 0, [Rational(1, 2), 2 * K < 0])),
    ),
    (
        "K < 0",
        ForAll((K,), implied([K < 0], K < 0)),
        lambda: for_all([K], [K < 0], assume(K < 0)),
    ),
]


@pytest.mark.parametrize(("printed", "claim", "theorem"), CLAIMS, ids=range(len(CLAIMS)))
def test_a_claim_concludes_its_print_and_does_not_suppose_it(printed, claim, theorem, page):
    page.state("mine", "whatever it says", printed, claim=claim)
    shown = known("square") if theorem is None else theorem()
    with pytest.raises(Unfounded, match="the claim"):
        page.settle("mine", shown)


def test_a_claim_may_add(page):
    claim = ForAll((x,), implied([x > 1], And((proposition(x > 0), proposition(x**2 > 0)))))
    page.state("mine", "more", "x > 0", claim=claim)
    first = positive(x > 0, x > 1, [1])
    both = conj(first, positive(x**2 > 0, [first, first]))
    verdict = page.settle("mine", for_all([x], [x > 1], both), example=example({x: 2}, [x > 1]))
    assert verdict.kind == "proved"


def test_a_condition_is_one_of_a_named_predicate(page):
    """x < 0 => 0 = 0 says nothing of a print x < 0."""
    claim = ForAll((x,), implied([x < 0], Relation(S.Zero, "=", S.Zero)))
    page.state("mine", "whatever it says", "x < 0", claim=claim, condition=True)
    with pytest.raises(Unfounded, match="no condition of a predicate"):
        page.settle("mine", known("square"))


def test_no_print_is_a_misprint_where_a_name_is_outside_of_its_domain(page):
    page.define("A damping", delta, -1 - beta**2)
    verdict = settled(page, "mine", r"\delta = 1 + \beta^2", Eq(delta, -1 - beta**2))
    assert verdict.kind == "undecided"
    assert "no point is found at which the print fails" in verdict.method

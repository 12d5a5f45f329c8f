"""What a chapter may not take for a ground of a verdict."""

import copy
import pickle
from dataclasses import replace

import pytest
import sympy as sp
from flint import arb
from sympy import Eq, Rational, S, atan, cos, floor, pi, sin

from symhaptic.book.grounds import shows
from symhaptic.book.page import Page
from symhaptic.book.record import Evidence, FalseStep
from symhaptic.notation import B, K, T, alpha, b, d, m, theta, x
from symhaptic.proof.counterexample import Witness
from symhaptic.proof.enclosed import Enclosed, enclosed, value
from symhaptic.proof.roots import NoSuchRoot, zero
from symhaptic.proof.seal import NotMade
from symhaptic.proof.sign import Fact, NotShown, assume, combined, either
from symhaptic.proof.verdict import Unfounded


@pytest.fixture
def page():
    found = Page("test")
    found.state("mine", "something in words")
    return found


# -- names and numbers ------------------------------------------------------------------


def test_a_name_has_the_unit_of_what_it_stands_for(page):
    # N/m and Ns/m, Table of symbols of the paper
    with pytest.raises(FalseStep, match="K is in N/m, what it stands for in Ns/m"):
        page.define("Wrong", K, B)
    page.define("Right", K, B / T)
    page.define("Text has no unit that could be read", r"\kappa", B)


def test_pi_is_not_three_and_a_quarter(page):
    with pytest.raises(TypeError, match=r"a bare ball 3\.2500 shows nothing"):
        page.enclosed("Wrong", [(r"\pi", arb("3.25"))])
    with pytest.raises(FalseStep, match=r"pi is not 3\.25"):
        page.enclosed("Wrong", [(pi, Rational(13, 4))], places=2)
    with pytest.raises(TypeError, match="bare ball"):
        page.settle("mine", value=arb("3.25"))
    page.enclosed("Right", [(pi, pi), ("x", zero(cos(x), x, S(1), S(2)))], places=3)
    assert len(page.certificates) == 1  # of the zero, checked again at the end


def test_a_condition_that_is_left_out_is_told_in_latex(page):
    with pytest.raises(FalseStep, match=r"^mine: provided: K > 0 is not allowed; LaTeX of a"):
        page.settle("mine", Eq(K, B / T), provided=K > 0)


def test_a_value_has_no_open_symbols_and_is_real():
    with pytest.raises(NoSuchRoot, match="without x"):
        value(x + 1)
    with pytest.raises(NoSuchRoot, match="real"):
        enclosed(sp.I)


# -- comparisons ------------------------------------------------------------------------


def test_a_thing_compared_with_itself_is_no_ground(page):
    with pytest.raises(FalseStep, match="0 compared with itself"):
        page.same("nothing", 0, 0)
    with pytest.raises(FalseStep, match=r"x \+ 1 compared with itself"):
        page.same(
            "nothing",
            x + 1,
            x + 1,
        )
    with pytest.raises(FalseStep, match="two sides"):
        page.same("nothing", x)
    told = page.same("computed", x + x, 2 * x)
    assert told.method == "both sides evaluate to one expression"


@pytest.mark.parametrize(
    ("expr", "symbol"),
    [
        (K + B, m),  # it was never there
        (floor(theta), theta),  # its derivative is zero almost everywhere
        (atan(x) + atan(1 / x), x),  # pi/2 for x > 0, -pi/2 for x < 0
        (sp.Heaviside(x), x),
        (sp.sign(x), x),
        (x * K, x),
    ],
)
def test_not_free_of(expr, symbol, page):
    with pytest.raises(FalseStep):
        page.free_of("something", expr, symbol)


def test_free_of_what_drops_out(page):
    page.free_of("Pythagoras", K * (sin(theta) ** 2 + cos(theta) ** 2), theta)


# -- facts ------------------------------------------------------------------------------


def test_an_assumption_settles_nothing(page):
    with pytest.raises(FalseStep, match="assumed, not proved"):
        page.settle("mine", assume(b))
    with pytest.raises(FalseStep, match="rests on itself"):
        page.settle("mine", combined(x, [Rational(1, 2), assume(2 * x)]))
    with pytest.raises(FalseStep, match="assumed, not proved"):
        page.positive("Wrong", assume(x), "x>0")


def test_what_a_fact_rests_on_is_on_the_page(page):
    fact = combined(x**2 - x, [assume(x - 1), assume(x - 1)], [assume(x - 1)])
    with pytest.raises(FalseStep, match="rests on x - 1 > 0, which is not on the page"):
        page.settle("mine", fact)
    page.positive("Beyond 1", fact, "x>1")
    assert page.settle("mine", fact).claimed == "proved"


def test_a_domain_of_the_notation_need_not_be_written(page):
    # theta lies in (0, pi); x, which is real, in no interval
    fact = combined(theta * (pi - theta), [assume(theta), assume(pi - theta)])
    assert page.settle("mine", fact).claimed == "proved"


def test_two_cases_are_all_of_what_is_real_only():
    # the square of j is -1: from j > 0 and from j <= 0 alike
    less = combined(S(-1), [assume(sp.I), assume(sp.I)])
    more = combined(S(-1), [2, assume(-sp.I, False), assume(-sp.I, False)], [1])
    with pytest.raises(NotShown, match="is not real"):
        either(less, more, sp.I)


def test_a_sign_shows_what_holds_wherever_the_symbols_are(page):
    fact = combined(K - 1, [assume(K - 2)], [1])
    page.positive("Of a stiff one", fact, "K>2")
    page.state("stiff", "of every wall", "K > 1")
    assert page.settle("stiff", K > 1).kind == "argued"


def test_a_square_is_not_negative_of_what_is_real(page):
    # (K + j)^2 + (K - j)^2 = 2 K^2 - 2, which is negative for K = 0
    squares = [assume((K + sign * sp.I) ** 2, strict=False) for sign in (1, -1)]
    with pytest.raises(FalseStep, match="is not on the page"):
        page.settle("mine", combined(2 * K**2 - 2, *([square] for square in squares)))
    real = combined(K**2 + 1, [assume(K**2, strict=False)], [1])
    assert page.settle("mine", real).claimed == "proved"


@pytest.mark.parametrize(
    "make",
    [
        lambda: Fact(x),
        lambda: Evidence("because"),
        lambda: Witness({}, "because"),
        lambda: Enclosed(arb(3)),
        lambda: replace(assume(x), expr=-x),
        lambda: copy.copy(assume(x)),
        lambda: pickle.dumps(assume(x)),
    ],
)
def test_what_proves_is_not_made_by_hand(make):
    with pytest.raises(NotMade):
        make()


# -- prints -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("printed", "form"),
    [
        ("x = 2", Eq(x, 2)),
        ("x = 2", Eq(2, x, evaluate=False)),
        ("x = K + B/T", Eq(x, B / T + K)),
        ("x > 2", x > 2),
        ("x > 2", sp.Lt(2, x, evaluate=False)),
        ("x - K = B", Eq(B - x, -K)),
        ("x = 2", Eq(x, 2 * sin(theta) ** 2 + 2 * cos(theta) ** 2)),
        ("x > 2", 2 * x > 4),
    ],
)
def test_a_print_that_is_retyped_is_not_proved(printed, form):
    page = Page("test")
    page.step("Beside it", sin(theta) ** 2, 1 - cos(theta) ** 2)
    page.state("mine", "whatever it says", printed)
    verdict = page.settle("mine", form)
    assert (verdict.kind, verdict.argued_for) == ("argued", "proved")
    page.state("again", "what rests on it", printed)
    assert page.settle("again", form).kind == "argued"


def test_a_print_that_is_retyped_is_what_the_page_shows():
    page = Page("test")
    page.step("Two", cos(theta) ** 2 + sin(theta) ** 2 + 1, S(2), name=x)
    page.state("mine", "what the name stands for", "x = 2")
    assert page.settle("mine", Eq(x, 2)).kind == "proved"
    page.state("wrong", "it is 2", "x = 3")
    assert page.settle("wrong", Eq(x, 3)).kind == "argued"
    page.state("sign", "of an angle inside", r"\pi \theta - \theta^2 > 0")
    fact = combined(theta * (pi - theta), [assume(theta), assume(pi - theta)])
    page.positive("It is", fact, r"0<\theta<\pi")
    assert page.settle("sign", pi * theta - theta**2 > 0).kind == "proved"
    page.state("identity", "true of itself", r"\sin^2(\theta) = 1 - \cos^2(\theta)")
    assert page.settle("identity", Eq(sin(theta) ** 2, 1 - cos(theta) ** 2)).kind == "proved"


def test_only_what_has_no_value_of_its_own_is_a_name():
    page = Page("test")
    page.step("One", cos(theta) ** 2 + sin(theta) ** 2, S.One, name=cos(theta))
    page.state("mine", "of every angle", r"\cos(\theta) = 1")
    assert page.settle("mine", Eq(cos(theta), 1)).kind == "argued"
    page.define("By itself", alpha, 2 * alpha)
    page.state("twice", "of every number", r"\alpha = 2 \alpha")
    assert page.settle("twice", Eq(alpha, 2 * alpha, evaluate=False)).kind == "argued"
    page.state("circle", "roughly", r"\pi = 4")
    four = Eq(pi, 4, evaluate=False)
    assert page.settle("circle", four, definition=True).kind == "argued"
    page.state("units", "a stiffness that is a damping", "K = B")
    assert page.settle("units", Eq(K, B), definition=True).kind == "argued"
    page.state("name", "from here on", r"\theta = \pi")
    assert page.settle("name", Eq(theta, pi), definition=True).kind == "definition"


def test_a_name_that_stands_for_two_things_shows_neither():
    """x is 2 and x is 3, by two steps that are both right of what they are of."""
    page = Page("test")
    page.step("Two", cos(theta) ** 2 + sin(theta) ** 2 + 1, S(2), name=x)
    page.step("Three", cos(theta) ** 2 + sin(theta) ** 2 + 2, S(3), name=x)
    for id, number in (("two", 2), ("three", 3)):
        page.state(id, "what the name stands for", f"x = {number}")
        assert page.settle(id, Eq(x, number)).kind == "argued"
    page.define("A wall", K, B / T)
    page.define("Twice as stiff", K, 2 * B / T)
    page.state("put", "a stiffness put in", "b = K T")
    with pytest.raises(FalseStep, match="K stands for more than one thing on the page"):
        page.settle("put", Eq(b, B), given={K: B / T})


def test_a_name_may_be_written_twice_for_the_same():
    page = Page("test")
    page.define("A wall", K, B / T)
    page.step("Again", (B + 1) / T - 1 / T, B / T, name=K)
    page.state("same", "a stiffness", r"K = \frac{B}{T}")
    assert page.settle("same", Eq(K, B / T)).kind == "proved"


def test_what_a_symbol_is_assumed_to_be_is_not_on_the_page():
    """beta is any real number: the root of its square is beta of a positive one only."""
    page, own = Page("test"), sp.Symbol("beta", positive=True)
    known = "carries assumptions; its domain in the notation"
    page.state("mine", "the root of a square", r"\alpha = \sqrt{\beta^2}")
    for write in (
        lambda: page.define("A name", alpha, own),
        lambda: page.step("A step", own * sin(theta) ** 2 + own * cos(theta) ** 2, own, name=alpha),
        lambda: page.limit("Where it ends", own / (1 + T), T, S.Zero, own),
        lambda: page.settle("mine", Eq(alpha, own)),
        lambda: page.settle("mine", Eq(alpha, alpha, evaluate=False), given={alpha: own}),
        lambda: page.settle("mine", Eq(alpha, sp.Function("H", positive=True)(T))),
        lambda: page.settle("mine", Eq(alpha, own), definition=True),
        lambda: page.settle("mine", combined(own * theta, [assume(own), assume(theta)])),
    ):
        with pytest.raises((FalseStep, Unfounded), match=f"{known}|is not a definition on"):
            write()
    # what a page that was patched shows is not known again where it arrives
    assert not shows([Eq(alpha, own)], [(alpha, own)], [])


@pytest.mark.parametrize(
    ("expr", "value"),
    [
        (d * x / (d * x + x**2), S.One),  # 0 without a delay
        ((d * x + x**2) / (d * x + 2 * x**2), S.One),  # one half
        (sin(d * x) / sin(d * x + x**2), S.One),  # 0
        (x**2 / (d * x + x**2), S.Zero),  # one
    ],
)
def test_a_limit_holds_where_a_symbol_is_zero_too(expr, value, page):
    """The lowest term of a divisor is another one there, which the series does not see."""
    with pytest.raises(FalseStep, match="step 'Wrong' is false at d = 0"):
        page.limit("Wrong", expr, x, S.Zero, value)
    page.limit("Not defined there", x / (x**2 + d * x), x, S.Zero, 1 / d)
    page.limit("Right there, too", sin(d * x) / sin(x), x, S.Zero, d)
    page.limit("Of all the sum", K + sin(x) / x, x, S.Zero, K + 1)
    assert page.blocks[-1].lines[0][0].endswith(r"} \bigl(K+\frac{\sin x}{x}\bigr)")


# -- what is put in ---------------------------------------------------------------------


def test_only_definitions_are_put_in():
    page = Page("test")
    page.state("mine", "a force without a damper", r"x = K + B/T")
    with pytest.raises(FalseStep, match="B = 0 restricts the statement"):
        page.settle("mine", Eq(x, K), given={B: S.Zero})
    with pytest.raises(FalseStep, match="K = B/T is not a definition on the page"):
        page.settle("mine", Eq(x, 2 * B / T), given={K: B / T})
    page.define("A wall", K, B / T)
    page.step("Both", 3 * B / T - B / T, 2 * B / T, name=x)
    assert page.settle("mine", Eq(x, 2 * B / T), given={K: B / T}).kind == "proved"


def test_what_is_put_in_has_the_sign_of_the_definition():
    page = Page("test")
    page.define("A wall", K, B / T)
    page.step("Twice", 3 * B - B, 2 * B, name=x)
    page.state("mine", "what pushes back", "x = -2 K T")
    with pytest.raises(FalseStep, match="is not a definition on the page"):
        page.settle("mine", Eq(x, 2 * B), given={B: -K * T})
    page.state("right", "what pushes", "x = 2 K T")
    assert page.settle("right", Eq(x, 2 * B), given={B: K * T}).kind == "proved"

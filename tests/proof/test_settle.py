"""A verdict follows from what is settled, and what does not support it is refused."""

import pytest
import sympy as sp
from flint import arb, ctx
from sympy import Eq, I, Rational, S, cos, pi, sin, sqrt

from symhaptic.notation.proposition import ForAll, Relation, proposition
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import read
from symhaptic.proof.constants import Unmeasured
from symhaptic.proof.settle import Settlement
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.theorems.kernel import gen
from symhaptic.proof.theorems.leaves import identity
from symhaptic.proof.theorems.tactics import counterexample, example, for_all, positive
from symhaptic.proof.verdict import Kind, Unfounded

x, K, B, T, b = sp.symbols("x K B T b")
PRINTED = read(r"K = \frac{b}{T}")
RIGHT = (Eq(K, b / T),)


# -- without a theorem --------------------------------------------------------------------


def test_a_definition_is_the_form_that_is_given():
    assert Settlement(derived=RIGHT).decide(PRINTED).kind == Kind.DEFINITION
    wrong = Settlement(derived=(Eq(K, 2 * b / T),)).decide(PRINTED)
    assert wrong.kind == Kind.UNDECIDED
    assert not wrong


@pytest.mark.parametrize(
    "printed",
    [
        r"K = b",  # N/m for Ns/m
        r"K T = 2b",  # no name stands alone
        r"K = K + 0",
        r"K < b/T",  # a bound that needs a theorem
    ],
)
def test_what_defines_nothing_is_no_definition(printed):
    forms = read(printed)
    assert Settlement(derived=forms).decide(forms).kind == Kind.UNDECIDED


def test_a_form_that_is_not_known_to_be_equal_is_undecided():
    verdict = Settlement(derived=(Eq(K, sqrt(b**2) / T),)).decide(PRINTED)
    assert verdict.kind == Kind.UNDECIDED


def test_what_is_derived_has_as_many_parts_as_the_print():
    with pytest.raises(Unfounded, match="1 components against 2"):
        Settlement(derived=(*RIGHT, *RIGHT)).decide(PRINTED)


def test_nothing_settles_nothing():
    assert Settlement().decide(PRINTED).kind == Kind.UNDECIDED
    assert Settlement().decide(()).kind == Kind.UNDECIDED
    assert Settlement(derived=RIGHT).decide(()).kind == Kind.UNDECIDED


def test_what_rests_on_data_outside_is_compared_where_it_is_derived():
    assert Settlement(external="on a table").decide(PRINTED).kind == Kind.EXTERNAL
    outside = Settlement(external="on a table", derived=RIGHT)
    assert outside.decide(PRINTED).kind == Kind.EXTERNAL
    wrong = outside.decide(read(r"K = \frac{2b}{T}"))
    assert wrong.kind == Kind.UNDECIDED


def test_a_slip_is_none_of_a_formula():
    assert Settlement(slip="(12)").decide(()).kind == Kind.SLIP
    with pytest.raises(Unfounded, match="a slip is a statement in words"):
        Settlement(slip="(12)").decide(PRINTED)


# -- by a theorem -------------------------------------------------------------------------


def concluded(printed):
    """What is printed, for all values."""
    [form] = printed
    claim = proposition(form)
    return ForAll(tuple(sorted(claim.free, key=str)), claim)


SQUARED = read("(x + 1)^2 = x^2 + 2x + 1")
IDENTITY = gen(identity((x + 1) ** 2, x**2 + 2 * x + 1), x)
HALF = read("(x + 1)^2 = x^2 + x + 1")


def test_a_theorem_settles_the_print_that_it_concludes_and_no_other():
    settlement = Settlement(Judged(IDENTITY), concluded)
    assert settlement.decide(SQUARED).kind == Kind.PROVED
    assert settlement.accepts(SQUARED)
    with pytest.raises(Unfounded, match="the theorem says"):
        settlement.decide(HALF)
    assert not settlement.accepts(HALF)


def test_a_theorem_needs_a_claim():
    with pytest.raises(Unfounded, match="no claim"):
        Settlement(Judged(IDENTITY)).decide(SQUARED)


def test_a_misprint_is_false_and_its_correction_a_theorem():
    at_two = counterexample(concluded(HALF), {x: S(2)})  # 9 for 7
    right = ("(x + 1)^2 = x^2 + 2x + 1",)
    verdict = Settlement(Judged(IDENTITY, None, (at_two,), right), concluded).decide(HALF)
    assert (verdict.kind, verdict.corrected) == (Kind.MISPRINT, right[0])
    assert verdict.counterexample == {"x": "2"}
    assert not verdict
    refuted = Judged(IDENTITY, None, (at_two,), right, misprint=False)
    assert Settlement(refuted, concluded).decide(HALF).kind == Kind.REFUTED


AT_TWO = counterexample(concluded(HALF), {x: S(2)})
AT_ZERO = example({x: S.Zero}, [Relation(S.Zero, "<=", x)])  # 1 = 1: nothing differs


@pytest.mark.parametrize(
    ("corrected", "unless", "told"),
    [
        ("(x + 1)^2 = x^2 + 3x + 1", (AT_TWO,), "the theorem says"),
        ("(x + 1)^2 = x^2 + 2x + 1", (), "needs a counterexample"),
        ("(x + 1)^2 = x^2 + 2x + 1", (AT_ZERO,), "needs a counterexample"),
        ("(x + 1)^2 = x^2 + 2x + 1", (AT_TWO, AT_ZERO), "needs a counterexample"),
    ],
)
def test_a_misprint_without_its_grounds_is_refused(corrected, unless, told):
    with pytest.raises(Unfounded, match=told):
        Settlement(Judged(IDENTITY, None, unless, (corrected,)), concluded).decide(HALF)


def test_a_right_print_is_no_misprint():
    judged = Judged(IDENTITY, None, (AT_TWO,), ("(x + 1)^2 = x^2 + 2x + 1",))
    with pytest.raises(Unfounded, match="needs a counterexample"):
        Settlement(judged, concluded).decide(SQUARED)


def test_the_derived_form_is_what_the_theorem_is_about():
    """It is what `formula(id).derived` hands out."""
    settlement = Settlement(Judged(IDENTITY), concluded, HALF)
    with pytest.raises(Unfounded, match="the derived form is another"):
        settlement.decide(SQUARED)
    assert Settlement(Judged(IDENTITY), concluded, SQUARED).decide(SQUARED).kind == Kind.PROVED


POSITIVE = read("K^2 + K > 0")


def test_a_condition_is_that_of_the_theorem_and_does_not_save_a_wrong_print():
    theorem = for_all((K,), [K > 0], positive(K**2 + K > 0, [K > 0, K > 0], K > 0))
    unless = (counterexample(concluded(POSITIVE), {K: -S.Half}, but=K > 0),)
    settlement = Settlement(Judged(theorem, example({K: 1}, [K > 0]), unless), concluded)
    verdict = settlement.decide(POSITIVE)
    assert (verdict.kind, verdict.condition) == (Kind.QUALIFIED, "K>0")
    assert verdict.counterexample == {"K": "-1/2"}
    assert not verdict
    for wrong in ("K^2 + 2K > 0", "K^2 + K < 0", r"K^2 + K \ge 0"):
        with pytest.raises(Unfounded):
            settlement.decide(read(wrong))


def test_a_definition_on_the_page_is_not_proved():
    settlement = Settlement(Judged(IDENTITY), concluded, definitions=("x:=1",), defines=True)
    verdict = settlement.decide(SQUARED)
    assert (verdict.kind, verdict.definitions) == (Kind.DEFINITION, ("x:=1",))


# -- constants ----------------------------------------------------------------------------


def constant(value, how, digits):
    return quoted((value,), (Quoted(how, digits),))


def quoted(values, numbers, printed=SQUARED, **more):
    settlement = Settlement(Judged(IDENTITY), concluded, values=values, quoted=numbers, **more)
    return settlement.decide(printed)


@pytest.mark.parametrize(
    ("value", "how", "digits", "kind"),
    [
        (pi, "about", "3.14", Kind.ENCLOSED),
        (pi, "about", "3.15", Kind.REFUTED),
        (pi, "about", "3.1415927", Kind.ENCLOSED),
        (pi, "about", "3.1415926", Kind.REFUTED),  # truncated, not rounded
        (pi, "below", "3.15", Kind.ENCLOSED),
        (pi, "below", "3.14", Kind.REFUTED),
        (pi, "above", "3.14", Kind.ENCLOSED),
        (pi, "above", "3.15", Kind.REFUTED),
        (sin(1) ** 2 + cos(1) ** 2, "below", "1", Kind.UNDECIDED),
    ],
)
def test_quoted_number(value, how, digits, kind):
    assert constant(value, how, digits).kind == kind


def test_decimals_and_radius_enclose_the_constant():
    verdict = constant(sqrt(2) - 1, "about", "0.41")
    # OEIS A014176 minus 2
    exact = "0.414213562373095048801688724209698078569671875376948"
    assert len(verdict.value.partition(".")[2]) >= 20
    with ctx.workprec(256):
        assert abs(arb(exact) - arb(verdict.value)) <= arb(verdict.radius) + arb("1e-50")


def test_complex_number_is_no_quoted_constant():
    with pytest.raises(Unmeasured):
        constant(sqrt(2) - 1 + I, "about", "0.41")


def test_number_that_is_hardly_known_is_no_constant():
    with pytest.raises(Unmeasured), ctx.workprec(20):
        constant(arb(2).sqrt(), "about", "1.4")


@pytest.mark.parametrize(
    ("how", "digits", "value", "says"),
    [
        ("about", "0.41", sqrt(2) - 1, "rounded down"),
        ("about", "3.142", pi, "rounded up"),
        ("about", "987e3", pi**2 * 10**5, "rounded up"),  # 986 960.44...
        ("below", "0.27", 2 - sqrt(3), "rounded up"),
        ("above", "3.1", pi, "cut off"),
        ("above", "3", 2 * pi, "looser than its digits: 6 would hold"),
        ("below", "0.1074", Rational(10699, 100000), "looser than its digits: 0.1070 would hold"),
    ],
)
def test_rounding_of_the_last_digit(how, digits, value, says):
    verdict = constant(value, how, digits)
    assert verdict.kind == Kind.ENCLOSED
    assert verdict.note == f"{digits} is {says}"


def test_exponent_marks_the_last_digit_that_counts():
    assert constant(pi**2 * 1000, "about", "1e4").kind == Kind.ENCLOSED  # 9869.6
    assert constant(pi**2 * 1000, "about", "10e3").kind == Kind.ENCLOSED
    assert constant(pi**2 * 1000, "about", "10000").kind == Kind.REFUTED


def test_every_quoted_number_must_hold():
    two = (Quoted("above", "17.8"), Quoted("below", "0.0562"))
    ratio = Rational(1783, 100)
    assert quoted((ratio, 1 / ratio), two).kind == Kind.ENCLOSED
    wrong = (two[0], Quoted("below", "0.056"))
    assert quoted((ratio, 1 / ratio), wrong).kind == Kind.REFUTED
    with pytest.raises(Unfounded):
        quoted((ratio,), two)
    with pytest.raises(Unfounded):
        quoted((pi,), ())


def test_a_number_does_not_save_a_wrong_formula():
    with pytest.raises(Unfounded, match="the theorem says"):
        quoted((pi,), (Quoted("about", "3.14"),), HALF)


def test_a_number_makes_no_result_of_a_definition():
    verdict = quoted((pi,), (Quoted("about", "3.14"),), defines=True)
    assert verdict.kind == Kind.DEFINITION

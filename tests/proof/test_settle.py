"""A verdict follows from its grounds, and grounds that do not support it are refused."""

import pytest
import sympy as sp
from flint import arb, ctx
from symhaptic.proof.sign import assume, combined, number
from sympy import Eq, I, Rational, S, cos, pi, sin, sqrt

from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import read
from symhaptic.proof.constants import Unmeasured
from symhaptic.proof.settle import Settlement
from symhaptic.proof.verdict import Kind, Unfounded

x, K, B, T, b, d, m, y = sp.symbols("x K B T b d m y")
PASSING = {Kind.PROVED, Kind.DEFINITION, Kind.ENCLOSED, Kind.QUALIFIED}
PRINTED = read(r"K = \frac{b}{T}")
RIGHT = (Eq(K, b / T),)


def test_equal_form_is_proved():
    assert Settlement(derived=RIGHT).decide(PRINTED).claimed == Kind.PROVED


def test_definition_is_one_only_if_the_form_is_right():
    assert Settlement(derived=RIGHT, definition=True).decide(PRINTED).claimed == Kind.DEFINITION
    wrong = Settlement(derived=(Eq(K, 2 * b / T),), definition=True)
    assert wrong.decide(PRINTED).claimed == Kind.MISPRINT


def test_undecided_form_is_undecided():
    verdict = Settlement(derived=(Eq(K, sqrt(b**2) / T),)).decide(PRINTED)
    assert verdict.claimed == Kind.UNDECIDED
    assert not verdict


def test_definitions_in_force_are_put_in():
    with_given = Settlement(derived=(Eq(K, x),), given={x: b / T})
    assert with_given.decide(PRINTED).claimed == Kind.PROVED
    assert Settlement(derived=(Eq(K, x),)).decide(PRINTED).claimed not in PASSING


def test_no_grounds_no_verdict():
    assert Settlement().decide(PRINTED).claimed == Kind.UNDECIDED
    assert Settlement().decide(()).claimed == Kind.UNDECIDED


def test_words_need_a_proof():
    assert Settlement(proofs=("seen",)).decide(()).claimed == Kind.PROVED
    assert Settlement(derived=RIGHT).decide(()).claimed == Kind.UNDECIDED


def test_printed_formula_is_not_settled_by_words():
    try:
        verdict = Settlement(proofs=("a proof of something else",)).decide(PRINTED)
    except Unfounded:
        return
    assert verdict.claimed not in PASSING


def test_what_follows_from_data_outside_is_compared():
    outside = Settlement(external="on a table elsewhere", derived=RIGHT)
    assert outside.decide(PRINTED).claimed == Kind.EXTERNAL
    assert outside.decide(read(r"K = \frac{2b}{T}")).claimed == Kind.MISPRINT
    assert Settlement(external="on a table elsewhere").decide(PRINTED).claimed == Kind.EXTERNAL


# -- misprints ----------------------------------------------------------------------------

DERIVED = (Eq(K, 2 * b / T),)


def test_misprint_has_a_counterexample_and_a_correction():
    grounds = Settlement(derived=DERIVED, corrected=(r"K = \frac{2b}{T}",))
    verdict = grounds.decide(PRINTED)
    assert verdict.claimed == Kind.MISPRINT
    assert not verdict
    at = {sp.Symbol(n): sp.sympify(v) for n, v in verdict.counterexample.items()}
    assert PRINTED[0].subs(at) != DERIVED[0].subs(at)
    assert verdict.corrected_latex == r"K = \frac{2b}{T}"


def test_what_is_no_slip_of_the_pen_is_refuted():
    assert Settlement(derived=DERIVED, misprint=False).decide(PRINTED).claimed == Kind.REFUTED


def test_wrong_correction_is_refused():
    with pytest.raises(Unfounded, match="corrected"):
        Settlement(derived=DERIVED, corrected=(r"K = \frac{3b}{T}",)).decide(PRINTED)


def test_disagreeing_units_are_noted():
    printed = read(r"K = b + \frac{b}{T}")
    verdict = Settlement(derived=DERIVED).decide(printed)
    assert "units disagree" in verdict.note


def test_false_statement_in_words_needs_a_counterexample():
    grounds = Settlement(proofs=("seen",), corrected=("K = B",))
    with pytest.raises(Unfounded):
        grounds.decide(())


# -- conditions ---------------------------------------------------------------------------

# |K| = K is right for K >= 0 only; at K = -1 it says 1 = -1.
MAGNITUDE = Settlement(derived=(Eq(B, sp.Abs(K)),), provided="K>=0", unless={K: -S.One}, truth=(K,))
ABSOLUTE = read("B = |K|")


def test_condition_with_a_counterexample_qualifies():
    verdict = MAGNITUDE.decide(ABSOLUTE)
    assert verdict.claimed == Kind.QUALIFIED
    assert not verdict
    assert verdict.condition == "K>=0"
    assert verdict.counterexample == {"K": "-1"}


def test_condition_does_not_save_a_wrong_form():
    assert MAGNITUDE.decide(read("B = |2K|")).claimed not in PASSING


UNFOUNDED = {
    "no counterexample": {"unless": None},
    "nothing differs there": {"unless": {K: S.One}},
    "no truth beside it": {"truth": None},
    "truth that agrees": {"truth": (sp.Abs(K),)},
    "truth that differs by nothing": {"truth": (-K * (sin(1) ** 2 + cos(1) ** 2),)},
}


@pytest.mark.parametrize("name", UNFOUNDED)
def test_unfounded_counterexample_is_refused(name):
    fields = {
        "derived": MAGNITUDE.derived,
        "provided": MAGNITUDE.provided,
        "unless": MAGNITUDE.unless,
        "truth": MAGNITUDE.truth,
    } | UNFOUNDED[name]
    with pytest.raises(Unfounded):
        Settlement(**fields).decide(ABSOLUTE)


def test_value_and_truth_of_different_kinds_show_nothing():
    # the print gives the number 1, the "truth" is that 1 > 0: no contradiction
    grounds = Settlement(derived=(Eq(y, x),), provided="c", unless={x: S.One}, truth=(x > 0,))
    with pytest.raises(Unfounded):
        grounds.decide((Eq(y, x),))


def relation_settled(unless, truth):
    printed = read("K > B")
    return Settlement(derived=(K > B,), provided="c", unless=unless, truth=truth).decide(printed)


def test_relation_and_truth_must_disagree():
    at = {K: S.One, B: S.Zero}
    with pytest.raises(Unfounded):
        relation_settled(at, (K > 0,))
    assert relation_settled(at, (K < 0,)).claimed == Kind.QUALIFIED


def test_fact_may_contradict_a_relation():
    # x^2 - x + 1/2 = (x - 1/2)^2 + 1/4
    square = assume((x - Rational(1, 2)) ** 2, strict=False)
    never = combined(x**2 - x + Rational(1, 2), [square], [Rational(1, 4)])
    at = {K: S.One, B: S.Zero}
    truth = (-(x**2) + x - Rational(1, 2) > 0, never)
    assert relation_settled(at, truth).claimed == Kind.QUALIFIED
    with pytest.raises(Unfounded):
        relation_settled(at, (x > 0, never))
    with pytest.raises(Unfounded):
        relation_settled(at, number(pi))


def test_counterexample_to_words_must_fail():
    grounds = {"proofs": ("seen",), "provided": "c", "unless": {x: S.One}}
    with pytest.raises(Unfounded):
        Settlement(**grounds, truth=(Eq(x, 1, evaluate=False),)).decide(())
    verdict = Settlement(**grounds, truth=(Eq(x, 2, evaluate=False),)).decide(())
    assert verdict.claimed == Kind.QUALIFIED


# -- constants ----------------------------------------------------------------------------


def constant(value, how, digits):
    return Settlement(values=(value,), quoted=(Quoted(how, digits),)).decide(())


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
    assert constant(value, how, digits).claimed == kind


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
    assert verdict.claimed == Kind.ENCLOSED
    assert verdict.note == f"{digits} is {says}"


def test_exponent_marks_the_last_digit_that_counts():
    assert constant(pi**2 * 1000, "about", "1e4").claimed == Kind.ENCLOSED  # 9869.6
    assert constant(pi**2 * 1000, "about", "10e3").claimed == Kind.ENCLOSED
    assert constant(pi**2 * 1000, "about", "10000").claimed == Kind.REFUTED


def test_every_quoted_number_must_hold():
    two = (Quoted("above", "17.8"), Quoted("below", "0.0562"))
    ratio = Rational(1783, 100)
    assert Settlement(values=(ratio, 1 / ratio), quoted=two).decide(()).claimed == Kind.ENCLOSED
    wrong = (two[0], Quoted("below", "0.056"))
    assert Settlement(values=(ratio, 1 / ratio), quoted=wrong).decide(()).claimed == Kind.REFUTED
    with pytest.raises(Unfounded):
        Settlement(values=(ratio,), quoted=two).decide(())


def test_a_number_does_not_save_a_wrong_formula():
    grounds = {"values": (pi,), "quoted": (Quoted("about", "3.14"),)}
    assert Settlement(derived=RIGHT, **grounds).decide(PRINTED).claimed == Kind.ENCLOSED
    wrong = Settlement(derived=(Eq(K, 2 * b / T),), **grounds)
    assert wrong.decide(PRINTED).claimed == Kind.MISPRINT


def test_constant_needs_the_printed_number():
    with pytest.raises(Unfounded):
        Settlement(values=(pi,)).decide(())


def test_what_rests_on_words_is_argued():
    """A statement in words is compared with nothing, and nobody reads a condition in LaTeX."""
    verdict = Settlement(proofs=("seen",)).decide(())
    assert (verdict.kind, verdict.claimed) == (Kind.ARGUED, Kind.PROVED)
    assert not verdict
    assert str(verdict).startswith("argued (proved)")

"""What a held force does: each rule works once, and says no where a hypothesis is missing."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy import I, Integer, Ne, Rational, S, exp, pi, sin, symbols

from symhaptic.model.plant import Plant
from symhaptic.notation import X, d, s, t, z
from symhaptic.notation.proposition import (
    FALSE,
    ForAll,
    Not,
    Predicate,
    Relation,
    implied,
    proposition,
    whole,
)
from symhaptic.notation.terms import NoTerm
from symhaptic.proof.theorems.axioms import answers, transfer
from symhaptic.proof.theorems.familiar import (
    amplified,
    in_units,
    shifted,
)
from symhaptic.proof.theorems.judge import Case
from symhaptic.proof.theorems.kernel import NotShown, assume, conj, inst, mp, spec
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.theorems.roots import degree, not_of_degree
from symhaptic.proof.theorems.samples import (
    held_answer,
    one_answer,
    turns,
)
from symhaptic.proof.theorems.tactics import closed, fact

x, y, m, b, k, T = symbols("x y m b k T")
FREE = (1, 0, 0)


def motion(device):
    mass, damping, stiffness = device
    plant = Plant(S(mass), damping or None, stiffness or None)
    return (*plant.transition(t), *plant.held(t))


def law(device=FREE, delay=(0, 0), forms=None, at=z, found=X):
    return held_answer(device, delay, s, at, found, forms or motion(device), t)


# -- the answer to a held force -------------------------------------------------------------


def test_a_free_mass_answers_as_newton_says() -> None:
    """Held for a second, 1 N moves 1 kg by 1/2 m: (z + 1)/(2 (z - 1)^2) at z = 2."""
    given = law(at=S(2), found=Rational(3, 2))
    steps = [fact(p) for p in given.conclusion.of[1].of]
    found = closed(mp(given, conj(*steps)), fact(whole(S.Zero)))
    assert not found.hypotheses
    assert found.conclusion == answers(1 / s**2, s, 2, Rational(3, 2), 1)


def test_a_late_force_moves_it_as_newton_says() -> None:
    """Pushed from 1/2 to 3/2: x_1 = 1/8, then x_k = k - 1; at z = 4 their sum is 1/32 + 1/9."""
    given = law(delay=(0, S.Half), at=Integer(4))
    _, apart, equation = given.conclusion.of[1].of
    assert equation.right / apart.left == Rational(1, 32) + Rational(1, 9)


@pytest.mark.parametrize("place", range(6))
def test_another_motion_is_refused(place) -> None:
    for device in (FREE, (1, 1, 0), (2, 0, 3), (1, 2, 1), (m, b, k)):
        forms = list(motion(device))
        forms[place] += t * (1 - t)
        with pytest.raises(NotShown):
            law(device, forms=forms)


def test_the_motion_of_another_device_is_refused() -> None:
    for device, other in (((1, 1, 0), FREE), ((1, 0, 1), (1, 0, 2)), ((2, 0, 0), FREE)):
        with pytest.raises(NotShown):
            law(device, forms=motion(other))


def test_a_motion_that_begins_elsewhere_is_refused() -> None:
    """exp(A (t + 1)) obeys the equation, too, and is not the identity at 0."""
    forms = [f.subs(t, t + 1) for f in motion(FREE)]
    with pytest.raises(NotShown):
        law(forms=forms)


def test_what_the_motion_divides_by_is_a_hypothesis() -> None:
    found = law((m, b, k)).hypotheses
    split = b**2 / m**2 - 4 * k / m
    assert proposition(Ne(m, 0)) in found
    assert proposition(Ne(split, 0)) in found
    assert whole(S.Zero) in found


def test_a_massless_or_changing_device_is_refused() -> None:
    for device in ((0, 1, 0), (t, 0, 0), (1, t, 0)):
        with pytest.raises((NotShown, NoTerm)):
            held_answer(device, (0, 0), s, z, X, motion(FREE), t)


def test_a_motion_in_steps_is_refused() -> None:
    forms = list(motion(FREE))
    for strange in (sp.Abs(t), sp.re(t), sp.Function("f")(t), sin(pi / t)):
        with pytest.raises(NotShown):
            law(forms=[strange, *forms[1:]])


TURNS = sp.log(exp(4 * I * t)) - 4 * I * t
"""0 up to t = pi/4 and -2 pi j from there on: its slope is 0 wherever it has one."""


@pytest.mark.parametrize("jump", [TURNS, sp.sqrt(exp(4 * I * t)) * exp(-2 * I * t) - 1])
def test_a_motion_that_jumps_is_refused(jump) -> None:
    """A step t -> t^2/2 - 2 pi j has the slopes of the motion, and would be a second answer."""
    forms = list(motion(FREE))
    with pytest.raises(NotShown):
        law(forms=[*forms[:4], forms[4] + jump, forms[5]])


def test_the_fraction_of_a_delay_lies_within_a_period() -> None:
    found = law(delay=(d, x)).hypotheses
    assert {whole(d), proposition(x >= 0), proposition(x <= 1)} <= found
    with pytest.raises(NotShown):
        law(delay=(0, I / 2))
    with pytest.raises(NotShown):
        fact(next(h for h in law(delay=(0, Integer(2))).hypotheses if h == Relation(2, "<=", 1)))


def test_the_laplace_variable_is_bound() -> None:
    for at, found in ((s, X), (z, s)):
        with pytest.raises((NotShown, NoTerm)):
            law(at=at, found=found)


def test_terms_do_not_meet_the_bound_laplace_variable() -> None:
    for rule, last in ((in_units, (2, 1)), (shifted, d), (amplified, y)):
        one, _ = rule(FREE, 0, s, X, T, last).conclusion.of
        assert one.of[1] == s  # the force turns by s, which is not what 1/s^2 has
        assert one.over[0] != s


# -- units, delays, gains -------------------------------------------------------------------


def test_units_are_positive_and_real() -> None:
    found = in_units((m, b, k), 0, z, X, T, (T, m))
    assert {proposition(T > 0), proposition(Ne(m, 0))} <= found.hypotheses
    for unit in (I, z):
        there = in_units((m, b, k), 0, z, X, T, (unit, m))
        assert Relation(S.Zero, "<", unit) in there.hypotheses
    assert Relation(0, "<", 0) in in_units((m, b, k), 0, z, X, T, (0, m)).hypotheses


def test_units_of_time_and_force() -> None:
    """1 on 4 for 2, in units of 2 of time and 1 of stiffness: a mass of 1 for a period of 1."""
    there = in_units((4, 0, 0), 0, z, X, 2, (2, 1)).conclusion.of[1]
    assert there == answers(1 / s**2, s, z, X, 1)


def test_whole_periods_only() -> None:
    assert shifted(FREE, 0, z, X, T, d).hypotheses == {whole(d)}
    half = shifted(FREE, 0, z, X, 1, S.Half)
    with pytest.raises(NotShown):
        closed(half, fact(whole(S.Half)))


def test_a_gain_is_not_zero() -> None:
    assert proposition(Ne(y, 0)) in amplified(FREE, 0, z, X, T, y).hypotheses
    with pytest.raises((NotShown, NoTerm)):
        amplified(FREE, 0, z, X, T, exp(-s))


def test_one_answer_is_of_one_device_one_force_and_one_period() -> None:
    one = assume(answers(transfer(FREE, 0, s), s, z, X, T))
    same = assume(answers(transfer(FREE, 0, s), s, z, y, T))
    assert one_answer(one, same).conclusion == Relation(X, "=", y)
    for other in (
        answers(transfer((2, 0, 0), 0, s), s, z, y, T),
        answers(transfer(FREE, T, s), s, z, y, T),
        answers(transfer(FREE, 0, s), s, 2 * z, y, T),
        answers(transfer(FREE, 0, s), s, z, y, 2 * T),
        Not((answers(transfer(FREE, 0, s), s, z, y, T),)),
    ):
        with pytest.raises(NotShown):
            one_answer(one, assume(other))
    assert turns(one).conclusion == Relation(z, "!=", S.Zero)
    with pytest.raises(NotShown):
        turns(assume(x > 0))


# -- degree ---------------------------------------------------------------------------------


def test_the_leading_coefficient_is_a_hypothesis() -> None:
    found = degree(x * z ** (d + 2) + z, z, d + 2)
    assert {proposition(Ne(x, 0)), whole(d), whole(d + 2)} <= found.hypotheses
    for polynomial, power in (
        (z**2 + z ** (d + 1), S(2)),
        (z**2 + z, S.One),
        (z**2, S(3)),
        (z ** (d + 1) - z ** (1 + d), d + 1),
        (exp(z), S.One),
        (1 / z + z**2, S(2)),
    ):
        with pytest.raises(NotShown):
            degree(polynomial, z, power)


def test_no_degree_only_for_what_is_seen() -> None:
    for polynomial, power in ((z ** Rational(5, 2) + z, S.One), (z**2, S(3)), (S.Zero, S.Zero)):
        claim = Predicate("degree", (z,), (polynomial, power))
        assert not_of_degree(polynomial, z, power).conclusion == Not((claim,))
    for polynomial, power in (
        (z**2 + z, S(2)),
        (x * z**2, S(2)),
        ((x - y) * z ** Rational(5, 2) + z, S.One),
        ((sin(1) ** 2 + sp.cos(1) ** 2 - 1) * z ** Rational(5, 2) + z, S.One),
        (z**d, S.One),
    ):
        with pytest.raises(NotShown):
            not_of_degree(polynomial, z, power)


# -- where a print divides by zero ----------------------------------------------------------


def test_a_relation_is_false_where_a_side_has_no_value() -> None:
    assert Relation(1 / x, "=", 1 / x).at({x: S.Zero}) == FALSE
    assert Not((Relation(x, "<", 1 / x),)).at({x: S.Zero}) == Not((FALSE,))


def test_zero_to_an_unknown_power_may_have_a_value() -> None:
    """0^-y is 0 at y = -1: nothing is said before y is a number."""
    open_ = Relation(x**-y, "=", S.Zero).at({x: S.Zero})
    assert open_ != FALSE
    assert open_.at({y: -S.One}) == Relation(0, "=", 0)
    assert open_.at({y: S.One}) == FALSE
    assert Relation(x**-y, "=", S.Zero).at({x: S.Zero, y: -S.One}) == Relation(0, "=", 0)


def test_a_divisor_that_is_lost_is_no_proof() -> None:
    """1/(1 + 1/x) has no value at 0, though SymPy says 0."""
    claim = assume(ForAll((x,), Relation(1 / (1 + 1 / x), "=", x)))
    found = spec(claim, {x: S.Zero})
    assert FALSE in found.hypotheses or Relation(0, "!=", 0) in found.hypotheses


def test_a_power_is_kept_by_its_base_only() -> None:
    """1/(x^2 + y) is not 1/x^2 where y is 0 unless x is not 0 there.

    The symbols are this test's own: a term x/(x + 0) that was read before stays as it was written.
    """
    x, y = symbols("x_here y_here")
    claim = assume(Relation(1 / (x**2 + y), "=", x))
    assert proposition(Ne(x**2, 0)) not in inst(claim, {y: S.Zero}).hypotheses
    lost = inst(assume(Relation(x * (x + y) / (x + y * 1), "=", x)), {y: S.Zero})
    assert proposition(Ne(x, 0)) not in lost.hypotheses  # SymPy cancelled before: never a divisor
    lost = inst(assume(Relation(x / (x + y), "=", 1)), {y: S.Zero})
    assert proposition(Ne(x, 0)) in lost.hypotheses


def test_a_claim_is_refuted_at_its_own_point_only() -> None:
    claim = ForAll((x,), implied([x >= 0], Relation(x / x**2, "=", 1 / x)))
    there = Case({x: S.Zero}, number(Relation(0, "<=", 0)))
    assert there.refutes(claim)
    assert not Case({x: S.One}, number(Relation(0, "<=", 1))).refutes(claim)
    outside = ForAll((x,), implied([x > 0], Relation(x / x**2, "=", 1 / x)))
    assert not Case({x: S.Zero}, number(Relation(0, "<=", 0))).refutes(outside)


def test_complex_numbers_differ_by_a_ball() -> None:
    assert number(Relation(2 * I * pi, "!=", S.Zero)).conclusion.sign == "!="
    with pytest.raises(NotShown):
        number(Relation(exp(I * pi) + 1 + I - I, "!=", S.Zero))

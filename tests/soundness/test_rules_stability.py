"""Rules on zeros inside the circle: each hypothesis that is dropped or weakened is refused."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import sympy as sp
from chapters import chapter
from scipy.signal import cont2discrete
from sympy import Function, Rational, S, symbols

from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.model import plant
from symhaptic.model.parts import FULL
from symhaptic.notation import alpha, beta, d, delta, gamma, z
from symhaptic.notation.proposition import And, Exists, Iff, Implies, Predicate, Relation, whole
from symhaptic.proof.theorems.definitions import loop_substituted
from symhaptic.proof.theorems.familiar import axiom, device_static, loop_late
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.roots import (
    degree,
    first_minors,
    jury,
    last_coefficient,
    opposite,
    outpaces,
    zero_on_circle,
)
from symhaptic.proof.verdict import Unfounded

x, y, n, p, s = symbols("x y n p q")
NAMES = symbols("n_1 n_0 a e")
LOOP = (alpha, beta, gamma, delta, d)


def stable(polynomial):
    return Predicate("stable", (z,), (sp.sympify(polynomial),))


# -- the product of the zeros ----------------------------------------------------------------


def test_the_last_coefficient_is_the_product_of_the_zeros():
    found = last_coefficient(assume(stable(z**2 + x * z + y)))
    assert found.conclusion == And((Relation(-S.One, "<", y), Relation(y, "<", S.One)))
    assert found.hypotheses == {stable(z**2 + x * z + y)}


def test_of_a_whole_power_with_a_symbol_it_is_a_hypothesis_that_it_is_whole():
    found = last_coefficient(assume(stable(z ** (n + 2) + x * z ** (n + 1) + y)))
    assert whole(n) in found.hypotheses


@pytest.mark.parametrize(
    "polynomial",
    [
        2 * z**2 + y,  # not monic
        x * z**2 + y,
        z**0 + y,  # no zero
        y + 0 * z,
        z**n + y,  # for n = 0 there is no zero
        z ** (n + 1) + x * z**n + y,  # for n = 0 the last coefficient is x + y
        z**n + z ** (n + 1) + y + z**p,  # which power is the highest?
        z ** (2 - n) + y,
        z**2 + z**-1 + y,
        z**2 + sp.I * y,  # not real
        z**2 + sp.sqrt(y),
        z**2 + sp.exp(z) + y,
    ],
)
def test_what_is_not_monic_real_and_a_polynomial_is_refused(polynomial):
    with pytest.raises(NotShown):
        last_coefficient(assume(stable(polynomial)))


def test_the_product_needs_zeros_inside():
    with pytest.raises(NotShown):
        last_coefficient(assume(Relation(x, "<", y)))
    with pytest.raises(NotShown):
        last_coefficient(assume(Predicate("whole", (), (x,))))


def test_below_the_last_coefficient_there_is_only_a_power():
    found = last_coefficient(assume(stable(z ** (n + 3) + x * z ** (n + 1))), n + 1)
    assert found.conclusion == And((Relation(-S.One, "<", x), Relation(x, "<", S.One)))
    for polynomial in (z ** (n + 3) + y * z**n + x * z ** (n + 1), z ** (n + 3) + x * z ** (p + 1)):
        with pytest.raises(NotShown):
            last_coefficient(assume(stable(polynomial)), n + 1)
    with pytest.raises(NotShown):
        last_coefficient(assume(stable(z**3 + x * z**3)), 3)


# -- Jury --------------------------------------------------------------------------------------


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5])
def test_jurys_inequalities_say_where_the_zeros_of_random_polynomials_lie(degree):
    rng = np.random.default_rng(degree)
    names = symbols(f"u_0:{degree}")
    found = jury(z**degree + sum(c * z**i for i, c in enumerate(names)), z)
    assert found.hypotheses == frozenset()
    inside, wanted = found.conclusion.of
    assert isinstance(found.conclusion, Iff)
    assert inside == stable(z**degree + sum(c * z**i for i, c in enumerate(names)))
    sides = sp.lambdify(names, [r.right for r in wanted.of])
    assert all((r.left, r.sign) == (0, "<") for r in wanted.of)
    seen = set()
    for _ in range(400):
        zeros = list(rng.uniform(-1.15, 1.15, degree % 2))
        while len(zeros) < degree:
            pair = rng.uniform(0.4, 1.15) * np.exp(1j * rng.uniform(0, np.pi))
            zeros += [pair, pair.conjugate()] if rng.random() < 0.7 else [*rng.uniform(-1.1, 1, 2)]
        largest = np.abs(zeros).max()
        if abs(largest - 1) < 1e-3:
            continue  # too near for rounding
        falling = np.poly(zeros).real
        seen.add(largest < 1)
        assert (min(sides(*falling[:0:-1])) > 0) == (largest < 1)
    assert seen == {True, False}


@pytest.mark.parametrize(
    "polynomial",
    [
        2 * z**2 + y,
        x * z**2 + y,
        S(1),
        z**n + y,
        z**2 + sp.I * y,
        z**2 + sp.sqrt(y) * z,
        z**2 + 1 / z,
        z**2 + sp.sin(z),
    ],
)
def test_jury_refuses_what_is_not_monic_real_and_of_a_known_degree(polynomial):
    with pytest.raises(NotShown):
        jury(polynomial, z)


# -- a delay of p/(s + 1) periods -----------------------------------------------------------------


def test_a_loop_with_a_fractional_delay_has_its_polynomial_in_a_root_of_z():
    found = loop_late(NAMES, LOOP, (p, s))
    claim = found.conclusion
    assert isinstance(claim, Implies)
    assert claim.of[0] == Predicate("stable_substituted", (), LOOP)
    assert isinstance(claim.of[1], Exists)
    late, count, ratio, zeros = claim.of[1].body.of
    assert (late, count) == (whole(p), whole(s))
    assert ratio == Relation(d * (s + 1), "=", p)
    n_1, n_0, a, e = NAMES
    for d_, p_, s_ in ((0, 0, 0), (2, 2, 0), (Rational(3, 2), 3, 1), (Rational(2, 3), 2, 2)):
        at = zeros.of[0].subs({p: p_, s: s_, d: d_})
        w = z ** (s_ + 1)
        loop = w * (w**2 - a * w + e) * z**p_ + (n_1 * w + n_0) * ((alpha + beta) * w - beta)
        assert sp.expand(at - loop) == 0
    assert Predicate("device", (), (gamma, delta, *NAMES)) in found.hypotheses


def test_names_of_a_fraction_are_new():
    for names in ((p, p), (d, s), (p, z), (p, NAMES[0]), (p,)):
        with pytest.raises(NotShown):
            loop_late(NAMES, LOOP, names)
    with pytest.raises(NotShown):
        loop_late(NAMES, (z, *LOOP[1:]), (p, s))


def test_every_fraction_that_is_the_delay_gives_the_polynomial_of_the_papers_reading():
    """Of 1/2 = 2/4, too; beside the definition, which is made of a number q and other code."""
    for over, under in ((0, 1), (2, 1), (1, 2), (3, 2), (2, 4)):
        late = Rational(over, under)
        found = axiom("loop in w", *LOOP[:-1], late, *NAMES, over, under - 1)
        device = Predicate("device", (), (gamma, delta, *NAMES))
        assert device in found.hypotheses
        assert {p.name for p in found.hypotheses if isinstance(p, Predicate)} == {"device", "whole"}
        reading, zeros = found.conclusion.of
        assert reading == Predicate("stable_substituted", (), (*LOOP[:-1], late))
        defined = loop_substituted((*LOOP[:-1], late), z, under)
        numbers = plant.sampled(plant.normalised(FULL))
        same = dict(zip(NAMES, (numbers.n1, numbers.n0, numbers.a, numbers.e), strict=True))
        at = {alpha: 0.3, beta: 0.7, gamma: 0.4, delta: 0.5, z: 0.8 + 0.3j}
        ours = complex(zeros.of[0].subs(same).subs(at))
        assert ours == pytest.approx(complex(defined.conclusion.of[1].of[0].subs(at)), abs=1e-12)


def test_a_period_has_a_whole_share():
    late = (*LOOP[:-1], Rational(2, 5))
    for share in (0, -1, -2):
        with pytest.raises(NotShown, match="no share of a period"):
            loop_substituted(late, z, share)
    # 5/2 of it is none: two are taken in the polynomial and in the hypothesis
    half = loop_substituted(late, z, Rational(5, 2))
    assert whole(Rational(4, 5)) in half.hypotheses
    assert whole(1) not in half.hypotheses


def test_a_fraction_that_is_not_the_delay_gives_no_polynomial():
    found = axiom("loop in w", *LOOP, *NAMES, p, s)
    assert Relation(d * (s + 1), "=", p) in found.hypotheses
    assert {whole(p), whole(s)} <= found.hypotheses
    with pytest.raises(NotShown):
        axiom("loop in w", *LOOP[:-1], z, *NAMES, p, s)


def test_a_device_at_rest_is_balanced_by_its_spring():
    n_1, n_0, a, e = NAMES
    device = Predicate("device", (), (gamma, delta, *NAMES))
    found = device_static(assume(device))
    assert found.hypotheses == {device}
    assert found.conclusion == Relation(1 - a + e, "=", gamma * (n_1 + n_0))
    for g, dl in ((0.0, 0.0), (0.0, 0.4), (2.0, 0.0), (4.0, 4.0), (39.4, 0.1)):
        top, (_, a1, a0), _ = cont2discrete(([1.0], [1.0, dl, g]), 1.0, method="zoh")
        _, b1, b0 = top[0]
        assert abs(1 + a1 + a0 - g * (b1 + b0)) < 1e-12
    with pytest.raises(NotShown):
        device_static(assume(whole(n)))


def test_an_undamped_device_swings_and_its_numerator_is_even():
    n_1, n_0, a, _ = NAMES
    device = Predicate("device", (), (x**2, 0, *NAMES))
    found = axiom("undamped device", x, *NAMES)
    assert found.hypotheses == {device}
    assert found.conclusion == And(
        (Relation(a, "=", 2 * sp.cos(x)), Relation(n_1, "=", n_0)),
    )
    for turn in (0.0, 0.3, 1.9, 3.1, 7.0):
        top, (_, a1, _), _ = cont2discrete(([1.0], [1.0, 0.0, turn**2]), 1.0, method="zoh")
        _, b1, b0 = top[0]
        assert abs(-a1 - 2 * np.cos(turn)) < 1e-12
        assert abs(b1 - b0) < 1e-12
    # with damping neither is true
    top, (_, a1, _), _ = cont2discrete(([1.0], [1.0, 0.4, 0.09]), 1.0, method="zoh")
    assert abs(-a1 - 2 * np.cos(0.3)) > 0.1
    assert abs(top[0][1] - top[0][2]) > 0.01


@pytest.mark.parametrize("delay", [0, 1, 2])
def test_loops_are_stable_where_jurys_inequalities_hold(delay):
    """The lemma beside eigenvalues; the device's numbers are SciPy's."""
    found = by_inequalities(delay)
    assert found.hypotheses == {Predicate("device", (), (gamma, delta, *NAMES))}
    reading, wanted = found.conclusion.of
    assert reading == Predicate("stable_substituted", (), (*LOOP[:-1], S(delay)))
    sides = sp.lambdify((alpha, beta, *NAMES), [r.right for r in wanted.of])
    rng, seen = np.random.default_rng(delay), set()
    for _ in range(300):
        g, dl = rng.uniform(0, 4), rng.uniform(0, 2)
        top, (_, a1, a0), _ = cont2discrete(([1.0], [1.0, dl, g]), 1.0, method="zoh")
        wall = rng.uniform(-1, 1.5), rng.uniform(-1.5, 2)
        loop = np.concatenate([[1.0, a1, a0], np.zeros(delay + 1)])
        loop[-3:] += np.convolve(top[0][1:], [sum(wall), -wall[1]])
        largest = np.abs(np.roots(loop)).max()
        if abs(largest - 1) > 1e-3:  # farther than rounding
            seen.add(largest < 1)
            assert (min(sides(*wall, *top[0][1:], -a1, a0)) > 0) == (largest < 1)
    assert seen == {True, False}


# -- what holds instead -------------------------------------------------------------------------


def test_words_for_a_reader_stand_beside_a_theorem_and_not_in_its_place():
    page = chapter("s4d_parts_delay").page
    settled = page.settled["s4d-delay-shrinks"]
    assert "lower with every period" in settled.verdict.corrected
    settlement = settled.settlement
    judged = settlement.judged
    for wrong in (
        dataclasses.replace(judged, instead=None),  # words alone correct nothing
        dataclasses.replace(judged, instead=settlement.claim(())),
        dataclasses.replace(judged, unless=()),
    ):
        with pytest.raises((Unfounded, ValueError)):
            dataclasses.replace(settlement, judged=wrong).decide(())


@pytest.mark.parametrize("power", [2**n, Function("f")(n), sp.sqrt(n), n**y, 1 / n])
def test_of_a_power_that_cannot_be_told_nothing_is_said(power):
    inside = assume(stable(z**power + x))
    for ask in (
        lambda: last_coefficient(inside),
        lambda: degree(z**power + x, z, power),
        lambda: first_minors(inside, 1),
        lambda: outpaces(inside, y),
        lambda: opposite(inside),
    ):
        with pytest.raises(NotShown):
            ask()
    with pytest.raises(NotShown):
        zero_on_circle(z ** (2**n) + x, z, y, assume(Relation(y, "=", S.Zero)))

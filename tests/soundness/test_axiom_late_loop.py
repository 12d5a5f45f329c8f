"""A loop that is late by a fraction: the axioms beside motions of the state, in both parts."""

import numpy as np
import pytest
import sympy as sp
from oracles import motion

from symhaptic.book.lemmas.late_loop import GIVEN, POLYNOMIAL
from symhaptic.notation import a, alpha, beta, delta, e, epsilon, gamma, l, theta, z
from symhaptic.notation.proposition import Relation, conjuncts
from symhaptic.proof.theorems.axioms import AXIOMS, DEVICE, LATE_DEVICE, LATE_NUMBERS, NUMBERS
from symhaptic.proof.theorems.familiar import axiom
from symhaptic.proof.theorems.kernel import NotShown

PLANTS = [(0.0, 0.0), (0.0, 0.7), (0.0625, 0.5), (2.0, 0.3), (30.0, 0.1), (-0.4, 0.2)]


def numbers(stiffness, damping, part=None):
    """n_1, n_0, a and e, and with a part m_2, m_1 and m_0, as the predicates define them."""
    phi, held = motion.held(1.0, damping, stiffness, 1.0)
    found = {"a": np.trace(phi), "e": np.linalg.det(phi)}
    found |= {"n_1": held[0], "n_0": phi[0, 1] * held[1] - phi[1, 1] * held[0]}
    if part is not None:
        after, new = motion.held(1.0, damping, stiffness, 1 - part)
        old = after @ motion.held(1.0, damping, stiffness, part)[1]
        found["m_2"] = new[0]
        found["m_1"] = phi[0, 1] * new[1] - phi[1, 1] * new[0] + old[0]
        found["m_0"] = phi[0, 1] * old[1] - phi[1, 1] * old[0]
    return found


def holds(claim, at):
    left, right = (complex(side.subs(at)) for side in claim.terms)
    return left == pytest.approx(right, abs=1e-12)


def test_all_that_is_asked_for_is_a_hypothesis():
    values = (alpha, beta, gamma, delta, l, epsilon, *LATE_NUMBERS, a, e)
    assert axiom("loop of a late device", *values).hypotheses >= {*GIVEN, LATE_DEVICE}
    numbers_ = axiom("late device and device", gamma, delta, epsilon, *LATE_NUMBERS, *NUMBERS)
    assert numbers_.hypotheses == {LATE_DEVICE, DEVICE}
    assert axiom("late device", gamma, delta, epsilon).hypotheses == set(GIVEN[1:])
    with pytest.raises(NotShown):
        axiom("loop of a late device", sp.I, *values[1:])


@pytest.mark.parametrize("plant", PLANTS)
def test_numbers_of_a_late_device_and_of_the_device(plant):
    total, *ends = AXIOMS["late device and device"].says.body.of[1].of
    for part in (0.0, 0.2, 0.9, 1.0):
        at = numbers(*plant, part)
        assert holds(total, at)
        for end in ends:
            given, then = end.of
            met = {"epsilon": part} | at
            assert not holds(given, met) or all(holds(c, met) for c in conjuncts(then))
    assert any(not holds(c, numbers(*plant, 0.5)) for c in conjuncts(ends[0].of[1]))


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("late", [0.0, 0.3, 1.5, 2.9])
def test_samples_of_a_loop_obey_the_recurrence_of_its_polynomial(plant, late):
    """Any motion does, once all forces are under way; of the wrong delay it does not."""
    stiffness, damping = plant
    wall = {alpha: 0.4, beta: -0.1}
    place = motion.positions(0.4, -0.1, b=damping, k=stiffness, late=late, steps=30)

    def left(whole, part):
        at = {l: whole, epsilon: part, **wall, **numbers(stiffness, damping, part)}
        polynomial = POLYNOMIAL.subs(at).expand()
        falling = [complex(polynomial.coeff(z, n)).real for n in range(whole + 4, -1, -1)]
        return np.abs(np.convolve(place[5:], falling, "valid")).max() / np.abs(place).max()

    whole = int(late)
    assert left(whole, late - whole) < 1e-12
    assert left(whole, (late - whole + 0.4) % 1) > 1e-6


def test_the_axiom_is_about_this_polynomial():
    values = (alpha, beta, gamma, delta, l, epsilon, *LATE_NUMBERS, a, e)
    reading, zeros = axiom("loop of a late device", *values).conclusion.of
    assert reading.of == (alpha, beta, gamma, delta, l + epsilon)
    assert zeros.of == (POLYNOMIAL,)


DAMPED = [(0.0, 0.7), (0.0, 9.0), (0.0625, 0.5), (2.0, 0.3), (30.0, 0.1), (90.0, 2.0)]


@pytest.mark.parametrize("plant", DAMPED)
@pytest.mark.parametrize("part", [0.04, 0.3, 0.5, 0.8])
def test_a_late_held_steady_state_burns_what_the_axiom_says(plant, part):
    """The motion that turns by z from period to period, followed from the beginning of a force."""
    claim = axiom("late held steady state", gamma, delta, epsilon, *LATE_NUMBERS, *NUMBERS, theta)
    least, work = claim.conclusion.terms
    stiffness, damping = plant
    off = part * (1 - part)
    for angle in (0.01, 0.6, 1.9, 3.0, np.pi):
        turn = np.exp(1j * angle)
        phi, held = motion.held(1.0, damping, stiffness, 1.0)
        start = np.linalg.solve(turn * np.eye(2) - phi, held)

        def state(time, start=start):
            move, push = motion.held(1.0, damping, stiffness, time)
            return move @ start + push

        p = state(1.0)[0] - start[0]
        q = state(1 - part)[0] - start[0] - (1 - part) * p
        nodes, weights = np.polynomial.legendre.leggauss(60)
        speeds = [state((1 + node) / 2)[1] for node in nodes]
        burnt = damping * (weights / 2 * np.abs(speeds) ** 2).sum()
        # work is burnt, for the store is what it was
        assert burnt == pytest.approx(p.real, rel=1e-9)
        assert damping * (abs(p) ** 2 + abs(q) ** 2 / off) < burnt * (1 + 1e-12)

        at = numbers(*plant, part)
        bottom = abs(turn**2 - at["a"] * turn + at["e"]) ** 2
        at |= {"gamma": stiffness, "delta": damping, "epsilon": part, "theta": angle}
        found = [complex(side.subs(at)) / bottom for side in (least, work)]
        assert found[0] == pytest.approx(damping * (off * abs(p) ** 2 + abs(q) ** 2), rel=1e-7)
        assert found[1] == pytest.approx(off * burnt, rel=1e-7)


def test_more_than_that_need_not_be_burnt():
    """At low frequencies the speed is nearly constant."""
    claim = axiom("late held steady state", gamma, delta, epsilon, *LATE_NUMBERS, *NUMBERS, theta)
    least, work = claim.conclusion.terms
    at = numbers(0.0, 0.7, 0.3) | {"gamma": 0.0, "delta": 0.7, "epsilon": 0.3, "theta": 1e-3}
    low, high = (complex(side.subs(at)).real for side in (least, work))
    assert low < high < 1.000001 * low


@pytest.mark.parametrize("rate", [0.3, 2 * np.pi / 3, 7.0])
@pytest.mark.parametrize("part", [0.0, 0.3, 0.5, 1.0])
def test_numbers_of_an_undamped_late_device(rate, part):
    claim = AXIOMS["undamped late device"].says.body
    at = {"x": rate, "epsilon": part, **numbers(rate**2, 0.0, part)}
    assert all(holds(c, at) for c in claim.of[1].of)
    assert not all(holds(c, at | {"epsilon": part + 0.1}) for c in claim.of[1].of)


@pytest.mark.parametrize("part", [0.0, 0.3, 0.5, 1.0])
def test_numbers_of_a_free_mass(part):
    claim = AXIOMS["free late mass"].says.body.of[1]
    at = {"epsilon": part, **numbers(0.0, 0.0, part)}
    assert all(holds(c, at) for c in claim.of)
    assert not all(holds(c, at | {"epsilon": part + 0.1}) for c in claim.of)
    assert holds(AXIOMS["free mass"].says.body.of[1], at)
    assert not holds(AXIOMS["free mass"].says.body.of[1], numbers(0.0, 0.7))


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("whole", [0, 2])
def test_zeros_on_the_principal_sheet_are_those_to_the_right(plant, whole):
    """Of the polynomial in v all zeros are tried, with z^(d+1) as NumPy has it."""
    at = numbers(*plant)
    values = (alpha, beta, gamma, delta, l, *NUMBERS)
    reading, never = axiom("half a period on the principal sheet", *values).conclusion.of
    assert (reading.name, reading.of[-1]) == ("stable_principal", l + sp.Rational(1, 2))
    (x, y), (outside, apart) = never.over, never.body.of
    assert set(conjuncts(outside)) == {Relation(0, "<", x), Relation(1, "<=", x**2 + y**2)}
    v = sp.Symbol("v")
    wall = {alpha: 0.7, beta: 0.9, l: whole}
    polynomial = apart.left.subs(wall).subs(at).xreplace({x + sp.I * y: v})
    zeros = np.roots([complex(c) for c in sp.Poly(polynomial, v).all_coeffs()])
    late = whole + 0.5
    assert len(zeros) == 2 * whole + 7
    for zero in zeros:
        z = zero**2
        bottom, top = z**2 - at["a"] * z + at["e"], at["n_1"] * z + at["n_0"]
        terms = z ** (late + 1) * bottom, top * (0.7 * z + 0.9 * (z - 1))
        small = abs(sum(terms)) < 1e-9 * (abs(terms[0]) + abs(terms[1]) + 1)
        if abs(terms[0]) > 1e-6:
            assert small == (zero.real > 0)

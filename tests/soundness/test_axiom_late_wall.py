"""A wall that is late by a fraction: the axiom beside energies of motions in two parts."""

import numpy as np
import pytest
import sympy as sp
from oracles import energy

from symhaptic.book.lemmas.late_passivity import GIVEN, passive_late
from symhaptic.notation import B, K, T, b, epsilon, l, theta
from symhaptic.proof.theorems.familiar import axiom
from symhaptic.proof.theorems.kernel import NotShown


def test_all_that_is_asked_for_is_a_hypothesis():
    assert axiom("passive late wall", K, B, b, T, l, epsilon).hypotheses >= set(GIVEN)
    assert passive_late().hypotheses == set(GIVEN)
    with pytest.raises(NotShown):
        axiom("passive late wall", sp.I, B, b, T, l, epsilon)


@pytest.mark.parametrize("late", [0.0, 0.3, 0.5, 1.7])
def test_the_angles_that_lose_energy_are_those_of_motions(late):
    _, always = passive_late().conclusion.of[1].of
    margin = always.body.of[1].right
    for stiffness, damping in ((0.4, 0.3), (1.1, -0.2), (0.0, 1.2)):
        at = {K: stiffness, B: damping, b: 1, T: 1, l: int(late), epsilon: late % 1}
        for angle in np.linspace(0.2, 3, 7):
            found = float(margin.subs(at).subs(theta, angle))
            if late % 1:
                wanted = energy.determinant(stiffness, damping, late, angle)
            else:
                z = np.exp(1j * angle)
                force = (stiffness + damping * (1 - 1 / z)) * z**-late / (z - 1)
                wanted = 1 + force.real
            assert found == pytest.approx(wanted, abs=1e-12)

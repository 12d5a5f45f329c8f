"""The plots and what is read from them rest on theorems, with the conditions that they need."""

import oracle
import pytest
from chapters import chapter
from sympy import Rational

from symhaptic.paper.propositions.plots import CURVE, THICK
from symhaptic.paper.propositions.stability import NUMBERS

SETTLED = {
    "eq27": ("s5a_normalised_boundary", "qualified"),
    "fig7": ("s4d_figure7_undelayed", "proved"),
    "s4d-gamma-invisible": ("s4d_figure7_undelayed", "proved"),
    "fig8": ("s4d_figure8_origin", "proved"),
    "s5c-shape": ("s5c_nyquist_region", "proved"),
}


@pytest.mark.parametrize("id", SETTLED)
def test_verdict_rests_on_a_theorem(id):
    name, kind = SETTLED[id]
    verdict = chapter(name).page.settled[id].verdict
    assert (verdict.kind, bool(verdict.rests)) == (kind, True)


def test_normalised_curve_bounds_up_to_its_end_for_whole_delays():
    condition = chapter("s5a_normalised_boundary").page.settled["eq27"].verdict.condition
    assert condition == r"d\in\mathbb{N}_0,\ \hat{\omega}\le\pi/(d+1)"


def test_a_line_in_fig_7_has_to_be_thicker_than_the_spring_moves_the_left_bound():
    # the claim's 0.002; the left bound alone moves by the largest gamma of (23), 0.001
    assert Rational(1, 1000) < THICK <= Rational(1, 500)
    # (0, 1) is inside the region without a spring, and 0.001 left of it the one with
    assert oracle.stable(-0.0009, 1.0, 1e-3, 0.02, 0)
    assert not oracle.stable(-0.0009, 1.0, 0.0, 0.02, 0)


def test_the_curve_of_fig_7_is_the_boundary():
    for gamma, delta in ((0.0, 0.02), (1e-3, 0.0), (1e-3, 0.02), (4e-4, 0.01)):
        numbers = oracle.named(gamma, delta)
        for beta in (0.1, 0.8, 1.7):
            alpha = float(CURVE.subs({**{s: numbers[str(s)] for s in NUMBERS}, "beta": beta}))
            assert oracle.stable(alpha - 1e-9, beta, gamma, delta, 0)
            assert not oracle.stable(alpha + 1e-9, beta, gamma, delta, 0)

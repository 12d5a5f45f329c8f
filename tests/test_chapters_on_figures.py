"""The plots and what is read from them rest on theorems, with the conditions that they need."""

import numpy as np
import oracle
import pytest
from chapters import chapter
from oracles import energy
from sympy import Rational

from symhaptic.paper.propositions.plots import CURVE, THICK
from symhaptic.paper.propositions.stability import NUMBERS

SETTLED = {
    "eq27": ("s5a_normalised_boundary", "qualified"),
    "fig7": ("s4d_figure7_undelayed", "proved"),
    "s4d-gamma-invisible": ("s4d_figure7_undelayed", "proved"),
    "fig8": ("s4d_figure8_origin", "proved"),
    "s5c-shape": ("s5c_nyquist_region", "proved"),
    "fig11": ("s5a_figure", "proved"),
    "fig13": ("s5c_robust_figure", "proved"),
    "s5c-robust-vanishes": ("s5c_robust", "proved"),
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


@pytest.mark.parametrize("gamma", [1e-3, 0.0])
def test_half_a_period_late_a_wall_may_meet_5_and_be_unstable_by_18(gamma):
    """So Figs. 11 and 13 claim nothing of (18) there.

    In zeta, z = zeta^2, (18) is zeta^3 A + N ((alpha + beta) zeta^2 - beta).
    """
    alpha, beta, delta = 0.01, 0.005, 0.02
    a, e, n_1, n_0 = (float(oracle.named(gamma, delta)[s]) for s in ("a", "e", "n_1", "n_0"))
    wall = np.polymul([n_1, 0, n_0], [alpha + beta, 0, -beta])
    roots = np.roots(np.polyadd([1, 0, -a, 0, e, 0, 0, 0], wall))
    assert np.abs(roots).max() > 1 + 1e-4
    # and (5) holds: the energy of constant turning
    assert energy.need(alpha, beta, 0.5).max() < delta

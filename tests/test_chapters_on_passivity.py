"""What the chapters on passivity say holds for half planes on a grid of frequencies.

All in units b = T = 1; the half planes are those of (5) as printed.
"""

import math

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import brentq, linprog

from symhaptic.book.chapters import folder, run
from symhaptic.paper import STATEMENTS


def half_planes(delay, angles):
    """Coefficients of K and -B in (5) as printed, after the division by its denominator."""
    below = 2 - 2 * np.cos(angles)
    stiffness = (np.cos(delay * angles) - np.cos((delay + 1) * angles)) / below
    damping = (
        np.cos(delay * angles) - 2 * np.cos((delay + 1) * angles) + np.cos((delay + 2) * angles)
    ) / below
    return stiffness, damping


def envelope(delay, angle):
    """(7) as printed."""
    below = math.sin(2 * (delay + 1) * angle) - 2 * (1 + delay) * math.sin(angle)
    up = (delay + 1) * (
        math.sin((delay + 2) * angle) - 2 * math.sin((delay + 1) * angle) + math.sin(delay * angle)
    )
    right = delay * math.sin((delay + 1) * angle) - (1 + delay) * math.sin(delay * angle)
    return 2 * up / below, 2 * right / below


ANGLES = np.linspace(0, math.pi, 40001)[1:-1]
STEP = ANGLES[1] - ANGLES[0]
DELAYS = [0.25, 0.5, 1.0, 2.7, 8.0]  # Fig. 4 has all but 2.7, which stands for any real delay


@pytest.mark.parametrize("delay", DELAYS)
def test_envelope_up_to_its_end_bounds_the_region(delay):
    stiffness, damping = half_planes(delay, ANGLES)
    for share in np.linspace(0.02, 1.0, 25):
        K, B = envelope(delay, share * math.pi / (delay + 1))
        # on the boundary: no half plane cuts the point off, and one just touches it; (7) loses
        # some 1e-10 to cancellation at small angles, where sines of third order remain
        assert (1 - stiffness * K - damping * B).min() > -1e-9
        own = half_planes(delay, np.array([share * math.pi / (delay + 1)]))
        assert abs(1 - own[0][0] * K - own[1][0] * B) < 1e-9


@pytest.mark.parametrize("delay", DELAYS)
def test_envelope_beyond_its_end_has_negative_stiffness_or_is_cut_off(delay):
    stiffness, damping = half_planes(delay, ANGLES)
    for share in (1.05, 1.2, 1.4):
        if share < delay + 1:  # inside the open interval up to Nyquist
            K, B = envelope(delay, share * math.pi / (delay + 1))
            assert K < 0 or (1 - stiffness * K - damping * B).min() < 0


@pytest.mark.parametrize("delay", DELAYS)
def test_region_for_a_given_stiffness_is_bounded_by_envelope_and_line(delay):
    stiffness, damping = half_planes(delay, ANGLES)
    top, end = math.pi / (2 * (delay + 1)), math.pi / (delay + 1)
    largest = envelope(delay, top)[0]
    start = 6 * (delay + 1) / ((2 * delay + 1) * (2 * delay + 3))  # (8) at y = 1
    for K in np.linspace(0.05, 0.95, 7) * largest:
        with np.errstate(divide="ignore"):  # an angle without a term in B does not bound B
            room = (1 - stiffness * K) / damping
        highest, lowest = room[damping > 0].min(), room[damping < 0].max()
        angle = brentq(lambda x, K=K: envelope(delay, x)[0] - K, top, end, xtol=1e-14)
        # a grid misses the strictest angle by at most half a step, and the bound by the square
        # of it times half its curvature, which is below 50 (d+1)^2 here
        slack = 50 * (delay + 1) ** 2 * STEP**2
        assert abs(highest - envelope(delay, angle)[1]) < slack
        if start < K:
            low = brentq(lambda x, K=K: envelope(delay, x)[0] - K, 1e-3 * top, top, xtol=1e-14)
            expected = envelope(delay, low)[1]
        else:
            expected = (delay + 0.5) * K - 1  # the line of (9)
        # the first angle of the grid is a step away from 0, where the line of (9) lies
        assert abs(lowest - expected) < slack
        # frequencies above pi/(d+1) cut off nothing
        inside = end >= ANGLES
        assert room[inside & (damping > 0)].min() <= highest + slack
        assert room[inside & (damping < 0)].max() >= lowest - slack


def largest_passive_stiffness(delay):
    """Largest K that fulfils (5) at every angle of the grid, for some B: a linear program."""
    stiffness, damping = half_planes(delay, ANGLES[::20])
    found = linprog(
        [-1, 0],
        A_ub=np.column_stack([stiffness, damping]),
        b_ub=np.ones(len(stiffness)),
        bounds=[(0, None), (None, None)],
        method="highs",
    )
    return found.x[0]


@pytest.mark.parametrize(
    # sqrt(2) - 1 and 2 - sqrt(3) to eight places; Sec. III-C quotes 41 % and 27 %
    ("delay", "ratio"),
    [(1, 0.41421356), (2, 0.26794919)],
)
def test_largest_passive_stiffness_by_linear_programming(delay, ratio):
    found = largest_passive_stiffness(delay) / largest_passive_stiffness(0)
    # the grid of the program has steps of 1.6e-3; their square times (d+1)^2 is 2.3e-5, and a
    # missed angle only lets the stiffness grow
    assert -1e-7 < found - ratio < 2.3e-5
    id = {1: "s3c-kmax-41", 2: "s3c-kmax-27"}[delay]
    verdict = run(folder() / "s3c_stiffness_maximum.py").page.settled[id].verdict
    assert abs(float(verdict.value) - ratio) < 5e-9  # the last of eight places


@pytest.mark.parametrize("delay", [0.25, 1.0, 3.0])
def test_largest_passive_point_is_eleven(delay):
    stiffness, damping = half_planes(delay, ANGLES)
    last = math.pi / (2 * (delay + 1))
    # (11) as printed
    K = 2 * (1 - math.cos(last)) / math.cos(delay * last)
    B = (math.sin(delay * last) - delay / (delay + 1)) / math.sin(last)
    # rounding of (11) and of the quotient in (5) at small angles
    assert (1 - stiffness * K - damping * B).min() > -1e-7
    assert pytest.approx(largest_passive_stiffness(delay), rel=1e-5, abs=0) == K


def test_undelayed_border_satisfies_the_condition():
    # s3a: K = T = B = 1, b = 3/2 = KT/2 + |B|, and yet (5) holds at every angle
    stiffness, damping = half_planes(0.0, ANGLES)
    assert (1.5 - stiffness - damping).min() > 0


@pytest.mark.parametrize(
    # counterexamples of (9) and (10): d, K, B; they fail at 5 pi/6
    ("delay", "K", "B"),
    [(1, -3.0, 0.0), (0, 2.0, 0.5)],
)
def test_counterexamples_of_the_linear_condition(delay, K, B):
    assert (1 + B) / (0.5 + delay) > K  # (9) holds
    stiffness, damping = half_planes(delay, np.array([5 * math.pi / 6]))
    assert 1 - stiffness[0] * K - damping[0] * B < 0


@pytest.mark.parametrize("delay", [0.0, *DELAYS])
def test_linear_condition_decides_in_its_range_for_positive_stiffness(delay):
    stiffness, damping = half_planes(delay, ANGLES)
    for B in np.linspace(-0.98, delay / (2 * delay + 3), 9):  # the range of (9), with b = 1
        border = (1 + B) / (0.5 + delay)
        for share, passive in ((0.01, True), (0.5, True), (0.999, True), (1.001, False)):
            worst = (1 - stiffness * share * border - damping * B).min()
            # a thousandth of the border is a margin of 2e-5 at least, at the first angles of the
            # grid; the grid's first angle is 8e-5
            assert (worst > 0) == passive


def test_normalised_boundary_is_the_physical_one_scaled():
    delay, angle, m, T, b = 1.3, 0.6, 2.0, 0.25, 0.7  # chosen
    K, B = envelope(delay, angle)  # for b = T = 1: K scales with b/T and B with b
    values = {"delta": b * T / m, "d": delay, "omega_hat": angle}
    alpha, beta = (
        sp.lambdify(list(values), e.rhs, "math")(*values.values())
        for e in STATEMENTS["eq27"].printed
    )
    # Table I; rounding only
    assert alpha == pytest.approx(K * b / T * T**2 / m, rel=1e-12, abs=0)
    assert beta == pytest.approx(B * b * T / m, rel=1e-12, abs=0)

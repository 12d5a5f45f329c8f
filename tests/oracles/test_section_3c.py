"""Ends and tips of the passive walls: energies, spectra of the worst motions, linear programmes."""

import numpy as np
import pytest
from oracles import energy
from oracles.guarding import guards
from oracles.subject import number, only, page, settled, shown
from scipy.optimize import linprog

pytestmark = pytest.mark.ci

DELAYS = (0, 1, 3)


@guards("s3c_damping_maximum")
def test_without_stiffness_the_damping_ends_at_that_of_the_device():
    b, T = 2.5, 1e-3

    def agrees(highest, lowest):
        for d in DELAYS:
            energy.bounds(0.0, number(highest, b=b), b, T, d)
            energy.bounds(0.0, number(lowest, b=b), b, T, d)

    found = settled("s3c_damping_maximum", "s3c-limit-points")
    only(agrees, found[1].rhs, found[3].rhs, by=0.05)


@guards("s3c_damping_maximum", "s3c_stiffness_maximum")
@pytest.mark.parametrize("d", [1, 2])
def test_the_worst_motion_has_the_frequency_that_is_said(d):
    T = 2e-3

    def agrees(of_damping, of_stiffness):
        # the spectrum of 150 periods has lines as wide as pi/150
        damping, stiffness = (number(f, d=d, T=T) * T for f in (of_damping, of_stiffness))
        assert energy.worst(1.0, 1.0, 1.0, T, d) == pytest.approx(damping, abs=0.03)
        K, B = best(d)
        assert energy.worst(1.02 * K / T, 1.02 * B, 1.0, T, d) == pytest.approx(stiffness, abs=0.03)

    frequencies = (
        settled("s3c_damping_maximum", "s3c-bmax-frequency")[0].rhs,
        settled("s3c_stiffness_maximum", "s3c-kmax-frequency")[0].rhs,
    )
    only(agrees, *frequencies, by=0.1)


@guards("s3c_linear_part")
@pytest.mark.parametrize("d", DELAYS)
def test_walls_on_the_straight_part_are_just_passive(d):
    b, T = 0.8, 1e-3

    def agrees(stiffness, damping):
        for y in (0.3, 0.7, 0.97):
            at = {"y": y, "d": d, "b": b, "T": T}
            energy.bounds(number(stiffness, **at), number(damping, **at), b, T, d, wide=1.05)

    only(agrees, *(e.rhs for e in settled("s3c_linear_part", "eq8")), by=0.1, kept=("y", "d"))


@guards("s3c_linear_part")
@pytest.mark.parametrize("d", [0, 1, 2, 5])
def test_walls_that_just_meet_the_condition_below_the_corner_are_on_the_line(d):
    """On rays before the corner, of walls that need the damping 1 at some angle and no more."""
    slope = d * (2 * d + 1) / (6 * (d + 1))
    rays = [slope - gap for gap in (0.05, 0.3, 1, 4)]
    walls = [w / energy.need(*w, d).max() for w in (np.array([1.0, ray]) for ray in rays)]

    def agrees(stiffness, damping):
        for K, B in walls:
            at = {"d": d, "b": 1, "T": 1}
            start, end = (number(damping, y=y, **at) for y in (0, 1))
            y = (B - start) / (end - start)
            assert 0 <= y <= 1
            # the line is met at an angle of 0; the first of the 2000 is 0.0016
            assert number(stiffness, y=y, **at) == pytest.approx(K, rel=1e-4 * (d + 1) ** 2)

    only(agrees, *(e.rhs for e in settled("s3c_linear_part", "eq8")), by=0.1, kept=("y", "d"))


@guards("s3c_linear_part_condition")
def test_damping_over_delay_is_the_limit_of_low_frequencies():
    def agrees(stiffness):
        for d, B in ((0, -0.3), (1, 0.1), (6.5, 0.25)):
            K = number(stiffness, b=1, B=B, T=1, d=d)
            # rounding of K/theta^2 at theta = 1e-4, and the next term, of order (d+1)^3 theta^2
            assert energy.need(K, B, d, np.array([1e-4]))[0] == pytest.approx(1, abs=1e-5)

    only(
        agrees,
        shown(
            "s3c_linear_part_condition",
            "Solved for the stiffness, the equation of the line is the total damping divided by "
            "the total delay",
        ),
        kept=("T",),
    )


def best(d):
    """The stiffest wall that needs no more than b = 1, T = 1: a linear programme in (K, B)."""
    angles = np.append(energy.ANGLES, np.pi / (2 * (d + 1)) + np.linspace(-1e-3, 1e-3, 41))
    rows = np.array([energy.need(1, 0, d, angles), energy.need(0, 1, d, angles)]).T
    found = linprog([-1, 0], A_ub=rows, b_ub=np.ones(len(angles)), bounds=[(0, None), (None, None)])
    return found.x


@guards("s3c_stiffness_maximum")
def test_the_stiffest_passive_wall_is_that_of_a_linear_programme():
    delays = [0.4, 1, 2, 5.5]  # without delay the damping is 0 by (6)
    found = [best(d) for d in delays]

    def agrees(stiffness, damping):
        for d, (K, B) in zip(delays, found, strict=True):
            # 41 angles 5e-5 apart: K misses by their square, B by themselves, times (d+1)^2
            assert number(stiffness, d=d, b=1, T=1) == pytest.approx(K, rel=1e-6)
            assert number(damping, d=d, b=1, T=1) == pytest.approx(B, abs=2e-3)

    both = (line.rhs for line in settled("s3c_stiffness_maximum", "eq11"))
    only(agrees, *both, by=0.02)


@guards("s3c_stiffness_maximum")
def test_a_period_of_delay_leaves_41_and_two_leave_27_percent():
    none, one, two = (best(d)[0] for d in (0, 1, 2))
    for which, ratio in (("s3c-kmax-41", one / none), ("s3c-kmax-27", two / none)):
        verdict = page("s3c_stiffness_maximum").settled[which].verdict
        assert float(verdict.value) == pytest.approx(ratio, rel=1e-6)  # of the grid, as above

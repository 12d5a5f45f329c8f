"""Figs. 4 and 5: energies at corners and tips, and lines that meet, in 60 digits."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from oracles import energy
from oracles.guarding import guards
from oracles.subject import counterexample, number, only, page, shown, value

pytestmark = pytest.mark.ci

CHAPTER = "s3d_figures"
WHOLE = (1, 2, 4)


def line(d, angle):
    """What one angle needs per stiffness and per damping, T = 1, in 60 digits."""
    z = mpmath.expj(angle)
    share = z ** (-mpmath.mpf(d)) / (z - 1)
    return -mpmath.re(share), -mpmath.re(share * (1 - 1 / z))


def crossing(d, angle, step="1e-18"):
    """The wall at which two angles close to each other need b = 1."""
    step = mpmath.mpf(step)
    rows = mpmath.matrix([line(d, angle - step), line(d, angle + step)])
    K, B = mpmath.lu_solve(rows, mpmath.matrix([1, 1]))
    return K, B


def corner(d):
    """Where the straight part ends: the crossing at an angle that is almost 0."""
    # the next terms are of the angle's square; rounding is 1e-60 over its square, over 1e-17
    return crossing(d, mpmath.mpf("1e-8"), "1e-9")


@guards("s3d_figures")
def test_corner_and_tip_lie_on_the_border_of_the_energy():
    def agrees(corner_stiffness, stiffness):
        for d in WHOLE:
            K, B = corner(d)
            assert abs(value(corner_stiffness, y=B) - K) < 1e-14
            energy.bounds(number(corner_stiffness, y=B), float(B), 1.0, 1.0, d, wide=1.05)
            tip = number(stiffness, d=d), float(crossing(d, mpmath.pi / (2 * (d + 1)))[1])
            energy.bounds(*tip, 1.0, 1.0, d, wide=1.05)

    titles = [
        "The dashed curve of the corners is a hyperbola in $y=B/b$",
        "The dash-dotted curve of the tips is (11)",
    ]
    only(agrees, *(shown(CHAPTER, title) for title in titles), by=0.1)


@guards("s3d_figures")
def test_the_tip_is_where_two_lines_meet_upright():
    def agrees(stiffness, damping):
        for d in ("0.25", "0.5", "1", "6"):
            angle = mpmath.pi / (2 * (mpmath.mpf(d) + 1))
            assert abs(line(d, angle)[1]) < 1e-50  # damping is of no use there
            # the next terms are of the step's square
            K, B = crossing(d, angle)
            assert abs(value(stiffness, d=d) - K) < 1e-30
            assert abs(value(damping, d=d) - B) < 1e-30

    titles = (
        "The dash-dotted curve of the tips is (11)",
        "The damping of the tips is that of (11)",
    )
    only(agrees, *(shown(CHAPTER, title) for title in titles))


@guards("s3d_figures")
def test_the_table_of_the_seven_curves():
    (table,) = (block.rows[1:] for block in page(CHAPTER).blocks if block.kind == "table")
    assert len(table) == 7
    for d, *cells in ([cell.strip("$") for cell in row] for row in table):
        found = list(corner(d))
        angles = np.pi / 2 / (float(d) + 1) * (1 + np.linspace(-0.2, 0.2, 41))
        tips = [crossing(d, mpmath.mpf(angle)) for angle in angles]
        found += max(tips)
        for cell, ours in zip(cells, found, strict=True):
            printed = Fraction(cell)
            # 1e-14: the corner is that of an angle of 1e-8, the angle of the tip is a float
            missing = ours - mpmath.mpf(printed.numerator) / printed.denominator
            # four decimals are cut off; other numbers are exact
            assert -1e-14 < missing < (1e-4 if "." in cell else 1e-14)


@guards("s3d_figures")
def test_long_delays():
    d = mpmath.mpf(10) ** 16  # the next terms are of 1/(d+1)
    angle = mpmath.pi / (2 * (d + 1))
    (per_K, _), step = line(d, angle), angle * mpmath.mpf("1e-15")
    K = 1 / per_K
    low, high = line(d, angle - step), line(d, angle + step)
    B = -K * (high[0] - low[0]) / (high[1] - low[1])  # the need is largest there

    def agrees(stiffness, damping):
        assert abs((d + 1) * K - value(stiffness)) < 1e-14
        assert abs(B - value(damping)) < 1e-14

    titles = (
        "For long delays the tips fall like $\\pi h/2$",
        "For long delays the damping of the tips tends to a constant",
    )
    only(agrees, *(shown(CHAPTER, title) for title in titles))


@guards("s3d_figures")
def test_a_fraction_of_a_period_leaves_the_straight_part():
    walls = [(K, late) for K in (0.6, 0.9) for late in (0.25, 0.5)] + [(0.3, 1.7)]

    def agrees(low):
        for K, late in walls:
            B, part = K * (late + 0.5) - 1, late % 1
            # rounding over the angle, and the next term, of its square
            found = energy.determinant(K, B, late, 1e-4)
            at = {"K": K, "T": 1.0, "epsilon": part}
            assert number(low, **at) == pytest.approx(found, abs=1e-6)

    only(agrees, shown(CHAPTER, "On the straight part of (7) low frequencies extract energy"))
    for K, late in walls[:4]:
        B = K * (late + 0.5) - 1
        assert energy.left(K, B, late=late) < -1e-4
    # with a whole delay, and the wall shorter than the corner, it does not
    assert energy.left(0.7, 0.7 * 1.5 - 1, late=1) > -1e-12


@guards("s3d_figures", "s3d_stiffness_over_delay")
def test_the_two_counterexamples_half_a_period_late():
    tip = counterexample(CHAPTER, "fig4")
    assert energy.left(tip["K"], tip["B"], late=0.5) < -0.01
    assert energy.left(1.17, 0.32, late=0.5, periods=250) > 0
    # the curve of Fig. 5 ends below: some angle needs more than b for every damping
    assert number(shown(CHAPTER, "The dash-dotted curve of the tips is (11)"), d=0.5) < 1.16
    assert energy.need(1.17, 0.0, 0.5, np.array([np.pi / 3]))[0] > 1
    for theta in (0.4, 1.5, 2.9):
        assert energy.determinant(1.17, 0.32, 0.5, theta) > 0

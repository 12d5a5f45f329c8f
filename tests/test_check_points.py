"""The points at which `check` calls a function, the units of its errors, and what it covers."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from symhaptic import Scene
from symhaptic.check import report
from symhaptic.check.callers import called
from symhaptic.check.checked import exact
from symhaptic.check.compare import compared, distance, error
from symhaptic.check.devices import of_device
from symhaptic.check.formulas import CHECKED
from symhaptic.check.points import drawn

MANY = 10_000


def columns(name):
    """Points of a formula by argument, without those beside a boundary, which take long."""
    one = replace(CHECKED[name], border=None)
    return dict(zip(one.arguments, np.array(drawn(one, MANY).all).T, strict=True))


# -- special places ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [n for n in CHECKED if n not in ("delay_margin", "max_delay")])
def test_each_argument_that_may_be_0_is_0_at_some_points(name):
    at = columns(name)
    for argument, kind in CHECKED[name].arguments.items():
        if kind.allows(0.0) and (name, argument) != ("eq28", "k"):  # which has no such frequency
            assert (at[argument] == 0).sum() > 200, argument


@pytest.mark.parametrize("name", ["stability_boundary", "passivity_margin_at"])
def test_angles_lie_at_each_of_the_first_half_turns_of_the_delay(name):
    """theta (d + 1) = n pi for n = 1 to 4 as far as theta < pi, behind a delay above 4 periods."""
    at = columns(name)
    turn = (at["theta"] * (at["d"] + 1) / math.pi)[at["d"] > 4]
    for n in range(1, 5):
        assert (np.abs(turn / n - 1) < 1e-11).mean() > 0.01
    assert ((turn > 0.1) & (turn < 0.9)).mean() > 0.2


def test_angles_next_to_pi_have_all_the_distances():
    """From 1e-9 to 0.1: some 40 of 10 000 points in each decade."""
    one = CHECKED["stability_boundary"]
    points = drawn(one, MANY)
    off = math.pi - np.array(points.all)[~points.ordinary, 0]
    decades, _ = np.histogram(np.log10(off), range(-9, 0))
    assert min(decades) > 20


@pytest.mark.parametrize("name", ["eq5", "eq7", "eq27", "passivity_boundary"])
def test_usual_angles_are_spread_over_the_half_turn_that_they_have(name):
    """Up to pi, or up to pi/(d + 1) where the curve ends; omega T is such an angle."""
    at = columns(name)
    theta = at["theta"] if "theta" in at else at["omega"] * at["T"]
    turn = theta / math.pi * (1 if name == "eq5" else at["d"] + 1)
    usual = drawn(CHECKED[name], MANY).ordinary
    assert np.quantile(turn[usual], (0.25, 0.5, 0.75)) == pytest.approx((0.25, 0.5, 0.75), abs=0.1)
    assert turn.max() <= 1.0


def test_devices_are_critically_damped_or_swing_in_whole_half_turns():
    """delta^2 = 4 gamma, and omega_d T = n pi with n = 1 to 9; neighbours lie on both sides."""
    at = columns("discretize")
    gamma, delta = at["gamma"], at["delta"]
    by = np.divide(delta**2, 4 * gamma, out=np.full(MANY, np.nan), where=gamma > 0) - 1
    assert (np.abs(by) < 1e-11).sum() > 200
    turn = np.sqrt(np.maximum(gamma - delta**2 / 4, 0)) / math.pi
    assert all((np.abs(turn / n - 1) < 1e-11).sum() >= 5 for n in range(1, 10))
    for off in (by, turn - 1):
        assert all(((side * off > 0) & (side * off < 1e-5)).sum() > 20 for side in (1, -1))


def test_delays_lie_on_both_sides_of_whole_numbers_nearer_and_farther():
    d = columns("is_stable")["d"]
    off = d - np.round(d)
    for low, high in ((1e-16, 1e-11), (1e-11, 1e-7), (1e-7, 2e-3)):
        for side in (1, -1):
            assert ((side * off > low) & (side * off < high)).sum() > 50


@pytest.mark.parametrize("name", ["max_stable_stiffness", "scene.max_stable_stiffness", "limit_at"])
def test_few_springs_are_so_stiff_that_the_limit_has_no_exact_value(name):
    """gamma > 9.8, or sqrt(gamma) (d + 1) > pi and d > 1, as the report has it."""
    at = columns(name)
    gamma = at["gamma"] if "gamma" in at else at["k"] * at["T"] ** 2 / at["m"]
    long = (at["d"] > 1) & (np.sqrt(gamma) * (at["d"] + 1) > math.pi)
    assert 0.0005 < ((gamma > 9.8) | long).mean() < 0.01
    assert "gamma > 9.8, or sqrt(gamma) (d + 1) > pi and d > 1" in CHECKED[name].open[0].replace(
        "k T^2/m", "gamma"
    )


def test_the_part_of_a_period_is_below_1():
    part = CHECKED["discretize_fractional"].arguments["epsilon"]
    assert part.allows(math.nextafter(1.0, 0.0))
    assert not part.allows(1.0)


# -- boundaries ----------------------------------------------------------------------------------


def test_where_a_boundary_cannot_be_computed_others_are_sought():
    one, seen = CHECKED["is_passive"], []

    def border(*at):
        seen.append(at)
        if len(seen) % 2:
            raise ZeroDivisionError
        return one.border(*at)

    far = drawn(replace(one, border=border), 200).distance
    assert (far == far).sum() == (drawn(one, 200).distance > 0).sum() > 0


@pytest.mark.parametrize("by", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("side", [1, -1])
def test_the_distance_of_a_wrong_verdict_is_that_to_the_boundary(by, side):
    """delta > alpha/2 + |beta| by (4) of the paper, and alpha > -gamma: in powers of 100."""
    passive = (0.4, 0.3, 0.5 * (1 + side * by), 0.0)
    spring = (-0.5 * (1 - side * by), 0.1, 0.5, 1.0, 0.0)
    for name, point in (("is_passive", passive), ("is_stable", spring)):
        one = CHECKED[name]
        assert exact(one, point)[0] == (side > 0,)
        assert 0.2 < distance(one, point, float(side < 0)) / (by * 2.0**52) < 200
        assert distance(one, point, float(side > 0)) == 1.0


def test_a_wall_that_pulls_less_than_its_damping_is_rounded_is_next_to_one_that_pushes():
    """alpha >= 0 is needed by (4): only a larger alpha makes this wall passive."""
    assert distance(CHECKED["is_passive"], (-1e-20, 0.1, 1.0, 0.0), 1.0) == 1.0


def test_how_far_from_the_boundary_is_told_in_units_and_as_a_share():
    """A damping that is 1e-5 too small passes: the verdict differs within 1e-5 of the boundary."""

    def mine(alpha, beta, delta, d):
        return alpha >= 0 and delta * (1 + 1e-5) >= alpha / 2 + abs(beta)

    over = {"d": (0, 0), "alpha": (0, 1), "beta": (0, 1), "delta": (0, 1)}
    found = compared(CHECKED["is_passive"], called(mine), 1e12, 300, over)
    said = report.text(report.Report(found, "mine", 0.0))
    ulp, share = said.split("within ")[1].split(" relative)")[0].split(" ulp (")
    assert found.agrees
    assert float(share) == pytest.approx(float(ulp) * 2.0**-52, rel=0.1)
    assert 1e-7 < float(share) < 1e-3


def test_the_stiffest_wall_with_a_damping_is_that_of_the_roots():
    """A free mass without delay: p(z) = z (z - 1)^2 + (z + 1)/2 ((alpha + beta) z - beta).

    Its roots lie inside while |p(0)| < 1 and 1 - p(0)^2 > |p(0) p2 - p1| (Jury), which for
    beta > 0 is alpha < 2 beta (2 - beta)/(2 + beta); on the circle two of the roots have the sum
    2 cos(theta), and the third is -p(0) = beta/2.
    """
    for beta in np.linspace(0.05, 1.95, 11):
        alpha = 2 * beta * (2 - beta) / (2 + beta)
        theta = math.acos(1 - alpha / 4 - beta / 2)
        found = exact(CHECKED["limit_at"], (beta, 0.0, 0.0, 0.0))[0]
        assert [float(v) for v in found] == pytest.approx([alpha, theta], rel=1e-12)


# -- what an error is measured by ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "point", "result"),
    [
        ("eq6", (1.3, 0.7, 0.9), 0),
        ("eq9", (1.3, 0.7, 0.01, 3.0), 0),
        ("eq24", (1.3, 0.7, 0.02, 0.01), 0),
        ("eq28", (9.0, 1e-6, 1.1), 0),
        ("linear_limit", (0.3, 0.9, 2.5), 0),
        ("discretize", (0.5, 1e-4), 3),
        ("discretize_fractional", (0.5, 1e-4, 0.25), 4),
    ],
)
def test_where_nothing_cancels_a_unit_is_one_of_the_value(name, point, result):
    rights, sizes = exact(CHECKED[name], point)
    right = float(rights[result])
    assert math.ulp(max(right, sizes[result])) == math.ulp(right)
    got = list(map(float, rights))
    got[result] += 12 * math.ulp(right)
    assert 11 < error(CHECKED[name], point, got)[0] < 13


def test_behind_long_delays_the_stiffness_counts_in_full_and_where_it_is_in_half_of_the_digits():
    one = CHECKED["max_stable_stiffness"]
    for d in (1e3, 1e6, 1e10):
        alpha, beta, theta = (float(v) for v in exact(one, (0.0, 1.0, d))[0])
        assert error(one, (0.0, 1.0, d), (alpha, beta + 1e-8, theta + 1e-8))[0] <= 8
        assert error(one, (0.0, 1.0, d), (alpha * (1 + 1e-9), beta, theta))[0] > 1e5


def test_at_large_angles_a_unit_of_equation_5_is_at_most_two_of_the_value():
    """Without delay and virtual damping b = K T (1 - cos(theta))/(2 - 2 cos(theta)) = K T/2."""
    off = 20 * math.ulp(0.5)
    assert error(CHECKED["eq5"], (1.0, 0.0, 1.0, 3.1, 0.0), (0.5 + off,))[0] > 8


@pytest.mark.parametrize("theta", [1e-3, 0.03, 0.5])
def test_at_small_angles_the_boundary_is_a_difference_of_numbers_of_size_4(theta):
    """Of a free mass without delay: alpha + beta (1 - 1/z) = -2 (z^2 - 2z + 1)/(z + 1).

    NumPy's roundings of its terms are few units; an error of 1000 roundings of 4 is refused.
    """
    one, point = CHECKED["stability_boundary"], (theta, 0.0, 0.0, 0.0)
    z = np.exp(1j * theta)
    wall = -2 * (z**2 - 2 * z + 1) / (z + 1)
    beta = wall.imag / np.sin(theta)
    alpha = wall.real - beta * (1 - np.cos(theta))
    assert error(one, point, (alpha, beta))[0] < 8
    assert error(one, point, (alpha + 4e-13, beta))[0] > 100
    assert error(one, point, (alpha, beta + 4e-13 / theta))[0] > 100


def test_no_answer_is_refused_for_each_plant_whose_limit_is_its_first_maximum():
    """gamma <= 9.8 with up to one period of delay, and sqrt(gamma) (d + 1) <= pi behind more."""
    one, nothing = CHECKED["max_stable_stiffness"], (math.nan,) * 3
    for plant in ((9.0, 1.0, 0.5), (0.5, 1.0, 0.0), (0.09, 1.0, 8.0)):
        assert error(one, plant, nothing)[0] == math.inf
    for plant in ((9.0, 1.0, 5.0), (11.0, 1.0, 0.5)):
        assert error(one, plant, nothing)[0] == -math.inf


def test_the_table_has_the_error_of_each_row():
    """In ulps of what is right, which no terms that cancel exceed for positive numbers."""
    over = {"beta": (1, 2), "delta": (1, 2)}

    def mine(beta, delta, d):
        return (beta + delta) / (d + 0.5)

    found = compared(CHECKED["linear_limit"], called(mine), 8, 60, over)
    rows = report.table(report.Report(found, "mine", 0.0)).splitlines()[1:]
    assert len(rows) == 60
    for *_, right, got, ulp in (row.split(",") for row in rows):
        off = abs(Fraction(float.fromhex(got)) - Fraction(right)) / Fraction(math.ulp(float(right)))
        assert float(ulp) == pytest.approx(float(off), rel=0.01, abs=1e-6)


# -- what is covered -----------------------------------------------------------------------------


@pytest.mark.parametrize(("off", "is_next"), [(0.0, 1), (4e-4, 1), (-4e-4, 1), (0.01, 0)])
def test_next_to_critical_damping_is_a_thousandth_of_its_square(off, is_next):
    over = {"gamma": (1, 1), "delta": (2 + 2 * off, 2 + 2 * off)}
    found = compared(CHECKED["discretize"], called(CHECKED["discretize"].near), 8, 20, over)
    kinds = report.covered(found)["kinds"]
    assert kinds.get("damping next to critical", 0) == 20 * is_next


def test_a_device_in_si_units_is_covered_as_its_numbers_without_unit():
    """k T^2/m = 10 > pi^2 without damping."""
    one = CHECKED["eq12"]
    over = {"b": (0, 0), "k": (5e4, 5e4), "m": (0.5, 0.5), "T": (0.01, 0.01)}
    kinds = report.covered(compared(one, called(one.near), 8, 20, over))["kinds"]
    assert kinds == {"natural frequencies above pi/T": 20, "no device damping": 20}


# -- devices -------------------------------------------------------------------------------------


def test_a_device_has_the_same_points_in_each_system_of_units():
    """K is a mass over a squared time, B a mass over a time, and a frequency one over a time."""

    def device(m, T):
        own = {"mass": m, "damping": 0.05 * m / T, "stiffness": 0.02 * m / T**2}
        return of_device(Scene(**own, sampling_period=T, delay=1.4 * T))

    plain, other = device(1.0, 1.0), device(0.1, 0.001)
    units = {"K": 0.1 / 0.001**2, "B": 0.1 / 0.001, "frequency_hz": 1 / 0.001}
    for name, one in plain.items():
        wanted = np.array(drawn(one, 200).all) * [units[a] for a in one.arguments]
        assert np.array(drawn(other[name], 200).all) == pytest.approx(wanted, rel=1e-6)


def test_pairs_of_a_device_lie_on_both_sides_of_its_passive_walls():
    """(4) of the paper: K T/2 < b - |B|."""
    scene = Scene(mass=0.1, damping=5.0, sampling_period=0.001)
    points = drawn(of_device(scene)["is_passive"], 200)
    beside = np.flatnonzero(~np.isnan(points.distance))
    K, B = np.array(points.all)[beside].T
    share = K * 0.001 / 2 / (5.0 - abs(B)) - 1
    assert len(beside) >= 20
    assert abs(share) == pytest.approx(points.distance[beside], rel=1e-3)
    assert (share > 0).sum() == (share < 0).sum()

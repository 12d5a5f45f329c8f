"""Passivity in the time domain: the energy that motions of finite length leave, and its sign.

How near 0 a motion of N periods comes to what endless ones can do: the worst angle is met to
within pi/N, so that the share of the energy misses its least value by some (d+1)^2 pi^2/N^2.
"""

import mpmath
import numpy as np
import pytest
import sympy as sp
from oracles import energy
from oracles.guarding import guards
from oracles.subject import number, only, page, settled, shown
from scipy.optimize import linprog

from symhaptic.notation import function, z

DELAYS = (0, 1, 3)
ANGLES = np.linspace(0, np.pi, 2001)[1:]


def need(K, B, delay, angles=ANGLES):
    """The printed (5), from the transfer function, with T = 1: delays beyond whole ones too."""
    z = np.exp(1j * angles)
    law = (K + B * (1 - 1 / z)) * np.exp(-1j * delay * angles)
    return ((1 - 1 / z) * law).real / (2 - 2 * np.cos(angles))


def edge(K, B, delay):
    """What the wall (K, B) must be multiplied by to need the damping 1, T = 1."""
    return 1 / need(K, B, delay).max()


def bounds(K, B, b, T, delay, short=0.99, wide=1.03):
    """The wall lies on the border: a little less cannot give energy away, a little more does."""
    assert energy.left(short * K, short * B, b, T, delay) > -1e-12  # rounding of an eigenvalue
    # 150 periods and d <= 3 miss at most 16 pi^2/150^2 = 0.007 of 0.03
    assert energy.left(wide * K, wide * B, b, T, delay) < 0


@guards("s3_energy")
def test_the_damping_of_a_filter_decides_over_its_energy():
    """(4) with a force of four samples; T = 0.002 s."""
    b, T = 1.7, 2e-3
    rng = np.random.default_rng(31)
    laws = [np.append(400, h) * rng.choice([0.5, 1]) for h in rng.uniform(-300, 300, size=(4, 3))]
    laws = [h + (h.sum() < 0) * abs(h.sum()) for h in laws]  # H(1) >= 0, as the chapter wants
    grid = np.linspace(0.005, np.pi - 0.005, 300)

    def agrees(needed):
        for law in laws:
            filter_ = sp.Lambda(z, sum(float(h) * z**-i for i, h in enumerate(law)))
            filled = needed.replace(function("H"), filter_)
            worst = max(number(filled, T=T, omega=angle / T, b=b) for angle in grid)
            scale = b / worst
            assert energy.left_of(0.98 * scale * law, b, T) > -1e-12
            assert energy.left_of(1.02 * scale * law, b, T) < 0

    condition = settled("s3_energy", "eq4")[0]
    assert condition.lhs.name == "b"
    only(agrees, condition.rhs, by=0.05, kept=("b", "omega"))


@guards("s3_energy")
def test_four_steps_against_a_spring():
    b, K, T, p = 1.3, 500.0, 1e-3, 0.004
    found = p**2 * b / T * 4 + sum(K * p * i * p for i in range(4))

    def agrees(energy_of_steps):
        assert number(energy_of_steps, b=b, K=K, T=T, p_k=p) == pytest.approx(found, rel=1e-14)

    only(agrees, shown("s3_energy", "Four equal steps against a spring"))
    # a pulling spring gives energy away however strong the damper is, if the motion is long
    assert energy.left(-0.1, 0.0, periods=60) < 0 < energy.left(-0.1, 0.0, periods=10)


@guards("s3_unilateral")
def test_a_wall_that_only_pushes_gives_no_energy_under_the_simple_bound():
    rng = np.random.default_rng(32)

    def least(share, K, B, late):
        """Least energy that a search finds, T = 1; the damper is ``share`` of the bound."""
        b = share * (K * (late + 0.5) + abs(B))
        moves = rng.normal(size=(400, 60)) * rng.uniform(0.1, 3, size=(400, 1))
        angles = rng.uniform(0, np.pi, size=(400, 1)) * np.arange(60)
        moves[:200] = np.sin(angles[:200]) + rng.uniform(-0.5, 0.5, size=(200, 1))
        moves[200:300] *= np.sin(angles[200:300])
        moves[::2, 20:] = np.where(np.arange(20, 60) % 2, 1.0, -1.0)  # as fast as possible, inside
        moves[::2, :20] = rng.uniform(0, 0.4, size=(200, 20))
        place = np.cumsum(moves, axis=1) - moves
        before = np.column_stack([np.zeros(len(place)), place[:, :-1]])
        force = K * np.maximum(place, 0) + B * (np.maximum(place, 0) - np.maximum(before, 0))
        felt = np.column_stack([np.zeros((len(place), late)), force])[:, :60]
        return (b * moves**2 + felt * moves).sum(axis=1).min()

    walls = ((1, 0, 0), (1, 0.7, 0), (0.3, -1, 0), (1, 0, 1), (1, -0.4, 2), (0.2, 0.9, 3))
    for K, B, late in walls:
        # sums of 60 terms of order 1
        assert least(1.0, K, B, late) >= -1e-12
    assert least(0.8, 1, 0, 0) < -0.1
    assert least(0.8, 1, 0.7, 0) < -0.1


@guards("s3a_passivity_condition")
def test_the_condition_tells_walls_that_give_energy_away_from_others():
    """eq5 in SI units."""
    b, T = 1.6, 1e-3
    walls = [(d, direction) for d in DELAYS for direction in (-0.5, 0.3, 1.2, 1.5)]
    omegas = np.linspace(0.002, 0.998, 250) * np.pi / T

    def agrees(needed):
        for d, direction in walls:
            K, B = np.cos(direction) / T, np.sin(direction)
            most = max(number(needed, K=K, B=B, T=T, d=d, omega=w) for w in omegas)
            bounds(K * b / most, B * b / most, b, T, d)

    condition = settled("s3a_passivity_condition", "eq5")[0]
    assert condition.lhs.name == "b"
    only(agrees, condition.rhs, by=0.1, kept=("omega",))


@guards("s3a_passivity_condition")
def test_without_delay_half_the_stiffness_and_all_of_the_damping_count():
    def agrees(needed):
        for K, B in ((1.0, 0.4), (0.5, -2.0), (2.0, 0.0), (0.0, 3.0)):
            b = number(needed, K=K, B=B, T=2e-3)
            bounds(K, B, b, 2e-3, 0)

    only(agrees, settled("s3a_passivity_condition", "eq6")[0].rhs, by=0.05)


@guards("s3a_passivity_condition")
def test_half_a_period_late_the_condition_is_not_enough():
    """The chapter's wall K = T = 1, B = 0, b = 1.01, and the energy of its motion."""
    assert need(1.0, 0.0, 0.5).max() < 1.01
    assert energy.left(1.0, 0.0, 1.01, late=0.5) < -0.02
    moves = np.tile([1.5, 1.0], 30)
    moves = np.concatenate([moves, -moves]) / np.sqrt(0.5)

    def agrees(energy_left):
        for K, B, b in ((1.0, 0.0, 1.01), (0.3, 2.0, 0.5)):
            # in the form's scale the damper's share is b times the squares
            law = energy.form(energy.wall(K, B, 1), b, 1.0, 0.5, 60)
            scaled = moves * np.sqrt(b)
            assert number(energy_left, K=K, B=B, b=b, T=1) == pytest.approx(
                scaled @ law @ scaled, abs=1e-10
            )

    only(agrees, shown("s3a_passivity_condition", "Energy left to damper and wall"), kept=("T",))


@guards("s3b_envelope", "s5a_normalised_boundary")
def test_each_point_of_the_envelope_is_where_two_lines_meet():
    """The paper's own words: l(omega) crossed with l(omega + epsilon), in 60 digits."""
    b, T, m = 1.4, 2e-3, 0.3
    points = [(0.7, 0.5), (1, 0.4), (2, 0.9), (4.5, 0.2)]

    def line(d, angle):
        z = mpmath.expj(angle)
        share = z**-d / (z - 1)
        return mpmath.re(share), mpmath.re(share * (1 - 1 / z)), mpmath.mpf(b) / T

    step = mpmath.mpf(10) ** -20  # errors of the order of the step, and 1e-40 of rounding
    crossed = []
    for d, angle in points:
        angle = mpmath.mpf(angle)
        k, c, e = zip(line(d, angle - step), line(d, angle + step), strict=True)
        det = k[0] * c[1] - k[1] * c[0]
        K, B = (c[0] * e[1] - c[1] * e[0]) / det, T * (k[1] * e[0] - k[0] * e[1]) / det
        crossed.append((float(K), float(B)))

    def agrees(stiffness, damping):
        for (d, angle), (K, B) in zip(points, crossed, strict=True):
            at = {"d": d, "theta": angle, "b": b, "T": T}
            assert number(stiffness, **at) == pytest.approx(K, rel=1e-14)
            assert number(damping, **at) == pytest.approx(B, rel=1e-14)

    both = (shown("s3b_envelope", name) for name in ("Stiffness", "Damping"))
    only(agrees, *both)

    def agrees_in_its_plane(stiffness, damping):
        for (d, angle), (K, B) in zip(points, crossed, strict=True):
            at = {"d": d, "omega_hat": angle, "delta": b * T / m, "T": T, "m": m}
            assert number(stiffness, **at) == pytest.approx(K * T**2 / m, rel=1e-14)
            assert number(damping, **at) == pytest.approx(B * T / m, rel=1e-14)

    both = (line.rhs for line in settled("s5a_normalised_boundary", "eq27"))
    only(agrees_in_its_plane, *both, kept=("T", "m"))


@guards("s3b_extent")
def test_frequencies_beyond_the_first_half_turn_cut_off_nothing():
    rng = np.random.default_rng(33)
    for d in (0.0, 0.3, 1.0, 1.6, 4.0):
        for direction in rng.uniform(-np.pi / 2, np.pi / 2, size=20):
            K, B = np.cos(direction), np.sin(direction)
            low = need(K, B, d, ANGLES * (1 / (d + 1))).max()
            # a grid of 2000 steps misses a maximum by less than (d+1)^3 1e-5
            assert need(K, B, d).max() <= low + 1e-5 * (d + 1) ** 3
    # a wall that pulls can be worse beyond
    assert need(-1.0, 1.2, 1.0).max() > need(-1.0, 1.2, 1.0, ANGLES / 2).max() + 0.1


@guards("s3b_extent")
def test_the_two_ends_of_the_margin():
    def agrees(low, high):
        for u, w, N in ((0.3, 0.2, 2), (0.1, 0.9, 5.5), (0.02, -0.4, 12)):
            K, B, d = 2 * u, w - u, N / 2 - 1
            # rounding of K/theta^2, and the next term of the series, theta^2 (d+1)^3
            low_end = 1 - need(K, B, d, np.array([1e-4]))[0]
            assert number(low, u=u, w=w, N=N) == pytest.approx(low_end, abs=1e-5)
            high_end = 1 - need(K, B, d, np.array([2 * np.pi / N]))[0]
            assert number(high, w=w) == pytest.approx(high_end, abs=1e-14)

    only(agrees, shown("s3b_extent", "At the lower end"), shown("s3b_extent", "At $N\\psi=\\pi$"))


@guards("s3b_rise")
@pytest.mark.parametrize("d", [1, 2, 3])
def test_the_envelope_is_the_border_of_the_energy(d):
    """eq7 in SI units, at frequencies up to pi/(T (d+1))."""
    b, T = 2.5, 1e-3

    def agrees(stiffness, damping):
        for part in (0.2, 0.5, 0.8, 0.95):
            at = {"omega": part * np.pi / (T * (d + 1)), "d": d, "b": b, "T": T}
            bounds(number(stiffness, **at), number(damping, **at), b, T, d)

    # an argument that moves the point along the curve is not noticed
    only(agrees, *(e.rhs for e in settled("s3b_rise", "eq7")), by=0.1, kept=("omega",))


@guards("s3b_rise")
def test_the_stiffness_of_the_envelope_rises_and_falls():
    def agrees(curve):
        for N in (2.5, 4, 9):
            values = [number(curve, N=N, psi=p) for p in np.linspace(0.01, 0.99, 99) * np.pi / N]
            assert np.argmax(values) == 49
            assert np.all(np.diff(values[:50]) > 0)
            assert np.all(np.diff(values[49:]) < 0)

    agrees(shown("s3b_rise", "The envelope's stiffness"))


@guards("s3c_damping_maximum")
def test_without_stiffness_the_damping_ends_at_that_of_the_device():
    b, T = 2.5, 1e-3

    def agrees(highest, lowest):
        for d in DELAYS:
            bounds(0.0, number(highest, b=b), b, T, d)
            bounds(0.0, number(lowest, b=b), b, T, d)

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
            bounds(number(stiffness, **at), number(damping, **at), b, T, d, wide=1.05)

    only(agrees, *(e.rhs for e in settled("s3c_linear_part", "eq8")), by=0.1, kept=("y", "d"))


@guards("s3c_linear_part")
def test_damping_over_delay_is_the_limit_of_low_frequencies():
    def agrees(stiffness):
        for d, B in ((0, -0.3), (1, 0.1), (6.5, 0.25)):
            K = number(stiffness, b=1, B=B, T=1, d=d)
            # rounding of K/theta^2 at theta = 1e-4, and the next term, of order (d+1)^3 theta^2
            assert need(K, B, d, np.array([1e-4]))[0] == pytest.approx(1, abs=1e-5)

    only(agrees, shown("s3c_linear_part", "Damping over delay"), kept=("T",))


def best(d):
    """The stiffest wall that needs no more than b = 1, T = 1: a linear programme in (K, B)."""
    angles = np.append(ANGLES, np.pi / (2 * (d + 1)) + np.linspace(-1e-3, 1e-3, 41))
    rows = np.array([need(1, 0, d, angles), need(0, 1, d, angles)]).T
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

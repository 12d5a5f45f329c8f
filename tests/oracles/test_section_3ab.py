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
from oracles.subject import number, only, settled, shown
from scipy.optimize import minimize

from symhaptic.notation import function, z

pytestmark = pytest.mark.ci

DELAYS = (0, 1, 3)


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

    only(agrees, shown("s3_energy", "Damper and spring receive this energy in four equal steps"))
    # a pulling spring gives energy away however strong the damper is, if the motion is long
    assert energy.left(-0.1, 0.0, periods=60) < 0 < energy.left(-0.1, 0.0, periods=10)


@guards("s3_unilateral")
def test_a_wall_that_only_pushes_gives_no_energy_under_the_simple_bound():
    """The least energy that a search down the slope finds, from many motions; T = 1."""
    rng = np.random.default_rng(32)
    periods = 24
    place = np.tri(periods, k=-1)  # positions of displacements

    def least(share, K, B, late, tries=8):
        b = share * (K * (late + 0.5) + abs(B))
        law = (K + B) * np.eye(periods, k=-late) - B * np.eye(periods, k=-late - 1)

        def ratio(p):
            """Energy left per squared displacement, and its slope."""
            x = place @ p
            wall = law @ np.maximum(x, 0)
            size, left = p @ p, b * p @ p + p @ wall
            slope = 2 * b * p + wall + place.T @ ((x > 0) * (law.T @ p))
            return left / size, (slope - 2 * p * left / size) / size

        starts = rng.normal(size=(tries, periods))
        starts[: tries // 2, 0] += 6  # a step into the wall, so that the rest happens there
        return min(minimize(ratio, p, jac=True, method="L-BFGS-B").fun for p in starts)

    needed = [(1, 0, 0), (1, 0.7, 0), (1, 0, 1), (1, -0.4, 2)]
    for wall in (*needed, (0.3, -1, 0), (0.2, 0.9, 3)):
        assert least(1.0, *wall) >= -1e-12  # sums of 24 terms of order 1
    # nearly all of the bound is needed without delay, and with delay for -b <= B <= 0
    for wall in needed:
        assert least(0.8, *wall) < 0


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
            energy.bounds(K * b / most, B * b / most, b, T, d)

    condition = settled("s3a_passivity_condition", "eq5")[0]
    assert condition.lhs.name == "b"
    only(agrees, condition.rhs, by=0.1, kept=("omega",))


@guards("s3a_undelayed")
def test_without_delay_half_the_stiffness_and_all_of_the_damping_count():
    def agrees(needed):
        for K, B in ((1.0, 0.4), (0.5, -2.0), (2.0, 0.0), (0.0, 3.0)):
            b = number(needed, K=K, B=B, T=2e-3)
            energy.bounds(K, B, b, 2e-3, 0)

    only(agrees, settled("s3a_undelayed", "eq6")[0].rhs, by=0.05)


@guards("s3a_passivity_condition")
def test_half_a_period_late_the_condition_is_not_enough():
    """The chapter's wall K = T = 1, B = 0, b = 1.01, and the energy of its motion."""
    assert energy.need(1.0, 0.0, 0.5).max() < 1.01
    assert energy.left(1.0, 0.0, 1.01, late=0.5) < -0.02
    moves = np.tile([1.5, 1.0], 30)
    moves = np.concatenate([moves, -moves]) / np.sqrt(0.5)

    def agrees(energy_left):
        for K, B, b in ((1.0, 0.0, 1.01), (0.3, 2.0, 0.5)):
            # in the form's scale the damper's share is b times the squares
            law = energy.form(energy.wall(K, B, 1), b, 1.0, 0.5, 60)
            scaled = moves * np.sqrt(b)
            found = scaled @ law @ scaled
            assert number(energy_left, K=K, B=B, b=b, T=1) == pytest.approx(found, abs=1e-10)

    only(
        agrees,
        shown("s3a_passivity_condition", "Damper and wall receive this energy from the motion"),
        kept=("T",),
    )


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

    both = (
        shown("s3b_envelope", name)
        for name in (
            "Two neighbouring lines meet at this stiffness",
            "Two neighbouring lines meet at this damping",
        )
    )
    only(agrees, *both)

    def agrees_in_its_plane(stiffness, damping):
        for (d, angle), (K, B) in zip(points, crossed, strict=True):
            at = {"d": d, "omega_hat": angle, "delta": b * T / m, "T": T, "m": m}
            assert number(stiffness, **at) == pytest.approx(K * T**2 / m, rel=1e-14)
            assert number(damping, **at) == pytest.approx(B * T / m, rel=1e-14)

    both = (line.rhs for line in settled("s5a_normalised_boundary", "eq27"))
    only(agrees_in_its_plane, *both, kept=("T", "m"))


@guards("s3b_rise")
def test_the_two_ends_of_the_margin():
    def agrees(low, high):
        for u, w, N in ((0.3, 0.2, 2), (0.1, 0.9, 5.5), (0.02, -0.4, 12)):
            K, B, d = 2 * u, w - u, N / 2 - 1
            # rounding of K/theta^2, and the next term of the series, theta^2 (d+1)^3
            low_end = 1 - energy.need(K, B, d, np.array([1e-4]))[0]
            assert number(low, u=u, w=w, N=N) == pytest.approx(low_end, abs=1e-5)
            high_end = 1 - energy.need(K, B, d, np.array([2 * np.pi / N]))[0]
            assert number(high, w=w) == pytest.approx(high_end, abs=1e-14)

    only(
        agrees,
        shown("s3b_rise", r"For $\psi\to0$ the margin has a linear limit"),
        shown("s3b_rise", r"At $N\psi=\pi$ the condition depends on $w$ only"),
    )


@guards("s3b_rise")
@pytest.mark.parametrize("d", [1, 2, 3])
def test_the_envelope_is_the_border_of_the_energy(d):
    """eq7 in SI units, at frequencies up to pi/(T (d+1))."""
    b, T = 2.5, 1e-3

    def agrees(stiffness, damping):
        for part in (0.2, 0.5, 0.8, 0.95):
            at = {"omega": part * np.pi / (T * (d + 1)), "d": d, "b": b, "T": T}
            energy.bounds(number(stiffness, **at), number(damping, **at), b, T, d)

    # an argument that moves the point along the curve is not noticed
    only(agrees, *(e.rhs for e in settled("s3b_rise", "eq7")), by=0.1, kept=("omega",))


@guards("s3b_rise")
@pytest.mark.parametrize("d", [1, 2, 5])
def test_walls_that_just_meet_the_condition_above_the_corner_are_on_the_envelope(d):
    """On rays beyond the corner, of walls that need the damping 1 at some angle and no more."""
    rays = [1 / k for k in (1.8, 0.9, 0.3, 0.05)] + [0.6 * d * (2 * d + 1) / (3 * (d + 1))]
    walls = [w / energy.need(*w, d).max() for w in (np.array([1.0, ray]) for ray in rays)]
    walls = [wall for wall in walls if wall[1] > d / (2 * d + 3) + 0.01]
    assert len(walls) > 2

    def agrees(stiffness, damping):
        turns = np.linspace(0.001, 1, 500) * np.pi / (d + 1)
        at = [{"omega": t, "d": d, "b": 1, "T": 1} for t in turns]
        curve = np.array([[number(e, **a) for e in (stiffness, damping)] for a in at])
        for wall in walls:
            # the curve is a polygon of 500 sides, the need a maximum over 2000 angles
            assert np.abs(curve - wall).max(axis=1).min() < 0.005

    stiffness, damping = (e.rhs for e in settled("s3b_rise", "eq7"))
    agrees(stiffness, damping)
    with pytest.raises(AssertionError):
        agrees(stiffness * 1.02, damping)


@guards("s3b_rise")
def test_the_stiffness_of_the_envelope_rises_and_falls():
    def agrees(curve):
        for N in (2.5, 4, 9):
            values = [number(curve, N=N, psi=p) for p in np.linspace(0.01, 0.99, 99) * np.pi / N]
            assert np.argmax(values) == 49
            assert np.all(np.diff(values[:50]) > 0)
            assert np.all(np.diff(values[49:]) < 0)

    agrees(
        shown(
            "s3b_rise",
            "The normalised stiffness $U=KT/(2b)$ on the envelope is a quotient of sines",
        )
    )

"""Passivity at any delay: energies of finite motions, Hermitian matrices, and Fejer's sums.

In units b = T = 1 (alpha = K, beta = B, delta = 1).  A motion is given by its displacements before
and after the force changes, in every period; that is not how the package writes it.
"""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from symhaptic import sweep
from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.passivity import (
    is_passive,
    max_passive_stiffness,
    passivity_boundary,
    passivity_margin,
)

RNG = np.random.default_rng(5)
ANGLES = np.linspace(0, np.pi, 4001)[1:]


def printed(alpha, beta, delay, angles=ANGLES):
    """Right side of (5) as printed, after the division by its denominator, b = T = 1."""
    d0, d1, d2 = (np.cos((delay + i) * angles) for i in range(3))
    return ((d0 - d1) * alpha + (d0 - 2 * d1 + d2) * beta) / (2 - 2 * np.cos(angles))


def needed(alpha, beta, delay, angles=ANGLES):
    """Damping at which the form in the two displacements of a period is just not negative.

    b/part |p|^2 + b/(1-part) |q|^2 + Re G (p + q) conj(z^-1 p + q): the largest eigenvalue of
    -Re(...) with p and q scaled by the roots of part and 1 - part.
    """
    whole = int(np.floor(delay))
    part = delay - whole
    z = np.exp(1j * angles)
    g = z ** (-whole) * (alpha + beta * (1 - 1 / z)) / (z - 1)
    to = np.array([np.sqrt(part) / z, np.full_like(z, np.sqrt(1 - part))]).T
    of = np.array([np.sqrt(part), np.sqrt(1 - part)])
    form = g[:, None, None] * to[:, :, None] * of
    return np.linalg.eigvalsh(-(form + form.conj().transpose(0, 2, 1)) / 2)[:, -1]


def horizon(alpha, beta, delay, periods):
    """Smallest eigenvalue of the energy of motions that return, per displacement squared."""
    whole = int(np.floor(delay))
    part = delay - whole
    count = periods + whole + 2
    moves = np.zeros((count, 2, 2 * periods))  # (period, before or after, coordinate)
    for k in range(periods):
        moves[k, 0, 2 * k], moves[k, 1, 2 * k + 1] = 1, 1
    place = np.vstack([np.zeros(2 * periods), np.cumsum(moves.sum(axis=1), axis=0)])[:count]
    before = np.vstack([np.zeros(2 * periods), place[:-1]])
    force = np.vstack([np.zeros((whole + 1, 2 * periods)), alpha * place + beta * (place - before)])
    form = sum(np.outer(force[k + i], moves[k, i]) for k in range(count) for i in (0, 1)) + np.diag(
        np.tile([1 / part, 1 / (1 - part)], periods)
    )
    back = np.ones(2 * periods) / np.sqrt(2 * periods)
    basis = np.linalg.svd(np.eye(2 * periods) - np.outer(back, back))[0][:, :-1]
    return np.linalg.eigvalsh(basis.T @ (form + form.T) @ basis / 2)[0]


@pytest.mark.parametrize("delay", [0.5, 0.2, 1.7])
def test_no_finite_motion_extracts_energy_from_a_passive_wall(delay):
    alpha, beta = passivity_boundary(np.array([0.3, 0.6, 0.9]) * np.pi / (delay + 1), 1.0, delay)
    for K, B in zip(alpha, beta, strict=True):
        assert horizon(0.999 * K, 0.999 * B, delay, 60) > 0
        # 60 periods come within some 1e-3 of what endless motions can do
        assert horizon(1.02 * K, 1.02 * B, delay, 60) < 0


WALLS = [(a, b) for a in (0.0, 0.3, 1.0, 2.0) for b in (-2.0, -0.4, 0.0, 0.2, 0.5, 1.2, 6.0)]
DELAYS = [0.0, 0.01, 0.1, 0.25, 0.5, 0.75, 0.99, 1.0, 1.5, 2.0, 3.25, 7.0, 7.9]


@pytest.mark.parametrize("delay", DELAYS)
def test_margin_is_the_worst_of_all_angles(delay):
    alpha, beta = np.array(WALLS).T
    found = 1 - passivity_margin(alpha, beta, 1.0, delay)
    for need, K, B in zip(found, alpha, beta, strict=True):
        worst = needed(K, B, delay).max()
        # a grid misses the top by at most half its step squared times half the curvature, which
        # is below 10 (d+1)^3 (K + |B|) here
        slack = 10 * (delay + 1) ** 3 * (K + abs(B)) * (ANGLES[1] - ANGLES[0]) ** 2
        # the matrix holds K/theta, from z - 1, and its eigenvalue is of the order of K
        rounding = 4e-16 * (K / ANGLES[0] ** 2 + abs(B))
        assert worst - rounding <= need <= worst + slack


@pytest.mark.parametrize("delay", [0.0, 0.25, 0.5, 1.0, 2.7])
def test_stiffness_takes_from_the_margin_of_a_damper(delay):
    """Where mere damping is not passive, no stiffness is; the stiffest passive wall rests on it."""
    for B in (0.7, -0.7, 1.5, -1.5):
        needs = [needed(K, B, delay).max() for K in (0.0, 0.01, 0.3, 2.0)]
        assert needs == sorted(needs)


@pytest.mark.parametrize("delay", [0.0, 0.25, 0.5, 1.0, 2.7, 8.0])
def test_principal_sheet_is_condition_5_as_printed(delay):
    alpha, beta = np.array(WALLS).T
    found = 1 - passivity_margin(alpha, beta, 1.0, delay, sheet="principal")
    assert passivity_margin(0.0, 0.0, 1.0, delay, sheet="principal") == 1  # of no wall
    for need, K, B in zip(found, alpha, beta, strict=True):
        worst = printed(K, B, delay).max()
        slack = 10 * (delay + 1) ** 3 * (K + abs(B)) * (ANGLES[1] - ANGLES[0]) ** 2
        # the print divides cosines by 2 - 2 cos: rounding of 1e-16 over the first step squared
        assert worst - 1e-9 <= need <= worst + slack + 1e-9


@pytest.mark.parametrize("delay", [1, 3, 12])
def test_whole_delays_against_fejer_sums(delay):
    """(5) for whole d is alpha (1/2 + sum of cos i theta) - beta cos (d+1) theta."""
    for alpha, beta in RNG.uniform([0, -1], [1, 2], size=(20, 2)):
        kernel = 0.5 + np.cos(np.outer(np.arange(1, delay + 1), ANGLES)).sum(axis=0)
        worst = (alpha * kernel - beta * np.cos((delay + 1) * ANGLES)).max()
        need = 1 - passivity_margin(alpha, beta, 1.0, delay)
        assert worst - 1e-12 <= need <= worst + 1e-3 * delay**3


@pytest.mark.parametrize("delay", [0.1, 0.25, 0.5, 0.9, 1.0, 1.3, 4.6, 5.0])
def test_boundary_has_no_margin_and_its_angle_is_the_worst(delay):
    omega = np.linspace(0.01, 0.99, 30) * np.pi / (delay + 1)
    alpha, beta = passivity_boundary(omega, 1.0, delay)
    there = alpha >= 0
    assert there[:20].all()
    margin = passivity_margin(alpha[there], beta[there], 1.0, delay)
    assert np.abs(margin).max() < 1e-13
    for K, B, angle in list(zip(alpha, beta, omega, strict=True))[:25:6]:
        near = angle + np.array([-1e-3, 0, 1e-3])
        need = needed(K, B, delay, near)
        assert need.argmax() == 1


def test_boundary_of_whole_delays_is_27_as_printed():
    for d in (0.5, 1, 3):
        w = np.linspace(0.2, 0.9, 8) * np.pi / (d + 1)
        below = np.sin(2 * (d + 1) * w) - 2 * (1 + d) * np.sin(w)
        up = np.sin((d + 2) * w) - 2 * np.sin((d + 1) * w) + np.sin(d * w)
        right = d * np.sin((d + 1) * w) - (1 + d) * np.sin(d * w)
        found = passivity_boundary(w, 0.7, d, sheet="principal")
        assert np.allclose(found[0], 0.7 * 2 * (d + 1) * up / below, rtol=1e-11)
        assert np.allclose(found[1], 0.7 * 2 * right / below, rtol=1e-9, atol=1e-12)


def test_boundary_at_low_frequencies_loses_no_digits():
    """Limit of (27): 6 (d+1)/((2d+1)(2d+3)) and d/(2d+3), where the print is 0/0."""
    for d in (1, 4, 10_000):
        alpha, beta = passivity_boundary(1e-6 / (d + 1), 1.0, d)
        assert alpha == pytest.approx(6 * (d + 1) / ((2 * d + 1) * (2 * d + 3)), rel=1e-11)
        assert beta == pytest.approx(d / (2 * d + 3), rel=1e-11)


@pytest.mark.parametrize("delay", [0.1, 0.25, 0.5, 0.75, 1.5, 4.2])
def test_largest_stiffness_by_minimising_the_worst_need(delay):
    def worst(beta):
        return needed(1.0, beta, delay).max()

    best = minimize_scalar(worst, bounds=(-0.5, 3), method="bounded", options={"xatol": 1e-9})
    K, B, theta = max_passive_stiffness(1.0, delay)
    # the grid of angles: as above
    assert pytest.approx(1 / best.fun, rel=1e-5) == K
    assert pytest.approx(best.x / best.fun, abs=2e-3) == B
    assert passivity_margin(K, B, 1.0, delay) == pytest.approx(0, abs=1e-13)
    assert passivity_margin(K * (1 + 1e-9), B, 1.0, delay) < 0
    assert needed(K, B, delay, theta + np.array([-1e-3, 0, 1e-3])).argmax() == 1


def test_largest_stiffness_in_closed_form():
    # (11) in the form 2 tan(pi/(4 (d+1))); at d = 1/2 the root of the polynomial of chapter s6f
    d = np.array([0, 1, 2, 7, 1000, 10**8])
    found = max_passive_stiffness(3.0, d)
    assert isinstance(found, Extremum)
    assert np.allclose(found.alpha, 6 * np.tan(np.pi / (4 * (d + 1))), rtol=1e-14)
    last = np.pi / (2 * (d + 1))
    direct = 3 * (np.cos(last) - d / (d + 1)) / np.sin(last)
    assert np.allclose(found.beta[:5], direct[:5], rtol=1e-12, atol=1e-15)
    assert found.beta[5] == pytest.approx(3 * 2 / np.pi, rel=1e-7)  # its limit
    assert found.beta[0] == 0
    K = float(max_passive_stiffness(1.0, 0.5).alpha)
    roots = np.roots([1, 24, -16, -2816, 73472, 694272, -913408])
    assert np.abs(roots - K).min() < 1e-12
    assert max_passive_stiffness(1.0, 0.5, sheet="principal").alpha == pytest.approx(2 / 3**0.5)


def test_a_longer_delay_can_help():
    # fractional-longer-delay, and the limiting points of fractional-limit-points
    assert is_passive(0, 1.2, 1.0, [0, 0.5, 1]).tolist() == [False, True, False]
    assert needed(0, 1.2, 0.5).max() < 1
    end = np.roots([1, 40, 144, -256]).real.max()
    for damping, passive in ((end - 1e-9, True), (end + 1e-9, False), (-1, True), (-1.001, False)):
        assert is_passive(0, damping, 1.0, 0.5) == passive


def test_pulling_walls_are_never_passive():
    """Four unit steps against K = -1 extract energy for b up to 3/2; n steps for n b > n(n-1)/2."""
    assert not is_passive(-1e-12, 0.0, 5.0, [0, 0.5, 3]).any()
    assert np.isneginf(passivity_margin(-1.0, 0.0, 5.0, 0))


def test_border_counts_as_passive():
    assert is_passive([2.0, 1.0, 0.0, 0.0], [0.0, 0.5, 1.0, -1.0], 1.0, 0).all()
    assert is_passive(0.0, 0.0, 0.0, [0, 0.5, 7]).all()


def test_scaling_and_broadcasting():
    alpha, beta = RNG.uniform(0, 1, size=(2, 3, 1))
    delay = np.array([0, 0.3, 1, 2.5])
    margin = passivity_margin(alpha, beta, 1.0, delay)
    assert margin.shape == (3, 4)
    assert margin.dtype == np.float64
    for scale in (1e-200, 3.0, 1e60):
        scaled = passivity_margin(scale * alpha, scale * beta, scale, delay)
        assert np.allclose(scaled, scale * margin, rtol=1e-12, atol=1e-13 * scale)


def test_a_huge_delay_costs_no_more_and_is_right():
    # K (d + 1/2) = 1 + B at low frequencies, for B in the range of (9)
    for delay in (1e6, 1e6 + 0.5, 1e12):
        K = 1.2 / (delay + 0.5)
        assert passivity_margin(0.999 * K, 0.2, 1.0, delay) > 0
        assert passivity_margin(1.001 * K, 0.2, 1.0, delay) < 0


def test_nan_in_nan_out():
    nan = np.nan
    for arguments in ((nan, 0, 1, 0), (0, nan, 1, 0), (0, 0, nan, 0), (0, 0, 1, nan)):
        for shift in (0, 0.5):
            moved = (*arguments[:3], arguments[3] + shift)
            assert np.isnan(passivity_margin(*moved))
            assert not is_passive(*moved)
    for arguments in ((nan, 1, 0.5), (1, nan, 0.5), (1, 1, nan)):
        assert np.isnan(passivity_boundary(*arguments)).all()
    for arguments in ((nan, 0.5), (nan, 1), (1, nan)):
        assert np.isnan(max_passive_stiffness(*arguments)).all()
    mixed = passivity_margin([1.0, nan], 0.0, 1.0, 0.5)
    assert np.isfinite(mixed[0])
    assert np.isnan(mixed[1])


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: passivity_margin(1, 0, -1, 0), "delta: -1.0 .* delta >= 0"),
        (lambda: is_passive(1, 0, 1, -0.5), "delay: -0.5 .* delay >= 0"),
        (lambda: is_passive(1, 0, np.inf, 0), "delta: inf"),
        (lambda: is_passive(np.inf, 0, 1, 0), "alpha: inf"),
        (lambda: passivity_boundary(4.0, 1, 0), "theta: 4.0 .* 0 < theta < pi"),
        (lambda: passivity_boundary([1.0, 0.0], 1, 0), "theta: 0.0"),
        (lambda: max_passive_stiffness(1, np.inf), "delay: inf"),
        (lambda: is_passive(1, 0, 1, 0, sheet="literal"), "sheet: 'literal' .*'exact'"),
    ],
)
def test_the_impossible_is_refused_by_name(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_the_old_name_of_the_angle_stays_with_a_warning():
    """In the function and as the axis of a sweep, until the next minor version."""
    angles = np.array([0.5, 1.0])
    wanted = passivity_boundary(angles, 1.0, 1)
    with pytest.warns(DeprecationWarning, match="omega: is now theta"):
        found = passivity_boundary(omega=angles, delta=1.0, delay=1)
    assert np.array_equal(found, wanted)
    with pytest.warns(DeprecationWarning, match="omega: is now theta"):
        rows = sweep("passivity_boundary", omega=angles, delta=1.0, delay=1)
    assert rows.alpha.dims == ("theta",)
    assert np.array_equal(rows.alpha, wanted[0])

"""The oracles among themselves: plain loops, states, polynomials and energies say the same."""

import numpy as np
import oracle
import pytest
from oracles import energy, motion
from oracles.search import edge, stiffest


@pytest.mark.parametrize("late", [0.0, 0.5, 1.0, 2.3])
def test_a_simulated_loop_is_the_power_of_its_state_matrix(late):
    alpha, beta, gamma, delta = 0.2, 0.3, 0.4, 0.1
    matrix = oracle.loops(alpha, beta, gamma, delta, late)
    state = np.zeros(len(matrix))
    state[1] = 1.0
    found = []
    for _ in range(80):
        found.append(state[0])
        state = matrix @ state
    place = motion.positions(alpha, beta, 1.0, delta, gamma, 1.0, late, steps=79)
    assert np.allclose(place, found, rtol=0, atol=1e-13 * np.abs(found).max())
    radius = oracle.moduli(alpha, beta, gamma, delta, late).max()
    assert motion.grows(place) == (radius > 1)


@pytest.mark.parametrize("late", [0.0, 2.0, 0.3, 1.6])
def test_the_energy_form_is_the_sum_over_all_pieces(late):
    rng = np.random.default_rng(11)
    K, B, b, T, periods = 300.0, 0.4, 1.5, 2e-3, 12
    whole, part = int(late), late % 1
    times = [part * T, (1 - part) * T] if part else [T]
    moves = rng.normal(size=(periods, len(times)))
    total, place, before, forces = 0.0, 0.0, 0.0, [0.0] * (whole + 1)
    for move in moves:
        forces.append(K * place + B * (place - before) / T)
        felt = [forces[-2 - whole], forces[-1 - whole]] if part else [forces[-1 - whole]]
        for step, time, force in zip(move, times, felt, strict=True):
            total += b * step**2 / time + force * step
        before, place = place, place + move.sum()
    scaled = (moves * np.sqrt(b / np.array(times))).ravel()
    form = energy.form(energy.wall(K, B, T), b, T, late, periods)
    assert scaled @ form @ scaled == pytest.approx(total, rel=1e-12)


def test_what_one_angle_needs_is_what_long_motions_show():
    for K, B, late in ((0.8, 0.1, 0), (0.3, 0.5, 2)):
        # 400 periods miss by (d+1)^2 pi^2/400^2
        found = 1 - energy.left(K, B, late=late, periods=400)
        assert found == pytest.approx(energy.need(K, B, late).max(), abs=1e-3)


def test_searches_on_what_is_known():
    assert edge(0.0, 2.0, lambda x: x * x < 2) == pytest.approx(2**0.5, rel=1e-14)
    theta = 0.7
    alpha, beta = (float(x) for x in oracle.wall(theta, 0, 0, 1))
    assert oracle.residual(alpha, beta, theta, 0, 0, 1) < 1e-15
    # the free mass by hand
    assert alpha == pytest.approx(4 * np.tan(theta / 2) ** 2 * np.cos(2 * theta), rel=1e-14)
    # alpha = 2 beta (2 - beta)/(2 + beta) of Gil et al., largest at beta = 2 sqrt(2) - 2
    alpha, beta = stiffest(0, 0, 0, 0.3, 1.5)
    assert alpha == pytest.approx(12 - 8 * 2**0.5, rel=1e-12)
    assert beta == pytest.approx(2 * 2**0.5 - 2, abs=1e-5)

"""Softer walls: their energies, and loops that only their stiffness keeps stable."""

import numpy as np
import oracle
import pytest
from oracles import energy, motion
from oracles.guarding import guards
from oracles.subject import counterexample, number, only, shown

pytestmark = pytest.mark.ci

SOFT = "s5b_soft_contacts"


@guards("s5b_soft_contacts")
def test_a_share_of_the_stiffness_of_a_passive_wall():
    walls = [(d, direction) for d in (0, 1, 3) for direction in (-1.4, -0.3, 0.6, 1.5)]

    def agrees(softer, without):
        for d, direction in walls:
            K, B = np.cos(direction), np.sin(direction)
            for angle in (0.3, 1.1, 2.8):
                at = {"K": K, "B": B, "b": 1.3, "T": 1.0, "d": d, "theta": angle}
                angles = np.array([angle])
                need = [energy.need(y * K, B, d, angles)[0] for y in (0.6, 0)]
                assert number(softer, y=0.6, **at) == pytest.approx(1.3 - need[0], abs=1e-12)
                assert number(without, **at) == pytest.approx(1.3 - need[1], abs=1e-12)

    titles = (
        "With a share $y$ of the stiffness the margin is a weighted mean of two margins",
        "Without stiffness the margin of a passive wall is not negative",
    )
    only(agrees, *(shown(SOFT, title) for title in titles))
    for d, direction in walls:
        wall = np.array([np.cos(direction), np.sin(direction)])
        K, B = 0.99 * wall / energy.need(*wall, d).max()
        for y in (1.0, 0.7, 0.3, 0.0):
            assert energy.left(y * K, B, late=d) > -1e-12
            assert oracle.stable(y * K, B, 0.2, 1.0, d)


@guards("s5b_soft_contacts")
def test_walls_that_only_their_stiffness_keeps_stable():
    soft = counterexample(SOFT, "s5b-soft-contacts")
    assert soft["y"] == 0
    walls = [(*(soft[n] for n in ("alpha", "beta", "gamma", "delta")), int(soft["d"]))]
    walls.append((0.3, 0.47, 3, 0.02, 2))
    for alpha, *rest in walls:
        assert oracle.certified(alpha, *rest) == 0
        assert oracle.certified(0.0, *rest) > 0
    alpha, beta, gamma, delta, d = walls[1]
    for stiffness, grows in ((alpha, False), (0.0, True)):
        place = motion.positions(stiffness, beta, 1.0, delta, gamma, 1.0, float(d), steps=3000)
        assert motion.grows(place) == grows
    # neither wall is passive
    assert all(energy.need(a, b, d).max() > delta for a, b, _, delta, d in walls)

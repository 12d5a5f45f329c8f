"""Device, wall and delay: Newton's law of two bodies, a wall fed with samples, a late force."""

import mpmath
import numpy as np
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import number, only, settled, shown, value

pytestmark = pytest.mark.ci

ARM = {"m_D": 0.4, "b_D": 1.5, "m_H": 1.8, "b_H": 26.2, "k_H": 199.1}


def pushed(masses, dampers, spring, grip, time):
    """Position of the device after a unit force; ``grip`` couples it to the arm's mass."""
    (m_D, m_H), (b_D, b_H) = masses, dampers
    state = mpmath.zeros(5)
    state[0, 2] = state[1, 3] = 1
    state[2, 0], state[2, 1] = -grip / m_D, grip / m_D
    state[3, 0], state[3, 1] = grip / m_H, -(grip + spring) / m_H
    state[2, 2], state[3, 3], state[2, 4] = -b_D / m_D, -b_H / m_H, 1 / mpmath.mpf(m_D)
    return mpmath.expm(state * time, method="taylor")[0, 4]


def single(m, b, k, time):
    """The same for one body."""
    state = mpmath.matrix([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]])
    return mpmath.expm(state * time, method="taylor")[0, 2]


@guards("s2a_device")
def test_two_bodies_in_a_firm_grip_move_as_one():
    grip = mpmath.mpf(10) ** 12  # in place of a rigid one: it gives way by force over grip
    both = (ARM["m_D"], ARM["m_H"]), (ARM["b_D"], ARM["b_H"]), ARM["k_H"]
    times = [mpmath.mpf(t) for t in (0.03, 0.4)]
    found = [pushed(*both, grip, t) for t in times]
    alone = [pushed(*both, 0, t) for t in times]

    def agrees(places):
        def moves(*numbers):
            moved = [single(*(value(n, **ARM) for n in numbers), t) for t in times]
            assert all(abs(x - y) < 10 / grip for x, y in zip(moved, places, strict=True))

        return moves

    only(agrees(found), *(line.rhs for line in settled("s2a_device", "eq2")))
    only(agrees(alone), *(line.rhs for line in settled("s2a_device", "eq3")))


@guards("s2b_wall")
def test_the_transfer_function_is_that_of_the_samples():
    rng = np.random.default_rng(21)
    K, B, T = 700.0, 3.0, 1e-3
    x = np.concatenate([rng.normal(size=12), [0]])
    force = K * x + B * np.diff(x, prepend=0) / T
    z = 0.8 * np.exp(0.7j)
    powers = z ** -np.arange(13.0)
    found = (force @ powers) / (x @ powers)

    def agrees(transfer):
        # 13 terms with a rounding each
        assert complex(value(transfer, K=K, B=B, T=T, z=z)) == pytest.approx(found, rel=1e-13)

    only(agrees, settled("s2b_wall", "eq1")[0].rhs)


@guards("s2b_wall")
def test_at_rest_the_wall_is_a_spring():
    x, K, B, T = np.full(5, 0.02), 700.0, 3.0, 1e-3
    force = K * x[1:] + B * np.diff(x) / T

    def agrees(stiffness):
        assert np.allclose(force, number(stiffness, K=K) * x[1:], rtol=1e-15, atol=0)

    only(agrees, shown("s2b_wall", "At a constant position the wall is its spring alone"))


@guards("s2c_delay")
def test_a_late_force_has_moved_the_mass_at_the_next_sample():
    def agrees(first):
        for late in (0.1, 0.5, 0.9):
            # a free mass, pushed by 1 N at the time ``late``: one exponential and its rounding
            moved = motion.held(1.0, 0.0, 0.0, 1 - late)[1][0]
            assert number(first, d=late) == pytest.approx(moved, rel=1e-13)

    only(
        agrees,
        shown(
            "s2c_delay",
            "A force that is delayed by less than a period changes the next sample",
        ),
    )

"""Connections of systems: energies of random ones, and lags in a chain that runs."""

import numpy as np
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import counterexample, number, only, shown, value
from scipy.linalg import expm

pytestmark = pytest.mark.ci

CHAPTER = "s3_interconnection"


def passive(rng, size=30):
    """A causal system whose energy is not negative in any of its motions, as a matrix."""
    form = rng.normal(size=(size, size))
    form = form @ form.T / size
    return 2 * np.tril(form, -1) + np.diag(np.diag(form))


def lags(count):
    """State matrix of lags in a chain, 1/(s+1) each, and the input of the first."""
    return -np.eye(count) + np.eye(count, k=-1), np.eye(count)[0]


def answer(count, omega, t):
    """What a chain of lags puts out under cos(omega t), long after its start."""
    chain, entry = lags(count)
    motion = np.zeros((count + 2, count + 2))
    motion[:count, :count], motion[:count, count] = chain, entry
    motion[count, count + 1], motion[count + 1, count] = -omega, omega
    return (expm(motion * t) @ np.eye(count + 2)[count])[count - 1]


@guards("s3_interconnection")
def test_what_two_systems_take_in_comes_from_outside():
    rng = np.random.default_rng(36)
    one, two = passive(rng), passive(rng)
    speed = rng.normal(size=30)
    taken = speed @ one @ speed + speed @ two @ speed
    force = one @ speed + two @ speed

    def agrees(power):
        pairs = zip(force, speed, strict=True)
        assert sum(number(power, F=F, v=v) for F, v in pairs) == pytest.approx(taken, rel=1e-12)

    only(agrees, shown(CHAPTER, "Two coupled systems receive energy only from outside"))


@guards("s3_interconnection")
def test_the_mean_power_that_lags_take_from_a_sine():
    def agrees(one, two):
        for omega in (0.4, 2.0):
            # 40 lags' times after the start, e^-40 = 4e-18; 16 instants are exact for a sine
            times = 40 + 2 * np.pi / omega * np.arange(16) / 16
            for count, ours in ((1, one), (2, two)):
                power = [np.cos(omega * t) * answer(count, omega, t) for t in times]
                assert number(ours, omega=omega) == pytest.approx(2 * np.mean(power), abs=1e-12)

    two = shown(CHAPTER, "Two lags in a chain are not passive")
    only(agrees, shown(CHAPTER, "One lag is passive"), two)
    point = counterexample(CHAPTER, "s3-interconnection")
    one, other = (complex(point[f"R_{n}"], point[f"X_{n}"]) for n in (1, 2))
    assert one == other == pytest.approx(1 / (1 + 2j), rel=1e-15)  # of a lag at omega = 2
    assert number(two, omega=2.0) == pytest.approx((one * other).real, rel=1e-14)


@guards("s3_interconnection")
def test_three_lags_in_a_loop_grow_and_a_pushed_mass_drifts():
    chain, _ = lags(3)
    chain[0, 2] -= 27
    assert np.linalg.eigvals(chain).real.max() == pytest.approx(0.5, abs=1e-12)

    def agrees(polynomial):
        for s in (0.3, -2 + 1j):
            found = np.linalg.det(s * np.eye(3) - chain)
            assert complex(value(polynomial, s=s)) == pytest.approx(found, rel=1e-13)

    only(agrees, shown(CHAPTER, "A loop of three lags with a gain of 27 is unstable"))

    def agrees_with_the_mass(drift):
        for t in (0.2, 70.0):
            move, _ = motion.held(1.3, 0.0, 0.0, t)
            assert number(drift, t=t) == pytest.approx(move[0, 1], rel=1e-13)

    only(agrees_with_the_mass, shown(CHAPTER, "A free mass drifts after a push"))

"""Delays that a safe wall bears: none at which some arm makes it unstable, and no gap between."""

from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from hands import growth, loops, moved

from symhaptic.bounds.safe.check import recheck
from symhaptic.bounds.safe.curve import walls
from symhaptic.bounds.safe.delay import borne, guessed
from symhaptic.bounds.safe.passive import is_passive, passive
from symhaptic.numeric.passivity import passivity_margin
from symhaptic.numeric.stability import is_stable

pytestmark = pytest.mark.ci

CASE = loops("0.1", "0.5", 1, ((0, 2), (0, 20), (0, 1000)))
K, B = 9000.0, 40.0


@cache
def shown():
    return borne(CASE, K, B)


@pytest.mark.ci
def test_no_arm_makes_it_unstable_at_a_delay_that_is_borne():
    at, _ = shown()
    rng = np.random.default_rng(1)
    for i in range(60):
        m, b, k = moved(CASE, rng, None if i % 2 else rng.integers(0, 2, 3))
        delay = float(CASE.periods[0]) + rng.choice([rng.uniform(), 1.0]) * float(at - 1)
        assert growth(K, B, m, b, k, 1e-3, delay) < 1, (m, b, k, delay)


def test_hardly_a_delay_is_left_out():
    at, _ = shown()
    assert 0.95 < float(at) / guessed(CASE, K, B) < 1
    assert growth(K, B, 0.1, 0.5, 0.0, 1e-3, 1.02 * guessed(CASE, K, B)) > 1


def test_delays_follow_each_other_and_are_checked_and_no_others():
    at, chain = shown()
    ends = [claim.loops.periods for claim in chain]
    assert len(chain) > 2
    assert ends[-1][1] == at
    assert all(one[1] == other[0] for one, other in pairwise(ends))
    assert all(map(recheck, chain))
    last = chain[-1]
    ahead = (last.loops.periods[0], last.loops.periods[1] + Fraction(1, 5))
    assert not recheck(replace(last, loops=last.loops._replace(periods=ahead)))
    low, high = chain[0].loops.periods  # from the later to the earlier, no delay is in it
    assert not recheck(replace(chain[0], loops=chain[0].loops._replace(periods=(high, low))))


@pytest.mark.parametrize("ends", [("1", "5/4"), ("0", "1/8"), ("7/4", "2")])
def test_walls_at_delays_of_a_range_are_in_its_box(ends):
    low, high = map(Fraction, ends)
    late = CASE._replace(periods=(low, high))
    hands = ((Fraction(1), Fraction(1)), (Fraction(5), Fraction(5)), (Fraction(300), Fraction(300)))
    for theta in (Fraction(1, 50), Fraction(1, 5), Fraction(4, 5)):
        found = walls(late, (theta, theta), hands)
        for delay in (low, (2 * low + high) / 3, high):
            one = walls(CASE._replace(periods=(delay, delay)), (theta, theta), hands)
            for wide, narrow in zip(found[:2], one[:2], strict=True):
                assert wide[0] <= narrow[1]
                assert narrow[0] <= wide[1]


@pytest.mark.parametrize("periods", [0, "1/2", 1, "5/2"])
def test_passive_corners_are_passive_and_walls_just_beyond_are_refused(periods):
    case = loops("0.1", "0.5", periods)
    corners = np.array(passive(case))
    assert len(corners) > 10
    alpha, beta = (corners * [1e-6 / 0.1, 1e-3 / 0.1]).T
    assert (passivity_margin(alpha, beta, 0.5e-2, float(Fraction(periods))) >= 0).all()
    for K_there, B_there in corners[5::9]:
        if K_there > 1:
            assert not is_passive(case, (1.01 * K_there, 1.01 * B_there))
    assert not is_passive(case, (-1.0, 0.0))
    assert not passive(loops("0.1", 0, periods))


def test_passive_walls_are_stable_with_every_arm():
    """By (2) and (3): an arm is passive, and so is what it holds."""
    corners = np.array(passive(CASE))
    rng = np.random.default_rng(4)
    stiff = corners[corners[:, 0] > 0]
    for _ in range(30):
        m, b, k = moved(CASE, rng)
        K_there, B_there = stiff.T
        assert is_stable(
            K_there * 1e-6 / m, B_there * 1e-3 / m, k * 1e-6 / m, b * 1e-3 / m, 1
        ).all()

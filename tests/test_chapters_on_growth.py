"""What enlarges the stable region, seen by companion eigenvalues."""

from fractions import Fraction

import numpy as np
import pytest
from scipy.signal import cont2discrete
from sympy import Rational, S

from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.proof.theorems.kernel import NotShown

RNG = np.random.default_rng(41)


def radius(al, be, g, dl, delay):
    """Spectral radius from SciPy's zero-order hold."""
    top, bottom, _ = cont2discrete(([1.0], [1.0, dl, g]), 1.0, method="zoh")
    p = np.concatenate([bottom, np.zeros(delay + 1)])
    p[-3:] += np.convolve(top[0][1:], [al + be, -be])
    return np.abs(np.roots(p)).max()


def test_no_stable_wall_is_lost_to_damping_without_delay():
    """s4d-delta-grows inside (23): 600 random walls and pairs of dampings."""
    stable = 0
    for _ in range(600):
        g, one = RNG.uniform(0, 1e-3), RNG.uniform(0, 0.02)
        two = RNG.uniform(one, 0.02)
        al, be = RNG.uniform(-g, 0.75), RNG.uniform(-0.03, 2.1)
        if radius(al, be, g, one, 0) < 1 - 1e-9:
            stable += 1
            assert radius(al, be, g, two, 0) < 1
    assert stable > 100


@pytest.mark.parametrize(
    ("wall", "before", "after"),
    [
        # the numbers that the chapters' texts quote
        ((-4.0, 5.9), (5.0, 1.2, 0), (5.0, 1.5, 0)),
        ((269 / 400, 97 / 100), (0.0, 0.0, 0), (1e-3, 0.0, 0)),
        ((-9e-4, -0.011), (1e-3, 0.01, 1), (1e-3, 0.01, 0)),
        ((1e-4, -0.022), (1e-3, 0.02, 40), (1e-3, 0.02, 0)),
    ],
)
def test_counterexamples_by_eigenvalues(wall, before, after):
    assert radius(*wall, *before) < 1 < radius(*wall, *after)


def test_twice_the_mass_destabilises():
    one = float(Fraction(9, 800)), float(Fraction(-13, 4000)), 0.0, 0.02
    assert radius(*one, 1) < 1 < radius(*(v / 2 for v in one), 1)


@pytest.mark.parametrize("delay", [0, 1, 3, 10])
def test_the_lower_corner_sinks_by_the_stiffness(delay):
    """s4d-delay-shrinks: just right of alpha = -gamma the loop is lost below beta_0."""
    g, dl = 1e-3, 0.01
    top, _, _ = cont2discrete(([1.0], [1.0, dl, g]), 1.0, method="zoh")
    n1, n0 = top[0][1:]
    corner = -(1 - np.exp(-dl)) / (n1 + n0) - g * (delay + 1 - n1 / (n1 + n0))
    near = -g + 1e-7
    assert radius(near, corner + 1e-3, g, dl, delay) < 1
    assert radius(near, corner - 1e-3, g, dl, delay) > 1


def test_a_root_on_the_wrong_side_is_not_shown():
    """Mutants of the counterexample: the dampings exchanged."""
    point = {alpha: S(-4), beta: Rational(59, 10), gamma: S(5), d: S.Zero}
    light, heavy = ({**point, delta: Rational(n, 10)} for n in (12, 15))
    assert stable_at(light)
    assert unstable_at(heavy)
    with pytest.raises(NotShown):
        stable_at(heavy)
    with pytest.raises(NotShown):
        unstable_at(light)

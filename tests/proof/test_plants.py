"""Balls of the plant's numbers contain SciPy's and mpmath's values."""

import mpmath
import numpy as np
import pytest
from flint import acb, arb
from scipy.linalg import expm

from symhaptic.notation import delta, gamma
from symhaptic.proof.plants import AT_ONE, LATE, LOSS, SLOPES, TOGETHER, numbers


def plant(g, dl):
    """1 - e, n1 + n0, n0 and 1 - a + e from SciPy's matrix exponential."""
    grown = expm(np.array([[0, 1, 0], [-g, -dl, 1], [0, 0, 0]], dtype=float))
    a, e = grown[0, 0] + grown[1, 1], np.exp(-dl)
    n1 = grown[0, 2]
    n0 = grown[0, 1] * grown[1, 2] - grown[1, 1] * grown[0, 2]
    return 1 - e, n1 + n0, n0, 1 - a + e


@pytest.mark.parametrize(
    ("g", "dl"), [(0, 0), (0, 0.02), (0.001, 0.01), (1, 2), (0.25, 1), (9.8, 0.5), (5, 1.5)]
)
def test_values_and_slopes(g, dl):
    at = {gamma: acb(arb(g)), delta: acb(arb(dl))}
    found = numbers(at, sloped=True)
    for name, value in zip((LOSS, TOGETHER, LATE, AT_ONE), plant(g, dl), strict=True):
        # 1e-14: rounding of SciPy's exponential
        assert abs(float(found[name].real.mid()) - value) < 1e-14
    mpmath.mp.dps = 30
    for i, name in enumerate(SLOPES):

        def value(x, i=i):
            grown = mpmath.expm(mpmath.matrix([[0, 1, 0], [-g, -x, 1], [0, 0, 0]]))
            n1 = grown[0, 2]
            n0 = grown[0, 1] * grown[1, 2] - grown[1, 1] * grown[0, 2]
            a, e = grown[0, 0] + grown[1, 1], mpmath.exp(-x)
            return (1 - e, n1 + n0, n0, 1 - a + e)[i]

        slope = mpmath.diff(value, mpmath.mpf(dl))
        assert abs(float(found[name].real.mid()) - float(slope)) < 1e-10


def test_an_interval_contains_its_points():
    wide = {gamma: acb(arb(0).union(arb("0.001"))), delta: acb(arb(0).union(arb("0.02")))}
    found = numbers(wide, sloped=True)
    for g in (0.0, 0.0004, 0.001):
        for dl in (0.0, 0.013, 0.02):
            for name, value in zip((LOSS, TOGETHER, LATE, AT_ONE), plant(g, dl), strict=True):
                ball = found[name].real
                # 1e-15: the point itself is rounded
                assert float(ball.lower()) - 1e-15 <= value <= float(ball.upper()) + 1e-15

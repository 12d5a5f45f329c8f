"""The search for a root of a cubic ends after few steps, and has the root's own digits then."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest

from symhaptic.export.precision import PRECISIONS
from symhaptic.export.routines import roots
from symhaptic.kernels import haptic

pytestmark = pytest.mark.ci

RNG = np.random.default_rng(452)


def pieces(precision, count):
    """Cubics on pieces of (-4, 4) that cross zero, and have neither extremum nor inflection.

    Among them are double and triple roots, next to which a piece ends, and roots as faint as the
    square of the faintest wall.
    """
    smallest = float(np.log2(float(precision.vanishing) ** 2))
    while count:
        root = RNG.uniform(0.1, 3.9) * 2.0 ** RNG.choice([0, 0, -1, RNG.uniform(smallest + 3, 0)])
        apart = root * 10.0 ** RNG.choice([RNG.uniform(-8, 2), 0, 5, 12])
        others = [(root + apart, RNG.uniform(-5, 9)), (root - apart, root - apart),
                  (-apart, -2 * apart), (root * 1.3, root * 1.3)][RNG.integers(4)]  # fmt: skip
        k = np.polynomial.polynomial.polyfromroots([root, *others]) * RNG.choice([-1, 1])
        k = np.asarray(k * 2.0 ** RNG.integers(-20, 20), precision.kind)
        if RNG.random() < 0.3:
            k[3] = 0
        side = RNG.choice([-1, 1])
        k[1::2] *= side
        flat = [0.0, *np.polynomial.Polynomial(np.float64(k)).deriv().roots()]
        flat += [-float(k[2]) / (3 * float(k[3]))] if k[3] else []
        cuts = [float(c.real) for c in flat if abs(np.imag(c)) < 1e-12 and abs(c) < 4]
        cuts = np.unique(np.asarray([-4.0, *cuts, 4.0], precision.kind))
        if RNG.random() < 0.5:  # on both sides of zero, as about the device's own frequency
            cuts = cuts[cuts != 0]
        for low, high in pairwise(cuts):
            ends = [value(k, at) for at in (low, high)]
            bends = [2 * Fraction(float(k[2])) + 6 * Fraction(float(k[3])) * Fraction(float(at))
                     for at in (low, high)]  # fmt: skip
            if ends[0] * ends[1] < 0 and bends[0] * bends[1] >= 0 and count:
                count -= 1
                yield k, low, high, precision.kind(float(ends[1] - ends[0]))


def value(k, y, of=Fraction):
    y = of(Fraction(float(y)))
    return sum(of(Fraction(float(c))) * y**i for i, c in enumerate(k))


@pytest.mark.parametrize("precision", PRECISIONS.values(), ids=PRECISIONS)
def test_what_is_left_of_the_cubic_is_its_own_rounding(precision):
    """In exact fractions; next to a double root this is all that anybody knows of it."""
    faint = 0
    for k, low, high, rise in pieces(precision, 1500):
        one = np.ones(1, precision.kind)
        given = [one * x for x in (*k, low, high, rise)]
        (found,) = haptic.cubic_root(np, *given)
        sizes = sum(abs(Fraction(float(c)) * Fraction(float(found)) ** i) for i, c in enumerate(k))
        if sizes < 16 * Fraction(float(np.finfo(precision.kind).tiny)) * 2**precision.bits:
            continue  # terms that underflow
        assert low <= found <= high
        assert abs(value(k, found)) <= 4 * Fraction(str(precision.last)) * sizes, (k, low, high)
        faint += abs(found) < 1e-6
    assert faint > 50


@pytest.mark.parametrize("precision", PRECISIONS.values(), ids=PRECISIONS)
def test_the_number_of_steps_is_what_the_worst_cubic_needs(precision):
    """Newton's method leaves two thirds of the distance to a triple root, and never more."""
    steps = roots._steps(precision)
    last = Fraction(1, 2**precision.bits)
    left = Fraction(roots._NEAR - 1) * Fraction(2, 3) ** (steps - 1)
    assert Fraction(2, 3) * left < last < Fraction(3, 2) * left


def test_no_cubic_leaves_more_than_two_thirds_of_the_distance():
    """Exact steps from the end from which the method does not overshoot; from beyond an inflection
    it may leave more, which is why pieces are cut there."""
    worst = Fraction(0)
    for _ in range(2000):
        root, b, c = (Fraction(int(x), 64) for x in RNG.integers(-256, 256, 3))
        # (y - root) ((y - b)^2 + c): complex roots for c > 0
        y = root + Fraction(int(RNG.integers(1, 512)), 64)
        rest, slope = (y - b) ** 2 + c, 2 * (y - b)
        steep = rest + (y - root) * slope
        bends = 2 * slope + 2 * (y - root)
        at_root = 4 * (root - b)
        first = (root - b) ** 2 + c
        # the slope is least at the root of a convex piece
        if bends < 0 or at_root < 0 or first <= 0:
            continue
        worst = max(worst, 1 - rest / steep)
        assert 0 <= 1 - rest / steep <= Fraction(2, 3)
    assert worst > Fraction(3, 5)
    # without the cut: the root 0 and 1 +- j/10, from 6/5
    y, b, c = Fraction(6, 5), Fraction(1), Fraction(1, 100)
    assert 1 - ((y - b) ** 2 + c) / ((y - b) ** 2 + c + y * 2 * (y - b)) > Fraction(2, 3)

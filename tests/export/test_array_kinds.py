"""Arrays of other kinds of numbers that users of NumPy have, given to the exported module."""

import numpy as np
import oracle
import pytest

from symhaptic import lambdify
from symhaptic.export import request
from symhaptic.export.targets import TARGETS

pytestmark = pytest.mark.ci


@pytest.fixture(scope="module")
def haptic():
    _, files = request.built(TARGETS["numpy"], request.chosen([]), vectors=False)
    space = {"__name__": "haptic"}
    exec(files["haptic.py"], space)
    return space


WALL = 8.120348091441618e25, -8.697756587568899e26, 2904407845399.803, 5.5892085835498246e-15, 4.0
"""Not stable; of long floats the halves had too many digits, and it counted as stable."""


def test_long_floats_are_rounded_to_doubles(haptic):
    assert oracle.all_inside(*WALL) is False
    long = [np.array([value], np.longdouble) for value in WALL]
    for run in (haptic["is_stable"], lambdify("is_stable")):
        assert run(*long).tolist() == [False]
    n1, *_ = haptic["discretize"](np.array(["1e400", "0.25"], np.longdouble), 1.0)
    assert n1.dtype == np.float64
    assert n1.tolist() == pytest.approx([np.nan, oracle.numbers(0.25, 1.0)[0]], nan_ok=True)


def test_what_is_masked_is_outside_of_every_domain(haptic):
    """Its data, which nobody gave, once counted: a wall that is masked was stable."""
    some = np.ma.array([0.01, 0.01, 1.0], mask=[False, True, False])
    loop = 0.1, 0.001, 0.02, 1.0
    expected = [oracle.stable(alpha, *loop) for alpha in (0.01, 1.0)]
    assert haptic["is_stable"](some, *loop).tolist() == [expected[0], False, expected[1]]
    assert haptic["unstable_roots"](some, *loop)[1] == -1
    limit = haptic["linear_limit"](np.ma.array([1, 2], mask=[True, False]), 0.5, 0.0)
    assert limit.tolist() == pytest.approx([np.nan, 2.5 / 0.5], nan_ok=True)
    assert not haptic["is_stable"](np.ma.masked, *loop)

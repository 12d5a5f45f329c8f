"""The linear limit is the wall for which (25) is an equality."""

import numpy as np
import pytest

from symhaptic import linear_limit


def test_is_the_equality_of_25():
    beta, delta, delay = np.array([-0.01, 0.0, 0.3]), 0.02, np.array([0.0, 0.5, 7.0])
    alpha = linear_limit(beta=beta, delta=delta, delay=delay)
    assert alpha * (0.5 + delay) == pytest.approx(beta + delta)


def test_bad_arguments_are_named():
    with pytest.raises(ValueError, match=r"delta: -1\.0 is not allowed"):
        linear_limit(0.0, [0.1, -1.0], 0)
    assert np.isnan(linear_limit(np.nan, 0.1, 0))

"""Numbers of mpmath have 60 digits in all oracles."""

import mpmath
import pytest


@pytest.fixture(autouse=True)
def digits():
    with mpmath.workdps(60):
        yield

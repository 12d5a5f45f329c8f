"""Exported C beside exact values in ball arithmetic: no result is farther off than recorded."""

import shutil

import pytest

from symhaptic.bench.error import measure
from symhaptic.bench.exact import EXACT
from symhaptic.export import request
from symhaptic.export.accuracy import MEASURED

needs_gcc = pytest.mark.skipif(
    shutil.which("gcc") is None, reason="no gcc here: exported C is not measured"
)


@needs_gcc
@pytest.mark.parametrize("name", MEASURED)
def test_no_error_is_larger_than_the_recorded_one(name):
    """All hard cases and some ordinary ones; the record is that of 10^5 points."""
    (form,) = request.chosen([name])
    for result, (error, point) in measure(form, 1200, seed=2).items():
        assert error <= MEASURED[name], (result, point)


def test_every_function_of_numbers_is_measured():
    assert set(MEASURED) == set(EXACT)
    names = {form.name for form in request.chosen([])}
    assert names - set(MEASURED) == {"is_stable", "stability_conditions"}

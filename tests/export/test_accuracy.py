"""Exported C beside exact values in ball arithmetic: no result is farther off than recorded."""

import importlib.util
import shutil
from pathlib import Path

import pytest

from symhaptic.export import request
from symhaptic.export.accuracy import MEASURED

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "accuracy.py"


@pytest.fixture(scope="module")
def script():
    if shutil.which("gcc") is None:
        pytest.skip("no gcc here: exported C is not measured")
    spec = importlib.util.spec_from_file_location("accuracy", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", MEASURED)
def test_no_error_is_larger_than_the_recorded_one(name, script):
    """All hard cases and some ordinary ones; the record is that of 10^5 points."""
    (form,) = request.chosen([name])
    for result, (error, point) in script.measure(form, 1200, seed=2).items():
        assert error <= MEASURED[name], (result, point)


def test_every_function_of_numbers_is_measured(script):
    assert set(MEASURED) == set(script.EXACT)
    names = {form.name for form in request.chosen([])}
    assert names - set(MEASURED) == {"is_stable", "stability_conditions"}

"""The kernels of plain Python say what those of arrays say, and refuse the same."""

import os
import subprocess
import sys

import numpy as np
import pytest

import symhaptic
from symhaptic.kernels import OF_NUMBERS, haptic, scalar
from symhaptic.numeric import compiled

RNG = np.random.default_rng(21)
COLUMNS = {
    "theta": RNG.uniform(0.01, 3.1, 300),
    "alpha": RNG.normal(size=300),
    "beta": RNG.normal(size=300),
    "gamma": RNG.choice([0, 1e-3, 1, 9, 40], 300) * RNG.uniform(0.5, 1, 300),
    "delta": RNG.choice([0, 1e-3, 1, 5], 300) * RNG.uniform(0.5, 1, 300),
    "d": RNG.choice([0, 0.3, 1, 2.5, 7], 300),
}


def given(name):
    code = getattr(scalar, name).__code__
    return [COLUMNS[n] for n in code.co_varnames[: code.co_argcount]]


@pytest.mark.parametrize("name", OF_NUMBERS)
def test_numbers_are_those_of_the_array_kernels(name):
    columns = given(name)
    found = [getattr(scalar, name)(*point) for point in zip(*map(np.ndarray.tolist, columns),
                                                            strict=True)]  # fmt: skip
    one = np.atleast_2d(np.array(found, dtype=float).T)
    with np.errstate(all="ignore"):
        other = np.atleast_2d(np.asarray(getattr(haptic, name)(*columns), dtype=float))
    last = 16 * 2**-52 * np.nanmax(np.where(np.isfinite(other), abs(other), 0), axis=0)
    assert np.allclose(one, other, rtol=1e-12, atol=np.maximum(last, 1e-15), equal_nan=True)


@pytest.mark.parametrize("name", OF_NUMBERS)
def test_outside_there_is_nothing(name):
    function = getattr(scalar, name)
    count = function.__code__.co_argcount
    for wrong in (float("nan"), float("inf"), -float("inf")):
        assert function(*[wrong] * count) is None


def test_public_functions_take_them(monkeypatch):
    """Numbers in, NumPy's numbers out, and errors by the functions."""
    monkeypatch.setattr(compiled, "MODULE", None)

    def slow(alpha, beta, gamma, delta, delay, sheet="exact"):
        raise LookupError("slow")

    fast = compiled.at_once("is_stable")(slow)
    assert fast(0.5, 1.0, 0.0, 0.0, 0) is np.True_
    for args in ((0.5, 1.0, -1.0, 0.0, 0), ([0.5], 1.0, 0.0, 0.0, 0), (np.nan, 1.0, 0.0, 0.0, 0)):
        with pytest.raises(LookupError):
            fast(*args)
    with pytest.raises(TypeError):
        fast(0.5, 1.0)


def test_without_a_compiler_calls_are_the_same():
    code = (
        "from symhaptic import discretize, is_stable, stability_boundary, unstable_roots\n"
        "print(is_stable(0.5, 1.0, 0.0, 0.0, 0), unstable_roots(5.0, 1.0, 0.0, 0.0, 0),\n"
        "      *discretize(0.0, 0.0), *stability_boundary(1.0, 0.0, 0.0, 0))"
    )
    env = os.environ | {"SYMHAPTIC_KERNELS": "array"}
    told = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True
    )
    alpha, beta = symhaptic.stability_boundary(1.0, 0.0, 0.0, 0)
    words = told.stdout.split()
    assert words[:6] == ["True", "2", "0.5", "0.5", "2.0", "1.0"]
    assert np.allclose([float(w) for w in words[6:]], [alpha, beta], rtol=1e-14)

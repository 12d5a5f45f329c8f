"""Blocks of ordinary arguments: as right as the kernel, the same bits on any instruction set."""

import ctypes
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import symhaptic
from symhaptic.bench.error import errors
from symhaptic.export import request

ufuncs = pytest.importorskip(
    "symhaptic.kernels._compiled", reason="the install found no compiler", exc_type=ImportError
)

KERNELS = Path(symhaptic.__file__).parent / "kernels"
FLAGS = ["-std=c++17", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-shared",
         f"-I{KERNELS}"]  # fmt: skip

GOALS = {"discretize": 2, "stability_boundary": 8, "passivity_margin_at": 4}
"""In units in the last place of the largest term, as for the exported C."""


def columns(name, count, seed):
    """Arguments inside, on and beside the edges of what is ordinary, next to 0, pi and the own
    frequency of the device."""
    rng = np.random.default_rng(seed)
    some = rng.random((5, count))
    gamma = np.where(some[0] < 0.2, 0.0, 10 ** rng.uniform(-14, -1, count))
    delta = np.where(some[1] < 0.2, 0.0, 10 ** rng.uniform(-14, -1.3, count))
    edge = np.nextafter(0.125 - 2 * delta, rng.choice([-1.0, 1.0], count))
    gamma = np.where(some[0] > 0.9, edge, gamma)
    theta = np.where(some[2] < 0.5, rng.uniform(0, np.pi, count), 10 ** rng.uniform(-9, 0, count))
    theta = np.where(some[2] > 0.8, np.pi - 10 ** rng.uniform(-12, 0, count), theta)
    own = np.sqrt(gamma) * (1 + rng.choice([-1, 1], count) * 10 ** rng.uniform(-9, 0, count))
    theta = np.where((some[3] < 0.2) & (gamma > 0), np.minimum(own, 3.0), theta)
    d = np.floor(10 ** rng.uniform(0, 5.3, count)) - 1
    alpha, beta = 10 ** rng.uniform(-6, 2, (2, count)) * rng.choice([-1, 1], (2, count))
    values = {"gamma": gamma, "delta": delta, "theta": theta, "alpha": alpha, "beta": beta, "d": d}
    return [values[s.name] for s in request.chosen([name])[0].arguments]


@pytest.mark.parametrize("name", GOALS)
def test_errors_are_those_of_the_exported_code_at_most(name):
    given = columns(name, 700, 3)
    found = np.array(np.atleast_2d(getattr(ufuncs, name)(*given)))
    assert errors(request.chosen([name])[0], given, found).max() <= GOALS[name]


HARD = {
    "discretize": [(5e-324, 0.0), (0.0, 5e-324), (1e-310, 1e-310), (0.125, -0.0), (-0.0, 0.0625)],
    "stability_boundary": [
        (1e-100, 1e-3, 0.0, 0.0), (1e-90, 0.0, 0.0, 1.0), (3.141592653589793, 0.0, 0.0, 3.0),
        (1.0, 5e-324, 5e-324, 0.0), (1e-5, 1e-10, 0.0, 1e6), (1.0, 1e-3, 0.0, 131072.0),
        (1.0, 1e-3, 0.0, 131073.0), (1.0, 1e-3, 0.02, -0.0), (0.5, 1e-3, 0.02, 2.5),
    ],
    "passivity_margin_at": [
        (1e-300, 1.0, 1.0, 0.1, 2.0), (3.141592653589793, 1.0, 1.0, 0.1, 7.0),
        (1.0, 1e70, -1e70, 1e70, 2.0), (1.0, 5e-324, 0.0, 0.0, 1.0), (1.0, -0.0, -0.0, -0.0, -0.0),
        (1.0, 1.0, 1.0, 0.1, 1e6), (1.0, 1.0, 1.0, 0.1, 0.5),
    ],
}  # fmt: skip


@pytest.mark.parametrize(("name", "given"), [(n, x) for n in HARD for x in HARD[n]])
def test_hard_arguments_beside_balls(name, given):
    columns = [np.array([x]) for x in given]
    found = np.array(getattr(ufuncs, name)(*columns)).reshape(-1, 1)
    assert errors(request.chosen([name])[0], columns, found).max() <= GOALS[name]


@pytest.mark.parametrize("name", GOALS)
def test_what_is_out_of_range_is_nan(name):
    """And told, beside arguments that are inside."""
    given = columns(name, 300, 4)
    for i in range(len(given)):
        for bad in (np.nan, np.inf, -1e-3 if request.chosen([name])[0].arguments[i].name not in
                    ("alpha", "beta") else 1e71):  # fmt: skip
            moved = [a.copy() for a in given]
            moved[i][7] = bad
            ufuncs.outside()
            found = np.atleast_2d(getattr(ufuncs, name)(*moved))
            assert np.isnan(found[0][7])
            assert ufuncs.outside()


def test_bits_depend_neither_on_the_place_nor_on_the_instructions(tmp_path):
    """The loops built for one set without vectors, beside those that this processor takes."""
    if shutil.which("g++") is None:
        pytest.skip("no g++")
    source, plain = tmp_path / "plain.cpp", tmp_path / "plain.so"
    source.write_text('#include "ordinary.cpp"\n' + "".join(
        f'extern "C" void {n}_(int n, double (*x)[256], double (*y)[256]) '
        f"{{ ordinary::{n}(n, *(ordinary::Rows *)x, *(ordinary::Rows *)y); }}\n" for n in GOALS
    ))  # fmt: skip
    subprocess.run(["g++", *FLAGS, "-DONE_SET", "-fno-tree-vectorize", source, "-o", plain],
                   check=True)  # fmt: skip
    library = ctypes.CDLL(str(plain))
    for name in GOALS:
        given = columns(name, 256, 5)
        x, y = np.zeros((5, 256)), np.zeros((5, 256))
        x[: len(given)] = given
        getattr(library, f"{name}_")(256, *(ctypes.c_void_p(a.ctypes.data) for a in (x, y)))
        ordinary = ~np.isnan(y[0])
        assert ordinary.mean() > 0.3
        turned = np.random.default_rng(6).permutation(256)
        found = np.atleast_2d(getattr(ufuncs, name)(*(a[turned] for a in given)))
        known = ordinary[turned]
        assert np.array_equal(found[:, known], y[: len(found), turned][:, known])
        one = [getattr(ufuncs, f"one_{name}")(*map(float, a)) for a in zip(*given, strict=True)]
        kept = [k for k, o in enumerate(one) if o is not None and ordinary[k]]
        alone = np.atleast_2d(np.array([one[k] for k in kept]).T)
        assert np.array_equal(alone, y[: len(found), kept])

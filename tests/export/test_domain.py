"""Outside of the domain nothing is stable, no count is known and every number is NaN."""

import ctypes
import math
import platform
import re
import shutil
import subprocess
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from export.test_targets import run_all

from symhaptic import lambdify
from symhaptic.export import library as libraries
from symhaptic.export import request
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.targets import TARGETS
from symhaptic.export.vectors import vectors
from symhaptic.forms import stable
from symhaptic.model.parts import Parts

pytestmark = pytest.mark.ci

ALL = request.chosen([])
ORDINARY = {"alpha": 0.01, "beta": 0.1, "gamma": 0.001, "delta": 0.02, "d": 1.0, "theta": 0.5,
            "epsilon": 0.5}  # fmt: skip
BAD = {
    name: [math.nan, math.inf, -math.inf, *([] if name in ("alpha", "beta") else [-1.0])]
    for name in ORDINARY
}
BAD["theta"] += [0.0, 4.0]
BAD["epsilon"] += [1.0]
NOTHING = {"is_stable": 0.0, "unstable_roots": -1.0}


def outside(form):
    """An ordinary point with one argument that the contract does not allow, each in its turn."""
    for at, symbol in enumerate(form.arguments):
        for value in BAD[symbol.name]:
            point = [ORDINARY[s.name] for s in form.arguments]
            point[at] = value
            yield point


def alike(found, expected):
    return found == expected or (math.isnan(expected) and math.isnan(found))


def nothing(form, results):
    """Whether these are what a function gives where it can tell nothing."""
    expected = NOTHING.get(form.name, math.nan)
    return all(alike(float(value), expected) for value in results)


@pytest.mark.parametrize("form", ALL, ids=lambda f: f.name)
def test_arrays_and_many_digits(form):
    run = lambdify(form.name) if form.name not in stable.FOR_ONE_DELAY else None
    digits = lambdify(form.name, modules="mpmath") if run else None
    for point in outside(form) if run else ():
        assert nothing(form, np.ravel(run(*point))), point
        found = digits(*map(mpmath.mpf, point))
        assert nothing(form, found if isinstance(found, tuple) else (found,)), point


@pytest.mark.parametrize("form", ALL, ids=lambda f: f.name)
@pytest.mark.parametrize("precision", [DOUBLE, SINGLE], ids=lambda p: p.name)
def test_every_self_test_asks_for_it(form, precision):
    """The vectors have NaN and infinities in each argument, and -1 where that is outside."""
    count = len(form.arguments)
    rows = {tuple(map(str, row[:count])): row[count::2] for row in vectors(form, precision)}
    for at, symbol in enumerate(form.arguments):
        for value in BAD[symbol.name][:4]:
            found = [r for point, r in rows.items() if point[at] == str(value)]
            assert found, (symbol, value)
            assert all(nothing(form, r) for r in found), (symbol, value)


@pytest.mark.slow
@pytest.mark.parametrize("language", TARGETS)
def test_a_self_test_notices_that_nobody_asks(language, tmp_path, monkeypatch):
    """A mutant: the same functions without a guard."""
    plain = libraries.of_form

    def unguarded(form, precision):
        return replace(plain(form, precision), within=())

    forms = request.chosen(["linear_limit", "discretize"])
    target = TARGETS[language]
    if language == "numpy":
        always = "lambda xp, most, x: xp.ones(x.shape, dtype=bool)"
        table = "INSIDE = {{{}}}".format
        monkeypatch.setattr(type(target), "_conditions", lambda _, names: [
            table(", ".join(f'"{name}": {always}' for name in names.values()))
        ])  # fmt: skip
    else:
        monkeypatch.setattr(libraries, "of_form", unguarded)
    _, files = request.built(target, forms)
    request.write(files, tmp_path / "out")
    with pytest.raises(AssertionError, match=r"missed|instead of nan"):
        run_all(target, "haptic", tmp_path / "out")


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """Exported C, called directly."""
    if shutil.which("gcc") is None:
        pytest.skip("no gcc here: exported C is not tried")
    folder = tmp_path_factory.mktemp("c")
    _, files = request.built(TARGETS["c"], ALL, vectors=False)
    for name, text in files.items():
        (folder / name).write_text(text)
    command = ["gcc", "-std=c99", "-O2", "-shared", "-fPIC", "-o", "all.so", "haptic.c", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "all.so")), folder


@pytest.mark.parametrize("form", ALL, ids=lambda f: f.name)
def test_exported_c(compiled, form):
    function = getattr(compiled[0], f"haptic_{form.name}")
    many = len(form.results) if len(form.results) > 1 else 0
    function.restype = ctypes.c_bool if form.truth else None if many else ctypes.c_double
    for point in outside(form):
        results = [ctypes.c_double(7) for _ in range(many)]
        found = function(*map(ctypes.c_double, point), *map(ctypes.byref, results))
        assert nothing(form, [r.value for r in results] or [found]), point


REFUSED = ["-ffast-math", "-Ofast", "-ffinite-math-only"]
if platform.machine() in {"x86_64", "AMD64", "i686"}:
    REFUSED += ["-mfpmath=387"]  # each step is rounded to more digits than a number keeps


@pytest.mark.parametrize("flag", REFUSED)
@pytest.mark.parametrize("language", ["c", "cpp"])
def test_arithmetic_without_nan_or_with_more_digits_is_refused(language, flag, tmp_path):
    compiler, standard = ("gcc", "c99") if language == "c" else ("g++", "c++17")
    if shutil.which(compiler) is None:
        pytest.skip(f"no {compiler} here: its flags are not tried")
    _, files = request.built(TARGETS[language], request.chosen(["linear_limit"]), vectors=False)
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    source = f"haptic.{language}"
    command = [compiler, f"-std={standard}", flag, "-c", source, "-o", "haptic.o"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode != 0
    assert "IEEE arithmetic" in run.stderr
    command[2] = "-O2"
    assert subprocess.run(command, cwd=tmp_path, check=False).returncode == 0


@pytest.mark.parametrize("size", [1e69, 1e71])
def test_sizes_that_no_sum_survives_are_outside(size):
    """As `symhaptic.is_stable` says with an error: numbers up to 1e70."""
    found = lambdify("unstable_roots")(size, 0.1, 0.0, 0.1, 1.0)
    assert found == (2 if size < 1e70 else -1)
    assert not lambdify("is_stable")(size, 0.1, 0.0, 0.1, 1.0)


@pytest.mark.parametrize(
    ("wall", "gamma", "delta"),
    [
        ((3.117699031039136e38, 7.357226217621891e35), 3.878532944401891e36, 0.003),
        ((6.50380989445945e54, 4.727867214732085e53), 4.2772030312227755e54, 1e-6),
        ((9e15, 0.0), 1.1e15, 0.01),
    ],
)
def test_a_plant_whose_swings_no_float_tells_is_outside(wall, gamma, delta):
    """cos(sqrt(gamma)) was a guess there, and walls eighty times too stiff were called stable."""
    for delay in (0.0, 0.5, 3.0):
        assert not lambdify("is_stable")(*wall, gamma, delta, delay)
        assert lambdify("unstable_roots")(*wall, gamma, delta, delay) == -1
        assert np.isnan(lambdify("stability_boundary")(1.0, gamma, delta, delay)).all()
    assert np.isnan(lambdify("discretize")(gamma, delta)).all()
    assert not np.isnan(lambdify("discretize")(1e15, delta)).any()


def test_what_is_stable_is_a_truth_value():
    wall = 0.01, 0.1, 0.001, 0.02
    verdict = lambdify("is_stable")(*wall, [1.0, 400.0])
    assert verdict.dtype == bool
    assert verdict.tolist() == [True, False]
    assert lambdify("is_stable", modules="mpmath")(*wall, 1) is True
    assert not lambdify("is_stable", scene=Parts(delay=False))(math.nan, *wall[1:])


def test_nothing_is_warned_of_outside(recwarn):
    """NaN among numbers: each element for itself, in all libraries' way of working."""
    some = np.array([0.01, np.nan, -np.inf, 1e300, 0.01])
    assert (
        lambdify("is_stable")(some, 0.1, [0.001, 1, 1, 1, -1], 0.02, 1).tolist()
        == [True] + [False] * 4
    )
    assert np.isnan(lambdify("linear_limit")(some, 1.0, 0.0)).tolist() == [False] + [True] * 3 + [
        False
    ]
    assert not recwarn


def test_a_domain_is_said_in_one_place_and_shown():
    for target in TARGETS.values():
        _, files = request.built(target, request.chosen(["is_stable", "unstable_roots"]))
        source = "\n".join(files[n] for n in files if re.search(r"\.(py|m|c|cpp|f90|rs|mjs)$", n))
        largest = "1e70" if target.precision is DOUBLE else "1e8"
        assert f"False outside it, and if an argument is NaN or larger than {largest}" in " ".join(
            re.sub(r"^[\s*/%!#]+", "", line) for line in (source + files.get("haptic.h", "")
            + files.get("haptic.hpp", "")).splitlines())  # fmt: skip
        assert "is_stable is a truth value" in files["README.md"]
        assert "-1, never 0" in files["README.md"].replace("\n", " ")

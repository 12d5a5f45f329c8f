"""Every export is compiled with warnings as errors and run over its own test vectors."""

import shutil
import subprocess
import sys

import numpy as np
import pytest
from export.covering import every_value, one_of

from symhaptic.bench.points import hard
from symhaptic.export import request
from symhaptic.export.precision import SINGLE
from symhaptic.export.targets import TARGETS
from symhaptic.export.vectors import hexadecimal
from symhaptic.model.parts import Parts

SCENES = {
    "everything": Parts(),
    "no stiffness": Parts(stiffness=False),
    "no damping": Parts(damping=False),
    "no delay": Parts(delay=False),
    "no virtual damping": Parts(virtual_damping=False),
    "mass only": Parts(stiffness=False, damping=False, delay=False),
    "three functions": Parts(),
}
NAMES = {"three functions": ["discretize", "max_passive_stiffness", "is_stable"]}


QUICK = [(n, "three functions") for n in TARGETS]
BOTH = [n for n, t in TARGETS.items() if t.single is not None and t.precision is not SINGLE]


def run_all(target, name, folder):
    """The commands of the README, in the folder; what the machine lacks is skipped by name."""
    said = ""
    for command in target.commands(name):
        program = sys.executable if command[0] == "python" else command[0]
        if not command[0].startswith("./") and shutil.which(program) is None:
            pytest.skip(f"no {program} here: the export to {target.title} is not run")
        run = subprocess.run(
            [program, *command[1:]], cwd=folder, capture_output=True, text=True, check=False
        )
        assert run.returncode == 0, run.stdout + run.stderr
        said = run.stdout
    return said


@pytest.mark.ci
@pytest.mark.parametrize("language", one_of(BOTH, "c"))
def test_the_self_test_passes_in_single_precision(language, tmp_path):
    """The vectors' arguments are single floats, their values those of exact arithmetic."""
    target = TARGETS[language].at(SINGLE)
    _, files = request.built(target, request.chosen([], delay=2))
    words = [w for line in files["vectors.txt"].splitlines() for w in line.split()[1:]]
    numbers = np.array([float.fromhex(x) for x in words])
    assert np.array_equal(numbers.astype(np.float32), numbers, equal_nan=True)
    request.write(files, tmp_path / "out")
    tried, _, missed, *_ = run_all(target, "haptic", tmp_path / "out").replace(",", " ").split()
    assert int(tried) > 500
    assert missed == "0"


def test_single_arrays_stay_single_without_a_warning():
    """All results of the array module, at every pair of hard cases."""
    forms = [f for f in request.chosen([]) if {"gamma", "delta"} & {s.name for s in f.arguments}]
    _, files = request.built(TARGETS["numpy"], forms, vectors=False)
    space = {}
    exec(compile(files["haptic.py"], "haptic.py", "exec"), space)
    gamma, delta = np.array(hard(SINGLE), dtype=np.float32).T
    given = {"gamma": gamma, "delta": delta, "alpha": 0.2, "beta": 0.1, "d": 3.0, "theta": 0.5}
    given["epsilon"] = 0.25
    for form in forms:
        with np.errstate(divide="raise", over="raise", invalid="raise"):
            found = space[form.name](*(given[s.name] for s in form.arguments))
        for value in found if isinstance(found, tuple) else (found,):
            if np.shape(value):
                assert value.dtype == (bool if form.truth else np.float32), form.name
                nowhere = form.name == "max_stable_stiffness"  # NaN outside its domain
                assert nowhere or np.isfinite(value).all(), form.name


# vectors of a scene are the same for all languages, and are found once
@pytest.mark.parametrize(("language", "scene"), every_value(TARGETS, SCENES, quick=QUICK))
def test_the_self_test_of_every_target_passes(language, scene, tmp_path):
    target, parts = TARGETS[language], SCENES[scene]
    delay = 2 if parts.delay and scene not in NAMES else None
    made, files = request.built(target, request.chosen(NAMES.get(scene, []), parts, delay))
    folder = tmp_path / "out"
    request.write(files, folder)
    said = run_all(target, "haptic", folder)
    values = sum(
        len(made.public[i].results) * files["vectors.txt"].count(f"{routine.name} ")
        for i, routine in enumerate(made.public)
    )
    assert said.split()[0] == str(values)
    assert values > 5


@pytest.mark.parametrize("language", TARGETS)
def test_the_self_test_fails_on_a_miss(language, tmp_path):
    """One expected value off by ten units in the fourth last digit."""
    target = TARGETS[language]
    _, files = request.built(target, request.chosen(["linear_limit"], Parts(stiffness=False)))
    lines = files["vectors.txt"].splitlines()
    words = next(line for line in lines if abs(float.fromhex(line.split()[4])) > 0.001).split()
    right = words[4]
    wrong = hexadecimal(float.fromhex(right) * (1 + 1e4 * float(target.precision.last)))
    files["vectors.txt"] = files["vectors.txt"].replace(right, wrong)
    folder = tmp_path / "out"
    request.write(files, folder)
    for command in target.commands("haptic"):
        program = sys.executable if command[0] == "python" else command[0]
        if not command[0].startswith("./") and shutil.which(program) is None:
            pytest.skip(f"no {program} here: the export to {target.title} is not run")
        run = subprocess.run(
            [program, *command[1:]], cwd=folder, capture_output=True, text=True, check=False
        )
    assert run.returncode == 1
    assert "linear_limit" in run.stdout

"""Exports with derivatives: compiled, run over their vectors, measured; bad requests refused."""

import shutil
import subprocess
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from export.test_request import symhaptic
from export.test_targets import run_all

from symhaptic import lambdify
from symhaptic.export import library, request
from symhaptic.export.language import Refused
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.routine import Routine
from symhaptic.export.targets import TARGETS
from symhaptic.forms.derivatives import differentiable
from symhaptic.model.parts import FULL, Parts
from symhaptic.scene.scene import Scene

pytestmark = pytest.mark.ci

needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc here")

EVERY = ("theta", "alpha", "beta", "gamma", "delta", "d")
SCENES = {
    "everything": Parts(),
    "no stiffness": Parts(stiffness=False),
    "no damping": Parts(damping=False, delay=False),
}


@cache
def asked(name, parts=FULL, by=()):
    """One form with its derivatives by all of its arguments, or by these."""
    (plain,) = request.chosen([name], parts)
    (form,) = request.chosen([name], parts, derivatives=by or differentiable(plain))
    return form


@cache
def some(scene):
    """Entire functions, a choice, an envelope; in C all others, too, but in one scene only."""
    parts = SCENES[scene]
    if scene == "no stiffness":
        known = {s.name for form in request.chosen([], parts) for s in form.arguments}
        return request.chosen([], parts, derivatives=[name for name in EVERY if name in known])
    if scene == "no damping":
        names = "discretize", "stability_boundary", "stability_conditions"
        return [asked(name, parts) for name in names]
    few = [asked("discretize"), asked("passivity_margin", by=("alpha",))]
    return [*few, asked("stability_boundary", by=("gamma", "d"))]


CASES = [(name, "everything") for name in TARGETS]
CASES += [("c", "no stiffness"), ("numpy", "no damping")]
USUAL = [(name, "everything") for name in ("numpy", "c")]
FURTHER = [(name, "everything") for name in ("fortran", "rust", "javascript")]


@pytest.mark.parametrize(
    ("language", "scene"),
    [
        pytest.param(
            *c, marks=[] if c in USUAL else pytest.mark.ci if c in FURTHER else pytest.mark.slow
        )
        for c in CASES
    ],
)
def test_the_self_test_of_every_target_passes_with_derivatives(language, scene, tmp_path):
    target, forms = TARGETS[language], some(scene)
    made, files = request.built(target, forms)
    request.write(files, tmp_path / "out")
    said = run_all(target, "haptic", tmp_path / "out")
    lines = [line.split()[0] for line in files["vectors.txt"].splitlines()]
    assert int(said.split()[0]) == sum(len(r.results) * lines.count(r.name) for r in made.public)
    assert any(name.endswith("_and_derivatives") for name in lines)


@pytest.mark.slow
@pytest.mark.parametrize("language", ["c"])
def test_the_self_test_passes_in_single_precision_with_derivatives(language, tmp_path):
    target = TARGETS[language].at(SINGLE)
    _, files = request.built(target, some("everything"))
    request.write(files, tmp_path / "out")
    tried, _, missed, *_ = run_all(target, "haptic", tmp_path / "out").replace(",", " ").split()
    assert int(tried) > 300
    assert missed == "0"


@pytest.mark.ci
@needs_gcc
@pytest.mark.parametrize(
    "name", ["Echo", "PlantN1Drop", "PlantN0Drop", "Ebb", "Kick", "DropSeries"]
)
def test_a_wrong_routine_is_found_by_the_self_test(name, tmp_path, monkeypatch):
    """One part in 10^12 off."""
    right = library.known(DOUBLE)
    old = right[name]
    ((result, value),) = old.results
    factor = 1 + 2.0**-40
    changed = sp.piecewise_fold(value * factor)
    wrong = Routine(name, old.about, old.arguments, old.steps, ((result, changed),))
    monkeypatch.setattr(library, "known", lambda precision=DOUBLE: {**right, name: wrong})
    _, files = request.built(TARGETS["c"], [asked("discretize")])
    request.write(files, tmp_path / "out")
    compile_, execute = TARGETS["c"].commands("haptic")
    subprocess.run(compile_, cwd=tmp_path / "out", check=True)
    run = subprocess.run(execute, cwd=tmp_path / "out", capture_output=True, text=True, check=False)
    assert run.returncode == 1
    assert "discretize_and_derivatives" in run.stdout


def test_beside_the_plain_function_in_one_library(tmp_path):
    forms = [*request.chosen(["discretize"]), asked("discretize")]
    made, files = request.built(TARGETS["c"], forms)
    assert [r.name for r in made.public] == ["discretize", "discretize_and_derivatives"]
    assert "void haptic_discretize(double gamma, double delta, " in files["haptic.h"]
    request.write(files, tmp_path / "out")
    run_all(TARGETS["c"], "haptic", tmp_path / "out")


@pytest.mark.parametrize(("precision", "said"), [(DOUBLE, True), (SINGLE, False)])
def test_a_remark_stands_beside_the_figure_that_it_explains(precision, said):
    """Also where the plain results are the worst ones; not beside that of another precision."""
    target = TARGETS["c"].at(precision)
    plain, *_ = request.chosen(["stability_boundary"])
    for form in (plain, asked("stability_boundary", by=("gamma",))):
        text = request.built(target, [form])[1]["README.md"]
        assert ("Found by a search around the worst points" in text) is said


HOSTILE = {
    "not its argument": (["discretize", "--derivative", "theta"], "it has gamma, delta"),
    "not in the scene": (["discretize", "--derivative", "gamma", "--scene", "no-stiffness"],
                         "it has delta"),
    "what counts": (["is_stable", "--derivative", "gamma"], "is_stable: has no derivative"),
    "of no function": (["--derivative", "mass"], "--derivative mass"),
    "of one of two": (["discretize", "linear_limit", "--derivative", "gamma"], "linear_limit"),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_a_bad_request_is_one_line(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words, named = HOSTILE[name]
    code, out, err = symhaptic(monkeypatch, capsys, "export", "--target", "c", *words)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert "--derivative" in err
    assert named in err
    assert not list(tmp_path.iterdir())


def test_a_name_given_twice_counts_once():
    (form,) = request.chosen(["linear_limit"], derivatives=["d", "d"])
    assert [name for name, _ in form.results] == ["alpha", "alpha_by_d"]
    with pytest.raises(Refused, match="has no argument"):
        request.chosen(["linear_limit"], derivatives=[""])


def test_the_list_and_the_readme_name_them(monkeypatch, capsys):
    code, out, _ = symhaptic(monkeypatch, capsys, "export", "--list", "--derivative", "d")
    assert code == 0
    assert "linear_limit_and_derivatives(beta, delta, d)" in out
    assert "is_stable(" in out
    assert "discretize(" in out
    text = request.built(TARGETS["c"], [asked("discretize")])[1]["README.md"]
    assert "Derivatives with respect to gamma, delta" in text
    assert "    n1_by_gamma = -PlantN1Drop(gamma, delta)" in text
    assert "- PlantN1Drop: " in text


def test_lambdify_gives_them_behind_the_results():
    """Beside mpmath.diff of (25) of the paper, and of a scene's own."""
    function = lambdify("eq25", derivatives=("beta", "d"))
    at = (0.25, 0.5, 1.5)
    alpha, by_beta, by_d = function(*at)
    slope = mpmath.diff(lambda x: 0.75 / (x + 0.5), 1.5)
    assert (float(alpha), float(by_beta)) == (0.375, 0.5)
    assert float(by_d) == pytest.approx(float(slope), rel=1e-14)
    free = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
    found = lambdify("discretize", scene=free, derivatives=["delta"])(np.array([0.0, 1e-9]))
    assert [float(np.max(x)) for x in found[4:6]] == pytest.approx([-1 / 6, -1 / 3])
    exact = lambdify("discretize", modules="mpmath", derivatives=["gamma"])
    with mpmath.workdps(30):
        assert mpmath.almosteq(exact(0, 0)[4], -mpmath.mpf(1) / 24, 1e-28)


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"id": "discretize", "derivatives": ("theta",)}, "derivatives: discretize: has no argu"),
        ({"id": "is_stable", "derivatives": ("gamma",)}, "derivatives: is_stable: has no deriv"),
        ({"id": "eq11", "form": "printed", "derivatives": ("d",)}, "derivatives: not available"),
    ],
)  # fmt: skip
def test_lambdify_refuses_what_has_none(options, named):
    with pytest.raises(ValueError, match=named):
        lambdify(**options)


@pytest.mark.parametrize("delay", [0, 1, 7, 1000])
def test_the_stiffest_passive_wall_behind_whole_delays_and_its_slope(delay):
    """Both are proportional to the damping; the angle is not moved by it: (11) in 40 digits."""
    run = lambdify("max_passive_stiffness", derivatives=["delta"])
    with mpmath.workdps(40):
        angle = mpmath.pi / (2 * (delay + 1))
        stiffness = 2 * mpmath.tan(angle / 2)
        damping = 1 / ((delay + 1) * mpmath.sin(angle)) - mpmath.tan(angle / 2)
        expected = 0.3 * stiffness, 0.3 * damping, angle, stiffness, damping, 0
    assert list(run(0.3, delay)) == pytest.approx([*map(float, expected)], rel=1e-15, abs=2e-16)


@pytest.mark.parametrize("delay", [0.0, 0.25, 3.0, 17.6, 1e4 + 0.3])
def test_the_stiffest_passive_spring_and_its_slopes(delay):
    """2 delta/(o + sqrt(o^2 + p (1 - p))), o = d + 1/2: by d inside a period, else to the right."""
    springs = {"scene": "no-virtual-damping", "derivatives": ["delta", "d"]}
    run = lambdify("max_passive_stiffness", **springs)
    with mpmath.workdps(40):
        order, part = mpmath.mpf(delay) + 0.5, mpmath.mpf(delay) % 1
        root = mpmath.sqrt(order**2 + part * (1 - part))
        alpha = mpmath.mpf(0.3) * 2 / (order + root)
        slope = -alpha / (order + root) * (1 + (2 * order + 1 - 2 * part) / (2 * root))
        expected = [alpha, 2 / (order + root), slope]
    assert list(run(0.3, delay)) == pytest.approx([*map(float, expected)], rel=1e-15)

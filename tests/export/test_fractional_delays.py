"""What is exported is exact for the sampled loop at fractional delays, and not the principal sheet.

Each function of a delay, as compiled C in both precisions and as a function of arrays, beside an
energy, a polynomial or a formula that is not the package's own.
"""

import math
import shutil
from itertools import product

import numpy as np
import oracle
import pytest
from test_fractional_passivity import needed

from symhaptic import lambdify
from symhaptic.bench import error
from symhaptic.export import request
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.forms import stable
from symhaptic.notation import d

pytestmark = pytest.mark.ci

DELAYS = 0.02, 0.25, 0.5, 0.75, 0.98, 1.3, 2.5, 5.9
SCENES = "", "no-stiffness", "no-damping", "no-virtual-damping"
SLACK = {DOUBLE: 1e-12, SINGLE: 1e-4}
"""Of numbers of about 1; the difference to the principal sheet is 1e-3 and more."""


QUICK = (DOUBLE, ""), (SINGLE, "no-stiffness"), (None, "no-damping")
"""Each precision and three scenes; the other pairs are slow."""


@pytest.fixture(
    params=[
        pytest.param(case, marks=[] if case in QUICK else pytest.mark.slow)
        for case in product((DOUBLE, SINGLE, None), SCENES)
    ],
    ids=lambda case: f"{getattr(case[0], 'name', 'arrays')}-{case[1] or 'full'}",
)
def exported(request, tmp_path_factory):
    """A function of a scene by its name: whether it is there, and what it is of numbers."""
    precision, scene = request.param

    def made(name):
        parts = asked(scene)
        if name not in {form.name for form in stable.forms(parts, 0)}:
            pytest.skip(f"this scene has no {name}")
        if precision is None:
            return stable.form(name, parts), lambdify(name, scene=parts), SLACK[DOUBLE]
        if shutil.which("gcc") is None:
            pytest.skip("no gcc here: exported C is not run")
        form = stable.form(name, parts)
        run = error.compiled(form, tmp_path_factory.mktemp(name), precision)

        def called(*numbers):
            rows = run([np.atleast_1d(np.asarray(x, precision.kind)) for x in numbers])
            return rows[0] if len(rows) == 1 else rows

        return form, called, SLACK[precision]

    return made


def asked(scene):
    return request.scene(scene)


def walls(form, count=16):
    """Arguments in single precision, each with a fractional delay."""
    rng = np.random.default_rng(17)
    ranges = {"theta": (0.05, 3.0), "alpha": (0.05, 2), "beta": (-0.4, 2), "gamma": (0.0, 3),
              "delta": (0.1, 2), "d": (0, 1)}  # fmt: skip
    columns = {s.name: rng.uniform(*ranges[s.name], count) for s in form.arguments}
    columns["d"] = rng.choice(DELAYS, count)
    return {name: np.float32(column).astype(float) for name, column in columns.items()}


def left_out(given):
    """With 0 for what the scene has not."""
    zero = np.zeros_like(given["d"])
    return {name: given.get(name, zero) for name in ("alpha", "beta", "gamma", "delta", "d")}


def rows(given):
    return zip(*given.values(), strict=True)


def test_the_margin_at_an_angle_is_that_of_the_worst_motion(exported):
    """The smallest damping at which the energy of two displacements a period is not negative."""
    form, function, slack = exported("passivity_margin_at")
    given = walls(form)
    found = np.ravel(function(*given.values()))
    for k, (alpha, beta, _, delta, delay) in enumerate(rows(left_out(given))):
        (need,) = needed(alpha, beta, delay, given["theta"][k : k + 1])
        assert found[k] == pytest.approx(delta - need, abs=10 * slack)


def test_its_least_value_is_not_positive_where_a_motion_gains_energy(exported):
    """4 sqrt(5) - 8 = 0.944 is the stiffest passive spring at d = 1/2; 0.98 gives energy away.

    On the principal sheet this wall has a margin of at least 0.02.
    """
    form, function, _ = exported("passivity_margin_at")
    theta = np.float32(np.linspace(0.01, 3.1, 2000)).astype(float)
    for alpha, passive in ((0.98, False), (0.94, True)):
        one = {"theta": theta, "alpha": alpha, "beta": 0.0, "delta": 1.0, "d": 0.5}
        values = [np.full(theta.shape, one[s.name]) for s in form.arguments]
        assert (np.min(function(*values)) >= 0) == passive


def test_the_margin_is_that_of_the_worst_angle(exported):
    form, function, slack = exported("passivity_margin")
    given = walls(form)
    found = np.ravel(function(*given.values()))
    for k, (alpha, beta, _, delta, delay) in enumerate(rows(left_out(given))):
        worst = delta - needed(alpha, beta, delay).max()  # on 4000 angles
        assert worst - 1e-4 - 10 * slack <= found[k] <= worst + 1e-7 + 10 * slack


def test_walls_of_the_passivity_boundary_need_the_damping_of_the_device(exported):
    _, function, slack = exported("passivity_boundary")
    for delay in DELAYS:
        theta = np.float32(np.array([0.2, 0.4, 0.6]) * math.pi / (delay + 1)).astype(float)
        alpha, beta = function(theta, np.full(3, 0.5), np.full(3, np.float32(delay), dtype=float))
        for wall in zip(np.ravel(alpha), np.ravel(beta), strict=True):
            need = needed(*map(float, wall), float(np.float32(delay))).max()
            assert need == pytest.approx(0.5, abs=2e-6 + slack)


def test_the_stiffest_passive_wall_needs_all_damping_and_no_other_is_stiffer(exported):
    form, function, _ = exported("max_passive_stiffness")
    late = np.float32(DELAYS).astype(float)
    found = function(np.ones(late.size), late)
    alpha = np.ravel(found[0] if isinstance(found, tuple) or np.ndim(found) == 2 else found)
    beta = np.ravel(found[1]) if len(form.results) > 1 else np.zeros(late.size)
    for k, delay in enumerate(late):
        assert needed(float(alpha[k]), float(beta[k]), delay).max() == pytest.approx(1, abs=2e-5)
        for other in beta[k] + (np.linspace(-0.2, 0.2, 5) if len(form.results) > 1 else [0]):
            assert needed(1.001 * float(alpha[k]), float(other), delay).max() > 1


def test_points_of_the_stability_boundary_have_a_root_on_the_circle(exported):
    form, function, slack = exported("stability_boundary")
    given = walls(form, 12)
    alpha, beta = map(np.ravel, function(*given.values()))
    for k, (_, _, gamma, delta, delay) in enumerate(rows(left_out(given))):
        at = alpha[k], beta[k], given["theta"][k], gamma, delta, delay
        assert oracle.residual(*map(float, at)) < slack


def test_the_stiffest_stable_wall_has_a_root_on_the_circle_and_a_softer_one_none_outside(exported):
    form, function, slack = exported("max_stable_stiffness")
    given = walls(form, 10)
    if "gamma" in given:  # the domain of the export
        given["gamma"] = np.float32(np.minimum(given["gamma"], 8 / (given["d"] + 1) ** 2)) * 1.0
    alpha, beta, theta = map(np.ravel, function(*given.values()))
    for k, (_, _, gamma, delta, delay) in enumerate(rows(left_out(given))):
        assert oracle.residual(*map(float, (alpha[k], beta[k], theta[k])), gamma, delta, delay) < (
            100 * slack
        )
        inside = float(alpha[k]) - 1e-3 * (gamma + float(alpha[k]))
        assert oracle.moduli(inside, float(beta[k]), gamma, delta, delay).max() < 1


def test_verdicts_are_those_of_certified_roots(exported):
    for name in ("is_stable", "unstable_roots"):
        form, function, _ = exported(name)
        given = walls(form)
        found = np.ravel(function(*given.values()))
        for k, case in enumerate(rows(left_out(given))):
            outside = oracle.certified(*map(float, case))
            assert found[k] == (outside == 0 if name == "is_stable" else outside), case


def test_every_exported_function_of_a_delay_is_tried_here():
    """The linear limit is a straight line by its definition, whatever the delay."""
    of_delays = {name for name in stable.FORMS if name not in stable.FOR_ONE_DELAY
                 and d in stable.form(name).arguments}  # fmt: skip
    assert of_delays == {
        "passivity_margin_at", "passivity_margin", "passivity_boundary", "max_passive_stiffness",
        "stability_boundary", "max_stable_stiffness", "is_stable", "unstable_roots", "linear_limit",
    }  # fmt: skip


def test_no_title_says_more_than_that():
    """A wall with alpha < 0 is not passive, whatever its margin at each angle."""
    title = stable.form("passivity_margin_at").title
    assert "a wall with alpha >= 0 is passive if" in title
    assert not any("principal" in words for words in stable.form("passivity_margin_at").domain)

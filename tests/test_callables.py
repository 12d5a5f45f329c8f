"""Formulas as functions: on arrays without a warning, in many digits, and for smaller scenes."""

import importlib.util
import inspect
import multiprocessing
import pickle
import re
import warnings
from inspect import signature

import mpmath
import numpy as np
import oracle
import pytest
from command import symhaptic as command

import symhaptic
from symhaptic import Scene, lambdify
from symhaptic.book import formulas
from symhaptic.book.chapters import folder, run
from symhaptic.check.formulas import CHECKED
from symhaptic.export import request
from symhaptic.forms import stable
from symhaptic.model.parts import Parts
from symhaptic.numeric.arguments import IN_ORDER
from symhaptic.scene.callables import _of_passive_stiffness

HARD = [0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 1.0, 10.0, 700.0]
NAMES = ["discretize", "stability_boundary", "passivity_margin_at", "passivity_boundary",
         "max_passive_stiffness", "linear_limit"]  # fmt: skip


def points(form):
    rng = np.random.default_rng(3)
    ranges = {"theta": (1e-6, 3.1), "gamma": (0, 12), "delta": (0, 6), "d": (0, 20)}
    columns = []
    for symbol in form.arguments:
        low, high = ranges.get(symbol.name, (-1, 1))
        column = rng.uniform(low, high, 400)
        columns.append(np.floor(column) if symbol.name == "d" else column)
    return columns


@pytest.mark.parametrize("name", NAMES)
def test_arrays_and_single_numbers_agree_without_a_warning(name):
    function = lambdify(name)
    columns = points(stable.form(name))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        together = np.stack(np.broadcast_arrays(*np.atleast_2d(function(*columns))))
        for k in range(0, 400, 40):
            one = np.ravel(function(*(float(c[k]) for c in columns)))
            assert one == pytest.approx(together[:, k], rel=1e-13, abs=1e-14, nan_ok=True)


@pytest.mark.parametrize(
    ("asked", "arguments"),
    [
        (("eq11",), (0.5, 1.5)),
        (("linear_limit", "stable", "numpy", "no-stiffness", ["d"]), (0.1, 1.0, 1.5)),
        (("linear_limit", "stable", "mpmath"), (1.0, 0.1, 1.5)),
        (("eq11", "derived"), (0.001, 0.5, 1.5)),
        (("eq11", "printed", "mpmath"), (0.001, 0.5, 1.5)),
    ],
)
def test_a_function_is_pickled_as_what_was_asked_for(asked, arguments):
    function = lambdify(*asked)
    again = pickle.loads(pickle.dumps(function))
    assert again(*arguments) == function(*arguments)
    assert (again.__name__, signature(again)) == (function.__name__, signature(function))


def test_a_function_in_another_process():
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.starmap(lambdify("eq11"), [(0.5, 1.5)]) == [lambdify("eq11")(0.5, 1.5)]


@pytest.mark.ci
def test_torch_compiles_a_function_of_a_formula():
    torch = pytest.importorskip("torch")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of caches that it looks through
        compiled = torch.compile(lambdify("linear_limit"), backend="eager", fullgraph=True)
        found = compiled(*map(torch.tensor, (0.1, 1.0, 1.5)))
    assert found == pytest.approx(lambdify("linear_limit")(0.1, 1.0, 1.5), rel=1e-6)


def test_hard_plants_on_arrays_without_a_warning():
    gamma, delta = (a.ravel() for a in np.meshgrid(HARD, HARD))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = np.stack(lambdify("eq14")(gamma, delta))
    assert np.isfinite(found).all()


def test_the_inequalities_are_the_roots():
    """All positive exactly where numpy.roots of the polynomial lie inside the unit circle."""
    rng = np.random.default_rng(6)
    for delay in (0, 1, 2, 3):
        (conditions,) = request.chosen(["stability_conditions"], delay=delay)
        (polynomial,) = request.chosen(["characteristic_polynomial"], delay=delay)
        run = [symhaptic.scene.callables._on_arrays(form, ()) for form in (conditions, polynomial)]
        both = set()
        for _ in range(40):
            wall = rng.uniform(-0.2, 1.5 / (delay + 1), 2)
            plant = rng.uniform(0, 2, 2)
            positive = min(run[0](*wall, *plant)) > 0
            radius = np.abs(np.roots([float(c) for c in run[1](*wall, *plant)])).max()
            if abs(radius - 1) > 1e-9:
                assert positive == (radius < 1), (delay, wall, plant)
                both.add(positive)
        assert both == {True, False}


def test_many_digits():
    """n1 of a free mass with damping 1e-30 is 1/2 - delta/6 + delta^2/24, the power series."""
    with mpmath.workdps(50):
        n1, n0, a, _ = lambdify("discretize", modules="mpmath")(0, mpmath.mpf("1e-30"))
        delta = mpmath.mpf("1e-30")
        assert abs(n1 - (0.5 - delta / 6)) < mpmath.mpf("1e-49")
        assert abs(n0 - (0.5 - delta / 3)) < mpmath.mpf("1e-49")
        assert abs(a - (2 - delta)) < mpmath.mpf("1e-48")


def test_many_digits_take_arguments_by_name():
    """(B + b)/(d + 1/2) of the linear condition: 3 over 3/2, by hand."""
    for modules in ("numpy", "mpmath"):
        limit = lambdify("linear_limit", modules=modules)
        assert limit(d=1, delta=1, beta=2) == 2
        assert [*signature(limit).parameters] == ["beta", "delta", "d"]
        with pytest.raises(TypeError, match=r"linear_limit.*missing.*'d'"):
            limit(1, 2)


def test_single_precision_on_its_own_scale():
    gamma, delta = np.random.default_rng(8).uniform(0, 12, (2, 2000)).astype(np.float32)
    exact = lambdify("discretize")(gamma.astype(float), delta.astype(float))
    for ours, double in zip(lambdify("discretize")(gamma, delta), exact, strict=True):
        assert ours.dtype == np.float32
        assert np.abs(ours - double).max() < 4 * np.finfo(np.float32).eps


def test_printed_and_derived_forms(monkeypatch):
    """(11) at b = T = 1 and d = 1: tan(pi/8) = sqrt 2 - 1, by hand; symbols by their names."""
    chapter = folder() / "s3c_stiffness_maximum.py"
    settled = {
        id: (found.settlement.derived, found.verdict)
        for id, found in run(chapter).page.settled.items()
    }
    monkeypatch.setattr(formulas, "_settled", lambda path: settled)
    for form in ("printed", "derived"):
        stiffness, damping = np.ravel(lambdify("eq11", form=form)(1.0, 1.0, 1.0))
        assert float(stiffness) == pytest.approx(2 * (2**0.5 - 1))
        assert float(damping) == pytest.approx(1 - 0.5**0.5)  # (sin(pi/4) - 1/2)/sin(pi/4)
        for library in ("jax", "torch"):
            if importlib.util.find_spec(library) is None:
                continue
            module = pytest.importorskip("jax.numpy" if library == "jax" else library)
            one = module.asarray([1.0, 1.0])
            stiffness, _ = lambdify("eq11", form=form, modules=library)(one, one, one)
            assert type(stiffness) is type(one)
            assert stiffness.tolist() == pytest.approx([2 * (2**0.5 - 1)] * 2, rel=1e-6)


def test_a_scene_leaves_arguments_out():
    scene = Scene(mass=0.1, sampling_period=0.001, damping=0.5)
    assert lambdify("linear_limit", scene=scene)(0.0, 0.02) == pytest.approx(0.04)
    assert lambdify("linear_limit", scene="no-delay, no-stiffness")(0.0, 0.02) == (
        pytest.approx(0.04)
    )  # 2 (beta + delta), the paper's (25) at d = 0
    with pytest.raises(TypeError, match="scene: 3 is not allowed"):
        lambdify("linear_limit", scene=3)
    free = lambdify("discretize", scene=Parts(stiffness=False, damping=False))
    assert [float(x) for x in free()] == [0.5, 0.5, 2.0, 1.0]


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ({"id": "eq99"}, "eq99"),
        ({"id": "eq11", "form": "best"}, "form: 'best'"),
        ({"id": "eq11", "modules": "pandas"}, "modules: 'pandas'"),
        ({"id": "eq11", "form": "printed", "scene": Parts()}, "scene"),
        ({"id": "eq11", "scene": Parts(damping=False)}, "without damping"),
        ({"id": "eq11", "scene": "no-dely"}, "scene: no-dely: .* did you mean 'no-delay'"),
        ({"id": "linear_limt"}, "id: 'linear_limt' .* did you mean 'linear_limit'"),
        ({"id": ["eq11"]}, r"^id: \['eq11'\] is not allowed; give text such as 'eq11'$"),
        ({"id": ["eq11"], "form": "derived"}, r"^id: \['eq11'\] is not allowed"),
        ({"id": "eq11", "derivatives": [["delta"]]}, r"^derivatives: .* no argument \['delta'\]"),
    ],
)
def test_what_is_not_known_is_named(arguments, named):
    with pytest.raises(ValueError, match=named):
        lambdify(**arguments)


@pytest.mark.parametrize("derivatives", [3, 1.5, {"delta": 1}, True])
def test_derivatives_that_are_no_names_are_named(derivatives):
    with pytest.raises(TypeError, match=r"^derivatives: .* is not allowed; give names"):
        lambdify("eq11", derivatives=derivatives)


def test_counted_roots_are_those_of_the_kernel_and_of_the_matrix():
    """Any whole delay: beside eigenvalues of the loop's matrix, and beside the kernel's count."""
    rng = np.random.default_rng(9)
    count, verdict = lambdify("unstable_roots"), lambdify("is_stable")
    size = 3000
    delay = np.where(rng.random(size) < 0.7, rng.integers(0, 9, size), rng.integers(0, 10**6, size))
    wall = rng.normal(0, 1, (2, size)) * 10 ** rng.uniform(-4, 1, size) / (delay + 1)
    plant = 10 ** rng.uniform(-6, 1.2, (2, size))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        outside = count(*wall, *plant, delay.astype(float))
        stable_ = verdict(*wall, *plant, delay.astype(float))
    assert np.array_equal(outside, symhaptic.unstable_roots(*wall, *plant, delay))
    assert stable_.dtype == bool
    assert np.array_equal(stable_, symhaptic.is_stable(*wall, *plant, delay))
    some = delay < 9
    sizes = [oracle.moduli(*wall[:, k], *plant[:, k], int(delay[k])) for k in np.flatnonzero(some)]
    clear = np.array([np.abs(s - 1).min() > 1e-7 for s in sizes])
    true = np.array([(s > 1).sum() for s in sizes])
    assert np.array_equal(outside[some][clear], true[clear])
    assert clear.mean() > 0.9


def test_a_loop_that_nothing_stabilises():
    stable_ = lambdify("is_stable")
    assert not stable_(0.0, 0.0, 0.3, 0.0, 2.0)  # it keeps on swinging
    assert stable_(0.0, 0.0, 0.3, 0.1, 2.0)
    assert not stable_(-0.3, 0.1, 0.3, 0.5, 1.0)  # a root at 1
    assert not stable_(0.1, 0.1, np.pi**2, 0.0, 0.0)  # whole half swings in a period


@pytest.mark.parametrize(
    "bad",
    [1j, 1 + 0j, "1", b"1", np.complex64(1), np.datetime64("2020-01-01"), 10**400, -(10**400),
     np.array(1j), np.array("1"), np.array([1j, 1.0]), np.array(["1", "2"]),
     np.array([1j, "1"], dtype=object), np.array([np.complex128(1), 10**400], dtype=object)],
)  # fmt: skip
def test_what_is_no_real_number_is_outside_of_every_domain(bad):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for other in (1.0, np.ones(2)):
            assert np.isnan(lambdify("linear_limit")(0.1, bad, other)).all()
            assert not np.any(lambdify("is_stable")(0.1, 0.2, bad, 0.1, other))
            assert np.all(lambdify("unstable_roots")(0.1, 0.2, bad, 0.1, other) == -1)


def test_complex_numbers_of_many_digits_are_outside_of_every_domain():
    for complex_one in (mpmath.mpc(1, 1), mpmath.mpc(1, 0), 1j):
        assert mpmath.isnan(lambdify("linear_limit", modules="mpmath")(0.1, 1, complex_one))
        assert not lambdify("is_stable", modules="mpmath")(0.1, 0.4, complex_one, 0.1, 1)


def test_a_free_mass_without_delay_is_told_stable_in_many_digits():
    """By the Jury conditions by hand: alpha < 2 beta (2 - beta)/(2 + beta) at beta = 1, 2/3."""
    stable = lambdify("is_stable", modules="mpmath")
    assert stable(0.66, 1, 0, 0, 0)
    assert not stable(0.67, 1, 0, 0, 0)


@pytest.mark.parametrize("delay", [0.0, 1.0, 0.5, 2.3])
@pytest.mark.parametrize("beta", [0.0, 0.3, -0.5])
def test_slopes_of_faint_walls_are_those_of_larger_ones(beta, delay):
    function = lambdify("passivity_margin", derivatives=["alpha", "beta", "d"])
    _, by_alpha, by_beta, by_d = function(1.0, beta, 0.0, delay)
    for size in (2.0**-500, 2.0**-600, 2.0**-1000):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            _, *slopes = function(size, size * beta, 0.0, delay)
        assert np.allclose(slopes, [by_alpha, by_beta, size * by_d], rtol=1e-13, atol=0)


def test_the_slope_of_the_stiffest_passive_wall_over_the_delay():
    """What JAX is told, beside a central difference; without delay every angle is a worst one."""
    stiffest = lambdify("max_passive_stiffness")
    delay = np.array([0.5, 1.5, 0.0])
    slope = _of_passive_stiffness(stable.form("max_passive_stiffness"), np.array(0.1), delay)
    more, less = (stiffest(0.1, delay[:2] + h)[0] for h in (1e-5, -1e-5))
    assert slope["alpha", "d"][:2] == pytest.approx((more - less) / 2e-5, rel=1e-6)
    assert np.isnan(slope["alpha", "d"][2])


# -- formulas in SI units, by number --------------------------------------------------------

PERIOD, DAMPER, MASS = mpmath.mpf("0.001"), mpmath.mpf(2), mpmath.mpf("0.1")
"""A device of 0.1 kg and 2 Ns/m, sampled at 1 kHz."""


def test_7_by_number_is_the_boundary_in_units_of_table_1():
    """(7) typed anew in SI units, at omega = 700 rad/s and one period of delay."""
    rate, d = mpmath.mpf(700), 1
    turn = rate * PERIOD
    bottom = mpmath.sin(2 * (d + 1) * turn) - 2 * (1 + d) * mpmath.sin(turn)
    sines = [mpmath.sin((d + n) * turn) for n in (2, 1, 0)]
    stiffness = 2 * DAMPER * (d + 1) / PERIOD * (sines[0] - 2 * sines[1] + sines[2]) / bottom
    damping = 2 * DAMPER * (d * sines[1] - (1 + d) * sines[2]) / bottom
    alpha, beta = lambdify("eq7")(float(turn), float(DAMPER * PERIOD / MASS), d)
    assert alpha * MASS / PERIOD**2 == pytest.approx(float(stiffness), rel=1e-13)
    assert beta * MASS / PERIOD == pytest.approx(float(damping), rel=1e-13)


def test_12_by_number_is_the_sampled_device():
    """The answer to a held force that turns by z = 2, from the exponential of the motion."""
    spring = mpmath.mpf(50)
    rows = [[0, 1, 0], [-spring / MASS, -DAMPER / MASS, 1 / MASS], [0, 0, 0]]
    step = mpmath.expm(mpmath.matrix(rows) * PERIOD)
    moved = mpmath.lu_solve(2 * mpmath.eye(2) - step[:2, :2], step[:2, 2])[0]
    gamma, delta = spring * PERIOD**2 / MASS, DAMPER * PERIOD / MASS
    n1, n0, a, e = lambdify("eq12")(float(gamma), float(delta))
    found = float(PERIOD**2 / MASS) * (2 * n1 + n0) / (4 - 2 * a + e)
    assert found == pytest.approx(float(moved), rel=1e-12)


def test_24_by_number_is_the_limit_of_the_stiffness():
    """(b + B)/(t_d + T/2), in N/m, for B = 5 Ns/m and a delay of 1.5 ms."""
    for id in ("eq24", "eq9"):
        alpha = lambdify(id)(5 * 0.001 / 0.1, 2 * 0.001 / 0.1, 1.5)
        assert alpha * 0.1 / 0.001**2 == pytest.approx((2 + 5) / 0.002, rel=1e-14)


def test_an_equation_has_one_order_of_arguments():
    """That of `symhaptic check --list`, in Python, too; what an inequality bounds comes first."""
    for id, order in IN_ORDER.items():
        assert " ".join(CHECKED[id].arguments) == order
        named = list(inspect.signature(lambdify(id, form="derived")).parameters)
        known = [name for name in order.split() if name in named]
        assert named[len(named) - len(known) :] == known
    assert list(inspect.signature(lambdify("eq11", form="printed")).parameters) == ["b", "T", "d"]


def test_31_by_number_is_in_si_units():
    """Example 5.1: 987 000 N/m."""
    assert lambdify("eq31")(T=1e-3, b=0.0, m=0.1) == pytest.approx(np.pi**2 * 1e5, rel=1e-15)
    assert lambdify("eq31")(1e-3, 2.0, 0.1) == pytest.approx(np.pi**2 * 1e5 + 10, rel=1e-15)
    assert pickle.loads(pickle.dumps(lambdify("eq31")))(1e-3, 0.0, 0.1) > 986_000


@pytest.mark.parametrize(
    ("id", "words"),
    [
        ("eq4", "a condition on any H(z); 'eq5'"),
        ("eq6", "lambdify('eq6', form='derived')"),
        ("eq28", "lambdify('eq28', form='derived')"),
    ],
)
def test_a_formula_without_a_stable_form_says_what_to_do(id, words):
    with pytest.raises(ValueError, match=re.escape(words)) as wrong:
        lambdify(id)
    assert "did you mean" not in str(wrong.value)
    run = command("export", id, "--list")
    assert run.returncode == 2
    assert words in run.stderr


@pytest.mark.parametrize("id", ["eq7", "eq12", "eq24"])
def test_these_are_exported_by_number(id):
    assert command("export", id, "--list").returncode == 0

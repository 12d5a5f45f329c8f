"""Exported C beside exact values in ball arithmetic: no result is farther off than recorded."""

import math
import shutil
from functools import cache
from pathlib import Path

import flint
import libm
import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb

from symhaptic.balls import closed, implicit
from symhaptic.balls.exact import EXACT
from symhaptic.bench import error, exported
from symhaptic.bench.points import columns, leaving_pi
from symhaptic.export import library, request
from symhaptic.export.accuracy import (
    DERIVATIVES,
    MEASURED,
    MEASURED_ON,
    MEASURED_WITH_MUSL,
    MUSL,
)
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.routines import arithmetic, device
from symhaptic.export.vectors import sized
from symhaptic.forms.derivatives import differentiable, with_derivatives

pytestmark = pytest.mark.ci

needs_gcc = pytest.mark.skipif(
    shutil.which("gcc") is None, reason="no gcc here: exported C is not measured"
)
COUNT = 2000
FEW = {"max_stable_stiffness": 200, "passivity_boundary": 500, "passivity_margin": 200,
       "max_passive_stiffness": 500, "stability_boundary": 700}  # fmt: skip
"""Fewer of those whose exact values take long."""
SLOPES = {DOUBLE: 240, SINGLE: 60}
"""And of those with derivatives."""
SOME, SOME_SLOPES = 80, 60
"""So many of the same, the hard cases first, in `make test`, and with derivatives in `make ci`;
`make check` has the others, too."""
GOALS = {
    "discretize": 2, "discretize_fractional": 4, "characteristic_polynomial": 4, "linear_limit": 4,
    "passivity_margin_at": 4, "passivity_margin": 4, "passivity_boundary": 8,
    "max_passive_stiffness": 8, "stability_boundary": 8, "max_stable_stiffness": 8,
}  # fmt: skip
"""What was asked for: 2 for the plant, 4 for passivity, 8 for boundaries and extreme points."""


IN_BLOCKS = "discretize", "stability_boundary", "passivity_margin_at"
"""Whose ordinary arguments `kernels/ordinary.cpp` computes."""


def cases(*tables, wanted=lambda *_: True, later=None):
    """Each function of these tables; of one of them, if it is named so, with `make ci`."""
    return pytest.mark.parametrize(
        ("records", "precision", "name"),
        [pytest.param(table, precision, name, marks=[pytest.mark.ci] * (table is later))
         for table in tables for precision in table
         for name in table[precision] if wanted(table, precision, name)],
        ids=lambda x: "derivatives" if x is DERIVATIVES else "musl" if x is MEASURED_WITH_MUSL else
            "results" if x is MEASURED else getattr(x, "name", x),
    )  # fmt: skip


def counts(records, precision, name):
    """How many points there are, and how many of these `make test` has."""
    if records is DERIVATIVES:
        return SLOPES[precision], SOME_SLOPES
    return FEW.get(name, COUNT), SOME


def has_others(*case):
    count, some = counts(*case)
    return count > some


every = cases(MEASURED, DERIVATIVES, later=DERIVATIVES)
every_other = cases(MEASURED, DERIVATIVES, wanted=has_others)
AT_HOME = libm.tag() == MEASURED_ON
"""Whether the mathematical library is that of the records; figures may only shrink there."""


def most(table, precision, name, at_home=AT_HOME):
    """The largest error that is allowed: the record, and with another library the goal.

    What has no goal, or misses it, may be twice the record there: where glibc's functions are off
    by little more than half a last place, others are by one.
    """
    record = table[precision][name].error
    if at_home:
        return record
    goal = GOALS[name] if table is MEASURED else 0
    return goal if record <= goal else 2 * record


def test_a_record_binds_only_where_it_was_measured(monkeypatch):
    """A sine that is one last place off makes another library, of which the goals are asked."""
    home = MEASURED[DOUBLE]["discretize"].error
    assert most(MEASURED, DOUBLE, "discretize", at_home=True) == home
    assert most(MEASURED, DOUBLE, "discretize", at_home=False) == 2 > home
    missed = MEASURED[DOUBLE]["stability_boundary"].error
    assert most(MEASURED, DOUBLE, "stability_boundary", at_home=False) >= missed
    slope = DERIVATIVES[DOUBLE]["discretize"].error
    assert most(DERIVATIVES, DOUBLE, "discretize", at_home=False) == 2 * slope
    here = libm.tag()
    assert here == libm.tag()
    sine = math.sin
    monkeypatch.setattr(math, "sin", lambda x: math.nextafter(sine(x), 2))
    assert libm.tag() != here


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """A function in C, with its derivatives where these are meant, compiled once."""

    @cache
    def made(name, precision, slopes):
        (form,) = request.chosen([name])
        form = with_derivatives(form, differentiable(form)) if slopes else form
        return form, error.compiled(form, tmp_path_factory.mktemp(name), precision)

    return made


@cache
def points(form, count, precision):
    """Arguments of a form, the same for each that asks."""
    return columns(form, np.random.default_rng(2), count, precision)


def are_within_the_record(records, precision, name, compiled, share):
    form, run = compiled(name, precision, records is DERIVATIVES)
    arrays = [a[share] for a in points(form, counts(records, precision, name)[0], precision)]
    for result, (off, point) in error.compare(form, arrays, run(arrays), precision).items():
        table = DERIVATIVES if "_by_" in result else MEASURED
        assert round(off, 2) <= most(table, precision, name), (result, point)


@needs_gcc
@every
def test_no_error_is_larger_than_the_recorded_one(records, precision, name, compiled):
    """All hard cases and some others; the record is that of 10^5 points, of derivatives 10^4."""
    some = slice(counts(records, precision, name)[1])
    are_within_the_record(records, precision, name, compiled, some)


@pytest.mark.slow
@needs_gcc
@every_other
def test_nor_is_one_of_the_others(records, precision, name, compiled):
    others = slice(counts(records, precision, name)[1], None)
    are_within_the_record(records, precision, name, compiled, others)


@needs_gcc
@pytest.mark.skipif(not AT_HOME, reason=f"measured on {MEASURED_ON}, not on {libm.tag()}")
@every
def test_the_recorded_error_is_found_where_it_was(records, precision, name, compiled):
    """At its own arguments: a smaller one means that the record has to shrink."""
    form, run = compiled(name, precision, records is DERIVATIVES)
    record = records[precision][name]
    arrays = [np.array([x], dtype=precision.kind) for x in record.at]
    found = error.compare(form, arrays, run(arrays), precision)[record.result][0]
    assert found == pytest.approx(record.error, abs=0.006)


needs_musl = pytest.mark.skipif(
    shutil.which(exported.MUSL) is None or libm.musl() != MUSL,
    reason=f"no {exported.MUSL} with {MUSL} here: its functions are not measured",
)


@pytest.mark.slow
@needs_musl
@cases(MEASURED_WITH_MUSL)
def test_with_musl_no_error_is_larger_than_the_recorded_one(records, precision, name, tmp_path):
    """At the same points, hard cases first; and the record is found at its own arguments."""
    (form,) = request.chosen([name])
    run = error.compiled(form, tmp_path, precision, exported.MUSL)
    record = records[precision][name]
    some = [a[:SOME] for a in points(form, counts(records, precision, name)[0], precision)]
    for off, point in error.compare(form, some, run(some), precision).values():
        assert round(off, 2) <= record.error, point
    there = [np.array([x], dtype=precision.kind) for x in record.at]
    found = error.compare(form, there, run(there), precision)[record.result][0]
    assert found == pytest.approx(record.error, abs=0.006)


@needs_musl
def test_another_library_is_really_another(tmp_path):
    """Some sines differ in their last places, and so does what is made of them."""
    (form,) = request.chosen(["passivity_margin_at"])
    found = []
    for compiler in (exported.GCC, exported.MUSL):
        folder = tmp_path / compiler
        folder.mkdir()
        arrays = points(form, COUNT, DOUBLE)
        found.append(error.compiled(form, folder, compiler=compiler)(arrays))
    same = np.isclose(*found, rtol=1e-9, atol=1e-9, equal_nan=True)
    assert same.mean() > 0.9
    assert not np.array_equal(*found, equal_nan=True)


@needs_gcc
@pytest.mark.parametrize("precision", MEASURED, ids=lambda p: p.name)
@pytest.mark.parametrize("name", sorted(set(EXACT) - {"characteristic_polynomial"}))
def test_the_ufuncs_are_the_c_that_is_measured(name, precision, compiled):
    """Bit by bit, so that the records are theirs; what needs one delay has no ufunc.

    Three functions compute ordinary arguments in another way, and keep the same goals.
    """
    ufuncs = pytest.importorskip(
        "symhaptic.kernels._compiled", reason="the install found no compiler", exc_type=ImportError
    )
    form, run = compiled(name, precision, False)
    arrays = points(form, COUNT, precision)
    found = np.stack(np.atleast_2d(getattr(ufuncs, name)(*arrays)))
    assert found.dtype == precision.kind
    same = found == run(arrays)
    if precision is DOUBLE and name in IN_BLOCKS:
        some = np.flatnonzero(~same.all(axis=0))[:SOME]
        few = [a[some] for a in arrays]
        assert error.errors(form, few, found[:, some]).max() <= GOALS[name]
    else:
        assert np.array_equal(found, run(arrays), equal_nan=True)


def test_what_has_derivatives_is_measured_but_for_two_in_single_precision():
    """Of the boundary they lose digits to underflow, of the margin floats do not tell the angle."""
    some = {name for name in EXACT if differentiable(*request.chosen([name]))}
    assert set(DERIVATIVES[DOUBLE]) == some
    assert set(DERIVATIVES[SINGLE]) == some - {"stability_boundary", "passivity_margin"}


@pytest.mark.parametrize("precision", MEASURED, ids=lambda p: p.name)
def test_every_function_of_numbers_is_measured(precision):
    measured = set(MEASURED[precision])
    assert measured == set(EXACT) == set(MEASURED_WITH_MUSL[precision])
    names = {form.name for form in request.chosen([])}
    assert names - measured == {"is_stable", "unstable_roots", "stability_conditions"}


@cases(MEASURED, MEASURED_WITH_MUSL)
def test_what_is_recorded_is_within_its_goal(records, precision, name):
    """Beta with a stiff spring once was not: n1 and n0 near whole turns."""
    assert records[precision][name].error <= GOALS[name]


def test_an_angle_next_to_pi_hangs_on_the_slope_there():
    """Beside exact angles: a plant that is moved moves the angle as much as the slope says."""
    (form,) = request.chosen(["max_stable_stiffness"])
    gamma, delta = 2.0, leaving_pi(2.0) * (1 - 1e-6)
    for d in (0.0, 0.25 * 2**-20):
        angle = form.expressions[-1].args[d > 0][0]
        slopes, angles = [], []
        for moved in (gamma, gamma - 1e-9):
            with mpmath.workdps(50), flint.ctx.workprec(300):
                angles.append(EXACT[form.name](moved, delta, d)[2])
                at = dict(zip(form.arguments, map(mpmath.mpf, (moved, delta, d)), strict=True))
                known = {s: (v, v) for s, v in at.items()}
                value = sized(angle, known)[0]
                slopes.append(sized(angle.leaning().total, known)[0])
                assert float(arb(str(value)) - angles[-1]) == pytest.approx(0, abs=1e-25)
                lean = sized(angle.leaning().slope, known)[0]
        moved = float(angles[1] - angles[0])
        assert moved == pytest.approx(float(lean * (slopes[1] - slopes[0])), rel=1e-2)
        assert abs(moved) > 1e-8


@pytest.mark.parametrize("d", [0.2221359375853755, 0.15, 0.1])
def test_no_angle_needs_more_than_the_exact_worst_one(d):
    """Next to the delay of 2/9 the worst angle leaves pi, where the slope vanishes anyway."""
    alpha, beta = 0.0005847863209369106, 0.058535222074622924
    with flint.ctx.workprec(300):
        need, angle = implicit.largest_required_damping(alpha, beta, d)
        for theta in np.linspace(2.9, math.pi, 50):
            there = closed.required_damping_at(arb(alpha), arb(beta), 0, arb(d), arb(theta))
            assert not there > need
    assert float(angle) == pytest.approx(3.0879 if d > 0.2 else math.pi, abs=1e-3)


@needs_gcc
@pytest.mark.parametrize("low", ["root_miss", "q_low"])
@pytest.mark.parametrize("precision", MEASURED, ids=lambda p: p.name)
def test_a_dropped_low_part_is_noticed(precision, low, monkeypatch, tmp_path: Path):
    """A mutant of the routines: a root or a pole without what its float misses."""
    whole = device.real_poles

    def mutant(*given):
        large, (small, _) = whole(*given)
        return large, (small, sp.S.Zero)

    (form,) = request.chosen(["discretize"])
    library.known.cache_clear()
    exported.written.cache_clear()
    with monkeypatch.context() as patch:
        if low == "root_miss":
            for caller in (arithmetic, device):
                patch.setattr(caller, "root_miss", lambda *_: sp.S.Zero)
        else:
            patch.setattr(device, "real_poles", mutant)
        run = error.compiled(form, tmp_path, precision)
    library.known.cache_clear()
    exported.written.cache_clear()
    arrays = points(form, COUNT, precision)
    found = error.compare(form, arrays, run(arrays), precision)
    assert max(off for off, _ in found.values()) > MEASURED[precision]["discretize"].error


def test_nothing_is_no_error_only_next_to_the_end_of_a_curve():
    """Where balls find no wall one last place ahead; NaN anywhere else is infinitely wrong."""
    (form,) = request.chosen(["passivity_boundary"])
    for theta, expected in ((0.001858695293776691, 0.0), (0.0015, np.inf)):
        arrays = [
            np.array([x], dtype=np.float32) for x in (theta, 2.18916916847229, 1689.2138671875)
        ]
        nothing = np.full((2, 1), np.nan, dtype=np.float32)
        found = error.compare(form, arrays, nothing, SINGLE)
        assert [off for off, _ in found.values()] == [expected, expected]


def test_nothing_is_no_error_where_the_first_maximum_does_not_border_the_stable_region():
    """A stiff spring and a softer one; the roots of the loop with a wall a little inside decide."""
    (form,) = request.chosen(["max_stable_stiffness"])
    for gamma, expected in ((9.787324270255052, 0.0), (5.0, np.inf)):
        arrays = [np.array([x]) for x in (gamma, 0.10330520125756526, 0.42213529560162316)]
        found = error.compare(form, arrays, np.full((3, 1), np.nan))
        assert [off for off, _ in found.values()] == [expected] * 3


@pytest.mark.parametrize("precision", MEASURED, ids=lambda p: p.name)
def test_points_around_others_are_in_the_domain(precision):
    """Of all distances, at both ends of each argument; whole delays stay whole."""
    rng = np.random.default_rng(8)
    ends = {"gamma": [0, 1e-30, 700], "delta": [0, 700], "epsilon": [0, 0.5, 1 - 1e-6],
            "theta": [1e-6, 0.1, 1.6, 3.1, precision.below_pi], "d": [0, 3, 1e6]}  # fmt: skip
    for name, values in ends.items():
        found = error._around(name, np.array(values * 50, precision.kind), rng, precision)
        assert found.dtype == precision.kind
        assert found.min() >= 0
        if name == "theta":
            assert found.min() > 0
            assert float(found.max()) <= precision.below_pi
        if name == "epsilon":
            assert found.max() < 1
        if name == "d":
            assert (found % 1 == 0).all()
        assert len(set(found.tolist())) > len(values) or name == "d"


@needs_gcc
def test_a_search_finds_what_plain_points_do_not():
    """Around them more than ten times as many: one more at least is worse."""
    (form,) = request.chosen(["discretize_fractional"])
    plain = error.measure(form, 150, seed=3)
    found = error.climb(form, 150, seed=3, rounds=2)
    assert all(found[result][0] >= off for result, (off, _) in plain.items())
    assert any(found[result][0] > off for result, (off, _) in plain.items())

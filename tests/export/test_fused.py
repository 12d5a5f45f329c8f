"""What several routines find from the same arguments is what each of them finds alone."""

from collections import Counter
from functools import cache, partial

import mpmath
import numpy as np
import oracle
import pytest
from export.inlining import inlined, program
from mpmath import mpf

from symhaptic.export import passes, request
from symhaptic.export.arrays import TARGET
from symhaptic.export.library import known, library, named
from symhaptic.export.passes import of_form
from symhaptic.export.routine import Several, computed
from symhaptic.forms.derivatives import differentiable, with_derivatives
from symhaptic.notation import delta, gamma

ROUTINES = known()
PLAIN = request.chosen([], delay=2)
FORMS = [*PLAIN, with_derivatives(PLAIN[0], differentiable(PLAIN[0]))]
MERGED = {form.name: passes.merged(of_form(form)) for form in FORMS}
JOINT = sorted({step.call.func.__name__ for r in MERGED.values() for step in r.steps
                if isinstance(step, Several)} - {"LateDevice"})  # fmt: skip


OWN = {"NextWave": ["CosNext", "SinNext"]}
"""Routines that are written as one."""


@cache
def in_digits(name):
    """A routine in mpmath, its roundings left out."""
    modules = [{n: partial(alone, n) for n in ROUTINES}, {"TwoProdError": lambda *_: 0}, "mpmath"]
    return program(inlined(named(name, ROUTINES), ROUTINES), modules)


def run(name, *values):
    """All results, in as many digits as are asked for."""
    return in_digits(name)(*values)


def alone(name, *values):
    """The one result."""
    (found,) = run(name, *values)
    return found


POINTS = {
    2: [("0.01", "0.1"), ("3.99", "0.01"), ("30", "1"), ("2", "40"), ("1", "2"), ("0.2", "1.9")],
    7: [("0.7", "0.4", "3.1", "0.3", "0.9", "0.05", "1.1")],
}


@pytest.mark.ci
@pytest.mark.parametrize("name", JOINT)
def test_each_result_is_that_of_the_routine_alone(name):
    count = len(named(name, ROUTINES).arguments)
    for point in POINTS[count]:
        with mpmath.workdps(40):
            numbers = [mpf(x) for x in point]
            parts = OWN.get(name) or name.split("_")
            theirs = [alone(part, *numbers) for part in parts]
            for one, other in zip(run(name, *numbers), theirs, strict=True):
                assert abs(one - other) <= 1e-35 * abs(other)


@pytest.mark.parametrize("part", ["0.1", "0.5", "0.93"])
@pytest.mark.parametrize("point", POINTS[2])
def test_a_late_device_is_made_of_two_parts_of_a_period(point, part):
    """Beside the closed forms of the whole period and of both parts."""
    with mpmath.workdps(50):
        gamma, delta, late = (mpf(x) for x in (*point, part))
        rest = 1 - late
        first = rest**2 * oracle.numbers(gamma * rest**2, delta * rest)[0]
        last = late**2 * oracle.numbers(gamma * late**2, delta * late)[1]
        last *= mpmath.exp(-delta * rest)
        root = rest * mpmath.sqrt(delta**2 / 4 - gamma)  # of sinh(root)/root at 0 its limit, 1
        kick = rest * mpmath.exp(-delta * rest / 2) * mpmath.re(mpmath.sinc(root * 1j))
        apart = 2 * (first + last) - sum(oracle.numbers(gamma, delta)[:2])
        found = run("LateDevice", gamma, delta, late)
        for one, other in zip(found, (apart, first, kick, last), strict=True):
            assert abs(one - other) <= 1e-18 * abs(first)


@pytest.mark.parametrize("name", ["is_stable", "stability_boundary"])
def test_a_fraction_of_a_period_is_one_call(name):
    (form,) = (f for f in PLAIN if f.name == name)
    made = library("some", "", [form], TARGET)
    (public,) = made.public
    calls = [step.call.func.__name__ for step in public.steps if isinstance(step, Several)]
    assert calls.count("LateDevice") == 1
    kicks = [step.call for step in public.steps if isinstance(step, Several)
             and "Kick" in step.call.func.__name__]  # fmt: skip
    assert all(kick.args == (gamma, delta) for kick in kicks)


def test_there_are_some_with_all_kinds_of_arguments():
    assert {len(named(name, ROUTINES).arguments) for name in JOINT} == set(POINTS)


@pytest.mark.parametrize("name", MERGED)
def test_nothing_is_called_twice_with_the_same_arguments(name):
    found = MERGED[name]
    asked = Counter()
    for step in found.steps:
        for expr in computed(step):
            calls = expr.atoms(*passes.MERGED)
            asked.update(call.args for call in calls)
            if isinstance(step, Several):
                asked[expr.args] += 1
    assert not [args for args, times in asked.items() if times > 1]


def test_merged_or_not_the_numbers_are_the_same():
    """To the last places of a float: terms may be added in another order."""
    rng = np.random.default_rng(5)
    given = {"gamma": rng.uniform(0, 5, 60), "delta": rng.uniform(0, 5, 60), "epsilon": 0.3,
             "theta": rng.uniform(0.1, 1, 60), "alpha": 0.4, "beta": 0.2,
             "d": rng.choice([0.0, 1.0, 0.5, 2.25], 60)}  # fmt: skip
    forms = request.chosen([])
    spaces = []
    for merges in (True, False):
        space = {}
        exec(TARGET.source(library("some", "", forms, TARGET, merges))["some.py"], space)
        spaces.append(space)
    for form in forms:
        one, two = (np.stack(np.atleast_1d(s[form.name](*(given[a.name] for a in form.arguments))))
                    for s in spaces)  # fmt: skip
        tolerance = 1e-12 if form.name == "max_stable_stiffness" else 1e-13  # its flat angle
        np.testing.assert_allclose(one, two, rtol=tolerance, atol=1e-15)


def test_a_file_for_octave_has_what_its_function_needs_and_no_more():
    from symhaptic.export.targets import TARGETS

    _, files = request.built(TARGETS["octave"], PLAIN, vectors=False)
    helpers = "elementwise, of_numbers, pick"
    assert files["+haptic/linear_limit.m"].count("\nfunction ") == len(helpers.split())
    assert "kick" in files["+haptic/stability_boundary.m"]
    assert "kick" not in files["+haptic/discretize.m"]

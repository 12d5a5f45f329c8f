"""Routines in their notation: pairs, groups, calls, and what is refused."""

import pytest
import sympy as sp

from symhaptic.export.notation import Pair, Steps, do, pick, routine
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.routine import Several

a, b, c = GROUP = sp.symbols("a b c")


@routine("total total_low", listed=False)
def summed(x: Pair, y):
    """x + y"""
    return do("total", x[0] + y), x[1]


@routine(listed=False, group=GROUP)
def first(group, precision):
    """a, in last places"""
    return group[0] / precision.last


def test_a_number_is_a_pair_that_misses_nothing():
    x, y = sp.symbols("x y")
    with Steps() as steps:
        assert summed(x, y) == sp.symbols("total total_low")
        assert summed((x, y), y) == sp.symbols("total2 total_low2")
    assert [step.call.args for step in steps.done] == [(x, 0, y), (x, y, y)]
    assert all(isinstance(step, Several) for step in steps.done)


def test_a_group_is_one_parameter_of_several_arguments():
    assert first.arguments == GROUP
    assert first(GROUP).args == GROUP
    assert [first.make(p).results[0][1] for p in (DOUBLE, SINGLE)] == [2**52 * a, 2**23 * a]


@pytest.mark.parametrize("given", [(a, b), (a, b, c, a)], ids=len)
def test_too_few_and_too_many_numbers_are_refused(given):
    with pytest.raises(ValueError, match=f"group has 3 numbers, {len(given)} are given"):
        first(given)


def test_a_choice_goes_into_groups():
    assert pick(a > 0, ((a, b), c), 0) == (
        (sp.Piecewise((a, a > 0), (0, True)), sp.Piecewise((b, a > 0), (0, True))),
        sp.Piecewise((c, a > 0), (0, True)),
    )


def test_outside_of_a_routine_there_is_nothing_to_add_to():
    with pytest.raises(AttributeError, match="no routine is written now"):
        do.nonzero(a)

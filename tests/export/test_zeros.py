"""An argument is left out where it is 0 in every call, and nowhere else."""

import pytest
import sympy as sp

from symhaptic.export import request
from symhaptic.export.notation import Steps
from symhaptic.export.passes import without_zeros
from symhaptic.export.targets import TARGETS

x, y, z = sp.symbols("x y z")
f, g = sp.Function("F"), sp.Function("G")


def helper(name, result, arguments=(x, y)):
    return Steps().routine(name, "", arguments, result)


def public(*results):
    return Steps().routine("public", "", (x, y), {f"r{i}": r for i, r in enumerate(results)})


def test_it_is_left_out_there_and_in_all_calls():
    helpers, (user,) = without_zeros({"F": helper("F", x + y)}, [public(f(x, 0), f(y, 0))])
    assert helpers["F"].arguments == (x,)
    assert helpers["F"].results == (("F", x),)
    assert [e for _, e in user.results] == [f(x), f(y)]


@pytest.mark.parametrize("other", [f(x, y), f(x, 1), f(x, -x)], ids=str)
def test_one_call_with_something_else_keeps_it(other):
    helpers, (user,) = without_zeros({"F": helper("F", x + y)}, [public(f(x, 0), other)])
    assert helpers["F"].arguments == (x, y)
    assert user.results[1][1] == other


def test_a_call_inside_of_a_search_or_a_repetition_counts():
    do = Steps()
    (state,) = do.repeat(
        {"state": sp.S.Zero}, lambda s: [f(s, x)], lambda s: s > 1, 9
    )  # fmt: skip
    user = do.routine("public", "", (x,), state + f(x, 0))
    helpers, (found,) = without_zeros({"F": helper("F", x + y)}, [user])
    assert helpers["F"].arguments == (x, y)
    assert found == user


def test_what_becomes_0_by_that_is_left_out_in_its_turn():
    inner = helper("G", x - y)
    outer = helper("F", g(x, x * y))
    helpers, _ = without_zeros({"G": inner, "F": outer}, [public(f(x, 0))])
    assert helpers["G"].arguments == (x,)
    assert helpers["F"].results == (("F", g(x)),)


def test_a_step_that_becomes_0_is_0_where_it_is_used():
    do = Steps()
    step = do("step", x * y)
    given = do.routine("F", "", (x, y), step + x)
    helpers, _ = without_zeros({"F": given}, [public(f(x, 0))])
    assert helpers["F"].steps == ()
    assert helpers["F"].results == (("F", x),)


def test_a_scene_without_a_spring_asks_for_no_stiffness():
    scene = request.scene("no-stiffness")
    _, files = request.built(
        TARGETS["c"], request.chosen(["is_stable"], scene, whole_delays=True), vectors=False
    )
    assert "gamma" not in files["haptic.c"]
    assert "at_one" not in files["haptic.c"]
    assert "sqrt(gamma)" in request.built(
        TARGETS["c"], request.chosen(["is_stable"]), vectors=False
    )[1]["haptic.c"]  # fmt: skip

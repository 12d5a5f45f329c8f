"""Bodies for two precisions are one where they differ in numbers alone, and only then."""

import builtins
import dis
from types import CodeType

import pytest

from symhaptic.export import request
from symhaptic.export.arrays import of_both
from symhaptic.export.targets import TARGETS
from symhaptic.model.parts import FULL

pytestmark = pytest.mark.ci


def test_a_number_that_differs_gets_one_name_for_all_its_places():
    found = of_both(["a = 0.5*x", "b = 1e-15*a + 1e-15"], ["a = 0.5*x", "b = 1e-07*a + 1e-07"], "x")
    assert found == (["a = 0.5*x", "b = number*a + number"], [("number", "1e-15", "1e-07")])


def test_a_sign_belongs_to_a_term_that_is_a_number():
    both = ["y = x - 2.5", "z = x - 2.0*y"], ["y = x + 1.5", "z = x - 3.0*y"]
    body, numbers = of_both(*both, "x")
    assert body == ["y = x + number", "z = x - number2*y"]
    assert numbers == [("number", "-2.5", "1.5"), ("number2", "2.0", "3.0")]
    for which, own in enumerate(both):
        plain = {"x": 7.0}
        found = plain | {name: float(pair[which]) for name, *pair in numbers}
        exec("\n".join(own), plain)
        exec("\n".join(body), found)
        assert (found["y"], found["z"]) == (plain["y"], plain["z"])


def test_a_name_that_is_taken_is_not_given_again():
    body, _ = of_both(["number = 1.5*x"], ["number = 2.5*x"], ["x"])
    assert body == ["number = number2*x"]


@pytest.mark.parametrize(
    "other",
    [["y = 2.0*x"], ["y = x + 2.0*z"], ["y = x - 2.0*z", "w = 1.0"], ["y = x - 2.0*x"], []],
)
def test_other_work_is_not_taken_for_the_same(other):
    assert of_both(["y = x - 2.0*z"], other, ["x", "z"]) is None


@pytest.mark.parametrize("form", request.chosen([], FULL), ids=lambda form: form.name)
def test_a_form_alone_has_what_either_precision_calls(form):
    """Single precision takes other steps here and there, of other helpers."""
    _, files = request.built(TARGETS["numpy"], [form], "alone", vectors=False)
    module = compile(files["alone.py"], "alone.py", "exec")
    space = {"__name__": "alone"}
    exec(module, space)
    assert asked_for(module) <= space.keys() | set(dir(builtins))


def asked_for(code):
    """The names that functions look for in their module."""
    inner = [const for const in code.co_consts if isinstance(const, CodeType)]
    own = {step.argval for step in dis.get_instructions(code) if step.opname == "LOAD_GLOBAL"}
    return own.union(*map(asked_for, inner))

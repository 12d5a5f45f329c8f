"""Bodies for two precisions are one where they differ in numbers alone, and only then."""

import pytest

from symhaptic.export.array_precision import of_both


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

"""Results in balls: as many digits as are asked for, around what doubles say."""

import numpy as np
import pytest
from flint import arb

import symhaptic
from symhaptic.numeric import digits

CALLS = [
    ("discretize", (1e-3, 0.02)),
    ("discretize_fractional", (1e-3, 0.02, 0.3)),
    ("stability_boundary", (0.7, 1e-3, 0.02, 2.3)),
    ("passivity_margin", (0.1, 0.2, 0.02, 2.3)),
    ("passivity_margin_at", (0.7, 0.1, 0.2, 0.02, 2.3)),
    ("passivity_boundary", (0.7, 0.02, 2)),
    ("max_passive_stiffness", (0.02, 3)),
    ("linear_limit", (0.1, 0.02, 2.3)),
]


def listed(found):
    return found if isinstance(found, tuple) else (found,)


@pytest.mark.parametrize("count", [1, 30, 1000])
@pytest.mark.parametrize(("name", "given"), CALLS, ids=[name for name, _ in CALLS])
def test_balls_are_narrow_and_around_the_floats(name, given, count):
    function = getattr(symhaptic, name)
    for ball, number in zip(listed(function(*given, digits=count)), listed(function(*given)),
                            strict=True):  # fmt: skip
        assert ball.rad() <= abs(ball) * arb(10) ** -count
        assert abs(ball - float(number)) <= 1e-13 * abs(ball) + ball.rad()


def test_arrays_broadcast_to_arrays_of_balls():
    alpha, beta = symhaptic.stability_boundary([[0.5], [1.0]], 0.0, 0.0, [0, 1, 2.5], digits=40)
    assert alpha.shape == beta.shape == (2, 3)
    assert alpha.dtype == object
    assert np.allclose(alpha.astype(float), symhaptic.stability_boundary(
        [[0.5], [1.0]], 0.0, 0.0, [0, 1, 2.5])[0], rtol=1e-14)  # fmt: skip
    assert symhaptic.linear_limit([], 0.1, 0, digits=20).shape == (0,)


@pytest.mark.parametrize(("name", "given"), CALLS, ids=[name for name, _ in CALLS])
def test_nan_is_nan_in_every_result(name, given):
    function = getattr(symhaptic, name)
    found = listed(function(np.nan, *given[1:], digits=20))
    assert len(found) == len(listed(function(*given)))
    assert all(ball.is_nan() for ball in found)


def test_the_pulling_wall_has_no_margin():
    assert symhaptic.passivity_margin(-1.0, 0.0, 1.0, 0, digits=20) == arb("-inf")


def test_a_ball_without_end_is_no_answer_while_more_bits_may_give_one(monkeypatch):
    """Next to a whole swing in a period hardly any force is left, but some: 6 bits do not tell."""
    monkeypatch.setattr("symhaptic.balls.exact.bits", lambda values: 2)
    alpha, _ = symhaptic.stability_boundary(1.0, 39.478417604357434, 0.0, 0, digits=1)
    assert abs(alpha - 6.40235180571087e32) < 0.2 * alpha  # with 20 digits


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: symhaptic.discretize(0.1, 0.1, digits=0), "digits: 0 is not allowed; give"),
        (lambda: symhaptic.discretize(-0.1, 0.1, digits=9), "gamma: -0.1 is not allowed"),
        (lambda: symhaptic.max_passive_stiffness(0.1, 0.5, digits=9), "delay: a fraction is not"),
        (lambda: symhaptic.stability_boundary(1.0, 0.0, 0.0, 0.5, "principal", digits=9),
         "delay: a fraction is not available for digits with sheet='principal'"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(call, said):
    with pytest.raises(ValueError, match=said):
        call()


def test_so_many_digits_and_no_more():
    third = symhaptic.linear_limit(0.5, 0.0, 1.0, digits=100_000)
    assert third.rad() < arb(10) ** -100_000
    assert third.overlaps(arb(1) / 3)
    with pytest.raises(ValueError, match=r"^digits: 100001 is not allowed; give .* to 100000$"):
        symhaptic.linear_limit(0.5, 0.0, 1.0, digits=100_001)


def test_digits_that_are_not_reached_are_told(monkeypatch):
    monkeypatch.setattr(digits, "_TRIES", 0)
    with pytest.raises(ArithmeticError, match="20 digits of passivity_margin are not reached at"):
        symhaptic.passivity_margin(0.1, 0.3, 0.3, 0.5, digits=20)

"""A certificate is accepted only if it shows its claim; every flaw in one is found."""

import pytest
import sympy as sp
from sympy import Rational, S, cos, pi, sin

from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.sign import (
    Interval,
    NotShown,
    assume,
    combined,
    cosine,
    either,
    exponential,
    integrated,
    number,
    quotient,
    sine,
)

x, y, a, p = sp.symbols("x y a p")
POSITIVE_X, POSITIVE_Y = assume(x), assume(y)
ABOVE_ZERO = Interval(x, S.Zero)


# -- what is right ------------------------------------------------------------------------


def test_sum_of_products_is_positive():
    fact = combined(x**2 + 3 * x * y, [POSITIVE_X, POSITIVE_X], [3, POSITIVE_X, POSITIVE_Y])
    assert fact.strict
    assert fact.rests == {(x, True), (y, True)}


def test_square_alone_is_not_strict():
    square = assume((x - y) ** 2, strict=False)
    assert not combined(x**2 - 2 * x * y + y**2, [square]).strict
    assert combined(x**2 - 2 * x * y + y**2 + 1, [square], [1]).strict


def test_relation_of_a_fact():
    assert POSITIVE_X.relation == (x > 0)
    assert assume(x, strict=False).relation == (x >= 0)


def test_sine_lies_below_its_angle():
    # sin x < x for 0 < x < pi: integrate 1 - cos x, itself the integral of sin x
    up = Interval(x, S.Zero, (assume(pi - x), number(S.One)))
    positive = sine(up.above, assume(pi - x))
    first = integrated(1 - cos(x), up, positive)
    second = integrated(x - sin(x), up, first)
    assert second.strict
    assert second.rests == {(x, True), (pi - x, True)}


def test_exponential_of_a_real_number():
    assert exponential(-x * y).relation == (sp.exp(-x * y) > 0)
    with pytest.raises(NotShown, match="not real"):
        exponential(sp.I * pi)  # it is -1
    with pytest.raises(Unsupported, match="c, which is complex"):
        exponential(sp.Symbol("c"))  # may be imaginary, by the notation
    with pytest.raises(Unsupported, match="need not be real"):
        exponential(sp.sqrt(x))


def test_cosine_is_positive_up_to_a_right_angle():
    fact = cosine(assume(x, strict=False), assume(pi / 2 - x))
    assert (fact.expr, fact.strict) == (cos(x), True)


def test_two_cases_cover_the_line():
    # x^2 - x + 1 = x (x - 1) + 1 for x > 1, and x^2 + (1 - x) for 0 <= x <= 1
    right = combined(x**2 - x + 1, [POSITIVE_X, assume(x - 1)], [1])
    left = combined(x**2 - x + 1, [assume(x, False), assume(x, False)], [assume(1 - x, False)])
    both = either(right, left, x - 1)
    assert both.rests == {(x, True), (x, False)}
    assert not both.strict


# -- sums, quotients, numbers -------------------------------------------------------------


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: combined(x + 2 * y, [POSITIVE_X], [POSITIVE_Y]),
        lambda: combined(x - y, [POSITIVE_X], [POSITIVE_Y]),
        lambda: combined(x * y, [POSITIVE_X], [POSITIVE_Y]),
        lambda: combined(-x, [-1, POSITIVE_X]),
        lambda: combined(S.Zero, [0, POSITIVE_X]),
        lambda: combined(pi * x, [pi, POSITIVE_X]),
        lambda: combined(x / 2, [0.5, POSITIVE_X]),
        lambda: combined(y * x, [y, POSITIVE_X]),
        lambda: combined(x, []),
        lambda: quotient(y / x, POSITIVE_Y, assume(x, strict=False)),
        lambda: quotient(x / y, POSITIVE_Y, POSITIVE_X),
        lambda: number(S.Zero),
        lambda: number(3 - pi),
        lambda: number(sin(1) ** 2 + cos(1) ** 2 - 1),
        lambda: sine(POSITIVE_X, assume(2 * pi - x)),
        lambda: sine(POSITIVE_X, assume(pi / 2 - x)),
        lambda: cosine(POSITIVE_X, assume(pi - x)),
        lambda: either(POSITIVE_X, POSITIVE_Y, x),
    ],
)
def test_certificate_that_does_not_add_up_is_rejected(wrong):
    with pytest.raises(NotShown):
        wrong()


def test_sine_up_to_the_ends_is_not_strict():
    assert not sine(assume(x, strict=False), assume(pi - x)).strict
    assert not sine(POSITIVE_X, assume(pi - x, strict=False)).strict


def test_cases_keep_what_they_do_not_split():
    one = combined(x + y, [POSITIVE_X], [POSITIVE_Y])
    two = combined(x + y, [assume(-x, False)], [2, POSITIVE_X], [POSITIVE_Y])
    # the wrong split leaves both assumptions on x in force
    assert (x, True) in either(one, two, y).rests
    # the second case must be the closed one: an open one leaves x = 0 out
    open_case = combined(x + y, [assume(-x)], [2, POSITIVE_X], [POSITIVE_Y])
    assert (-x, True) in either(one, open_case, x).rests


# -- integration --------------------------------------------------------------------------


def test_wrong_derivative_is_rejected():
    with pytest.raises(NotShown, match="derivative"):
        integrated(x**2, ABOVE_ZERO, combined(3 * x, [3, ABOVE_ZERO.above]))


def test_lower_end_that_does_not_vanish_is_rejected():
    with pytest.raises(NotShown, match="vanish"):
        integrated(x**2 - 1, ABOVE_ZERO, combined(2 * x, [2, ABOVE_ZERO.above]))


def test_slope_that_rests_on_a_larger_variable_is_rejected():
    # x^2/2 - 3x has the slope x - 3, positive beyond 3, and is negative at 4
    with pytest.raises(NotShown):
        integrated(x**2 / 2 - 3 * x, ABOVE_ZERO, assume(x - 3))


def test_assumption_on_the_variable_that_is_not_held_is_rejected():
    with pytest.raises(NotShown):
        integrated(x - x**2 / 2, ABOVE_ZERO, assume(1 - x))


def test_assumption_that_grows_with_the_variable_is_not_held():
    with pytest.raises(NotShown):
        Interval(x, S.Zero, (assume(x - 3), number(S.One)))


def test_slope_of_a_held_assumption_must_be_its_own():
    with pytest.raises(NotShown):
        Interval(x, S.Zero, (assume(1 - 2 * x), number(S.One)))


def test_slope_of_a_held_assumption_must_not_move():
    with pytest.raises(NotShown):
        Interval(x, S.Zero, (assume(1 - x**2), combined(2 * x, [2, POSITIVE_X])))


def test_held_assumption_is_allowed():
    up = Interval(x, S.Zero, (assume(1 - x), number(S.One)))
    fact = integrated(x - x**2 / 2, up, assume(1 - x))
    assert fact.rests == {(x, True), (1 - x, True)}


def test_slope_that_may_vanish_gives_no_strict_sign():
    fact = integrated(x, ABOVE_ZERO, combined(S.One, [assume(S.One, strict=False)]))
    assert not fact.strict


def test_what_a_held_assumption_rests_on_is_not_forgotten():
    # p - a x holds for smaller x only if a > 0: with p = a = -1 it holds beyond 1, and
    # p x - a x^2/2 = -x + x^2/2 is -3/8 at 3/2
    room = assume(p - a * x)
    try:
        up = Interval(x, S.Zero, (room, assume(a)))
        fact = integrated(p * x - a * x**2 / 2, up, combined(p - a * x, [room]))
    except NotShown:
        return
    assert (a, True) in fact.rests


def test_only_an_assumption_itself_can_be_held():
    # 1 = (x - 3)/(x - 3) does not grow, but that it is positive rests on x > 3;
    # x^2/2 - 3x is -4 at 4
    beyond = assume(x - 3)
    constant = quotient(S.One, beyond, beyond)

    def certificate():
        up = Interval(x, S.Zero, (constant, combined(S.Zero)))
        return integrated(x**2 / 2 - 3 * x, up, combined(x - 3, [beyond]))

    with pytest.raises(NotShown):
        certificate()


def test_symbolic_lower_end():
    up = Interval(x, y)
    fact = integrated(x**2 - y**2, up, combined(2 * x, [2, up.above], [2, POSITIVE_Y]))
    assert fact.rests == {(x - y, True), (y, True)}


def test_certified_sign_holds_at_points():
    # the first chord of the envelope, N = 5: checked against its values on a grid
    up = Interval(x, S.Zero, (assume(pi - 5 * x), number(S(5))))
    low, high = up.above, assume(pi - 5 * x)
    sin_x = sine(low, combined(pi - x, [high], [4, low]))
    sin_4x = sine(combined(4 * x, [4, low]), combined(pi - 4 * x, [high], [low]))
    expr = sin(5 * x) - 5 * sin(x) * cos(4 * x)
    fact = integrated(expr, up, combined(sp.diff(expr, x), [15, sin_x, sin_4x]))
    assert fact.strict
    for step in range(1, 20):
        assert expr.subs(x, pi / 5 * Rational(step, 20)).evalf(30) > 0

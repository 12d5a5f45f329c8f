"""The usual slips of somebody who writes a formula down as code: each is refused, and named."""

import math
from dataclasses import replace
from math import cos, degrees, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from scipy.linalg import expm

from symhaptic.check import callers
from symhaptic.check.compare import compared, plainest
from symhaptic.check.formulas import CHECKED
from symhaptic.check.mistakes import factor


def stiffest(b, T, d, *, turn=lambda x: x, half=lambda x: x / 2, pi=pi):
    """(11) of the paper, with what may go wrong in it."""
    n = pi / (2 * (d + 1))
    return 2 * b / T * tan(turn(half(n))), b * (sin(turn(n * d)) - d / (d + 1)) / sin(turn(n))


def single(b, T, d):
    """Single precision inside, and a product in double precision behind."""
    K, B = (np.float32(v) for v in stiffest(b, T, d))
    return float(K) * 1.0000000001, float(B) * 1.0000000001


def frequency(k, b, m):
    """(28): the frequency of a device that swings."""
    inside = k / m - (b / m / 2) ** 2
    return sqrt(inside) if inside >= 0 else math.nan


def sampled(b, k, m, T, *, root=sqrt):
    """(12) as it is right; only of a device that does not swing has it a value."""
    c = root(b * b - 4 * k * m) * T / m
    c2, c3, e = (
        math.exp(-b * T / m / 2 - c / 2),
        math.exp(-b * T / m / 2 + c / 2),
        math.exp(-b * T / m),
    )
    odd, inside = b * m / T * c * (c3 - c2), b * b - 4 * k * m
    below = -2 * k * inside
    return (
        (odd + inside * (c2 + c3 - 2)) / below,
        (-odd + inside * (c2 + c3 - 2 * e)) / below,
        c2 + c3,
        e,
    )


def defined(function):
    """NaN where a formula cannot be computed."""

    def f(*arguments):
        try:
            return function(*arguments)
        except (ValueError, ZeroDivisionError):
            return (math.nan,) * 4

    return f


SLIPS = [
    ("eq11", lambda b, T, d: 2 * b / T * tan(pi / (2 * (d + 1.0000001))), "differs"),
    ("eq11", lambda b, T, d: stiffest(b, T, d, half=lambda x: x * 0.98)[0], "differs"),
    ("eq11", lambda b, T, d: 2 * b / T * tan(pi / (8 * (d + 1))), "half the angle in tan"),
    (
        "eq11",
        lambda b, T, d: stiffest(b, T, d, turn=radians),
        "the angle as degrees in tan, sin and",
    ),
    (
        "eq11",
        lambda b, T, d: stiffest(b, T, d, turn=degrees),
        "turned into degrees in tan, sin and",
    ),
    ("eq11", lambda b, T, d: stiffest(b, T, d, pi=3.14159), "3.14159 for pi"),
    ("eq11", lambda b, T, d: stiffest(b, T, d, pi=22 / 7), "22/7 for pi"),
    ("eq11", lambda b, T, d: stiffest(b, T / 2, d), "T/2 for T"),
    ("eq11", lambda b, T, d: stiffest(b, 1000 * T, d), "T is taken in milliseconds"),
    ("eq11", lambda b, T, d: stiffest(b, T, d / T)[0], "d is taken in seconds, not in periods"),
    ("eq11", lambda T, b, d: stiffest(b, T, d), "arguments are taken in another order"),
    ("eq11", lambda b, T, d: stiffest(b, T, d - 1), "d - 1 for d"),
    ("eq11", lambda b, T, d: stiffest(b, T, d)[0] * T, "1/T dropped"),
    ("eq11", lambda b, T, d: stiffest(b, T, d)[0] * 3, "K is 3 times what is right"),
    ("eq11", lambda b, T, d: tuple(-v for v in stiffest(b, T, d)), "the sign of all results"),
    ("linear_limit", lambda y, x, d: max((y + x) / (d + 0.5), 0), "cut off at 0"),
    ("eq11", lambda b, T, d: tuple(map(float, map(int, stiffest(b, T, d)))), "whole numbers"),
    ("eq11", single, "single precision, somewhere in between"),
    (
        "eq11",
        lambda b, T, d: (
            stiffest(b, T, d)[0],
            b * (sin(pi * d / (2 * (d + 1))) - d // (d + 1)) / sin(pi / (2 * (d + 1))),
        ),
        "a division of whole numbers, rounded down",
    ),
    (
        "eq9",
        lambda b, B, T, d: (b + B) / ((d + 1 // 2) * T) if d else math.nan,
        "1/2 as a division",
    ),
    ("eq6", lambda K, B, T: K * T / 2 + B, "the absolute value left out"),
    ("eq6", lambda K, B, T: K * T + abs(B), "(6) with 2*"),
    ("eq5", lambda K, B, T, omega, d: eq5(K, B, T, 2 * pi * omega, d), "omega is taken in Hz"),
    ("eq24", lambda b, B, t_d, T: (b + B) / (t_d * T + T / 2), "t_d is taken in periods"),
    ("eq28", lambda k, b, m: frequency(k, b, m) ** 2, "the square root left out"),
    ("eq28", lambda k, b, m: frequency(k, b, m) / (2 * pi), "are given in Hz"),
    ("eq28", lambda k, b, m: frequency(k, b, 1000 * m), "m is taken in grams"),
    ("eq28", lambda k, b, m: sqrt(k / m), "dropped"),
    ("eq12", defined(sampled), "NaN where the device swings: a real square root of b^2 - 4km"),
    (
        "is_passive",
        lambda alpha, beta, delta, d: passive(2 * alpha, beta, delta, d),
        "alpha is taken twice",
    ),
    ("is_stable", lambda *wall: False, "every result is 0"),
    (
        "stability_boundary",
        lambda theta, *rest: bound(radians(theta), *rest),
        "theta is taken as degrees",
    ),
]


def held(b, k, m, T):
    """(12) by a matrix exponential: the device under a held force, and its textbook polynomials."""
    A = np.array([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]])
    step = expm(A * T)
    P, Q = step[:2, :2], step[:2, 2]
    a, e = np.trace(P), np.linalg.det(P)
    return Q[0], P[0, 1] * Q[1] - P[1, 1] * Q[0], a, e


def eq5(K, B, T, omega, d):
    half = omega * T / 2
    return K * T * sin((2 * d + 1) * half) / (2 * sin(half)) - B * cos(2 * (d + 1) * half)


def passive(*wall):
    from symhaptic import is_passive

    return float(is_passive(*wall))


def bound(*at):
    from symhaptic import stability_boundary

    return tuple(map(float, stability_boundary(*at)))


@pytest.mark.parametrize(
    ("formula", "function", "said"), SLIPS, ids=lambda v: v if isinstance(v, str) else ""
)
def test_a_usual_slip_is_refused_and_named(formula, function, said):
    checked = CHECKED[formula]
    found = compared(checked, callers.called(function), 8, 500)
    assert not found.agrees
    if said == "differs":  # no usual slip: nothing is named
        assert found.names == ()
    else:
        assert said in " ".join(found.names)


@pytest.mark.parametrize(
    ("formula", "function", "over"),
    [
        ("eq5", eq5, {"omega": (1.0, 300.0), "T": (1e-3, 1e-2), "d": (0, 5)}),
        ("eq6", lambda K, B, T: K * T / 2 + abs(B), {}),
        ("eq9", lambda b, B, T, d: (b + B) / ((d + 1 / 2) * T), {}),
        ("eq11", stiffest, {}),
        ("eq12", held, {"k": (1.0, 1e3), "b": (0.1, 10.0), "m": (0.1, 1.0), "T": (1e-3, 1e-2)}),
        ("eq24", lambda b, B, t_d, T: (b + B) / (t_d + T / 2), {}),
        ("eq28", frequency, {}),
    ],
)
def test_the_textbooks_code_agrees(formula, function, over):
    checked = replace(CHECKED[formula], balls=100)
    found = compared(checked, callers.called(function), 1e5, 100, over, explained=False)
    assert found.agrees, (found.worst, found.at)


def test_twice_the_angle_is_named():
    """tan(angle) where the paper has tan(angle/2): without delay it has no value at all."""

    def mine(b, T, d):
        return 2 * b / T * tan(pi / (2 * (d + 1)))

    found = compared(CHECKED["eq11"], callers.called(mine), 8, 3000)
    assert found.names == ("this is (11) with twice the angle in tan",)


@pytest.mark.parametrize(
    ("formula", "function", "said"),
    [
        ("is_passive", lambda *wall: not passive(*wall), "true and false are exchanged"),
        (
            "scene.max_stable_stiffness",
            lambda m, b, k, T, d: 2 * b / T,
            "a rule in circulation: a stiffness up to twice the damping over the period is stable; "
            "see rules:twice-damping",
        ),
    ],
)
def test_few_points_name_what_is_wrong_everywhere(formula, function, said):
    assert compared(CHECKED[formula], callers.called(function), 8, 60).names == (said,)


def test_numbers_that_are_wrong_beside_nan_are_told_of_whatever_their_size():
    """(12) has n1 = x T^2/m of some 1e-6 s^2/kg: one hundredth of them is far, too."""

    def mine(b, k, m, T):
        n1, n0, a, e = sampled(b, k, m, T)
        return n0, n1 + n0, a, e

    over = {"T": (1e-4, 1e-2), "m": (0.1, 1.0)}
    found = compared(CHECKED["eq12"], callers.called(defined(mine)), 8, 300, over)
    assert found.names == (
        "NaN where the device swings: a real square root of b^2 - 4km; "
        "where it is a number it is wrong, too",
    )


def test_a_factor_is_a_fraction_only_where_it_is_one():
    """1/sqrt(2) is off by 1e-6 from each fraction of numbers up to 1000; 355/113 is not pi, but
    as near as the factor has digits."""
    x = np.arange(1.0, 9.0)
    for times, said in ((sqrt(0.5), "0.707107*x"), (0.4, "2*x/5"), (pi * pi, "9.8696*x")):
        assert factor({"x": ()}, [x], x, times * x**2) == said


def test_the_plainest_wrong_argument_may_be_a_power_of_ten():
    """K is wrong from 900 to 5000 only, where 4321.0 is rounded to 4000 or to its power, 1000."""

    def mine(K, B, T):
        return K * T / 2 + abs(B) + (900 < K < 5000)

    begin = (4321.0, 0.3, 0.1), (7.0,)
    at, _ = plainest(CHECKED["eq6"], callers.called(mine), begin, 8, {}, 60.0)
    assert at == (1000.0, 0.0, 1.0)


def test_a_right_function_has_no_slip():
    found = compared(CHECKED["eq11"], callers.called(stiffest), 8, 2000)
    assert found.agrees
    assert found.names == ()

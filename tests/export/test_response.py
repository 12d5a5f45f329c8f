"""The device's force on the circle: its routines are its closed form, and round but once."""

import math
import random
from fractions import Fraction

import pytest
import sympy as sp

from symhaptic.export.library import known
from symhaptic.export.routine import ProductError
from symhaptic.model.response import Ahead, InPhase

PARTS = {cls.__name__: cls for cls in (InPhase, Ahead)}
T = sp.Symbol("t")

ROUNDED = 0.5001
"""Half a last place, and what is lost beyond twice the digits."""


def done(routine):
    """All steps, and the result as the last one."""
    return (*routine.steps, (None, routine.results[0][1]))


@pytest.mark.parametrize("name", PARTS)
def test_without_rounding_it_is_the_closed_form(name):
    routine, at = known()[name], {}
    for symbol, expr in done(routine):
        at[symbol] = expr.replace(ProductError, lambda *_: sp.S.Zero).xreplace(at)
    closed = PARTS[name].definition(*routine.arguments)
    turned = {sp.cos(routine.arguments[0]): 1 / sp.sqrt(1 + T**2)}
    turned |= {sp.sin(routine.arguments[0]): T / sp.sqrt(1 + T**2)}
    found = at[None].xreplace({sp.tan(routine.arguments[0]): T}) - closed.xreplace(turned)
    assert sp.cancel(sp.together(found)) == 0


def missed(one, two):
    """By how much the product of two floats is rounded."""
    return float(Fraction(one) * Fraction(two) - Fraction(one * two))


def steps(name, without=None):
    """The routine's steps as functions of floats; its tangent is its argument."""
    routine = known()[name]
    before, found = list(routine.arguments), []
    for number, (symbol, expr) in enumerate(done(routine)):
        if number == without:
            expr = expr.replace(ProductError, lambda *_: sp.S.Zero)
        expr = expr.replace(sp.tan, lambda x: x)
        found.append(sp.lambdify(before, expr, [{"ProductError": missed}, math]))
        before.append(symbol)
    return found


def errors(name, points, without=None):
    """In units in the last place, what cancels in twice the digits left out."""
    own = steps(name, without)
    for point in points:
        values = list(point)
        for step in own:
            values.append(float(step(*values)))
        exact, size = force(name, *map(Fraction, point))
        off = abs(Fraction(values[-1]) - exact) - size / 2**98
        yield float(off / Fraction(math.ulp(float(exact))))


def force(name, t, at_one, at_minus_one, loss, together, apart, across):
    """The part by its definition as a fraction of complex numbers, and its largest term."""
    above, above_j = (at_one, -at_minus_one * t * t), 2 * t * loss
    below, below_j = (together, -apart * t * t), t * across
    size = sum(below) ** 2 + below_j**2
    pairs = [(above_j, below_j)] if name == "InPhase" else []
    pairs += [(x, y) for x in above for y in below] if name == "InPhase" else []
    pairs += [(above_j, x) for x in below] if name == "Ahead" else []
    pairs += [(-x, below_j) for x in above] if name == "Ahead" else []
    terms = [x * y / size for x, y in pairs]
    most = max(abs(x) for x in (*below, below_j)) ** 2 / size
    return sum(terms), max(map(abs, terms)) * most


def points(count):
    """Devices of all sizes, at all angles; also such as nearly cancel."""
    chance = random.Random(7)
    for _ in range(count):
        t = 10 ** chance.uniform(-4, 4)
        numbers = [10 ** chance.uniform(-3, 1) for _ in range(6)]
        if chance.random() < 0.5:
            numbers[0] = numbers[1] * t * t * (1 + chance.uniform(-1, 1) * 1e-9)
        if chance.random() < 0.5:
            numbers[3] = numbers[4] * t * t * (1 + chance.uniform(-1, 1) * 1e-9)
        yield (t, *numbers)


@pytest.mark.parametrize("name", PARTS)
def test_it_is_rounded_once(name):
    assert max(errors(name, points(400))) < ROUNDED


@pytest.mark.parametrize("name", PARTS)
def test_nothing_that_a_product_misses_may_be_left_out(name):
    for number, (_, expr) in enumerate(done(known()[name])):
        if expr.has(ProductError):
            assert any(error > ROUNDED for error in errors(name, points(400), number)), number

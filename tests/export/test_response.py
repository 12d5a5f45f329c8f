"""The device's force on the circle: its routines are its closed form, and differences are exact."""

import math
import random
from fractions import Fraction

import pytest
import sympy as sp

from symhaptic.export.library import known
from symhaptic.export.response import less
from symhaptic.export.routine import ProductError, Steps
from symhaptic.model.response import Ahead, InPhase

PARTS = {cls.__name__: cls for cls in (InPhase, Ahead)}
T = sp.Symbol("t")


@pytest.mark.parametrize("name", PARTS)
def test_without_rounding_it_is_the_closed_form(name):
    routine, at = known()[name], {}
    for symbol, expr in (*routine.steps, (None, routine.results[0][1])):
        at[symbol] = expr.replace(ProductError, lambda *_: sp.S.Zero).xreplace(at)
    psi = routine.arguments[0]
    turned = {sp.cos(psi): 1 / sp.sqrt(1 + T**2), sp.sin(psi): T / sp.sqrt(1 + T**2)}
    closed = PARTS[name].definition(*routine.arguments).xreplace(turned)
    assert sp.cancel(sp.together(at[None].xreplace({sp.tan(psi): T}) - closed)) == 0


def missed(one, two):
    """By how much the product of two floats is rounded."""
    return float(Fraction(one) * Fraction(two) - Fraction(one * two))


def run(steps, values, without):
    """The last step, of floats; one product error may be left out."""
    at = dict(values)
    for symbol, expr in steps:
        if symbol == without:
            expr = expr.replace(ProductError, lambda *_: sp.S.Zero)
        squares = {x: sp.Mul(x.base, x.base, evaluate=False) for x in expr.atoms(sp.Pow)}
        found = sp.lambdify(list(at), expr.xreplace(squares), [{"ProductError": missed}, math])
        at[symbol] = float(found(*at.values()))
    return at[steps[-1][0]]


def chances(count):
    """Numbers of all sizes; every second time the difference of them nearly cancels."""
    chance = random.Random(7)
    for k in range(count):
        one, factor, t = (10 ** chance.uniform(-2, 2) for _ in range(3))
        yield (factor * t * t * (1 + 1e-9 * chance.uniform(-1, 1)) if k % 2 else one), factor, t


ONE, FACTOR, TAN = sp.symbols("one factor tan")

ROUNDED = 0.501
"""Half a last place, and what is lost beyond twice the digits."""


def differences(without=None):
    """Errors of one - factor t^2, in units of its last place."""
    do = Steps()
    square, low = do("square", TAN * TAN), do("low", ProductError(TAN, TAN))
    less(do, ONE, FACTOR, square, low)
    for one, factor, t in chances(200):
        exact = Fraction(one) - Fraction(factor) * Fraction(t) ** 2
        found = run(do.done, {ONE: one, FACTOR: factor, TAN: t}, without)
        yield float(abs(Fraction(found) - exact) / Fraction(math.ulp(float(exact))))


def test_a_difference_is_rounded_once():
    assert max(differences()) < ROUNDED


@pytest.mark.parametrize("left_out", ["low", "missed"])
def test_nothing_that_a_product_misses_may_be_left_out(left_out):
    assert max(differences(sp.Symbol(left_out))) > ROUNDED

"""Compensated functions: their routines are their closed forms and round once where they say it."""

import math
import random
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from export.inlining import inlined

from symhaptic.export.arrays import TARGET
from symhaptic.export.library import known, library
from symhaptic.export.notation import Steps
from symhaptic.export.routine import TwoProdError
from symhaptic.export.routines.response import less
from symhaptic.forms import stable
from symhaptic.forms.required_damping import Between, Straight
from symhaptic.forms.response import Ahead, FractionalNumeratorGap, InPhase

PARTS = {cls.__name__: cls for cls in (InPhase, Ahead, FractionalNumeratorGap, Straight, Between)}
T = sp.Symbol("t")


@pytest.mark.parametrize("name", PARTS)
def test_without_rounding_it_is_the_closed_form(name):
    routine, at = inlined(known()[name], known()), {}
    for symbol, expr in (*routine.steps, (None, routine.results[0][1])):
        at[symbol] = expr.replace(TwoProdError, lambda *_: sp.S.Zero).xreplace(at)
    psi = routine.arguments[0]
    turned = {sp.cos(psi): 1 / sp.sqrt(1 + T**2), sp.sin(psi): T / sp.sqrt(1 + T**2)}
    closed = PARTS[name].definition(*routine.arguments).xreplace(turned)
    assert sp.cancel(sp.together(at[None].xreplace({sp.tan(psi): T}) - closed)) == 0


def missed(one, two):
    """By how much the product of two floats is rounded."""
    return float(Fraction(one) * Fraction(two) - Fraction(one * two))


def program(steps, arguments, without):
    """The steps as functions of floats; one product error may be left out."""
    before = list(arguments)
    for symbol, expr in steps:
        if symbol == without:
            expr = expr.replace(TwoProdError, lambda *_: sp.S.Zero)
        squares = {
            x: sp.Mul(x.base, x.base, evaluate=False) for x in expr.atoms(sp.Pow) if x.exp == 2
        }
        yield sp.lambdify(before, expr.xreplace(squares), [{"TwoProdError": missed}, math])
        before.append(symbol)


def run(functions, values):
    """The value of the last one."""
    values = list(values)
    for function in functions:
        values.append(float(function(*values)))
    return values[-1]


def chances():
    """Numbers of all sizes; every second time the difference of them nearly cancels."""
    chance = random.Random(7)
    for k in range(200):
        one, factor, t = (10 ** chance.uniform(-2, 2) for _ in range(3))
        yield (factor * t * t * (1 + 1e-9 * chance.uniform(-1, 1)) if k % 2 else one), factor, t


def difference():
    """The steps of one - factor t^2, their arguments, and the exact value."""
    do, (one, factor, t) = Steps(), sp.symbols("begin factor tan")
    square, low = do("square", t * t), do("low", TwoProdError(t, t))
    with do:
        less(one, factor, square, low)
    found = do.done[-1].names[0]  # the float itself, without what it misses
    routine = inlined(do.routine("Less", "", (one, factor, t), found), known())
    steps = (*routine.steps, (sp.Symbol("found"), routine.results[0][1]))
    return steps, (one, factor, t), lambda one, factor, t: one - factor * t**2


def late():
    """The same of M at -1 behind a fraction of a period."""
    routine = inlined(known()["FractionalNumeratorGap"], known())
    steps = (*routine.steps, (sp.Symbol("found"), routine.results[0][1]))
    return steps, routine.arguments, FractionalNumeratorGap.definition


def straight():
    """The same of what straight motions need, of its sines and its cosine as floats."""
    routine, given = inlined(known()["Straight"], known()), ("wave", "near", "along")
    steps = [s for s in routine.steps if s[0].name not in given]
    stiffness, damping, k, _ = routine.arguments
    arguments = (stiffness, damping, k, *map(sp.Symbol, given))
    steps.append((sp.Symbol("found"), routine.results[0][1]))
    return (
        steps,
        arguments,
        lambda a, b, k, wave, near, along: a * (2 * k + 1) * wave / near - b * along,
    )


ROUNDED = 0.5001
"""Half a last place, and what is lost beyond twice the digits."""


def late_point(one, x, y):
    """A share of a period, two kicks with what they miss, and terms that nearly cancel theirs."""
    share, chance = one % 1, random.Random(one)
    lows = (chance.uniform(-0.5, 0.5) * math.ulp(k) for k in (x, y))
    first = 2 * share * (1 - share) * x * y * (1 + chance.choice((0, 1e-9, 0.3, 7)))
    (x_low, y_low), last = lows, first * chance.uniform(0, 1e-7)
    return share, x, x_low, y, y_low, first, last, last * chance.uniform(-1, 1)


def errors(work, without=None):
    """In units of the last place of the exact value."""
    steps, arguments, value = work()
    functions = list(program(steps, arguments, without))
    for point in chances():
        if work is late:
            point = late_point(*point)
        if work is straight:
            stiffness, near, wave = point
            whole = float(int(100 * near))
            along = random.Random(wave).uniform(0.1, 1)
            point = stiffness, 3 * stiffness, whole, wave, near, along
        exact = value(*map(Fraction, point))
        found = run(functions, point)
        yield float(abs(Fraction(found) - exact) / Fraction(math.ulp(float(exact))))


@pytest.mark.parametrize("work", [difference, late, straight], ids=lambda f: f.__name__)
def test_it_is_rounded_once(work):
    assert max(errors(work)) < ROUNDED


@pytest.mark.parametrize("work", [difference, late, straight], ids=lambda f: f.__name__)
def test_nothing_that_a_product_misses_may_be_left_out(work):
    kept = [symbol for symbol, expr in work()[0] if expr.has(TwoProdError)]
    assert len(kept) > 1
    for symbol in kept:
        assert max(errors(work, symbol)) > ROUNDED, symbol


def test_a_kick_and_what_its_float_misses():
    """Of slow, creeping devices to a hundredth of a last place; neither alone nor subtracted.

    Where a device swings, exp(-delta/2) of the library is a float that is off by itself.
    """
    space = {}
    form = stable.form("stability_boundary")
    exec(TARGET.source(library("one", "", [form], TARGET, merges=False))["one.py"], space)
    rng = np.random.default_rng(4)
    delta = rng.uniform(0, 0.1, 300)
    gamma = delta * delta / 4 * rng.uniform(0, 0.99, 300)
    kick, low = (space[name](np, gamma, delta) for name in ("kick", "kick_low"))
    offs = []
    for g, d, one, two in zip(gamma, delta, kick, low, strict=True):
        with mpmath.workdps(40):
            # the impulse response of x'' + d x' + g x after a period
            root = mpmath.sqrt(mpmath.mpf(d) ** 2 / 4 - mpmath.mpf(g))
            exact = (mpmath.exp(-mpmath.mpf(d) / 2) * mpmath.sinh(root) / root).real
            last = mpmath.mpf(math.ulp(one))
            offs.append([float(abs(one + k * mpmath.mpf(two) - exact) / last) for k in (1, 0, -1)])
    right, alone, wrong = np.max(offs, axis=0)
    assert right < 0.01
    assert min(alone, wrong) > 0.4

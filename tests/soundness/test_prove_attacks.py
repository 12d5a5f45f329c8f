"""False and meaningless questions, asked afresh: none is proved, enclosed, refuted or confirmed.

Where a side has no value at a point of the box, or at no point at all, there is nothing to say of
it.  ``ZERO`` is zero by Pythagoras, which SymPy does not see.
"""

import time

import pytest
import sympy as sp
from flint import arb, ctx
from sympy import (
    Abs,
    Add,
    Eq,
    I,
    Lt,
    Mul,
    Pow,
    Rational,
    S,
    acosh,
    atan,
    conjugate,
    cos,
    cot,
    exp,
    im,
    log,
    oo,
    pi,
    re,
    sin,
    sqrt,
    tan,
    tanh,
)

from symhaptic import enclose, enclose_maximum, prove, recheck
from symhaptic.proof.certificate import Known, Largest, Positive, Zero
from symhaptic.proof.program import program
from symhaptic.proof.verdict import Kind

x, y, z = sp.symbols("x y z")
f = sp.Function("f")
ZERO = sin(x) ** 2 + cos(x) ** 2 - 1
NUMBER = sin(1) ** 2 + cos(1) ** 2 - 1
"""The same of a number."""
AROUND, UNIT, POINT = (-1, 1), (0, 1), (0, 0)


def kept(head, *parts):
    """What SymPy would evaluate, as it is written."""
    return head(*parts, evaluate=False)


def cancelled(part):
    return kept(Add, part, -part)


def below(left, right=1):
    return kept(Lt, left, right)


REAL = sp.Symbol("x", real=True)
INTEGER = sp.Symbol("n", integer=True)
THIRD = Rational(1, 3)

NOT_ENCLOSED = {
    # a pole, a branch point or a complex value that cancels
    "1/x - 1/x": (below(cancelled(1 / x)), {x: AROUND}),
    "1/x - 1/x at a point": (below(cancelled(1 / x)), {x: POINT}),
    "1/x - 1/x to the right of 0": (below(cancelled(1 / x)), {x: UNIT}),
    "log x - log x": (below(cancelled(log(x))), {x: UNIT}),
    "cot x - cot x": (below(cancelled(cot(x))), {x: AROUND}),
    "tan x - tan x": (below(cancelled(tan(x))), {x: (1, 2)}),
    "sqrt x - sqrt x": (below(cancelled(sqrt(x))), {x: AROUND}),
    "cube roots": (below(cancelled(x**THIRD)), {x: (-1, -THIRD)}),
    "x^-pi - x^-pi": (below(cancelled(x**-pi)), {x: UNIT}),
    "x^x - x^x": (below(cancelled(x**x)), {x: AROUND}),
    "|1/x| - |1/x|": (below(cancelled(Abs(1 / x))), {x: AROUND}),
    "acos x - acos x": (below(cancelled(sp.acos(x))), {x: (0, 2)}),
    "acosh x - acosh x": (below(cancelled(acosh(x))), {x: UNIT}),
    "1/x on both sides": (kept(Lt, 1 / x, Add(1, 1 / x)), {x: AROUND}),
    "on the larger side": (kept(Lt, -1, cancelled(1 / x)), {x: AROUND}),
    "of another symbol": (below(kept(Add, x, 1 / y, -1 / y), 2), {x: UNIT, y: AROUND}),
    "two symbols of one name": (below(kept(Add, 1 / x, -1 / REAL)), {x: AROUND}),
    "the box has the other one": (below(cancelled(1 / x)), {REAL: AROUND}),
    "1/(x - x)": (below(1 / cancelled(x)), {x: UNIT}),
    "f(x) - f(x)": (below(cancelled(f(x))), {x: UNIT}),
    # what is multiplied by zero
    "0/x": (below(kept(Mul, 0, 1 / x)), {x: AROUND}),
    "0 tan x": (below(kept(Mul, 0, tan(x))), {x: (1, 2)}),
    "0 log x": (below(kept(Mul, 0, log(x))), {x: UNIT}),
    "0 f(x)": (below(kept(Mul, 0, f(x))), {x: UNIT}),
    # parts that are finite where the number is not
    "im 1/x": (below(kept(im, 1 / x)), {x: AROUND}),
    "re 1/x": (below(cancelled(kept(re, 1 / x))), {x: AROUND}),
    "im log x": (below(kept(im, log(x)), 4), {x: AROUND}),
    "im of a conjugate": (below(kept(im, kept(conjugate, 1 / x))), {x: AROUND}),
    "im of a product": (below(kept(im, kept(Mul, I, I, 1 / x))), {x: AROUND}),
    # powers of zero, and the power of zero
    "(1/x)^y": (below(kept(Pow, 1 / x, y), 2), {x: AROUND, y: POINT}),
    "(log x)^y": (below(kept(Pow, log(x), y), 2), {x: UNIT, y: POINT}),
    "0^x": (below(kept(Pow, S.Zero, x), 2), {x: AROUND}),
    "x^-1/2": (below(-(x ** -Rational(1, 2)), 0), {x: UNIT}),
    "x^(y - 1)": (below(-(x ** (y - 1)), 1), {x: UNIT, y: UNIT}),
    # removable singularities are singularities
    "sin x/x": (below(sin(x) / x, 2), {x: AROUND}),
    "x/x": (below(kept(Mul, x, 1 / x), 2), {x: AROUND}),
    "1/(1/x)": (below(kept(Pow, 1 / x, -1), 2), {x: AROUND}),
    "exp log x": (below(kept(exp, log(x)), 2), {x: UNIT}),
    "exp -1/x^2": (below(exp(-1 / x**2), 2), {x: AROUND}),
    "atan 1/x": (below(atan(1 / x), 2), {x: AROUND}),
    "tanh 1/x": (below(tanh(1 / x), 2), {x: AROUND}),
    "x log x": (below(x * log(x), 1), {x: UNIT}),
    # no numbers, and functions without balls
    "x < oo": (below(x, oo), {x: UNIT}),
    "-oo < x": (below(-oo, x), {x: UNIT}),
    "oo - oo": (below(kept(Add, oo, -oo)), {x: UNIT}),
    "nan": (below(sp.nan), {x: UNIT}),
    "1/oo": (below(kept(Pow, oo, -1)), {x: UNIT}),
    "Max": (below(sp.Max(1 / x, 0), 2), {x: AROUND}),
    "Piecewise": (below(sp.Piecewise((1 / x, x > 0), (0, True)), 2), {x: UNIT}),
    "floor": (below(sp.floor(x), 1), {x: UNIT}),
    # false at an end, in a point, or by less than a ball's width
    "x < 1": (below(x), {x: UNIT}),
    "x^(10^9) < 1": (below(x ** (10**9)), {x: UNIT}),
    "10^-400": (below(x + Rational(1, 10**400)), {x: (1 - Rational(1, 10**400), 1)}),
    "pi < pi": (below(pi, pi), {}),
    "1 < 0": (below(1, 0), {x: UNIT}),
    "sqrt 2 < its root": (below(sqrt(2) + sqrt(3), sqrt(5 + 2 * sqrt(6))), {}),
}


@pytest.mark.parametrize("name", NOT_ENCLOSED)
def test_a_box_on_which_a_side_is_not_defined_shows_nothing(name):
    relation, box = NOT_ENCLOSED[name]
    assert not prove(relation, box, steps=200_000)


@pytest.mark.parametrize(
    ("relation", "box"),
    [
        (x < 2, {x: (1, 0)}),
        (x < 2, {x: (pi + Rational(1, 10**400), pi)}),
        (x < 2, {x: (0, oo)}),
        (x < 2, {x: (-oo, 0)}),
        (x < 2, {x: (0, sp.nan)}),
        (x < 2, {x: (0, I)}),
        (x < 2, {x: (sqrt(-1 - sqrt(2)), 0)}),
        (x < 2, {x: (0, 1), y: (1, 0)}),  # a symbol that does not occur
        (x < 2, {x: (0, y)}),
        (x < 2, {x: (0, 0.5)}),
        (x < 2.5, {x: UNIT}),
        (x + sp.Float("0.5") < 2, {x: UNIT}),
        (x < y, {x: UNIT}),
        (x < 2, {}),
        (kept(Lt, INTEGER, 2), {INTEGER: UNIT}),
        (kept(Lt, sp.Symbol("p", positive=True), 2), {sp.Symbol("p", positive=True): AROUND}),
        (kept(Lt, sp.Symbol("q", imaginary=True), 2), {sp.Symbol("q", imaginary=True): UNIT}),
        (kept(Lt, sp.Symbol("i", infinite=True), 2), {sp.Symbol("i", infinite=True): UNIT}),
        (x < 2, {sp.Symbol("A", commutative=False): UNIT, x: UNIT}),
    ],
)
def test_a_box_that_is_none_is_refused(relation, box):
    with pytest.raises(ValueError, match=r"^prove: "):
        prove(relation, box)


POSITIVE, FURTHER = sp.symbols("p q", positive=True)
ROOT = sqrt(x**2)

UNDEFINED = {
    "1/0": 1 / ZERO,
    "log 0": log(ZERO),
    "cot 0": kept(cot, ZERO),
    "tan pi/2": kept(tan, pi / 2 + ZERO),
    "atan j": atan(I * (1 + ZERO)),
    "sin 0/0": sin(ZERO) / ZERO,
    "0/0": kept(Mul, 0, 1 / ZERO),
    "1/(1/0)": kept(Pow, 1 / ZERO, -1),
    "(1/0)^0": kept(Pow, 1 / ZERO, 0),
    "0^-x^2": ZERO ** (-(x**2)),
    "acosh 1/0": acosh(1 / ZERO),
    "acosh log 0": acosh(log(ZERO)),
    "|1/0|": Abs(1 / ZERO),
    "im 1/0": kept(im, 1 / ZERO),
    "im log 0": kept(im, log(ZERO)),
    "im 1/(x - x)": kept(im, 1 / cancelled(x)),
    "f(1/0)": f(1 / ZERO),
    "1/(f - f)": 1 / cancelled(f(x)),
    "1/(f(x) - f(x + 0))": 1 / (f(x) - f(x + ZERO)),
    "gamma 0": sp.gamma(ZERO),
    "Max(1/0, 0)": kept(sp.Max, 1 / ZERO, 0),
    # zeros that the normal form does not see
    "4^x = 2^(2 x)": 1 / (kept(Pow, 4, x) - kept(Pow, 2, 2 * x)),
    "log 4 = 2 log 2": 1 / (kept(log, 4) - 2 * log(2)),
    "e^(x log 2) = 2^x": 1 / (kept(exp, x * log(2)) - kept(Pow, 2, x)),
    "sqrt x^4 = x^2": 1 / (sqrt(x**4) - x**2),
    "sqrt p sqrt q = sqrt(p q)": 1
    / (kept(Pow, POSITIVE, S.Half) * sqrt(FURTHER) - kept(Pow, POSITIVE * FURTHER, S.Half)),
    "|x|^2 = x^2": 1 / ((ROOT - x) * (ROOT + x)),
    "|x| = x or -x": 1 / (ROOT - x) + 1 / (ROOT + x),
    "the inverse of both": 1 / (1 + 1 / (ROOT - x)) + 1 / (1 + 1 / (ROOT + x)),
    "1/0 for all that it may be": x / sp.Symbol("o", zero=True),
    # no numbers
    "oo": oo * x,
    "zoo": sp.zoo,
    "nan": sp.nan,
    "float": x + sp.Float("0.1"),
    "a derivative": sp.Derivative(log(ZERO), x),
    "noncommutative": sp.Symbol("A", commutative=False) / ZERO,
}


@pytest.mark.parametrize("name", UNDEFINED)
def test_what_is_nowhere_defined_is_neither_equal_nor_unequal(name):
    of = UNDEFINED[name]
    for left, right in (
        (of, of),
        (kept(Add, of, of), kept(Mul, 2, of)),
        (of, kept(Add, of, 1)),
        (of, 3),
        (x, of),
        ([x, of], [x, of]),
        ([x, of], [x]),
        (sp.Matrix([x, of]), sp.Matrix([[x, of]])),
        (Eq(y, of, evaluate=False), Eq(y, of, evaluate=False)),
        (Eq(y, of, evaluate=False), Eq(y, 3)),
        (Eq(of, y, evaluate=False), Eq(y, of, evaluate=False)),
        (below(of), below(of)),
        (below(of), kept(sp.Gt, of, 1)),
        (below(of), x),
    ):
        verdict = prove(left, right, steps=300_000)
        assert verdict.kind == Kind.UNDECIDED, (left, right)
        assert verdict.method


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ([1 / (ROOT - x), 1 / (ROOT + x)], [1 / (ROOT - x), 1 / (ROOT + x)]),  # never both
        ([sqrt(x - 1) / x, log(1 / (x - x**2)), x], [sqrt(x - 1) / x, log(1 / ZERO), x]),
        (below(sqrt(-1 - x**2)), below(2 * sqrt(-1 - x**2), 2)),  # no order
        (below(I * x), below(2 * I * x, 2)),
        (below(x, I), below(2 * x, 2 * I)),
        (below(sp.Symbol("q", imaginary=True)), below(2 * sp.Symbol("q", imaginary=True), 2)),
        (log(x * y), log(x) + log(y)),
        (sqrt(z**2), z),
        (atan(x) + atan(1 / x), pi / 2),
        (sp.acos(cos(x)), x),
        (log(exp(I * x)), I * x),
        ((x**2) ** y, x ** (2 * y)),
        ((x * y) ** THIRD, x**THIRD * y**THIRD),
        (exp(x) ** y, exp(x * y)),
        (sqrt(x**2), sp.Symbol("x", negative=True)),
        (conjugate(sp.Symbol("q", imaginary=True)), sp.Symbol("q", imaginary=True)),
        (conjugate(z), z),  # complex in the notation
        (re(z), z),
        (Abs(x), x),
        (kept(Pow, 0, x), 0),
        (kept(Pow, x, ZERO), 2),
        (x**1_000_000_000, x**1_000_000_001),
        (sp.Float("0.1") + sp.Float("0.2"), sp.Float("0.3")),
        (sp.Max(x, y), x),
        (sp.Piecewise((x, x > 0), (0, True)), x),
        (sp.Dummy("x"), sp.Dummy("x")),
        (Eq(x, oo), Eq(x, -oo)),
        (Eq(x, 1), True),
        (x, x + Rational(1, 10**2000)),
    ],
)
def test_what_is_false_or_without_a_value_is_not_proved(left, right):
    assert not prove(left, right, steps=300_000)


NO_NUMBER = {
    "0/0": kept(Mul, 0, 1 / NUMBER),
    "1/0 - 1/0": cancelled(1 / NUMBER),
    "log 0 - log 0": cancelled(log(NUMBER)),
    "exp log 0": kept(exp, log(NUMBER)),
    "im 1/0": kept(im, 1 / NUMBER),
    "im log 0": kept(im, log(NUMBER)),
    "re j log 0": kept(re, I * log(NUMBER)),
    "|1/0| - |1/0|": cancelled(Abs(1 / NUMBER)),
    "conjugate": cancelled(kept(conjugate, 1 / NUMBER)),
    "(1/0)^0": kept(Pow, 1 / NUMBER, 0),
    "(1/0)^(1 - 1)": kept(Pow, 1 / NUMBER, cancelled(S.One)),
    "0^0": NUMBER**NUMBER,
    "tan pi/2": kept(Mul, 0, kept(tan, pi / 2 + NUMBER)),
    "cot 0": cancelled(kept(cot, NUMBER)),
    "atan j": cancelled(atan(I * (1 + NUMBER))),
    "acosh 1/0": cancelled(acosh(1 / NUMBER)),
    "atanh 1": cancelled(sp.atanh(1 + NUMBER)),
    "1/(sqrt 2 sqrt 3 - sqrt 6)": kept(
        Mul,
        0,
        1 / (kept(Pow, 2, S.Half) * kept(Pow, 3, S.Half) - kept(Pow, 6, S.Half) + NUMBER),
    ),
    "1/(log 4 - 2 log 2)": kept(Mul, 0, 1 / (kept(log, 4) - 2 * log(2))),
    "oo - oo": kept(Add, oo, -oo),
    "0 oo": kept(Mul, 0, oo),
    "Max": kept(sp.Max, 1 / NUMBER, 0),
    "gamma 0": kept(sp.gamma, NUMBER),
}


@pytest.mark.parametrize("name", NO_NUMBER)
def test_what_is_no_number_is_not_enclosed(name):
    with pytest.raises(ValueError, match=r"^enclose: expr: "):
        enclose(NO_NUMBER[name])


NO_MAXIMUM = {
    "1/x - 1/x": (cancelled(1 / x), {x: AROUND}),
    "1/x - 1/x, two symbols": (kept(Add, 1 / x, -1 / REAL), {x: AROUND}),
    "log x - log x": (cancelled(log(x)), {x: UNIT}),
    "im 1/x": (kept(im, 1 / x), {x: AROUND}),
    "im log x": (kept(im, log(x)), {x: AROUND}),
    "0/x": (kept(Mul, 0, 1 / x), {x: AROUND}),
    "x/x": (kept(Mul, x, 1 / x), {x: AROUND}),
    "(1/x)^y": (kept(Pow, 1 / x, y), {x: AROUND, y: POINT}),
    "-1/x^2": (-1 / x**2, {x: AROUND}),
    "-|log x|": (-Abs(log(x)), {x: UNIT}),
    "exp -1/x^2": (exp(-1 / x**2), {x: AROUND}),
    "atan 1/x": (atan(1 / x), {x: AROUND}),
    "sqrt x": (sqrt(x), {x: AROUND}),
    "j x": (I * x, {x: UNIT}),
    "f(x)": (f(x), {x: UNIT}),
    "Max": (sp.Max(x, -x), {x: AROUND}),
    "oo": (kept(Add, oo, x), {x: UNIT}),
    "no point": (x, {x: (1, 0)}),
    "no end": (x, {x: (0, oo)}),
}


@pytest.mark.parametrize("name", NO_MAXIMUM)
def test_what_is_not_defined_everywhere_has_no_largest_value(name):
    expr, box = NO_MAXIMUM[name]
    with pytest.raises(ValueError, match=r"^enclose_maximum: "):
        enclose_maximum(expr, box, digits=2, steps=200_000)


def positive(expr, ends=AROUND, cuts=".", **more):
    return Positive(expr, {x: ends}, cuts, 96, **more)


FORGED = {
    "im 1/x": positive(1 - kept(im, 1 / x)),
    "im log x": positive(4 - kept(im, log(x))),
    "0/x": positive(kept(Add, 1, kept(Mul, 0, 1 / x))),
    "1/x - 1/x": positive(kept(Add, 1, 1 / x, -1 / x)),
    "a side": positive(S.One, defined=(kept(im, 1 / x),)),
    "(1/x)^y": Positive(2 - kept(Pow, 1 / x, y), {x: AROUND, y: POINT}, ".", 96),
    "no piece": positive(x + 2, cuts=""),
    "a piece too many": positive(x + 2, cuts=".."),
    "a cut across no symbol": positive(x + 2, cuts="1.."),
    "half a box": positive(x + 2, cuts="0."),
    "slopes of |x|": positive(Abs(x) + 1, cuts=":"),
    "slopes of 1/x": positive(kept(Add, 1, kept(Mul, x, 1 / x)), cuts=":"),
    "slopes across a jump": positive(sqrt(x**2) / x + S.Half, (-Rational(1, 10**20), 1), ":"),
    "a reversed box": positive(x - 2, (1, 0)),
    "no number given": positive(y, given=Known({y: arb("nan")})),
    "infinity given": positive(y, given=Known({y: arb("inf")})),
    "tan": Zero(tan(x), x, (S.One, S(2)), arb("1.57 +/- 0.1"), 96),
    "1/x": Zero(1 / x, x, (-S.One, S.One), arb("0 +/- 0.5"), 96),
    "atan 1/x": Zero(atan(1 / x), x, (-S.One, S.One), arb("0 +/- 0.5"), 96),
    "|x|/x": Zero(sqrt(x**2) / x, x, (-S.One, S.One), arb("0 +/- 0.5"), 96),
    "a zero of im log x": Zero(kept(im, log(x)) - 1, x, (-S.One, S.One), arb("0 +/- 0.5"), 96),
    "x^3": Zero(x**3, x, (-S.One, S.One), arb("0 +/- 0.5"), 96),  # the slope vanishes
    "x beyond": Zero(x, x, (S.One, S(2)), arb("0 +/- 0.5"), 96),
    "a maximum of im 1/x": Largest(
        kept(im, 1 / x), positive(1 - kept(im, 1 / x)), {x: S.One}, S.Zero, S.One
    ),
    "a maximum of 1/x - 1/x": Largest(cancelled(1 / x), positive(S.One), {x: S.One}, S.Zero, S.One),
    "a maximum outside": Largest(x, positive(2 - x), {x: S(2)}, S(2), S(2)),
    "a maximum not reached": Largest(x, positive(2 - x), {x: S.One}, S(2), S(2)),
}


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_certificate_is_not_confirmed(name):
    assert not recheck(FORGED[name])


@pytest.mark.parametrize(
    ("relation", "box"),
    [
        (below(cancelled(1 / x)), {x: (1, 2)}),
        (below(cancelled(log(x))), {x: (THIRD, 1)}),
        (below(kept(Add, 1 / x, -1 / REAL)), {x: (1, 2)}),
        (below(kept(im, 1 / x)), {x: (1, 2)}),
        (below(sin(x) / x, 2), {x: (THIRD, 1)}),
        (below(sp.acos(x), 2), {x: (0, S.Half)}),
    ],
)
def test_where_both_sides_are_defined_the_same_is_enclosed(relation, box):
    verdict = prove(relation, box)
    assert verdict.kind == Kind.ENCLOSED
    assert recheck(verdict.certificate)


def test_a_list_is_refuted_where_all_of_it_is_defined():
    nothing = 1 / ZERO
    assert prove([y, nothing], [y + 1, nothing]).kind == Kind.UNDECIDED
    assert prove([y, Lt(I + x, 1, evaluate=False)], [y + 1, x]).kind == Kind.UNDECIDED
    point = prove([y, log(x)], [y + 1, log(x)]).counterexample
    assert set(point) == {"x", "y"}
    assert sp.sympify(point["x"]) != 0


def test_what_takes_sympy_long_or_breaks_it_is_answered():
    """29 s, and an AttributeError, in SymPy 1.14."""
    begin = time.perf_counter()
    for left, right in (
        (sp.acos(x), sqrt(sp.acos(x) ** 2)),
        (Eq(sp.acos(x), y), sp.Ne(sqrt(sp.acos(x) ** 2), y)),
        (sp.arg(acosh(z)), sp.arg(exp(acosh(z)))),
        (sp.arg(exp(acosh(z))), acosh(z)),
        (log(exp(acosh(x))), acosh(x)),
    ):
        assert not prove(left, right)
    assert prove(sp.acos(x), sqrt(sp.acos(x) ** 2) + 1).kind == Kind.REFUTED
    assert time.perf_counter() - begin < 60


@pytest.mark.parametrize(
    ("number", "real", "imaginary"),
    [
        # mpmath 1.3 at 30 digits
        (sp.acos(2), "0", "1.31695789692481670862504634731"),
        (sp.asin(2), "1.57079632679489661923132169164", "-1.31695789692481670862504634731"),
        (acosh(-2), "1.31695789692481670862504634731", "3.14159265358979323846264338328"),
        (sp.atanh(2), "0.549306144334054845697622618461", "-1.57079632679489661923132169164"),
        (sp.asinh(2 * I), "1.31695789692481670862504634731", "1.57079632679489661923132169164"),
    ],
)
def test_on_a_cut_an_inverse_function_has_the_value_that_mpmath_gives_it(number, real, imaginary):
    found = sp.im(number, evaluate=False), re(number, evaluate=False)
    for part, text in zip(found, (imaginary, real), strict=True):
        with ctx.workprec(100):
            assert abs(program(part, [])().real - arb(text)) < arb(10) ** -28


def test_what_is_defined_somewhere_is_still_proved():
    assert prove(1 / x - 1 / x**2, (x - 1) / x**2)
    assert prove(acosh(x) + acosh(x), 2 * acosh(x))
    assert prove(cot(x), cos(x) / sin(x))
    assert prove(f(x) + f(1 / x), f(1 / x) + f(x))
    assert prove(kept(im, 1 / x), kept(im, 1 / x))
    assert prove([1 / ROOT, log(x)], [1 / ROOT, log(x)])

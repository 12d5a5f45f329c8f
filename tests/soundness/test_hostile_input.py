"""Text is never run, nonsense is refused in a line, and no question takes for ever."""

import time

import mpmath
import numpy
import pytest
import sympy as sp
from flint import arb
from sympy import And, I, Lambda, Piecewise, Rational, cos, exp, pi, sin, sqrt

import symhaptic
from symhaptic import enclose, enclose_maximum, prove, recheck
from symhaptic.proof.certificate import Positive, Zero
from symhaptic.proof.verdict import Kind

x, y = sp.symbols("x y")
PROGRAM = "[print('EVALUATED'), pi][1]"


@pytest.mark.parametrize(
    "ask",
    [
        lambda text: enclose(text),
        lambda text: enclose([text]),
        lambda text: enclose_maximum(text, {x: (0, 1)}),
        lambda text: enclose_maximum(x, {x: (0, text)}),
        lambda text: enclose_maximum(x, {x: text}),
        lambda text: prove(text, x),
        lambda text: prove(x, text),
        lambda text: prove([x, text], [x, x]),
        lambda text: prove((x, [[text]]), (x, x)),
        lambda text: prove(text, {x: (0, 1)}),
        lambda text: prove(x > 0, {x: (text, 1)}),
        lambda text: prove(x > 0, {x: (0, text)}),
        lambda text: prove(x > 0, {text: (0, 1)}),
        lambda text: prove(x > 0, text),
        lambda text: prove(x, x, steps=text),
    ],
)
@pytest.mark.parametrize("text", [PROGRAM, "x", "1", b"1"])
def test_text_is_never_run(ask, text, capsys):
    with pytest.raises((TypeError, ValueError)) as caught:
        ask(text)
    assert capsys.readouterr().out == ""
    assert "\n" not in str(caught.value)
    if isinstance(text, str) and "enclose" not in str(caught.value):
        assert caught.type is TypeError


CYCLE: list = []
CYCLE.append(CYCLE)
SELF = {1: 2}


@pytest.mark.parametrize(
    "nonsense",
    [
        None,
        object(),
        {x},
        Lambda(x, x),
        And(x > 0, y > 0),
        sp.Interval(0, 1),
        sp.FiniteSet(1),
        CYCLE,
        [None],
        sp.Matrix,
        sin,
        range,
        lambda: x,
        sp.Eq(sp.Matrix([1]), sp.Matrix([[1, 2]]), evaluate=False),
        sp.Dict({x: 1}),
        numpy.array([1, 2]),
    ],
    ids=lambda nonsense: type(nonsense).__name__,
)
def test_what_is_no_formula_is_refused_in_a_line(nonsense):
    for ask in (
        lambda: prove(nonsense, x),
        lambda: prove(x, nonsense),
        lambda: prove(nonsense, nonsense),
        lambda: prove([x, nonsense], [x, x]),
        lambda: prove(nonsense, {x: (0, 1)}),
        lambda: enclose(nonsense),
        lambda: enclose_maximum(nonsense, {x: (0, 1)}),
    ):
        with pytest.raises((TypeError, ValueError)) as caught:
            ask()
        assert "\n" not in str(caught.value)
        assert str(caught.value).startswith(("prove: ", "enclose: ", "enclose_maximum: "))


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (0**x, x),
        (0**x, 0**x + 1),
        (sp.zoo, x),
        (sp.nan, sp.nan),
        (sp.oo, sp.oo),
        (x + sp.oo, x),
        (Piecewise((x, x > 0), (0, True)), x),
        (sp.Integral(x, (x, 0, y)), y**2 / 2),
        (sp.Derivative(sp.Function("f")(x), x), 1),
        (sp.Sum(x, (x, 0, y)), y),
        (sp.Subs(x, x, y), y),
        (Lambda(x, x)(y) + sp.Order(x), y),
        (sp.Max(x, y), x),
        (sp.floor(x), x),
        (sp.Heaviside(x), 1),
        (sp.factorial(x), sp.gamma(x + 1)),
        (cos(pi / 1009) + cos(pi / 1013), cos(pi / 1013) * 2),
        (exp(I * pi / 10**9), x),
        ((x + y + 1) ** 5000, (x + y) ** 5000),
        ((x + y) ** 400_000, x),
        (sp.Pow(sp.Pow(2 * x, 10**6, evaluate=False), 10**6, evaluate=False), x),
        (1 / (x ** (10**8) - 1) + 1 / (x ** (10**8 + 1) - 1), x),
        (sin(x) ** 20_000, x),
        ((1 + sqrt(2) * x) ** 10_000, x),
        ((cos(pi / 9973) + x) ** 50, x),
        (x ** (10**12), y),
        (x ** Rational(10**9 + 1, 2), y),
        (x ** Rational(1, 10**9), y),
        (x**x**x**x, y),
        (sum(sqrt(x + k) for k in range(25)) ** 9, y),
        (sp.prod(x - cos(2 * pi * k / 97) for k in range(97)), x + 1),
        ([], []),
        ([[]], [[]]),
        (sp.zeros(0, 3), sp.zeros(3, 0)),
        ([], x),
        (True, x > 0),
        (x, x > 0),
        (1.5, x),
        (sp.Symbol("i", infinite=True) + 1, sp.Symbol("i", infinite=True)),
        (x / sp.Symbol("o", zero=True), 2 * x / sp.Symbol("o", zero=True)),
        (1j, I),
    ],
    ids=lambda form: type(form).__name__,
)
def test_every_question_has_an_answer(left, right):
    assert prove(left, right, steps=300_000).kind in (Kind.REFUTED, Kind.UNDECIDED)


def test_what_is_nested_too_deeply_is_undecided():
    deep = x
    for _ in range(3000):
        deep = sp.sin(deep, evaluate=False)
    assert prove(deep, x).kind == Kind.UNDECIDED
    assert prove(sp.Lt(deep, 2, evaluate=False), {x: (0, 1)}).kind == Kind.UNDECIDED


ZERO = sp.Add(0, 0, evaluate=False)
BELOW = [
    sp.cot(0, evaluate=False),
    sp.Pow(sp.sin(ZERO, evaluate=False), Rational(-1, 2), evaluate=False),
    1 / sp.Add(2 + I, sp.Pow(0, -1, evaluate=False), evaluate=False),
]
"""Numbers that divide by zero; SymPy finds out, or we, as soon as something is asked of them."""


@pytest.mark.parametrize("number", BELOW)
def test_a_number_that_divides_by_zero_is_told_in_a_line(number):
    assert not prove(number, number + 1)
    assert not prove(sp.Lt(number * x, 7, evaluate=False), {x: (0, 1)}, steps=10_000)
    with pytest.raises(ValueError, match=r"^enclose: expr: "):
        enclose(number)
    with pytest.raises(ValueError, match=r"^enclose_maximum: expr: "):
        enclose_maximum(number + x, {x: (0, 1)}, digits=2, steps=10_000)
    with pytest.raises(ValueError, match=r"^prove: box: .* is not allowed"):
        prove(x > -1, {x: (0, number)})
    for claim in (
        Positive(number * x + 1, {x: (0, 1)}, ".", 96),
        Zero(x, x, (-1, number), arb(0), 96),
    ):
        assert not recheck(claim)


def test_a_certificate_that_is_nested_too_deeply_shows_nothing():
    deep = x
    for _ in range(3000):
        deep = sp.sin(deep, evaluate=False)
    assert not recheck(Positive(deep, {x: (0, 1)}, ".", 96))


@pytest.mark.parametrize("function", [sin, cos, sp.tanh])
def test_what_is_nested_is_not_counted_out(function):
    # as exponentials it has 2**40 terms
    nested = x
    for _ in range(40):
        nested = function(nested, evaluate=False)
    assert prove(nested, 2).kind is Kind.REFUTED
    assert prove(nested, nested).kind is not Kind.REFUTED


def test_a_number_that_is_nested_costs_what_it_is_made_of():
    # SymPy asks each of 2^12 arcs for its decimals, and those in it once more
    nested = x
    for shift in range(12):
        arcs = (sp.atan(nested + s, evaluate=False) for s in (shift, -shift - 1))
        nested = sp.Add(*arcs, evaluate=False)
    assert prove(nested, nested + 1, steps=100_000).kind is Kind.UNDECIDED
    assert prove(sp.atan(sp.atan(x)), sp.atan(x), steps=100_000).kind is Kind.REFUTED


def test_what_is_too_long_to_be_read_is_told_at_once():
    # 2^24 arcs in 100 lines; each question of SymPy's walks through all of them
    nested = x
    for shift in range(24):
        arcs = (sp.atan(nested + s, evaluate=False) for s in (shift, -shift - 1))
        nested = sp.Add(*arcs, evaluate=False)
    begin = time.perf_counter()
    for verdict in (
        prove(nested, nested + 1),
        prove([x, nested], [x, nested]),
        prove(sp.Lt(nested, 7, evaluate=False), {x: (0, 1)}),
    ):
        assert verdict.kind is Kind.UNDECIDED
    with pytest.raises(ValueError, match=r"^enclose_maximum: expr: more than \d+ steps$"):
        enclose_maximum(nested, {x: (0, 1)}, digits=2)
    assert time.perf_counter() - begin < 60


def test_a_precision_that_reaches_the_digits_is_tried():
    # at 106 bits it may be anything, 0 too, of which the normal form knows nothing
    with mpmath.workdps(80):
        right = mpmath.nstr(mpmath.sin(mpmath.exp(100)), 20)
    assert enclose(sin(exp(sp.Integer(100)))).str(20, radius=False) == right


def test_no_number_is_written_out_that_no_memory_holds():
    # at x = 1 and x = -1 the tower is x; at x = 2 it has 2**40 bits
    tower = x
    for _ in range(40):
        tower = tower**x
    assert prove(tower, x).kind in (Kind.REFUTED, Kind.UNDECIDED)


@pytest.mark.parametrize(
    "expr", [sp.oo, sp.zoo, sp.nan, sp.gamma(pi), sp.EulerGamma, 1 / sp.Function("f")(1), sp.log(0)]
)
def test_what_has_no_ball_is_named(expr):
    with pytest.raises(ValueError, match=r"^enclose: expr: "):
        enclose(expr)
    with pytest.raises(ValueError, match=r"^enclose_maximum: expr: "):
        enclose_maximum(expr + x, {x: (0, 1)}, digits=2)


@pytest.mark.parametrize(("expr", "ends"), [(1 / x, (0, 1)), (sp.tan(x), (0, 2))])
def test_what_has_no_largest_value_is_named(expr, ends):
    with pytest.raises(ValueError, match=r"^enclose_maximum: expr: "):
        enclose_maximum(expr, {x: ends}, digits=2)


def test_a_prime_number_of_parts_of_a_turn_is_no_work():
    # a regular polygon with 1009 corners; sin 2a = 2 sin a cos a, and Pythagoras
    assert prove(cos(pi / 1009) ** 2 + sin(pi / 1009) ** 2, 1, steps=100_000)
    assert prove(2 * cos(pi / 1009) * sin(pi / 1009), sin(2 * pi / 1009), steps=100_000)
    assert prove(cos(pi / 1009), 1).kind == Kind.REFUTED
    assert enclose(cos(pi / 1009) ** 2 + sin(pi / 1009) ** 2 - 1) == 0


def test_steps_are_a_budget():
    few = prove(sin(2 * x), 2 * sin(x) * cos(x), steps=1)
    assert few.kind == Kind.UNDECIDED
    assert "more than 1 steps" in few.method
    assert prove(sin(2 * x), 2 * sin(x) * cos(x), steps=1000)
    wide = prove(sin(x) < x - x**3 / 8, {x: (1, 2)}, steps=20)
    assert wide.kind == Kind.UNDECIDED
    for wrong, error in ((0, ValueError), (-1, ValueError), (1.5, TypeError), (True, TypeError)):
        with pytest.raises(error, match="prove: steps:"):
            prove(x, x, steps=wrong)


def test_a_constant_that_the_other_routine_sees_elsewhere_is_not_enclosed(monkeypatch):
    from flint import acb

    monkeypatch.setattr(symhaptic.proof.enclose, "program", lambda expr, at: lambda: acb(4))
    with pytest.raises(ValueError, match="not confirmed"):
        enclose(pi)
    with pytest.raises(ValueError, match="not confirmed"):
        enclose(sin(1) ** 2 + cos(1) ** 2 - 1)


class Rationally(sp.Expr):
    """Says of itself that it is 1."""

    is_Rational = is_commutative = True  # noqa: N815
    p = q = 1


class Alike(sp.Function):
    """Says of itself that it is equal to everything."""

    def __eq__(self, other):
        return True

    def __hash__(self):
        return hash(x)


class Named(sp.Symbol):
    """Another symbol of the same name."""


@pytest.mark.parametrize(
    "own", [Rationally(x), Alike(x), Named("x"), sin(Rationally(x), evaluate=False) + y]
)
def test_a_class_of_a_users_own_may_not_speak_for_itself(own):
    for ask in (
        lambda: prove(own, 1),
        lambda: prove(x, own),
        lambda: prove([own], [x]),
        lambda: prove(sp.Gt(own, 0, evaluate=False), {x: (1, 2), y: (1, 2)}),
        lambda: prove(x > 0, {own: (1, 2), x: (1, 2)}),
        lambda: enclose(own),
        lambda: enclose_maximum(own, {x: (1, 2), y: (1, 2)}),
    ):
        with pytest.raises(TypeError, match=r"^(prove|enclose|enclose_maximum): .*class|no symbol"):
            ask()


@pytest.mark.parametrize("none", [sp.nan, sp.zoo, sp.oo, -sp.oo, sp.AccumBounds(0, 1)])
def test_a_function_of_what_is_no_number_is_nothing(none):
    value = sp.Function("f")(none)
    assert prove(2 * value, sp.Add(value, value, evaluate=False)).kind == Kind.UNDECIDED
    assert prove(value, value).kind == Kind.UNDECIDED


def test_what_python_cannot_print_is_refused_in_a_line():
    long = sp.Integer(10) ** 5000
    for ask in (
        lambda: prove(x, long),
        lambda: prove(x > 0, {x: (0, long)}),
        lambda: enclose(sp.tan(long)),
        lambda: enclose_maximum(x / long, {x: (0, 1)}),
    ):
        with pytest.raises(ValueError, match="give at most 4300 digits"):
            ask()


def test_an_interval_is_no_number():
    from mpmath import iv

    for ask in (lambda: prove(iv.mpf([1, 2]), 1), lambda: prove(x > 0, {x: (iv.mpf([1, 2]), 3)})):
        with pytest.raises(TypeError, match="is no number"):
            ask()


@pytest.mark.parametrize("base", [2, x])
def test_a_logarithm_to_a_base_is_not_taken_for_another(base):
    written = sp.log(x, base, evaluate=False)
    assert not prove(written, sp.log(x))
    assert not prove(sp.Gt(written, 0, evaluate=False), {x: (2, 3)})
    with pytest.raises(ValueError, match="no program for log"):
        enclose_maximum(written, {x: (2, 3)})


def test_what_is_nested_too_deeply_has_no_largest_value():
    deep = x
    for _ in range(3000):
        deep = sp.sin(deep, evaluate=False)
    with pytest.raises(ValueError, match="nested too deeply"):
        enclose_maximum(deep, {x: (0, 1)})


@pytest.mark.parametrize("expr", [1 / (x - Rational(1, 3)), -1 / (x - Rational(1, 3)) ** 2])
def test_next_to_a_pole_no_largest_value_is_looked_for_long(expr):
    with pytest.raises(ValueError, match=r"next to x = 0\.333333"):
        enclose_maximum(expr, {x: (0, 1)}, steps=30_000)


def test_a_largest_value_has_a_budget_too():
    with pytest.raises(ValueError, match="too much work"):
        enclose_maximum(-((x - y) ** 2), {x: (0, 1), y: (0, 1)}, digits=15, steps=10_000)
    with pytest.raises(ValueError, match="enclose_maximum: steps"):
        enclose_maximum(x, {x: (0, 1)}, steps=0)
    with pytest.raises(ValueError, match="next to x = 1"):
        enclose_maximum(10**50 * x, {x: (0, 1)}, steps=30_000)


@pytest.mark.parametrize("at", [sqrt(2), pi, sp.S.Half])
def test_a_box_may_be_one_point(at):
    found = enclose_maximum(x**2, {x: (at, at)})
    assert found.where == {x: at}
    assert float(found.lower) <= float(at) ** 2 <= float(found.upper)
    assert symhaptic.recheck(found)

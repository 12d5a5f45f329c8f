"""Questions on boxes and constants: right, wrong, or an honest undecided; bad input is named."""

import re
import subprocess
import sys

import mpmath
import pytest
import sympy as sp
from flint import arb
from sympy import Eq, Rational, S, cos, exp, pi, sin, sqrt

import symhaptic
from symhaptic import enclose, enclose_maximum, prove, recheck

x, y = sp.symbols("x y")
HALF = Rational(1, 2)


@pytest.mark.parametrize(
    "relation",
    [
        sin(x) < x,  # textbook: for x > 0
        x > sin(x),
        cos(x) > 1 - x**2 / 2,
        exp(x) >= 1 + x,
        2 * x / pi - Rational(1, 100) <= sin(x),  # Jordan's inequality
    ],
)
def test_textbook_inequality_holds(relation):
    verdict = prove(relation, {x: (Rational(1, 10), Rational(3, 2))})
    assert verdict
    assert verdict.kind == "enclosed"
    assert recheck(verdict.certificate)


@pytest.mark.parametrize(
    "relation", [sin(x) > x, exp(x) <= 1 + x, cos(x) > 1 - x**2 / 3, sin(x) < x * Rational(9, 10)]
)
def test_mutants_are_refuted_at_a_point(relation):
    verdict = prove(relation, {x: (Rational(1, 10), Rational(3, 2))})
    assert not verdict
    assert verdict.kind == "refuted"
    at = Rational(verdict.counterexample["x"])
    assert Rational(1, 10) <= at <= Rational(3, 2)
    with mpmath.workdps(40):  # the point is looked at by other means
        sides = [sp.lambdify(x, s, "mpmath")(mpmath.mpf(at.p) / at.q) for s in relation.args]
    assert not relation.func(*(sp.Float(str(s), 30) for s in sides))


def test_what_is_touched_is_undecided(monkeypatch):
    monkeypatch.setattr(symhaptic.proof.box, "_PIECES", 300)
    for relation in (x**2 >= 0, x**3 - x**3 * x >= 0):
        verdict = prove(relation, {x: (0, 1)})
        assert verdict.kind == "undecided"
        assert not verdict
    assert prove(x**2 > 0, {x: (-1, 1)}).kind == "refuted"  # zero in the middle


def test_a_complex_value_is_no_order():
    assert prove(sqrt(x) + 1 > 0, {x: (-2, -1)}).kind == "undecided"


@pytest.mark.parametrize("alone", [x < 1, Eq(x, y), x + 1])
def test_one_form_alone_is_no_question(alone):
    with pytest.raises(TypeError, match=f"^prove: {re.escape(repr(alone))} alone .* is one"):
        prove(alone)


def test_unknown_functions_are_undecided():
    assert prove(sp.Function("f")(x) > 0, {x: (0, 1)}).kind == "undecided"


@pytest.mark.parametrize(
    ("relation", "box", "error", "says"),
    [
        (x > 0, {x: (0.1, 1)}, ValueError, r"0\.1.* of x is not allowed"),
        (x > 0, {x: (2, 1)}, ValueError, "empty"),
        (x > 0, {x: (0, sp.oo)}, ValueError, "oo of x"),
        (x > 0, {x: 3}, ValueError, "no pair"),
        (x + y > 0, {x: (0, 1)}, ValueError, "no interval for y"),
        (x > 0, {"x": (0, 1)}, TypeError, "no symbol"),
        (Eq(x, 0), {x: (0, 1)}, TypeError, "no inequality"),
        (x, {x: (0, 1)}, TypeError, "no inequality"),
        (x < 1, (0, 1), TypeError, r"rhs: \(0, 1\) is no relation .* and no box; .* \{x: "),
        (x < 1, [(x, 0, 1)], TypeError, r"rhs: \[\(x, 0, 1\)\] is no relation"),
        (sp.Symbol("r", positive=True) > -1, {x: (0, 1)}, TypeError, "is True already.*evaluate"),
        (x > -0.1, {x: (0, 1)}, ValueError, r"0\.1.* is no exact number"),
    ],
)
def test_bad_input_is_named(relation, box, error, says):
    with pytest.raises(error, match=says):
        prove(relation, box)


# -- constants ------------------------------------------------------------------------------


@pytest.mark.parametrize("digits", [1, 20, 300])
@pytest.mark.parametrize("expr", [pi, exp(-40) * sin(3), sqrt(2) - Rational(7, 5), S(10) ** 40])
def test_ball_contains_the_value_and_is_narrow(expr, digits):
    ball = enclose(expr, digits)
    with mpmath.workdps(digits + 40):
        value = arb(mpmath.nstr(sp.lambdify((), expr, "mpmath")(), digits + 30))
    slack = abs(value) * arb(10) ** -(digits + 25)  # the text above is cut
    assert (ball + (-slack).union(slack)).contains(value.mid())
    assert ball.rad() <= abs(ball) * arb(10) ** -digits


def test_zero_is_recognised_and_never_guessed():
    assert enclose(sin(1) ** 2 + cos(1) ** 2 - 1) == 0
    nearly = sin(1) ** 2 + cos(1) ** 2 - 1 + S(10) ** -60
    assert enclose(nearly, 5).overlaps(arb("1e-60"))


def test_complex_constant():
    value = enclose(exp(sp.I), 25)
    assert abs(float(value.imag.mid()) - 0.8414709848078965) < 1e-16  # sin 1


@pytest.mark.parametrize(
    ("expr", "digits", "says"),
    [
        (x, 20, "no constant"),
        (sp.Float("0.1"), 20, "float"),
        (pi, 0, "digits: 0"),
        (pi, 2.5, "2.5"),
    ],
)
def test_bad_constant_is_named(expr, digits, says):
    with pytest.raises(ValueError, match=says):
        enclose(expr, digits)


def test_maximum_between_its_bounds():
    """x exp(-x) has its maximum 1/e at 1."""
    found = enclose_maximum(x * exp(-x), {x: (0, 5)}, digits=8)
    assert found.upper - found.lower <= Rational(1, 10**8)
    assert found.lower <= sp.exp(-1) <= found.upper
    assert recheck(found)
    with pytest.raises(ValueError, match="no interval for y"):
        enclose_maximum(x * y, {x: (0, 1)})


def test_a_failed_assertion_says_the_sentence_and_the_counterexample(pytest_of):
    """In pytest's own words, with its rewritten assertions."""
    out = pytest_of(
        "from sympy.abc import x\n"
        "from sympy import sin\n"
        "from symhaptic import prove\n"
        "def test_mine():\n"
        "    assert prove(sin(2*x), 2*sin(x))\n"
    )
    assert "assert <refuted: the two sides differ; counterexample x = 1>" in out


@pytest.fixture
def pytest_of(tmp_path):
    """Runs pytest on a file in a process, and returns what it prints."""

    def run(text):
        (tmp_path / "test_mine.py").write_text(text, encoding="utf-8")
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "test_mine.py"]
        found = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert found.returncode == 1
        return found.stdout

    return run

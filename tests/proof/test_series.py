"""Limits come from exact leading terms, and what cannot be expanded is refused."""

import mpmath
import pytest
import sympy as sp
from sympy import Abs, I, Rational, cos, cot, exp, log, pi, sin, sinh, sqrt, tan

from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.series import limit, lowest_term

x, d, a, y, z = sp.symbols("x d a y z")

# Leading terms of Taylor and Laurent series (Abramowitz and Stegun 4.3.65-70, 23.1.1).
LEADING = {
    "sine": (sin(x), 1, 1),
    "sine minus angle": (sin(x) - x, 3, -Rational(1, 6)),
    "one minus cosine": (1 - cos(x), 2, Rational(1, 2)),
    "tangent minus sine": (tan(x) - sin(x), 3, Rational(1, 2)),
    "cotangent": (cot(x), -1, 1),
    "cotangent, second term": (cot(x) - 1 / x, 1, -Rational(1, 3)),
    "cotangent, third term": (cot(x) - 1 / x + x / 3, 3, -Rational(1, 45)),
    "Bernoulli, first term": (1 / x - 1 / (exp(x) - 1), 0, Rational(1, 2)),
    "Bernoulli, second term": (1 / x - 1 / (exp(x) - 1) - Rational(1, 2), 1, -Rational(1, 12)),
    "Bernoulli, third term": (
        1 / x - 1 / (exp(x) - 1) - Rational(1, 2) + x / 12,
        3,
        Rational(1, 720),
    ),
    "order eight": (
        cos(x) - sum((-(x**2)) ** n / sp.factorial(2 * n) for n in range(4)),
        8,
        1 / sp.factorial(8),
    ),
    "a divisor that begins with x^4": (
        x**4 / (exp(x) - 1 - x - x**2 / 2 - x**3 / 6),
        0,
        24,
    ),
    "multiple angle": (sin(d * x) - d * sin(x), 3, (d - d**3) / 6),
    "hyperbolic": (sinh(x) - sin(x), 3, Rational(1, 3)),
    "exponential of j": (exp(I * x) - 1 - I * x, 2, -Rational(1, 2)),
    "symbolic factor": (a * x**2 / (1 + x), 2, a),
}


@pytest.mark.parametrize("name", LEADING)
def test_leading_term(name):
    expr, order, coefficient = LEADING[name]
    found = lowest_term(expr, x)
    assert found[0] == order
    assert sp.expand(found[1] - coefficient) == 0


@pytest.mark.parametrize(
    ("expr", "at", "value"),
    [
        (sin(d * x) / sin(x), 0, d),
        (sin((d + Rational(1, 2)) * x) / (2 * sin(x / 2)), 0, d + Rational(1, 2)),
        ((exp(-x) - 1 + x) / x**2, 0, Rational(1, 2)),
        (sin(x) / (pi - x), pi, 1),
        ((z - 1) / (z**2 - 1), 1, Rational(1, 2)),
        ((exp(x) - exp(a)) / (x - a), a, exp(a)),
        (x * cot(x), 0, 1),
    ],
)
def test_limit(expr, at, value):
    variable = z if expr.has(z) else x
    assert sp.expand(limit(expr, variable, sp.sympify(at)) - value) == 0


@pytest.mark.parametrize("expr", [sin(3 * x) / tan(2 * x), (exp(x) - cos(x)) / sinh(5 * x)])
def test_limit_is_approached_by_the_values(expr):
    with mpmath.workdps(40):
        near = sp.lambdify(x, expr, "mpmath")(mpmath.mpf(10) ** -15)
        # next term of the series is of order x = 1e-15, with a coefficient below 10
        assert abs(near - mpmath.mpf(limit(expr, x).p) / limit(expr, x).q) < mpmath.mpf("1e-14")


@pytest.mark.parametrize("expr", [1 / x, cos(x) / x**2, cot(x)])
def test_pole_has_no_limit(expr):
    with pytest.raises(Unsupported):
        limit(expr, x)


@pytest.mark.parametrize("expr", [sqrt(x), sqrt(1 + x) - 1, x**d, exp(1 / x), sin(1 / x)])
def test_what_has_no_exact_series_here_is_refused(expr):
    with pytest.raises(Unsupported):
        limit(expr, x)


def either_refused_or(expr, value):
    try:
        found = limit(expr, x)
    except Unsupported:
        return True
    return sp.simplify(found - value) == 0


@pytest.mark.parametrize(
    ("expr", "value"),
    [
        (Abs(x) + x, 0),
        ((Abs(x) + x) / (Abs(x) + 2 * x), Rational(2, 3)),  # from above
        (log(1 + x) + x, 0),
        (log(1 + x) / (log(1 + x) + x), Rational(1, 2)),
    ],
)
def test_function_of_the_small_variable_is_no_constant(expr, value):
    assert either_refused_or(expr, value)


@pytest.mark.parametrize(
    "zero",
    [
        exp(I * pi / 4) + exp(-I * pi / 4) - sqrt(2),  # 2 cos(pi/4) = sqrt(2)
        Abs(a) ** 2 - a**2,  # zero for real a, and symbols are real
        4**y - 2 ** (2 * y),
    ],
)
def test_coefficient_that_vanishes_unseen_is_not_taken_for_the_leading_one(zero):
    # zero + x over zero + 2x tends to 1/2
    assert either_refused_or((zero + x) / (zero + 2 * x), Rational(1, 2))

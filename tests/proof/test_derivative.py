"""The derivatives of searches are SymPy's."""

import pytest
import sympy as sp
from sympy import cos, exp, sin, sqrt, tan

from symhaptic import prove
from symhaptic.proof.derivative import derivative

x, y = sp.symbols("x y")


@pytest.mark.parametrize(
    "expr",
    [
        sp.S(3),
        y,
        x,
        (x + y) ** 3 / (x - y) ** 2,
        x**2 * sin(x * y) * cos(x) / tan(x / 7),
        exp(-x * y) * sqrt(1 + x**2),
        x**y + y**x,
        sp.log(x) * sp.atan(x * y),
        sp.Function("f")(x) * x,
    ],
)
def test_it_is_that_of_sympy(expr):
    assert derivative(expr, x) == sp.diff(expr, x)


def test_a_power_of_e_that_is_kept_as_one_has_its_slope():
    """It was an AttributeError, of SymPy's, in `prove` and `enclose_maximum`."""
    x = sp.Symbol("x")
    kept = sp.Pow(sp.E, 2 * x, evaluate=False)
    assert derivative(kept, x).subs(x, 0) == 2
    assert bool(prove(kept > 1 + 2 * x + x**2, {x: (sp.Rational(1, 100), 1)}))

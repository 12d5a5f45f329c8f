"""A program over balls contains what mpmath finds, which shares nothing with it."""

import mpmath
import pytest
import sympy as sp
from flint import acb, arb, ctx

from symhaptic.proof.ball import ball
from symhaptic.proof.program import Uncheckable, program

x, y = sp.symbols("x y")
FORMS = (
    *(f(x + sp.I * y) for f in (sp.exp, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh)),
    *(f(x - sp.I * y) for f in (sp.log, sp.atan, sp.Abs, sp.re, sp.im, sp.conjugate)),
    *(x**3 - y**-2, sp.sqrt(x + y), sp.sqrt(x - 7 * y), (x + y) ** sp.Rational(-3, 4), x**y),
    *(
        sp.pi * x + sp.E * y + sp.Rational(1, 3),
        sp.I * (x - y) / (x + 2 * y) + sp.exp(sp.I * x) ** 2,
    ),
    *(sp.exp(x * y) * sp.cos(x) / (1 + sp.exp(-x * y)) - x * y * (x * y - 1) ** 2, sp.S(7) / 9),
)
POINTS = (("0.3", "1.7"), ("2.25", "-0.6"), ("0.01", "0.02"))


@pytest.mark.parametrize("at", POINTS)
@pytest.mark.parametrize("form", FORMS)
def test_a_value_lies_in_its_ball(form, at):
    with mpmath.workdps(60):
        value = mpmath.mpc(sp.lambdify((x, y), form, "mpmath")(*map(mpmath.mpf, at)))
        parts = [mpmath.nstr(part, 45) for part in (value.real, value.imag)]
    with ctx.workprec(96):
        numbers = [acb(arb(number)) for number in at]
        for found in (
            program(form, [x, y])(*numbers),
            ball(form, {x: numbers[0], y: numbers[1]}, 96),
        ):
            for part, exact in zip((found.real, found.imag), parts, strict=True):
                assert part.overlaps(arb(exact))
                assert part.rad() < 1e-24


@pytest.mark.parametrize("form", FORMS)
def test_a_ball_of_all_values_contains_that_of_one(form):
    with ctx.workprec(96):
        wide = program(form, [x, y])(acb(arb("1", "0.125")), acb(arb("0.5", "0.0625")))
        inside = program(form, [x, y])(acb(arb("1.1")), acb(arb("0.45")))
        assert not wide.is_finite() or wide.contains(inside)


def test_what_has_no_ball_has_no_program():
    with pytest.raises(Uncheckable, match="no program for"):
        program(sp.gamma(x), [x])
    with pytest.raises(Uncheckable, match="no program for Symbol: y"):
        program(x + y, [x])

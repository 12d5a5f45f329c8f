r"""What the entire functions change by: their derivatives, entire functions again.

With both poles p + q = delta, p q = gamma, and divided differences of exp over repeated nodes,

.. math::
    n_1 = \exp[0,-p,-q],\qquad
    \partial_\gamma n_1 = -\exp[0,-p,-p,-q,-q],\qquad
    \partial_\delta n_1 = -\exp[-p,-p,-q,-q],

and those of n_0 = exp(-delta) n_1(gamma, -delta) by time reversal.  For real poles each of them is
positive.  ``SLOPES`` says which function is the derivative of which.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy import Expr, cos, exp, factorial, sin

from symhaptic.forms.angle_slopes import ChordSlope, Ripple, SpreadSlope
from symhaptic.forms.entire import (
    SLOPES,
    C,
    Chord,
    CosNext,
    Creep,
    Decay,
    Entire,
    Fade,
    Gap,
    Lag,
    S,
    Sinc,
    SinNext,
    Spread,
)
from symhaptic.forms.entire_device import (
    DenominatorAtMinusOne,
    NumeratorAtOne,
    NumeratorGap,
    PlantN0,
    PlantN1,
    PlantTrace,
    _complete,
    _motion,
)


def _slope_term(cls: Any, index: int, k: int, gamma: Expr, delta: Expr) -> Expr:
    """The term of degree k of a derivative by gamma (index 0), of degree 2, or by delta."""
    x = sp.symbols("x:2")
    return (
        cls.term(k + 2 - index, *x).diff(x[index]).subs(dict(zip(x, (gamma, delta), strict=True)))
    )


# -- of the device ------------------------------------------------------------------------


class Kick(Entire):
    """exp[-p, -q]: where a unit impulse has moved the device after a period."""

    nargs = 2
    meaning = "exp(-delta/2) S(w), w = delta^2/4 - gamma: displacement by a unit impulse"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta/2) S(w)."""
        return exp(-delta / 2) * _motion(gamma, delta)[1]

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The complete symmetric polynomial of degree k in both poles, over (k+1)!."""
        return _complete(k, gamma, -delta) / factorial(k + 1)


class Coast(Entire):
    """exp(-delta/2) (C(w) - delta/2 S(w)): the speed that a unit impulse has left."""

    nargs = 2
    meaning = "exp(-delta/2) (C(w) - delta/2 S(w)), w = delta^2/4 - gamma: speed by a unit impulse"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta/2) (C(w) - delta/2 S(w))."""
        even, odd = _motion(gamma, delta)
        return exp(-delta / 2) * (even - delta / 2 * odd)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """That of -da/d delta."""
        return -_slope_term(PlantTrace, 1, k, gamma, delta)


class Echo(Entire):
    """exp[-p, -p, -q, -q] = -d n_1/d delta: the answer to a unit impulse, convolved with itself."""

    nargs = 2
    meaning = "exp(-delta/2) (C(w) - S(w))/(2 w), w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta/2) (C(w) - S(w))/(2 w)."""
        even, odd = _motion(gamma, delta)
        return exp(-delta / 2) * (even - odd) / (delta**2 / 2 - 2 * gamma)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """That of -d n_1/d delta."""
        return -_slope_term(PlantN1, 1, k, gamma, delta)


class Ebb(Entire):
    """Echo - n_0 = d n_0/d delta."""

    nargs = 2
    meaning = "Echo - PlantN0, of gamma and delta: d n0/d delta"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """Echo - PlantN0."""
        return Echo.definition(gamma, delta) - PlantN0.definition(gamma, delta)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """That of d n_0/d delta."""
        return _slope_term(PlantN0, 1, k, gamma, delta)


class PlantN1Drop(Entire):
    """exp[0, -p, -p, -q, -q] = -d n_1/d gamma."""

    nargs = 2
    meaning = "(PlantN1 - (Kick + delta Echo)/2)/gamma: -d n1/d gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """(PlantN1 - (Kick + delta Echo)/2)/gamma."""
        own, echo = Kick.definition(gamma, delta), Echo.definition(gamma, delta)
        return (PlantN1.definition(gamma, delta) - (own + delta * echo) / 2) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """That of -d n_1/d gamma."""
        return -_slope_term(PlantN1, 0, k, gamma, delta)


class PlantN0Drop(Entire):
    """exp[-p - q, -p, -p, -q, -q] = -d n_0/d gamma."""

    nargs = 2
    meaning = "(PlantN0 - (Kick - delta Echo)/2)/gamma: -d n0/d gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """(PlantN0 - (Kick - delta Echo)/2)/gamma."""
        own, echo = Kick.definition(gamma, delta), Echo.definition(gamma, delta)
        return (PlantN0.definition(gamma, delta) - (own - delta * echo) / 2) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """That of -d n_0/d gamma."""
        return -_slope_term(PlantN0, 0, k, gamma, delta)


class NumeratorGapDrop(Entire):
    """exp[0, -p - q, -p, -p, -q, -q] = (PlantN1Drop - PlantN0Drop)/delta."""

    nargs = 2
    meaning = "((PlantN1 - PlantN0)/delta - Echo)/gamma: -d ((n1 - n0)/delta)/d gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """(NumeratorGap - Echo)/gamma."""
        return (NumeratorGap.definition(gamma, delta) - Echo.definition(gamma, delta)) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """That of -d NumeratorGap/d gamma."""
        return -_slope_term(NumeratorGap, 0, k, gamma, delta)


# -- of one variable ----------------------------------------------------------------------


class Bend(Entire):
    """(C(w) - S(w))/(2 w) = dS/dw."""

    nargs = 1
    meaning = "(C(w) - S(w))/(2 w)"

    @classmethod
    def definition(cls, w: Expr) -> Expr:
        """(cosh(sqrt w) - sinh(sqrt w)/sqrt w)/(2 w)."""
        if w.could_extract_minus_sign():
            root = sp.sqrt(-w)
            return (sin(root) / root - cos(root)) / (-2 * w)
        root = sp.sqrt(w)
        return (sp.cosh(root) - sp.sinh(root) / root) / (2 * w)

    @classmethod
    def term(cls, k: int, w: Expr) -> Expr:
        """(k+1) w^k/(2k+3)!."""
        return (k + 1) * w**k / factorial(2 * k + 3)


class Wane(Entire):
    """(2 - (x^2 + 2 x + 2) exp(-x))/x^3, by which Fade becomes less."""

    nargs = 1
    meaning = "(2 - (x^2 + 2 x + 2) exp(-x))/x^3"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """(2 - (x^2 + 2 x + 2) exp(-x))/x^3."""
        return (2 - (x**2 + 2 * x + 2) * exp(-x)) / x**3

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(-x)^k/(k! (k+3))."""
        return (-x) ** k / factorial(k) / (k + 3)


# -- which is the derivative of which -----------------------------------------------------


SLOPES |= {
    PlantN1: (lambda g, d: -PlantN1Drop(g, d), lambda g, d: -Echo(g, d)),
    PlantN0: (lambda g, d: -PlantN0Drop(g, d), lambda g, d: Ebb(g, d)),
    NumeratorAtOne: (
        lambda g, d: -PlantN1Drop(g, d) - PlantN0Drop(g, d),
        lambda g, d: -PlantN0(g, d),
    ),
    PlantTrace: (lambda g, d: -Kick(g, d), lambda g, d: -Coast(g, d)),
    DenominatorAtMinusOne: (lambda g, d: -Kick(g, d), lambda g, d: -Coast(g, d) - exp(-d)),
    Kick: (lambda g, d: -Echo(g, d), lambda g, d: g * PlantN0Drop(g, d) - PlantN0(g, d)),
    S: (lambda w: Bend(w),),
    Decay: (lambda x: -Fade(x),),
    Creep: (lambda x: -Lag(x),),
    Fade: (lambda x: -Wane(x),),
    Sinc: (lambda x: -2 * x * Bend(-(x**2)),),
    Spread: (
        lambda k, x: 4 * (SinNext(k, x) / x) ** 2 - 2 * Gap(x),
        lambda k, x: SpreadSlope(k, x),
    ),
    Chord: (
        lambda k, x: 2 * CosNext(k, x) * Gap(x) + 2 * (k + 1) * Sinc(x) * SinNext(k, x) / x,
        lambda k, x: ChordSlope(k, x),
    ),
}
"""The derivative by each argument.  C, SinNext and CosNext state their own."""

STABLE = frozenset((*SLOPES, C, CosNext, SinNext))
"""Functions whose derivatives are made of entire functions."""

NEW = (
    Kick, Coast, Echo, Ebb, PlantN1Drop, PlantN0Drop, NumeratorGapDrop, Bend, Wane, Ripple,
    SpreadSlope, ChordSlope,
)  # fmt: skip

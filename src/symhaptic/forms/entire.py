r"""Entire functions of which the loop's formulas are made when nothing in them is 0/0.

Each one has a closed form, its ``definition``, which loses its digits or is 0/0 somewhere, though
the function is defined everywhere.  Differences that would cancel are inside the functions, so that
formulas made of them keep their digits.

With :math:`w=\delta^2/4-\gamma` and both poles p, q of the device, where p + q = delta and
p q = gamma, and divided differences of exp over repeated nodes,

.. math::
    n_1 = \exp[0,-p,-q],\qquad
    \partial_\gamma n_1 = -\exp[0,-p,-p,-q,-q],\qquad
    \partial_\delta n_1 = -\exp[-p,-p,-q,-q],

and those of n_0 = exp(-delta) n_1(gamma, -delta) by time reversal.  For real poles each of them is
positive.  ``SLOPES`` says which function is the derivative of which.

Floats compute these functions by the routines of export/routines, with power series near zero:
device.py has those of n_1 and n_0.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import sympy as sp
from sympy import Expr, Function, cos, cosh, exp, sin, sinh, sqrt


class Meant(Function):  # type: ignore[misc]
    """A function of its own; its docstring begins with what it is, in plain text."""

    meaning: ClassVar[str]
    """What it is: the first paragraph of its docstring."""

    def __init_subclass__(cls, **options: Any) -> None:
        said = " ".join((cls.__doc__ or "").split("\n\n")[0].split())
        cls.meaning = vars(cls).get("meaning", said)
        super().__init_subclass__()


class Entire(Meant):
    """A function without singularities; its docstring begins with its closed form."""

    definition: ClassVar[Callable[..., Expr]]
    """The closed form, valid wherever nothing in it is divided by zero."""

    at_zero: ClassVar[Expr]
    """Its value where all arguments are 0, as the closed form may be 0/0 there."""

    def __init_subclass__(cls, at_zero: Any, **options: Any) -> None:
        cls.at_zero = sp.sympify(at_zero)
        super().__init_subclass__(**options)

    def fdiff(self, argindex: int = 1) -> Expr:
        """The derivative: entire where :data:`SLOPES` has it, else that of the closed form."""
        if type(self) in SLOPES:
            return SLOPES[type(self)][argindex - 1](*self.args)
        symbols = [sp.Dummy() for _ in self.args]
        slope = sp.diff(type(self).definition(*symbols), symbols[argindex - 1])
        return slope.xreplace(dict(zip(symbols, self.args, strict=True)))


def at_numbers(expr: Expr) -> Expr:
    """An expression with the values of the entire functions in it that depend on mere numbers.

    >>> x = sp.Symbol("x")
    >>> at_numbers(x + Decay(sp.S.Zero) + Sinc(sp.pi / 2))
    x + 2/pi + 1
    """
    fixed = (f for f in expr.atoms(Entire) if f.is_number)
    values = {f: f.definition(*f.args) if any(f.args) else f.at_zero for f in fixed}
    return expr.xreplace(values)


def written_out(expr: Expr) -> Expr:
    """The expression with every entire function replaced by its closed form.

    >>> x = sp.Symbol("x")
    >>> written_out(x * Decay(x))
    1 - exp(-x)
    """
    return expr.replace(lambda e: isinstance(e, Entire), lambda e: e.definition(*e.args))


HALF, SIXTH = sp.Rational(1, 2), sp.Rational(1, 6)

# -- of one variable ---------------------------------------------------------------------------


def _by_root(w: Expr, swings: Callable[..., Expr], creeps: Callable[..., Expr]) -> Expr:
    """A function of sqrt(w) and w, or of sqrt(-w) and w where w shows a minus sign."""
    return swings(sqrt(-w), w) if w.could_extract_minus_sign() else creeps(sqrt(w), w)


class C(Entire, nargs=1, at_zero=1):
    """cosh(sqrt(w)), which is cos(sqrt(-w)) for w < 0"""

    definition = staticmethod(lambda w: _by_root(w, lambda r, w: cos(r), lambda r, w: cosh(r)))


class S(Entire, nargs=1, at_zero=1):
    """sinh(sqrt(w))/sqrt(w), which is sin(sqrt(-w))/sqrt(-w) for w < 0"""

    definition = staticmethod(
        lambda w: _by_root(w, lambda r, w: sin(r) / r, lambda r, w: sinh(r) / r)
    )


class Bend(Entire, nargs=1, at_zero=SIXTH):
    """(C(w) - S(w))/(2 w)

    The derivative of S.
    """

    definition = staticmethod(
        lambda w: _by_root(
            w,
            lambda r, w: (sin(r) / r - cos(r)) / (-2 * w),
            lambda r, w: (cosh(r) - sinh(r) / r) / (2 * w),
        )
    )


class Decay(Entire, nargs=1, at_zero=1):
    """(1 - exp(-x))/x"""

    definition = staticmethod(lambda x: (1 - exp(-x)) / x)


class Creep(Entire, nargs=1, at_zero=HALF):
    """(exp(-x) - 1 + x)/x^2

    How far a damped mass gets under a unit force.
    """

    definition = staticmethod(lambda x: (exp(-x) - 1 + x) / x**2)


class Fade(Entire, nargs=1, at_zero=HALF):
    """(1 - (1 + x) exp(-x))/x^2

    It is exp(-x) Creep(-x).
    """

    definition = staticmethod(lambda x: (1 - (1 + x) * exp(-x)) / x**2)


class Lag(Entire, nargs=1, at_zero=SIXTH):
    """(x - 2 + (x + 2) exp(-x))/x^3

    It is (Creep(x) - Fade(x))/x.
    """

    definition = staticmethod(lambda x: (x - 2 + (x + 2) * exp(-x)) / x**3)


class Wane(Entire, nargs=1, at_zero=2 * SIXTH):
    """(2 - (x^2 + 2 x + 2) exp(-x))/x^3

    By so much Fade becomes less.
    """

    definition = staticmethod(lambda x: (2 - (x**2 + 2 * x + 2) * exp(-x)) / x**3)


class Sinc(Entire, nargs=1, at_zero=1):
    """sin(x)/x"""

    definition = staticmethod(lambda x: sin(x) / x)


class Gap(Entire, nargs=1, at_zero=SIXTH):
    """(x - sin(x))/x^3"""

    definition = staticmethod(lambda x: (x - sin(x)) / x**3)


# -- of an angle x and a delay of k periods ----------------------------------------------------


class CosNext(Entire, nargs=2, at_zero=1):
    """cos((k + 1) x), without rounding the product"""

    definition = staticmethod(lambda k, x: cos((k + 1) * x))


class SinNext(Entire, nargs=2, at_zero=0):
    """sin((k + 1) x), without rounding the product"""

    definition = staticmethod(lambda k, x: sin((k + 1) * x))


class Spread(Entire, nargs=2, at_zero=1):
    """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3"""

    definition = staticmethod(lambda k, x: (2 * (k + 1) * sin(x) - sin(2 * (k + 1) * x)) / x**3)


class Chord(Entire, nargs=2, at_zero=1):
    """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3"""

    definition = staticmethod(
        lambda k, x: (2 * sin((k + 1) * x) - 2 * (k + 1) * sin(x) * cos((k + 1) * x)) / x**3
    )


class Ripple(Entire, nargs=2, at_zero=0):
    """((k + 1) cos((k + 1) x) sin(x) - sin((k + 1) x) cos(x))/sin(x)^2

    By so much sin((k + 1) x)/sin(x) changes: regular at x = 0, and where no sine vanishes.
    """

    definition = staticmethod(
        lambda k, x: ((k + 1) * cos((k + 1) * x) * sin(x) - sin((k + 1) * x) * cos(x)) / sin(x) ** 2
    )


class SpreadSlope(Entire, nargs=2, at_zero=0):
    """(2 k + 2) (cos(x) - cos((2 k + 2) x))/x^3 - 3 Spread(k, x)/x"""

    definition = staticmethod(
        lambda k, x: (
            2 * (k + 1) * (cos(x) - cos(2 * (k + 1) * x)) / x**3 - 3 * Spread.definition(k, x) / x
        )
    )


def _chord_slope(k: Expr, x: Expr) -> Expr:
    n = k + 1
    own = (1 - cos(x)) * cos(n * x) + n * sin(x) * sin(n * x)
    return 2 * n * own / x**3 - 3 * Chord.definition(k, x) / x


class ChordSlope(Entire, nargs=2, at_zero=0):
    """(2 k + 2) ((1 - cos(x)) cos((k + 1) x) + (k + 1) sin(x) sin((k + 1) x))/x^3
    - 3 Chord(k, x)/x
    """

    definition = staticmethod(_chord_slope)


# -- of the device -----------------------------------------------------------------------------


def _even(gamma: Expr, delta: Expr) -> Expr:
    """C(w) of w = delta^2/4 - gamma, written with c = sqrt(delta^2 - 4 gamma)."""
    return cosh(sqrt(delta**2 - 4 * gamma) / 2)


def _odd(gamma: Expr, delta: Expr) -> Expr:
    """S(w)."""
    half = sqrt(delta**2 - 4 * gamma) / 2
    return sinh(half) / half


def _halves(function: Any, gamma: Expr, delta: Expr) -> Expr:
    """The product of a function of (delta + c)/4 and of (delta - c)/4."""
    c = sqrt(delta**2 - 4 * gamma)
    return function((delta + c) / 4) * function((delta - c) / 4)


class PlantN1(Entire, nargs=2, at_zero=HALF):
    """(1 - exp(-delta/2) (C(w) + delta/2 S(w)))/gamma, w = delta^2/4 - gamma

    n_1, where a unit force, held for a period, has moved the device; never negative.  It and n_0
    nearly vanish where a device with little damping has swung k turns, at gamma = (2 pi k)^2;
    export/routines/device.py has their form there.
    """

    definition = staticmethod(
        lambda g, d: (1 - exp(-d / 2) * (_even(g, d) + d / 2 * _odd(g, d))) / g
    )


class PlantN0(Entire, nargs=2, at_zero=HALF):
    """exp(-delta) PlantN1(gamma, -delta)

    n_0, the same device, its time reversed.
    """

    definition = staticmethod(lambda g, d: exp(-d) * PlantN1.definition(g, -d))


class NumeratorAtOne(Entire, nargs=2, at_zero=1):
    """exp(-delta/2) sinhc((delta + c)/4) sinhc((delta - c)/4), sinhc(x) = sinh(x)/x,
    c = sqrt(delta^2 - 4 gamma)

    n_1 + n_0.
    """

    definition = staticmethod(lambda g, d: 4 * exp(-d / 2) * _halves(sinh, g, d) / g)


class NumeratorGap(Entire, nargs=2, at_zero=SIXTH):
    """exp(-delta/2) (S(delta^2/4) - S(w))/gamma, w = delta^2/4 - gamma

    (n_1 - n_0)/delta: exp(-delta/2) times the divided difference of S at delta^2/4 and w.
    """

    definition = staticmethod(lambda g, d: exp(-d / 2) * (sinh(d / 2) / (d / 2) - _odd(g, d)) / g)


class PlantTrace(Entire, nargs=2, at_zero=2):
    """2 exp(-delta/2) C(w), w = delta^2/4 - gamma

    a, the sum of the poles of the sampled device.
    """

    definition = staticmethod(lambda g, d: 2 * exp(-d / 2) * _even(g, d))


class DenominatorAtMinusOne(Entire, nargs=2, at_zero=4):
    """4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4), c = sqrt(delta^2 - 4 gamma)

    1 + a + e.
    """

    definition = staticmethod(lambda g, d: 4 * exp(-d / 2) * _halves(cosh, g, d))


# -- what the device's numbers change by -------------------------------------------------------


class Kick(Entire, nargs=2, at_zero=1):
    """exp(-delta/2) S(w), w = delta^2/4 - gamma: displacement by a unit impulse

    exp[-p, -q].
    """

    definition = staticmethod(lambda g, d: exp(-d / 2) * _odd(g, d))


class Coast(Entire, nargs=2, at_zero=1):
    """exp(-delta/2) (C(w) - delta/2 S(w)), w = delta^2/4 - gamma: speed by a unit impulse"""

    definition = staticmethod(lambda g, d: exp(-d / 2) * (_even(g, d) - d / 2 * _odd(g, d)))


class Echo(Entire, nargs=2, at_zero=SIXTH):
    """exp(-delta/2) (C(w) - S(w))/(2 w), w = delta^2/4 - gamma

    exp[-p, -p, -q, -q] = -d n_1/d delta: the answer to a unit impulse, convolved with itself.
    """

    definition = staticmethod(
        lambda g, d: exp(-d / 2) * (_even(g, d) - _odd(g, d)) / (d**2 / 2 - 2 * g)
    )


class Ebb(Entire, nargs=2, at_zero=-2 * SIXTH):
    """Echo - PlantN0, of gamma and delta: d n0/d delta"""

    definition = staticmethod(lambda g, d: Echo.definition(g, d) - PlantN0.definition(g, d))


class PlantN1Drop(Entire, nargs=2, at_zero=SIXTH / 4):
    """(PlantN1 - (Kick + delta Echo)/2)/gamma: -d n1/d gamma

    exp[0, -p, -p, -q, -q].
    """

    definition = staticmethod(
        lambda g, d: (PlantN1.definition(g, d)
                      - (Kick.definition(g, d) + d * Echo.definition(g, d)) / 2) / g
    )  # fmt: skip


class PlantN0Drop(Entire, nargs=2, at_zero=SIXTH / 4):
    """(PlantN0 - (Kick - delta Echo)/2)/gamma: -d n0/d gamma

    exp[-p - q, -p, -p, -q, -q].
    """

    definition = staticmethod(
        lambda g, d: (PlantN0.definition(g, d)
                      - (Kick.definition(g, d) - d * Echo.definition(g, d)) / 2) / g
    )  # fmt: skip


class NumeratorGapDrop(Entire, nargs=2, at_zero=SIXTH / 20):
    """((PlantN1 - PlantN0)/delta - Echo)/gamma: -d ((n1 - n0)/delta)/d gamma

    exp[0, -p - q, -p, -p, -q, -q] = (PlantN1Drop - PlantN0Drop)/delta.
    """

    definition = staticmethod(
        lambda g, d: (NumeratorGap.definition(g, d) - Echo.definition(g, d)) / g
    )


ALL: dict[str, Any] = {cls.__name__: cls for cls in Entire.__subclasses__()}
"""All entire functions by name."""

DEVICE = (
    PlantN1, PlantN0, NumeratorAtOne, NumeratorGap, PlantTrace, DenominatorAtMinusOne, Kick, Coast,
    Echo, Ebb, PlantN1Drop, PlantN0Drop, NumeratorGapDrop,
)  # fmt: skip
"""Those of the device, of gamma and delta."""

# -- which is the derivative of which ----------------------------------------------------------

SLOPES: dict[Any, tuple[Callable[..., Expr], ...]] = {
    PlantN1: (lambda g, d: -PlantN1Drop(g, d), lambda g, d: -Echo(g, d)),
    PlantN0: (lambda g, d: -PlantN0Drop(g, d), lambda g, d: Ebb(g, d)),
    NumeratorAtOne: (
        lambda g, d: -PlantN1Drop(g, d) - PlantN0Drop(g, d),
        lambda g, d: -PlantN0(g, d),
    ),
    PlantTrace: (lambda g, d: -Kick(g, d), lambda g, d: -Coast(g, d)),
    DenominatorAtMinusOne: (lambda g, d: -Kick(g, d), lambda g, d: -Coast(g, d) - exp(-d)),
    Kick: (lambda g, d: -Echo(g, d), lambda g, d: g * PlantN0Drop(g, d) - PlantN0(g, d)),
    C: (lambda w: S(w) / 2,),
    S: (lambda w: Bend(w),),
    Decay: (lambda x: -Fade(x),),
    Creep: (lambda x: -Lag(x),),
    Fade: (lambda x: -Wane(x),),
    Sinc: (lambda x: -2 * x * Bend(-(x**2)),),
    CosNext: (lambda k, x: -x * SinNext(k, x), lambda k, x: -(k + 1) * SinNext(k, x)),
    SinNext: (lambda k, x: x * CosNext(k, x), lambda k, x: (k + 1) * CosNext(k, x)),
    Spread: (
        lambda k, x: 4 * (SinNext(k, x) / x) ** 2 - 2 * Gap(x),
        lambda k, x: SpreadSlope(k, x),
    ),
    Chord: (
        lambda k, x: 2 * CosNext(k, x) * Gap(x) + 2 * (k + 1) * Sinc(x) * SinNext(k, x) / x,
        lambda k, x: ChordSlope(k, x),
    ),
}
"""The derivative by each argument, made of entire functions."""

r"""Entire functions of which the loop's formulas are made when nothing in them is 0/0.

Each one has a closed form, which loses its digits or is undefined somewhere, and a power series,
which is defined everywhere; ``definition`` gives the first, ``series_to`` the second.  Differences
that would cancel are inside the functions, so that formulas made of them keep their digits.  Here
are those of one variable, and those of an angle and a delay.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import sympy as sp
from sympy import Expr, Function, cosh, exp, factorial, sinh, sqrt

SLOPES: dict[Any, tuple[Callable[..., Expr], ...]] = {}
"""Which entire functions are the derivatives of which; :mod:`symhaptic.forms.slopes` says it."""


class Entire(Function):  # type: ignore[misc]
    """A function without singularities."""

    meaning: str
    """What it is, in plain text."""

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The closed form, valid wherever nothing in it is divided by zero."""
        raise NotImplementedError

    @classmethod
    def term(cls, k: int, *args: Expr) -> Expr:
        """The term of degree k of the power series, where a square counts as one where it is."""
        raise NotImplementedError

    @classmethod
    def series_to(cls, terms: int, *args: Expr) -> Expr:
        """The first terms of the power series.

        >>> x = sp.Symbol("x")
        >>> Decay.series_to(3, x)
        x**2/6 - x/2 + 1
        """
        return sp.expand(sp.Add(*(cls.term(k, *args) for k in range(terms))))

    def fdiff(self, argindex: int = 1) -> Expr:
        """The derivative: entire where :data:`SLOPES` has it, else that of the closed form."""
        if type(self) in SLOPES:
            return SLOPES[type(self)][argindex - 1](*self.args)
        symbols = [sp.Dummy() for _ in self.args]
        slope = sp.diff(self.definition(*symbols), symbols[argindex - 1])
        return slope.xreplace(dict(zip(symbols, self.args, strict=True)))


def at_numbers(expr: Expr) -> Expr:
    """An expression with the values of the entire functions in it that depend on mere numbers.

    >>> x = sp.Symbol("x")
    >>> at_numbers(x + Decay(sp.S.Zero) + Sinc(sp.pi / 2))
    x + 2/pi + 1
    """
    fixed = (f for f in expr.atoms(Entire) if f.is_number)
    values = {f: (f.definition if any(f.args) else partial(f.term, 0))(*f.args) for f in fixed}
    return expr.xreplace(values)


class C(Entire):
    """cosh(sqrt w), which is cos(sqrt -w) for w < 0."""

    nargs = 1
    meaning = "cosh(sqrt(w)), which is cos(sqrt(-w)) for w < 0"

    @classmethod
    def definition(cls, w: Expr) -> Expr:
        """cosh(sqrt w)."""
        return sp.cos(sqrt(-w)) if w.could_extract_minus_sign() else cosh(sqrt(w))

    @classmethod
    def term(cls, k: int, w: Expr) -> Expr:
        """w^k/(2k)!."""
        return w**k / factorial(2 * k)

    def fdiff(self, argindex: int = 1) -> Expr:
        """S(w)/2."""
        return S(self.args[0]) / 2


class S(Entire):
    """sinh(sqrt w)/sqrt w, which is sin(sqrt -w)/sqrt -w for w < 0."""

    nargs = 1
    meaning = "sinh(sqrt(w))/sqrt(w), which is sin(sqrt(-w))/sqrt(-w) for w < 0"

    @classmethod
    def definition(cls, w: Expr) -> Expr:
        """sinh(sqrt w)/sqrt w."""
        if w.could_extract_minus_sign():
            return sp.sin(sqrt(-w)) / sqrt(-w)
        return sinh(sqrt(w)) / sqrt(w)

    @classmethod
    def term(cls, k: int, w: Expr) -> Expr:
        """w^k/(2k+1)!."""
        return w**k / factorial(2 * k + 1)


class Decay(Entire):
    """(1 - exp(-x))/x."""

    nargs = 1
    meaning = "(1 - exp(-x))/x"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """(1 - exp(-x))/x."""
        return (1 - exp(-x)) / x

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(-x)^k/(k+1)!."""
        return (-x) ** k / factorial(k + 1)


class Creep(Entire):
    """(exp(-x) - 1 + x)/x^2: how far a damped mass gets under a unit force."""

    nargs = 1
    meaning = "(exp(-x) - 1 + x)/x^2"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """(exp(-x) - 1 + x)/x^2."""
        return (exp(-x) - 1 + x) / x**2

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(-x)^k/(k+2)!."""
        return (-x) ** k / factorial(k + 2)


class Fade(Entire):
    """(1 - (1 + x) exp(-x))/x^2 = exp(-x) Creep(-x)."""

    nargs = 1
    meaning = "(1 - (1 + x) exp(-x))/x^2"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """(1 - (1 + x) exp(-x))/x^2."""
        return (1 - (1 + x) * exp(-x)) / x**2

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(k+1) (-x)^k/(k+2)!."""
        return (k + 1) * (-x) ** k / factorial(k + 2)


class Lag(Entire):
    """(x - 2 + (x + 2) exp(-x))/x^3 = (Creep(x) - Fade(x))/x."""

    nargs = 1
    meaning = "(x - 2 + (x + 2) exp(-x))/x^3"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """(x - 2 + (x + 2) exp(-x))/x^3."""
        return (x - 2 + (x + 2) * exp(-x)) / x**3

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(k+1) (-x)^k/(k+3)!."""
        return (k + 1) * (-x) ** k / factorial(k + 3)


class Sinc(Entire):
    """sin(x)/x."""

    nargs = 1
    meaning = "sin(x)/x"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """sin(x)/x."""
        return sp.sin(x) / x

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(-x^2)^k/(2k+1)!."""
        return (-(x**2)) ** k / factorial(2 * k + 1)


class Gap(Entire):
    """(x - sin(x))/x^3."""

    nargs = 1
    meaning = "(x - sin(x))/x^3"

    @classmethod
    def definition(cls, x: Expr) -> Expr:
        """(x - sin(x))/x^3."""
        return (x - sp.sin(x)) / x**3

    @classmethod
    def term(cls, k: int, x: Expr) -> Expr:
        """(-x^2)^k/(2k+3)!."""
        return (-(x**2)) ** k / factorial(2 * k + 3)


class CosNext(Entire):
    """cos((k + 1) x), exact for every float k and x: the product is not rounded."""

    nargs = 2
    meaning = "cos((k + 1) x), the rounding of the product put back"

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """cos((k + 1) x)."""
        return sp.cos((k + 1) * x)

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """(-1)^k ((steps + 1) x)^(2k)/(2k)!."""
        return (-1) ** k * ((steps + 1) * x) ** (2 * k) / factorial(2 * k)

    def fdiff(self, argindex: int = 1) -> Expr:
        """-x sin((k + 1) x) or -(k + 1) sin((k + 1) x)."""
        k, x = self.args
        return -(x if argindex == 1 else k + 1) * SinNext(k, x)


class SinNext(Entire):
    """sin((k + 1) x), exact for every float k and x: the product is not rounded."""

    nargs = 2
    meaning = "sin((k + 1) x), the rounding of the product put back"

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """sin((k + 1) x)."""
        return sp.sin((k + 1) * x)

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """(-1)^k ((steps + 1) x)^(2k+1)/(2k+1)!."""
        return (-1) ** k * ((steps + 1) * x) ** (2 * k + 1) / factorial(2 * k + 1)

    def fdiff(self, argindex: int = 1) -> Expr:
        """x cos((k + 1) x) or (k + 1) cos((k + 1) x)."""
        k, x = self.args
        return (x if argindex == 1 else k + 1) * CosNext(k, x)


class Spread(Entire):
    """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3."""

    nargs = 2
    meaning = "((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3"

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3."""
        return (2 * (k + 1) * sp.sin(x) - sp.sin(2 * (k + 1) * x)) / x**3

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """By even powers of x."""
        order = 2 * (steps + 1)
        size = (order - order ** (2 * k + 3)) * (-1) ** (k + 1) / factorial(2 * k + 3)
        return sp.expand(size) * x ** (2 * k)


class Chord(Entire):
    """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3."""

    nargs = 2
    meaning = "(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3"

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3."""
        turn = (k + 1) * x
        return (2 * sp.sin(turn) - 2 * (k + 1) * sp.sin(x) * sp.cos(turn)) / x**3

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """By even powers of x: sin(x) cos(y) is half of sin(x + y) and sin(x - y)."""
        n = steps + 1
        power = 2 * k + 3
        sums = 2 * n**power - n * ((n + 1) ** power - (n - 1) ** power)
        return sp.expand(sums * (-1) ** (k + 1) / factorial(power)) * x ** (2 * k)


def written_out(expr: Expr) -> Expr:
    """The expression with every entire function replaced by its closed form.

    >>> x = sp.Symbol("x")
    >>> written_out(x * Decay(x))
    1 - exp(-x)
    """
    return expr.replace(lambda e: isinstance(e, Entire), lambda e: e.definition(*e.args))

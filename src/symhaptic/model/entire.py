r"""Entire functions of which the loop's formulas are made when nothing in them is 0/0.

Each one has a closed form, which loses its digits or is undefined somewhere, and a power series,
which is defined everywhere; ``definition`` gives the first, ``series`` the second.  Differences
that would cancel are inside the functions, so that formulas made of them keep their digits.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, cast

import mpmath
import sympy as sp
from mpmath import mpf
from sympy import Expr, Function, Symbol, cosh, exp, factorial, sinh, sqrt

_TRIES = 4
"""Precisions tried, each with more digits than the one before, until two agree."""


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

        >>> x = Symbol("x")
        >>> Decay.series_to(3, x)
        x**2/6 - x/2 + 1
        """
        return sp.expand(sp.Add(*(cls.term(k, *args) for k in range(terms))))

    def fdiff(self, argindex: int = 1) -> Expr:
        """The derivative: that of the closed form."""
        symbols = [sp.Dummy() for _ in self.args]
        slope = sp.diff(self.definition(*symbols), symbols[argindex - 1])
        return slope.xreplace(dict(zip(symbols, self.args, strict=True)))


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

    def fdiff(self, argindex: int = 1) -> Expr:
        """-Fade(x)."""
        return -Fade(self.args[0])


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


# -- of both parameters of the device -----------------------------------------------------


def _motion(gamma: Expr, delta: Expr) -> tuple[Expr, Expr]:
    """C(w) and S(w) of w = delta^2/4 - gamma, written with c = sqrt(delta^2 - 4 gamma)."""
    half = sqrt(delta**2 - 4 * gamma) / 2
    return cosh(half), sinh(half) / half


def _complete(k: int, gamma: Expr, delta: Expr) -> Expr:
    """Sum of p^i q^(k-i), for p + q = delta and p q = gamma."""
    before, now = sp.S.Zero, sp.S.One
    for _ in range(k):
        before, now = now, delta * now - gamma * before
    return sp.expand(now)


class Rise(Entire):
    """n_1: where a unit force, held for a period, has moved the device."""

    nargs = 2
    meaning = "(1 - exp(-delta/2) (C(w) + delta/2 S(w)))/gamma, w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """(1 - exp(-delta/2) (C(w) + delta/2 S(w)))/gamma."""
        even, odd = _motion(gamma, delta)
        return (1 - exp(-delta / 2) * (even + delta / 2 * odd)) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The complete symmetric polynomial of degree k in both poles, over (k+2)!."""
        return _complete(k, gamma, -delta) / factorial(k + 2)


class Fall(Entire):
    """n_0 = exp(-delta) Rise(gamma, -delta): the same device, its time reversed."""

    nargs = 2
    meaning = "exp(-delta) Rise(gamma, -delta)"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta) Rise(gamma, -delta)."""
        return exp(-delta) * Rise.definition(gamma, -delta)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The product of two power series, by total degree in both poles."""
        parts = (
            (-delta) ** j / factorial(j) * Rise.term(k - j, gamma, -delta) for j in range(k + 1)
        )
        return sp.expand(sp.Add(*parts))


class Together(Entire):
    """n_1 + n_0 = exp(-delta/2) sinhc((delta + c)/4) sinhc((delta - c)/4)."""

    nargs = 2
    meaning = (
        "exp(-delta/2) sinhc((delta + c)/4) sinhc((delta - c)/4), sinhc(x) = sinh(x)/x, "
        "c = sqrt(delta^2 - 4 gamma)"
    )

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """4 exp(-delta/2) sinh((delta + c)/4) sinh((delta - c)/4)/gamma."""
        c = sqrt(delta**2 - 4 * gamma)
        return 4 * exp(-delta / 2) * sinh((delta + c) / 4) * sinh((delta - c) / 4) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The sum of those of Rise and Fall."""
        return sp.expand(Rise.term(k, gamma, delta) + Fall.term(k, gamma, delta))


class Apart(Entire):
    """(n_1 - n_0)/delta: exp(-delta/2) times the divided difference of S at delta^2/4 and w."""

    nargs = 2
    meaning = "exp(-delta/2) (S(delta^2/4) - S(w))/gamma, w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta/2) (S(delta^2/4) - S(w))/gamma, where sinh(delta/2)/(delta/2) is S(..)."""
        whole = sinh(delta / 2) / (delta / 2)
        return exp(-delta / 2) * (whole - _motion(gamma, delta)[1]) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """By total degree in both poles, from the difference of Rise and Fall."""
        apart = Rise.term(k + 1, gamma, delta) - Fall.term(k + 1, gamma, delta)
        return sp.expand(sp.cancel(apart / delta))


class Swing(Entire):
    """a = 2 exp(-delta/2) C(w), the sum of the poles of the sampled device."""

    nargs = 2
    meaning = "2 exp(-delta/2) C(w), w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """2 exp(-delta/2) C(w)."""
        return 2 * exp(-delta / 2) * _motion(gamma, delta)[0]

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The sum of the k-th powers of both poles, over k!."""
        sums = [sp.S(2), -delta]
        for _ in range(k - 1):
            sums.append(-delta * sums[-1] - gamma * sums[-2])
        return sp.expand(sums[k]) / factorial(k)


class Nyquist(Entire):
    """1 + a + e = 4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4)."""

    nargs = 2
    meaning = "4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4), c = sqrt(delta^2 - 4 gamma)"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4)."""
        c = sqrt(delta**2 - 4 * gamma)
        return 4 * exp(-delta / 2) * cosh((delta + c) / 4) * cosh((delta - c) / 4)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """1 + a + e, term by term."""
        first = 1 if k == 0 else 0
        return sp.expand(first + Swing.term(k, gamma, delta) + (-delta) ** k / factorial(k))


ALL: dict[str, Any] = {
    cls.__name__: cls
    for cls in (
        C, S, Decay, Creep, Fade, Lag, Sinc, Gap, CosNext, SinNext, Spread, Chord,
        Rise, Fall, Together, Apart, Swing, Nyquist,
    )
}  # fmt: skip


def written_out(expr: Expr) -> Expr:
    """The expression with every entire function replaced by its closed form.

    >>> x = Symbol("x")
    >>> written_out(x * Decay(x))
    1 - exp(-x)
    """
    return expr.replace(lambda e: isinstance(e, Entire), lambda e: e.definition(*e.args))


# -- values -------------------------------------------------------------------------------


def value(expr: Expr, at: dict[Symbol, mpf], digits: int = 40) -> mpf:
    """The value at a point, to so many digits, whatever cancels.

    The point's numbers are exact, those of a float too.  What is far below 10^-300 counts as
    zero.
    Raises :class:`ArithmeticError` where the value is not found, or not real.

    >>> gamma, delta = sp.symbols("gamma delta")
    >>> mpmath.nstr(value(Rise(gamma, delta), {gamma: mpf(0), delta: mpf(1e-300)}), 20)
    '0.5'
    """
    function = _compiled(expr, tuple(at))
    before = None
    least = _digits(at, digits)
    for precision in (least + 50 * i * i for i in range(_TRIES)):
        with mpmath.workdps(precision):
            found = mpmath.mpmathify(function(*at.values()))
            if isinstance(found, mpmath.mpc):
                found = found.real
            if abs(found) < mpf(10) ** -(precision // 2 + 300):
                found = mpf(0)
            if before is not None and abs(found - before) <= abs(found) * mpf(10) ** -digits:
                return found
            before = found
    raise ArithmeticError(f"no {digits} digits of {expr} found at {at}")


def _digits(at: dict[Symbol, mpf], digits: int) -> int:
    """Enough for cubes of the smallest argument, and for exponentials of the largest."""
    sizes = [abs(v) for v in at.values() if v]
    small = max([0, *(-int(mpmath.log10(v)) for v in sizes)])
    large = max([0, *(int(v) for v in sizes if v < 10000)])
    return digits + 40 + 3 * small + large


@cache
def _compiled(expr: Expr, names: tuple[Symbol, ...]) -> Callable[..., mpf]:
    modules = [{name: numeric(cls) for name, cls in ALL.items()}, "mpmath"]
    return cast(Callable[..., mpf], sp.lambdify(names, expr, modules, cse=True))


@cache
def numeric(cls: Any) -> Callable[..., mpf]:
    """The function in mpmath: its closed form, and its limit where that is 0/0."""
    arguments = [sp.Dummy() for _ in range(next(iter(cls.nargs)))]
    closed = sp.lambdify(arguments, cls.definition(*arguments), "mpmath")

    def at(*values: mpf) -> mpf:
        exact = [mpmath.mpmathify(v) for v in values]
        limit = _hidden(cls, exact)
        if limit is not None:
            return limit
        found = closed(*exact)
        return found.real if isinstance(found, mpmath.mpc) else found

    return at


_WITHOUT_SPRING: dict[Any, Any] = {
    Rise: Creep,
    Fall: Fade,
    Together: Decay,
    Apart: Lag,
}


def _hidden(cls: Any, at: list[mpf]) -> mpf | None:
    """The value where the closed form is 0/0, else None."""
    if cls in (CosNext, SinNext, Spread, Chord, C, Swing, Nyquist):
        return None
    if len(at) == 1:
        first = cls.term(0, sp.S.Zero)
        return None if at[0] else mpf(first.p) / first.q
    gamma, delta = at
    if gamma == 0:
        return numeric(_WITHOUT_SPRING[cls])(delta)
    critical = delta**2 == 4 * gamma and cls is not Together
    if not critical and not (delta == 0 and cls is Apart):
        return None
    # smooth, and the point beside is nearer than the precision asked for
    step = mpf(10) ** -(2 * mpmath.mp.dps)
    with mpmath.workdps(5 * mpmath.mp.dps):
        return numeric(cls)(gamma * (1 + step), delta + step * (delta or 1))

"""Values of stable forms in many digits, whatever cancels."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any, cast

import flint
import mpmath
import sympy as sp
from flint import arb
from mpmath import mpf
from sympy import Expr, Symbol

from symhaptic.forms import entire
from symhaptic.forms.entire import ALL
from symhaptic.forms.implicit import ImplicitFunction
from symhaptic.forms.response import closed
from symhaptic.forms.root_count import fractional_outside, outside

_TRIES = 4
"""Precisions tried, each with more digits than the one before, until two agree."""


def value(expr: Expr, at: dict[Symbol, mpf], digits: int = 40) -> mpf:
    """The value at a point, to so many digits, whatever cancels.

    The point's numbers are exact, those of a float too.  What is far below 10^-300 counts as
    zero.
    Raises :class:`ArithmeticError` where the value is not found, or not real.

    >>> gamma, delta = sp.symbols("gamma delta")
    >>> mpmath.nstr(value(entire.PlantN1(gamma, delta), {gamma: mpf(0), delta: mpf(1e-300)}), 20)
    '0.5'
    """
    return settled(_compiled(expr, tuple(at)), tuple(at.values()), digits, expr)


def settled(function: Callable[..., mpf], at: tuple[mpf, ...], digits: int, name: object) -> mpf:
    """The value of a function of numbers, with more and more digits until so many stay."""
    before = None
    least = _digits(at, digits)
    for precision in (least + 50 * i * i for i in range(_TRIES)):
        with mpmath.workdps(precision):
            found = mpmath.mpmathify(function(*at))
            if isinstance(found, mpmath.mpc):
                found = found.real
            if abs(found) < mpf(10) ** -(precision // 2 + 300):
                found = mpf(0)
            if before is not None and abs(found - before) <= abs(found) * mpf(10) ** -digits:
                return found
            before = found
    raise ArithmeticError(f"no {digits} digits of {name} found at {at}")


def _digits(at: tuple[mpf, ...], digits: int) -> int:
    """Enough for cubes of the smallest argument, and for exponentials of the largest."""
    sizes = [abs(v) for v in at if v]
    small = max([0, *(-int(mpmath.log10(v)) for v in sizes)])
    large = max([0, *(int(mpmath.log10(mpmath.e) * v) for v in sizes if v < 10000)])
    return digits + 40 + 3 * small + large


@cache
def _compiled(expr: Expr, names: tuple[Symbol, ...]) -> Callable[..., mpf]:
    expr = closed(expr)
    used = {type(f) for f in expr.atoms(sp.Function)}
    own = {name: numeric(cls) for name, cls in ALL.items() if cls in used}
    own |= {cls.__name__: _found(cls.exact) for cls in used if issubclass(cls, ImplicitFunction)}
    own |= {name: _found(count) for name, count in _COUNTS.items()}
    # what is shared is computed first, also where a choice does not need it
    shared = not expr.has(sp.Piecewise)
    return cast(Callable[..., mpf], sp.lambdify(names, expr, [own, "mpmath"], cse=shared))


def _found(exact: Callable[..., mpf]) -> Callable[..., mpf]:
    """A function that is searched for, each value once."""

    @lru_cache(maxsize=256)
    def at(bits: int, *args: mpf) -> mpf:
        return exact(*args)

    return lambda *args: at(mpmath.mp.prec, *args)


_COUNTS: dict[str, Callable[..., mpf]] = {
    "WholeRoots": outside,
    "FractionalRoots": fractional_outside,
    "Stable": lambda roots, *_: mpf(roots == 0),
}


@cache
def numeric(cls: Any) -> Callable[..., mpf]:
    """The function in mpmath: its closed form, and its limit where that is 0/0."""
    if cls in BY_MATRIX:
        return BY_MATRIX[cls]
    arguments = sp.symbols(f"x:{next(iter(cls.nargs))}")
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
    entire.PlantN1: entire.Creep,
    entire.PlantN0: entire.Fade,
    entire.NumeratorAtOne: entire.Decay,
    entire.NumeratorGap: entire.Lag,
}


def _hidden(cls: Any, at: list[mpf]) -> mpf | None:
    """The value where the closed form is 0/0, else None."""
    if len(at) == 1:
        return None if at[0] else mpf(cls.at_zero.p) / cls.at_zero.q
    if cls not in _WITHOUT_SPRING:
        return None
    gamma, delta = at
    if gamma == 0:
        return numeric(_WITHOUT_SPRING[cls])(delta)
    if delta == 0 and cls is entire.NumeratorGap:
        return numeric(entire.Gap)(mpmath.sqrt(gamma))
    if delta**2 != 4 * gamma or cls is entire.NumeratorAtOne:
        return None
    # smooth, and the point beside is nearer than the precision asked for
    step = mpf(10) ** -(2 * mpmath.mp.dps)
    with mpmath.workdps(5 * mpmath.mp.dps):
        return numeric(cls)(gamma * (1 + step), delta * (1 + step))


# -- Values of the derivatives of the device's functions in many digits: from matrix exponentials --


_DOUBLINGS = 8
"""Precisions tried, each twice the one before, until the ball is small enough."""


def _chain(devices: int, gamma: Any, delta: Any, *rates: Any) -> Any:
    """exp of devices in series, each moved by the next, behind them decays of these rates."""
    size = 2 * devices + len(rates)
    matrix = [[arb(0)] * size for _ in range(size)]
    for i in range(0, 2 * devices, 2):
        matrix[i][i + 1] = arb(1)
        matrix[i + 1][i], matrix[i + 1][i + 1] = -gamma, -delta
    for i, rate in enumerate(rates, 2 * devices):
        matrix[i][i] = -rate
    for i in range(1, size - 1):
        if i % 2 or i >= 2 * devices:
            matrix[i][i + 1] = arb(1)
    return flint.arb_mat(matrix).exp()


def _ebb(gamma: Any, delta: Any) -> Any:
    """exp[-p, -p, -q, -q] - exp[-p - q, -p, -q]."""
    return _chain(2, gamma, delta)[0, 3] - _chain(1, gamma, delta, delta)[0, 2]


def _exact(number: mpf) -> Any:
    _, mantissa, power, _ = mpmath.mpmathify(number)._mpf_
    return arb(flint.fmpz(int(mantissa))) * arb(2) ** power * (-1 if number < 0 else 1)


def _numbers(found: Callable[[Any, Any], Any]) -> Callable[[mpf, mpf], mpf]:
    """To the digits that mpmath works with."""

    def at(gamma: mpf, delta: mpf) -> mpf:
        wanted = mpmath.mp.prec
        bits = 2 * wanted + int(2 * min(delta, 10**4))
        for _ in range(_DOUBLINGS):
            with flint.ctx.workprec(bits):
                ball = found(_exact(gamma), _exact(delta))
                if ball.rel_accuracy_bits() > wanted:
                    mantissa, power = ball.mid().man_exp()
                    return +mpf((int(mantissa), int(power)))
                if ball.contains(0) and ball < arb(2) ** (-2 * wanted - 2000):
                    return mpf(0)
            bits *= 2
        raise ArithmeticError(f"no {wanted} bits found at {gamma}, {delta}")

    return at


BY_MATRIX: dict[Any, Callable[[mpf, mpf], mpf]] = {
    entire.Kick: _numbers(lambda g, d: _chain(1, g, d)[0, 1]),
    entire.Coast: _numbers(lambda g, d: _chain(1, g, d)[1, 1]),
    entire.Echo: _numbers(lambda g, d: _chain(2, g, d)[0, 3]),
    entire.Ebb: _numbers(_ebb),
    entire.PlantN1Drop: _numbers(lambda g, d: _chain(2, g, d, arb(0))[0, 4]),
    entire.PlantN0Drop: _numbers(lambda g, d: _chain(2, g, d, d)[0, 4]),
    entire.NumeratorGapDrop: _numbers(lambda g, d: _chain(2, g, d, arb(0), d)[0, 5]),
}

"""An expression as a short program over balls, each subexpression computed once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache, reduce
from operator import add, mul
from typing import Any, TypeAlias

import sympy as sp
from flint import acb, acb_series, arb, ctx
from sympy import Expr

from symhaptic.notation.exact import fraction


class Uncheckable(ValueError):
    """An expression for which there is no program."""


Ball: TypeAlias = acb | acb_series
"""A ball, or the first terms of a series with such coefficients."""


def _sum(*terms: Ball) -> Ball:
    return reduce(add, terms)


def _product(*factors: Ball) -> Ball:
    return reduce(mul, factors)


def _sinh(x: Ball) -> Ball:
    return x.sinh() if isinstance(x, acb) else (x.exp() - (-x).exp()) / 2


def _cosh(x: Ball) -> Ball:
    return x.cosh() if isinstance(x, acb) else (x.exp() + (-x).exp()) / 2


def _tanh(x: Ball) -> Ball:
    return x.tanh() if isinstance(x, acb) else _sinh(x) / _cosh(x)


def _cot(x: Ball) -> Ball:
    return x.cot() if isinstance(x, acb) else x.cos() * x.sin() ** -1  # nan where / raises


def _power(x: Ball, y: Ball) -> Ball:
    if isinstance(x, acb) and isinstance(y, acb):
        return raised(x, y)
    return (x.log() * y).exp()


def _plain(function: Callable[[acb], acb]) -> Callable[[Ball], Ball]:
    """A function without a series; it has no value where its argument has none.

    A part of a number may be finite where the number is not, such as the imaginary part of 1/0.
    """

    def apply(x: Ball) -> Ball:
        if not isinstance(x, acb):
            raise Uncheckable("a slope of a function that has none")
        return function(x) if x.is_finite() else acb("nan")

    return apply


def raised(base: acb, exponent: acb) -> acb:
    """A power; Arb says 1 for the power of 0 of 0, and of what has no value."""
    defined = base.is_finite() and (exponent.real > 0 or not base.contains(0))
    return base.pow(exponent) if defined else acb("nan")


_PLAIN: dict[type, Callable[[Ball], Ball]] = {
    sp.asin: _plain(lambda x: x.asin()),
    sp.acos: _plain(lambda x: x.acos()),
    sp.asinh: _plain(lambda x: x.asinh()),
    sp.acosh: _plain(lambda x: x.acosh()),
    sp.atanh: _plain(lambda x: x.atanh()),
    sp.Abs: _plain(lambda x: acb(abs(x))),
    sp.re: _plain(lambda x: acb(x.real)),
    sp.im: _plain(lambda x: acb(x.imag)),
    sp.conjugate: _plain(lambda x: acb(x.real, -x.imag)),
}
WITHOUT_SERIES = tuple(_PLAIN)
"""Functions of which no slope is computed."""

CALLS: dict[type, Callable[[Ball], Ball]] = {
    sp.exp: lambda x: x.exp(),
    sp.sin: lambda x: x.sin(),
    sp.cos: lambda x: x.cos(),
    sp.tan: lambda x: x.tan(),
    sp.cot: _cot,
    sp.sinh: _sinh,
    sp.cosh: _cosh,
    sp.tanh: _tanh,
    sp.log: lambda x: x.log(),
    sp.atan: lambda x: x.atan(),
    **_PLAIN,
}
"""Functions of one argument, and what they do with a ball or a series."""


def value(number: Expr) -> acb:
    """A number in a ball of the precision in force."""
    found: acb = program(sp.sympify(number, strict=True), [])()
    return found


def real(number: Expr) -> arb:
    """A real number in a ball."""
    return value(number).real


def program(expr: Expr, symbols: Sequence[Expr]) -> Callable[..., Any]:
    """A function of balls or of their series, each subexpression computed once.

    >>> x = sp.Symbol("x")
    >>> print(program(sp.sin(x)**2 + 1, [x])(acb(0)).real)
    1.00000000000000
    """
    return _program(expr, tuple(symbols), ctx.prec)


@lru_cache(maxsize=1024)
def _program(expr: Expr, symbols: tuple[Expr, ...], bits: int) -> Callable[..., Any]:
    """The same for the precision in force, in which its numbers are."""
    place: dict[Expr, int] = {symbol: i for i, symbol in enumerate(symbols)}
    steps: list[tuple[Callable[..., Ball], tuple[int, ...]]] = []

    def put(part: Expr) -> int:
        if part not in place:
            operation, operands = _operation(part)
            at = tuple(put(operand) for operand in operands)
            place[part] = len(symbols) + len(steps)
            steps.append((operation, at))
        return place[part]

    last = put(expr)

    def run(*values: Ball) -> Ball:
        known = list(values)
        for operation, at in steps:
            known.append(operation(*[known[i] for i in at]))
        return known[last]

    return run


def _operation(part: Expr) -> tuple[Callable[..., Ball], tuple[Expr, ...]]:
    """What is done, and to which parts."""
    if part.is_Rational:
        number = acb(fraction(part))
        return lambda: number, ()
    if part is sp.pi:
        pi = acb(arb.pi())
        return lambda: pi, ()
    if part is sp.E:
        number = acb(1).exp()
        return lambda: number, ()
    if part is sp.I:
        return (lambda: acb(0, 1)), ()
    if part.is_Pow and part.args[1].is_Integer:
        n = int(part.args[1])
        # what has no value has none to the power of 0, of which Arb says 1
        return (lambda x: x**n) if n else (lambda x: 0 * x + 1), (part.args[0],)
    if part.is_Pow and part.args[1] == sp.Rational(1, 2):
        return (lambda x: x.sqrt()), (part.args[0],)
    if part.is_Pow:
        return _power, part.args
    if part.is_Add or part.is_Mul:
        return (_sum if part.is_Add else _product), part.args
    if part.func in CALLS and len(part.args) == 1:
        return CALLS[part.func], part.args
    raise Uncheckable(f"no program for {type(part).__name__}: {part}")

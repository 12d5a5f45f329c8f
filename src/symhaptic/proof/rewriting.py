"""Sines, cosines and real parts as exponentials; what the zero test cannot do is said here."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from functools import lru_cache

import sympy as sp
from sympy import Expr
from sympy.core.function import AppliedUndef

from symhaptic.notation import FUNCTIONS, SYMBOLS


class Undefined(ArithmeticError):
    """The expression divides by something that is identically zero."""


class Unsupported(ValueError):
    """The expression holds something that the normal form does not know."""


_MIRRORED = (
    sp.Add,
    sp.Mul,
    sp.exp,
    sp.sin,
    sp.cos,
    sp.tan,
    sp.cot,
    sp.sinh,
    sp.cosh,
    sp.tanh,
    sp.Abs,
    sp.re,
    sp.im,
    sp.conjugate,
)
"""What takes conjugate arguments to the conjugate value, wherever it is defined.

Functions with a branch cut on the real axis do not: acos(2) is real neither at 2 nor beside it.
"""


def conjugated(expr: Expr, real: AbstractSet[Expr] = frozenset()) -> Expr:
    """The complex conjugate; symbols and coefficients of the paper's unknown functions are real.

    Raises :class:`Unsupported` where the conjugate is not found by exchanging j and -j: for
    symbols that may be complex and are not among those known to be ``real``, for functions but
    those that are known to be mirrored, and for roots and powers that need not be real.
    """
    _check_mirrored(expr, real)
    return expr.xreplace({sp.I: -sp.I})


def _check_mirrored(expr: Expr, real: AbstractSet[Expr]) -> None:
    if expr.is_Rational or expr in (sp.I, sp.pi, sp.E):
        return
    if expr.is_Symbol:
        if expr not in real and is_complex(expr):
            raise Unsupported(f"the conjugate of an expression in {expr}, which is complex")
        return
    if expr.is_Pow:
        if not (expr.exp.is_Integer or expr.base.is_positive):
            raise Unsupported(f"the conjugate of {expr}, which need not be real")
    elif isinstance(expr, AppliedUndef):
        if expr.func.__name__ not in FUNCTIONS:
            raise Unsupported(f"the conjugate of {expr}, an unknown function")
    elif expr.func not in _MIRRORED or (isinstance(expr, sp.im) and expr.has(sp.I)):
        # im w is real, and im of the conjugate of w is -im w
        raise Unsupported(f"the conjugate of {expr}, which need not be real")
    for arg in expr.args:
        _check_mirrored(arg, real)


def is_complex(symbol: Expr) -> bool:
    """Whether a symbol need not be real, by what is assumed of it or by the paper's notation."""
    entry = SYMBOLS.get(symbol.name)
    if symbol.is_real is not None:
        return not symbol.is_real
    if symbol.is_complex is not None or symbol.is_antihermitian:
        return True
    return entry is not None and entry.domain == "complex"


_REWRITTEN = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.re, sp.im)


def as_exponentials(expr: Expr) -> Expr:
    """Sines, cosines, tangents and real parts rewritten with exponentials, nothing else touched."""
    left, seen = [expr], set[int]()
    while left:
        part = left.pop()
        if part.args and id(part) not in seen:
            if isinstance(part, _REWRITTEN):
                return _rewritten(expr)
            seen.add(id(part))
            left += part.args
    return expr


@lru_cache(maxsize=8192)
def _rewritten(expr: Expr) -> Expr:
    """The same of an expression that holds one of them; nothing is evaluated on the way."""
    if not expr.args:
        return expr
    j = sp.I
    if isinstance(expr, (sp.re, sp.im)):
        inside = expr.args[0]
        one, other = as_exponentials(inside), as_exponentials(conjugated(inside))
        return (one + other) / 2 if isinstance(expr, sp.re) else (one - other) / (2 * j)
    if isinstance(expr, _REWRITTEN):
        around = isinstance(expr, (sp.sin, sp.cos, sp.tan, sp.cot))
        argument = _rewritten(expr.args[0])
        if _depth(argument) > 1:  # they would double from one sine of a sine to the next
            raise Unsupported("an exponential inside an exponent")
        exponent, unit = (j * argument, 2 * j) if around else (argument, sp.S(2))
        up, down = sp.exp(exponent, evaluate=False), sp.exp(-exponent, evaluate=False)
        sine = _product(1 / unit, sp.Add(up, _product(sp.S.NegativeOne, down), evaluate=False))
        cosine = _product(sp.S.Half, sp.Add(up, down, evaluate=False))
        if isinstance(expr, (sp.sin, sp.sinh)):
            return sine
        if isinstance(expr, (sp.cos, sp.cosh)):
            return cosine
        top, bottom = (cosine, sine) if isinstance(expr, sp.cot) else (sine, cosine)
        return _product(top, sp.Pow(bottom, -1, evaluate=False))
    if not (expr.is_Add or expr.is_Mul or expr.is_Pow or isinstance(expr, sp.exp)):
        return expr
    args = tuple(map(_rewritten, expr.args))
    if args == expr.args:
        return expr
    return expr.func(*args, evaluate=False)


@lru_cache(maxsize=8192)
def _depth(expr: Expr) -> int:
    """How many exponentials stand within one another."""
    if expr.is_Add or expr.is_Mul or expr.is_Pow:
        return max(map(_depth, expr.args))
    return 1 + _depth(expr.args[0]) if isinstance(expr, sp.exp) else 0


def _product(left: Expr, right: Expr) -> Expr:
    return sp.Mul(left, right, evaluate=False)

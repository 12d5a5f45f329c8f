"""Expressions at many points at once, each part of them only once."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import add, mul
from typing import Any

import numpy as np
import sympy as sp
from sympy import Expr

_FUNCTIONS: dict[Any, Callable[..., Any]] = {
    sp.sin: np.sin, sp.cos: np.cos, sp.tan: np.tan, sp.exp: np.exp, sp.log: np.log,
    sp.sinh: np.sinh, sp.cosh: np.cosh, sp.Abs: np.abs, sp.floor: lambda x: np.floor(np.real(x)),
}  # fmt: skip


def at_columns(expr: Expr, known: dict[Expr, Any]) -> Any:
    """The values of an expression; of its symbols, and of parts met before, they are known."""
    if expr not in known:
        known[expr] = _found(expr, known)
    return known[expr]


def _found(expr: Expr, known: dict[Expr, Any]) -> Any:
    if expr.is_Number or expr.is_NumberSymbol:
        return float(expr)
    if expr.is_Add or expr.is_Mul:
        return reduce(add if expr.is_Add else mul, (at_columns(a, known) for a in expr.args))
    if expr.is_Pow:
        base = at_columns(expr.base, known)
        if expr.exp == sp.S.Half:
            return np.sqrt(base)
        return base ** (int(expr.exp) if expr.exp.is_Integer else at_columns(expr.exp, known))
    if expr.func in _FUNCTIONS:
        return _FUNCTIONS[expr.func](*(at_columns(a, known) for a in expr.args))
    symbols = sorted(expr.free_symbols, key=str)
    written = sp.lambdify(symbols, expr, [{"floor": _FUNCTIONS[sp.floor]}, "numpy"])
    return written(*(known[s] for s in symbols))

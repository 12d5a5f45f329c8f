"""Derivatives that searches and lemmas ask for; what is said of them is proved without this."""

from __future__ import annotations

from functools import lru_cache, reduce
from operator import mul

import sympy as sp
from sympy import Expr


@lru_cache(maxsize=1 << 12)
def derivative(expr: Expr, symbol: sp.Symbol) -> Expr:
    """As ``diff``, which asks of each part whether its derivative is zero, and takes its time.

    >>> x = sp.Symbol("x")
    >>> derivative(x**3*sp.tan(2*x), x)
    x**3*(2*tan(2*x)**2 + 2) + 3*x**2*tan(2*x)
    """
    if expr == symbol:
        return sp.S.One
    if not expr.has(symbol):
        return sp.S.Zero
    slopes = [derivative(part, symbol) for part in expr.args]
    if expr.is_Add:
        return sp.Add(*slopes)
    if expr.is_Mul:
        parts = expr.args
        rows = ((*parts[:i], slope, *parts[i + 1 :]) for i, slope in enumerate(slopes) if slope)
        return sp.Add(*(reduce(mul, row) for row in rows))
    if expr.is_Pow and slopes[1].is_zero:
        base, power = expr.args
        return expr * (slopes[0] * power / base)
    if expr.func in (sp.exp, sp.sin, sp.cos, sp.tan):  # a power of e that is kept as one is none
        return expr.fdiff() * slopes[0]
    return sp.diff(expr, symbol)

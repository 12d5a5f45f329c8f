"""The largest term of a stable form, on arrays: what a last place is measured by."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np
import sympy as sp
from sympy import Expr

from symhaptic.export.routine import code_name
from symhaptic.export.vectors import rounded, slope_size, squares
from symhaptic.forms.entire import C, Entire, NumeratorGap, PlantN0, PlantN1, PlantTrace, S
from symhaptic.forms.implicit import ImplicitFunction, Rated
from symhaptic.forms.response import Compensated, closed


def sized(expr: Expr, at: dict[Any, Any], functions: Any) -> tuple[Any, Any]:
    """Values and largest terms, as in symhaptic.export.vectors but in floats, on arrays."""
    if expr not in at:
        at[expr] = _sized(expr, at, functions)
    found: tuple[Any, Any] = at[expr]
    return found


def _sized(expr: Expr, at: dict[Any, Any], functions: Any) -> tuple[Any, Any]:
    if expr.is_Symbol:
        return at[expr.name], np.abs(at[expr.name])
    if expr.is_number:
        return float(expr), abs(float(expr))
    if isinstance(expr, sp.Piecewise):
        (yes, condition), (no, _) = expr.args
        whole = sized(condition.lhs, at, functions)[0] == 0
        both = sized(yes, at, functions), sized(no, at, functions)
        return tuple(np.where(whole, *pair) for pair in zip(*both, strict=True))
    if isinstance(expr, Compensated):
        value, size = sized(closed(expr), at, functions)
        more = [sized(term, at, functions)[1] for term in expr.terms(*expr.args)]
        return value, np.max(np.broadcast_arrays(size, *more), axis=0)
    parts = [sized(a, at, functions) for a in expr.args]
    if isinstance(expr, Entire):
        args = [v for v, _ in parts]
        function = partial(getattr(functions, code_name(type(expr).__name__)), np)
        value = function(*args)
        size = np.maximum(np.abs(value), swing(expr, args))
        return value, size + spoiled(function, value, expr, args)
    if isinstance(expr, ImplicitFunction):
        given = np.broadcast_arrays(*(np.asarray(v, dtype=float) for v, _ in parts))
        value = getattr(functions, code_name(type(expr).__name__))(np, *given)
        if isinstance(expr, Rated):
            return value, parts[1][1]
        return value, np.maximum(np.abs(value), leans(expr, value, at, functions))
    if expr.is_Add:
        total = sum(v for v, _ in parts)
        terms = np.broadcast_arrays(np.abs(total), *(size for _, size in parts))
        return total, np.max(terms, axis=0)
    if expr.is_Mul:
        return math.prod(v for v, _ in parts), math.prod(s for _, s in parts)
    if expr.is_Pow and abs(expr.args[1]) == sp.S.Half:
        root = np.sqrt(parts[0][0])
        lost = squares(expr.args[0], lambda e: sized(e, at, functions))
        some = np.where(root == 0, 1.0, root)
        if expr.args[1] > 0:
            return root, np.maximum(root, lost / (2 * some))
        return 1 / root, np.maximum(1 / root, lost / (2 * some**3))
    if expr.is_Pow:
        power = int(expr.args[1])
        base, size = parts[0]
        return base**power, size**power if power > 0 else np.abs(base ** (power - 1)) * size
    plain: Any = {sp.exp: np.exp, sp.sin: np.sin, sp.cos: np.cos, sp.tan: np.tan}[expr.func]
    value = plain(parts[0][0])
    return value, np.abs(value) + spoiled(plain, value, expr, [parts[0][0]])


def leans(expr: ImplicitFunction, value: Any, at: dict[Any, Any], functions: Any) -> Any:
    """What the largest term of a sum that passes through zero counts in what hangs on it."""
    at[expr] = value, np.abs(value)
    if (found := expr.leaning()) is None:
        return 0.0
    size = sized(found.total, at, functions)[1] * np.abs(sized(found.slope, at, functions)[0])
    counts = [sized(c, at, functions)[0] > 0 for c in found.counts]
    return np.where(np.logical_and.reduce(np.broadcast_arrays(*counts)), size, 0.0)


def spoiled(function: Any, value: Any, expr: Expr, args: list[Any]) -> Any:
    """How much a rounded product as an argument changes the value, by its last place."""
    change: Any = 0.0
    for i, arg in enumerate(expr.args):
        if rounded(arg):
            moved = [*args[:i], args[i] * (1 + _SMALL), *args[i + 1 :]]
            change = change + np.abs(function(*moved) - value) / _SMALL
    return change


_SMALL = 1e-7


def swing(expr: Expr, args: list[Any]) -> Any:
    """The size of sines and cosines in functions that swing through zero."""
    if isinstance(expr, (C, S)):
        w = np.minimum(args[0], -1)
        return np.where(args[0] < -1, 1 if isinstance(expr, C) else 1 / np.sqrt(-w), 0)
    if not isinstance(expr, (PlantN1, PlantN0, PlantTrace, NumeratorGap)):
        return slope_size(type(expr), args)
    g, d = args
    swings = (g >= 4) & (d * d < 4 * g)
    decayed, g = np.exp(-d / 2), np.maximum(g, 4)
    if isinstance(expr, PlantN0):
        root = np.sqrt(np.where(swings, g - d * d / 4, 1))
        decayed = decayed * np.maximum(1, np.abs(d / 2 * np.sin(root) / root))
    size = {
        PlantTrace: 2 * decayed,
        NumeratorGap: 1 / g / np.maximum(d, 1),
        PlantN1: 1 / g,
        PlantN0: decayed / g,
    }
    return np.where(swings, size[type(expr)], 0.0)

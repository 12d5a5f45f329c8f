"""How large are the terms of a stable form at a point: what its last place is measured by."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import mpmath
import sympy as sp
from mpmath import mpf
from sympy import Expr

from symhaptic.export.error_scale import size as slope_size
from symhaptic.forms.entire import C, Entire, S
from symhaptic.forms.entire_device import NumeratorGap, PlantN0, PlantN1, PlantTrace
from symhaptic.forms.implicit import ImplicitFunction, Rated
from symhaptic.forms.response import Compensated, closed
from symhaptic.forms.root_count import (
    NEAR,
    FractionalRoots,
    Stable,
    WholeRoots,
    fractional_outside,
    outside,
)
from symhaptic.forms.slope_values import BY_MATRIX
from symhaptic.forms.values import numeric, settled

DIGITS = 60
"""Of each entire function; what a stable form loses beyond is its largest term's last place."""

_FOUND = 32
"""Of what is searched for: twice those of a float."""

_PLAIN = {
    sp.exp: mpmath.exp, sp.sin: mpmath.sin, sp.cos: mpmath.cos, sp.tan: mpmath.tan, sp.Abs: abs,
}  # fmt: skip

Sizes = dict[Expr, tuple[mpf, mpf]]


def sized(expr: Expr, at: Sizes) -> tuple[mpf, mpf]:
    """Value and largest term of a form at a point: what its last place is measured by.

    A difference is as large as its larger side, a sum at least as large as its value, a product
    as large as its factors.  A quotient grows by what its denominator lost: next to the pole that
    the boundary has where M(-1) = 0, a last place of any argument changes it as much.  An argument
    that is a product, such as delta (1 - epsilon), reaches its function rounded, and half a last
    place of it counts, too: a mere wave or exponential of it is not known better.  An angle that
    hangs on a sum that passes through zero counts with what that sum's largest term moves it by.
    ``at`` has those of the arguments, and keeps all that are found.
    """
    if expr not in at:
        at[expr] = _sized(expr, at)
    return at[expr]


def _sized(expr: Expr, at: Sizes) -> tuple[mpf, mpf]:
    if expr.is_Rational:
        exact = mpf(expr.p) / expr.q
        return exact, abs(exact)
    if expr is sp.pi:
        return +mpmath.pi, +mpmath.pi
    if isinstance(expr, Compensated):
        exact, size = sized(closed(expr), at)
        return exact, max([size, *(sized(term, at)[1] for term in expr.terms(*expr.args))])
    if isinstance(expr, Entire):
        cls: Any = type(expr)
        args = [sized(arg, at)[0] for arg in expr.args]
        exact = _entire(cls, tuple(args))
        return exact, max(abs(exact), _swing(expr, args)) + _spoiled(expr, exact, at)
    if isinstance(expr, sp.Piecewise):
        (yes, condition), (no, _) = expr.args
        return sized(yes if sized(condition.lhs - condition.rhs, at)[0] == 0 else no, at)
    parts = [sized(arg, at) for arg in expr.args]
    if isinstance(expr, ImplicitFunction):
        kind: Any = type(expr)
        exact = _searched(kind, tuple(v for v, _ in parts))
        return exact, parts[1][1] if kind is Rated else max(abs(exact), _leans(expr, exact, at))
    if isinstance(expr, WholeRoots | FractionalRoots):
        near = {"near": at[NEAR][0]} if NEAR in at else {}
        exact = outside if isinstance(expr, WholeRoots) else fractional_outside
        count = exact(*(v for v, _ in parts), **near)
        return count, count
    if isinstance(expr, Stable):  # no root on the circle, where the count is known
        good = mpf(parts[0][0] == 0)
        return good, good
    if expr.is_Add:
        total = mpmath.fsum(v for v, _ in parts)
        return total, max(abs(total), *(size for _, size in parts))
    if expr.is_Mul:
        return mpmath.fprod(v for v, _ in parts), mpmath.fprod(size for _, size in parts)
    if expr.is_Pow and expr.args[1].is_Integer:
        (base, size), power = parts[0], int(expr.args[1])
        return base**power, size**power if power > 0 else abs(base) ** (power - 1) * size
    if expr.is_Pow:
        root, lost = mpmath.sqrt(parts[0][0]), squares(expr.args[0], lambda e: sized(e, at))
        if expr.args[1] > 0:
            return root, max(root, lost / (2 * root) if root else root)
        return 1 / root, max(1 / root, lost / (2 * root**3))
    exact = _PLAIN[expr.func](parts[0][0])
    return exact, abs(exact) + _spoiled(expr, exact, at)


def squares(base: Expr, term: Callable[[Expr], tuple[Any, Any]]) -> Any:
    """What the last places of the terms below a root count: of a square, twice those of its side.

    A root grows by what the sum below it lost, as a quotient does.
    """
    found: Any = 0
    for part in sp.Add.make_args(base):
        side, power = part.as_base_exp()
        value, size = term(side)
        found += 2 * abs(value) * size if power == 2 else term(part)[1]
    return found


def _leans(expr: ImplicitFunction, exact: mpf, at: Sizes) -> mpf:
    """What the largest term of a sum that passes through zero counts in what hangs on it."""
    at[expr] = exact, abs(exact)
    if (found := expr.leaning()) is None or any(sized(c, at)[0] <= 0 for c in found.counts):
        return mpf(0)
    return sized(found.total, at)[1] * abs(sized(found.slope, at)[0])


def rounded(arg: Expr) -> bool:
    """Whether an argument is a product that may be rounded."""
    return len(arg.free_symbols) > 1


def _spoiled(expr: Expr, exact: mpf, at: Sizes) -> mpf:
    """How much a rounded product as an argument changes the value, by its last place."""
    change = mpf(0)
    cls: Any = type(expr)
    for i, arg in enumerate(expr.args):
        if rounded(arg):
            args = [sized(a, at)[0] for a in expr.args]
            args[i] *= 1 + _SMALL
            moved = _entire(cls, tuple(args)) if isinstance(expr, Entire) else _PLAIN[cls](*args)
            change += abs(moved - exact) / _SMALL
    return change


_SMALL = mpf(2) ** -60


@cache
def _entire(cls: Any, args: tuple[mpf, ...]) -> mpf:
    if cls in BY_MATRIX:
        return BY_MATRIX[cls](*args)
    return settled(numeric(cls), args, DIGITS, cls.__name__)


@cache
def _searched(cls: Any, args: tuple[mpf, ...]) -> mpf:
    with mpmath.workdps(_FOUND):
        found: mpf = cls.exact(*args)
    return found


def _swing(expr: Expr, args: list[mpf]) -> mpf:
    """The size of the sines and cosines in a function that swings through zero."""
    if isinstance(expr, (C, S)):
        w = args[0]
        return mpf(0) if w >= -1 else 1 if isinstance(expr, C) else 1 / mpmath.sqrt(-w)
    if not isinstance(expr, (PlantN1, PlantN0, PlantTrace, NumeratorGap)):
        return mpf(float(slope_size(type(expr), [float(arg) for arg in args])))
    g, dl = args
    if g < 4 or dl**2 >= 4 * g:
        return mpf(0)
    decayed = mpmath.exp(-dl / 2)
    if isinstance(expr, PlantTrace):
        return 2 * decayed
    if isinstance(expr, NumeratorGap):
        return 1 / g / max(dl, mpf(1))
    if isinstance(expr, PlantN1):
        return 1 / g
    root = mpmath.sqrt(g - dl**2 / 4)
    return decayed * max(1, abs(dl / 2 * mpmath.sin(root) / root)) / g

"""Test vectors: arguments, values to the last digit, and how far off a value may be."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import product
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from mpmath import mpf
from sympy import Expr, Symbol

from symhaptic.export.error_scale import size as slope_size
from symhaptic.export.precision import DOUBLE, Precision
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
from symhaptic.forms.stable import Form
from symhaptic.forms.values import numeric, settled
from symhaptic.notation import alpha, beta, d, delta, epsilon, gamma, theta

_ALLOWED = {
    "discretize": 4, "passivity_margin_at": 4, "passivity_margin": 4, "stability_conditions": 64,
}  # fmt: skip
_ELSE = 8
_SLOPES = 16
"""The same with derivatives."""


def allowed(form: Form) -> int:
    """Units in the last place that a self-test allows, of the largest term of the stable form."""
    if form.plain is not None:
        return max(_SLOPES, allowed(form.plain))
    return _ALLOWED.get(form.name, _ELSE)


TINIEST, BELOW, ABOVE = -1.0, -2.0, -3.0
"""Stand for what depends on the precision: a very small number, and the neighbours of 1/4."""

_HARD = {
    gamma: (0.0, TINIEST, 1e-12, 1e-3, 1.0, 9.869604401089358, 700.0),
    delta: (0.0, TINIEST, 1e-8, 0.02, 2.0, 60.0, 700.0),
    alpha: (0.0, 0.3, -0.1, 1e-9),
    beta: (0.0, 0.2, -0.05, 1e3),
    d: (0.0, 1.0, 2.0, 1e6, 0.5, 3.25),
    epsilon: (0.0, 0.5, 1e-9, 0.999),
    theta: (1e-9, 0.01, 1.0, 3.0, 3.141592653589793 - 1e-9),
}
_CRITICAL = [(0.25, 1.0), (BELOW, 1.0), (ABOVE, 1.0), (25.0, 10.0)]
_MOST = 40
"""Vectors a function: all combinations where these are fewer, else an even choice of them."""


def hexadecimal(number: float) -> str:
    """A float without any rounding, always with 13 digits.

    >>> hexadecimal(-3.0), hexadecimal(0.0)
    ('-0x1.8000000000000p+1', '0x0.0000000000000p+0')
    >>> hexadecimal(float("nan")), hexadecimal(float("-inf"))
    ('nan', '-inf')
    """
    text = number.hex()
    mantissa, _, power = text.partition("p")
    whole, _, digits = mantissa.partition(".")
    return f"{whole}.{digits:0<13}p{power}" if power else text


def points(form: Form, precision: Precision = DOUBLE) -> list[tuple[float, ...]]:
    """Ordinary and hard arguments of a form, which are floats of the precision."""
    kind = precision.kind
    special = {
        TINIEST: precision.smallest,
        BELOW: float(np.nextafter(kind(0.25), kind(0))),
        ABOVE: float(np.nextafter(kind(0.25), kind(1))),
    }

    def near(symbol: Symbol, value: float) -> float:
        found = precision.nearest(special.get(value, value))
        return min(found, precision.below_pi) if symbol == theta else found

    choices = [[near(s, v) for v in _HARD[s] if s != d or not form.whole or v.is_integer()]
               for s in form.arguments]  # fmt: skip
    everything = list(product(*choices))
    step = max(1, len(everything) // _MOST) | 1
    found = everything[:: step if len(everything) > _MOST else 1]
    if gamma in form.arguments and delta in form.arguments:
        for i, (stiffness, damping) in enumerate(_CRITICAL):
            point = dict(zip(form.arguments, everything[(i * 37) % len(everything)], strict=True))
            point |= {gamma: near(gamma, stiffness), delta: near(delta, damping)}
            found.append(tuple(point[s] for s in form.arguments))
    return found


_DIGITS = 60
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
        return sized(closed(expr), at)
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
        root = mpmath.sqrt(parts[0][0])
        root = root if expr.args[1] > 0 else 1 / root
        return root, root
    exact = _PLAIN[expr.func](parts[0][0])
    return exact, abs(exact) + _spoiled(expr, exact, at)


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
    return settled(numeric(cls), args, _DIGITS, cls.__name__)


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


@cache
def vectors(form: Form, precision: Precision = DOUBLE) -> tuple[tuple[float, ...], ...]:
    """For each point: the arguments, then each result's exact value, rounded, and its tolerance.

    Points where a result is no number, or too small or large for a float, are left out; points
    outside the domain follow.
    """
    return (*_rows(form, precision), *_outside(form, precision))


ORDINARY = {gamma: 1.0, delta: 2.0, alpha: 0.25, beta: 0.125, d: 1.0, epsilon: 0.5, theta: 0.5}
"""Arguments inside every domain."""


def _outside(form: Form, precision: Precision) -> Iterator[tuple[float, ...]]:
    """An ordinary point with one argument that may not be, each in its turn."""
    result = float("nan") if form.outside is sp.nan else float(int(form.outside == -1) * -1)
    results = (result, 0.0) * len(form.results)
    bad = float("nan"), float("inf"), float("-inf"), -1.0, *((1.5,) * form.whole)
    for i, (symbol, within) in enumerate(zip(form.arguments, form.within, strict=True)):
        most = {d: precision.longest, gamma: precision.stiffest}.get(symbol, precision.largest)
        for value in (*bad, 4 * most, -4 * most):
            if math.isnan(value) or not precision.at(within).xreplace({symbol: sp.Float(value)}):
                point = [ORDINARY[s] for s in form.arguments]
                point[i] = value
                yield (*point, *results)


def _rows(form: Form, precision: Precision) -> Iterator[tuple[float, ...]]:
    for point in points(form, precision):
        with mpmath.workdps(_DIGITS):
            at = {s: (mpf(v), abs(mpf(v))) for s, v in zip(form.arguments, point, strict=True)}
            at[NEAR] = mpmath.sqrt(mpf(precision.ulp(1.0))) / 16, mpf(0)
            try:
                found = [sized(expr, at) for expr in form.expressions]
            except ArithmeticError:
                continue
            if any(size > precision.huge or 0 < abs(v) < precision.tiny for v, size in found):
                continue
            if form.outside is not sp.nan and _swings_on(
                {s: v for s, (v, _) in at.items()}, precision
            ):
                continue
            row = list(point)
            for exact, size in found:
                row += [precision.nearest(exact), allowed(form) * precision.ulp(float(size))]
        yield tuple(row)


def _swings_on(at: Mapping[Expr, mpf], precision: Precision) -> bool:
    """Whether too little damping is given to tell whether any wall stops the device: see Stable.

    This is so where a period holds whole half swings: the samples do not see these.
    """
    damping, swing = at.get(delta, mpf(0)), mpmath.sqrt(at.get(gamma, mpf(0)))
    last = mpf(precision.ulp(1.0))
    hidden = swing > 1 and abs(mpmath.sin(swing)) <= 2 * last * swing
    return bool(hidden and 0 < damping < 5 * last)


def text(forms: tuple[Form, ...], precision: Precision = DOUBLE) -> str:
    """One line a vector: the function's name, then its numbers."""
    lines = []
    for form in forms:
        for row in vectors(form, precision):
            lines.append(" ".join([form.name, *(hexadecimal(x + 0.0) for x in row)]))
    return "\n".join(lines) + "\n"

"""Test vectors: arguments, values to the last digit, and how far off a value may be."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from itertools import product
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from mpmath import mpf
from sympy import Expr, Symbol

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.sampled import MARGIN
from symhaptic.forms.entire import (
    Bend,
    C,
    ChordSlope,
    Coast,
    Ebb,
    Echo,
    Entire,
    Kick,
    NumeratorGap,
    NumeratorGapDrop,
    PlantN0,
    PlantN0Drop,
    PlantN1,
    PlantN1Drop,
    PlantTrace,
    Ripple,
    S,
    SpreadSlope,
)
from symhaptic.forms.implicit import LOOP, DelayMargin, ImplicitFunction, Rated
from symhaptic.forms.response import Compensated, closed
from symhaptic.forms.root_count import (
    NEAR,
    FractionalRoots,
    Stable,
    WholeRoots,
    fractional_outside,
    outside,
)
from symhaptic.forms.stable import Form
from symhaptic.forms.values import BY_MATRIX, numeric, settled
from symhaptic.notation import alpha, beta, d, delta, epsilon, gamma, theta

_ALLOWED = {
    "discretize": 4, "passivity_margin_at": 4, "passivity_margin": 4, "stability_conditions": 64,
    MARGIN: 2048,
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
_LATE = [
    (0.01, 0.05, 0.0, 0.0, 2.5), (0.1, 0.3, 0.0, 0.01, 0.5), (0.01, 0.1, 0.3, 0.05, 1.0),
    (0.3, 0.5, 0.0, 0.05, 0.25), (0.5, 0.1, 0.0, 0.01, 3.0),
]  # fmt: skip
"""Loops whose delay margin is told, but for one that is not stable."""
_CRITICAL = [(0.25, 1.0), (BELOW, 1.0), (ABOVE, 1.0), (25.0, 10.0), (1e6, 0.02)]
"""Critical damping and its neighbours; reordered sums give a wrong n0 of the stiff device."""
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

    if form.name == MARGIN:
        loops = [dict(zip(LOOP, map(precision.nearest, loop), strict=True)) for loop in _LATE]
        return [tuple(loop[s] for s in form.arguments) for loop in loops]
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
        with mpmath.workdps(DIGITS):
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

    This is so where a period holds whole half oscillations: the samples do not see these.
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


# -- How large are the terms of a stable form at a point: what its last place is measured by -----


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
        if kind is DelayMargin:  # a delay is known as well as all of it
            return exact, exact + parts[-1][1] + 2
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


# -- The largest term in derivatives that swing through zero: what their last place is measured by


_DEVICE = (Kick, Coast, Ebb, Echo, PlantN1Drop, PlantN0Drop, NumeratorGapDrop)


def slope_size(cls: Any, args: Any) -> Any:
    """Of one of these functions, at floats or arrays of them; 0 where the value itself counts."""
    args = [np.asarray(a, dtype=float) for a in args]
    if cls in _DEVICE:
        return _of_device(cls, *args)
    if cls is Bend:
        return np.where(args[0] < -4, 0.5 / np.maximum(-args[0], 4), 0.0)
    return _of_angle(cls, *args) if cls in (Ripple, SpreadSlope, ChordSlope) else 0.0


def _of_device(cls: Any, gamma: Any, delta: Any) -> Any:
    w = delta * delta / 4 - gamma
    root, fall = np.sqrt(np.abs(w)), np.exp(-delta / 2)
    slow, far = gamma / np.maximum(delta / 2 + root, 1e-300), np.maximum(root, 1.0)
    stiff = np.maximum(gamma, 4.0)
    kick = fall / far
    echo = fall / (2 * far * far)
    pair = (kick + delta * echo) / 2
    creeping: Any = 0.0
    if cls is Kick:
        swinging = kick
    elif cls is Coast:
        swinging = fall + delta / 2 * kick
        creeping = slow * np.exp(-slow) / np.maximum(2 * root, 1.0)
    elif cls is Echo:
        swinging = echo
    elif cls is Ebb:
        swinging = echo + fall / stiff
        creeping = (2 + slow) * np.exp(-slow) / np.maximum(2 * root, 2.0) ** 2
        creeping = creeping / np.maximum(delta / 2 + root, 2.0)
    elif cls is NumeratorGapDrop:
        swinging = (1 / stiff / np.maximum(delta, 1.0) + echo) / stiff
    else:
        swinging = ((1 if cls is PlantN1Drop else fall) / stiff + pair) / stiff
    counts = (w < 0) & ((gamma >= 4) | (cls is Coast))
    return np.where(counts, swinging, np.where(w < 0, 0.0, creeping))


def _of_angle(cls: Any, k: Any, x: Any) -> Any:
    n = k + 1
    sine, half, near = np.abs(np.sin(x)), np.sin(x / 2), n * x < 1.5
    if cls is Ripple:
        return np.where(near, np.abs(np.sin(n * x)) / 2, n / np.maximum(sine, 1e-300))
    cube = np.maximum(x, 1e-100) ** 3
    top = 4 * n if cls is SpreadSlope else 2 * n * n * sine + 4 * n * half * half
    return np.where(near, 0.0, top / cube)

"""Test vectors: arguments, values to the last digit, and how far off a value may be."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import product

import mpmath
import numpy as np
import sympy as sp
from mpmath import mpf
from sympy import Expr, Symbol

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.term_sizes import DIGITS, sized
from symhaptic.forms.root_count import NEAR
from symhaptic.forms.stable import Form
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

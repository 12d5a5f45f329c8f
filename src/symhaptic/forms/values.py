"""Values of stable forms in many digits, whatever cancels."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any, cast

import mpmath
import sympy as sp
from mpmath import mpf
from sympy import Expr, Symbol

from symhaptic.forms.entire import (
    C,
    Chord,
    CosNext,
    Creep,
    Decay,
    Fade,
    Gap,
    Lag,
    S,
    Sinc,
    SinNext,
    Spread,
)
from symhaptic.forms.entire_device import (
    DenominatorAtMinusOne,
    NumeratorAtOne,
    NumeratorGap,
    PlantN0,
    PlantN1,
    PlantTrace,
)
from symhaptic.forms.implicit import ImplicitFunction
from symhaptic.forms.response import closed
from symhaptic.forms.root_count import fractional_outside, outside
from symhaptic.forms.slope_values import BY_MATRIX
from symhaptic.forms.slopes import NEW

_TRIES = 4
"""Precisions tried, each with more digits than the one before, until two agree."""

ALL: dict[str, Any] = {
    cls.__name__: cls
    for cls in (
        C, S, Decay, Creep, Fade, Lag, Sinc, Gap, CosNext, SinNext, Spread, Chord,
        PlantN1, PlantN0, NumeratorAtOne, NumeratorGap, PlantTrace, DenominatorAtMinusOne, *NEW,
    )
}  # fmt: skip
"""All entire functions by name."""


def value(expr: Expr, at: dict[Symbol, mpf], digits: int = 40) -> mpf:
    """The value at a point, to so many digits, whatever cancels.

    The point's numbers are exact, those of a float too.  What is far below 10^-300 counts as
    zero.
    Raises :class:`ArithmeticError` where the value is not found, or not real.

    >>> gamma, delta = sp.symbols("gamma delta")
    >>> mpmath.nstr(value(PlantN1(gamma, delta), {gamma: mpf(0), delta: mpf(1e-300)}), 20)
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
    PlantN1: Creep,
    PlantN0: Fade,
    NumeratorAtOne: Decay,
    NumeratorGap: Lag,
}


def _hidden(cls: Any, at: list[mpf]) -> mpf | None:
    """The value where the closed form is 0/0, else None."""
    if cls in (CosNext, SinNext, Spread, Chord, C, PlantTrace, DenominatorAtMinusOne) or (
        len(at) == 2 and cls in NEW
    ):
        return None
    if len(at) == 1:
        first = cls.term(0, sp.S.Zero)
        return None if at[0] else mpf(first.p) / first.q
    gamma, delta = at
    if gamma == 0:
        return numeric(_WITHOUT_SPRING[cls])(delta)
    if delta == 0 and cls is NumeratorGap:
        return numeric(Gap)(mpmath.sqrt(gamma))
    if delta**2 != 4 * gamma or cls is NumeratorAtOne:
        return None
    # smooth, and the point beside is nearer than the precision asked for
    step = mpf(10) ** -(2 * mpmath.mp.dps)
    with mpmath.workdps(5 * mpmath.mp.dps):
        return numeric(cls)(gamma * (1 + step), delta * (1 + step))

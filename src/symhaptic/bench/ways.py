"""The ways to compute a function: the paper's forms, stable forms, C, many digits, balls."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any

import flint
import mpmath
import numpy as np
from flint import arb

import symhaptic
from symhaptic.bench.error import functions
from symhaptic.bench.exact import EXACT
from symhaptic.bench.exported import compiled
from symhaptic.bench.points import Array
from symhaptic.bench.printed import expressions, function, swings
from symhaptic.forms.stable import Form

KINDS_OF_C: tuple[Any, ...] = (np.float64,)
"""Precisions in which C is exported."""

DIGITS = (30, 50)
BITS = (53, 128)


@dataclass(frozen=True)
class Way:
    """One way: of arrays in a float type, or of one point at a time."""

    name: str
    precision: str
    """float32, float64, or digits or bits."""
    last: float
    """A unit in the last place of numbers from 1 to 2."""
    call: Callable[[Sequence[Any]], Sequence[Any]]
    kind: Any = None
    """The float type of arrays; None where points go one at a time."""


@cache
def routines(form: Form) -> Any:
    """The functions of the NumPy export of a form."""
    return functions(form)


def ways(form: Form, folder: Path) -> Iterator[Way]:
    """All ways to compute a form; C is compiled in ``folder``, where there is a compiler."""
    stable = getattr(routines(form), form.name)
    forms = ["printed", "derived"]
    if expressions(form, "printed") == expressions(form, "derived"):
        forms.pop()
    if not expressions(form, "printed"):
        forms = []
    for kind in (np.float32, np.float64):
        for name in forms:
            yield _in(kind, name, _real(function(form, name, "numpy"), swings(form, name), kind))
        yield _in(kind, "stable", lambda arrays: _listed(stable(*arrays)))
    if shutil.which("gcc"):
        for kind in KINDS_OF_C:
            yield _in(kind, "C", partial(_in_c, compiled(form, folder)))
    if form.name in _OWN:
        yield _in(np.float64, "package", partial(_own, form.name))
    for digits in DIGITS:
        last = 10.0 ** (1 - digits)
        for name in forms:
            call = partial(_in_digits, function(form, name, "mpmath"), digits)
            yield Way(name, f"{digits} digits", last, call)
        call = partial(_in_digits, symhaptic.lambdify(form.name, modules="mpmath"), digits)
        yield Way("stable", f"{digits} digits", last, call)
    for bits in BITS:
        yield Way("balls", f"{bits} bits", 2.0 ** (1 - bits), partial(_balls, form.name, bits))


def _in(kind: Any, name: str, call: Callable[[Sequence[Any]], Sequence[Any]]) -> Way:
    return Way(name, np.dtype(kind).name, float(np.finfo(kind).eps), call, kind)


def _listed(found: Any) -> Sequence[Any]:
    return found if isinstance(found, tuple) else (found,)


def _real(call: Callable[..., Any], complex: bool, kind: Any) -> Callable[..., Sequence[Any]]:
    """A printed form on arrays, as somebody would type it in."""
    if not complex:
        return lambda arrays: call(*arrays)
    wide = np.result_type(kind, np.complex64)
    return lambda arrays: [np.real(v) for v in call(*(a.astype(wide) for a in arrays))]


def _in_c(call: Callable[[list[Array]], Array], arrays: Sequence[Array]) -> Sequence[Array]:
    return list(call(list(arrays)))


# what the package itself computes with; a form's other functions have other arguments there
_OWN = ("discretize", "stability_boundary", "passivity_boundary", "max_passive_stiffness",
        "linear_limit")  # fmt: skip
_SHEETS = ("stability_boundary", "passivity_boundary", "max_passive_stiffness")


def _own(name: str, arrays: Sequence[Array]) -> Sequence[Array]:
    sheet = {"sheet": "principal"} if name in _SHEETS else {}
    return _listed(tuple(np.atleast_2d(getattr(symhaptic, name)(*arrays, **sheet))))


def _in_digits(call: Callable[..., Any], digits: int, point: Sequence[float]) -> Sequence[Any]:
    with mpmath.workdps(digits):
        try:
            found = call(*map(mpmath.mpf, point))
        except ArithmeticError:  # a division by zero, or no digits found
            return ()
        return [+mpmath.re(v) for v in (found if isinstance(found, (list, tuple)) else (found,))]


def _balls(name: str, bits: int, point: Sequence[float]) -> Sequence[arb]:
    with flint.ctx.workprec(bits):
        return EXACT[name](*point)


def error(found: Any, exact: arb) -> float:
    """Distance of a number, or the radius of a ball; NaN where it is no number."""
    if isinstance(found, arb):
        return float(found.rad()) if found.is_finite() else math.nan
    number = arb(found if isinstance(found, mpmath.mpf) else float(found))
    return float(abs(number - exact)) if number.is_finite() else math.nan

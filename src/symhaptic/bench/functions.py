"""Error against time of every function, in every way, on ordinary and on hard parameters."""

from __future__ import annotations

import math
import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import flint
import mpmath
import numpy as np
from flint import arb

import symhaptic
from symhaptic.balls.exact import EXACT, bits
from symhaptic.bench import points
from symhaptic.bench.error import exactly, functions, largest
from symhaptic.bench.exported import compiled
from symhaptic.bench.points import Array
from symhaptic.bench.printed import expressions, function, swings
from symhaptic.bench.timing import seconds
from symhaptic.export import request
from symhaptic.forms.stable import Form

SETS = ("ordinary", "hard")

_ALL = 250
"""Bits of each exact value, more than the 50 digits that are compared with it."""

_LONG = ("discretize_fractional", "passivity_margin", "max_stable_stiffness")
"""Functions of fractional delays, or that search: in balls they take seconds a point."""

FUNCTIONS = tuple(name for name in EXACT if name not in _LONG)


class WrongExact(RuntimeError):
    """An exact value that another method contradicts; the message is one line."""


@dataclass(frozen=True)
class Effort:
    """How many points are measured."""

    points: int
    """Points of a set, in floats."""
    slow: int
    """Points that are also computed with many digits."""
    timed: int
    """Elements of the arrays that are timed."""


def measured(effort: Effort, names: Sequence[str] = FUNCTIONS) -> Iterator[dict[str, Any]]:
    """One row for each function, set of parameters and way."""
    for form in request.chosen(names):
        sets = {which: chosen(form, which, effort.points) for which in SETS}
        for arrays in sets.values():
            confirm(form, [a[:: max(1, a.size // effort.slow)] for a in arrays])
        with tempfile.TemporaryDirectory() as place:
            for way in ways(form, Path(place)):
                for which, arrays in sets.items():
                    row = {"function": form.name, "set": which, "way": way.name}
                    yield {
                        **row,
                        "precision": way.precision,
                        **_measured(form, way, arrays, effort),
                    }


def chosen(form: Form, which: str, count: int) -> list[Array]:
    """Arguments of a form: in the paper's range (23), or hard ones."""
    rng = np.random.default_rng(23)
    if which == "hard":  # whole delays, for which the paper's forms are meant
        arrays = points.columns(form, rng, count)
        pairs = zip(form.arguments, arrays, strict=True)
        return [np.floor(a) if s.name == "d" else a for s, a in pairs]
    curve = form.name == "passivity_boundary"  # one point without delay
    delay = rng.integers(curve, 9, count).astype(float)
    most = np.pi / (delay + 1) if curve else np.pi
    values = {
        "gamma": rng.uniform(0, 1e-3, count),
        "delta": rng.uniform(0, 0.02, count),
        "alpha": rng.uniform(0, 0.5, count),
        "beta": rng.uniform(-0.02, 1, count),
        "d": delay,
        "theta": most * rng.uniform(0, 1, count),
    }
    return [values[s.name] for s in form.arguments]


def _measured(form: Form, way: Way, arrays: list[Array], effort: Effort) -> dict[str, Any]:
    some: list[list[float]]
    if way.kind is None:
        few = np.linspace(0, arrays[0].size - 1, effort.slow).astype(int)
        some = [[float(a[k]) for a in arrays] for k in few]
        found: list[Any] = [way.call(point) for point in some]
        took = seconds(lambda: [way.call(point) for point in some], 2) / len(some)
        return errors(form, some, found, way.last) | {"seconds": took}
    typed = [np.ascontiguousarray(a, dtype=way.kind) for a in arrays]
    many = [np.resize(a, effort.timed) for a in typed]
    with np.errstate(all="ignore"):
        rows = [np.broadcast_to(r, typed[0].shape) for r in way.call(typed)]
        took = seconds(lambda: way.call(many)) / effort.timed
    some = [[float(a[k]) for a in typed] for k in range(typed[0].size)]
    found = [[row[k] for row in rows] for k in range(len(some))]
    return errors(form, some, found, way.last) | {"seconds": took}


def errors(
    form: Form, some: list[list[float]], found: Sequence[Sequence[Any]], last: float
) -> dict[str, Any]:
    """Median and worst error, and the share of points without a number.

    In units in the last place (``last`` for numbers from 1 to 2) of the largest term of the
    stable form; each point counts with the worst of its results.
    """
    worst: list[float] = []
    missing = 0
    at: list[float] = []
    least = 1e-30 if last > 1e-10 else 1e-290
    sizes = largest(form, [np.array(column) for column in zip(*some, strict=True)])
    for k, point in enumerate(some):
        exact = exactly(form, tuple(point), _ALL)
        offs = [] if found[k] else [math.nan]
        for value, right, size in zip(found[k], exact, sizes[:, k], strict=False):
            if not math.isfinite(size) or size < least or not right.is_finite():
                continue
            offs.append(error(value, right) / (last * 2.0 ** math.floor(math.log2(size))))
        if any(not math.isfinite(off) for off in offs):
            missing += 1
        elif offs:
            if not worst or max(offs) > max(worst):
                at = point
            worst.append(max(offs))
    total = len(worst) + missing
    return {
        "points": total,
        "median": float(np.median(worst)) if worst else None,
        "worst": max(worst) if worst else None,
        "at": at,
        "missing": missing / total if total else 0.0,
        "last": last,
    }


def confirm(form: Form, arrays: list[Array], digits: int = 50) -> None:
    """Compare the exact values with the stable form in many digits, an independent method.

    Raises :class:`WrongExact` if the number is outside of the ball.
    """
    other = symhaptic.lambdify(form.name, modules="mpmath")
    for point in zip(*(map(float, a) for a in arrays), strict=True):
        with mpmath.workdps(digits):
            try:
                numbers = other(*point)
            except ArithmeticError:  # a zero that has no digits to agree on
                continue
        numbers = numbers if isinstance(numbers, tuple) else (numbers,)
        exact = exactly(form, point, _ALL)
        for (name, _), right, number in zip(form.results, exact, numbers, strict=True):
            with flint.ctx.workprec(bits(point)):
                near = arb(number) * arb(1, 10.0 ** (2 - digits))
                if right.is_finite() and not near.overlaps(right):
                    raise WrongExact(f"{form.name}, {name}: the exact value is wrong at {point}")


# -- the ways to compute a function -----------------------------------------------------------

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


def ways(form: Form, folder: Path) -> Iterator[Way]:
    """All ways to compute a form; C is compiled in ``folder``, where there is a compiler."""
    stable = getattr(functions(form), form.name)
    printed, derived = (expressions(form, kind) for kind in ("printed", "derived"))
    forms = ["printed"] * bool(printed) + ["derived"] * (derived != printed)
    for kind in (np.float32, np.float64):
        for name in forms:
            yield _in(kind, name, _real(function(form, name, "numpy"), swings(form, name), kind))
        yield _in(kind, "stable", lambda arrays: _listed(stable(*arrays)))
    if shutil.which("gcc"):
        run = compiled(form, folder)
        yield _in(np.float64, "C", lambda arrays: list(run(list(arrays))))
    if form.name in _OWN:
        yield _in(np.float64, "package", partial(_own, form.name))
    for digits in DIGITS:
        last = 10.0 ** (1 - digits)
        for name in forms:
            call = partial(_in_digits, function(form, name, "mpmath"), digits)
            yield Way(name, f"{digits} digits", last, call)
        call = partial(_in_digits, symhaptic.lambdify(form.name, modules="mpmath"), digits)
        yield Way("stable", f"{digits} digits", last, call)
        if form.name in _TO_DIGITS:
            yield Way("package", f"{digits} digits", last, partial(_to_digits, form.name, digits))
    for size in BITS:
        yield Way("balls", f"{size} bits", 2.0 ** (1 - size), partial(_balls, form.name, size))


def _in(kind: Any, name: str, call: Callable[[Sequence[Any]], Sequence[Any]]) -> Way:
    return Way(name, np.dtype(kind).name, float(np.finfo(kind).eps), call, kind)


def _listed(found: Any) -> Sequence[Any]:
    return found if isinstance(found, tuple) else (found,)


def _real(call: Callable[..., Any], complex: bool, kind: Any) -> Callable[..., Sequence[Any]]:
    """A published form on arrays, as a user would type it in."""
    if not complex:
        return lambda arrays: call(*arrays)
    wide = np.result_type(kind, np.complex64)
    return lambda arrays: [np.real(v) for v in call(*(a.astype(wide) for a in arrays))]


# what the package itself computes with; a form's other functions have other arguments there
_OWN = ("discretize", "stability_boundary", "passivity_boundary", "max_passive_stiffness",
        "linear_limit")  # fmt: skip
_TO_DIGITS = (*_OWN, "discretize_fractional", "passivity_margin_at")
_SHEETS = ("stability_boundary", "passivity_boundary", "max_passive_stiffness")


def _own(name: str, arrays: Sequence[Array]) -> Sequence[Array]:
    sheet = {"sheet": "principal"} if name in _SHEETS else {}
    return _listed(tuple(np.atleast_2d(getattr(symhaptic, name)(*arrays, **sheet))))


def _to_digits(name: str, digits: int, point: Sequence[float]) -> Sequence[Any]:
    """Balls, which are right to so many digits; nothing where one is not reached."""
    try:
        found = getattr(symhaptic, name)(*point, digits=digits)
    except (ValueError, ArithmeticError):  # outside of the function's range, or zero
        return ()
    return _listed(found)


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

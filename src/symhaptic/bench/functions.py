"""Error against time of every function, in every way, on ordinary and on hard parameters."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import flint
import mpmath
import numpy as np
from flint import arb

from symhaptic.bench import points
from symhaptic.bench.exact import EXACT, bits
from symhaptic.bench.points import Array
from symhaptic.bench.terms import sized
from symhaptic.bench.timing import seconds
from symhaptic.bench.ways import Way, error, routines, ways
from symhaptic.export import request
from symhaptic.forms.stable import Form

SETS = ("ordinary", "hard")

_LONG = ("discretize_fractional", "passivity_margin", "max_stable_stiffness")
"""Of fractions of a period, or searched for: in balls they take seconds a point."""

FUNCTIONS = tuple(name for name in EXACT if name not in _LONG)


class WrongExact(RuntimeError):
    """An exact value that another road contradicts; the message is one line."""


@dataclass(frozen=True)
class Effort:
    """How many points are measured."""

    points: int
    """A set, in floats."""
    slow: int
    """Of these with many digits."""
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
    """Arguments of a form: inside the paper's (23), or hard ones."""
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
    terms = _sizes(form, some)
    for k, point in enumerate(some):
        exact = truth(form, tuple(point))
        offs = [] if found[k] else [math.nan]
        for value, right, size in zip(found[k], exact, terms[k], strict=False):
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


@cache
def truth(form: Form, point: tuple[float, ...]) -> tuple[arb, ...]:
    """Exact values in balls."""
    with flint.ctx.workprec(bits(point)):
        return tuple(EXACT[form.name](*point))


def _sizes(form: Form, some: list[list[float]]) -> Array:
    arrays = [np.array(column) for column in zip(*some, strict=True)]
    at = {s.name: a for s, a in zip(form.arguments, arrays, strict=True)}
    helpers = routines(form)
    with np.errstate(all="ignore"):
        found = [sized(e, at, helpers)[1] for e in form.expressions]
    return np.stack([np.broadcast_to(f, len(some)) for f in found], axis=1).astype(float)


def confirm(form: Form, arrays: list[Array], digits: int = 50) -> None:
    """Compare the exact values with the stable form in many digits, which is another road.

    Raises :class:`WrongExact` where a ball and the number are apart.
    """
    from symhaptic.scene.callables import lambdify

    other = lambdify(form.name, modules="mpmath")
    for point in zip(*(map(float, a) for a in arrays), strict=True):
        with mpmath.workdps(digits):
            try:
                numbers = other(*point)
            except ArithmeticError:  # a zero that has no digits to agree on
                continue
        numbers = numbers if isinstance(numbers, tuple) else (numbers,)
        exact = truth(form, point)
        for (name, _), right, number in zip(form.results, exact, numbers, strict=True):
            with flint.ctx.workprec(bits(point)):
                near = arb(number) * arb(1, 10.0 ** (2 - digits))
                if right.is_finite() and not near.overlaps(right):
                    raise WrongExact(f"{form.name}, {name}: the exact value is wrong at {point}")

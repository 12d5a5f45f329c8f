"""Errors of exported C, in units in the last place of the largest term of the stable form."""

from __future__ import annotations

import math
import tempfile
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import flint
import numpy as np
from flint import arb

from symhaptic.balls.exact import EXACT, bits, slopes
from symhaptic.bench.exported import GCC, compiled
from symhaptic.bench.points import Array, columns
from symhaptic.bench.terms import sized
from symhaptic.export.library import library
from symhaptic.export.precision import DOUBLE, SINGLE, Precision
from symhaptic.export.targets import TARGETS
from symhaptic.forms.stable import Form

Worst = dict[str, tuple[float, tuple[float, ...]]]
"""The largest error of each result, and the arguments there."""


@cache
def functions(form: Form) -> Any:
    """The routines of the array export, which compute the sizes of terms."""
    language = TARGETS["numpy"]
    files = language.source(library("terms", "", [form], language, merges=False))
    space: dict[str, Any] = {}
    exec(compile(files["terms.py"], "terms.py", "exec"), space)
    return type("Terms", (), {k: staticmethod(v) for k, v in space.items() if callable(v)})


_FEW, _TOLD = 320, 100
"""Bits of the first attempt, and correct bits that each result must then have."""


@lru_cache(maxsize=8192)  # several exports are compared at the same points
def exactly(form: Form, point: tuple[float, ...], told: int = _TOLD) -> tuple[Any, ...]:
    """The results of a form, followed by their derivatives if it has any.

    Nearly all of them are found with few bits.  If a ball is wide or infinite, the working
    precision is the one that the arguments may require.
    """
    with flint.ctx.workprec(_FEW):
        found = _in_balls(form, point)
        if all(x.is_finite() and x.rel_accuracy_bits() >= told for x in found):
            return found
    with flint.ctx.workprec(bits(point)):
        return _in_balls(form, point)


def _in_balls(form: Form, point: tuple[float, ...]) -> tuple[Any, ...]:
    plain = form.plain or form
    found = list(EXACT[plain.name](*point))
    named = {s.name: v for s, v in zip(form.arguments, point, strict=True)}
    names = [name.rpartition("_by_")[2] for name, _ in form.results[len(plain.results) :]]
    for by in dict.fromkeys(names):
        found += slopes(plain.name, named, by)
    return tuple(found)


def measure(
    form: Form, count: int, seed: int = 1, precision: Precision = DOUBLE, compiler: str = GCC
) -> Worst:
    """The worst error of each result, with its arguments.

    NaN counts as an infinite error, except one unit in the last place of theta before the end of
    the curve.
    """
    arrays = columns(form, np.random.default_rng(seed), count, precision)
    with tempfile.TemporaryDirectory() as place:
        found = compiled(form, Path(place), precision, compiler)(arrays)
    if precision is SINGLE:
        worst = suspects(form, arrays, found)
        arrays, found = [np.ascontiguousarray(a[worst]) for a in arrays], found[:, worst]
    return compare(form, arrays, found, precision)


def climb(
    form: Form,
    count: int,
    seed: int = 1,
    precision: Precision = DOUBLE,
    compiler: str = GCC,
    rounds: int = 4,
) -> Worst:
    """The same, searched further around the worst points, and around the worst of these."""
    rng = np.random.default_rng(seed)
    arrays = columns(form, rng, count, precision)
    worst: Worst = {name: (0.0, ()) for name, _ in form.results}
    with tempfile.TemporaryDirectory() as place:
        run = compiled(form, Path(place), precision, compiler)
        for _ in range(rounds + 1):
            off = errors(form, arrays, run(arrays), precision)
            _keep(worst, arrays, off)
            top = np.unique(np.argsort(off, axis=1)[:, -_TOP:])
            arrays = [_around(s.name, a[top], rng, precision)
                      for s, a in zip(form.arguments, arrays, strict=True)]  # fmt: skip
    return worst


_TOP, _NEAR = 8, 20
"""The worst points of each result from which the search continues, and points around each."""


def _around(name: str, values: Array, rng: np.random.Generator, precision: Precision) -> Array:
    """Points at all distances from these, and these points; integer delays stay integers."""
    many = np.repeat(values.astype(float), _NEAR)
    far = rng.choice([-1, 1], many.size) * 10 ** rng.uniform(-16, -1, many.size)
    moved = many * (1 + far * (rng.random(many.size) < 0.7))
    if name == "d":
        moved = np.where(many % 1 == 0, many, moved)
    if name == "epsilon":
        moved = np.minimum(moved, 1 - 1e-6)
    if name == "theta":
        away = np.pi - (np.pi - many) * (1 + far)
        moved = np.where((rng.random(many.size) < 0.5) | (away <= 0), moved, away)
        moved = np.minimum(moved, 3.14159265)
    moved = np.concatenate([values, moved]).astype(precision.kind)
    return np.minimum(moved, precision.kind(precision.below_pi)) if name == "theta" else moved


def suspects(form: Form, arrays: list[Array], found: Array) -> Array:
    """Points where single precision differs most from double precision."""
    wide = [a.astype(float) for a in arrays]
    with tempfile.TemporaryDirectory() as place:
        right = compiled(form, Path(place), DOUBLE)(wide)
    sizes = largest(form, wide)
    with np.errstate(all="ignore"):
        off = np.abs(found - right) / np.spacing(sizes.astype(np.float32))
    off[~((sizes >= SINGLE.tiny) & (sizes <= SINGLE.huge))] = 0
    lacking = np.isnan(found) & ~np.isnan(right)
    off[np.isnan(off)] = 0
    worst = [*np.argsort(off, axis=1)[:, -20:], *(np.flatnonzero(row)[:20] for row in lacking)]
    return np.unique(np.concatenate(worst))


def largest(form: Form, arrays: list[Array]) -> Array:
    """The sizes of the largest terms, a row for each result."""
    at = {s.name: a.astype(float) for s, a in zip(form.arguments, arrays, strict=True)}
    helpers = functions(form)
    with np.errstate(all="ignore"):
        sizes = [np.broadcast_to(sized(e, at, helpers)[1], arrays[0].shape)
                 for e in form.expressions]  # fmt: skip
    return np.array(sizes)


def _ends(form: Form, point: tuple[float, ...], precision: Precision) -> bool:
    """Whether the passivity boundary ends within one unit in the last place of theta.

    No float can decide there on which side of the end a point is.
    """
    if (form.plain or form).name != "passivity_boundary":
        return False
    theta, *others = point
    return not exactly(form, (theta + precision.ulp(theta), *others))[0].is_finite()


def errors(form: Form, arrays: list[Array], found: Array, precision: Precision = DOUBLE) -> Array:
    """The error of each result at each point, in units in the last place of its largest term."""
    sizes = largest(form, arrays)
    off = np.zeros(found.shape)
    for k in range(arrays[0].size):
        point = tuple(float(a[k]) for a in arrays)
        exact = exactly(form, point)
        with flint.ctx.workprec(_FEW):
            for i in range(len(form.results)):
                size = float(sizes[i][k])
                beyond = size < precision.tiny or size > precision.huge  # of NaN neither
                if beyond or not exact[i].is_finite():
                    continue
                off[i, k] = float(abs(arb(float(found[i][k])) - exact[i])) / precision.ulp(size)
                if np.isnan(off[i, k]):
                    off[i, k] = 0.0 if _ends(form, point, precision) else math.inf
    return off


def compare(form: Form, arrays: list[Array], found: Array, precision: Precision = DOUBLE) -> Worst:
    """The largest of these, with its arguments."""
    worst: Worst = {name: (0.0, ()) for name, _ in form.results}
    _keep(worst, arrays, errors(form, arrays, found, precision))
    return worst


def _keep(worst: Worst, arrays: list[Array], off: Array) -> None:
    for (name, (most, _)), row in zip(list(worst.items()), off, strict=True):
        k = int(np.argmax(row))
        if row[k] > most:
            worst[name] = float(row[k]), tuple(float(a[k]) for a in arrays)

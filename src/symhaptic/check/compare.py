"""The worst error in units in the last place, its arguments, and simpler arguments with an error.

All points are compared with the package's own numbers, which takes little.  Exact values, in balls,
are computed beside boundaries, where the function differs most from these numbers, and at other
points.  Exact values alone decide what is wrong.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import flint
import numpy as np
from flint import arb

from symhaptic.check.checked import Checked, Point, exact
from symhaptic.check.points import Points, Range, drawn

Caller = Callable[[Sequence[Point]], list[Point]]

POINTS = 10_000
"""Points at which a function is called."""

_SECONDS = 5.0
"""Time that a function gets before it is called at fewer points."""

_PLAIN = 2.0
"""Time for the search of simpler arguments."""

_FIRST = 50
"""Points of the first call, and a third of those of the second, and so on."""

_TRIED = 10
"""Wrong truth values whose distance from the boundary is computed."""


@dataclass(frozen=True)
class Found:
    """What a comparison found; ``worst`` is infinite for NaN, and for what no rounding explains."""

    checked: Checked
    results: tuple[str, ...]
    """Those that the function gives."""
    ulp: float
    points: Points
    called: int
    """So many of the points the function was called at."""
    looked: tuple[tuple[int, Point, float], ...]
    """Numbers of the points that have exact values, with results and errors."""
    worst: float
    at: Point
    got: Point
    silent: frozenset[int]
    """Numbers of the points at which it wrongly gives "no answer", where this is allowed."""
    missing: tuple[Point, ...]
    """Where it gives NaN."""
    names: tuple[str, ...]

    @property
    def agrees(self) -> bool:
        """Whether no error is larger than is allowed."""
        return self.worst <= self.ulp


def compared(
    checked: Checked,
    call: Caller,
    ulp: float = 8,
    count: int | None = None,
    over: Range | None = None,
    explained: bool = True,
) -> Found:
    """Compare at ``count`` points; what is wrong is explained by a plainer point and a cause.

    Without a count there are ``POINTS``, or as many as the function computes in a few seconds.
    A function that gives the first of several results is held against these.
    """
    if not 0 <= ulp < math.inf:
        raise ValueError(f"ulp: {ulp} is not a finite number >= 0; give one")
    points = drawn(checked, count or (POINTS if checked.near else checked.balls), over)
    got = _called(call, points.all, math.inf if count else _SECONDS)
    given = _given(checked, got)
    nothing = (math.nan,) * given
    got = [g[:given] or nothing for g in got]
    places = _looked(checked, points, got)
    looked = [(i, got[i], error(checked, points.all[i], got[i])[0]) for i in places]
    silent = frozenset(
        i
        for i, g, off in looked
        if off > 0 and not points.ordinary[i] and _is_open(checked, points.all[i], g)
    )
    looked = [(i, g, -math.inf if i in silent else off) for i, g, off in looked]
    looked = _forgiven(checked, points, looked, ulp)
    place, last, most = max(looked, key=lambda one: one[2])
    if most < 0:
        raise ValueError(f"{checked.id} has no exact value at any of {len(got)} points")
    at = points.all[place]
    names: tuple[str, ...] = ()
    missing = tuple(p for p, g in zip(points.all, got, strict=False) if any(map(math.isnan, g)))
    if most > ulp and explained:
        from symhaptic.check.mistakes import named

        at, last = plainest(checked, call, (at, last), ulp, over or {})
        some = [i for i in range(len(got)) if points.ordinary[i]]
        names = named(checked, [points.all[i] for i in some], [got[i] for i in some], missing)
    results = checked.results[:given]
    count = len(got)
    return Found(
        checked, results, ulp, points, count, tuple(looked), most, at, last, silent, missing, names
    )


def _called(call: Caller, some: list[Point], seconds: float) -> list[Point]:
    """Results at the first points, in growing batches, until the time is used up."""
    found: list[Point] = []
    size, begin = _FIRST if seconds < math.inf else len(some), perf_counter()
    while len(found) < len(some):
        before = perf_counter()
        batch = some[len(found) : len(found) + size]
        found += call(batch)
        each = (perf_counter() - before) / len(batch)
        left = seconds - (perf_counter() - begin)
        size = 3 * size if each * 3 * size <= left else int(left / each) if left > 0 else 0
        if size < _FIRST:
            break
    return found


def _given(checked: Checked, got: list[Point]) -> int:
    """The number of results of the function at points where it gives any."""
    counts = [len(g) for g in got if g] or [len(checked.results)]
    given, most = min(counts), max(counts)
    if given != most:
        raise ValueError(
            f"the function gives {given} numbers at one point and {most} at another; "
            "give as many at every point"
        )
    if not 0 < given <= len(checked.results):
        names = ", ".join(checked.results)
        raise ValueError(f"the function gives {given} numbers; give {names}")
    return given


def _looked(checked: Checked, points: Points, got: list[Point]) -> list[int]:
    """Which points get exact values: beside boundaries, where it is farthest off, and others."""
    count = len(got)
    if count <= checked.balls:
        return list(range(count))
    mine = np.array(got, dtype=float)
    away = np.where(np.isnan(mine), np.inf, 0.0)
    if checked.near is not None:
        columns = [np.array(column) for column in zip(*points.all[:count], strict=True)]
        with np.errstate(all="ignore"):
            near = _stacked(columns, checked.near(*columns))[:, : mine.shape[1]]
            size = np.abs(near)
            if checked.scale is not None:
                scale = _stacked(columns, checked.scale(*columns))
                size = np.maximum(size, scale[:, : mine.shape[1]])
            away = np.abs(mine - near) / np.spacing(size)
            away[np.isnan(mine) ^ np.isnan(near) | np.isinf(mine) ^ np.isinf(near)] = np.inf
    order = np.argsort(-np.nan_to_num(away, nan=0.0, posinf=np.inf).max(axis=1), kind="stable")
    beside = np.flatnonzero(~np.isnan(points.distance[:count]))
    chosen = dict.fromkeys([*beside.tolist(), *order[: checked.balls // 2].tolist()])
    chosen |= dict.fromkeys(order[:: max(1, count // max(1, checked.balls // 2))].tolist())
    return list(chosen)


def _stacked(columns: list[Any], values: Sequence[Any]) -> Any:
    return np.stack(np.broadcast_arrays(columns[0], *values)[1:], axis=1).astype(float)


def error(checked: Checked, point: Point, got: Sequence[float]) -> tuple[float, str]:
    """The error of the worst result, and its name; -inf where none has an exact value."""
    worst = -math.inf, checked.results[0]
    rights, sizes = exact(checked, point)
    for name, value, right, size in zip(checked.results, got, rights, sizes, strict=False):
        off = _off(value, right, size)
        if math.isnan(value) and checked.refused(*point):
            off = -math.inf
        worst = max(worst, (off, name), key=lambda one: one[0])
    if checked.refutes and worst[0] == -math.inf and checked.refutes(point, got):
        return math.inf, checked.results[0]
    return worst


def _off(value: float, right: Any, size: float) -> float:
    """At least so many units; -inf where there is no exact value."""
    if right is None:
        return -math.inf
    if isinstance(right, int):  # a truth value, or a count
        return 0.0 if value == right else math.inf
    if right.is_nan():
        return -math.inf
    if not right.is_finite():
        infinite = math.inf if right > 0 else -math.inf if right < 0 else math.nan
        return -math.inf if math.isnan(infinite) else 0.0 if value == infinite else math.inf
    if not math.isfinite(value):
        return math.inf
    with flint.ctx.workprec(256):
        away = float((arb(value) - right).abs_lower())
    return away / math.ulp(max(abs(float(right.mid())), size))


# -- truth values and counts ---------------------------------------------------------------------


def _forgiven(
    checked: Checked, points: Points, looked: list[tuple[int, Point, float]], ulp: float
) -> list[tuple[int, Point, float]]:
    """Wrong truth values with the distance to the next point where they are right, in units.

    What rounding the arguments explains is told from what is wrong; those that a boundary is far
    from come first.
    """
    if checked.border is None:
        return looked
    far = points.distance
    wrong = [one for one in looked if one[2] == math.inf and math.isfinite(one[1][0])]
    wrong.sort(key=lambda one: -far[one[0]] if far[one[0]] == far[one[0]] else -math.inf)
    found = {one[0]: one[2] for one in looked}
    for n, (i, got, _) in enumerate(wrong):
        found[i] = distance(checked, points.all[i], got[0], ulp if n >= _TRIED else 0.0)
        if found[i] > (ulp if n >= _TRIED else 1e300):  # the others change nothing
            found |= {other: found[i] for other, *_ in wrong[n:]}
            break
    return [(i, got, found[i]) for i, got, _ in looked]


def distance(checked: Checked, point: Point, value: float, least: float = 0.0) -> float:
    """The smallest change of the arguments, in units of 2^-52, that makes a truth value right.

    Distances below ``least`` are told as this; infinite where a change of a tenth does not suffice.
    For the safe answer, "not stable", the gains of walls count as 1 at least, since the loop adds
    them to numbers of order 1.
    """
    units = [u for u in (1.0, 8.0, *(100.0**k for k in range(1, 8))) if u > least]
    least_size = 0.0 if value else 1.0
    seen = [exact(checked, point)[0][0]]
    for unit in [least, *units] if least else units:
        for other in _moved(checked, point, unit * 2.0**-52, least_size):
            seen += [v for v in exact(checked, other)[0] if v is not None]
            if min(seen) <= value <= max(seen):
                return unit
    return math.inf


def _moved(checked: Checked, point: Point, share: float, least: float) -> Iterator[Point]:
    """The point with the wall or one argument larger or smaller by a share."""
    at = dict(zip(checked.arguments, point, strict=True))
    wall = max(abs(at.get("alpha", 0.0)), abs(at.get("beta", 0.0)), least)
    for sign in (1, -1):
        scaled = {
            name: v * (1 + sign * share) for name, v in at.items() if name in ("alpha", "beta")
        }
        yield tuple((at | scaled).values())
        for name, value in at.items():
            size = wall if name in ("alpha", "beta") else abs(value)
            other = value + sign * share * size
            if other != value:
                yield tuple((at | {name: other}).values())


def plainest(
    checked: Checked,
    call: Caller,
    begin: tuple[Point, Point],
    ulp: float,
    over: Range,
    seconds: float = _PLAIN,
) -> tuple[Point, Point]:
    """The simplest arguments that are found, one after the other, at which the function is wrong.

    With what the function gives there.
    """
    point, last = begin
    before: Point = ()
    end = perf_counter() + seconds
    while before != point:
        before = point
        for i, (name, argument) in enumerate(checked.arguments.items()):
            low, high = over.get(name, (-math.inf, math.inf))
            values = [v for v in _plainer(point[i]) if low <= v <= high and argument.allows(v)]
            others = [(*point[:i], v, *point[i + 1 :]) for v in values]
            if perf_counter() > end or not others:
                continue
            try:
                got = [g[: len(last)] or (math.nan,) * len(last) for g in call(others)]
            except ValueError:  # what is wrong has been found
                return point, last
            wrong = (pair for pair in zip(others, got, strict=True) if _wrong(checked, *pair, ulp))
            point, last = next(wrong, (point, last))
    return point, last


def _is_open(checked: Checked, at: Point, got: Point) -> bool:
    """Whether this is "no answer" at a point where that is allowed."""
    return got[0] == checked.no_answer and checked.hard(*at)


def _wrong(checked: Checked, at: Point, got: Point, ulp: float) -> bool:
    if _is_open(checked, at, got):
        return False
    off, _ = error(checked, at, got)
    if off == math.inf and checked.border is not None and math.isfinite(got[0]):
        return distance(checked, at, got[0], ulp) > ulp
    return off > ulp


def _plainer(value: float) -> list[float]:
    """Values with fewer digits, the simplest first."""
    plain = [0.0, 1.0, 2.0, 0.5]
    plain += [10.0 ** math.floor(math.log10(abs(value)))] if value else []
    plain += [float(f"{value:.{n}g}") for n in range(1, 17)]
    plain = list(dict.fromkeys(plain))
    return plain[: plain.index(value)] if value in plain else plain

"""The worst error in units in the last place, where it is, and the plainest place where it is.

All points are compared with the package's own numbers, which takes little, and only where these
are farthest off, and at as many others, with balls.  Balls alone decide what is wrong.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import islice, product
from typing import Any

import flint
import numpy as np
from flint import arb

from symhaptic.bench.exact import bits
from symhaptic.check.callers import Caller
from symhaptic.check.checked import Checked

Point = tuple[float, ...]


@dataclass(frozen=True)
class Found:
    """What a comparison found; ``worst`` is infinite for NaN and for a wrong truth value."""

    checked: Checked
    ulp: float
    points: int
    looked: tuple[tuple[Point, Point, float], ...]
    """Points that were held against balls, with results and errors."""
    worst: float
    at: Point
    result: str
    got: Point
    right: tuple[str, ...]
    missing: tuple[Point, ...]
    """Where it gives NaN."""
    names: tuple[str, ...]

    @property
    def agrees(self) -> bool:
        """Whether no error is larger than is allowed."""
        return self.worst <= self.ulp


def points(checked: Checked, count: int, seed: int = 20) -> list[Point]:
    """Edges and hard values in all pairs first, then random ones inside."""
    ends = [_ends(checked, name) for name in checked.ranges]
    edges = [
        [v for v in dict.fromkeys((low, high, *hard)) if low <= v <= high]
        for (low, high), (*_, hard) in zip(ends, checked.ranges.values(), strict=True)
    ]
    found = list(islice(product(*edges), count // 2))
    rng = np.random.default_rng(seed)
    inside = [rng.uniform(*pair, count - len(found)) for pair in ends]
    for i, name in enumerate(checked.ranges):
        if name in checked.whole:
            inside[i] = np.round(inside[i])
    return found + list(zip(*(column.tolist() for column in inside), strict=True))


def _ends(checked: Checked, name: str) -> tuple[float, float]:
    """The least and the largest value of an argument, a whole number where it is one."""
    low, high, _ = checked.ranges[name]
    if name not in checked.whole:
        return low, high
    if math.ceil(low) > math.floor(high):
        raise ValueError(f"{name}: no whole number lies between {low} and {high}")
    return float(math.ceil(low)), float(math.floor(high))


def compared(checked: Checked, call: Caller, ulp: float, count: int) -> Found:
    """Compare at ``count`` points, and make the worst of them plainer where it stays wrong.

    A function that gives the first of several results is held against these.
    """
    if not 0 <= ulp < math.inf:
        raise ValueError(f"ulp: {ulp} is not allowed; finite numbers >= 0 are")
    some = points(checked, count)
    got, many = call(some), len(checked.results)
    given, most_given = min(map(len, got)), max(map(len, got))
    if given != most_given:
        raise ValueError(
            f"the function gives {given} numbers at one point and {most_given} at another; "
            "as many everywhere are allowed"
        )
    if not given or given > many:
        names = ", ".join(checked.results)
        raise ValueError(f"the function gives {given} numbers; {names} are allowed")
    checked = replace(checked, results=checked.results[:given])
    got = [g[:given] for g in got]
    places = _looked(checked, some, got)
    looked = [(some[i], got[i], off(checked, some[i], got[i])[0]) for i in places]
    at, last, most = max(looked, key=lambda one: one[2])
    if most < 0:
        raise ValueError(f"{checked.id} has no value that is told at any of {len(some)} points")
    wrong = most > ulp
    if wrong:
        at = plainest(checked, call, at, ulp)
        last = call([at])[0][:given]
    return Found(
        checked,
        ulp,
        len(some),
        tuple(looked),
        most,
        at,
        off(checked, at, last)[1],
        last,
        tuple(map(shown, exact(checked, at)[0])),
        tuple(p for p, g in zip(some, got, strict=True) if any(map(math.isnan, g))),
        _named(checked, some, got) if wrong else (),
    )


def _named(checked: Checked, some: list[Point], got: list[Point]) -> tuple[str, ...]:
    """Mistakes are read from the paper, which who is right need not wait for."""
    from symhaptic.check.mistakes import named

    return named(checked, some, got)


def _looked(checked: Checked, some: list[Point], got: list[Point]) -> list[int]:
    """Which points are held against balls: where it is farthest off, and as many others."""
    if len(some) <= checked.balls or checked.near is None:
        return list(range(0, len(some), max(1, len(some) // checked.balls)))
    columns = [np.array(column) for column in zip(*some, strict=True)]
    mine = np.array(got, dtype=float)
    with np.errstate(all="ignore"):
        near = np.stack(np.broadcast_arrays(*checked.near(*columns)), axis=1).astype(float)
        size = np.abs(near)
        if checked.scale:
            scale = np.broadcast_arrays(columns[0], *checked.scale(*columns))[1:]
            size = np.maximum(size, np.stack(scale, axis=1))
        near, size = near[:, : mine.shape[1]], size[:, : mine.shape[1]]
        away = np.abs(mine - near) / np.spacing(size)
    away[np.isnan(mine) & ~np.isnan(near)] = np.inf
    order = np.argsort(-np.nan_to_num(away, nan=0.0, posinf=np.inf).max(axis=1), kind="stable")
    half = checked.balls // 2
    others = order[half :: max(1, (len(order) - half) // half)][:half]
    return [int(i) for i in (*order[:half], *others)]


def off(checked: Checked, point: Point, got: Sequence[float]) -> tuple[float, str]:
    """The error of the worst result, and its name; -inf where none has a value that is told."""
    worst = -math.inf, checked.results[0]
    rights, sizes = exact(checked, point)
    for name, value, right, size in zip(checked.results, got, rights, sizes, strict=True):
        worst = max(worst, (_off(value, right, size), name), key=lambda one: one[0])
    return worst


def exact(checked: Checked, point: Point) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Exact results, and the sizes that their errors are measured by."""
    tiny = any(0 < abs(v) < 1e-12 for v in point)
    with flint.ctx.workprec(bits(point) if tiny else 256):
        found = checked.exact(*point)
    sizes = checked.scale(*point) if checked.scale else (0.0,) * len(found)
    given = len(checked.results)
    return found[:given], sizes[:given]


def _off(value: float, right: Any, size: float) -> float:
    """At least so many units; -inf where the formula has no value or balls do not tell it."""
    if right is None:
        return -math.inf
    if isinstance(right, bool):
        return 0.0 if value == right else math.inf
    if not right.is_finite():
        return -math.inf
    if not math.isfinite(value):
        return math.inf
    with flint.ctx.workprec(256):
        away = float((arb(value) - right).abs_lower())
    return away / math.ulp(max(abs(float(right.mid())), float(size)))


def shown(right: Any) -> str:
    """An exact value in 25 digits; ``None`` where it is not told."""
    return str(right) if isinstance(right, bool | None) else str(right.str(25, radius=False))


def plainest(checked: Checked, call: Caller, point: Point, ulp: float) -> Point:
    """The plainest arguments that are reached, one after the other, while it stays wrong."""
    before: Point = ()
    while before != point:
        before = point
        for i, (name, (low, high, _)) in enumerate(checked.ranges.items()):
            values = [v for v in _plainer(point[i], name in checked.whole) if low <= v <= high]
            others = [(*point[:i], v, *point[i + 1 :]) for v in values]
            got = call(others) if others else []
            wrong = (
                other
                for other, g in zip(others, got, strict=True)
                if off(checked, other, g[: len(checked.results)])[0] > ulp
            )
            point = next(wrong, point)
    return point


def _plainer(value: float, whole: bool) -> list[float]:
    """Values with less to read, the plainest first."""
    plain = [0.0, 1.0, 2.0, 0.5]
    plain += [10.0 ** math.floor(math.log10(abs(value)))] if value else []
    plain += [float(f"{value:.{n}g}") for n in range(1, 17)]
    plain = [v for v in dict.fromkeys(plain) if not whole or v.is_integer()]
    return plain[: plain.index(value)] if value in plain else plain

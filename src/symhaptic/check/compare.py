"""The worst error in units in the last place, where it is, and which mistake it may be."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import islice, product
from typing import Any

import flint
from flint import arb

from symhaptic.check.callers import Caller, Points
from symhaptic.check.formulas import Checked

_BITS = 2400
"""Enough for exponentials of the smallest arguments, 1e-300."""


@dataclass(frozen=True)
class Found:
    """What a comparison found; ``worst`` is infinite for NaN and for a wrong truth value."""

    points: int
    worst: float
    at: tuple[float, ...]
    result: str
    got: tuple[float, ...]
    missing: int
    names: tuple[str, ...]


def points(checked: Checked, count: int, seed: int = 20) -> list[tuple[float, ...]]:
    """Edges and hard values in all pairs first, then random ones inside."""
    rng = random.Random(seed)
    edges = [
        [v for v in dict.fromkeys((low, high, *hard)) if low <= v <= high]
        for low, high, hard in checked.ranges.values()
    ]
    found = list(islice(product(*edges), count // 2))
    while len(found) < count:
        point = []
        for name, (low, high, _) in checked.ranges.items():
            value = rng.uniform(low, high)
            point.append(float(round(value)) if name in checked.whole else value)
        found.append(tuple(point))
    return found


def compared(checked: Checked, call: Caller, ulp: float, count: int) -> Found:
    """Compare at ``count`` points, and make the worst of them simpler where it stays wrong.

    A function that gives the first of several results is held against these.
    """
    some = points(checked, count)
    got, many = call(some), len(checked.results)
    given = min(map(len, got))
    if not given or max(map(len, got)) > many:
        raise ValueError(f"gives {max(map(len, got))} numbers; {', '.join(checked.results)} are")
    checked = replace(checked, results=checked.results[:given])
    got = [g[:given] for g in got]
    offs = [off(checked, p, g) for p, g in zip(some, got, strict=True)]
    k = max(range(len(offs)), key=lambda i: offs[i][0])
    at = some[k]
    if offs[k][0] > ulp:
        at = simpler(checked, call, at, ulp)
    last = call([at])[0][:given]
    worst, result = off(checked, at, last)
    missing = sum(any(map(math.isnan, g)) for g in got)
    names = named(checked, some, got, missing) if offs[k][0] > ulp else ()
    return Found(len(some), max(worst, offs[k][0]), at, result, last, missing, names)


def off(checked: Checked, point: tuple[float, ...], got: Sequence[float]) -> tuple[float, str]:
    """The error of the worst result, and its name."""
    exact, sizes = _exact(checked, point)
    worst = 0.0, checked.results[0]
    for name, value, right, size in zip(checked.results, got, exact, sizes, strict=True):
        worst = max(worst, (_off(value, right, size), name))
    return worst


def _exact(checked: Checked, point: tuple[float, ...]) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    tiny = any(0 < abs(v) < 1e-12 for v in point)
    with flint.ctx.workprec(_BITS if tiny else 256):
        exact = checked.exact(*point)
    sizes = checked.scale(*point) if checked.scale else (0.0,) * len(exact)
    given = len(checked.results)
    return exact[:given], sizes[:given]


def _off(value: float, right: Any, size: float) -> float:
    if right is None:
        return 0.0
    if isinstance(right, bool):
        return 0.0 if bool(value) is right and not math.isnan(value) else math.inf
    if not right.is_finite():
        return 0.0
    if not math.isfinite(value):
        return math.inf
    with flint.ctx.workprec(256):
        return float(abs(arb(value) - right)) / math.ulp(max(abs(float(right)), size))


def simpler(
    checked: Checked, call: Caller, point: tuple[float, ...], ulp: float
) -> tuple[float, ...]:
    """Round and plain values for one argument after the other, as long as it stays wrong."""
    for i, (low, high, _) in enumerate(checked.ranges.values()):
        for value in (0.0, 1.0, 2.0, *(float(f"{point[i]:.{n}g}") for n in (1, 2, 4))):
            if not low <= value <= high:
                continue
            other = (*point[:i], value, *point[i + 1 :])
            if off(checked, other, call([other])[0][: len(checked.results)])[0] > ulp:
                point = other
                break
    return point


def named(
    checked: Checked, some: Points, got: Sequence[Sequence[float]], missing: int
) -> tuple[str, ...]:
    """Mistakes that give what was found at most points, and at more than the formula itself."""
    few = list(zip(some, got, strict=True))[:: max(1, len(some) // 500)]
    right = _near(checked.exact, few, 1e-5)
    shares = {name: _near(exact, few, 1e-6) for name, exact in checked.mistakes.items()}
    names = [name for name, share in shares.items() if share > max(_MOST, right)]
    if right > _MOST and _single(few):
        names.append("single precision: every result is a float32")
    if missing and checked.naught and not names:
        names.append(checked.naught)
    return tuple(names)


_MOST = 0.7
"""Of the values; a misprint, too, loses its digits at some points."""


def _single(few: Sequence[tuple[tuple[float, ...], Sequence[float]]]) -> bool:
    values = [v for _, g in few for v in g if math.isfinite(v) and abs(v) < 1e38]
    return bool(values) and all(v == 0 or math.frexp(v)[0] * 2**24 % 1 == 0 for v in values)


def _near(exact: Any, few: Sequence[tuple[tuple[float, ...], Sequence[float]]], by: float) -> float:
    """The share of values that are near: a guess at the cause, and no verdict."""
    told = near = 0
    for point, got in few:
        with flint.ctx.workprec(256):
            for value, right in zip(got, exact(*point), strict=False):
                if isinstance(right, bool):
                    told += 1
                    near += bool(value) is right
                elif right is not None and right.is_finite() and math.isfinite(value):
                    wanted = float(right)
                    told += 1
                    near += abs(value - wanted) <= by * max(abs(wanted), 1e-12)
    return near / told if told else 0.0

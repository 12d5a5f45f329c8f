"""Where a function is called: ordinary, wide and special arguments, and both sides of boundaries.

All are drawn with one seed, in an order that makes the first of them a sample of all.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import flint
import numpy as np
from numpy.typing import NDArray

from symhaptic.check.checked import Argument, Checked, Point, exact
from symhaptic.notation.sizes import LARGEST

Array = NDArray[np.float64]
Range = Mapping[str, tuple[float, float]]

DISTANCES = tuple(10.0**-k for k in range(3, 13))
"""Relative distances from a boundary."""

_SHARES = {"ordinary": 0.3, "wide": 0.3, "special": 0.4}
_BORDER = 0.12
"""Share of the points that lie beside a boundary, where there is one."""
_MOST_BORDER = 1000

_NEXT = np.array([0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-8, 1e-6, -1e-4, 1e-3])
"""Relative distances from a special place."""


@dataclass(frozen=True)
class Points:
    """Points, which of them are ordinary, and how far those beside a boundary are from it."""

    all: list[Point]
    ordinary: NDArray[np.bool_]
    distance: Array
    """NaN for a point that is not beside a boundary."""


def not_in(argument: Argument, low: float, high: float) -> str:
    """Why an argument has no values in a range, or not all of them; empty where it has."""
    if argument.whole and math.ceil(low) > math.floor(high):
        return "has no whole number in it; give another range"
    if not all(map(replace(argument, whole=False).allows, (low, high))):
        least = "> 0" if argument.low else ">= 0"
        most = f" and <= {argument.top}" if argument.top < math.inf else ""
        return f"has numbers that are not allowed; give a range of numbers {least}{most}"
    if max(-low, high) > LARGEST:
        return f"has numbers that are too large; give a range up to {LARGEST:g}"
    return ""


def drawn(checked: Checked, count: int, over: Range | None = None, seed: int = 20) -> Points:
    """So many points of a function, with some arguments in narrower ranges."""
    rng = np.random.default_rng(seed)
    over = over or {}
    for name, ends in over.items():
        if why := not_in(checked.arguments[name], *ends):
            raise ValueError(f"{name}: {ends[0]} to {ends[1]} {why}")
    kinds = rng.choice(list(_SHARES), count, p=list(_SHARES.values()))
    columns = _columns(checked, rng, kinds, over)
    distance = np.full(count, math.nan)
    if checked.border is not None:
        rows, far = _beside(checked, rng, columns, min(int(_BORDER * count), _MOST_BORDER), over)
        if len(rows):  # none where the ranges have no boundary
            columns[: len(rows)], distance[: len(rows)] = rows, far
            kinds[: len(rows)] = "border"
    order = rng.permutation(count)
    rows = columns[order].tolist()
    return Points([tuple(row) for row in rows], (kinds == "ordinary")[order], distance[order])


def _columns(checked: Checked, rng: Any, kinds: Any, over: Range) -> Array:
    at = {name: _values(name, arg, rng, kinds) for name, arg in checked.arguments.items()}
    _together(at, rng, kinds != "ordinary")
    at = checked.derived(at)
    for name, argument in checked.arguments.items():
        if name in over:
            low, high = over[name]
            inside = rng.uniform(low, high, kinds.size)
            if name == "d":
                inside = np.where(rng.random(kinds.size) < 0.5, np.floor(inside), inside)
            inside = np.clip(inside, low, high)
            ends = np.where(rng.random(kinds.size) < 0.5, low, high)
            inside = np.where(rng.random(kinds.size) < 0.1, ends, inside)
            at[name] = np.where((at[name] >= low) & (at[name] <= high), at[name], inside)
        if argument.whole:
            least, most = over.get(name, (0.0, math.inf))
            at[name] = np.clip(np.floor(at[name]), math.ceil(least), math.floor(min(most, 1e300)))
    return np.stack([at[name] for name in checked.arguments], axis=1) + 0.0


def _values(name: str, argument: Argument, rng: Any, kinds: Any) -> Array:
    """Values of one argument: each kind of point has its own."""
    count = kinds.size
    ordinary = rng.uniform(argument.low, argument.high, count)
    wide = 10 ** rng.uniform(math.log10(argument.least), math.log10(argument.most), count)
    special = rng.choice(argument.special, count)
    if name == "d":
        some = rng.random(count) < 0.5
        ordinary = np.where(some, np.round(ordinary), ordinary)
        wide = 10 ** rng.uniform(0, math.log10(argument.most), count)
        wide = np.where(rng.random(count) < 0.5, np.floor(wide), wide)
        near = np.floor(np.where(some, rng.uniform(0, 9, count), wide))
        near = np.where(near < 1e10, near, np.floor(rng.uniform(1, 100, count)))
        near = near + rng.choice([*_NEXT, 0.5], count)
        special = np.where(rng.random(count) < 0.2, special, np.maximum(near, 0.0))
    if name == "theta":
        near = argument.most - 10 ** rng.uniform(-9, -1, count)
        special = np.where(rng.random(count) < 0.5, near, wide)
    if argument.signed:
        ordinary, wide = ordinary * _signs(rng, count), wide * _signs(rng, count)
        special = special * _signs(rng, count)
    mixed = np.select([(pick := rng.random(count)) < 0.5, pick < 0.75], [special, ordinary], wide)
    return np.select([kinds == "ordinary", kinds == "wide"], [ordinary, wide], mixed)


def _signs(rng: Any, count: int) -> Array:
    return np.where(rng.random(count) < 0.3, -1.0, 1.0)


def _together(at: dict[str, Any], rng: Any, some: Any) -> None:
    """Arguments that are special together."""
    pick, count = rng.random(some.size), some.size
    near = 1 + rng.choice(_NEXT, count)
    if {"gamma", "delta"} <= at.keys():
        gamma, delta = at["gamma"], at["delta"]
        swings = (np.pi * np.minimum(np.floor(10 ** rng.uniform(0, 1.5, count)), 9)) ** 2
        hardly = np.where(rng.random(count) < 0.3, 0.0, 10 ** rng.uniform(-12, -2, count))
        critical, turning = some & (pick < 0.15), some & (pick >= 0.15) & (pick < 0.3)
        at["gamma"] = np.select(
            [critical, turning], [delta**2 / 4 * near, (swings + hardly**2 / 4) * near], gamma
        )
        at["delta"] = np.where(turning, hardly, delta)
    if {"theta", "d"} <= at.keys():  # half turns of the delay, and the first of them
        turn = np.pi / (at["d"] + 1)
        many = np.ceil(rng.uniform(0, 1, count) * np.minimum(at["d"] + 1, 4))
        theta = np.select(
            [pick < 0.4, pick < 0.7],
            [turn * rng.uniform(0, 1, count), turn * many * near],
            at["theta"],
        )
        theta = np.where(some | (at["d"] > 8), theta, at["theta"])
        at["theta"] = np.clip(theta, 1e-16, math.pi - 1e-9)
    if {"theta", "gamma"} <= at.keys():
        swing = np.sqrt(at["gamma"])
        here = some & (rng.random(count) < 0.1) & (swing > 1e-9) & (swing < 3.1)
        at["theta"] = np.where(here, swing * near, at["theta"])
    if {"alpha", "gamma"} <= at.keys():  # the left bound, where a root lies at 1
        here = some & (rng.random(count) < 0.05)
        at["alpha"] = np.where(here, -at["gamma"] * near, at["alpha"])


def _beside(
    checked: Checked, rng: Any, columns: Array, count: int, over: Range
) -> tuple[list[Point], list[float]]:
    """Pairs of points on both sides of a boundary, whose exact values differ."""
    names = list(checked.arguments)
    rows: list[Point] = []
    far: list[float] = []
    distances = [distance for distance in DISTANCES if distance > checked.nearest]
    for i, row in enumerate(columns.tolist()):
        if len(rows) + 1 >= count:
            break
        distance = distances[len(rows) // 2 % len(distances)]
        try:
            with flint.ctx.workprec(256):
                pair = checked.border(rng, distance, *row) if checked.border else []
        except ArithmeticError:
            continue
        inside = all(
            checked.arguments[name].allows(v) and low <= v <= high
            for point in pair
            for name, v in zip(names, point, strict=True)
            for low, high in (over.get(name, (-math.inf, math.inf)),)
        )
        if len(pair) == 2 and inside:
            values = [exact(checked, point)[0][0] for point in pair]
            if None not in values and values[0] != values[1]:
                rows += pair
                far += [distance] * 2
        if i > 4 * count:
            break
    return rows, far

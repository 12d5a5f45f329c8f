"""What the points of a comparison cover, and what they do not."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from symhaptic.check.checked import Checked
from symhaptic.check.compare import Found

_CLOSE = 1e-3


def _beside_multiple(gamma: Any, delta: Any) -> Any:
    swing = np.sqrt(np.maximum(gamma - delta**2 / 4, 0)) / np.pi
    return (swing > 0.5) & (abs(swing - np.round(swing)) <= _CLOSE * swing)


_KINDS: tuple[tuple[str, str, Callable[..., Any]], ...] = (
    ("no delay", "d", lambda d: d == 0),
    ("whole delays", "d", lambda d: (d > 0) & (d == np.floor(d))),
    ("fractional delays", "d", lambda d: d != np.floor(d)),
    ("delays next to a whole number", "d",
     lambda d: (d != np.floor(d)) & (abs(d - np.round(d)) <= _CLOSE)),
    ("delays above 100 periods", "d", lambda d: d > 100),
    ("no spring", "gamma", lambda gamma: gamma == 0),
    ("springs with omega T > pi", "gamma", lambda gamma: gamma > np.pi**2),
    ("no damping", "delta", lambda delta: delta == 0),
    ("dampings below 1e-6", "delta", lambda delta: (delta > 0) & (delta < 1e-6)),
    ("dampings next to critical", "gamma delta",
     lambda gamma, delta: (gamma > 0) & (abs(delta**2 - 4 * gamma) <= _CLOSE * 4 * gamma)),
    ("omega_d T next to a multiple of pi", "gamma delta", _beside_multiple),
    ("angles below 0.001", "theta", lambda theta: theta < _CLOSE),
    ("angles next to pi", "theta", lambda theta: theta > np.pi - _CLOSE),
    ("negative stiffnesses of the wall", "alpha", lambda alpha: alpha < 0),
    ("negative dampings of the wall", "beta", lambda beta: beta < 0),
)  # fmt: skip
"""Kinds of points: words, arguments and a condition."""


@dataclass(frozen=True)
class Covered:
    """Ranges of the arguments, numbers of points, and what is not covered."""

    ranges: dict[str, tuple[float, float]]
    kinds: dict[str, int]
    beside: dict[str, int]
    """Points at each relative distance from a boundary, with different exact values in pairs."""
    missing: tuple[str, ...]


def covered(found: Found) -> Covered:
    """What the points cover at which the function was called."""
    checked = found.checked
    columns = np.array(found.points.all[: found.called]).T
    at = dict(zip(checked.arguments, columns, strict=True))
    ranges = {name: (float(v.min()), float(v.max())) for name, v in at.items()}
    kinds = {
        words: int(inside(*(size[name] for name in names.split())).sum())
        for size in (_sizes(at),)
        for words, names, inside in _KINDS
        if size.keys() >= set(names.split()) and _may(checked, words)
    }
    seen = {i for i, _, _ in found.looked}
    far = [d for i, d in enumerate(found.points.distance[: found.called]) if i in seen and d == d]
    beside = {f"{d:.0e}": far.count(d) for d in sorted(set(far))}
    missing = [*checked.open, *(words for words, count in kinds.items() if not count)]
    if unknown := sum(error == -math.inf for *_, error in found.looked):
        missing.append(f"{unknown} points of which no exact value is known")
    if found.called < found.asked:
        missing.append(
            f"{found.asked - found.called} of {found.asked} points: the function is slow"
        )
    return Covered(ranges, {k: v for k, v in kinds.items() if v}, beside, tuple(missing))


def _may(checked: Checked, words: str) -> bool:
    """Whether there are such points of the function."""
    delay, spring = checked.arguments.get("d"), checked.arguments.get("gamma")
    whole = delay is not None and delay.whole and words.startswith(("fract", "delays next"))
    soft = spring is not None and spring.most < 9 and "omega" in words
    return not whole and not soft


def _sizes(at: dict[str, Any]) -> dict[str, Any]:
    """The arguments, and those in SI units as numbers without unit."""
    found = dict(at)
    if {"m", "T"} <= at.keys():
        found["gamma"], found["delta"] = (
            at["k"] * at["T"] ** 2 / at["m"],
            at["b"] * at["T"] / at["m"],
        )
    if "omega" in at:
        found["theta"] = at["omega"] * at["T"]
    return found

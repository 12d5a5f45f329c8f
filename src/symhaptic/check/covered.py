"""What the points of a comparison cover, and what they do not."""

from __future__ import annotations

import math
from collections.abc import Callable
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
    ("integer delays", "d", lambda d: (d > 0) & (d == np.floor(d))),
    ("fractional delays", "d", lambda d: d != np.floor(d)),
    ("delays next to an integer", "d",
     lambda d: (d != np.floor(d)) & (abs(d - np.round(d)) <= _CLOSE)),
    ("delays above 100 periods", "d", lambda d: d > 100),
    ("no device stiffness", "gamma", lambda gamma: gamma == 0),
    ("natural frequencies above pi/T", "gamma", lambda gamma: gamma > np.pi**2),
    ("no device damping", "delta", lambda delta: delta == 0),
    ("device damping below 1e-6", "delta", lambda delta: (delta > 0) & (delta < 1e-6)),
    ("damping next to critical", "gamma delta",
     lambda gamma, delta: (gamma > 0) & (abs(delta**2 - 4 * gamma) <= _CLOSE * 4 * gamma)),
    ("omega_d T next to a multiple of pi", "gamma delta", _beside_multiple),
    ("angles below 0.001", "theta", lambda theta: theta < _CLOSE),
    ("angles next to pi", "theta", lambda theta: theta > np.pi - _CLOSE),
    ("negative wall stiffness", "alpha", lambda alpha: alpha < 0),
    ("negative wall damping", "beta", lambda beta: beta < 0),
)  # fmt: skip
"""Kinds of points: words, arguments and a condition."""


def covered(found: Found) -> dict[str, Any]:
    """Ranges of the arguments, numbers of points by kind, and what is missing.

    ``beside`` has the number of points at each relative distance from a boundary.
    """
    checked, asked = found.checked, len(found.points.all)
    columns = np.array(found.points.all[: found.called]).T
    at = dict(zip(checked.arguments, columns, strict=True))
    sizes = _sizes(at)
    kinds = {
        words: int(inside(*(sizes[name] for name in names.split())).sum())
        for words, names, inside in _KINDS
        if sizes.keys() >= set(names.split()) and _may(checked, words)
    }
    seen = {i for i, _, _ in found.looked}
    far = [d for i, d in enumerate(found.points.distance[: found.called]) if i in seen and d == d]
    missing = [*checked.open, *(words for words, count in kinds.items() if not count)]
    known = [i in found.silent or error > -math.inf for i, _, error in found.looked]
    if unknown := known.count(False):
        missing.append(f"{unknown} points of which no exact value is known")
    if found.silent:
        told = f'{checked.no_answer:g} was accepted for "not known"'
        missing.append(f"points at which {told}: {len(found.silent)}")
    if found.called < asked:
        missing.append(f"{asked - found.called} of {asked} points: the function is slow")
    return {
        "ranges": {name: (float(v.min()), float(v.max())) for name, v in at.items()},
        "kinds": {words: count for words, count in kinds.items() if count},
        "beside": {f"{d:.0e}": far.count(d) for d in sorted(set(far))},
        "missing": missing,
    }


def _may(checked: Checked, words: str) -> bool:
    """Whether there are such points of the function: fractional delays are none of a whole one."""
    delay = checked.arguments.get("d")
    return delay is None or not delay.whole or not words.startswith(("fract", "delays next"))


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

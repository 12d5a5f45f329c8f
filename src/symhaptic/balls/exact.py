"""Exact values of each function, and their derivatives, in ball arithmetic."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from flint import arb, arb_series

from symhaptic.balls import closed, implicit

EXACT: dict[str, Callable[..., tuple[Any, ...]]] = {
    "discretize": closed.device,
    "discretize_fractional": lambda gamma, delta, epsilon: closed.delayed(gamma, delta, epsilon),
    "characteristic_polynomial": closed.polynomial,
    "stability_boundary": closed.boundary,
    "passivity_margin_at": closed.margin,
    "passivity_boundary": implicit.just_passive,
    "max_passive_stiffness": implicit.max_passive,
    "linear_limit": closed.line,
    "passivity_margin": implicit.passivity_margin,
    "max_stable_stiffness": implicit.max_stable,
}


def slopes(name: str, point: dict[str, float], by: str) -> tuple[Any, ...]:
    """The derivatives of all results of a function with respect to one argument.

    The angle of a maximum may be held still (envelope theorem).
    """
    at = {n: arb_series([arb(v), arb(1)], 2) if n == by else arb(v) for n, v in point.items()}
    if name == "passivity_margin":
        if point["alpha"] < 0:
            return (arb("nan"),)
        wall = point["alpha"], point["beta"], point["d"]
        found = closed.margin(implicit.largest_required_damping(*wall)[1], **at)
    elif name == "max_stable_stiffness":
        angle = EXACT[name](**point)[2]
        found = closed.boundary(angle, **at)[:1] if angle.is_finite() else (angle,)
    else:
        found = EXACT[name](**at)
    return tuple(map(_slope, found))


def _slope(x: Any) -> Any:
    """The first derivative; NaN stays NaN."""
    if isinstance(x, arb_series):
        return x[1]
    return arb(0) if x.is_finite() else x


def bits(point: Sequence[float]) -> int:
    """Enough for exponentials of the largest and cubes of the smallest argument."""
    small = max([0.0, *(-math.log2(abs(v)) for v in point if v)])
    large = max(min(abs(v), 700.0) for v in point)
    return int(200 + 3 * small + 7 * large)

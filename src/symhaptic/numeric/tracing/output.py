"""A stable region as text for other programs."""

from __future__ import annotations

import json
from typing import Any

from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.tracing.region import Region


def csv_text(region: Region) -> str:
    """One row per point of the outline: number of its ring, alpha, beta; all digits."""
    rows = ["ring,alpha,beta"]
    for number, ring in enumerate(region.outline):
        rows += [f"{number},{float(alpha)!r},{float(beta)!r}" for alpha, beta in ring]
    return "\n".join(rows) + "\n"


def json_text(region: Region) -> str:
    """Everything that is known of the region; an angle is null where only a real root is."""
    loop = region.loop
    content: dict[str, Any] = {
        "gamma": loop.gamma,
        "delta": loop.delta,
        "delay": loop.delay,
        "sheet": loop.sheet,
        "area": region.area,
        "error": region.error,
        "touches_left_bound": region.touches_left_bound,
        "max_stiffness": _extremum(region.max_stiffness),
        "max_damping": _extremum(region.max_damping),
        "min_damping": _extremum(region.min_damping),
        "corners": region.corners.tolist(),
        "outline": [ring.tolist() for ring in region.outline],
    }
    return json.dumps(content, indent=1, allow_nan=False) + "\n"


def _extremum(point: Extremum) -> dict[str, float | None]:
    values = {name: float(value) for name, value in point._asdict().items()}
    return {name: value if value == value else None for name, value in values.items()}

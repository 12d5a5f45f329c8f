"""The walls that no spring destabilises, up to the Nyquist frequency."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import shapely

from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.containers import numbers_only
from symhaptic.numeric.stability import SHEETS
from symhaptic.numeric.tracing.region import Region, stable_region
from symhaptic.numeric.tracing.shape import Shape

_PER_TURN = 8
"""Springs per half turn of z^(d+1) to begin with."""

_NEAR_NYQUIST = 0.5 ** np.arange(1, 8)
"""Parts of the last step, before its end, at which springs are tried, too: the plant's numerator
changes quickly there, and the middle of the step may cut nothing."""

_ROUNDS = 20
"""Halvings of the steps between springs at most."""


@dataclass(frozen=True)
class RobustRegion(Shape):
    """The walls (alpha, beta) that are stable for all springs tried up to the Nyquist frequency."""

    delta: float
    delay: float
    sheet: str
    polygon: Any
    """Shapely's polygon or polygons."""
    springs: Array = field(compare=False)
    """The stiffnesses gamma whose stable regions were intersected, rising."""
    error: float
    """Estimate of how far the outline may be off."""


@numbers_only
def robust_region(
    delta: float, delay: float, sheet: str = "exact", tolerance: float = 1e-3
) -> RobustRegion:
    r"""The walls that are stable for every spring 0 <= gamma <= pi^2 + delta^2/4.

    The intersection of the stable regions of all springs, (30) of the paper: ``delta`` >= 0,
    ``delay`` >= 0 periods.  Springs are inserted in the middle between two neighbours, in terms of
    the angle sqrt(gamma - delta^2/4), until this moves the outline by less than ``tolerance`` of
    its extent; where every insertion moves it by about a quarter of the one before, the rest is
    less than the last move.  No proof stands behind the springs between those tried: keep away from
    the outline by ``error``, which is an estimate, or take the walls that ``Scene.safe_walls``
    proves for a range of arms.

    Without damping there is no such wall (proved for whole and half delays in chapter s5c_robust,
    no other was found), and the polygon is empty.

    Raises :class:`ValueError` for an impossible damping, delay or tolerance, and where
    :func:`stable_region` does.

    >>> region = robust_region(0.02, 0)  # a triangle for d = 0; passive walls fill 0.0008 of it
    >>> region.area > 0.0008, len(region.outline)
    (True, 1)
    """
    arguments.one_of("sheet", sheet, SHEETS)
    numbers = {}
    for name, value in (("delta", delta), ("delay", delay)):
        array = (arguments.periods if name == "delay" else arguments.nonnegative)(name, value)
        arguments.refuse(name, array, np.isnan(array), f"finite numbers {name} >= 0 are")
        numbers[name] = arguments.single(name, array)
    delta, delay = numbers["delta"], numbers["delay"]
    tolerance = arguments.one("tolerance", tolerance)
    if not 1e-6 <= tolerance < 1:
        raise ValueError(f"tolerance: {tolerance!r} is not allowed; 1e-6 <= tolerance < 1 is")
    if delta == 0:
        nothing = np.array([0.0, np.pi**2])
        return RobustRegion(0.0, float(delay), sheet, shapely.Polygon(), nothing, 0.0)
    # a region of the size of delta, cut out of regions of the size of 10
    fine = float(np.clip(1e-2 * tolerance * delta, 1e-12, 1e-3))

    def region(angle: float) -> Region:
        return stable_region(_spring(angle, delta), delta, delay, sheet, fine)

    count = int(np.ceil(_PER_TURN * (delay + 1)))
    regions = [region(-delta / 2)]  # which refuses too long a delay
    creeping = np.linspace(0, min(np.pi, delta / 2), count + 1) - delta / 2
    near = np.pi * (1 - _NEAR_NYQUIST / count)
    angles = [*creeping[creeping < 0], *np.linspace(0, np.pi, count + 1)[:-1], *near, np.pi]
    regions += [region(angle) for angle in angles[1:]]
    shape = _common([r.polygon for r in regions])
    error = max(r.error for r in regions)
    gaps = list(itertools.pairwise(angles))
    for _ in range(_ROUNDS):
        if shape.is_empty or not gaps:
            break
        middles = [(low + high) / 2 for low, high in gaps]
        cuts = [region(middle) for middle in middles]
        moves = [_moved(shape, _common([shape, cut.polygon])) for cut in cuts]
        fresh = _common([shape, *(cut.polygon for cut in cuts)])
        move, shape = _moved(shape, fresh), fresh
        angles += middles
        if move <= tolerance * _extent(shape) / 2:
            error += move
            break
        gaps = [
            half
            for (low, high), middle, cut in zip(gaps, middles, moves, strict=True)
            if cut > tolerance * _extent(shape) / 8
            for half in ((low, middle), (middle, high))
        ]
    springs = np.array([_spring(angle, delta) for angle in sorted(angles)])
    return RobustRegion(float(delta), float(delay), sheet, shape, springs, error)


def _spring(angle: float, delta: float) -> float:
    """gamma of a swing by ``angle`` per period; below 0 the plant creeps."""
    return max(delta**2 / 4 + angle * abs(angle), 0.0)


def _common(polygons: list[Any]) -> Any:
    """The intersection, without the points and lines in which regions only touch."""
    shape = polygons[0]
    for polygon in polygons[1:]:
        shape = shape.intersection(polygon)
    parts = [p for p in getattr(shape, "geoms", [shape]) if p.area > 0]
    return shapely.unary_union(parts) if parts else shapely.Polygon()


def _moved(before: Any, after: Any) -> float:
    """How far the outline has moved."""
    return float(before.hausdorff_distance(after)) if not after.is_empty else _extent(before)


def _extent(shape: Any) -> float:
    """Diagonal of the box around a shape."""
    left, low, right, high = shape.bounds
    return float(np.hypot(right - left, high - low))

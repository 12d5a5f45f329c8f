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
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.arcs import Loop
from symhaptic.numeric.tracing.region import NotTraced, stable_region
from symhaptic.numeric.tracing.shape import Shape
from symhaptic.numeric.tracing.sides import chords

_PER_TURN = 8
"""Springs per half turn of z^(d+1) to begin with."""

_NEAR_NYQUIST = 0.5 ** np.arange(1, 8)
"""Parts of the last step, before its end, at which springs are tried, too: the plant's numerator
changes quickly there, and the middle of the step may cut nothing."""

_ROUNDS = 20
"""Halvings of the steps between springs at most."""

_LONGEST = 100
"""Periods of delay at most."""


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
    """The walls that are stable for every spring 0 <= gamma <= pi^2 + delta^2/4.

    Parameters
    ----------
    delta : float
        Physical damping b T/m, >= 0.
    delay : float
        Delay in sampling periods, 0 to 100.  Long delays take about ten seconds.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay, as for :func:`stable_region`.
    tolerance : float, optional
        Distance of the outline from the boundary, in units of the region's extent, from 1e-6 to 1.

    Returns
    -------
    RobustRegion
        With ``outline``, ``area``, ``contains``, ``springs`` (the stiffnesses that were tried) and
        ``error``, an estimate of how far the outline may be off.  Empty without damping.

    Raises
    ------
    ValueError
        If an argument is out of its range, or if pieces of a boundary are missed: for some dampings
        below 1e-8, and as in :func:`stable_region`.

    Notes
    -----
    The region is the intersection of the stable regions of all springs, (30) of the paper.  Springs
    are inserted halfway between two neighbours (of the angle sqrt(gamma - delta^2/4)) until
    this moves the outline by less than ``tolerance`` of its extent.  If each insertion moves it by
    about a quarter of the previous move, the remaining error is below the last move.

    Springs between the sampled ones are not proved.  Keep a distance of ``error`` from the outline,
    or use the walls that ``Scene.safe_walls`` proves for a range of arms.

    That no wall is robust without damping is proved in chapter s5c_robust for integer delays and
    half periods; for other delays no such wall was found.

    Examples
    --------
    >>> region = robust_region(0.02, 0)  # a triangle for d = 0; passive walls fill 0.0008 of it
    >>> region.area > 0.0008, len(region.outline)
    (True, 1)
    """
    arguments.check_sheet(sheet)
    delta, delay = arguments.of_loop("delta", delta), arguments.of_loop("delay", delay)
    if delay > _LONGEST:
        raise ValueError(
            f"delay: {delay!r} is not allowed; give at most {_LONGEST} periods: each further "
            "period adds springs that have to be computed"
        )
    tolerance = arguments.one("tolerance", tolerance)
    if not 1e-6 <= tolerance < 1:
        raise ValueError(f"tolerance: {tolerance!r} is not allowed; give 1e-6 <= tolerance < 1")
    if delta == 0:
        nothing = np.array([0.0, np.pi**2])
        return RobustRegion(0.0, float(delay), sheet, shapely.Polygon(), nothing, 0.0)
    _, low, right, high = stable_region(0.0, delta, delay, sheet, 1e-3).polygon.bounds

    def cut(shape: Any, angle: float) -> Any:
        loop = Loop(_spring(angle, delta), delta, delay, sheet)
        found = _held(shape, loop, tolerance / 100)
        if found.is_empty:  # which it never is: passive walls are in it
            raise NotTraced(loop)
        return found

    count = int(np.ceil(_PER_TURN * (delay + 1)))
    slow = min(np.pi, delta / 2)
    creeping = np.linspace(0, slow, max(_PER_TURN, int(count * slow / np.pi)) + 1) - delta / 2
    near = np.pi * (1 - _NEAR_NYQUIST / count)
    angles = [*creeping[creeping < 0], *np.linspace(0, np.pi, count + 1)[:-1], *near, np.pi]
    shape = shapely.box(0, 1.1 * low, 1.1 * right, 1.1 * high)
    for angle in reversed(angles):
        shape = cut(shape, angle)
    gaps, move = list(itertools.pairwise(angles)), 0.0
    for _ in range(_ROUNDS):
        before, wide = shape, []
        for low, high in gaps:
            middle = (low + high) / 2
            angles.append(middle)
            after = cut(shape, middle)
            if _moved(shape, after) > tolerance * _extent(before) / 8:
                wide += [(low, middle), (middle, high)]
            shape = after
        move = _moved(before, shape)
        if not wide or move <= tolerance * _extent(shape) / 2:
            break
        gaps = wide
    error = move + tolerance / 50 * max(delta, _extent(shape))
    springs = np.array([_spring(angle, delta) for angle in sorted(angles)])
    return RobustRegion(float(delta), float(delay), sheet, shape, springs, error)


def _spring(angle: float, delta: float) -> float:
    """gamma of a swing by ``angle`` per period; below 0 the plant creeps."""
    return max(delta**2 / 4 + float(angle) * abs(float(angle)), 0.0)


def _held(shape: Any, loop: Loop, share: float) -> Any:
    """The parts of a shape whose walls a loop keeps stable: its boundary cuts them apart."""
    parts = list(getattr(shape, "geoms", [shape]))
    room = shape.buffer(_extent(shape), quad_segs=1).bounds
    lines = shapely.multilinestrings(shapely.linestrings(chords(loop, shape.bounds, share)))
    lines = shapely.clip_by_rect(lines, *room)  # those to infinity would blur the others
    if shapely.intersects(shape, lines):
        cut = shapely.unary_union([shape.boundary, lines])
        faces, _, loose, _ = shapely.polygonize_full([cut])
        if shapely.length(shapely.intersection(loose, shape)) > share * _extent(shape):
            raise NotTraced(loop)
        parts = list(faces.geoms)
    alpha, beta = shapely.get_coordinates([part.representative_point() for part in parts]).T
    stable = is_stable(alpha, beta, loop.gamma, loop.delta, loop.delay, loop.sheet)
    stable &= shapely.contains_xy(shape, alpha, beta)
    return shapely.unary_union([p for p, kept in zip(parts, stable, strict=True) if kept])


def _moved(before: Any, after: Any) -> float:
    """How far the outline has moved: the distance of corners that are new from where it was."""
    corners = [set(map(tuple, shapely.get_coordinates(shape))) for shape in (before, after)]
    gone, new = corners[0] - corners[1], corners[1] - corners[0]
    away = [
        shapely.distance(shapely.points(list(some)), shape.boundary)
        for some, shape in ((gone, after), (new, before))
        if some
    ]
    return float(np.max(np.concatenate([[0.0], *away])))


def _extent(shape: Any) -> float:
    """Diagonal of the box around a shape."""
    left, low, right, high = shape.bounds
    return float(np.hypot(right - left, high - low))

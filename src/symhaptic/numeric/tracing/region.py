"""The stable region of the (alpha, beta) plane as a polygon with exact corners."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.containers import numbers_only
from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.arcs import Loop, flips
from symhaptic.numeric.tracing.corners import joined
from symhaptic.numeric.tracing.shape import Shape
from symhaptic.numeric.tracing.sides import (
    Piece,
    at_angle,
    curves,
    diagonal,
    left_sides,
    right_sides,
)

_SAME = (1e-8, 1e-7, 1e-6, 1e-5)
"""Ends of pieces closer than this, relative to the region, are one corner, refined afterwards; the
first that leaves no loose end is taken."""


@dataclass(frozen=True)
class Region(Shape):
    """The stable walls (alpha, beta) of one plant with one delay, as a plane figure.

    :func:`symhaptic.stable_region` returns it.  alpha is K T^2/m, beta is B T/m.
    """

    loop: Loop
    polygon: Any
    """Shapely's polygon or polygons."""
    corners: Array = field(compare=False)
    """One row (alpha, beta) per corner."""
    error: float
    """No point of the outline is farther than this from the boundary."""

    @property
    def touches_left_bound(self) -> bool:
        """Whether a part of the line alpha = -gamma borders the region."""
        at_left = self.corners[:, 0] == -self.loop.gamma if len(self.corners) else np.zeros(0)
        return int(np.sum(at_left)) > 1

    @property
    def max_stiffness(self) -> Extremum:
        """The point of largest alpha."""
        return self.farthest(1.0, 0.0)

    @property
    def max_damping(self) -> Extremum:
        """The point of largest beta."""
        return self.farthest(0.0, 1.0)

    @property
    def min_damping(self) -> Extremum:
        """The point of smallest beta."""
        return self.farthest(0.0, -1.0)

    def farthest(self, alpha: float, beta: float) -> Extremum:
        """The point of the boundary farthest in a direction, to full precision.

        Parameters
        ----------
        alpha, beta : float
            The direction, not both 0.

        Returns
        -------
        Extremum
            NaN if the region is empty.  The angle is NaN if the point lies only on a line of a real
            root.

        Raises
        ------
        ValueError
            If a component is not finite, or both are 0.
        """
        for name, value in (("alpha", alpha), ("beta", beta)):
            array = arguments.finite(name, value)
            arguments.refuse(name, array, np.isnan(array), "finite numbers")
            arguments.single(name, array)
        if alpha == beta == 0:
            raise ValueError(
                f"alpha: {alpha} with beta={beta} is no direction; give one that is not 0"
            )
        found = farthest(self.loop, np.array([alpha, beta]))
        left, low, right, high = self.polygon.bounds
        near = _SAME[0] * np.hypot(right - left, high - low)
        for corner in self.corners:
            if corner @ (alpha, beta) > np.dot((alpha, beta), found[:2]) or np.isnan(found[0]):
                same = np.linalg.norm(corner - found[:2]) <= near  # but for rounding
                found = np.array([*corner, found[2] if same else np.nan])
        return Extremum(*(np.asarray(v) for v in found))

    def contains(self, alpha: ArrayLike, beta: ArrayLike) -> NDArray[np.bool_]:
        """Whether walls are stable, by the root count and not from the outline.

        Parameters
        ----------
        alpha, beta : array_like
            K T^2/m and B T/m; they broadcast.

        Returns
        -------
        bool or ndarray of bool
            Of the shape to which the arguments broadcast.
        """
        loop = self.loop
        return is_stable(alpha, beta, loop.gamma, loop.delta, loop.delay, loop.sheet)


_AROUND = np.arange(16) * np.pi / 8
"""Directions in which walls are tried around no wall at all."""

_PLACES = 4
"""Last places by which the angle of a corner may be off."""

_NEXT_TO_NONE = 2.0 ** -np.arange(10.0, 110.0, 10.0)
"""How large these walls are: the smallest that is not too faint for a verdict is the best one."""


@numbers_only
def stable_region(
    gamma: float, delta: float, delay: float, sheet: str = "exact", tolerance: float = 1e-6
) -> Region:
    """The stable region of a plant: all walls (alpha, beta) with a stable loop.

    Parameters
    ----------
    gamma, delta : float
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : float
        Delay in sampling periods, 0 to 100 000, integer or fractional.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        reading that the paper draws.
    tolerance : float, optional
        Distance of the outline from the boundary, in units of the region's extent, from 1e-12 to 1.

    Returns
    -------
    Region
        With ``outline``, ``corners``, ``area``, ``contains``, ``plot``, ``max_stiffness``,
        ``max_damping``, ``min_damping`` and ``farthest``.

    Raises
    ------
    ValueError
        If an argument is out of its range, or if pieces of the boundary are missed.  This occurs
        for lightly damped devices with omega_d T near a multiple of pi, and on the principal sheet
        for delays within some 1e-6 of a period above an integer.

    See Also
    --------
    is_stable : The verdict on a single wall, without an outline.

    Notes
    -----
    The sides are pieces of the explicit boundary (:func:`symhaptic.stability_boundary`, chapter
    s4d_explicit_boundary) and of the lines with a root at 1 or -1.  Corners are computed to full
    precision.  The time grows with the delay.

    Examples
    --------
    >>> region = stable_region(0.0, 0.0, 0)
    >>> [round(float(x), 6) for x in region.max_stiffness]  # alpha = 4 (2 - r)(r - 1)/r, r = sqrt 2
    [0.686292, 0.828427, 1.143718]
    """
    arguments.check_sheet(sheet)
    given = {"gamma": gamma, "delta": delta, "delay": delay}
    numbers = {name: arguments.of_loop(name, value) for name, value in given.items()}
    tolerance = arguments.one("tolerance", tolerance)
    if not 1e-12 <= tolerance < 1:
        raise ValueError(f"tolerance: {tolerance!r} is not allowed; give 1e-12 <= tolerance < 1")
    loop = Loop(**numbers, sheet=sheet)
    pieces, error = curves(loop, tolerance)
    ends = np.array([p.points[i] for p in pieces for i in (0, -1)]).reshape(-1, 2)
    near = _SAME[0] * diagonal(pieces)
    pieces = pieces + left_sides(loop, ends, near) + right_sides(loop, ends, near)
    corners, faces, moved = _faces(loop, pieces)
    stable = []
    for face in faces:
        inner = face.representative_point()
        if is_stable(inner.x, inner.y, loop.gamma, loop.delta, loop.delay, loop.sheet):
            stable.append(face)
    if not stable and _hardly_held(loop):
        raise NotTraced(loop)
    return Region(loop, shapely.unary_union(stable), corners, max(error, moved))


def _hardly_held(loop: Loop) -> bool:
    """Whether a wall far below the passive ones, alpha = delta/(4 + 8 d), is stable.

    Where no damper makes any passive, one of those around no wall at all: the roots of a spring
    that swings go inside for half of them.
    """
    alpha, beta = np.array(loop.delta / (4 + 8 * loop.delay)), np.array(0.0)
    if loop.delta == 0:
        around = np.array([np.cos(_AROUND), np.sin(_AROUND)])
        alpha, beta = around[..., None] * _NEXT_TO_NONE
    return bool(np.any(is_stable(alpha, beta, loop.gamma, loop.delta, loop.delay, loop.sheet)))


class NotTraced(ValueError):
    """Pieces of a loop's boundary are missed."""

    def __init__(self, loop: Loop) -> None:
        super().__init__(
            f"gamma: {loop.gamma!r} with delta={loop.delta!r} behind {loop.delay!r} periods is not "
            "traced, since the pieces of its boundary do not meet; is_stable tells of each wall"
        )


def _faces(loop: Loop, pieces: list[Piece]) -> tuple[Array, list[Any], float]:
    """The corners, the faces between the sides, and how far ends were moved to meet.

    A loose end may be a side of a face that is missed: nothing is known of the region then.
    """
    if not pieces:
        return np.zeros((0, 2)), [], 0.0
    extent = diagonal(pieces)
    for share in _SAME:
        corners, met = joined(loop, pieces, share * extent)
        lines = shapely.unary_union([shapely.LineString(p.points) for p in met])
        polygons, *rest = shapely.polygonize_full([lines])
        if sum(shapely.length(rest)) <= share * extent:
            moved = 0.0 if share == _SAME[0] else share * extent
            return corners, list(polygons.geoms), moved
    raise NotTraced(loop)


def farthest(loop: Loop, direction: Array) -> Array:
    """(alpha, beta, theta) of the curve's bordering point farthest in a direction; NaN if none."""
    grid, found = loop.samples(), [np.zeros(0)]
    if loop.end is None and any(high == np.pi for _, high in loop.arcs):
        raise NotTraced(loop)  # the curve goes to infinity there, and borders nothing
    for low, high in loop.arcs:
        inside = grid[(grid > low) & (grid < high)]
        inner = np.unique(np.clip([low, *inside, high], grid[0], grid[-1]))
        rises = loop.tangent(inner) @ direction > 0
        rising = flips(lambda theta: loop.tangent(theta) @ direction > 0, inner, rises)
        found.append(np.array([low, *rising, high]))
    angles = np.concatenate(found)
    points = np.array([at_angle(loop, angle) for angle in angles]).reshape(-1, 2)
    reach = points @ direction
    if np.all(np.isnan(reach)):
        return np.full(3, np.nan)
    best = int(np.nanargmax(reach))
    # an angle is known to some last places: of a corner's two, the one where they matter less
    inner = np.clip(angles, grid[0], grid[-1])
    off = _PLACES * np.spacing(angles) * np.abs(loop.tangent(inner) @ direction)
    near = np.flatnonzero(reach >= reach[best] - off[best])
    best = int(near[np.argmin(off[near])])
    return np.array([*points[best], angles[best]])

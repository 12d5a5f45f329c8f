"""The stable region of the (alpha, beta) plane as a polygon with exact corners."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.containers import numbers_only
from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.stability import SHEETS, is_stable
from symhaptic.numeric.tracing.arcs import Loop, flips
from symhaptic.numeric.tracing.shape import Shape

_ROUNDS = 30
"""Halvings of a chord at most."""

_SAME = (1e-8, 1e-7, 1e-6, 1e-5)
"""Ends of pieces closer than this, relative to the region, are one corner, refined afterwards; the
first that leaves no loose end is taken."""


@dataclass(frozen=True)
class Piece:
    """A part of the boundary: points from corner to corner, and the angles of a curve's ends."""

    points: Array
    angles: tuple[float, float] | None = None


@dataclass(frozen=True)
class Region(Shape):
    """The walls (alpha, beta) that a device keeps stable, for one plant and one delay."""

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
        """The rightmost point."""
        return self.farthest(1.0, 0.0)

    @property
    def max_damping(self) -> Extremum:
        """The uppermost point."""
        return self.farthest(0.0, 1.0)

    @property
    def min_damping(self) -> Extremum:
        """The lowest point."""
        return self.farthest(0.0, -1.0)

    def farthest(self, alpha: float, beta: float) -> Extremum:
        """The boundary's point farthest in a direction, to full precision; NaN if there is none.

        Its angle is NaN where it lies on a line of a real root only.
        """
        for name, value in (("alpha", alpha), ("beta", beta)):
            array = arguments.finite(name, value)
            arguments.refuse(name, array, np.isnan(array), "finite numbers are")
            arguments.single(name, array)
        if alpha == beta == 0:
            raise ValueError(f"alpha: {alpha} beside beta={beta} is not allowed; a direction is")
        found = farthest(self.loop, np.array([alpha, beta]))
        for corner in self.corners:
            if corner @ (alpha, beta) > np.dot((alpha, beta), found[:2]) or np.isnan(found[0]):
                found = np.array([*corner, np.nan])
        return Extremum(*(np.asarray(v) for v in found))

    def contains(self, alpha: ArrayLike, beta: ArrayLike) -> NDArray[np.bool_]:
        """Whether walls are stable, by the root count and not by the outline."""
        loop = self.loop
        return is_stable(alpha, beta, loop.gamma, loop.delta, loop.delay, loop.sheet)


@numbers_only
def stable_region(
    gamma: float, delta: float, delay: float, sheet: str = "exact", tolerance: float = 1e-6
) -> Region:
    """The stable region for a plant ``gamma``, ``delta`` >= 0 and ``delay`` >= 0 periods.

    Its sides are pieces of the explicit boundary and of the lines of a root at 1 and -1; its
    corners are computed to full precision, the outline between them within ``tolerance`` of the
    region's extent.  With ``sheet="principal"`` the region that the paper draws for a fractional
    delay.

    Raises :class:`ValueError` for an impossible plant or tolerance, for more than 100 000
    periods, as the time grows with the delay, and where pieces of the boundary are missed: next
    to a hardly damped device that makes whole half swings in a period, and on the principal sheet
    up to some 1e-6 of a period beyond a whole delay.

    >>> region = stable_region(0.0, 0.0, 0)
    >>> [round(float(x), 6) for x in region.max_stiffness]  # alpha = 4 (2 - r)(r - 1)/r, r = sqrt 2
    [0.686292, 0.828427, 1.143718]
    """
    arguments.one_of("sheet", sheet, SHEETS)
    numbers = {}
    for name, value in (("gamma", gamma), ("delta", delta), ("delay", delay)):
        array = (arguments.periods if name == "delay" else arguments.nonnegative)(name, value)
        arguments.refuse(name, array, np.isnan(array), f"finite numbers {name} >= 0 are")
        numbers[name] = arguments.single(name, array)
    tolerance = arguments.one("tolerance", tolerance)
    if not 1e-12 <= tolerance < 1:
        raise ValueError(f"tolerance: {tolerance!r} is not allowed; 1e-12 <= tolerance < 1 is")
    loop = Loop(**numbers, sheet=sheet)
    pieces, error = _curves(loop, tolerance)
    ends = np.array([p.points[i] for p in pieces for i in (0, -1)]).reshape(-1, 2)
    near = _SAME[0] * _size(pieces)
    pieces = pieces + _left_sides(loop, ends, near) + _right_sides(loop, ends, near)
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
    """Whether a wall far below the passive ones, alpha = delta/(4 + 8 d), is stable."""
    wall = loop.delta / (4 + 8 * loop.delay), 0.0
    return bool(is_stable(*wall, loop.gamma, loop.delta, loop.delay, loop.sheet))


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
    size = _size(pieces)
    for share in _SAME:
        corners, joined = _joined(loop, pieces, share * size)
        lines = shapely.unary_union([shapely.LineString(p.points) for p in joined])
        polygons, *rest = shapely.polygonize_full([lines])
        if sum(shapely.length(rest)) <= share * size:
            moved = 0.0 if share == _SAME[0] else share * size
            return corners, list(polygons.geoms), moved
    raise NotTraced(loop)


# -- the sides ------------------------------------------------------------------------------


def _point(loop: Loop, angle: float) -> Array:
    if angle == 0:
        return loop.begin
    if angle == np.pi and loop.end is not None:
        return loop.end
    return loop.curve(np.asarray(angle))


def _curves(loop: Loop, tolerance: float) -> tuple[list[Piece], float]:
    """The curved sides with chords short enough, and the error of the chords."""
    arcs = [(a, b) for a, b in loop.arcs if b < np.pi or loop.end is not None]
    if not arcs:
        return [], 0.0
    grid = loop.samples()
    inside = [grid[(grid > a) & (grid < b)] for a, b in arcs]
    rough = [
        np.vstack([_point(loop, a), loop.curve(g), _point(loop, b)])
        for (a, b), g in zip(arcs, inside, strict=True)
    ]
    size = float(np.linalg.norm(np.ptp(np.vstack(rough), axis=0)))
    pieces, worst = [], 0.0
    for (a, b), angles, points in zip(arcs, inside, rough, strict=True):
        angles = np.concatenate([[a], angles, [b]])
        for _ in range(_ROUNDS):
            middles = (angles[1:] + angles[:-1]) / 2
            fresh = loop.curve(middles)
            off = _distance(fresh, points[:-1], points[1:])
            far = np.flatnonzero(off > tolerance * size / 2)
            if not far.size:
                break
            angles = np.insert(angles, far + 1, middles[far])
            points = np.insert(points, far + 1, fresh[far], axis=0)
        # a chord's largest distance is at most 4/3 of that at its middle to second order
        worst = max(worst, 2 * float(off.max()))
        pieces.append(Piece(points, (a, b)))
    return pieces, worst


def _distance(points: Array, begin: Array, end: Array) -> Array:
    """Distance of points from segments."""
    along = end - begin
    length = np.sum(along**2, axis=1)
    share = np.sum((points - begin) * along, axis=1) / np.where(length == 0, 1.0, length)
    foot = begin + np.clip(share, 0, 1)[:, None] * along
    return np.asarray(np.linalg.norm(points - foot, axis=1))


def _left_sides(loop: Loop, ends: Array, near: float) -> list[Piece]:
    """The parts of the line of a root at 1, between the points where the curve meets it."""
    angles = loop.at_left
    touching = ends[np.abs(ends[:, 0] + loop.gamma) <= near, 1]
    betas = [float(loop.begin[1]), *loop.curve(angles)[:, 1], *touching]
    if loop.line is not None:
        betas.append((loop.line + loop.gamma) / 2)
    return _sides(loop, np.array([[-loop.gamma, beta] for beta in _apart(betas, near)]))


def _right_sides(loop: Loop, ends: Array, near: float) -> list[Piece]:
    """The parts of the line of a root at -1, likewise."""
    if loop.line is None or loop.end is None:
        return []
    line = loop.line
    angles = loop.at_right
    touching = ends[np.abs(ends @ (1, 2) - line) <= near, 0]
    alphas = [-loop.gamma, float(loop.end[0]), *loop.curve(angles)[:, 0], *touching]
    return _sides(loop, np.array([[alpha, (line - alpha) / 2] for alpha in _apart(alphas, near)]))


def _apart(values: list[float], near: float) -> list[float]:
    """The values in order, each but once."""
    kept: list[float] = []
    for value in sorted(values):
        if not kept or value - kept[-1] > near:
            kept.append(value)
    return kept


def _sides(loop: Loop, points: Array) -> list[Piece]:
    """The segments between neighbouring points that have stable walls beside them."""
    pieces = []
    for one, two in itertools.pairwise(points):
        across = np.array([two[1] - one[1], one[0] - two[0]]) * 1e-7
        middle = (one + two) / 2
        near = np.stack([middle + across, middle - across])
        stable = is_stable(near[:, 0], near[:, 1], loop.gamma, loop.delta, loop.delay, loop.sheet)
        if np.any(stable):
            pieces.append(Piece(np.stack([one, two])))
    return pieces


def _size(pieces: list[Piece]) -> float:
    """Diagonal of the box around the pieces."""
    if not pieces:
        return 0.0
    return float(np.linalg.norm(np.ptp(np.vstack([p.points for p in pieces]), axis=0)))


# -- the corners ----------------------------------------------------------------------------


def _joined(loop: Loop, pieces: list[Piece], near: float) -> tuple[Array, list[Piece]]:
    """The corners, refined, and the pieces with their ends exactly there."""
    ends = [(i, j) for i in range(len(pieces)) for j in (0, -1)]
    groups: list[list[tuple[int, int]]] = []
    for i, j in ends:
        here = pieces[i].points[j]
        for group in groups:
            k, m = group[0]
            if np.linalg.norm(pieces[k].points[m] - here) <= near:
                group.append((i, j))
                break
        else:
            groups.append([(i, j)])
    points = [p.points.copy() for p in pieces]
    corners = []
    for group in groups:
        corner = _refined(loop, [(pieces[i], j) for i, j in group])
        corners.append(corner)
        for i, j in group:
            points[i][j] = corner
    return np.array(corners), [
        Piece(new, piece.angles) for new, piece in zip(points, pieces, strict=True)
    ]


def _refined(loop: Loop, group: list[tuple[Piece, int]]) -> Array:
    """A corner to full precision: from a straight side, or where two angles give one wall."""
    for piece, j in group:
        if piece.angles is None:
            return np.asarray(piece.points[j])
    angles = np.array([piece.angles[j] for piece, j in group if piece.angles is not None])
    if len(angles) < 2 or angles[0] == 0 or angles[-1] == np.pi:
        return np.asarray(group[0][0].points[group[0][1]])
    pair = angles[:2]
    for _ in range(4):
        one, two = loop.curve(pair)
        slopes = loop.tangent(pair)
        matrix = np.stack([slopes[0], -slopes[1]], axis=1)
        if np.linalg.matrix_rank(matrix) < 2:
            break
        pair = pair - np.linalg.solve(matrix, one - two)
    return np.asarray(loop.curve(pair).mean(axis=0))


def farthest(loop: Loop, direction: Array) -> Array:
    """(alpha, beta, theta) of the curve's bordering point farthest in a direction; NaN if none."""
    best = np.full(3, np.nan)
    grid = loop.samples()
    if loop.end is None and any(high == np.pi for _, high in loop.arcs):
        raise NotTraced(loop)  # the curve goes to infinity there, and borders nothing
    for low, high in loop.arcs:
        inside = grid[(grid > low) & (grid < high)]
        inner = np.unique(np.clip([low, *inside, high], grid[0], grid[-1]))
        rises = loop.tangent(inner) @ direction > 0
        rising = flips(lambda theta: loop.tangent(theta) @ direction > 0, inner, rises)
        angles = [low, *rising, high]
        points = np.array([[*_point(loop, angle), angle] for angle in angles])
        reach = points[:, :2] @ direction
        at = int(np.nanargmax(reach))
        if np.isnan(best[0]) or reach[at] > best[:2] @ direction:
            best = points[at]
    return best

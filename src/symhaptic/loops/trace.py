"""The stable walls of one loop: explicit boundary, limits at a damping or a stiffness, region.

Where K X + B Y = -(z^M A + E) on the circle, K and B solve two real linear equations, whatever the
device, the filter and the delay are.  With the lines of a root at z = 1 and z = -1 that is the
whole boundary.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops.circle import Array, grid, zeros
from symhaptic.loops.count import crossing, is_stable
from symhaptic.loops.loop import Loop
from symhaptic.numeric.extremum import Extremum

LONGEST = 20_000
"""Periods of delay; the pieces of a boundary are as many as its turns."""


def boundary(loop: Loop, theta: Array) -> tuple[Array, Array]:
    """K and B of the walls with which a loop swings at these angles."""
    top_K, top_B, bottom = _tops(loop, theta)
    with np.errstate(divide="ignore", invalid="ignore"):
        return top_K / bottom, top_B / bottom


def _tops(loop: Loop, theta: Array) -> tuple[Array, Array, Array]:
    """By Cramer's rule: K and B times the determinant, and the determinant."""
    late, X, Y, E = crossing(loop, theta)
    wanted = -(late + E)
    return (
        -(wanted * Y.conj()).imag,
        (wanted * X.conj()).imag,
        (X.conj() * Y).imag,
    )


@dataclass(frozen=True)
class Walls:
    """Walls on the border of stability: arrays of K, B and of the angle at which they swing."""

    K: Array
    B: Array
    theta: Array


class Trace:
    """The boundary of one loop, in pieces on which K and B rise or fall, and its stable walls."""

    def __init__(self, loop: Loop) -> None:
        if int(loop.M) > LONGEST:
            raise ValueError(
                f"delay: {int(loop.M)} periods are too long; give at most {LONGEST} periods"
            )
        self.loop = loop
        self.theta = self._angles()
        self.K, self.B = boundary(loop, self.theta)
        self._drawn = np.column_stack([self.K, self.B])
        bottom = _tops(loop, self.theta)[2]
        self.whole = bottom[1:] * bottom[:-1] > 0
        """Which neighbours have no pole of the boundary between them."""

    def _angles(self) -> Array:
        """A grid on which each turn has many points, with the extremes of K and B between."""
        turns = int(self.loop.M) + self.loop.A.shape[-1] + self.loop.X.shape[-1]
        first = 1e-5 / turns
        uniform = np.linspace(0, np.pi, 24 * turns + 400)[1:-1]
        bends = () if self.loop.in_z else (self.loop.X, self.loop.Y)
        theta = grid(uniform, first, self.loop.A, *bends)
        bottom = _tops(self.loop, theta)[2]
        there = np.flatnonzero(bottom[1:] * bottom[:-1] < 0)
        poles = zeros(lambda at: _tops(self.loop, at)[2], theta[there], theta[there + 1])
        theta = np.union1d(theta, np.concatenate([poles * (1 + each) for each in _BESIDE]))
        theta = theta[theta < np.pi]
        for which in (0, 1):
            theta = np.union1d(theta, self._extremes(theta, which))
        return theta

    def _extremes(self, theta: Array, which: int) -> Array:
        """Where K (0) or B (1) turns between three neighbours, by ever finer grids."""
        values = boundary(self.loop, theta)[which]
        with np.errstate(invalid="ignore"):
            rise = np.diff(values)
            there = np.flatnonzero(rise[1:] * rise[:-1] < 0) + 1
        up = np.where(rise[there - 1] > 0, 1.0, -1.0)
        low, high = theta[there - 1], theta[there + 1]
        for _ in range(10):
            at = low + _SIXTEEN * (high - low)
            top = np.argmax(up * boundary(self.loop, at)[which], axis=0)
            step = (high - low) / 16
            low, high = low + step * np.maximum(top - 1, 0), low + step * np.minimum(top + 1, 16)
        return np.asarray((low + high) / 2)

    @cached_property
    def lines(self) -> tuple[tuple[float, float, float], ...]:
        """x K + y B + c = 0 of a root at z = 1 and at z = -1."""
        found = []
        for theta in (0.0, np.pi):
            late, X, Y, E = crossing(self.loop, np.array(theta))
            found.append((float(X.real), float(Y.real), float((late + E).real)))
        return tuple(found)

    def at_stiffness(self, K: Array) -> list[Walls]:
        """All walls of a stiffness on the boundary, for each of several stiffnesses."""
        return self._at(K, self.K, 0)

    def _at(self, given: Array, along: Array, which: int) -> list[Walls]:
        given = np.atleast_1d(np.asarray(given, dtype=float))
        with np.errstate(invalid="ignore"):
            above = along > given[:, None]
        rows, there = np.nonzero((above[:, 1:] != above[:, :-1]) & self.whole)
        theta = zeros(
            lambda at: boundary(self.loop, at)[which] - given[rows],
            self.theta[there],
            self.theta[there + 1],
        )
        other = boundary(self.loop, theta)[1 - which]
        rows, other, theta = self._with_lines(given, which, rows, other, theta)
        order = np.lexsort((other, rows))
        cuts = np.searchsorted(rows[order], np.arange(1, len(given)))
        found: list[Walls] = []
        if not len(given):
            return found
        for one, value, angle in zip(
            given, np.split(other[order], cuts), np.split(theta[order], cuts), strict=True
        ):
            same_value = np.full(value.shape, one)
            K, B = (value, same_value) if which else (same_value, value)
            found.append(Walls(K, B, angle))
        return found

    def _with_lines(
        self, given: Array, which: int, rows: NDArray[np.intp], other: Array, theta: Array
    ) -> tuple[NDArray[np.intp], Array, Array]:
        """The same with the walls of each damping, or stiffness, on the lines of real roots."""
        for (x, y, c), end in zip(self.lines, (0.0, np.pi), strict=True):
            mine, its = (x, y) if which else (y, x)
            if abs(mine) > 1e-14 * (abs(x) + abs(y) + abs(c)):
                rows = np.concatenate([rows, np.arange(len(given))])
                other = np.concatenate([other, -(its * given + c) / mine])
                theta = np.concatenate([theta, np.full(len(given), end)])
        return rows, other, theta

    def stable_between(self, walls: list[Walls]) -> list[NDArray[np.bool_]]:
        """Whether the loop is stable between neighbouring walls of each list."""
        if not walls:
            return []
        middles = [(np.diff(w.K) / 2 + w.K[:-1], np.diff(w.B) / 2 + w.B[:-1]) for w in walls]
        K, B = (np.concatenate([m[k] for m in middles]) for k in (0, 1))
        told = is_stable(self.loop, K, B)
        return np.split(told, np.cumsum([len(m[0]) for m in middles])[:-1])

    def limits(self, B: Array) -> tuple[Array, Array]:
        """Largest stable stiffness and its angle for each damping; NaN where there is none."""
        return self._ends(np.atleast_1d(np.asarray(B, dtype=float)), 0, 1.0)

    def dampings(self, K: Array) -> list[list[tuple[float, float]]]:
        """The intervals of B in which walls of each stiffness are stable."""
        walls = self.at_stiffness(K)
        found = []
        for each, told in zip(walls, self.stable_between(walls), strict=True):
            pieces: list[tuple[float, float]] = []
            for low, high, stable in zip(each.B[:-1], each.B[1:], told, strict=True):
                if stable and pieces and pieces[-1][1] == low:
                    pieces[-1] = (pieces[-1][0], float(high))
                elif stable:
                    pieces.append((float(low), float(high)))
            found.append(pieces)
        return found

    @cached_property
    def polygon(self) -> Any:
        """Shapely's polygon or polygons of the stable walls, within about 1e-5 of its extent."""
        size = 4.0
        for _ in range(12):
            polygon, reaches = self._faces(size, size)
            if not reaches:
                break
            size *= 4
        K, B = self._extent
        if not polygon.is_empty:
            low_K, low_B, high_K, high_B = polygon.bounds
            K, B = max(K, abs(low_K), abs(high_K)), max(B, abs(low_B), abs(high_B))
        return self._faces(2 * K, 2 * B, fine=True)[0] if K and B else polygon

    @cached_property
    def _extent(self) -> tuple[float, float]:
        """Largest sizes of K and B of stable walls on lines through points of the boundary.

        A region beside the one that a square box shows may be far away.
        """
        found = [0.0, 0.0]
        for which, along in ((0, self.B), (1, self.K)):
            lines = np.unique(along[np.isfinite(along)])
            lines = lines[np.linspace(0, len(lines) - 1, min(_LINES, len(lines))).astype(int)]
            for sign in (1.0, -1.0):
                ends = self._ends(lines, which, sign)[0]
                there = ~np.isnan(ends)
                for at, sizes in ((which, ends[there]), (1 - which, lines[there])):
                    found[at] = max(found[at], float(np.abs(sizes).max(initial=0.0)))
        return found[0], found[1]

    def _faces(self, K: float, B: float, fine: bool = False) -> tuple[Any, bool]:
        """Stable faces within a box, and whether one of them reaches its border.

        ``fine`` draws the boundary with more points.
        """
        from shapely import box, linestrings, multilinestrings, unary_union
        from shapely.ops import polygonize

        points, whole = np.column_stack([self.K, self.B]), self.whole
        if fine:
            near = np.all(np.abs(points) < 2 * np.array([K, B]), axis=1)
            wide = np.flatnonzero(near[1:] & near[:-1] & whole)
            parts = np.linspace(0, 1, _FINER, endpoint=False)[1:, None]
            between = self.theta[wide] + parts * (self.theta[wide + 1] - self.theta[wide])
            theta = np.concatenate([self.theta, between.ravel()])
            order = np.argsort(theta)
            points = np.column_stack(boundary(self.loop, theta[order]))
            whole = np.insert(whole, np.repeat(wide, _FINER - 1), True)
            self._drawn = points
        with np.errstate(invalid="ignore"):
            inside = np.all(np.abs(points) < 4 * np.array([K, B]), axis=1)
        joined = whole & inside[1:] & inside[:-1]
        frame = box(-K, -B, K, B)
        runs = np.split(np.arange(len(points)), np.flatnonzero(~joined) + 1)
        lines = [linestrings(points[run]) for run in runs if len(run) > 1]
        for (x, y, c), end in zip(self.lines, (0, -1), strict=True):
            if abs(x) + abs(y) > 1e-14 * abs(c):
                lines.append(linestrings(_through(x, y, c, 4 * (K + B))))
                if inside[end]:  # the curve ends on the line, a little beyond its last point
                    lines.append(linestrings(_across(x, y, c, points[end], 1e-6 * (K + B))))
        cut = multilinestrings(lines).intersection(frame)
        faces = list(polygonize(unary_union([cut, frame.boundary])))
        if not faces:
            return frame.difference(frame), False
        inner = np.array([(p.x, p.y) for p in (f.representative_point() for f in faces)])
        told = is_stable(self.loop, inner[:, 0], inner[:, 1])
        kept = [face for face, stable in zip(faces, told, strict=True) if stable]
        found = unary_union(kept)
        reaches = not found.is_empty and found.distance(frame.boundary) < 1e-9 * (K + B)
        return found, reaches

    @cached_property
    def max_stiffness(self) -> Extremum:
        """The stable wall of the largest stiffness, as a supremum; NaN if no wall is stable."""
        return self._farthest(0, 1.0)

    @cached_property
    def max_damping(self) -> Extremum:
        """The stable wall of the largest damping."""
        return self._farthest(1, 1.0)

    @cached_property
    def min_damping(self) -> Extremum:
        """The stable wall of the smallest damping."""
        return self._farthest(1, -1.0)

    @cached_property
    def corners(self) -> Array:
        """Where pieces of the outline meet: one row (K, B) each."""
        drawn = {tuple(p) for p in self._drawn.tolist()}
        rings = [np.asarray(p.exterior.coords)[:-1] for p in _polygons(self.polygon)]
        found = []
        for ring in rings:
            along = np.diff(np.concatenate([ring[-1:], ring, ring[:1]]), axis=0)
            heading = np.arctan2(along[:, 1], along[:, 0] * self._shape)
            turn = np.abs((np.diff(heading) + np.pi) % (2 * np.pi) - np.pi)
            sharp = (turn > _SHARP) & [tuple(p) not in drawn for p in ring.tolist()]
            found.append(ring[sharp])
        return np.concatenate(found) if found else np.zeros((0, 2))

    @property
    def _shape(self) -> float:
        """Height over width of the region."""
        low_K, low_B, high_K, high_B = self.polygon.bounds
        return float((high_B - low_B) / (high_K - low_K))

    def _farthest(self, which: int, sign: float) -> Extremum:
        """The border point with the largest K (0) or ``sign`` B (1).

        Starting from the outline, ever closer values of the other coordinate are tried.
        """
        if self.polygon.is_empty:
            return Extremum(*(np.asarray(np.nan) for _ in range(3)))
        points = np.concatenate([np.asarray(p.exterior.coords) for p in _polygons(self.polygon)])
        other = 1 - which
        best = float(points[np.argmax(sign * points[:, which]), other])
        low, high = points[:, other].min(), points[:, other].max()
        width, steps = (high - low) / 20, np.linspace(-1, 1, 21)
        found = (np.nan, np.nan, np.nan)
        for _ in range(14):
            tried = best + width * steps
            ends, theta = self._ends(tried, which, sign)
            width /= 7
            if not np.isnan(ends).all():
                top = int(np.nanargmax(sign * ends))
                best, found = float(tried[top]), (ends[top], tried[top], theta[top])
        value, beside, angle = (np.asarray(float(x)) for x in found)
        return Extremum(value, beside, angle) if which == 0 else Extremum(beside, value, angle)

    def _ends(self, given: Array, which: int, sign: float) -> tuple[Array, Array]:
        """The last stable K (0) or ``sign`` B (1) and its angle at values of the other one."""
        walls = self._at(given, (self.B, self.K)[which], 1 - which)
        found = np.full((2, len(given)), np.nan)
        for n, (each, told) in enumerate(zip(walls, self.stable_between(walls), strict=True)):
            if told.any():
                stable = np.flatnonzero(told)
                last = int(stable[-1]) + 1 if sign > 0 else int(stable[0])
                found[:, n] = (each.K, each.B)[which][last], each.theta[last]
        return found[0], found[1]


_LINES = 64
"""Lines of equal K, and of equal B, on which stable walls are sought."""

_SHARP = 0.02
"""Radians by which the outline turns at a corner, drawn as high as wide."""

_BESIDE = np.geomspace(1e-9, 0.1, 81)
_BESIDE = np.concatenate([-_BESIDE, _BESIDE])
"""Relative distances from a pole: next to it the boundary goes to infinity within little angle."""

_SIXTEEN = np.linspace(0.0, 1.0, 17)[:, None]
"""Ends of sixteen parts of an interval, one column for each of many intervals."""

_FINER = 6
"""So many pieces are drawn of each between two angles of the grid."""


def _through(x: float, y: float, c: float, reach: float) -> Array:
    """Two far points of a line."""
    size = x * x + y * y
    foot = np.array([-x * c / size, -y * c / size])
    along = np.array([-y, x]) / np.sqrt(size) * reach
    return np.array([foot - along, foot + along])


def _across(x: float, y: float, c: float, start: Array, least: float) -> Array:
    """From a point to both sides of a line."""
    normal = np.array([x, y]) / np.hypot(x, y)
    far = (x * start[0] + y * start[1] + c) / np.hypot(x, y)
    reach = 2 * abs(far) + least
    return np.array([start - normal * reach, start, start + normal * reach])


def _polygons(region: Any) -> list[Any]:
    return list(getattr(region, "geoms", [region]))

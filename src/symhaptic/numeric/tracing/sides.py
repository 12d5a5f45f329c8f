"""The sides of a stable region: pieces of the curve, and of the lines of a root at 1 and at -1."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from symhaptic.numeric.arguments import Array
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.arcs import Loop

_ROUNDS = 30
"""Halvings of a chord at most."""


@dataclass(frozen=True)
class Piece:
    """A part of the boundary: points from corner to corner, and the angles of a curve's ends."""

    points: Array
    angles: tuple[float, float] | None = None


def at_angle(loop: Loop, angle: float) -> Array:
    """The wall of an angle, those at its ends included."""
    if angle == 0:
        return loop.begin
    if angle == np.pi and loop.end is not None:
        return loop.end
    return loop.curve(np.asarray(angle))


def curves(loop: Loop, tolerance: float) -> tuple[list[Piece], float]:
    """The curved sides with chords short enough, and the error of the chords."""
    arcs = [(a, b) for a, b in loop.arcs if b < np.pi or loop.end is not None]
    if not arcs:
        return [], 0.0
    grid = loop.samples()
    inside = [grid[(grid > a) & (grid < b)] for a, b in arcs]
    rough = [
        np.vstack([at_angle(loop, a), loop.curve(g), at_angle(loop, b)])
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


def chords(loop: Loop, bounds: tuple[float, ...], share: float) -> Array:
    """The whole boundary inside a box as chords, two ends each: the curve and the line at -1.

    They are off by less than ``share`` times delta, or times their distance from no wall at all.
    """
    low, high = np.reshape(bounds, (2, 2))
    angles = np.concatenate([[0.0], loop.samples(), [np.pi] * (loop.end is not None)])
    inner = loop.curve(angles[(angles > 0) & (angles < np.pi)])
    last, found = np.zeros((0, 2)), []
    if loop.line is not None and loop.end is not None:
        alphas = np.unique([low[0], np.clip(loop.end[0], low[0], high[0]), high[0]])
        side = np.stack([alphas, (loop.line - alphas) / 2], axis=-1)
        found.append(np.stack([side[:-1], side[1:]], axis=1))
        last = np.array([[loop.end[0], (loop.line - loop.end[0]) / 2]])  # one corner with the side
    points = np.vstack([loop.begin, inner, last])
    ends, turns = np.stack([points[:-1], points[1:]], 1), np.stack([angles[:-1], angles[1:]], 1)
    for _ in range(_ROUNDS):
        room = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)[:, None] / 8
        near = (ends.min(axis=1) - room <= high) & (ends.max(axis=1) + room >= low)
        at = np.flatnonzero(near.all(axis=1))
        ends, turns = ends[at], turns[at]
        middles = turns.mean(axis=1)
        fresh = loop.curve(middles)
        away = _distance(np.zeros(2), ends[:, 0], ends[:, 1])
        far = _distance(fresh, ends[:, 0], ends[:, 1]) > share * np.maximum(loop.delta, away)
        found.append(ends[~far])
        if not far.any():
            break
        ends, turns = (
            np.concatenate(
                [np.stack([old[far, 0], new[far]], 1), np.stack([new[far], old[far, 1]], 1)]
            )
            for old, new in ((ends, fresh), (turns, middles))
        )
    return np.concatenate(found)


def _distance(points: Array, begin: Array, end: Array) -> Array:
    """Distance of points from segments."""
    along = end - begin
    length = np.sum(along**2, axis=1)
    share = np.sum((points - begin) * along, axis=1) / np.where(length == 0, 1.0, length)
    foot = begin + np.clip(share, 0, 1)[:, None] * along
    return np.asarray(np.linalg.norm(points - foot, axis=1))


def left_sides(loop: Loop, ends: Array, near: float) -> list[Piece]:
    """The parts of the line of a root at 1, between the points where the curve meets it."""
    angles = loop.at_left
    touching = ends[np.abs(ends[:, 0] + loop.gamma) <= near, 1]
    betas = [float(loop.begin[1]), *loop.curve(angles)[:, 1], *touching]
    if loop.line is not None:
        betas.append((loop.line + loop.gamma) / 2)
    return _sides(loop, np.array([[-loop.gamma, beta] for beta in _apart(betas, near)]))


def right_sides(loop: Loop, ends: Array, near: float) -> list[Piece]:
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


def diagonal(pieces: list[Piece]) -> float:
    """Diagonal of the box around the pieces."""
    if not pieces:
        return 0.0
    return float(np.linalg.norm(np.ptp(np.vstack([p.points for p in pieces]), axis=0)))

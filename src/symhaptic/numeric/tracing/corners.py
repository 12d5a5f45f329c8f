"""The corners of a stable region, where sides meet, to full precision."""

from __future__ import annotations

import numpy as np

from symhaptic.numeric.arguments import Array
from symhaptic.numeric.tracing.arcs import Loop
from symhaptic.numeric.tracing.sides import Piece


def joined(loop: Loop, pieces: list[Piece], near: float) -> tuple[Array, list[Piece]]:
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
    steep = np.linalg.norm(loop.tangent(pair), axis=1) * np.spacing(pair)
    return np.asarray(loop.curve(pair)[np.argmin(steep)])  # an angle's last place moves it least

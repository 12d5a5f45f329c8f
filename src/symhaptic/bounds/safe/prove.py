"""How stiff a wall may be at each virtual damping so that no arm of a range makes it unstable.

A root leaves the unit circle only across it.  Walls that are joined by walls, held by arms that are
joined by arms, are all stable if one of them is and none has a root on the circle, for any arm.
So the walls are cut into columns, from one damping to the next; pieces of the circle and of the
arms are enclosed, and what they may touch is cut off, until all is shown.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from flint import ctx
from numpy.typing import NDArray

from symhaptic.bounds.safe.arms import Ends, Hands, Loops, halved
from symhaptic.bounds.safe.curve import Walls, late, walls

BITS = 64
"""Working precision."""

PI = Fraction(31415926535897933, 10**16)
"""A little more than pi: where pieces of the circle end."""

_FINE = 2**-9
"""Pieces are not halved below this relative width; what they touch is cut off."""

_EASY, _HARD = 3_000, 10_000
"""After so many pieces, and within so many more, columns give way: see :func:`shown`."""

_SPARE = 2**-9
"""What is cut off beyond what has to be: it makes it easier for the pieces nearby."""

_EACH = 2**-6
"""What a column counts that is touched, beside the share of its height that is touched."""

_BETTER = 0.98
"""Halving across another dimension than the widest has to touch less by this factor."""

_MORE = 1 + 2**-40
"""More than what a few operations on floats may be off."""


@dataclass(frozen=True)
class Columns:
    """Walls low <= K <= tops[i] with edges[i] <= B <= edges[i + 1]; a top of 0 is no column."""

    edges: tuple[float, ...]
    """Dampings in Ns/m, rising."""
    tops: tuple[float, ...]
    """Stiffnesses in N/m."""
    low: float
    """The softest wall in N/m: at 0, without a spring, nothing holds the mass."""

    def runs(self) -> list[range]:
        """Columns that stand beside each other.

        >>> Columns((0.0, 1.0, 2.0, 3.0), (5.0, 0.0, 7.0), 0.1).runs()
        [range(0, 1), range(2, 3)]
        """
        found: list[range] = []
        for i, top in enumerate(self.tops):
            if top > 0 and found and found[-1].stop == i:
                found[-1] = range(found[-1].start, i + 1)
            elif top > 0:
                found.append(range(i, i + 1))
        return found


@dataclass(frozen=True)
class Shown:
    """Columns that no root on the circle touches, and the pieces that show it."""

    columns: Columns
    cuts: str
    """The tree of pieces: ``.`` is one that touches nothing, a digit what one is halved across."""
    angles: tuple[Fraction, ...]
    """Ends of the pieces of the circle to begin with."""


class Touching:
    """Which columns a piece of the circle and of the arms may touch, and how low."""

    def __init__(self, loops: Loops, columns: Columns) -> None:
        edges, period = np.array(columns.edges), float(loops.period)
        self.left, self.right, self.low = edges[:-1], edges[1:], columns.low
        self.swing = 2 * np.maximum(abs(self.left), abs(self.right)) / period * _MORE

    def __call__(
        self, piece: Walls, tops: NDArray[np.float64]
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Numbers of the columns, and the lowest stiffness that is touched in each."""
        lowest = np.full(len(self.left), max(piece.K[0], self.low))
        highest = np.full(len(self.left), piece.K[1])
        if piece.lag is not None:
            near, far = piece.lag
            start, end = self.left + piece.held[0], self.right + piece.held[1]
            start = np.where(start > 0, start / far, start / near)
            end = np.where(end > 0, end / near, end / far)
            lowest = np.maximum(lowest, start - abs(start) * (_MORE - 1))
            highest = np.minimum(highest, end + abs(end) * (_MORE - 1))
        lowest = np.maximum(lowest, piece.size / _MORE - self.swing)
        hit = (tops > 0) & (lowest <= tops) & (lowest <= highest)
        hit &= (self.left <= piece.B[1]) & (self.right >= piece.B[0])
        (which,) = np.nonzero(hit)
        return which, lowest[which]


def circle(loops: Loops, low: float) -> tuple[Fraction, ...]:
    """Angles from 0 to pi; below the first of them no wall as stiff as ``low`` has a root."""
    most = float(loops.mass + loops.hands[0][1])
    at = Fraction(min(math.sqrt(low / most) * float(loops.period) / 2, 0.5))
    found = [Fraction(0)]
    while at < 3:
        found.append(at)
        at *= 2
    return (*found, PI)


def widest(loops: Loops, piece: Piece, K: float, B: float) -> tuple[float, int]:
    """By how much walls differ over a piece, and across what most: the angle, or h, r or s.

    Next to the angle 0 walls are unknown only if the arms differ too much.
    """
    (low, high), ((h0, h1), (r0, r1), (s0, s1)) = piece.angles, piece.hands
    mass = float(loops.mass + h1) / float(loops.mass + h0) - 1
    by_r, by_s = (float(h1) if by else 1.0 for by in loops.by_mass)
    drift = float(r1 * (h1 - h0)) if loops.by_mass[0] else 0.0
    spring = float(s1 * (h1 - h0)) if loops.by_mass[1] else 0.0
    held = 1 + float(loops.stiffness) / K  # its spring is part of what turns with the angle
    arms_alone = not low and math.isinf(piece.walls.K[0]) and any(a < b for a, b in piece.hands)
    sizes = (
        2 * (float(high / low) - 1) * held if low else 0.0 if arms_alone else 16.0,
        mass + drift / B + spring / K,
        float(r1 - r0) * by_r / B,
        float(s1 - s0) * by_s / K,
    )
    across = max(range(4), key=sizes.__getitem__)
    return sizes[across], across


def shown(loops: Loops, columns: Columns, most: int = _EASY + _HARD, fine: float = _FINE) -> Shown:
    """Lower the columns until no arm has a root on the circle for any wall in them.

    A piece that touches columns is halved.  It lowers them instead if it is ``fine`` enough, or
    if it touches their upper part alone.  That part is nothing for the first pieces and grows with
    the number of pieces, because a little height often saves most of the work.  No column is left
    if ``most`` pieces do not suffice.
    """
    touching = Touching(loops, columns)
    begun = np.array(columns.tops)
    tops = begun.copy()
    K, B = max(columns.tops), max(map(abs, columns.edges))
    cuts, looked, angles = [], 0, circle(loops, columns.low)
    with ctx.workprec(BITS):
        pieces = [Piece.of(loops, arc, loops.hands) for arc in pairwise(angles)][::-1]
        while pieces and tops.any():
            piece = pieces.pop()
            looked += 1
            which, heights = touching(piece.walls, tops)
            if len(which):
                if looked > most:
                    tops[:] = 0.0
                    break
                size, across = widest(loops, piece, K, B)
                slack = max(0.0, (looked - _EASY) / _HARD)
                if size > fine and np.any(heights <= (1 - slack) * begun[which]):
                    across, halves = best_halves(loops, piece, across, touching, tops)
                    cuts.append(str(across))
                    pieces += halves[::-1]
                    continue
                lowered = heights * (1 - _SPARE)
                tops[which] = np.where(lowered > columns.low, lowered, 0.0)
            cuts.append(".")
    late.cache_clear()
    kept = Columns(columns.edges, tuple(map(float, tops)), columns.low)
    return Shown(kept, "".join(cuts), angles)


class Piece(NamedTuple):
    """A piece of the circle and of the arms, with the walls that have a root on it."""

    angles: Ends
    hands: Hands
    walls: Walls

    @classmethod
    def of(cls, loops: Loops, angles: Ends, hands: Hands) -> Piece:
        """The piece with its walls enclosed."""
        return cls(angles, hands, walls(loops, angles, hands))


def best_halves(
    loops: Loops, piece: Piece, widest: int, touching: Touching, tops: NDArray[np.float64]
) -> tuple[int, list[Piece]]:
    """Halve a piece across the dimension after which it touches the columns least.

    The widest dimension is not always the best one: heavy arms differ much in damping, yet only
    the angle decides how large the wall's damping has to be.
    """
    found: tuple[int, list[Piece]] = (widest, [])
    least = math.inf
    box = (piece.angles, *piece.hands)
    others = (i for i in range(4) if i != widest and touching.low < tops.max())
    for across in (widest, *others):
        low, high = box[across]
        if low == high or (across == 0 and low == 0 and across != widest):
            continue
        halves = [Piece.of(loops, *half) for half in halved(piece.angles, piece.hands, across)]
        touched = 0.0
        for half in halves:
            which, heights = touching(half.walls, tops)
            touched += float(np.sum(_EACH + 1 - heights / tops[which]))
        if touched < _BETTER * least:
            found, least = (across, halves), touched
        if not touched:
            break
    return found

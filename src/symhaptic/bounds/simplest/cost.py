"""What a part costs: the largest relative error on a box when it is left out, between two bounds.

Branch and bound.  On a piece the error lies in a ball by the limits of both models there, and in
another by the error in the middle and the slopes on the piece.  The piece whose ball reaches
farthest is cut: where the error rises or falls with an interval all over it, its two ends are left,
else the interval that matters most is halved.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from heapq import heappop, heappush
from typing import NamedTuple

from flint import arb, ctx

from symhaptic.bounds.balls import exact
from symhaptic.bounds.simplest.plants import (
    BITS,
    NOTHING,
    Box,
    Found,
    Interval,
    Limit,
    NotCovered,
    NotEnclosed,
)

_PIECES = 1000
"""So many pieces of the range are tried."""

_ENOUGH = 300
"""So many for bounds that are close, where it is decided on which side of the limit they lie."""

_PATIENCE = 100
"""So many, where some have no bound and a point shows that the error is too large."""

_CLOSE = 1.01
"""The bounds of an error need not be closer than this factor."""

_SMALL = 1e-12
"""Nor closer than this."""

_ROUGH = 1.25
"""The factor for those that are not close after enough pieces."""


class Cost(NamedTuple):
    """The largest relative error on a range lies between these two."""

    least: float
    most: float


class Model(NamedTuple):
    """Another limit, and the intervals that it has no part for."""

    limit: Limit
    left_out: Sequence[int] = ()

    def __call__(self, box: Box, hint: object = None) -> Found:
        """The model's limit on a box of the whole model."""
        less = tuple(NOTHING if i in self.left_out else x for i, x in enumerate(box))
        found = self.limit(less, hint)
        none = arb(0)
        slopes = tuple(none if i in self.left_out else s for i, s in enumerate(found.slopes))
        return found._replace(slopes=slopes)


def error(whole: Limit, model: Model) -> Limit:
    """The relative error of a model's limit, reduced/whole - 1, with its slopes.

    What a small part costs is the small difference of two limits that a box has far apart.  Where
    the model is the same limit without some parts, it is also what these parts make of the limit
    on the way there, by the mean value theorem: size times slope, which is small itself.
    """

    def found(box: Box, hint: object = None) -> Found:
        hints = hint if isinstance(hint, tuple) else (None, None, None)
        full, less = whole(box, hints[0]), model(box, hints[1])
        positive(full.value)
        ratio = less.value / full.value
        error, there = ratio - 1, None
        if model.limit is whole and model.left_out:
            taken, there = _on_the_way(model, box, hints[2])
            error = _nearer(error, -taken / full.value)
            ratio = _nearer(ratio, error + 1)
        slopes = zip(less.slopes, full.slopes, strict=True)
        return Found(
            error,
            tuple((r - ratio * f) / full.value for r, f in slopes),
            (full.hint, less.hint, there),
        )

    return found


def _on_the_way(model: Model, box: Box, hint: object) -> tuple[arb, object]:
    """What the parts that are left out add to the limit, not finite where that is not known."""
    way = [
        Interval(min(x.low, Fraction(0)), max(x.high, Fraction(0))) if i in model.left_out else x
        for i, x in enumerate(box)
    ]
    try:
        found = model.limit(tuple(way), hint)
    except NotEnclosed:
        return arb("nan"), None
    parts = (found.slopes[i] * box[i].ball for i in model.left_out)
    return sum(parts, arb(0)), found.hint


def _nearer(one: arb, other: arb) -> arb:
    """What two balls around the same number have in common."""
    if not other.is_finite():
        return one
    return one.intersection(other) if one.is_finite() else other


def positive(stiffness: arb) -> None:
    """Raise where there is no stiffness to compare with."""
    if stiffness <= 0:
        raise NotCovered("the stiffness limit is not positive in some part of the range")
    if not stiffness > 0:
        raise NotEnclosed("the stiffness limit is not shown to be positive")


class _Piece(NamedTuple):
    box: Box
    hint: object = None
    """What was found on a larger box, for smaller ones to start from."""
    least: float = 0.0
    most: float = math.inf
    parts: tuple[Box, ...] = ()
    """Smaller boxes, one of which has the largest error."""


def cost(error: Limit, box: Box, rtol: float) -> Cost:
    """Bounds of the largest size of an error on a box, on one side of ``rtol`` if they can.

    Raises :class:`NotCovered` where there is no proof on some part of the box, with the reason.
    """
    with ctx.workprec(BITS):
        heap: list[tuple[float, int, _Piece]] = []
        least, tried, new = 0.0, 0, [_Piece(box)]
        while True:
            for piece in new:
                tried += 1
                known = _bounded(error, piece)
                least = max(least, known.least)
                heappush(heap, (-known.most, tried, known))
            worst = heap[0][2]
            most = max(worst.most, least)
            even = most <= least + _SMALL
            decided = most < rtol or rtol <= least or even
            close = even or most <= (_CLOSE if tried <= _ENOUGH else _ROUGH) * least
            if decided and most < math.inf and close:
                return Cost(least, most)
            if most == math.inf and rtol <= least and tried > _PATIENCE:
                return Cost(least, most)
            if tried > _PIECES or not worst.parts:
                if most == math.inf:
                    raise NotCovered("nothing is shown on some part of the range")
                return Cost(least, most)
            heappop(heap)
            new = [_Piece(part, worst.hint) for part in worst.parts]


def _bounded(error: Limit, piece: _Piece) -> _Piece:
    """The piece with bounds of its largest error."""
    box = piece.box
    middle = tuple(x.point for x in box)
    try:
        found = error(box, piece.hint)
    except NotCovered:
        raise
    except NotEnclosed:
        _at_point(error, middle, None)  # says why where it is in vain
        widest = max(range(len(box)), key=lambda i: box[i].high - box[i].low)
        return piece._replace(parts=_halved(box, widest))
    there = _at_point(error, middle, found.hint)
    ways = [s * (x.ball - exact(x.middle)) for s, x in zip(found.slopes, box, strict=True)]
    return _Piece(
        box,
        found.hint,
        max(0.0, math.nextafter(float(there.abs_lower()), 0.0)) if there.is_finite() else 0.0,
        min(_above(found.value), _above(there + sum(ways, arb(0)))),
        _faces(box, found.slopes) or _halved(box, max(range(len(box)), key=_sizes(box, ways))),
    )


def _sizes(box: Box, ways: Sequence[arb]) -> Callable[[int], float]:
    return lambda i: _above(ways[i]) if box[i].low < box[i].high else -1.0


def _halved(box: Box, across: int) -> tuple[Box, ...]:
    """The two halves of a box; none of a point."""
    if box[across].low == box[across].high:
        return ()
    return tuple((*box[:across], half, *box[across + 1 :]) for half in box[across].halves())


def _faces(box: Box, slopes: Sequence[arb]) -> tuple[Box, ...]:
    """The two ends of all intervals by which a value with these slopes rises or falls."""
    high, low = list(box), list(box)
    for i, (slope, x) in enumerate(zip(slopes, box, strict=True)):
        if slope > 0 or slope < 0:
            bottom, top = Interval(x.low, x.low), Interval(x.high, x.high)
            low[i], high[i] = (bottom, top) if slope > 0 else (top, bottom)
    return () if tuple(high) == box else (tuple(high), tuple(low))


def _at_point(error: Limit, point: Box, hint: object) -> arb:
    """The error at one point."""
    try:
        return error(point, hint).value
    except NotCovered:
        raise
    except NotEnclosed as reason:
        raise NotCovered(str(reason)) from reason


def _above(value: arb) -> float:
    """A float not below the size of any number of a ball."""
    return math.nextafter(float(value.abs_upper()), math.inf) if value.is_finite() else math.inf

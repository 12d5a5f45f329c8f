"""Zeros of functions in balls."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb

_STEPS = 50
"""Newton's steps at most: a ball around a zero at 0 would get smaller without end."""


def narrowed(value: Callable[[arb], arb], slope: Callable[[arb], arb], piece: arb) -> arb | None:
    """The only zero in a ball by Newton's interval steps, as long as they narrow it.

    The ball itself is returned if the slope has no sign on it, and None if no zero is in it.

    >>> print(narrowed(lambda x: x * x - 2, lambda x: 2 * x, arb(1).union(2)).str(10))
    [1.414213562 +/- 3.74e-10]
    """
    for _ in range(_STEPS):
        rises = slope(piece)
        if not (rises > 0 or rises < 0):
            break
        middle = arb(piece.mid())
        step = middle - value(middle) / rises
        if not step.overlaps(piece):
            return None
        less = step.intersection(piece)
        if not less.rad() < 0.9 * piece.rad():
            return less
        piece = less
    return piece

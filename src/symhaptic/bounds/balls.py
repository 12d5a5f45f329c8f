"""Balls around numbers and intervals, and the zeros of functions in balls."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import arb, fmpq

_PIECES = 600
"""So many pieces of an interval are tried."""

_LEAST = 2**-7
"""Pieces are not halved below this length."""


def exact(value: Fraction) -> arb:
    """A ball around a number."""
    return arb(fmpq(value.numerator, value.denominator))


def sinc(low: arb, high: arb) -> arb:
    """sin(x)/x between two angles from 0 on; it falls up to pi."""
    if high <= 3:
        return low.sinc().union(high.sinc())
    return low.union(high).sinc()


_STEPS = 50
"""Newton's steps at most: a ball around a zero at 0 would get smaller without end."""


class TooMany(ArithmeticError):
    """Pieces of an interval that are not decided."""


def pieces(end: float, holds: Callable[[arb], bool]) -> list[arb]:
    """Short pieces of 0 to ``end`` on which ``holds`` is true, in order; neighbours are joined.

    Raises :class:`TooMany`.
    """
    left, kept = [(0.0, end)], list[arb]()
    for _ in range(_PIECES):
        if not left:
            return kept
        low, high = left.pop()
        piece = arb(low).union(arb(high))
        if not holds(piece):
            continue
        if high - low > _LEAST:
            middle = (low + high) / 2
            left += [(middle, high), (low, middle)]  # the lower one is next
        elif kept and kept[-1].overlaps(piece):
            kept[-1] = kept[-1].union(piece)
        else:
            kept.append(piece)
    raise TooMany


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

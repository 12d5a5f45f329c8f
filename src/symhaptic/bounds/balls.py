"""Balls around numbers and intervals, and pieces of an interval."""

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

"""The whole periods of delay with which a root may be in a band of angles."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric.arguments import Array
from symhaptic.numeric.tracing.bands import ROUNDING

_AHEAD = 62
"""Beside the periods that are over, so many more are looked at together to begin with."""


_ROUNDS = 1000
"""Steps at most; tens are usual."""

EXACT = 4e-15
"""By so much of themselves phases are off of which both angles are known to the last places."""


class Window(NamedTuple):
    """Two angles, and between them the least and the greatest phase of g/f.

    Without the whole periods' part.
    """

    low: Array
    high: Array
    least: Array
    most: Array


def first_periods(window: Window, begin: Array, end: Array, rounding: float = ROUNDING) -> Array:
    """The least whole number of periods >= begin with which a root may be on the circle.

    Infinite if there is none up to ``end``; phases may be off by ``rounding`` of themselves.

    A root needs an odd number of half turns between the least and the most of the phase: a window
    of turns that moves on and widens with each period.
    """
    found = np.where(begin <= end, np.maximum(begin, 0.0), np.inf)
    left = np.flatnonzero(begin <= end)
    turn, reach = 2 * np.pi, found + _AHEAD
    for _ in range(_ROUNDS):  # then the period that is reached is the answer, which is no later
        if not left.size:
            break
        low, high, least, most = (a[left] for a in window)
        now = found[left]
        last = now + reach[left]
        blur = rounding * ((last + 2) * high / turn + 10)
        ahead = ((now + 2) * low - most - np.pi) / turn - blur
        width = ((last + 2) * (high - low) + most - least) / turn + 2 * blur
        # seen backwards, as low/turn keeps its digits where it is small
        new = now + first_step(low / turn, -(ahead + width) % 1.0, width)
        out = new > last
        new = np.where(out, last + 1, new)
        start = np.ceil(((new + 2) * low - most - np.pi) / turn - blur)
        hit = ~out & (start <= ((new + 2) * high - least - np.pi) / turn + blur)
        # the window is too wide by what it has not yet grown: when it reaches the same turn
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            later = np.ceil(((start - blur) * turn + np.pi + least) / high - 2)
        new = np.where(out | hit, new, np.maximum(new + 1, later))
        # where it only just misses, what it has grown until far ahead would meet at every step
        reach[left] = np.where(out, 2 * reach[left], np.floor(reach[left] / 4))
        over = new > end[left]
        found[left] = np.where(over, np.inf, new)
        left = left[~hit & ~over]
    return found


def first_step(turn: Array, low: Array, width: Array) -> Array:
    """The least whole x >= 0 with (turn x) mod 1 between ``low`` and ``low + width``; or infinite.

    Euclid's algorithm: if no multiple of ``turn`` is in there before the first time round, the
    number of times round obeys a condition of the same kind, modulo ``turn``.
    """
    a, m = np.array(turn, dtype=float), np.ones(turn.shape)
    low, high = np.array(low, dtype=float), low + width
    at: NDArray[np.intp] = np.arange(a.size)
    levels: list[tuple[NDArray[np.intp], Array, Array, Array]] = []
    found = np.full(a.size, np.inf)
    while at.size:
        now = (low <= 0) | (high >= m)
        found[at[now]] = 0.0
        at, (a, m, low, high) = at[~now], (v[~now] for v in (a, m, low, high))
        back = 2 * a > m
        a, low, high = (np.where(back, m - u, v) for u, v in ((a, a), (high, low), (low, high)))
        some = np.where(a > 0, a, 1.0)
        steps = np.ceil(low / some)
        now = (a > 0) & (steps * a <= high)
        found[at[now]] = steps[now]
        now |= a <= 0
        at, (a, m, low, high) = at[~now], (v[~now] for v in (a, m, low, high))
        if not at.size:
            break
        levels.append((at, a, m, low))
        a, m, low, high = -m % a, a, low % a, high % a
    for at, a, m, low in reversed(levels):
        found[at] = np.ceil((low + m * found[at]) / a)
    return found

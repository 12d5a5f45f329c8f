"""The first delay at which roots leave the circle: branch and bound over fractions of a period.

A part of the period is done with where no root can be on the circle, and where all of those that
can cross it in the same direction: then the root counts at the part's two ends tell whether one
did.  Other parts are cut in four.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric import arguments, stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.crossings import Wall, crossings, surplus
from symhaptic.numeric.plant import device
from symhaptic.numeric.tracing.bands import Bands, bands, first_periods, one_way, part_of

SHORTEST = 2.0**-20
"""Parts of a period that are not cut again."""

_LATER = 32
"""So many more whole periods are counted at the ends of such a part."""

_AT_ONCE = 8192
"""Parts that are looked at together, which bounds the memory."""

_NEWTON = 12
"""Steps of Newton's method at most; where it does not arrive, the count is bisected."""

_HALVINGS = 64
"""Halvings of a part down to the last digit of a float64."""


class Loops(NamedTuple):
    """Walls and plants."""

    v: Wall
    gamma: Array
    delta: Array

    def take(self, at: NDArray[np.intp]) -> Loops:
        """Some of them."""
        return Loops(Wall(*(a[at] for a in self.v)), self.gamma[at], self.delta[at])

    def stable(self, steps: Array, part: Array) -> NDArray[np.bool_]:
        """Whether no root is outside behind ``steps`` and a fraction of a period.

        By the kernel of all delays where the sum is one float64, as it is where parts are cut; the
        error of a sum whose larger term comes first is that term's part which is not in it.
        """
        late = steps + part
        whole = (late - steps == part) & (late <= arguments.LONGEST)
        found = np.array(
            stability.is_stable(
                self.v.alpha, self.v.beta, self.gamma, self.delta, np.where(whole, late, 0.0)
            )
        )
        left = np.flatnonzero(~whole)
        if left.size:
            some = self.take(left)
            x = device(some.gamma, some.delta, part[left])
            found[left] = stability.count(x, some.v, steps[left], False) == 0
        return found


class _Parts(NamedTuple):
    """Parts of the period from ``begin`` on, for ``steps`` whole periods and more."""

    at: NDArray[np.intp]
    begin: Array
    width: Array
    steps: Array

    def take(self, at: NDArray[Any]) -> _Parts:
        return _Parts(*(a[at] for a in self))

    def cut(self) -> _Parts:
        """Each in four."""
        width = np.repeat(self.width / 4, 4)
        begin = np.repeat(self.begin, 4) + np.tile(np.arange(4), self.at.size) * width
        return _Parts(np.repeat(self.at, 4), begin, width, np.repeat(self.steps, 4))


class _Search:
    """The first losses as far as they are known."""

    def __init__(self, loops: Loops, whole: Array) -> None:
        self.loops = loops
        self.least = whole.copy()
        """A delay with which the loop is lost, the least known; infinite if there is none."""
        self.end = np.full(whole.size, np.inf)
        """The end of the part with the first loss, that part's begin, width and whole periods."""
        self.begin, self.width, self.steps = np.zeros((3, whole.size))

    def step(self, parts: _Parts) -> _Parts:
        """What is left to be looked at."""
        parts = parts.take(parts.steps + parts.begin < self.least[parts.at])
        here = self.loops.take(parts.at)
        half = parts.width / 2
        b = bands(part_of(here.gamma, here.delta, parts.begin + half, half), here.v)
        latest = np.minimum(self.least[parts.at] - parts.begin, arguments.LONGEST)
        periods = first_periods(b, parts.steps[b.at], latest[b.at])
        first = np.full(parts.at.size, np.inf)
        np.minimum.at(first, b.at, periods)
        some = np.isfinite(first)
        way = _ways(b.take(periods == first[b.at]), first)[some]
        parts = parts.take(some)._replace(steps=first[some])
        lost = self._counted(parts)
        self._found(parts.take(lost & ((way != 0) | (parts.width <= SHORTEST))))
        last = parts.take(parts.width <= SHORTEST)
        for _ in range(_LATER if last.at.size else 0):
            last = last._replace(steps=last.steps + 1)
            last = last.take(last.steps + last.begin < self.least[last.at])
            self._found(last.take(self._counted(last)))
        left = parts._replace(steps=parts.steps + np.abs(way))
        open_ = left.steps + left.begin < self.least[left.at]
        return left.take(open_ & (left.width > SHORTEST)).cut()

    def _counted(self, parts: _Parts) -> NDArray[np.bool_]:
        """Whether loops are stable at the begin of the part and lost at the end."""
        here, end = self.loops.take(parts.at), parts.begin + parts.width
        before, after = (here.stable(parts.steps, e) for e in (parts.begin, end))
        for bad, at in ((~before, parts.begin), (~after, end)):
            np.minimum.at(self.least, parts.at[bad], (parts.steps + at)[bad])
        return before & ~after

    def _found(self, parts: _Parts) -> None:
        end = parts.steps + (parts.begin + parts.width)
        np.minimum.at(self.end, parts.at, end)
        new = end == self.end[parts.at]
        at = parts.at[new]
        self.begin[at], self.width[at] = parts.begin[new], parts.width[new]
        self.steps[at] = parts.steps[new]


def _ways(b: Bands, steps: Array) -> Array:
    """Which way all roots in the bands of each part cross; 0 where that is not known."""
    way = one_way(b, steps[b.at])
    least, most = np.ones(steps.size), -np.ones(steps.size)
    np.minimum.at(least, b.at, way)
    np.maximum.at(most, b.at, way)
    return np.where(least == most, least, 0.0)


def first_loss(loops: Loops, whole: Array) -> Array:
    """The first delay at which a loop is lost that is stable without delay.

    ``whole`` is the first whole number of periods at which it is, or infinite.
    """
    search, none = _Search(loops, whole), np.zeros(whole.size)
    stack = [_Parts(np.arange(whole.size), none, none + 1, none).cut()]
    while stack:
        parts = stack.pop()
        every = np.arange(parts.at.size)
        for begin in range(_AT_ONCE, every.size, _AT_ONCE):
            stack.append(parts.take(every[begin : begin + _AT_ONCE]))
        rest = search.step(parts.take(every[:_AT_ONCE]))
        if rest.at.size:
            stack.append(rest)
    at = np.flatnonzero(np.isfinite(search.least))
    some, least = loops.take(at), search.least[at]
    steps, low, high = search.steps[at], search.begin[at], search.begin[at] + search.width[at]
    missed = search.end[at] != least  # lost in a part where nothing could be decided
    steps = np.where(missed, np.ceil(least) - 1, steps)
    low, high = np.where(missed, 0.0, low), np.where(missed, least - steps, high)
    part = np.full(at.size, np.nan)
    for refined in (_by_newton, _by_newton_at_minus_one, _by_halves):
        left = np.flatnonzero(np.isnan(part))
        if not left.size:
            break
        here = some.take(left)
        with np.errstate(all="ignore"):
            part[left] = refined(here, steps[left], low[left], high[left])
    search.least[at] = steps + part
    return search.least


def _by_halves(loops: Loops, steps: Array, low: Array, high: Array) -> Array:
    """The fraction up to which a loop is stable that is so at ``low`` and not at ``high``."""
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        if np.all((middle == low) | (middle == high)):
            break
        stable = loops.stable(steps, middle)
        low, high = np.where(stable, middle, low), np.where(stable, high, middle)
    return low


def _by_newton(loops: Loops, steps: Array, low: Array, high: Array) -> Array:
    """The same by Newton's method for the root's angle and the fraction; NaN where it fails."""
    part = (low + high) / 2
    theta = _nearest(loops, steps, part)
    v, g, dl = loops.v, loops.gamma, loops.delta
    for _ in range(_NEWTON):
        p = part_of(g, dl, part, np.zeros_like(part))
        x, z = p.x, np.exp(1j * theta)
        m, a, w = x.m2 * z + x.m1 + x.m0 / z, z - x.a + x.e / z, v.slope * z - v.beta
        value = np.log(-m * w / a * np.exp(-1j * (steps + 2) * theta))
        turned = (x.m2 * z - x.m0 / z) / m + v.slope * z / w - (z - x.e / z) / a
        by_theta = 1j * (turned - (steps + 2))
        by_part = (p.slope0 * (1 / z - 1) + p.slope2 * (z - 1)) / m
        area = (by_theta * np.conj(by_part)).imag
        theta = theta - (value * np.conj(by_part)).imag / area
        part = part + (value * np.conj(by_theta)).imag / area
    return _checked(loops, steps, low, high, part)


def _by_newton_at_minus_one(loops: Loops, steps: Array, low: Array, high: Array) -> Array:
    """The same for a root that leaves at -1, from p(-1) alone."""
    part = (low + high) / 2
    sign = np.where(steps % 2 == 0, 1.0, -1.0)
    for _ in range(_NEWTON):
        p = part_of(loops.gamma, loops.delta, part, np.zeros_like(part))
        force = loops.v.at_minus_one
        value = sign * p.x.at_minus_one - p.x.numerator_at_minus_one * force
        part = part + value / (2 * (p.slope2 + p.slope0) * force)
    return _checked(loops, steps, low, high, part)


def _checked(loops: Loops, steps: Array, low: Array, high: Array, part: Array) -> Array:
    """The fraction if the loop is stable next to it below and lost above, else NaN."""
    inside = (part >= low) & (part <= high)
    part, near = np.where(inside, part, low), 1e-14 * (1 + steps)
    stable = loops.stable(steps, np.maximum(part - near, low))
    lost = ~loops.stable(steps, np.minimum(part + near, high))
    return np.where(inside & stable & lost, part, np.nan)


def _nearest(loops: Loops, steps: Array, part: Array) -> Array:
    """The angle at which plant and wall are equally strong and most nearly opposite."""
    x = device(loops.gamma, loops.delta, part)
    best, theta = np.full(part.size, np.inf), np.full(part.size, np.nan)
    for c in crossings(surplus(x, loops.v), False):
        angle, bare = (
            a.halves * np.pi + a.rest for a in (stability.theta(c), stability.phase(x, loops.v, c))
        )
        apart = np.abs(np.remainder(bare - (steps + 2) * angle, 2 * np.pi) - np.pi)
        nearer = c.there & (apart < best)
        best, theta = np.where(nearer, apart, best), np.where(nearer, angle, theta)
    return theta

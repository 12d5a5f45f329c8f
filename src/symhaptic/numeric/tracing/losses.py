"""The first delay at which roots leave the circle: branch and bound over fractions of a period.

A part of the period is finished where no root can be on the circle, and where all of those that
can cross it in the same direction.  That holds for many whole periods at once: where roots come
back nothing is lost, and where they leave, the first whole delay with one outside at the end of
the part has lost the loop.  Other parts are cut in four.  The parts with the smallest delays are
examined first.  Where a part is too short to be cut, or too many have been examined, the search
ends: up to the smallest delay that is left the loop is known to be stable.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.notation import sizes
from symhaptic.numeric import stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.crossings import crossings, surplus
from symhaptic.numeric.tracing.bands import Bands, bands, part_of, slopes
from symhaptic.numeric.tracing.directions import one_way
from symhaptic.numeric.tracing.loops import Loops
from symhaptic.numeric.tracing.periods import Window, first_periods

SHORTEST = 2.0**-40
"""Parts of a period that are not cut again."""

PARTS = 4096
"""Parts that are examined of each loop; loops that are hard, but not next to a root on the circle
at every delay, take up to 1500."""

_AT_ONCE = 8192
"""Parts that are examined together, which bounds the memory."""

_BEST = 64
"""Of each loop at most, the first ones: others may lie behind the first loss."""

_FIRST = 4
"""As many times that a root may leave are looked at first, then four times as many each time."""

_MANY = 2**16
"""As many at once, of all parts together."""

_NEWTON = 12
"""Steps of Newton's method at most; where it does not arrive, the count is bisected."""

_ARRIVED = 1e-15
"""A step that is no longer than this is the last one."""

_HALVINGS = 64
"""Halvings of a part down to the last digit of a float64."""


class _Parts(NamedTuple):
    """Parts of the period from ``begin`` on, for ``steps`` whole periods and more."""

    at: NDArray[np.intp]
    begin: Array
    width: Array
    steps: Array
    ahead: Array
    """As many times that a root may leave are looked at next."""

    @property
    def delay(self) -> Array:
        """The least delay in each."""
        return np.asarray(self.steps + self.begin)

    def take(self, at: NDArray[Any]) -> _Parts:
        """Some of them."""
        return _Parts(*(a[at] for a in self))

    def and_also(self, more: _Parts) -> _Parts:
        """These and others."""
        at = np.concatenate([self.at, more.at])
        rest = (np.concatenate(pair) for pair in zip(self[1:], more[1:], strict=True))
        return _Parts(at, *rest)

    def cut(self) -> _Parts:
        """Each in four."""
        width = np.repeat(self.width / 4, 4)
        begin = np.repeat(self.begin, 4) + np.tile(np.arange(4), self.at.size) * width
        steps = np.repeat(self.steps, 4)
        return _Parts(np.repeat(self.at, 4), begin, width, steps, np.full(steps.size, _FIRST))


class _Search:
    """The first losses as far as they are known."""

    def __init__(self, loops: Loops, whole: Array) -> None:
        self.loops = loops
        self.least = whole.copy()
        """A delay with which the loop is lost, the least known; infinite if there is none."""
        self.open = np.full(whole.size, np.inf)
        """The least delay at which nothing could be decided; infinite if there is none."""
        self.end = np.full(whole.size, np.inf)
        """The end of the part with the first loss, that part's begin, width and whole periods."""
        self.begin, self.width, self.steps = np.zeros((3, whole.size))

    def left(self, parts: _Parts) -> NDArray[np.bool_]:
        """Which parts may change what is known."""
        return np.asarray(parts.delay < np.minimum(self.least, self.open)[parts.at])

    def give_up(self, parts: _Parts) -> None:
        """Leave parts undecided."""
        np.minimum.at(self.open, parts.at, parts.delay)

    def step(self, parts: _Parts) -> _Parts:
        """Examine parts; what is left to be examined."""
        here = self.loops.take(parts.at)
        half = parts.width / 2
        b = bands(part_of(here.x, here.gamma, here.delta, parts.begin + half, half), here.v)
        periods, first = self._first(b, parts)
        some = np.isfinite(first)
        way, until = (a[some] for a in _ways(b, periods, first))
        parts = parts.take(some)._replace(steps=first[some])
        known, shortest = way != 0, parts.width <= SHORTEST
        self.give_up(parts.take(~known & shortest))
        out, inward = way > 0, parts.take(way < 0)._replace(steps=until[way < 0] + 1)
        more = inward.and_also(self._outward(parts.take(out), until[out]))
        return parts.take(~known & ~shortest).cut().and_also(more)

    def _first(self, b: Bands, parts: _Parts) -> tuple[Array, Array]:
        """The first whole periods with which a root may be in each band, and in each part."""
        latest = np.minimum(self.least[parts.at] - parts.begin, sizes.LONGEST)
        window = Window(b.low, b.high, b.least, b.most)
        periods = first_periods(window, parts.steps[b.at], latest[b.at])
        first = np.full(parts.at.size, np.inf)
        np.minimum.at(first, b.at, periods)
        return periods, first

    def _outward(self, parts: _Parts, until: Array) -> _Parts:
        """Note the first loss in parts where all roots cross outward: it is seen at the end.

        What is left of them is where that does not hold any more, or farther ahead.
        """
        lost = self._counted(parts)
        self._found(parts.take(lost))
        parts, until = parts.take(~lost), until[~lost]
        end = parts.begin + parts.width
        if parts.at.size == 0:
            return parts
        behind = parts._replace(steps=until + 1)
        leaves = self.loops.take(parts.at).can_leave(end)
        parts, until, end = parts.take(leaves), until[leaves], end[leaves]
        behind = behind.take(~leaves)
        for count in np.unique(parts.ahead):  # as many times for each
            some = parts.ahead == count
            behind = behind.and_also(
                self._looked_at(parts.take(some), until[some], end[some], int(count))
            )
        return behind

    def _looked_at(self, parts: _Parts, until: Array, end: Array, count: int) -> _Parts:
        """The same with the next times that a root may leave, so many of each."""
        latest = np.minimum(self.least[parts.at] - parts.begin, sizes.LONGEST)
        steps, last = self.loops.take(parts.at).leaving(parts.steps, end, count)
        near = steps <= np.minimum(until, latest)[:, None]
        lost = ~self.loops.take(parts.at).many(np.where(near, steps, 0.0), end) & near
        some = np.asarray(lost.any(axis=1))
        first = steps[np.arange(some.size), lost.argmax(axis=1)]
        first = parts._replace(steps=first).take(some)
        self._found(first.take(self._counted(first)))
        most = max(_FIRST, _MANY // max(parts.at.size, 1))
        parts = parts._replace(
            steps=np.minimum(last, until) + 1, ahead=np.full(parts.at.size, min(4 * count, most))
        )
        return parts.take(~some)

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


def _ways(b: Bands, periods: Array, first: Array) -> tuple[Array, Array]:
    """Which way all roots in the bands of each part cross, and until when; 0 if not known.

    A band in which nothing can be before ``periods`` does not count until then.
    """
    way, until = one_way(b, first[b.at])
    least, most = np.ones(first.size), -np.ones(first.size)
    now = periods == first[b.at]
    np.minimum.at(least, b.at[now], way[now])
    np.maximum.at(most, b.at[now], way[now])
    all_ = np.where(least == most, least, 0.0)
    until = np.where(way == all_[b.at], until, periods - 1)
    last = np.full(first.size, np.inf)
    np.minimum.at(last, b.at, until)
    return all_, last


def first_loss(loops: Loops, whole: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The first delay at which a loop is lost that is stable without delay.

    And where this is a lower bound only.  ``whole`` is the first whole number of periods at which
    it is lost, or infinite.
    """
    search, none = _Search(loops, whole), np.zeros(whole.size)
    parts = _Parts(np.arange(whole.size), none, none + 1, none, none).cut()
    looked = np.zeros(whole.size, dtype=int)
    while parts.at.size:
        now = _nearest_parts(parts)
        done = parts.take(now)
        looked += np.bincount(done.at, minlength=whole.size)
        parts = parts.take(~now).and_also(search.step(done))
        over = looked[parts.at] >= PARTS
        search.give_up(parts.take(over))
        parts = parts.take(~over)
        parts = parts.take(search.left(parts))
    found = _refined(search)
    bound = search.open < found * (1 - _CLOSE) - _CLOSE
    return np.where(bound, search.open, found), bound


_CLOSE = 1e-9
"""Delays that differ by less, relative to 1 + d, are as good as one."""


def _nearest_parts(parts: _Parts) -> NDArray[np.bool_]:
    """The parts with the smallest delays of each loop, as many of each."""
    order = np.lexsort((parts.delay, parts.at))
    at = parts.at[order]
    new = np.concatenate([[True], at[1:] != at[:-1]])
    rank = np.arange(at.size) - np.maximum.accumulate(np.where(new, np.arange(at.size), 0))
    most = min(_BEST, max(1, _AT_ONCE // int(new.sum())))
    found = np.zeros(at.size, dtype=bool)
    found[order[np.flatnonzero(rank < most)[:_AT_ONCE]]] = True
    return found


def _refined(search: _Search) -> Array:
    """The losses to full precision."""
    loops = search.loops
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
    going = np.ones(part.size, dtype=bool)  # each loop stops by itself, whatever is beside it
    for _ in range(_NEWTON):
        slope2, slope0 = slopes(g, dl, part)
        x, z = loops.behind(part), np.exp(1j * theta)
        m, a, w = x.m2 * z + x.m1 + x.m0 / z, z - x.a + x.e / z, v.slope * z - v.beta
        value = np.log(-m * w / a * np.exp(-1j * (steps + 2) * theta))
        turned = (x.m2 * z - x.m0 / z) / m + v.slope * z / w - (z - x.e / z) / a
        by_theta = 1j * (turned - (steps + 2))
        by_part = (slope0 * (1 / z - 1) + slope2 * (z - 1)) / m
        area = (by_theta * np.conj(by_part)).imag
        moved = np.where(going, (value * np.conj(by_theta)).imag / area, 0.0)
        theta = theta - np.where(going, (value * np.conj(by_part)).imag / area, 0.0)
        part = part + moved
        going &= np.abs(moved) > _ARRIVED
        if not going.any():
            break
    return _checked(loops, steps, low, high, part)


def _by_newton_at_minus_one(loops: Loops, steps: Array, low: Array, high: Array) -> Array:
    """The same for a root that leaves at -1, from p(-1) alone."""
    part = (low + high) / 2
    sign = np.where(steps % 2 == 0, 1.0, -1.0)
    for _ in range(_NEWTON):
        x, force = loops.behind(part), loops.v.at_minus_one
        value = sign * x.at_minus_one - x.numerator_at_minus_one * force
        part = part + value / (2 * sum(slopes(loops.gamma, loops.delta, part)) * force)
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
    x = loops.behind(part)
    best, theta = np.full(part.size, np.inf), np.full(part.size, np.nan)
    for c in crossings(surplus(x, loops.v), False):
        angle, bare = (
            a.halves * np.pi + a.rest for a in (stability.theta(c), stability.phase(x, loops.v, c))
        )
        apart = np.abs(np.remainder(bare - (steps + 2) * angle, 2 * np.pi) - np.pi)
        nearer = c.there & (apart < best)
        best, theta = np.where(nearer, apart, best), np.where(nearer, angle, theta)
    return theta

r"""Where roots can be on the unit circle while the delay runs through part of a period.

For all fractions in ``middle`` +- ``half`` at once, and any number of whole periods.  With the
impulse response g of the device the coefficients behind a fraction change by
:math:`m_2'=-g(1-\varepsilon)` and :math:`m_0'=e^{-\delta(1-\varepsilon)}g(\varepsilon)`, and these
slopes by at most 1 per period, as a passive device never moves faster than it was pushed.  So
:math:`|M|^2` is that of the middle within a multiple of y, and :math:`|A|=|M|\,|W|` can hold on
bands of angles between the roots of two cubics only.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric import cubic, stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.crossings import Crossing, Surplus, Wall, surplus
from symhaptic.numeric.cubic import Terms
from symhaptic.numeric.plant import Device, device, impulse

_ROUNDING = 1e-13
"""Phases are taken to be off by this much of themselves."""

_TURNS = 1000
"""Turns of the phase that are looked at before a weaker bound is given."""


class Part(NamedTuple):
    """The device while the delay's fraction is within ``middle`` +- ``half``."""

    x: Device
    """In the middle."""
    half: Array
    slope2: Array
    """m2' in the middle."""
    slope0: Array
    """m0' in the middle."""
    change: Array
    """The most by which m2 and m0 change, together."""


def part_of(gamma: Array, delta: Array, middle: Array, half: Array) -> Part:
    """The device while the delay's fraction is within ``middle`` +- ``half``."""
    rest = 1 - middle
    slope2 = -impulse(gamma, delta, rest)
    slope0 = np.exp(-delta * rest) * impulse(gamma, delta, middle)
    change = half * (np.abs(slope2) + np.abs(slope0) + half)
    return Part(device(gamma, delta, middle), half, slope2, slope0, change)


class Bands(NamedTuple):
    """Bands of angles of many walls, one after the other."""

    at: NDArray[np.intp]
    """The number of each band's wall."""
    part: Part
    v: Wall
    low: Array
    """The least angle."""
    high: Array
    least: Array
    """The least phase of g/f without the delay's whole periods, up to a number of turns."""
    most: Array
    y: Array
    """4 sin(theta/2)^2 inside the band."""
    rest: Array
    off: Array
    top: Array
    """The largest y."""

    def take(self, at: NDArray[np.bool_]) -> Bands:
        """Some of them."""
        part = Part(Device(*(a[at] for a in self.part.x)), *(a[at] for a in self.part[1:]))
        rest = (a[at] for a in self[3:])
        return Bands(self.at[at], part, Wall(*(a[at] for a in self.v)), *rest)


def bands(p: Part, v: Wall) -> Bands:
    """Where plant and wall can be equally strong, with the phases that they can have there."""
    x, change = p.x, p.change
    near = change * (2 * np.abs(x.m2 - x.m0) + change + x.numerator_at_one)
    far = change * (np.abs(x.numerator_at_minus_one) + change)
    middle = surplus(x, v)
    room = _room(middle, v, np.maximum(near, far))
    none = np.zeros_like(middle.center)
    end = np.stack([none + 4, none, middle.beyond])
    cuts = [np.stack([none, none + 4, -middle.center]), end]
    for sign in (1.0, -1.0):
        for y, rest, off, _, there in cubic.roots(*_moved(middle, room, sign)):
            cuts.append(np.where(there, [y, rest, off], end))
    edges = np.stack(cuts)  # edge, (y, rest, off), wall
    edges = np.take_along_axis(edges, np.argsort(edges[:, 2:], axis=0), axis=0)
    first, last = edges[:-1], edges[1:]
    inner = np.moveaxis((first + last) / 2, 1, 0)
    possible = np.abs(_at(middle, *inner)) <= _at(room, *inner)
    row, at = np.nonzero(possible & (last[:, 2] > first[:, 2]))
    some = Part(Device(*(a[at] for a in p.x)), *(a[at] for a in p[1:]))
    walls = Wall(*(a[at] for a in v))
    ends = [_point(*e[row, :, at].T) for e in (first, last)]
    angles = [stability.theta(c) for c in ends]
    low, high = (a.halves * np.pi + a.rest for a in angles)
    least, most = _phases(some, walls, ends)
    y, rest, off = (a[row, at] for a in inner)
    return Bands(at, some, walls, low, high, least, most, y, rest, off, ends[1].y)


def _point(y: Array, rest: Array, off: Array) -> Crossing:
    return Crossing(y, rest, off, np.asarray(np.True_), np.asarray(np.True_))


def _room(s: Surplus, v: Wall, change: Array) -> Surplus:
    """change y |W|^2, by which the surplus can differ from that in the middle."""
    force, size, last = v.slope * v.beta, v.alpha**2, v.at_minus_one**2
    own = size + force * s.center
    none = np.zeros_like(change)
    return Surplus(
        (none, change * size, change * force, none),
        (change * s.center * own, change * (own + force * s.center), change * force, none),
        (change * 4 * last, -change * (last + 4 * force), change * force, none),
        s.center,
        s.beyond,
    )


def _moved(s: Surplus, room: Surplus, sign: float) -> Surplus:
    def moved(k: Terms, more: Terms) -> Terms:
        return tuple(c + sign * m for c, m in zip(k, more, strict=True))

    near, own, far = (moved(k, more) for k, more in zip(s[:3], room[:3], strict=True))
    return Surplus(near, own, far, s.center, s.beyond)


def _at(s: Surplus, y: Array, rest: Array, off: Array) -> Array:
    """The polynomial's value, from the expansion about the nearest of three points."""
    edge = np.minimum(y, rest)
    value = np.where(y < rest, cubic.value(s.near, y), cubic.value(s.far, rest))
    return np.where(np.abs(off) < edge, cubic.value(s.own, off), value)


def _phases(p: Part, v: Wall, ends: list[Crossing]) -> tuple[Array, Array]:
    """The least and the greatest phase of g/f, without the whole periods' part.

    The angle of A/z rises; those of M/z and of the wall turn back at one y at most.
    """
    x = p.x
    below = [_sum(stability.below(x, c)) for c in ends]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        turn_m = 2 * x.numerator_at_one / x.m1, -2 * x.numerator_at_minus_one / x.m1
        turn_w = -2 * v.alpha / v.beta, 2 * v.at_minus_one / v.beta
    inside = [_between(ends, *turn) for turn in (turn_m, turn_w)]
    above = np.stack([_sum(stability.above(x, c)) for c in (*ends, inside[0])])
    force = np.stack([_sum(stability.force(v, c)) for c in (*ends, inside[1])])
    # |M|^2 is a quadratic in y: least at an end or at its own extremum
    product, total = x.m2 * x.m0, x.numerator_at_one
    linear = (x.m2 - x.m0) ** 2 - total * (x.m2 + x.m0)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        own = np.nan_to_num(-linear / (2 * product), nan=0.0)
    sizes = [
        total**2 + (linear + product * y) * y
        for y in (ends[0].y, ends[1].y, np.clip(own, ends[0].y, ends[1].y))
    ]
    smallest = np.sqrt(np.maximum(np.min(sizes, axis=0), 0.0))
    moves = p.change * np.sqrt(ends[1].y)
    sure = moves < smallest
    spread = np.where(
        sure, np.arcsin(np.where(sure, moves / np.where(sure, smallest, 1), 0)), np.pi
    )
    least = above.min(axis=0) + force.min(axis=0) - below[1] - spread
    most = above.max(axis=0) + force.max(axis=0) - below[0] + spread
    return least, most


def _sum(angle: stability.Angle) -> Array:
    return np.asarray(angle.halves * np.pi + angle.rest)


def _between(ends: list[Crossing], y: Array, rest: Array) -> Crossing:
    """The point inside the band, or the lower end of it where it is not inside."""
    one, two = ends
    inside = (y > one.y) & (y < two.y)
    return one._replace(y=np.where(inside, y, one.y), rest=np.where(inside, rest, one.rest))


def first_periods(b: Bands, begin: Array, end: Array) -> Array:
    """The least whole number of periods >= begin with which a root may be on the circle.

    Infinite if there is none up to ``end``; where many turns bring none, a number below which
    there is none.
    """
    found = np.maximum(begin, 0.0)
    left = np.arange(found.size)
    before = np.full(found.size, -np.inf)
    for _ in range(_TURNS):
        if not left.size:
            break
        low, high, least, most = (a[left] for a in (b.low, b.high, b.least, b.most))
        now = found[left]
        turns = np.ceil((((now + 2) * low - most) / np.pi - 1) / 2 - _ROUNDING * (now + 2))
        before[left] = turns = np.maximum(turns, before[left] + 1)
        odd = (2 * turns + 1) * np.pi
        blur = _ROUNDING * (np.abs(odd) + 10)
        with np.errstate(divide="ignore", invalid="ignore"):
            first = np.ceil((odd + least - blur) / high - 2)
            last = (odd + most + blur) / low - 2  # infinite for a band that begins at 0
        new = np.maximum(now, first)
        hit = ~(new > last)
        new = np.where(new > end[left], np.inf, new)
        found[left] = np.where(hit, new, np.maximum(new, np.floor(last) + 1))
        left = left[~hit & np.isfinite(found[left])]
    return found


def one_way(b: Bands, steps: Array) -> Array:
    """1 or -1 where every root of the band crosses outward or inward with the delay, else 0.

    A root z moves with the fraction by d ln z = -h/Z, where h is the logarithmic derivative of M
    by the fraction and Z that of g/f by ln z; balls around both decide the sign of the real part.
    """
    p, x, v = b.part, b.part.x, b.v
    sine, cosine = np.sqrt(b.y * b.rest) / 2, (b.rest - b.y) / 4
    theta = 2 * np.arctan2(np.sqrt(b.y), np.sqrt(b.rest))
    reach = np.maximum(theta - b.low, b.high - theta)
    both, over = x.m2 + x.m0, np.sqrt(b.top)
    size = np.abs(x.m2) + np.abs(x.m0)
    late = (x.numerator_at_one * b.rest - x.numerator_at_minus_one * b.y) / 4
    push = (v.alpha * b.rest - v.at_minus_one * b.y) / 4
    plant = _Ball(-(1 + x.e) * b.off / 2 + 1j * x.loss * sine, (1 + x.e) * reach)
    turned = _Ball(x.loss * cosine + 1j * (1 + x.e) * sine, (1 + x.e) * reach)
    force = _Ball(late + 1j * (x.m2 - x.m0) * sine, size * reach + p.change * over)
    shape = _Ball((x.m2 - x.m0) * cosine + 1j * both * sine, size * reach + p.change)
    wall = _Ball(push + 1j * v.slope * sine, np.abs(v.slope) * reach)
    round_ = _Ball(v.slope * cosine + 1j * v.slope * sine, np.abs(v.slope) * reach)
    rise = _Ball(
        -b.y / 2 * (p.slope2 + p.slope0) + 1j * sine * (p.slope2 - p.slope0),
        (np.abs(p.slope2) + np.abs(p.slope0)) * reach + 2 * p.half * over,
    )
    parts = shape / force, round_ / wall, turned / plant
    moved = parts[0].center + parts[1].center - parts[2].center - (steps + 2)
    reach = parts[0].radius + parts[1].radius + parts[2].radius
    h = rise / force
    real = -(h.center * np.conj(moved)).real
    off = np.abs(h.center) * reach + (np.abs(moved) + reach) * h.radius
    return np.where(np.abs(real) > off * (1 + _ROUNDING), np.sign(real), 0.0)


class _Ball(NamedTuple):
    """Complex numbers at most ``radius`` from ``center``."""

    center: NDArray[Any]
    radius: Array

    def __truediv__(self, other: _Ball) -> _Ball:
        size = np.abs(other.center) - other.radius
        sure = size > 0
        quotient = self.center / np.where(sure, other.center, 1.0)
        grown = self.radius + np.abs(quotient) * other.radius
        return _Ball(quotient, np.where(sure, grown / np.where(sure, size, 1.0), np.inf))

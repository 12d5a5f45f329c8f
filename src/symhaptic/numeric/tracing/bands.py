r"""Where roots can be on the unit circle while the delay runs through part of a period.

For all fractions in ``middle`` +- ``half`` at once, and any number of whole periods.  With the
impulse response g of the device the coefficients behind a fraction change by
:math:`m_2'=-g(1-\varepsilon)` and :math:`m_0'=e^{-\delta(1-\varepsilon)}g(\varepsilon)`.  On the
circle :math:`M/z=N-\tfrac y2S+jD\sin\theta` with their sum S and their difference D, whose slopes
change by at most 2 per period, as a passive device never moves faster than it was pushed.  One
that swings with :math:`w^2=\gamma-\delta^2/4` has

.. math:: S'=\tfrac{e^{-\delta(1-\varepsilon)/2}}w
   (e^{-\delta/2}\sin w\varepsilon-\sin w(1-\varepsilon)),

D' with a sum in place of the difference, so that by
:math:`\sin a-\sin b=2\cos\frac{a+b}2\sin\frac{a-b}2` the slope of S changes by at most
:math:`(1+\frac\delta{2w})(1-e^{-\delta/2}+2|\cos\frac w2|)`, that of D likewise with a sine:
next to half swings in a period S hardly moves at all, next to whole ones D.  So :math:`|M|^2` is
that of the middle, and its slope there times the way, within :math:`y(P(4-y)+Qy)/4`, and
:math:`|A|=|M|\,|W|` can hold on bands of angles between the roots of four cubics only.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric import cubic, stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.crossings import Crossing, Surplus, Wall, surplus
from symhaptic.numeric.cubic import Terms
from symhaptic.numeric.plant import Device, behind, impulse, swing

_ROUNDING = 1e-13
"""Phases are taken to be off by this much of themselves."""

_AHEAD = 62
"""Beside the periods that are over, so many more are looked at together."""


class Part(NamedTuple):
    """The device while the delay's fraction is within ``middle`` +- ``half``."""

    x: Device
    """In the middle."""
    half: Array
    sum_slope: Array
    """S' in the middle, where S = m2 + m0."""
    gap_slope: Array
    """D' in the middle, where D = m2 - m0."""
    sum_turn: Array
    """The most by which S' differs from that in the middle."""
    gap_turn: Array
    sum_change: Array
    """The most by which S differs from that in the middle."""
    gap_change: Array


def slopes(gamma: Array, delta: Array, part: Array) -> tuple[Array, Array]:
    """m2' and m0'."""
    rest = 1 - part
    return -impulse(gamma, delta, rest), np.exp(-delta * rest) * impulse(gamma, delta, part)


def part_of(undelayed: Device, gamma: Array, delta: Array, middle: Array, half: Array) -> Part:
    """The device while the delay's fraction is within ``middle`` +- ``half``."""
    slope2, slope0 = slopes(gamma, delta, middle)
    v = swing(gamma, delta, middle)
    grown, slope, turn = 1 + delta / (2 * v.w), [], []
    creep = slope2 + slope0, slope2 - slope0
    for slow, fast, share in zip(creep, v.slopes(), (v.cosine, v.sine), strict=True):
        slope.append(np.where(v.there, fast, slow))
        most = np.minimum(grown * (v.lost + 2 * np.abs(share)), 2.0)
        turn.append(half * np.where(v.there, most, 2.0))
    change = [half * (np.abs(now) + most / 2) for now, most in zip(slope, turn, strict=True)]
    return Part(behind(undelayed, gamma, delta, middle), half, *slope, *turn, *change)


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
    reach: Array
    """The most by which the angle differs from that of y."""
    away: Array
    """The most by which y/2 does."""
    top: Array
    """The largest y."""
    sine: Array
    """The largest sine."""

    def take(self, at: NDArray[np.bool_]) -> Bands:
        """Some of them."""
        part = Part(Device(*(a[at] for a in self.part.x)), *(a[at] for a in self.part[1:]))
        rest = (a[at] for a in self[3:])
        return Bands(self.at[at], part, Wall(*(a[at] for a in self.v)), *rest)


def bands(p: Part, v: Wall) -> Bands:
    """Where plant and wall can be equally strong, with the phases that they can have there."""
    middle = surplus(p.x, v)
    way, room = _trend(p, v), _room(p, v)
    none = np.zeros_like(middle.center)
    end = np.stack([none + 4, none, middle.beyond])
    cuts = [np.stack([none, none + 4, -middle.center]), end]
    for y, rest, off, _, there in cubic.roots(*_moved(middle, way, room)):
        cuts += list(np.where(there, [y, rest, off], end[:, None]).swapaxes(0, 1))
    edges = np.stack(cuts)  # edge, (y, rest, off), wall
    y, rest, off = np.moveaxis(edges, 1, 0)  # each has the digits of the others next to its 0
    order = np.lexsort((-rest, y, off), axis=0)
    edges = np.take_along_axis(edges, order[:, None], axis=0)
    at, first, last = _runs(middle, way, room, edges)
    some = Part(Device(*(a[at] for a in p.x)), *(a[at] for a in p[1:]))
    walls = Wall(*(a[at] for a in v))
    ends = [_point(*e.T) for e in (first, last)]
    angles = [stability.theta(c) for c in ends]
    low, high = (a.halves * np.pi + a.rest for a in angles)
    least, most = _phases(some, walls, ends)
    y, rest, off = ((first + last) / 2).T
    theta = 2 * np.arctan2(np.sqrt(y), np.sqrt(rest))
    reach = np.maximum(theta - low, high - theta)
    sizes = np.maximum(np.abs(first), np.abs(last))
    finest = sizes.argmin(axis=1)[:, None]  # the distances with the most digits
    away = np.abs(np.take_along_axis(last - first, finest, axis=1)[:, 0]) / 4
    more = least, most, y, rest, off, reach, away, ends[1].y, _widest(*ends)
    return Bands(at, some, walls, low, high, *more)


def _point(y: Array, rest: Array, off: Array) -> Crossing:
    return Crossing(y, rest, off, np.asarray(np.True_), np.asarray(np.True_))


def _runs(
    middle: Surplus, way: Surplus, room: Surplus, edges: Array
) -> tuple[NDArray[np.intp], Array, Array]:
    """The walls of neighbouring pieces between edges on which |f| = |g| is possible, their ends."""
    first, last = edges[:-1], edges[1:]
    inner = np.moveaxis((first + last) / 2, 1, 0)
    most = np.abs(_at(way, *inner)) + _at(room, *inner)
    open_ = (np.abs(_at(middle, *inner)) <= most) | (first == last).all(axis=1)
    shut = np.zeros_like(open_[:1])
    begins = open_ & ~np.concatenate([shut, open_[:-1]])
    stops = open_ & ~np.concatenate([open_[1:], shut])
    at, row = np.nonzero(begins.T)
    at_stop, row_stop = np.nonzero(stops.T)  # as many of each wall, in the same order
    low, high = first[row, :, at], last[row_stop, :, at_stop]
    wide = (low != high).any(axis=1)
    return at[wide], low[wide], high[wide]


def _trend(p: Part, v: Wall) -> Surplus:
    """How the surplus changes over half the part, by its slope in the middle."""
    x = p.x
    bends = 2 * x.gap * p.gap_slope - x.numerator_at_one * p.sum_slope
    far = p.sum_slope * x.numerator_at_minus_one
    return _spread(p, v, p.half * bends, p.half * far)


def _room(p: Part, v: Wall) -> Surplus:
    """The most by which it changes besides."""
    x, sums, gaps = p.x, p.sum_turn * p.half / 2, p.gap_turn * p.half / 2
    near = x.numerator_at_one * sums + 2 * np.abs(x.gap) * gaps + p.gap_change**2
    far = np.abs(x.numerator_at_minus_one) * sums + p.sum_change**2
    return _spread(p, v, near, far)


def _spread(p: Part, v: Wall, near: Array, far: Array) -> Surplus:
    """y (near (4 - y) + far y)/4 |W|^2."""
    center, beyond = 2 * p.x.at_one / (1 + p.x.e), 2 * p.x.at_minus_one / (1 + p.x.e)
    tilt, own = (far - near) / 4, (near * beyond + far * center) / 4
    force, size, last = v.slope * v.beta, v.alpha**2, v.at_minus_one**2
    there = size + force * center
    none = np.zeros_like(near)
    return Surplus(
        (none, near * size, near * force + tilt * size, tilt * force),
        (
            center * own * there,
            (own + center * tilt) * there + center * own * force,
            tilt * there + (own + center * tilt) * force,
            tilt * force,
        ),
        (
            4 * far * last,
            -(far + 4 * tilt) * last - 4 * far * force,
            tilt * last + (far + 4 * tilt) * force,
            -tilt * force,
        ),
        center,
        beyond,
    )


def _moved(s: Surplus, way: Surplus, room: Surplus) -> Surplus:
    """The four polynomials between whose roots the surplus can vanish."""
    along, across = np.array([[1.0, 1, -1, -1], [1, -1, 1, -1]])[:, :, None]

    def moved(k: Terms, one: Terms, more: Terms) -> Terms:
        return tuple(c + along * t + across * r for c, t, r in zip(k, one, more, strict=True))

    near, own, far = (moved(*k) for k in zip(s[:3], way[:3], room[:3], strict=True))
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
    linear = x.gap**2 - total * (x.m2 + x.m0)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        own = np.nan_to_num(-linear / (2 * product), nan=0.0)
    extremum = _between(ends, own, 4 - own)
    smallest = np.sqrt(np.min([_square(x, c.y, c.rest) for c in (*ends, extremum)], axis=0))
    moves = _moves(p, ends[1].y, _widest(*ends))
    sure = moves < smallest
    spread = np.where(
        sure, np.arcsin(np.where(sure, moves / np.where(sure, smallest, 1), 0)), np.pi
    )
    least = above.min(axis=0) + force.min(axis=0) - below[1] - spread
    most = above.max(axis=0) + force.max(axis=0) - below[0] + spread
    return least, most


def _square(x: Device, y: Array, rest: Array) -> Array:
    """|M|^2."""
    real = (x.numerator_at_one * rest - x.numerator_at_minus_one * y) / 4
    return np.asarray(real**2 + x.gap**2 * (y * rest / 4))


def _widest(low: Crossing, high: Crossing) -> Array:
    """The largest sine in a band."""
    middle = (low.y < 2) & (high.y > 2)
    ends = np.maximum(low.y * low.rest, high.y * high.rest)
    return np.asarray(np.where(middle, 1.0, np.sqrt(ends) / 2))


def _moves(p: Part, top: Array, sine: Array) -> Array:
    """The most by which M differs from that in the middle."""
    return np.asarray(np.hypot(top / 2 * p.sum_change, sine * p.gap_change))


def _sum(angle: stability.Angle) -> Array:
    return np.asarray(angle.halves * np.pi + angle.rest)


def _between(ends: list[Crossing], y: Array, rest: Array) -> Crossing:
    """The point inside the band, or the lower end of it where it is not inside."""
    one, two = ends
    near = (y > one.y) & (y < two.y), (rest > two.rest) & (rest < one.rest)
    inside = np.where(y < rest, *near)  # by the one that has its digits
    return one._replace(y=np.where(inside, y, one.y), rest=np.where(inside, rest, one.rest))


def first_periods(b: Bands, begin: Array, end: Array) -> Array:
    """The least whole number of periods >= begin with which a root may be on the circle.

    Infinite if there is none up to ``end``.  A root needs an odd number of half turns between
    the least and the most of the phase: a window of turns that moves on and widens with each
    period.
    """
    found = np.where(begin <= end, np.maximum(begin, 0.0), np.inf)
    left = np.flatnonzero(begin <= end)
    turn = 2 * np.pi
    while left.size:
        low, high, least, most = (a[left] for a in (b.low, b.high, b.least, b.most))
        now = found[left]
        last = 2 * now + _AHEAD
        blur = _ROUNDING * (last + 10)
        ahead = ((now + 2) * low - most - np.pi) / turn - blur
        width = ((last + 2) * (high - low) + most - least) / turn + 2 * blur
        new = now + first_step(-low / turn % 1.0, ahead % 1.0, width)
        out = new > last
        new = np.where(out, last + 1, new)
        start = np.ceil(((new + 2) * low - most - np.pi) / turn - blur)
        hit = ~out & (start <= ((new + 2) * high - least - np.pi) / turn + blur)
        # the window is too wide by what it has not yet grown: when it reaches the same turn
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            later = np.ceil(((start - blur) * turn + np.pi + least) / high - 2)
        new = np.where(out | hit, new, np.maximum(new + 1, later))
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


def one_way(b: Bands, steps: Array) -> tuple[Array, Array]:
    """1 or -1 where every root of the band crosses outward or inward with the delay, else 0.

    And the number of periods up to which that holds.  A root z moves with the fraction by
    d ln z = -h/Z, where h is the logarithmic derivative of M by the fraction and Z that of g/f by
    ln z; boxes around both decide the sign of the real part.  A period more takes 1 from Z: it
    adds Re h to what decides, and the error of Re h to what it has to exceed.
    """
    p, x, v = b.part, b.part.x, b.v
    sine, cosine = np.sqrt(b.y * b.rest) / 2, (b.rest - b.y) / 4
    sums, gaps, reach, away = x.m2 + x.m0, x.gap, b.reach, b.away
    late = (x.numerator_at_one * b.rest - x.numerator_at_minus_one * b.y) / 4
    push = (v.alpha * b.rest - v.at_minus_one * b.y) / 4
    total = 1 + x.e
    plant = _box(-total * b.off / 2, x.loss * sine, total * away, x.loss * reach)
    turned = _box(x.loss * cosine, total * sine, x.loss * away, total * reach)
    wall = _box(push, v.slope * sine, v.slope * away, v.slope * reach)
    round_ = _box(v.slope * cosine, v.slope * sine, v.slope * away, v.slope * reach)
    low, high = b.top / 2, b.sine
    force = _box(late, gaps * sine, np.abs(sums) * away + low * p.sum_change,
                 np.abs(gaps) * reach + high * p.gap_change)  # fmt: skip
    shape = _box(gaps * cosine, sums * sine, np.abs(gaps) * away + p.gap_change,
                 np.abs(sums) * reach + high * p.sum_change)  # fmt: skip
    rise = _box(-p.sum_slope * b.y / 2, p.gap_slope * sine,
                np.abs(p.sum_slope) * away + low * p.sum_turn,
                np.abs(p.gap_slope) * reach + high * p.gap_turn)  # fmt: skip
    parts = shape / force, round_ / wall, turned / plant
    moved = parts[0].center + parts[1].center - parts[2].center - (steps + 2)
    along, across = (sum(errors) for errors in zip(*(part[1:] for part in parts), strict=True))
    h = rise / force
    real = -(h.center * np.conj(moved)).real
    with np.errstate(invalid="ignore"):  # a box without end decides nothing: NaN
        off = np.abs(h.center.real) * along + np.abs(h.center.imag) * across
        off += h.along * (np.abs(moved.real) + along) + h.across * (np.abs(moved.imag) + across)
        off *= 1 + _ROUNDING
    way = np.where(np.abs(real) > off, np.sign(real), 0.0)
    lost = h.along * (1 + _ROUNDING) - way * h.center.real
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        more = np.where(lost > 0, (np.abs(real) - off) / lost, np.inf)
    return way, np.where(way == 0, steps, steps + np.floor(more))


class _Box(NamedTuple):
    """Complex numbers that differ from ``center`` by at most so much."""

    center: NDArray[Any]
    along: Array
    """In the real part."""
    across: Array
    """In the imaginary part."""

    def __truediv__(self, other: _Box) -> _Box:
        size = np.abs(other.center)
        off = np.hypot(other.along, other.across)
        sure = size > off
        unit, size = np.where(sure, other.center / np.where(sure, size, 1.0), 1.0), size - off
        quotient = self.center / np.where(sure, other.center, 1.0)
        real, up = np.abs(quotient.real), np.abs(quotient.imag)
        # (a + da)/(b + db) - a/b = (da - a/b db)/b (1 - db/(b + db))
        x = self.along + real * other.along + up * other.across
        y = self.across + real * other.across + up * other.along
        turned = np.abs(unit.real), np.abs(unit.imag)
        more, room = np.hypot(x, y) * off, np.where(sure, size, 1.0)
        whole = size + off
        errors = (
            np.where(sure, (part + more / room) / np.where(sure, whole, 1.0), np.inf)
            for part in (x * turned[0] + y * turned[1], y * turned[0] + x * turned[1])
        )
        return _Box(quotient, *errors)


def _box(real: Array, up: Array, along: Array, across: Array) -> _Box:
    return _Box(real + 1j * up, np.abs(along), np.abs(across))

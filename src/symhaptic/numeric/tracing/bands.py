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

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric import cubic, stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.crossings import Crossing, Surplus, Wall, surplus
from symhaptic.numeric.cubic import Terms
from symhaptic.numeric.plant import Device, behind, impulse, swing

ROUNDING = 1e-13
"""Phases are taken to be off by this much of themselves."""


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
    creep, bent = (slope2 + slope0, slope2 - slope0), _bent(gamma, delta, 1 - middle - half)
    for slow, fast, share in zip(creep, v.slopes(), (v.cosine, v.sine), strict=True):
        slope.append(np.where(v.there, fast, slow))
        most = np.minimum(grown * (v.lost + 2 * np.abs(share)), 2.0)
        turn.append(half * np.where(v.there, most, bent))
    change = [half * (np.abs(now) + most / 2) for now, most in zip(slope, turn, strict=True)]
    return Part(behind(undelayed, gamma, delta, middle), half, *slope, *turn, *change)


def _bent(gamma: Array, delta: Array, rest: Array) -> Array:
    """The most by which m2' and m0' of an overdamped device change, with so much of a period left.

    Of its poles -p and -q the speed is g' = (p exp(-p t) - q exp(-q t))/(p - q), and the second
    derivatives are g'(1 - epsilon) and exp(-delta (1 - epsilon)) (delta g + g')(epsilon).
    """
    root = np.sqrt(np.maximum(delta**2 / 4 - gamma, 0))
    p = delta / 2 + root
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        slow, share = gamma / p, p / (2 * root)
        speed = share * (np.exp(-p * rest) + slow / p * np.exp(-slow * rest))
        most = speed + 2 * share * (1 + slow / p) * np.exp(-delta * rest)
    return np.asarray(np.fmin(most, 2.0))


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
    # a band without width is a crossing that is known to the last digit, or an end of the circle
    there = (low != high).any(axis=1) | ((low[:, 0] > 0) & (low[:, 1] > 0))
    return at[there], low[there], high[there]


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
    # |W|^2 at the own frequency, where size + force center would lose its digits next to pi
    wave = (v.alpha * beyond - v.at_minus_one * center) / 4
    there = wave**2 + v.slope**2 * (center * beyond / 4)
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

"""The largest stable stiffness at a given virtual damping, for all plants of a box, in one ball.

On the line of one beta the number of roots outside can only change where a root lies on the unit
circle: at alpha = -gamma, where the line crosses the explicit boundary, and at one wall with a
root at -1.  Between those, one wall of one plant tells about all; Schur's reduction decides it in
balls.  From some stiffness on a coefficient is too large for a stable polynomial.  Nothing else is
needed: this holds for every spring and damper, and every whole delay.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache, lru_cache
from itertools import accumulate, pairwise
from typing import NamedTuple

import sympy as sp
from flint import arb, arb_poly

from symhaptic.balls.zeros import narrowed
from symhaptic.bounds.balls import TooMany, exact, pieces
from symhaptic.bounds.simplest.cost import positive
from symhaptic.bounds.simplest.plants import (
    NAMES,
    Box,
    Found,
    Limit,
    NotEnclosed,
    Numbers,
    chained,
    compiled,
    numbers,
)
from symhaptic.loops.number import all_inside
from symhaptic.model import linear
from symhaptic.model.plant import Sampled
from symhaptic.notation import a, delta, e, gamma, n_0, n_1, nu, s_1, s_2
from symhaptic.proof.derivative import derivative
from symhaptic.proof.plants import BALLS, TOGETHER

LIGHT = sp.Symbol("1/(n_1+n_0)")

SHAPE = (nu, s_1, LIGHT, gamma, delta)
"""What the boundary's coefficients contain."""


class _Part(NamedTuple):
    """A polynomial in y = 4 sin(theta/2)^2, and its slopes by gamma and delta."""

    value: arb_poly
    by_gamma: arb_poly
    by_delta: arb_poly

    def on(self, chord: arb) -> _On:
        """Its value and slopes by y, gamma and delta on an interval of y."""
        slope = self.value.derivative()
        return _On(*(_over(p, chord) for p in (self.value, slope, self.by_gamma, self.by_delta)))


class _On(NamedTuple):
    value: arb
    by_chord: arb
    by_gamma: arb
    by_delta: arb

    def over(self, size: _On) -> _On:
        """The quotient of two, with its slopes."""
        ratio = self.value / size.value
        slopes = zip(self[1:], size[1:], strict=True)
        return _On(ratio, *((up - ratio * down) / size.value for up, down in slopes))


class _Arc(NamedTuple):
    """The boundary: quotients of polynomials by their size."""

    push: _Part
    """alpha."""
    up: _Part
    """beta."""
    above: _Part
    """beta + delta - (d + 1/2) alpha."""
    size: _Part


class _Meeting(NamedTuple):
    """Stiffnesses at which a root may lie on the circle, and the y of those on the boundary."""

    low: float
    high: float
    chords: tuple[arb, ...] = ()


@lru_cache(maxsize=64)
def at_damping(delay: int) -> Limit:
    """The largest stable alpha behind a whole delay, on boxes of gamma, delta and beta."""
    arc = _arc(delay)

    def limit(box: Box, hint: object = None) -> Found:
        curve = arc(box)
        chord = _stiffest(curve, box, delay)
        size = curve.size.on(chord)
        return _along(curve.push.on(chord).over(size), curve.up.on(chord).over(size))

    return limit


@lru_cache(maxsize=64)
def error_of_line(delay: int) -> Limit:
    """The error of the linear limit, alpha_lin/alpha - 1 = Delta/((d + 1/2) alpha).

    alpha_lin = (beta + delta)/(d + 1/2), and Delta is the boundary's surplus over this line.
    """
    arc, share = _arc(delay), exact(Fraction(2, 2 * delay + 1))

    def error(box: Box, hint: object = None) -> Found:
        curve = arc(box)
        chord = _stiffest(curve, box, delay)
        push = curve.push.on(chord)
        positive(push.value)
        up = curve.up.on(chord).over(curve.size.on(chord))
        found = _along(curve.above.on(chord).over(push), up)
        return Found(found.value * share, tuple(slope * share for slope in found.slopes))

    return error


def _along(what: _On, up: _On) -> Found:
    """A number of the boundary as a function of gamma, delta and beta instead of y."""
    by_damping = what.by_chord / up.by_chord
    return Found(
        what.value,
        (
            what.by_gamma - by_damping * up.by_gamma,
            what.by_delta - by_damping * up.by_delta,
            by_damping,
        ),
    )


@cache
def _shape() -> tuple[Callable[..., list[arb]], Callable[..., list[arb]]]:
    """Balls of what the boundary is made of, and of its slopes by the plant's numbers."""
    shape = {s: x.subs(BALLS) for s, x in linear.numbers(Sampled(n_1, n_0, a, e)).items()}
    meant = (shape[nu], shape[s_1], 1 / TOGETHER, gamma, delta)
    return compiled(meant), compiled([derivative(x, name) for x in meant for name in NAMES])


def _arc(delay: int) -> Callable[[Box], _Arc]:
    """Finds the boundary of a box of plants."""
    form = linear.arc(delay)
    light = LIGHT - (1 - nu) * s_1  # s_2 with 1/(n_1 + n_0), so that equal terms meet
    forms = (form.right - gamma * form.size, form.up, form.above, form.size)
    coefficients = [form.coefficients(p.subs(s_2, light).expand()) for p in forms]
    ends = list(pairwise(accumulate(map(len, coefficients), initial=0)))
    flat = [c for part in coefficients for c in part]
    values = compiled(flat, SHAPE)
    partial = compiled([derivative(c, name) for c in flat for name in SHAPE], SHAPE)
    named, named_by = _shape()

    def arc(box: Box) -> _Arc:
        x, middle = numbers(*box[:2]), numbers(box[0].point, box[1].point)
        by = _batched(named_by(*x.values), len(NAMES))
        slopes = _batched(partial(*named(*x.values)), len(SHAPE))
        found = []
        for along in (x.by_gamma, x.by_delta):
            inner = [chained(part, along) for part in by]
            found.append([chained(part, inner) for part in slopes])
        ways = [y.ball - exact(y.middle) for y in box[:2]]
        there = zip(values(*named(*middle.values)), *found, strict=True)
        rows = [[v + g * ways[0] + f * ways[1] for v, g, f in there], *found]
        return _Arc(*(_Part(*(arb_poly(row[i:j]) for row in rows)) for i, j in ends))

    return arc


def _batched(values: Sequence[arb], size: int) -> list[Sequence[arb]]:
    """So many at a time."""
    return [values[i : i + size] for i in range(0, len(values), size)]


def _stiffest(arc: _Arc, box: Box, delay: int) -> arb:
    """The y of the boundary below which the first walls are stable, from high stiffness down.

    Between two stiffnesses at which no plant of the box has a root on the circle all have the same
    number of roots outside, and one plant and wall tells it.
    """
    x, beta = numbers(*box[:2]), box[2].ball
    spring, damper, middle = (interval.point for interval in box)
    one = numbers(spring, damper)
    meetings = _merged([*_at_ends(x, beta, delay), *_on_boundary(arc, beta)])
    above = max(_bound(x, beta, delay), meetings[-1].high) + 1.0
    for meeting, upper in reversed(list(zip(meetings, [*meetings[1:], None], strict=True))):
        end = above if upper is None else upper.low
        wall = arb((meeting.high + end) / 2)
        stable = all_inside(_polynomial(one, wall, middle.ball, delay))
        if stable is None:
            raise NotEnclosed("whether a wall is stable is not decided")
        if stable:
            if upper is None or len(upper.chords) != 1:
                raise NotEnclosed("what ends the stable walls is not one root on the circle")
            return upper.chords[0]
        if meeting.low <= -float(x.values[4].lower()) <= meeting.high:
            break  # walls below alpha = -gamma are unstable
    raise NotEnclosed("no wall with this virtual damping is shown to be stable")


def _at_ends(x: Numbers, beta: arb, delay: int) -> list[_Meeting]:
    """Walls with a root at 1 and at -1."""
    loss, both, late, static, spring, _ = x.values
    found = [_around(-spring)]
    top, apart = 4 - 2 * loss - static, both - 2 * late  # A(-1), n_1 - n_0
    if apart > 0 or apart < 0:
        found.append(_around((-1) ** delay * top / apart - 2 * beta))
    elif not top > abs(apart).upper() * (_bound(x, beta, delay) + 2 * abs(beta)):
        raise NotEnclosed("whether a root lies at -1 is not decided")
    return found


def _bound(x: Numbers, beta: arb, delay: int) -> float:
    """No wall as stiff as this is stable: no coefficient exceeds the binomial one."""
    loss, both, late, static, *_ = x.values
    first = both - late
    if delay == 0:
        bound = (5 - loss - static) / first - beta  # of z^2, -a + n_1 (alpha + beta) < 3
    else:
        bound = (delay + 3 + first * beta) / late - beta  # of z, n_0 (alpha + beta) - n_1 beta
    return _around(abs(bound)).high


def _around(value: arb, *chords: arb) -> _Meeting:
    if not value.is_finite():
        raise NotEnclosed("a stiffness on the boundary is not known")
    low, high = float(value.lower()), float(value.upper())
    return _Meeting(math.nextafter(low, -math.inf), math.nextafter(high, math.inf), chords)


def _merged(meetings: Sequence[_Meeting]) -> list[_Meeting]:
    """In order, and those that overlap as one."""
    found: list[_Meeting] = []
    for one in sorted(meetings, key=lambda m: m.low):
        if found and one.low <= found[-1].high:
            last = found.pop()
            one = _Meeting(last.low, max(last.high, one.high), (*last.chords, *one.chords))
        found.append(one)
    return found


def _over(polynomial: arb_poly, interval: arb) -> arb:
    """A polynomial's values on an interval, by its expansion about the middle."""
    middle = interval.mid()
    return polynomial(arb_poly([middle, 1]))(interval - middle)


def _on_boundary(arc: _Arc, beta: arb) -> list[_Meeting]:
    """Where the boundary has the damping: pieces of it with all those points."""
    surplus = arc.up.value - arb_poly([beta]) * arc.size.value
    slope = surplus.derivative()
    try:
        kept = pieces(4.0, lambda piece: _over(surplus, piece).contains(0))
    except TooMany:
        raise NotEnclosed("too many pieces of the boundary") from None
    near = [narrowed(surplus, lambda y: _over(slope, y), piece) for piece in kept]
    sizes = [(piece, arc.size.on(piece)) for piece in near if piece is not None]
    return [_around(arc.push.on(piece).over(size).value, piece) for piece, size in sizes]


def _polynomial(x: Numbers, alpha: arb, beta: arb, delay: int) -> list[arb]:
    """z^(d+1) (z^2 - a z + e) + (n_1 z + n_0) ((alpha + beta) z - beta), highest power first."""
    loss, both, late, static, *_ = x.values
    found = [arb(1), loss + static - 2, 1 - loss, *[arb(0)] * (delay + 1)]
    first = both - late
    for i, part in enumerate(
        (first * (alpha + beta), late * (alpha + beta) - first * beta, -late * beta), -3
    ):
        found[i] += part
    return found

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
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import NamedTuple

import sympy as sp
from flint import arb, arb_poly

from symhaptic.model import linear
from symhaptic.model.plant import Sampled
from symhaptic.notation import a, e, gamma, n_0, n_1, nu, s_1, s_2
from symhaptic.plant_balls import TOGETHER
from symhaptic.simplest.cost import Model
from symhaptic.simplest.plants import (
    BY_NAMES,
    NAMES,
    Box,
    Found,
    Limit,
    NotEnclosed,
    Numbers,
    chained,
    compiled,
    number,
    numbers,
)

_PIECES = 600
"""So many pieces of the boundary are tried."""

_LEAST = 2**-7
"""Pieces of the boundary are not halved below this length in y."""


LIGHT = sp.Symbol("1/(n_1+n_0)")

SHAPE = (nu, s_1, LIGHT, gamma)
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
    """The boundary, times a size: alpha + gamma and beta."""

    right: _Part
    up: _Part
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
        x, curve = numbers(*box[:2]), arc(numbers(*box[:2]))
        chord = _stiffest(curve, x, box, delay)
        size = curve.size.on(chord)
        right, up = curve.right.on(chord).over(size), curve.up.on(chord).over(size)
        along = right.by_chord / up.by_chord
        slopes = (
            right.by_gamma - 1 - along * up.by_gamma,
            right.by_delta - along * up.by_delta,
            along,
        )
        return Found(right.value - x.values[4], slopes)

    return limit


def _arc(delay: int) -> Callable[[Numbers], _Arc]:
    """Finds the boundary of a box of plants."""
    form = linear.arc(delay)
    size = LIGHT - (1 - nu) * s_1  # s_2 with 1/(n_1 + n_0), so that equal terms meet
    parts = [(p.subs(s_2, size).expand()) for p in (form.right, form.up, form.size)]
    coefficients = [form.coefficients(part) for part in parts]
    ends = list(pairwise(accumulate(map(len, coefficients), initial=0)))
    flat = [c for part in coefficients for c in part]
    values = compiled(flat, SHAPE)
    partial = compiled([sp.diff(c, name) for c in flat for name in SHAPE], SHAPE)
    shape = {s: x.subs(BY_NAMES) for s, x in linear.numbers(Sampled(n_1, n_0, a, e)).items()}
    meant = (shape[nu], shape[s_1], 1 / TOGETHER, gamma)
    named = compiled(meant)
    named_by = compiled([sp.diff(x, name) for x in meant for name in NAMES])

    def arc(x: Numbers) -> _Arc:
        at, by = named(*x.values), named_by(*x.values)
        found = [values(*at)]
        slopes = partial(*at)
        for along in (x.by_gamma, x.by_delta):
            inner = [chained(part, along) for part in _batched(by, len(NAMES))]
            found.append([chained(part, inner) for part in _batched(slopes, len(SHAPE))])
        return _Arc(*(_Part(*(arb_poly(v[i:j]) for v in found)) for i, j in ends))

    return arc


def _batched(values: Sequence[arb], size: int) -> list[Sequence[arb]]:
    """So many at a time."""
    return [values[i : i + size] for i in range(0, len(values), size)]


def line(delay: int) -> Model:
    """The linear limit, alpha = (beta + delta)/(delay + 1/2)."""
    slope = 1 / number(delay + Fraction(1, 2))

    def limit(box: Box, hint: object = None) -> Found:
        return Found((box[1].ball + box[2].ball) * slope, (arb(0), slope, slope))

    return Model(limit)


def _stiffest(arc: _Arc, x: Numbers, box: Box, delay: int) -> arb:
    """The y of the boundary below which the first walls are stable, from high stiffness down.

    Between two stiffnesses at which no plant of the box has a root on the circle all have the same
    number of roots outside, and one plant and wall tells it.
    """
    beta = box[2].ball
    spring, damper, middle = (interval.point for interval in box)
    one = numbers(spring, damper)
    meetings = _merged([*_at_ends(x, beta, delay), *_on_boundary(arc, x, beta)])
    above = max(_bound(x, beta, delay), meetings[-1].high) + 1.0
    for meeting, upper in reversed(list(zip(meetings, [*meetings[1:], None], strict=True))):
        end = above if upper is None else upper.low
        wall = arb((meeting.high + end) / 2)
        stable = _inside(_polynomial(one, wall, middle.ball, delay))
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


def _on_boundary(arc: _Arc, x: Numbers, beta: arb) -> list[_Meeting]:
    """Where the boundary has the damping: pieces of it with all those points."""
    surplus = arc.up.value - arb_poly([beta]) * arc.size.value
    slope = surplus.derivative()
    pieces, kept, tried = [(0.0, 4.0)], list[arb](), 0
    while pieces:
        low, high = pieces.pop()
        tried += 1
        if tried > _PIECES:
            raise NotEnclosed("too many pieces of the boundary")
        piece = arb(low).union(arb(high))
        if not _over(surplus, piece).contains(0):
            continue
        if high - low > _LEAST:
            middle = (low + high) / 2
            pieces += [(middle, high), (low, middle)]  # the lower one is next
        elif kept and kept[-1].overlaps(piece):
            kept[-1] = kept[-1].union(piece)
        else:
            kept.append(piece)
    near = [_narrowed(surplus, slope, piece) for piece in kept]
    found = [(piece, arc.right.on(piece).over(arc.size.on(piece))) for piece in near if piece]
    return [_around(right.value - x.values[4], piece) for piece, right in found]


def _narrowed(surplus: arb_poly, slope: arb_poly, piece: arb) -> arb | None:
    """Newton's interval step on a piece, as long as it narrows; None where no zero is left."""
    while True:
        rises = _over(slope, piece)
        if rises.contains(0):
            return piece
        middle = piece.mid()
        step = middle - surplus(middle) / rises
        if not step.overlaps(piece):
            return None
        less = step.intersection(piece)
        if not less.rad() < 0.9 * piece.rad():
            return piece
        piece = less


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


def _inside(polynomial: list[arb]) -> bool | None:
    """Whether all roots lie inside the unit circle, by Schur's reduction; None if undecided."""
    while len(polynomial) > 1:
        share = polynomial[-1] / polynomial[0]
        if abs(share) >= 1:
            return False
        if not abs(share) < 1:
            return None
        mirrored = reversed(polynomial)
        polynomial = [p - share * q for p, q in zip(polynomial, mirrored, strict=True)][:-1]
    return True

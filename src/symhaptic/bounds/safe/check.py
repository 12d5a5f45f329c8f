"""The walls of a certificate, enclosed once more: by another road, and with nothing searched for.

The plants come from a matrix exponential and not from a series, the walls from complex numbers, the
first stable wall from roots and not from Schur's reduction, and all comparisons are those of balls.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from flint import acb, acb_poly, arb, arb_mat, ctx

from symhaptic.bounds.balls import exact, sinc
from symhaptic.bounds.safe.arms import Ends, Hands, Loops, halved, midway, moved, ratios, span
from symhaptic.bounds.safe.prove import Columns

BITS = 80
"""Working precision."""

_DEEPER = 8
"""So often a piece may be halved here, where this road sees less than the other."""


@dataclass(frozen=True)
class Certificate:
    """All walls of the columns are stable for every arm of the loops."""

    loops: Loops
    columns: Columns
    cuts: str
    angles: tuple[Fraction, ...]
    stable: tuple[tuple[float, float], ...]
    """For each run of columns a wall (K, B) in it that is stable for the first arm."""


def recheck(claim: Certificate) -> bool:
    """Whether a certificate shows what it says."""
    if not _sensible(claim):
        return False
    with ctx.workprec(BITS):
        if not all(stable(claim.loops, wall) for wall in claim.stable):
            return False
        pieces = [(arc, claim.loops.hands) for arc in pairwise(claim.angles)][::-1]
        for cut in claim.cuts:
            if not pieces:
                return False
            arc, hands = pieces.pop()
            if cut == ".":
                if not _clear(claim, arc, hands, _DEEPER):
                    return False
            elif cut in "0123":
                pieces += halved(arc, hands, int(cut))[::-1]
            else:
                return False
    return not pieces


def _sensible(claim: Certificate) -> bool:
    """Whether it speaks of all angles, of loops that exist and of columns in order."""
    loops, columns = claim.loops, claim.columns
    runs = columns.runs()
    numbers = [*columns.edges, *columns.tops, columns.low]
    steps = math.floor(loops.periods[0])
    with ctx.workprec(BITS):
        whole = claim.angles[0] == 0 and bool(exact(claim.angles[-1]) > arb.pi())
    return (
        whole
        and all(low < high for low, high in pairwise(claim.angles))
        and all(map(math.isfinite, numbers))
        and len(columns.tops) == len(columns.edges) - 1
        and all(low <= high for low, high in pairwise(columns.edges))
        and columns.low > 0
        # a lower column would join others with no wall between them
        and all(top <= 0 or top >= columns.low for top in columns.tops)
        and loops.mass > 0
        and loops.period > 0
        and min(loops.damping, loops.stiffness, loops.periods[0]) >= 0
        and loops.periods[0] <= loops.periods[1] <= steps + 1
        and all(0 <= low <= high for low, high in loops.hands)
        and len(claim.stable) == len(runs)
        and all(
            any(_within(columns, i, wall) for i in run)
            for run, wall in zip(runs, claim.stable, strict=True)
        )
    )


def _within(columns: Columns, i: int, wall: tuple[float, float]) -> bool:
    K, B = wall
    return columns.low <= K <= columns.tops[i] and columns.edges[i] <= B <= columns.edges[i + 1]


def _clear(claim: Certificate, arc: Ends, hands: Hands, deeper: int) -> bool:
    """Whether no wall of the columns has a root on this piece for one of these arms."""
    if _apart(claim, arc, hands):
        return True
    if not deeper:
        return False
    box = [arc, *hands]
    wide = [i for i in (0, 1, 2, 3) if box[i][0] < box[i][1]]
    across = wide[deeper % len(wide)]
    return all(_clear(claim, *half, deeper - 1) for half in halved(arc, hands, across))


def _apart(claim: Certificate, arc: Ends, hands: Hands) -> bool:
    loops, columns = claim.loops, claim.columns
    K, B, lag, held, size = _enclosed(loops, arc, hands)
    for (left, right), top in zip(pairwise(columns.edges), columns.tops, strict=True):
        if top <= 0:
            continue
        damping = arb(left).union(arb(right))
        if B.is_finite() and not B.overlaps(damping):
            continue
        swing = 2 * max(abs(left), abs(right)) / exact(loops.period)
        if size > arb(top) + swing:
            continue
        if not K.is_finite():
            return False
        stiffness = arb(columns.low).union(arb(top))
        if not K.overlaps(stiffness):
            continue
        if lag > 0 and held.is_finite():  # B + held = lag K in the column
            if (arb(left) + held) / lag > arb(top).min(K.upper()):
                continue
            if (arb(right) + held) / lag < arb(columns.low).max(K.lower()):
                continue
        return False
    return True


class _Dual(NamedTuple):
    """A number and its slopes by gamma and by delta."""

    value: arb
    by_g: arb
    by_f: arb

    def plus(self, other: _Dual, times: int = 1) -> _Dual:
        """The sum, or the difference."""
        return _Dual(*(x + times * y for x, y in zip(self, other, strict=True)))

    def times(self, other: _Dual) -> _Dual:
        """The product."""
        x, y = self.value, other.value
        return _Dual(x * y, self.by_g * y + x * other.by_g, self.by_f * y + x * other.by_f)

    def over(self, other: _Dual) -> _Dual:
        """The quotient."""
        ratio = self.value / other.value
        ways = zip(self[1:], other[1:], strict=True)
        return _Dual(ratio, *((up - ratio * down) / other.value for up, down in ways))


def _pushed(g: arb, f: arb, time: arb) -> tuple[_Dual, _Dual, _Dual]:
    """Position and speed after ``time`` of unit force, and what is kept of a speed of 1.

    exp([[X, X_g, X_f], [0, X, 0], [0, 0, X]] t) has exp(X t) and its slopes in its first rows.
    """
    rows = [[arb(0)] * 9 for _ in range(9)]
    for i in (0, 3, 6):
        rows[i][i + 1], rows[i + 1][i + 2] = arb(1), arb(1)
        rows[i + 1][i], rows[i + 1][i + 1] = -g, -f
    rows[1][3] = rows[1][7] = arb(-1)
    grown = (arb_mat(rows) * time).exp()
    found = [(grown[i, j], grown[i, j + 3], grown[i, j + 6]) for i, j in ((0, 2), (1, 2), (1, 1))]
    return _Dual(*found[0]), _Dual(*found[1]), _Dual(*found[2])


def _shape(loops: Loops, g: arb, f: arb) -> tuple[_Dual, ...]:
    """m_2, m_1 and m_0 over their sum S, (1 - L/2)/S and lambda/S."""
    x, v, kept = _pushed(g, f, arb(1))
    first, speed = x, v
    if any(loops.part):
        first, speed, _ = _pushed(g, f, 1 - span(loops.part))
    before, rest = x.plus(first, -1), v.plus(speed, -1)
    ends = (
        first,
        v.times(speed).plus(kept.times(first), -1).plus(before),
        v.times(rest).plus(kept.times(before), -1),
    )
    total = x.plus(v.times(v)).plus(kept.times(x), -1)
    # lambda is the speed after a period of unit force without a spring
    held = _pushed(arb(0), f, arb(1))[1]
    share = _Dual(held.value, arb(0), held.by_f)
    half = _Dual(f, arb(0), arb(1)).times(share)
    weight = _Dual(1 - half.value / 2, arb(0), -half.by_f / 2)
    return tuple(each.over(total) for each in (*ends, weight, share))


@lru_cache(maxsize=1 << 14)
def _numbers(loops: Loops, hands: Hands) -> list[arb]:
    """The same for all arms of a box: in its middle, and slopes times the way from there."""
    g, f = ratios(loops, hands)
    ways = g - g.mid(), f - f.mid()
    middle, wide = _shape(loops, g.mid(), f.mid()), _shape(loops, g, f)
    return [
        here.value + there.by_g * ways[0] + there.by_f * ways[1]
        for here, there in zip(middle, wide, strict=True)
    ]


@lru_cache(maxsize=1 << 14)
def _drift(loops: Loops, hands: Hands) -> tuple[arb, arb, arb]:
    """How m_2, m_1 and m_0 over S change with the delay, for all delays of the loops.

    The force begins later: x and v after 1 - e lose v and v' = 1 - f v - g x per period.
    """
    g, f = ratios(loops, hands)
    x, v, kept = (each.value for each in _pushed(g, f, arb(1)))
    first, speed, _ = (each.value for each in _pushed(g, f, 1 - span(loops.part)))
    pull = 1 - f * speed - g * first
    total = x + v * v - kept * x
    return (
        -speed / total,
        (speed - v * pull + kept * speed) / total,
        (v * pull - kept * speed) / total,
    )


def _numerator(loops: Loops, arc: Ends, hands: Hands) -> tuple[arb, arb]:
    """V/S on a piece of the circle: its real part, and its imaginary part over the angle."""
    low, high = exact(arc[0]), exact(arc[1])
    theta, half = low.union(high), arb(1) / 2
    numbers = _numbers(loops, hands)[:3] if loops.periods[0] == loops.periods[1] else []
    if numbers:
        late = exact(loops.part[0])
        right, tilt = arb(0), arb(0)
        for m, c in zip(numbers, (late + half, late - half, late - 3 * half), strict=True):
            right += m * (c * theta).cos()
            tilt += m * c * sinc(low * c.abs_lower(), high * c.abs_upper())
        return right, tilt
    one = midway(loops)
    right, tilt = _numerator(one, arc, hands)
    away = span(loops.periods) - exact(one.periods[0])
    late, drift = span(loops.part), _drift(loops, hands)
    phases = late + half, late - half, late - 3 * half
    for m, by, c in zip(_numbers(one, hands)[:3], drift, phases, strict=True):
        there, cosine = m + away * by, (c * theta).cos()
        right += away * (by * cosine - there * theta * (c * theta).sin())
        tilt += away * (by * c * sinc(low * c.abs_lower(), high * c.abs_upper()) + there * cosine)
    return right, tilt


def _between(ends: tuple[arb, arb], c: arb) -> arb:
    """c times all numbers between two."""
    return (c * ends[0]).union(c * ends[1])


def _enclosed(loops: Loops, arc: Ends, hands: Hands) -> tuple[arb, arb, arb, arb, arb]:
    """K, B, the two numbers of B + held = lag K, and |K + B/T (1 - 1/z)|, with a root there."""
    weight, share = _numbers(midway(loops), hands)[3:]
    mass, damping, stiffness = moved(loops, hands)
    T, d = exact(loops.period), span(loops.periods)
    low, high = exact(arc[0]), exact(arc[1])
    theta, lag = low.union(high), d + arb(1) / 2
    spread, sine = sinc(low, high), theta.sin()
    right, lifted = _numerator(loops, arc, hands)
    tilt, aside = lifted / spread, lifted * theta
    size = right * right + aside * aside
    turned = acb((lag * theta).cos(), (lag * theta).sin()) * acb(right, -aside) / size
    ahead = acb(((d + 1) * theta).cos(), ((d + 1) * theta).sin()) * acb(right, -aside) / size
    half = (theta / 2).cos()
    heavy = (mass[0] * (2 * (low / 2).sin() / T) ** 2, mass[1] * (2 * (high / 2).sin() / T) ** 2)

    def pushed(c: arb) -> arb:
        return _between(heavy, weight * c) - _between(stiffness, c)

    leading, lagging = ahead.real / half, ahead.imag / half * sine
    K = pushed(leading) + _between(damping, share * lagging / T)
    wave = sinc(low * lag.lower(), high * lag.upper()) / spread * lag
    rise = (right * wave - tilt * (lag * theta).cos()) / size
    B = T * pushed(rise) - _between(damping, share * turned.real)
    slope = T * rise / leading
    held = _between(damping, share * (turned.real + lagging * rise / leading))
    least = pushed(arb(1)).abs_lower() ** 2
    least += _between(damping, share * sine / T).abs_lower() ** 2
    modulus = (least / size.abs_upper()).sqrt() if size.is_finite() else arb(0)
    slope = slope if leading > 0 else arb("nan")
    return K, B, slope, held, modulus


def stable(loops: Loops, wall: tuple[float, float]) -> bool:
    """Whether all roots of a wall lie inside the circle, for the first arm of the range."""
    ends = tuple((low, low) for low, _ in loops.hands)
    hands: Hands = (ends[0], ends[1], ends[2])
    one = loops._replace(periods=(loops.periods[0], loops.periods[0]))
    g, f = ratios(one, hands)
    x, v, _ = (each.value for each in _pushed(g, f, arb(1)))
    kept, total = (-f).exp(), x + v * v - (1 - f * v - g * x) * x
    m2, m1, m0 = (each.value * total for each in _shape(one, g, f)[:3])
    scale = exact(loops.period) / moved(loops, hands).mass[0]
    K, B = arb(wall[0]) * scale * exact(loops.period), arb(wall[1]) * scale
    device = acb_poly([kept, -(1 + kept - g * total), 1])  # z^2 - a z + e with 1 - a + e = g S
    late = acb_poly([0] * (loops.steps + 2) + [1])
    loop = late * device + acb_poly([m0, m1, m2]) * acb_poly([-B, K + B])
    while loop.degree() > 0 and loop[0] == 0:
        loop = loop // acb_poly([0, 1])
    try:
        return all(abs(root) < 1 for root in loop.roots())
    except ValueError:
        return False

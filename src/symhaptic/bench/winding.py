"""Roots of the loop outside the unit circle, counted in balls by the argument principle.

With A(z) = z^2 - a z + e of the device, M(z) = m2 z^2 + m1 z + m0 of its delayed input and
W(z) = (alpha + beta) z - beta of the wall, the characteristic polynomial is
p = z^(l+2) A + M W.  On the unit circle |A|^2 - |M W|^2 is a cubic in y = 2 - 2 cos(theta) whose
coefficients do not contain the whole delay l.  Between its roots one of the two terms is larger,
and the argument of p follows the argument of this term.

The device is a matrix exponential, and nothing is taken from the package's kernels.
"""

from __future__ import annotations

import math
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

import flint
import numpy as np
from flint import acb_poly, arb, arb_poly

from symhaptic.bench.exact import device, late

BITS = (160, 320, 640, 1280, 2560)
"""Working precisions, tried one after the other."""


class Undecided(ArithmeticError):
    """The balls are too wide, or a root lies on the unit circle."""


class Plant(NamedTuple):
    """M, A and what a difference of their coefficients would lose."""

    m2: Any
    m1: Any
    m0: Any
    a: Any
    e: Any
    force: Any
    """M(1); A(1) is gamma M(1)."""
    loss: Any
    """1 - e."""


def plant(gamma: float, delta: float, part: Any) -> Plant:
    """The device behind a fraction of a period."""
    m2, m1, m0, a, e = late(gamma, delta, part)
    n1, n0 = device(gamma, delta)[:2]
    return Plant(m2, m1, m0, a, e, n1 + n0, -(-arb(delta)).expm1())


_PIECES = 200
"""Pieces of (0, 4) in which zeros are sought."""

_plants = lru_cache(maxsize=4096)(lambda gamma, delta, part, bits: plant(gamma, delta, part))


def unstable(alpha: float, beta: float, gamma: float, delta: float, delay: float) -> int | None:
    """How many roots lie outside, or None where no precision decides.

    >>> unstable(5.0, 1.0, 0.0, 0.0, 0.0), unstable(0.5, 1.0, 0.0, 0.0, 0.0)
    (2, 0)
    """
    if on_circle(alpha, beta, gamma, delta):
        return None
    whole = math.floor(delay)
    for bits in BITS:
        with flint.ctx.workprec(bits):
            try:
                x = _plants(gamma, delta, delay - whole, bits)
                return count(alpha, beta, gamma, x, whole)
            except Undecided:
                continue
    return None


def stable(alpha: float, beta: float, gamma: float, delta: float, delay: float) -> bool | None:
    """Whether all roots lie inside; None where no precision decides."""
    if on_circle(alpha, beta, gamma, delta):
        return False
    outside = unstable(alpha, beta, gamma, delta, delay)
    return None if outside is None else outside == 0


def on_circle(alpha: float, beta: float, gamma: float, delta: float) -> bool:
    """Whether a root is known to lie on the circle: p(1) = (gamma + alpha) M(1), or no loss."""
    return alpha == -gamma or alpha == beta == delta == 0


def count(alpha: Any, beta: Any, gamma: Any, x: Plant, whole: Any) -> int:
    """The number of roots outside behind ``whole`` periods; every number may be a ball.

    Raises :class:`Undecided`.
    """
    al, be, g = arb(alpha), arb(beta), arb(gamma)
    both, sums, gap = al + be, x.m2 + x.m0, x.m2 - x.m0

    def free(y: Any) -> list[tuple[Any, int | None]]:
        return [_angle(g * x.force - (1 + x.e) * y / 2, x.loss, y)]

    def moved(y: Any) -> list[tuple[Any, int | None]]:
        return [_angle(x.force - sums * y / 2, gap, y), _angle(al - both * y / 2, both, y)]

    row = surplus(al, be, g, x)
    crossings = between(row)
    leads = _sign(next((c for c in row if not c.is_zero()), arb(0))) > 0
    angles, turns = (free if leads else moved)(arb(0)), 0
    begin = sum((angle for angle, _ in angles), arb(0))
    for y in crossings:
        ways = free(y), moved(y)
        _same(angles, ways[not leads])
        theta = 2 * arb.atan2(y.sqrt(), (4 - y).sqrt())
        phase = ways[1][0][0] + ways[1][1][0] - ways[0][0][0] - (whole + 2) * theta
        turns += (1 if leads else -1) * _nearest(phase / (2 * arb.pi()))
        leads = not leads
        angles = ways[not leads]
    last = (free if leads else moved)(arb(4))
    _same(angles, last)
    outside = begin / arb.pi()
    if not leads:
        outside += whole + 3 - sum((angle for angle, _ in last), arb(0)) / arb.pi()
    return 2 * turns + _nearest(outside)


def surplus(al: Any, be: Any, g: Any, x: Plant) -> list[Any]:
    """|A|^2 - |M W|^2 by powers of y, the lowest first."""
    sums, gap = x.m2 + x.m0, x.m2 - x.m0
    device = arb_poly([0, x.loss**2 - (1 + x.e) * g * x.force, x.e])
    moved = arb_poly([x.force**2, gap**2 - x.force * sums, x.m2 * x.m0])
    row: list[Any] = (device - moved * arb_poly([al * al, be * (al + be)])).coeffs()
    row += [arb(0)] * (4 - len(row))
    row[0] = x.force**2 * (g - al) * (g + al)
    return row


def between(row: list[Any]) -> list[Any]:
    """The zeros in (0, 4) of a polynomial, the lowest first; Undecided for a double one."""
    while row and row[0].is_zero():
        row = row[1:]
    while row and row[-1].is_zero():
        row = row[:-1]
    try:
        found = acb_poly(row).roots() if len(row) > 1 else []
    except ValueError:  # the coefficients are too wide for all zeros, but not for these
        return _divided(arb_poly(row))
    whole, here = arb_poly(row), []
    for i, root in enumerate(found):
        mirror = root.conjugate()
        if not root.overlaps(mirror) or root.real < 0 or root.real > 4:
            continue
        y = _newton(whole, whole.derivative(), root.real)
        if not (y > 0 and y < 4) or any(mirror.overlaps(o) for o in found[:i] + found[i + 1 :]):
            raise Undecided
        here.append(y)
    return sorted(here, key=lambda y: float(y.mid()))


def _divided(whole: Any) -> list[Any]:
    """The same by dividing (0, 4) into pieces on which the polynomial has no zero or a slope."""
    slope, left = whole.derivative(), [(arb(0), arb(4))]
    found: list[Any] = []
    for _ in range(_PIECES):
        if not left:
            return found
        low, high = left.pop()
        piece = low.union(high)
        if not whole(piece).contains(0):
            continue
        rise = slope(piece)
        if rise.contains(0):
            middle = arb(((low + high) / 2 if low >= high / 16 else high / 16).mid())
            left += [(middle, high), (low, middle)]
        elif _sign(whole(low)) != _sign(whole(high)):
            found.append(_newton(whole, slope, piece))
    raise Undecided


def _newton(row: Any, slope: Any, y: Any) -> Any:
    """A ball with one zero made smaller."""
    while True:
        middle = arb(y.mid())
        rise = slope(y)
        if not (rise > 0 or rise < 0):
            return y
        new = middle - row(middle) / rise
        if not new.overlaps(y):
            raise Undecided
        new = new.intersection(y)
        if not new.rad() * 2 < y.rad():
            return new
        y = new


def _angle(real: Any, up: Any, y: Any) -> tuple[Any, int | None]:
    """The argument of real + j up sin(theta), continuous where up keeps its sign.

    Where up is 0 or its sign is not known, the argument near 0 or pi, and the sign of real.
    """
    sine = (y * (4 - y)).sqrt() / 2
    if up > 0:
        return arb.atan2(up * sine, real), None
    if up < 0:
        return -arb.atan2(-up * sine, real), None
    if real.contains(0):
        raise Undecided
    off = abs(up * sine / real).upper()
    side = 1 if real > 0 else -1
    return arb(0 if side > 0 else arb.pi()) + arb(0, off), side


def _same(begin: list[tuple[Any, int | None]], end: list[tuple[Any, int | None]]) -> None:
    """Whatever sign an unknown imaginary part has, it has not turned the argument on this arc."""
    if any(one[1] != other[1] for one, other in zip(begin, end, strict=True)):
        raise Undecided


def _nearest(x: Any) -> int:
    found = (x + arb(1) / 2).floor().unique_fmpz()
    if found is None:
        raise Undecided
    return int(found)


def _sign(x: Any) -> int:
    if x.contains(0):
        raise Undecided
    return 1 if x > 0 else -1


_NARROW = 1e-9
"""Share of the delay margin up to which every smaller delay is shown to be stable."""

_RANGES = 600
"""Ranges of delays that are looked at before a margin counts as not decided."""


def largest_delay(alpha: float, beta: float, gamma: float, delta: float, most: float) -> Any:
    """The delay up to which the loop is stable, in a ball; None where none is decided.

    0 for a loop that is not stable without delay, infinite for one that every delay leaves stable.
    Every delay before the ball is shown to be stable, in ranges that are divided where the balls
    are too wide; the upper end of the ball is one that is not.
    """
    first = stable(alpha, beta, gamma, delta, 0.0)
    if not first:
        return arb(0) if first is False else None
    with flint.ctx.workprec(BITS[0]):
        if _never_leads(alpha, beta, gamma, delta):
            return arb("inf")
        left = [(low, high) for low, high in reversed(_doubling(most))]
        for _ in range(_RANGES):
            if not left:
                return None
            low, high = left.pop()
            if _all_stable(alpha, beta, gamma, delta, low, high):
                continue
            if high - low > _NARROW * high:
                left += [(middle := _middle(low, high), high), (low, middle)]
            else:
                return _bisected(alpha, beta, gamma, delta, low)
    return None


def _bisected(alpha: float, beta: float, gamma: float, delta: float, low: float) -> Any:
    """Between a stable delay and one that is not, a few last places apart, or None."""
    high = low * (1 + 64 * _NARROW)
    if stable(alpha, beta, gamma, delta, high) is not False:
        return None
    while (middle := (low + high) / 2) not in (low, high) and high - low > 4e-16 * high:
        inside = stable(alpha, beta, gamma, delta, middle)
        if inside is None:
            break
        low, high = (middle, high) if inside else (low, middle)
    return arb(low).union(arb(high))


def _doubling(most: float) -> list[tuple[float, float]]:
    ends = [0.0, 1.0]
    while ends[-1] < most:
        ends.append(min(2 * ends[-1], most))
    return list(pairwise(ends))


def _middle(low: float, high: float) -> float:
    """Whole where more than one period lies between."""
    middle = (low + high) / 2
    return math.floor(middle) if high - low > 1 else middle


def _all_stable(
    alpha: float, beta: float, gamma: float, delta: float, low: float, high: float
) -> bool:
    """Whether the loop is shown to be stable at every delay of a range."""
    if high - low > 1:
        whole, part = arb(low).union(arb(high - 1)), arb(0).union(arb(1))
    else:
        whole = arb(math.floor(low))
        part = (arb(low) - whole).union(arb(high) - whole)
    try:
        return count(alpha, beta, gamma, plant(gamma, delta, part), whole) == 0
    except Undecided:
        return False


def _never_leads(alpha: float, beta: float, gamma: float, delta: float, pieces: int = 64) -> bool:
    """Whether the device is stronger than the wall at every angle, behind every fraction."""
    for i in range(pieces):
        part = (arb(i) / pieces).union(arb(i + 1) / pieces)
        x = plant(gamma, delta, part)
        try:
            row = surplus(arb(alpha), arb(beta), arb(gamma), x)
            if between(row) or _sign(row[0]) < 0:
                return False
        except Undecided:
            return False
    return True


_FINE = 1e-7
"""Share of a stiffness up to which the largest stable one is sought."""

_HEIGHTS = 1 - 1e-6, 0.9, 0.5, 0.1, 1e-3
"""Where stiffnesses are tried between two tops of the boundary."""


def stiffest(gamma: float, delta: float, delay: float) -> Any:
    """The largest stable stiffness of any device, in a ball; NaN where no wall is found stable.

    At one stiffness the number of unstable roots changes with the damping only on the explicit
    boundary and on the line of a root at -1, so that one wall between each two of these decides; it
    is counted in balls.  Stiffnesses between the tops of the boundary are tried from above.  That
    none is missed rests on the grid of angles, which is fine but proves nothing.
    """
    curve = _Curve(gamma, delta, delay)
    tops = [*curve.alpha[_tops(curve.alpha)], curve.alpha[0], curve.alpha[-1], -gamma]
    levels = sorted({float(a) for a in tops if a >= -gamma}, reverse=True)
    above = 2 * abs(levels[0]) + 1
    for level, below in zip(levels, [*levels[1:], -gamma], strict=True):
        for share in _HEIGHTS:
            here = below + (level - below) * share
            if here < above and curve.has_stable(here):
                while above - here > _FINE * abs(here + gamma):
                    middle = (here + above) / 2
                    inside = curve.has_stable(middle)
                    here, above = (middle, above) if inside else (here, middle)
                return arb(here).union(arb(above))
            above = here
    return arb("nan")


def _tops(values: Any) -> Any:
    return 1 + np.flatnonzero((values[1:-1] >= values[:-2]) & (values[1:-1] >= values[2:]))


class _Curve:
    """The explicit boundary of a device in floats, on a grid of angles with all its tops."""

    def __init__(self, gamma: float, delta: float, delay: float) -> None:
        self.at, self.whole = (gamma, delta, delay), math.floor(delay)
        with flint.ctx.workprec(BITS[2]):
            x = plant(gamma, delta, arb(delay) - self.whole)
            self.m2, self.m1, self.m0, self.a, self.e = (float(v) for v in x[:5])
        turns = math.ceil(delay) + math.sqrt(gamma) / math.pi + 2
        theta = np.linspace(0, math.pi, int(60 * turns))[1:-1]
        ends = theta[0] * 10.0 ** np.arange(-6, 0)
        theta = np.concatenate([ends, theta, math.pi - ends[::-1]])
        alpha = self.wall(theta)[0]
        low, high = theta[_tops(alpha) - 1], theta[_tops(alpha) + 1]
        for _ in range(60):  # the third that is farther from the top is left out
            one, two = (2 * low + high) / 3, (low + 2 * high) / 3
            rises = self.wall(one)[0] < self.wall(two)[0]
            low, high = np.where(rises, one, low), np.where(rises, high, two)
        self.theta = np.unique(np.concatenate([theta, (low + high) / 2]))
        self.alpha = self.wall(self.theta)[0]
        line = self.m2 - self.m1 + self.m0
        self.line = (1 + self.a + self.e) / line * (-1) ** (self.whole % 2) if line else math.nan
        """alpha + 2 beta of a wall with a root at -1."""

    def wall(self, theta: Any) -> tuple[Any, Any]:
        z = np.exp(1j * theta)
        q = -(z ** (self.whole + 1)) * (z - self.a + self.e / z)
        q = q / (self.m2 * z + self.m1 + self.m0 / z)
        return q.real - q.imag * np.tan(theta / 2), q.imag / np.sin(theta)

    def has_stable(self, alpha: float) -> bool:
        """Whether some damping makes a wall of this stiffness stable."""
        inside = self.alpha > alpha
        at = np.flatnonzero(inside[1:] != inside[:-1])
        low, high, rises = self.theta[at], self.theta[at + 1], inside[at + 1]
        for _ in range(45):
            middle = (low + high) / 2
            beyond = (self.wall(middle)[0] > alpha) == rises
            low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
        ends = np.append(self.wall((low + high) / 2)[1], (self.line - alpha) / 2)
        ends = np.sort(ends[np.isfinite(ends)])
        if not ends.size:
            ends = np.zeros(1)
        ends = np.concatenate(
            [ends[:1] - 2 - 2 * abs(ends[0]), ends, ends[-1:] + 2 + 2 * abs(ends[-1])]
        )
        middles = ((ends[1:] + ends[:-1]) / 2).tolist()
        return any(stable(alpha, beta, *self.at) for beta in middles)

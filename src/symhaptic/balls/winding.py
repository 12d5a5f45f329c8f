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
from flint import acb, acb_poly, arb, arb_poly

from symhaptic.balls.closed import delayed, device, periods
from symhaptic.balls.zeros import narrowed

BITS = (160, 320, 640, 1280, 2560)
"""Working precisions, tried one after the other."""


class Undecided(ArithmeticError):
    """The balls are too wide, or a root lies on the unit circle."""


class Plant(NamedTuple):
    """Coefficients of M and A, and numbers that their differences would lose digits of."""

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
    """The device with a delay of a fraction of a period."""
    m2, m1, m0, a, e = delayed(gamma, delta, part)
    n1, n0 = device(gamma, delta)[:2]
    return Plant(m2, m1, m0, a, e, n1 + n0, -(-arb(delta)).expm1())


_PIECES = 200
"""Pieces of (0, 4) in which zeros are sought."""

_plants = lru_cache(maxsize=4096)(lambda gamma, delta, part, bits: plant(gamma, delta, part))


def unstable(alpha: float, beta: float, gamma: float, delta: float, delay: float) -> int | None:
    """The number of roots outside, or None if no precision decides it.

    >>> unstable(5.0, 1.0, 0.0, 0.0, 0.0), unstable(0.5, 1.0, 0.0, 0.0, 0.0)
    (2, 0)
    """
    if on_circle(alpha, beta, gamma, delta):
        return None
    whole = periods(delay)
    for bits in BITS:
        with flint.ctx.workprec(bits):
            try:
                x = _plants(gamma, delta, delay - whole, bits)
                return count(alpha, beta, gamma, x, whole)
            except Undecided:
                continue
    return None


def stable(alpha: float, beta: float, gamma: float, delta: float, delay: float) -> bool | None:
    """Whether all roots lie inside; None if no precision decides it."""
    if on_circle(alpha, beta, gamma, delta):
        return False
    outside = unstable(alpha, beta, gamma, delta, delay)
    return None if outside is None else outside == 0


def on_circle(alpha: float, beta: float, gamma: float, delta: float) -> bool:
    """Whether a root is known to lie on the circle: p(1) = (gamma + alpha) M(1), or no loss."""
    return alpha == -gamma or alpha == beta == delta == 0


def count(alpha: Any, beta: Any, gamma: Any, x: Plant, whole: Any) -> int:
    """The number of roots outside with a delay of ``whole`` periods; each argument may be a ball.

    Raises :class:`Undecided`.
    """
    al, be, g = arb(alpha), arb(beta), arb(gamma)
    both, sums, gap = al + be, x.m2 + x.m0, x.m2 - x.m0

    def free(y: Any) -> list[tuple[Any, int | None]]:
        return [_angle(g * x.force - (1 + x.e) * y / 2, x.loss, y)]

    def moved(y: Any) -> list[tuple[Any, int | None]]:
        return [_angle(x.force - sums * y / 2, gap, y), _angle(al - both * y / 2, both, y)]

    row = surplus(al, be, g, x)
    close = arb(2) ** (-flint.ctx.prec // 3) if flint.ctx.prec > BITS[0] else None
    crossings = between(row, close)
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


def between(row: list[Any], tol: Any = None) -> list[Any]:
    """The zeros in (0, 4) of a polynomial, the lowest first; Undecided for a double one.

    ``tol`` is the radius of balls that keeps close zeros apart.
    """
    while row and row[0].is_zero():
        row = row[1:]
    while row and row[-1].is_zero():
        row = row[:-1]
    try:
        found = acb_poly(row).roots(tol=tol) if len(row) > 1 else []
    except ValueError:  # the coefficients are too wide for all zeros, but not for these
        return _divided(arb_poly(row))
    whole, here = arb_poly(row), []
    for i, root in enumerate(found):
        mirror = root.conjugate()
        if not root.overlaps(mirror) or root.real < 0 or root.real > 4:
            continue
        y = _newton(whole, whole.derivative(), root.real)
        if y < 0 or y > 4:
            continue
        if not (y > 0 and y < 4) or any(mirror.overlaps(o) for o in found[:i] + found[i + 1 :]):
            raise Undecided
        here.append(y)
    return sorted(here, key=lambda y: float(y.mid()))


def _divided(whole: Any) -> list[Any]:
    """The same by dividing (0, 4) into pieces where the polynomial has no zero or is monotone."""
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
    found = narrowed(row, slope, y)
    if found is None:
        raise Undecided
    return found


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
"""The largest number of ranges of delays; with more, a margin is not decided."""


def largest_delay(alpha: float, beta: float, gamma: float, delta: float, most: float) -> Any:
    """The delay up to which the loop is stable, in a ball; None if it is not decided.

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
    """A ball from a stable to an unstable delay, a few units in the last place apart, or None."""
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
    """The middle, rounded down if the range is longer than a period."""
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
    """Whether |A| > |M W| at all angles, for all fractional delays."""
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


def damping_at(alpha: float, gamma: float, delta: float, delay: float) -> float | None:
    """A damping with which a wall of this stiffness is stable; None if there is none.

    The number of unstable roots changes with the damping only where a root is on the circle.  The
    angles of such roots are the zeros of a polynomial, which are found in balls, so that none is
    missed; one wall between each two of their dampings is counted.

    Raises :class:`Undecided`.
    """
    for bits in BITS[1:]:
        with flint.ctx.workprec(bits):
            try:
                walls = _between(_critical_dampings(alpha, gamma, delta, delay))
            except Undecided:
                continue
        counts = [unstable(alpha, beta, gamma, delta, delay) for beta in walls]
        if 0 in counts:
            return walls[counts.index(0)]
        if None not in counts:
            return None
    raise Undecided


def _critical_dampings(alpha: float, gamma: float, delta: float, delay: float) -> list[Any]:
    """The dampings that put a root on the circle, the lowest first.

    With p = N + beta M (z - 1) and N = z^(l+2) A + alpha z M, beta is real on the circle where
    z^(l+1) N M* + N* M is 0, with * for coefficients in reverse.  This is z + 1 times a
    polynomial in y = 2 - z - 1/z.
    """
    whole = periods(delay)
    x = plant(gamma, delta, arb(delay) - whole)
    moved, turned = [x.m0, x.m1, x.m2], [x.m2, x.m1, x.m0]
    shift = arb_poly([0] * (whole + 2) + [1])
    top = (arb_poly([x.e, -x.a, 1]) * shift + arb_poly([0, alpha]) * arb_poly(moved)).coeffs()
    left = arb_poly([0] * (whole + 1) + top) * arb_poly(turned)
    row = (left + arb_poly(top[::-1]) * arb_poly(moved)).coeffs()
    row += [arb(0)] * (2 * whole + 8 - len(row))
    for i in reversed(range(1, len(row) - 1)):  # divided by z + 1
        row[i] -= row[i + 1]
    row = row[1:]
    half = len(row) // 2
    waves = [arb_poly([2]), arb_poly([2, -1])]  # z^k + z^-k
    while len(waves) <= half:
        waves.append(arb_poly([2, -1]) * waves[-1] - waves[-2])
    both = sum((waves[k] * row[half + k] for k in range(1, half + 1)), arb_poly([row[half]]))
    found = []
    for y in between(both.coeffs(), arb(2) ** (-flint.ctx.prec // 3)):
        turn = 2 * arb.atan2(y.sqrt(), (4 - y).sqrt())
        z = acb(turn.cos(), turn.sin())
        found.append(-(acb_poly(top)(z) / (acb_poly(moved)(z) * (z - 1))).real)
    line = x.m2 - x.m1 + x.m0
    if not line.is_zero():  # a root at -1
        found.append(((1 + x.a + x.e) / line * (-1) ** whole - alpha) / 2)
    if any(not beta.is_finite() for beta in found):
        raise Undecided
    return sorted(found, key=lambda beta: float(beta.mid()))


def _between(dampings: list[Any]) -> list[float]:
    """A number between each two of them, and one on either side of all."""
    if not dampings:
        return [0.0]
    low, high = dampings[0], dampings[-1]
    middles = [(a + b) / 2 for a, b in pairwise(dampings)]
    found = [float(b.mid()) for b in (2 * low - abs(low) - 1, *middles, 2 * high + abs(high) + 1)]
    if all(a < beta < b for beta, (a, b) in zip(found[1:-1], pairwise(dampings), strict=True)):
        return found
    raise Undecided


@lru_cache(maxsize=4096)
def stiff_wall(gamma: float, delta: float, delay: float) -> tuple[float, float] | None:
    """The stiffest stable wall that a search finds.

    It tries stiffnesses between the tops of the explicit boundary that a grid of angles shows, from
    above, and goes up from the first that is stable.  So a stiffer wall may be stable.
    """

    def stable_at(alpha: float) -> float | None:
        try:
            return damping_at(alpha, gamma, delta, delay)
        except Undecided:
            return None

    tops = _tops(gamma, delta, delay)
    above = 2 * abs(tops[0]) + 1 if tops else 0.0
    for high, low in pairwise([*tops, -gamma]):
        for share in _HEIGHTS:
            alpha = low + (high - low) * share
            beta = stable_at(alpha)
            while beta is not None and above - alpha > _FINE * (alpha + gamma):
                middle = (alpha + above) / 2
                other = stable_at(middle)
                if other is None:
                    above = middle
                else:
                    alpha, beta = middle, other
            if beta is not None:
                return alpha, beta
            above = alpha
    return None


_FINE = 1e-7
"""Share of a stiffness up to which the search goes up."""

_HEIGHTS = 1 - 1e-6, 0.9, 0.5, 0.1, 1e-3
"""Where stiffnesses are tried between two tops of the boundary."""


def _tops(gamma: float, delta: float, delay: float) -> list[float]:
    """Stiffnesses of the tops of the boundary above -gamma, in floats, the largest first."""
    whole = periods(delay)
    with flint.ctx.workprec(BITS[2]):
        x = plant(gamma, delta, arb(delay) - whole)
        m2, m1, m0, a, e = (float(v) for v in x[:5])

    def stiffness(theta: Any) -> Any:
        z = np.exp(1j * theta)
        q = -(z ** (whole + 1)) * (z - a + e / z) / (m2 * z + m1 + m0 / z)
        return q.real - q.imag * np.tan(theta / 2)

    turns = math.ceil(delay) + math.sqrt(gamma) / math.pi + 2
    theta = np.linspace(0, math.pi, int(60 * turns))[1:-1]
    ends = theta[0] * 10.0 ** np.arange(-6, 0)
    theta = np.concatenate([ends, theta, math.pi - ends[::-1]])
    alpha = stiffness(theta)
    at = 1 + np.flatnonzero((alpha[1:-1] >= alpha[:-2]) & (alpha[1:-1] >= alpha[2:]))
    low, high = theta[at - 1], theta[at + 1]
    for _ in range(60):  # the third that is farther from the top is left out
        one, two = (2 * low + high) / 3, (low + 2 * high) / 3
        rises = stiffness(one) < stiffness(two)
        low, high = np.where(rises, one, low), np.where(rises, high, two)
    found = [*stiffness((low + high) / 2), alpha[0], alpha[-1]]
    return sorted({float(top) for top in found if top > -gamma}, reverse=True)

"""Exact values of what is searched for: a fine grid, then Newton's steps on power series of balls.

Made of the printed formulas and of matrix exponentials, as in symhaptic.bench.exact.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import Any

import flint
from flint import acb_poly, arb, arb_poly, arb_series

_MANY = 40
"""Angles a half turn of the delay."""

_HALF = arb(1) / 2

_SHORT = 4
"""Delays up to which the kernel of (5) is a sum of cosines, which no quotient makes wider."""

_LEAST = 1e-25
"""Share of the largest value by which the enclosure of a piece may be larger."""

_TERMS = 14
"""Of a series for |x| < 1/2."""

_PIECES = 2000
"""Pieces that are looked at before the working precision counts as too low."""


def series(f: Callable[[Any], Any], at: Any, terms: int) -> list[Any]:
    """The first coefficients of the power series of f at a number."""
    flint.ctx.cap = terms
    found = f(arb_series([at, 1], prec=terms))
    return [found[i] for i in range(terms)]


def required_damping(alpha: Any, beta: Any, whole: Any, part: Any) -> Callable[[Any], Any]:
    """(5) of the paper; at a fraction of a period the largest need of all motions."""

    def straight(t: Any, d: Any) -> Any:
        if isinstance(d, int) and d <= _SHORT:
            kernel = sum(((k * t).cos() for k in range(1, d + 1)), _HALF)
        else:
            kernel = ((d + _HALF) * t).sin() / (t * _HALF).sin() * _HALF
        return alpha * kernel - beta * ((d + 1) * t).cos()

    def at(t: Any) -> Any:
        if part == 0:
            return straight(t, whole)
        n = (1 - part) * straight(t, whole) + part * straight(t, whole + 1)
        sine = (t * _HALF).sin()
        extra = part * (1 - part) * (alpha * alpha + 4 * beta * (alpha + beta) * sine * sine)
        return (n + (n * n + extra).sqrt()) * _HALF

    return at


def passivity_margin(alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """delta minus the largest need on (0, pi), with its limits at the ends."""
    if alpha < 0:
        return (arb("-inf"),)
    return (arb(delta) - largest_required_damping(alpha, beta, d)[0],)


def largest_required_damping(alpha: float, beta: float, d: float) -> tuple[Any, Any]:
    """The largest need on (0, pi) for alpha >= 0, in a ball, and an angle where it is reached.

    With R^2 = (alpha/2)^2 cot^2(theta/2) + (alpha/2 + beta)^2 and
    rho^2 = 1 - 4 e (1 - e) sin^2(theta/2) for the fraction e, no need is larger than
    R (1 + rho)/2, which falls with the angle.  Pieces of the first half turns of the delay are
    enclosed up to the angle from which this bound is below what was found.
    """
    whole = math.floor(d)
    part = arb(d) - whole
    turn = arb.pi() / (arb(d) + 1)
    if alpha == 0 and (part == 0 or beta == 0):
        return abs(arb(beta)), arb(0) if beta <= 0 else turn
    wall = arb(alpha), arb(beta), whole, part
    found = _Largest(partial(required_damping_at, *wall), arb(alpha) * (d + 1) + abs(arb(beta)))
    for i in range(20):  # more than a half turn, from 0: pieces below these values are left out
        found.take(arb((turn * i / 12).mid()))
    shape = partial(series, required_damping(*wall), terms=3)
    low, high = arb(0), turn / 8
    found.within(low, high, shape if whole < _SHORT else partial(_near_zero, *wall))
    while (low := high) < arb.pi() and not _bound(*wall[:2], part, low) < found.ball:
        high = low + turn / 8
        found.within(low, high if high < arb.pi() else arb.pi(), shape)
    return found.ball, found.angle


def required_damping_at(alpha: Any, beta: Any, whole: int, part: Any, theta: Any) -> Any:
    """What (5) asks of the damping at an angle, or in its limit at 0; balls or power series."""
    if theta != 0:
        return required_damping(alpha, beta, whole, part)(theta)
    n = alpha * (part + whole + _HALF) - beta
    return (n + (n * n + part * (1 - part) * alpha * alpha).sqrt()) / 2 if part != 0 else n


def _bound(alpha: Any, beta: Any, part: Any, theta: Any) -> Any:
    """R (1 + rho)/2."""
    sine, cosine = (theta * _HALF).sin(), (theta * _HALF).cos()
    most = ((alpha * cosine / (2 * sine)) ** 2 + (alpha / 2 + beta) ** 2).sqrt()
    return most * (1 + (1 - 4 * part * (1 - part) * sine * sine).sqrt()) / 2


class _Largest:
    """The largest value of a function of an angle, over the pieces that are looked at."""

    def __init__(self, f: Callable[[Any], Any], size: Any) -> None:
        self.f, self.least = f, size * _LEAST
        self.ball, self.angle, self.pieces = arb("-inf"), arb(0), 0

    def take(self, angle: Any) -> None:
        """The value at an angle, which may be a ball."""
        if angle > arb.pi():
            return
        value = self.f(angle)
        if value.mid() > self.ball.mid():
            self.angle = arb(angle.mid())
        self.ball = self.ball.max(value)

    def within(self, low: Any, high: Any, look: Callable[[Any], Sequence[Any]]) -> None:
        """Divide a piece until the function has one slope there, or is concave, or is too small.

        ``look`` encloses the value, the slope and, if it can, half the second derivative.
        """
        left = [(arb(low.mid()), arb(high.mid()))]
        while left:
            self.pieces += 1
            if self.pieces > _PIECES:
                raise ArithmeticError("the balls are too wide for the largest value")
            low, high = left.pop()
            piece, middle = low.union(high), arb(((low + high) / 2).mid())
            value, rise, *bend = look(piece)
            if value < self.ball:
                continue
            if rise > 0 or rise < 0:
                self.take(high if rise > 0 else low)
            elif bend and bend[0] < 0:
                self.take(self._top(piece, look))
            elif bend and bend[0] > 0:
                self.take(low)
                self.take(high)
            elif (value := self.f(middle) + rise * (piece - middle)) < self.ball + self.least:
                self.ball = self.ball.max(value)
            else:
                left += [(middle, high), (low, middle)]

    def _top(self, piece: Any, look: Callable[[Any], Sequence[Any]]) -> Any:
        """Where a concave function is largest: Newton's method on the slope, in balls."""
        for _ in range(40):
            middle = arb(piece.mid())
            new = middle - look(middle)[1] / (2 * look(piece)[2])
            if not new.overlaps(piece):  # the slope keeps its sign: the top is an end
                return piece.upper() if new > piece else piece.lower()
            new = new.intersection(piece)
            if not new.rad() * 2 < piece.rad():
                return new
            piece = new
        return piece


def _near_zero(alpha: Any, beta: Any, whole: int, part: Any, t: Any) -> tuple[Any, Any]:
    """The need and its slope, on a ball of angles below 1/8 of a half turn and around 0.

    The slope over t, where its sign is known: that of the slope.
    """

    def sloped(x: Any) -> tuple[Any, Any]:
        """sin(x)/x, and its slope over x by an alternating series, with the first term left out."""
        square, slope = x * x, arb(0)
        for k in range(_TERMS, 0, -1):
            slope = arb((-1) ** k * 2 * k) / math.factorial(2 * k + 1) + square * slope
        k = _TERMS + 1
        return x.sinc(), slope + (square**_TERMS * 2 * k / math.factorial(2 * k + 1)) * arb(0, 1)

    (near, near_slope), sine = sloped(t / 2), (t / 2).sin()
    needs = []
    for d in (whole,) if part == 0 else (whole, whole + 1):
        long = d + _HALF
        (far, far_slope), turn = sloped(long * t), arb(d) + 1
        slope = long**2 * far_slope * near - near_slope * far / 4
        needs.append((
            alpha * long * far / near - beta * (turn * t).cos(),
            alpha * long * slope / near**2 + beta * turn**2 * (turn * t).sinc(),
        ))  # fmt: skip
    if part == 0:
        need, slope = needs[0]
        return need, slope if slope > 0 or slope < 0 else slope * t
    n, slope = ((1 - part) * one + part * other for one, other in zip(*needs, strict=True))
    share = part * (1 - part)
    root = (n**2 + share * (alpha**2 + 4 * beta * (alpha + beta) * sine**2)).sqrt()
    more = n * slope + share * beta * (alpha + beta) * t.sinc()
    slope = (slope + more / root) / 2
    return (n + root) / 2, slope if slope > 0 or slope < 0 else slope * t


# -- the passivity boundary at a fraction of a period ------------------------------------------


def crossing(f: Callable[[Any], Any], low: Any, high: Any, digits: int = 30) -> Any:
    """The root of f between two numbers where it has different signs; NaN if it has not.

    The Illinois method, with a bisection now and then.
    """
    at_low, at_high = f(low), f(high)
    if not (at_low > 0) ^ (at_high > 0):
        return arb("nan")
    side = 0
    for step in range(200):
        new = arb((low - at_low * (high - low) / (at_high - at_low)).mid())
        if step % 8 == 7 or not low < new < high:
            new = arb(((low + high) / 2).mid())
        value = f(new)
        if value == 0:
            return new
        if (value > 0) == (at_low > 0):
            at_high = at_high / 2 if side > 0 else at_high
            low, at_low, side = new, value, 1
        else:
            at_low = at_low / 2 if side < 0 else at_low
            high, at_high, side = new, value, -1
        if float(high - low) <= 10.0**-digits * abs(float(new)):
            return new
    return arb("nan")


def touching(theta: Any, whole: int, part: Any, digits: int = 30) -> tuple[Any, Any]:
    """The wall that is just passive for a damping of 1 and whose need has no slope at theta."""

    def wall(x: Any) -> tuple[Any, Any]:
        alpha = x.cos() / (whole + 1)
        return alpha, x.sin() - alpha / 2

    def slope(x: Any) -> Any:
        return arb(series(required_damping(*wall(x), whole, part), theta, 2)[1].mid())

    alpha, beta = wall(crossing(slope, arb(0), arb.pi() / 2, digits))
    need = required_damping(alpha, beta, whole, part)(theta)
    return alpha / need, beta / need


def passive(theta: float, delta: float, d: float) -> tuple[Any, ...]:
    """Of that wall, at a fraction of a period."""
    found = touching(arb(theta), math.floor(d), arb(d) - math.floor(d))
    return tuple(arb(delta) * x for x in found)


@cache
def _stiffest(d: float) -> tuple[Any, Any, Any]:
    whole, part = math.floor(d), arb(d) - math.floor(d)

    def hinders(theta: Any) -> Any:
        alpha, beta = touching(theta, whole, part, 22)
        changed = [required_damping(alpha, beta + x, whole, part)(theta) for x in (_STEP, -_STEP)]
        return arb((changed[0] - changed[1]).mid())

    turn = arb.pi() / (whole + part + 1)
    theta = crossing(hinders, turn * 3 / 10, turn * 7 / 10, 20)
    return (*touching(theta, whole, part), theta)


_STEP = arb(2) ** -40


def stiffest_passive(delta: float, d: float) -> tuple[Any, ...]:
    """The wall on it whose need does not change with beta: its stiffness is the largest."""
    alpha, beta, theta = _stiffest(d)
    return arb(delta) * alpha, arb(delta) * beta, theta


# -- the largest stable stiffness --------------------------------------------------------------


def stiffest_stable(numbers: tuple[Any, ...], gamma: float, d: float) -> tuple[Any, ...]:
    """The first maximum of alpha on -z^(l+1) A/M of a late device (m2, m1, m0, a, e)."""
    if gamma > 9.8 or (math.sqrt(gamma) * (d + 1) > math.pi and d > 1):
        return (arb("nan"),) * 3
    whole = math.floor(d)
    m2, m1, m0, a, e = numbers

    def parts(t: Any) -> tuple[Any, Any]:
        above, above_j = (1 + e) * t.cos() - a, (1 - e) * t.sin()
        below, below_j = (m2 + m0) * t.cos() + m1, (m2 - m0) * t.sin()
        cosine, sine = ((whole + 1) * t).cos(), ((whole + 1) * t).sin()
        size = below * below + below_j * below_j
        real = (above * below + above_j * below_j) / size
        up = (above_j * below - above * below_j) / size
        return up * sine - real * cosine, -(up * cosine + real * sine)

    def alpha(t: Any) -> Any:
        real, up = parts(t)
        half = t * _HALF
        return real - up * half.sin() / half.cos()

    end = arb.pi() / (arb(d) + 1) if d >= 1 else arb.pi()
    shares = [(i + _HALF) / _MANY for i in range(_MANY)]
    shares += [1 - arb(2) ** -k for k in range(8, 60)]  # the maximum may be next to the end
    before = None
    for share in shares:
        angle = arb((end * share).mid())
        rises = series(alpha, angle, 2)[1] > 0
        if before is not None and not rises:
            break
        before = angle if rises else None
    else:
        return _at_pi(parts) if d < 1 and before is not None else (arb("nan"),) * 3
    theta = crossing(lambda t: arb(series(alpha, t, 2)[1].mid()), before, angle)
    wall = alpha(theta), parts(theta)[1] / theta.sin()
    stiff = math.sqrt(gamma) * (d + 1) > math.pi
    if stiff and not _all_inside(wall[0] - (wall[0] + gamma) / 10**6, wall[1], whole, numbers):
        return (arb("nan"),) * 3
    return *wall, theta


def _all_inside(alpha: Any, beta: Any, whole: int, numbers: tuple[Any, ...]) -> bool:
    """Whether the loop with this wall is stable, by all roots of its polynomial in z."""
    m2, m1, m0, a, e = numbers
    wall, moved = arb_poly([-beta, alpha + beta]), arb_poly([m0, m1, m2])
    whole_loop = wall * moved + arb_poly([*[0] * (whole + 2), e, -a, 1])
    exact = acb_poly([c.mid() for c in whole_loop.coeffs()])
    return all(abs(root) < 1 for root in exact.roots())


def _at_pi(parts: Callable[[Any], tuple[Any, Any]]) -> tuple[Any, Any, Any]:
    """The end for delays below one period, where the imaginary part vanishes with sin(theta)."""
    slope = series(lambda t: parts(t)[1], arb.pi(), 2)[1]
    return parts(arb.pi())[0] + 2 * slope, -slope, arb.pi()

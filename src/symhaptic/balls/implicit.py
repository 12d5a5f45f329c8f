"""Exact values of what is searched for: a fine grid, then Newton's steps on power series of balls.

Made of the formulas in :mod:`symhaptic.balls.closed`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import Any

import flint
from flint import arb, arb_series

from symhaptic.balls import closed, winding
from symhaptic.balls.closed import HALF, SHORT, periods, required_damping, required_damping_at
from symhaptic.balls.zeros import narrowed

_MANY = 40
"""Angles up to theta (d + 1) = pi."""

_LEAST = 1e-25
"""Share of the largest value by which the enclosure of a piece may be larger."""

_TERMS = 14
"""Terms of a series for |x| < 1/2."""

_PIECES = 2000
"""The largest number of pieces; with more, the working precision is too low."""


def series(f: Callable[[Any], Any], at: Any, terms: int) -> list[Any]:
    """The first coefficients of the power series of f at a number."""
    before, flint.ctx.cap = flint.ctx.cap, terms
    try:
        found = f(arb_series([at, 1], prec=terms))
        return [found[i] for i in range(terms)]
    finally:
        flint.ctx.cap = before


def passivity_margin(alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """delta minus the largest required damping on (0, pi), limits at the ends included."""
    if alpha < 0:
        return (arb("-inf"),)
    return (arb(delta) - largest_required_damping(alpha, beta, d)[0],)


def largest_required_damping(alpha: float, beta: float, d: float) -> tuple[Any, Any]:
    """The largest required damping on (0, pi) for alpha >= 0, and an angle where it is reached.

    With R^2 = (alpha/2)^2 cot^2(theta/2) + (alpha/2 + beta)^2 and
    rho^2 = 1 - 4 e (1 - e) sin^2(theta/2) for the fraction e, no need is larger than
    R (1 + rho)/2, which falls with the angle.  Pieces of the first half turns of the delay are
    enclosed up to the angle from which this bound is below what was found.
    """
    whole = periods(d)
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
    found.within(low, high, shape if whole < SHORT else partial(_near_zero, *wall))
    while (low := high) < arb.pi() and not _bound(*wall[:2], part, low) < found.ball:
        high = low + turn / 8
        found.within(low, high if high < arb.pi() else arb.pi(), shape)
    return found.ball, found.angle


def _bound(alpha: Any, beta: Any, part: Any, theta: Any) -> Any:
    """R (1 + rho)/2."""
    sine, cosine = (theta * HALF).sin(), (theta * HALF).cos()
    most = ((alpha * cosine / (2 * sine)) ** 2 + (alpha / 2 + beta) ** 2).sqrt()
    return most * (1 + (1 - 4 * part * (1 - part) * sine * sine).sqrt()) / 2


class _Largest:
    """The largest value of a function of an angle over pieces of its range."""

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
        """Where a concave function is largest: where its slope is zero, or at an end."""
        found = narrowed(lambda t: look(t)[1], lambda t: 2 * look(t)[2], piece)
        if found is None:  # the slope keeps its sign
            return piece.upper() if look(arb(piece.mid()))[1] > 0 else piece.lower()
        return found


def _near_zero(alpha: Any, beta: Any, whole: int, part: Any, t: Any) -> tuple[Any, Any]:
    """The required damping and its slope for small angles, on a ball that contains 0.

    If the sign of the slope over t is known, it is returned instead of the slope.
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
        long = d + HALF
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
    """The root of f between two numbers where f has different signs; NaN if the signs are equal.

    The Illinois method; each eighth step is a bisection.
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
    """The wall that is just passive for a damping of 1 and whose worst angle is theta."""

    def wall(x: Any) -> tuple[Any, Any]:
        alpha = x.cos() / (whole + 1)
        return alpha, x.sin() - alpha / 2

    def slope(x: Any) -> Any:
        return arb(series(required_damping(*wall(x), whole, part), theta, 2)[1].mid())

    alpha, beta = wall(crossing(slope, arb(0), arb.pi() / 2, digits))
    need = required_damping(alpha, beta, whole, part)(theta)
    return alpha / need, beta / need


def just_passive(theta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """The wall that is just passive, and whose worst angle is theta."""
    whole, part = closed.split(d)
    if closed.value(part) == 0:
        return closed.envelope(theta, delta, d)
    alpha, beta = touching(closed.value(theta), whole, closed.value(part))
    return closed.ball(delta) * alpha, closed.ball(delta) * beta


@cache
def _stiffest(d: float) -> tuple[Any, Any, Any]:
    whole, part = closed.split(d)

    def hinders(theta: Any) -> Any:
        alpha, beta = touching(theta, whole, part, 22)
        changed = [required_damping(alpha, beta + x, whole, part)(theta) for x in (_STEP, -_STEP)]
        return arb((changed[0] - changed[1]).mid())

    turn = arb.pi() / (whole + part + 1)
    theta = crossing(hinders, turn * 3 / 10, turn * 7 / 10, 20)
    return (*touching(theta, whole, part), theta)


_STEP = arb(2) ** -40


def max_passive(delta: Any, d: Any) -> tuple[Any, ...]:
    """The wall of maximum passive stiffness: its required damping does not change with beta."""
    if closed.value(closed.split(d)[1]) == 0:
        return closed.max_passive(delta, d)
    alpha, beta, theta = _stiffest(float(closed.value(d)))
    return closed.ball(delta) * alpha, closed.ball(delta) * beta, theta


# -- the largest stable stiffness --------------------------------------------------------------


def max_stable(gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """The first maximum of alpha on the boundary, with its beta and its angle; NaN if none."""
    nothing = (arb("nan"),) * 3
    if gamma > 9.8 or (math.sqrt(gamma) * (d + 1) > math.pi and d > 1):
        return nothing
    whole, part = closed.split(d)
    numbers = closed.delayed(gamma, delta, part)

    def rise(t: Any) -> Any:
        return series(lambda x: closed.curve(x, numbers, whole)[0], t, 2)[1]

    end = arb.pi() / (arb(d) + 1) if d >= 1 else arb.pi()
    shares = [(i + HALF) / _MANY for i in range(_MANY)]
    shares += [1 - arb(2) ** -k for k in range(8, 60)]  # the maximum may be next to the end
    before = None
    for share in shares:
        angle = arb((end * share).mid())
        rises = rise(angle) > 0
        if before is not None and not rises:
            break
        before = angle if rises else None
    else:
        at_pi = d < 1 and before is not None
        return (*closed.curve(arb.pi(), numbers, whole), arb.pi()) if at_pi else nothing
    theta = crossing(lambda t: arb(rise(t).mid()), before, angle)
    alpha, beta = closed.curve(theta, numbers, whole)
    softer = float((alpha - (alpha + gamma) / 10**6).mid())
    stiff = math.sqrt(gamma) * (d + 1) > math.pi
    if stiff and not winding.stable(softer, float(beta.mid()), float(gamma), float(delta), d):
        return nothing
    return alpha, beta, theta

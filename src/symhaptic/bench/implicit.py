"""Exact values of what is searched for: a fine grid, then Newton's steps on power series of balls.

Made of the printed formulas and of matrix exponentials, as in symhaptic.bench.exact.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import flint
import numpy as np
from flint import acb_poly, arb, arb_poly, arb_series

_MANY = 40
"""Angles a half turn of the delay."""

_FAR = 8
"""Half turns of a long delay that are looked at; all of them for a short one."""


def angles(turn: float) -> Any:
    """The grid, on (0, pi)."""
    count = min(int(math.pi / turn), _FAR) * _MANY
    grid = turn * np.arange(1, count) / _MANY
    return grid if count >= _FAR * _MANY else np.append(grid, math.pi)


def peaks(values: Any) -> Any:
    """Each value, and where it is the largest of three the peak of the parabola through them."""
    rise, fall = values[1:-1] - values[:-2], values[1:-1] - values[2:]
    bend = np.where((rise >= 0) & (fall >= 0) & (rise + fall > 0), rise + fall, math.inf)
    found = values.copy()
    found[1:-1] += (rise - fall) ** 2 / (8 * bend)
    return found


def stationary(f: Callable[[Any], Any], low: float, near: float, high: float) -> Any:
    """Where the slope of a function of power series changes its sign, on one side of ``near``."""

    def slope(at: Any) -> Any:
        return arb(series(f, at, 2)[1].mid())

    ends = (low, near) if slope(arb(near)) < 0 else (near, high)
    return crossing(slope, *map(arb, ends))


def series(f: Callable[[Any], Any], at: Any, terms: int) -> list[Any]:
    """The first coefficients of the power series of f at a number."""
    flint.ctx.cap = terms
    found = f(arb_series([at, 1], prec=terms))
    return [found[i] for i in range(terms)]


def required_damping(
    alpha: Any, beta: Any, whole: Any, part: Any, lib: Any
) -> Callable[[Any], Any]:
    """(5) of the paper, at a fraction the need of all motions; ``lib`` has sin, cos and sqrt."""

    def straight(t: Any, d: Any) -> Any:
        half = lib.half
        kernel = lib.sin((d + half) * t) / lib.sin(t * half) * half
        return alpha * kernel - beta * lib.cos((d + 1) * t)

    def at(t: Any) -> Any:
        if part == 0:
            return straight(t, whole)
        n = (1 - part) * straight(t, whole) + part * straight(t, whole + 1)
        sine = lib.sin(t * lib.half)
        extra = part * (1 - part) * (alpha * alpha + 4 * beta * (alpha + beta) * sine * sine)
        return (n + lib.sqrt(n * n + extra)) * lib.half

    return at


class _Balls:
    half = arb(1) / 2
    sin = staticmethod(lambda x: x.sin())
    cos = staticmethod(lambda x: x.cos())
    sqrt = staticmethod(lambda x: x.sqrt())


class _Floats:
    half = 0.5
    sin, cos = np.sin, np.cos
    sqrt = staticmethod(lambda x: np.sqrt(np.maximum(x, 0)))


def passivity_margin(alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """delta minus the largest need on (0, pi), with its limits at the ends."""
    if alpha < 0:
        return (arb("-inf"),)
    return (arb(delta) - largest_required_damping(alpha, beta, d)[0],)


def largest_required_damping(alpha: float, beta: float, d: float) -> tuple[Any, Any]:
    """The largest need on (0, pi) and its angle, which is 0 where the need has its limit there."""
    whole, part = math.floor(d), d - math.floor(d)
    grid = angles(math.pi / (whole + 1))
    values = required_damping(alpha, beta, whole, part, _Floats)(grid)
    best = int(np.argmax(peaks(values)))
    wall = arb(alpha), arb(beta), whole, arb(part)
    tried = [arb(0), arb(float(grid[best]))]
    if best + 1 < len(grid):
        before = grid[best - 1] if best else grid[0] / 10**6
        ends = map(float, (before, grid[best], grid[best + 1]))
        angle = stationary(required_damping(*wall, _Balls), *ends)
        tried += [angle] if angle.is_finite() else []
    elif grid[best] == math.pi:
        angle = _before_pi(required_damping(*wall, _Balls), float(grid[-2]))
        tried += [angle] if angle.is_finite() else []
    return max(((required_damping_at(*wall, t), t) for t in tried), key=lambda pair: pair[0].mid())


def _before_pi(f: Callable[[Any], Any], low: float) -> Any:
    """Where the slope changes its sign behind the last angle but pi, where it vanishes."""

    def slope(at: Any) -> Any:
        found = -2 * series(f, at, 3)[2] if at == end else series(f, at, 2)[1] / (end - at)
        return arb(found.mid())

    end = arb(math.pi)
    return crossing(slope, arb(low), end)


def required_damping_at(alpha: Any, beta: Any, whole: int, part: Any, theta: Any) -> Any:
    """What (5) asks of the damping at an angle, or in its limit at 0; balls or power series."""
    if theta != 0:
        return required_damping(alpha, beta, whole, part, _Balls)(theta)
    n = alpha * (part + whole + _Balls.half) - beta
    return (n + (n * n + part * (1 - part) * alpha * alpha).sqrt()) / 2 if part != 0 else n


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
        return arb(series(required_damping(*wall(x), whole, part, _Balls), theta, 2)[1].mid())

    alpha, beta = wall(crossing(slope, arb(0), arb.pi() / 2, digits))
    need = required_damping(alpha, beta, whole, part, _Balls)(theta)
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
        changed = [
            required_damping(alpha, beta + x, whole, part, _Balls)(theta) for x in (_STEP, -_STEP)
        ]
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
        half = t * _Balls.half
        return real - up * half.sin() / half.cos()

    end = arb.pi() / (arb(d) + 1) if d >= 1 else arb.pi()
    shares = [(i + _Balls.half) / _MANY for i in range(_MANY)]
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

"""Exact values of what is searched for: a fine grid, then Newton's steps on power series of balls.

Made of the printed formulas and of matrix exponentials, as in symhaptic.bench.exact.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import flint
import numpy as np
from flint import arb, arb_series

_MANY = 40
"""Angles a half turn of the delay."""

_FAR = 8
"""Half turns of a long delay that are looked at; all of them for a short one."""

_STEPS = 60
"""Newton's steps, at most."""


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


def stationary(f: Callable[[Any], Any], start: float, low: float, high: float) -> Any:
    """Where the slope of a function of power series vanishes, between two angles."""
    at = arb(start)
    for _ in range(_STEPS):
        _, slope, bend = series(f, at, 3)
        step = slope / (2 * bend)
        moved = arb((at - step).mid())
        if not low <= float(moved) <= high:
            moved = arb((low + high) / 2) if low <= float(at) <= high else at
        at = moved
        if abs(float(step)) < 1e-25 * float(at):
            break
    return at


def series(f: Callable[[Any], Any], at: Any, terms: int) -> list[Any]:
    """The first coefficients of the power series of f at a number."""
    flint.ctx.cap = terms
    found = f(arb_series([at, 1], prec=terms))
    return [found[i] for i in range(terms)]


def needed(alpha: Any, beta: Any, whole: Any, part: Any, lib: Any) -> Callable[[Any], Any]:
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


def worst(alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """delta minus the largest need on (0, pi), with its limits at the ends."""
    if alpha < 0:
        return (arb("-inf"),)
    whole, part = math.floor(d), d - math.floor(d)
    grid = angles(math.pi / (whole + 1))
    values = needed(alpha, beta, whole, part, _Floats)(grid)
    best = int(np.argmax(peaks(values)))
    al, be, ep = arb(alpha), arb(beta), arb(part)
    n = al * (arb(d) + arb(1) / 2) - be
    found = [(n + (n * n + ep * (1 - ep) * al * al).sqrt()) / 2 if part else n]
    exact = needed(al, be, whole, ep if part else 0, _Balls)
    found.append(exact(arb(float(grid[best]))))
    around = grid[max(best - 1, 0)] * (best > 0), grid[min(best + 1, len(grid) - 1)]
    if best + 1 < len(grid):
        angle = stationary(exact, float(grid[best]), *map(float, around))
        found.append(exact(angle))
    return (arb(delta) - max(found, key=lambda x: float(x.mid())),)


SEARCHED = {"passivity_margin": worst}

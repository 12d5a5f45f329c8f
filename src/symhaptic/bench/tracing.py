"""The boundary of stability: the paper's grid, bisection along rays, and the explicit form."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache, partial
from typing import Any

import flint
import numpy as np
from flint import arb
from numpy.typing import NDArray

from symhaptic.balls import closed, implicit
from symhaptic.bench.points import Array
from symhaptic.bench.timing import seconds
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.grid import grid_boundary, spectral_radius
from symhaptic.numeric.tracing.region import stable_region

GAMMA, DELTA = 1e-3, 0.02
"""The corner of the paper's (23)."""

RAYS = 64
_BITS = 200


def measured(
    delays: tuple[int, ...], thresholds: tuple[float, ...], nodes: int, checked: int
) -> Iterator[dict[str, Any]]:
    """One row for each delay, method and threshold."""
    for delay in delays:
        left, low, right, high = stable_region(GAMMA, DELTA, delay).polygon.bounds
        wide, tall = right - left, high - low
        alphas = np.linspace(left - 0.1 * wide, right + 0.1 * wide, nodes)
        betas = np.linspace(low - 0.1 * tall, high + 0.1 * tall, nodes)
        inside = np.array(stable_region(GAMMA, DELTA, delay).polygon.representative_point().coords)
        works: list[tuple[str, float | None, Callable[[], Array]]] = []
        for threshold in thresholds:
            grid = partial(grid_boundary, GAMMA, DELTA, delay, alphas, betas, threshold)
            works.append(("grid", threshold, grid))
            for name, stable in _tests(delay).items():
                ray = partial(rays, stable, inside[0], math.hypot(wide, tall), threshold)
                works.append((name, threshold, ray))
        angles = np.linspace(0, math.pi, 4001)[1:-1]
        bordering = angles[stable_region(GAMMA, DELTA, delay).loop.borders(angles)]
        many = np.resize(bordering, 20_000)
        explicit = partial(stability_boundary, many, GAMMA, DELTA, delay)
        works.append(("explicit", None, partial(_stacked, explicit)))
        for name, limit, work in works:
            points = work()
            some = points[np.linspace(0, len(points) - 1, checked).astype(int)]
            off = [distance(p, delay) for p in some]
            yield {
                "method": name,
                "delay": delay,
                "threshold": limit,
                "points": len(points),
                "seconds": seconds(work, 3) / len(points),
                "median": float(np.median(off)),
                "worst": max(off),
            }


def _tests(delay: int) -> dict[str, Callable[[Array], NDArray[np.bool_]]]:
    """Whether walls are stable, by eigenvalues and by the number of roots outside."""
    return {
        "rays": lambda p: np.asarray(spectral_radius(p[:, 0], p[:, 1], GAMMA, DELTA, delay) < 1),
        "rays, counted": lambda p: is_stable(p[:, 0], p[:, 1], GAMMA, DELTA, delay),
    }


def _stacked(pairs: Callable[[], tuple[Array, Array]]) -> Array:
    return np.stack(pairs(), axis=1)


def rays(
    stable: Callable[[Array], NDArray[np.bool_]], inside: Array, far: float, threshold: float
) -> Array:
    """Where rays from a stable wall leave the region, by bisection, all side by side."""
    angles = 2 * np.pi * np.arange(RAYS) / RAYS
    way = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    low, high = np.zeros(RAYS), np.full(RAYS, far)
    for _ in range(math.ceil(math.log2(far / threshold))):
        middle = (low + high) / 2
        good = stable(inside + middle[:, None] * way)
        low, high = np.where(good, middle, low), np.where(good, high, middle)
    return np.asarray(inside + ((low + high) / 2)[:, None] * way)


@cache
def _near(delay: int) -> tuple[Array, Array]:
    """Many angles and their points of the curve."""
    angles = np.linspace(0, math.pi, 20_001)[1:-1]
    return angles, np.stack(stability_boundary(angles, GAMMA, DELTA, delay), axis=1)


def distance(point: Array, delay: int) -> float:
    """From a wall to the exact boundary: the curve, or the line alpha = -gamma.

    Newton's method for the foot of the perpendicular begins at the nearest of many points of the
    curve; the squared distance is a power series of the angle.
    """
    angles, curve = _near(delay)
    with flint.ctx.workprec(_BITS):
        theta = arb(float(angles[np.argmin(np.hypot(*(curve - point).T))]))
        alpha, beta = map(float, point)
        found = [abs(arb(alpha) + GAMMA)]

        def squared(angle: Any) -> Any:
            x, y = closed.curve(angle, _device(), delay)
            return (x - alpha) * (x - alpha) + (y - beta) * (y - beta)

        for _ in range(12):
            square = implicit.series(squared, theta, 3)
            if square[0].is_finite():
                found.append(arb(square[0].mid()).sqrt())
            if not square[2] > 0:
                break
            before, theta = theta, (theta - square[1] / (2 * square[2])).mid()
            if abs(theta - before) < arb(2) ** -100:
                break
        return min(float(f.mid()) for f in found)


@cache
def _device() -> tuple[arb, ...]:
    """The exact numbers of the device, without a fraction of a period."""
    return closed.delayed(GAMMA, DELTA, 0)

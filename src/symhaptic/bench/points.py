"""Where functions are measured: hard cases first, then ordinary, wide, critical and stiff ones."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any, cast

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from scipy.optimize import brentq

from symhaptic.export.precision import DOUBLE, SINGLE, Precision
from symhaptic.forms import max_stiffness_slope
from symhaptic.forms.stable import Form
from symhaptic.kernels.haptic import discretize

Array = NDArray[np.floating[Any]]

HARD = {
    DOUBLE: [0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 1.0, 10.0, 700.0],
    SINGLE: [0.0, 1e-30, 1e-8, 1e-6, 1e-4, 1e-2, 1.0, 10.0, 700.0],
}
DELAYS = [0.0, 1.0, 2.0, 5.0, 100.0, 1e6, 0.5, 1e-3, 0.1]


_TELLS = 10_000
"""Least distance, in units in the last place, from the damping of :func:`leaving_pi`."""


def hard(precision: Precision = DOUBLE) -> list[tuple[float, float]]:
    """All pairs of hard cases, critical damping and its neighbours, pi^2 and beyond."""
    kind = precision.kind
    found: list[tuple[float, float]] = [(g, d) for g in HARD[precision] for d in HARD[precision]]
    for damping in (1e-8, 0.1, 1.0, 2.0, 3.0, 3.9999, 4.0, 4.5, 5.0, 7.0, 20.0, 100.0, 700.0):
        d = precision.nearest(damping)
        g = (d / 2) ** 2
        near = kind(g)
        neighbours = near, np.nextafter(near, kind(0)), np.nextafter(near, kind(1e9))
        found += [(float(v), d) for v in (*neighbours, g * (1 + 1e-15))]
        found += [(g * (1 - 1e-12), d), (g * (1 + 1e-8), d)]
    return [*found, (math.pi**2, 0.0), (math.pi**2, 0.02), (39.47841760435743, 0.0)]


def plants(rng: np.random.Generator, count: int, precision: Precision = DOUBLE) -> Array:
    """gamma and delta: hard cases first, then ordinary, wide, critical and stiff ones."""
    found = hard(precision)
    while len(found) < count:
        d = 10 ** rng.uniform(-3, 2.8)
        near = rng.choice([0, 1e-15, -1e-15, 1e-12, -1e-8, 1e-4, -1e-3])
        found += [
            (rng.uniform(0, 1e-3), rng.uniform(0, 0.02)),
            (rng.uniform(0, 10), rng.uniform(0, 6)),
            (10 ** rng.uniform(-12, 3), 10 ** rng.uniform(-12, 2.85)),
            ((d / 2) ** 2 * (1 + near), d),
            (rng.uniform(0, 700), rng.uniform(0, 60)),
            (0.0, 10 ** rng.uniform(-12, 2.85)),
        ]
    return np.array(found[:count])


@lru_cache(maxsize=4096)  # the same plants are tried in both precisions
def leaving_pi(gamma: float) -> float:
    """The damping above which the stiffest stable wall without delay is at theta = pi."""

    def rises(delta: float) -> float:
        n1, n0, a, e = discretize(gamma, delta)
        return float(_end()(1 - a + e, 1 + a + e, 1 - e, n1 + n0, n1 - n0, 0.0))

    return float(brentq(rises, 0.1, 4.0))


@cache
def _end() -> Callable[..., float]:
    return cast(
        Callable[..., float],
        sp.lambdify(max_stiffness_slope.EARLY, max_stiffness_slope.end(), "math"),
    )


def columns(
    form: Form, rng: np.random.Generator, count: int, precision: Precision = DOUBLE
) -> list[Array]:
    """Arguments of a form, one array each, of floats of the precision."""
    both = plants(rng, count, precision)
    if "gamma" not in {s.name for s in form.arguments}:
        rng.shuffle(both)
    signs = rng.choice([-1.0, 1.0], count)
    delay = rng.choice(DELAYS, count)
    some = rng.random(count) < 0.5
    delay = np.where(some, delay, np.floor(10 ** rng.uniform(0, 6, count)))
    delay = np.where(rng.random(count) < 0.3, 10 ** rng.uniform(-1, 4, count), delay)
    most = (
        np.pi / (delay + 1)
        if (form.plain or form).name == "passivity_boundary"
        else np.full(count, np.pi)
    )
    theta = most * np.where(some, rng.uniform(0, 1, count), 10 ** rng.uniform(-6, 0, count))
    theta = np.where(rng.random(count) < 0.1, most * (1 - 10 ** rng.uniform(-12, -1, count)), theta)
    damping = both[:, 1]
    if form.name == "passivity_boundary":  # delta over the cube of the delay is a normal float
        least = 2 * float(np.finfo(precision.kind).tiny) * (2 * (delay + 1)) ** 3
        damping = np.where(damping > 0, np.maximum(damping, least), 0)
    if (form.plain or form).name == "max_stable_stiffness":  # there its angle is hard to find
        edge = np.flatnonzero(rng.random(count) < 0.2)
        both[edge, 0] = rng.uniform(0, 9.7, edge.size)
        # nearer ones are decided by less than the rounding of the plant
        near = rng.uniform(math.log10(_TELLS * precision.ulp(1.0)), -1, edge.size)
        beside = 1 + rng.choice([-1.0, 1.0], edge.size) * 10**near
        both[edge, 1] = [leaving_pi(gamma) for gamma in both[edge, 0]] * beside
        delay[edge] = rng.choice([0.0, 1.0], edge.size) * 10 ** rng.uniform(-8, 0, edge.size)
        far = np.sqrt(both[:, 0]) * (delay + 1) > np.pi
        seen = 5 * precision.ulp(1.0)  # less damping is lost in a pole of size one
        both[far & (both[:, 1] > 0), 1] = np.maximum(both[far & (both[:, 1] > 0), 1], seen)
    values = {
        "gamma": both[:, 0],
        "delta": damping,
        "alpha": signs * 10 ** rng.uniform(-6, 2, count),
        "beta": rng.choice([-1.0, 1.0], count) * 10 ** rng.uniform(-6, 2, count),
        "d": delay,
        "epsilon": np.where(some, rng.uniform(0, 1, count), delay % 1),
        "theta": np.minimum(theta, 3.14159265),
    }
    arrays: list[Array] = [
        np.ascontiguousarray(values[s.name], dtype=precision.kind) for s in form.arguments
    ]
    if precision is SINGLE and "theta" in {s.name for s in form.arguments}:
        np.minimum(arrays[0], precision.below_pi, out=arrays[0])
    return arrays

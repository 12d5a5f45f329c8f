"""The time that simpler models of the loop take, and the errors of their stiffness limits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from symhaptic.bench.points import Array
from symhaptic.bench.timing import seconds
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.linear import linear_limit
from symhaptic.numeric.tracing.extremes import max_stable_stiffness

SHARES = (0.0, 0.1, 0.25, 0.5, 0.75)
"""Virtual damping, relative to that of the wall of maximum stiffness of the full model."""

_HALVINGS = 60


def limit(beta: Array, gamma: Array, delta: Array, delay: float) -> Array:
    """The largest stable alpha for a beta up to that of the stiffest wall; 0 without damping.

    The boundary's beta grows from theta = 0 to the stiffest wall's; beta is met there by
    bisection.
    """
    tip = max_stable_stiffness(gamma, delta, delay)
    low, high = 1e-9 * tip.theta, 1.0 * tip.theta
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        less = stability_boundary(middle, gamma, delta, delay)[1] < beta
        low, high = np.where(less, middle, low), np.where(less, high, middle)
    alpha = stability_boundary((low + high) / 2, gamma, delta, delay)[0]
    return np.asarray(np.maximum(alpha, 0.0))


MODELS: dict[str, Callable[[Array, Array, Array, float], Array]] = {
    "linear": lambda beta, gamma, delta, d: linear_limit(beta, delta, d),
    "mass alone": lambda beta, gamma, delta, d: limit(beta, 0 * gamma, 0 * delta, d),
    "no damping": lambda beta, gamma, delta, d: limit(beta, gamma, 0 * delta, d),
    "no stiffness": lambda beta, gamma, delta, d: limit(beta, 0 * gamma, delta, d),
    "full": limit,
}


def measured(delays: tuple[int, ...], count: int) -> Iterator[dict[str, Any]]:
    """One row for each delay, model and virtual damping: the limit over the full one, less 1."""
    rng = np.random.default_rng(11)
    gamma, delta = rng.uniform(0, 1e-3, count), rng.uniform(0, 0.02, count)
    for delay in delays:
        tip = max_stable_stiffness(gamma, delta, delay)
        exact = {share: limit(share * tip.beta, gamma, delta, delay) for share in SHARES}
        for name, model in MODELS.items():
            work = partial(model, SHARES[-1] * tip.beta, gamma, delta, delay)
            took = seconds(work, 2) / count
            for share in SHARES:
                off = model(share * tip.beta, gamma, delta, delay) / exact[share] - 1
                yield {
                    "delay": delay,
                    "model": name,
                    "damping": share,
                    "seconds": took,
                    "median": float(np.median(np.abs(off))),
                    "most": float(off.max()),
                    "least": float(off.min()),
                }

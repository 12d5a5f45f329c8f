"""Roots of a cubic inside (0, 4), given about three points, by Newton's method on convex pieces."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric.arguments import Array

_STEPS = 1000
"""At most so many: every piece converges from its safe end, a double root by half a step; the
faintest wall that is counted has a root of 2^-800."""

Terms = Sequence[Array]
"""Coefficients, constant term first."""


def value(k: Terms, y: Array) -> Array:
    """The polynomial at y."""
    return ((k[3] * y + k[2]) * y + k[1]) * y + k[0]


def _cuts(k: Terms, low: Array, high: Array) -> Array:
    """The ends, and the extrema and the inflection between them, rising."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        root = np.sqrt(k[2] ** 2 - 3 * k[3] * k[1])
        q = -(k[2] + np.where(k[2] < 0, -root, root))
        inner = np.stack([q / (3 * k[3]), k[1] / q, -k[2] / (3 * k[3])])
    inner = np.sort(np.where((inner > low) & (inner < high), inner, low), axis=0)
    return np.concatenate([low[None], inner, high[None]])


def _newton(k: Terms, low: Array, high: Array, rises: NDArray[np.bool_]) -> Array:
    """The root between the ends of a piece without extremum or inflection inside."""
    convex = 3 * k[3] * (low + high) + 2 * k[2] > 0
    down = rises == convex  # from this end Newton never overshoots
    y = np.where(down, high, low)
    left = np.arange(y.size)
    for _ in range(_STEPS):
        if not left.size:
            break
        now = y[left]
        some = [c[left] for c in k]
        slope = (3 * some[3] * now + 2 * some[2]) * now + some[1]
        step = value(some, now) / np.where(slope == 0, np.inf, slope)
        new = np.clip(now - step, low[left], high[left])
        y[left] = new
        left = left[np.where(down[left], new < now, new > now)]
    return y


def _between(
    k: Terms, low: Array, high: Array, at_low: Array, at_high: Array
) -> tuple[Array, NDArray[np.bool_], NDArray[np.bool_]]:
    """For each of four pieces: the root, whether the cubic rises there, whether it is there."""
    cuts = _cuts(k, low, high)
    values = np.stack([at_low, *(value(k, cut) for cut in cuts[1:-1]), at_high])
    there = ((values[:-1] < 0) != (values[1:] < 0)) & (cuts[1:] > cuts[:-1])
    rises = values[:-1] < values[1:]
    found = np.zeros(there.shape)
    at = np.nonzero(there)
    some = [c[at[1]] for c in k]
    found[at] = _newton(some, cuts[:-1][at], cuts[1:][at], rises[at])
    return found, rises, there


def roots(
    near: Terms, own: Terms, far: Terms, center: Array, beyond: Array
) -> list[tuple[Array, Array, Array, NDArray[np.bool_], NDArray[np.bool_]]]:
    """y, 4 - y, y - center, whether the cubic rises with y, and whether there is a root at all.

    ``near``, ``own`` and ``far`` are the coefficients of one cubic in y, in y - ``center`` and in
    4 - y, constant term first, and ``beyond`` is 4 - ``center``; the point next to a root gives it
    its digits.
    """
    given = (*near, *own, *far, center, beyond)
    shape = np.broadcast_shapes(*(c.shape for c in given))
    flat = [np.broadcast_to(c, shape).reshape(-1) for c in given]
    near, own, far, (center, beyond) = flat[:4], flat[4:8], flat[8:12], flat[12:]
    none, one, two = np.zeros_like(center), center / 2, beyond / 2
    at_one, at_two = value(own, -one), value(own, two)
    y, rises, there = _between(near, none, one, near[0], at_one)
    off, rises_own, there_own = _between(own, -one, two, at_one, at_two)
    rest, falls, there_far = _between(far, none, two, far[0], at_two)
    y, rest, off = (
        np.concatenate([y, center + off, 4 - rest]),
        np.concatenate([4 - y, beyond - off, rest]),
        np.concatenate([y - center, off, beyond - rest]),
    )
    rises = np.concatenate([rises, rises_own, ~falls])
    there = np.concatenate([there, there_own, there_far]) & (y > 0) & (rest > 0)
    y, rest, off = np.where(there, [y, rest, off], 2.0)
    # at most three of the twelve pieces have a root: move them to the front
    order = np.argsort(~there, axis=0, kind="stable")[: int(there.sum(axis=0).max(initial=0))]
    columns = [np.take_along_axis(v, order, axis=0) for v in (y, rest, off, rises, there)]
    return [
        (a.reshape(shape), b.reshape(shape), o.reshape(shape), r.reshape(shape), t.reshape(shape))
        for a, b, o, r, t in zip(*columns, strict=True)
    ]

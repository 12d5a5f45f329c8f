"""Roots of a cubic inside (0, 4), given around both ends, by Newton's method on convex pieces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from symhaptic.kernels.arguments import Array

_STEPS = 100
"""At most so many: every piece converges from its safe end, a double root by half a step."""

Terms = tuple[Array, ...]
"""Coefficients, constant term first."""


def _value(k: Terms, y: Array) -> Array:
    return ((k[3] * y + k[2]) * y + k[1]) * y + k[0]


def _cuts(k: Terms) -> Array:
    """0, the extrema and the inflection inside (0, 2), and 2, rising."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        root = np.sqrt(k[2] ** 2 - 3 * k[3] * k[1])
        q = -(k[2] + np.where(k[2] < 0, -root, root))
        inner = np.stack([q / (3 * k[3]), k[1] / q, -k[2] / (3 * k[3])])
    inner = np.sort(np.where((inner > 0) & (inner < 2), inner, 0.0), axis=0)
    return np.concatenate([np.zeros_like(inner[:1]), inner, np.full_like(inner[:1], 2.0)])


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
        some = k[0][left], k[1][left], k[2][left], k[3][left]
        slope = (3 * some[3] * now + 2 * some[2]) * now + some[1]
        step = _value(some, now) / np.where(slope == 0, np.inf, slope)
        new = np.clip(now - step, low[left], high[left])
        y[left] = new
        left = left[np.where(down[left], new < now, new > now)]
    return y


def _half(k: Terms, at_two: Array) -> tuple[Array, NDArray[np.bool_], NDArray[np.bool_]]:
    """For each of four pieces of (0, 2): the root, whether the cubic rises, whether it is there."""
    cuts = _cuts(k)
    values = np.stack([k[0], *(_value(k, cut) for cut in cuts[1:-1]), at_two])
    there = ((values[:-1] < 0) != (values[1:] < 0)) & (cuts[1:] > cuts[:-1])
    rises = values[:-1] < values[1:]
    y = np.ones(there.shape)
    at = np.nonzero(there)
    some = k[0][at[1]], k[1][at[1]], k[2][at[1]], k[3][at[1]]
    y[at] = _newton(some, cuts[:-1][at], cuts[1:][at], rises[at])
    there &= y > 0  # a root at the very end is none on the open half circle
    return y, rises, there


def roots(
    near: Terms, far: Terms
) -> list[tuple[Array, Array, NDArray[np.bool_], NDArray[np.bool_]]]:
    """y, 4 - y, whether the cubic rises with y, and whether there is a root at all.

    ``near`` are the coefficients in y, ``far`` those of the same cubic in 4 - y, constant term
    first; the end where a root lies gives it its digits.
    """
    shape = np.broadcast_shapes(*(c.shape for c in (*near, *far)))
    flat = [np.broadcast_to(c, shape).reshape(-1) for c in (*near, *far)]
    n, f = tuple(flat[:4]), tuple(flat[4:])
    middle = _value(n, np.full_like(n[0], 2.0))
    y, rises, there = _half(n, middle)
    rest, falls, beyond = _half(f, middle)
    y, rest = np.concatenate([y, 4 - rest]), np.concatenate([4 - y, rest])
    rises, there = np.concatenate([rises, ~falls]), np.concatenate([there, beyond])
    # at most three of the eight pieces have a root: move them to the front
    order = np.argsort(~there, axis=0, kind="stable")[: int(there.sum(axis=0).max(initial=0))]
    columns = [np.take_along_axis(v, order, axis=0) for v in (y, rest, rises, there)]
    return [
        (a.reshape(shape), b.reshape(shape), r.reshape(shape), t.reshape(shape))
        for a, b, r, t in zip(*columns, strict=True)
    ]

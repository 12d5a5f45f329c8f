"""Roots of a cubic inside (0, 4), given around both ends, by Newton's method on convex pieces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from symhaptic.kernels.arguments import Array

_STEPS = 80
"""At most so many: every piece converges from its safe end, a double root by a third a step."""


def _value(k: tuple[Array, ...], y: Array) -> Array:
    return ((k[3] * y + k[2]) * y + k[1]) * y + k[0]


def _derivative(k: tuple[Array, ...], y: Array) -> Array:
    return (3 * k[3] * y + 2 * k[2]) * y + k[1]


def _cuts(k: tuple[Array, ...]) -> list[Array]:
    """0, the extrema and the inflection inside (0, 2), and 2, rising."""
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(k[2] ** 2 - 3 * k[3] * k[1])
        q = -(k[2] + np.where(k[2] < 0, -root, root))
        inner = np.stack([q / (3 * k[3]), k[1] / q, -k[2] / (3 * k[3])])
    inner = np.sort(np.where((inner > 0) & (inner < 2), inner, 0.0), axis=0)
    return [np.zeros_like(inner[0]), *inner, np.full_like(inner[0], 2.0)]


def _half(
    k: tuple[Array, ...], at_two: Array
) -> list[tuple[Array, NDArray[np.bool_], NDArray[np.bool_]]]:
    """Roots in (0, 2) with whether the cubic rises there and whether there is one."""
    cuts = _cuts(k)
    values = [k[0], *(_value(k, cut) for cut in cuts[1:-1]), at_two]
    found = []
    for low, high, below, above in zip(cuts, cuts[1:], values, values[1:], strict=False):
        there = (below < 0) != (above < 0)
        there &= high > low
        if not np.any(there):
            continue
        rises = below < above
        convex = 6 * k[3] * (low + high) / 2 + 2 * k[2] > 0
        falls = rises == convex
        y = np.where(falls, high, low)  # from here Newton never overshoots
        y = np.where(there, y, 1.0)
        for _ in range(_STEPS):
            slope = _derivative(k, y)
            step = np.where(there & (slope != 0), _value(k, y), 0.0) / np.where(
                slope == 0, 1.0, slope
            )
            new = np.clip(y - step, np.where(there, low, 1.0), np.where(there, high, 1.0))
            moved = np.where(falls, new < y, new > y)  # a step back is rounding
            y = np.where(moved, new, y)
            if not np.any(moved):
                break
        found.append((y, rises, there))
    return found


def roots(
    near: tuple[Array, ...], far: tuple[Array, ...]
) -> list[tuple[Array, Array, NDArray[np.bool_], NDArray[np.bool_]]]:
    """y, 4 - y, whether the cubic rises with y, and whether there is a root at all.

    ``near`` are the coefficients in y, ``far`` those of the same cubic in 4 - y, constant term
    first; the end where a root lies gives it its digits.
    """
    middle = _value(near, np.full_like(near[0], 2.0))
    found = [(y, 4 - y, rises, there) for y, rises, there in _half(near, middle)]
    found += [(4 - y, y, ~rises, there) for y, rises, there in _half(far, middle)]
    return found

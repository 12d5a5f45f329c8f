"""How many roots of a loop are not inside the unit circle; its cost does not grow with the delay.

On the circle z^M A outweighs the wall's part W = K X + B Y + E, or W outweighs it.  Where they
change places, |A| = |W|, is a polynomial equation in x = 2 - 2 cos(theta) whose degree does not
depend on M.  Between such angles the sum turns as the larger one does, but for a principal value
at both ends.  A and W themselves cross the real axis at the roots of polynomials in x, and between
these their turns are principal values.
"""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops.circle import (
    Array,
    Complex,
    beside,
    imaginary,
    point,
    real_roots,
    roots,
    squared,
    value,
)
from symhaptic.loops.loop import Loop
from symhaptic.numeric.compiled import kernels_used

if TYPE_CHECKING:
    from symhaptic.loops import _count
else:
    _count = None
    if kernels_used() == "compiled":
        with suppress(ImportError):  # each extension is optional of its own
            from symhaptic.loops import _count


def roots_inside(loop: Loop, K: Array, B: Array) -> tuple[Array, Array]:
    """Half turns of p along the upper circle, which are its roots inside, and how near 0 p comes.

    Not a whole number if a root lies on the circle.  The nearness is |p| over the larger of its
    two parts, at the angles where they are equal.
    """
    K, B, whole = np.broadcast_arrays(K, B, loop.M)
    W = loop.wall(K, B)
    if _count is not None and not loop.in_z and max(W.shape[-1], loop.A.shape[-1]) <= _MOST:
        return _compiled(loop, W, K.shape)
    A = np.broadcast_to(loop.A, (*K.shape, loop.A.shape[-1]))
    theta = _arcs(A, W, loop.in_z)
    device, wall = _both(A, W, theta, loop.in_z)
    late = np.exp(1j * whole[..., None] * theta) * device
    leads = np.abs(device[..., 1::2]) >= np.abs(wall[..., 1::2])  # in the middle of each arc
    with np.errstate(divide="ignore", invalid="ignore"):
        after_device, after_wall = np.angle(1 + wall / late), np.angle(1 + late / wall)
        larger = np.maximum(np.abs(late), np.abs(wall))
        near = np.where(larger > 0, np.abs(late + wall) / larger, 0.0)
        turns = [np.angle(each[..., 1:] / each[..., :-1]) for each in (device, wall)]
    of_device, of_wall = (np.nan_to_num(t[..., ::2] + t[..., 1::2]) for t in turns)
    ends = theta[..., ::2]
    turned = np.where(
        leads,
        of_device + whole[..., None] * np.diff(ends) + _difference(after_device[..., ::2]),
        of_wall + _difference(after_wall[..., ::2]),
    )
    return turned.sum(axis=-1) / np.pi, near.min(axis=-1)


_MOST = 17
"""Coefficients for which the compiled loop has room."""


def _compiled(loop: Loop, W: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """The same, compiled."""
    inside, near = np.empty(shape), np.empty(shape)
    A, M = loop.A, np.asarray(loop.M, dtype=float)
    if M.size > 1 or A.ndim > 1:
        A, M = np.broadcast_to(A, (*shape, A.shape[-1])), np.broadcast_to(M, shape)
    rows = (np.ascontiguousarray(each, dtype=float) for each in (A, W, M))
    A, W, M = rows
    assert _count is not None
    _count.roots_inside(A, A.shape[-1], W, W.shape[-1], M, inside, near)
    return inside, near


def _difference(angles: Array) -> Array:
    return np.diff(np.nan_to_num(angles))


def unstable_roots(loop: Loop, K: Array, B: Array) -> Array:
    """The number of roots outside the unit circle, for walls and loops that broadcast.

    NaN for a loop on the boundary.
    """
    inside, near = roots_inside(loop, K, B)
    return np.where(near > _ON, loop.degree - np.rint(inside), np.nan)


_WHOLE = 0.1
"""Turns are told to much better than this; those of a loop with a root on the circle are halves."""

_ON = 1e-13
"""A loop with a smaller |p| beside its parts counts as on the boundary."""


def is_stable(loop: Loop, K: Array, B: Array) -> NDArray[np.bool_]:
    """Whether all roots lie inside the unit circle; not stable where that cannot be told."""
    inside, near = roots_inside(loop, K, B)
    return (inside > loop.degree - _WHOLE) & (near > _ON)


def _both(A: Array, W: Array, theta: Array, in_z: bool) -> tuple[Complex, Complex]:
    """A and W at angles on an axis of their own behind those of the walls."""
    return (
        value(A[..., None, :], point(theta, False)),
        value(W[..., None, :], point(theta, in_z)),
    )


def _arcs(A: Array, W: Array, in_z: bool) -> Array:
    """Ends and middles in turn of arcs on which one part outweighs the other.

    On none of them does A or W change the half plane in which it lies.
    """
    ends = _many_ends(A, W) if in_z else _ends(A, W)
    zero = np.zeros((*W.shape[:-1], 1))
    ends = np.concatenate([zero, np.sort(ends, axis=-1), zero + np.pi], axis=-1)
    theta = np.empty((*zero.shape[:-1], 2 * ends.shape[-1] - 1))
    theta[..., ::2], theta[..., 1::2] = ends, (ends[..., 1:] + ends[..., :-1]) / 2
    return theta


def _ends(A: Array, W: Array) -> Array:
    sides = _balance(A, W), imaginary(A), imaginary(W)
    return _angle(np.concatenate([real_roots(each) for each in sides], axis=-1))


def equal(A: Array, W: Array, in_z: bool) -> Array:
    """Angles at which |A| = |W|, in ascending order; NaN for those that are not there."""
    if in_z:
        _, angles, there = _many(A, W)
        return np.where(there, angles, np.nan)
    x = real_roots(_balance(A, W))
    return np.where((x > 0) & (x < 4), _angle(x), np.nan)


def _balance(A: Array, W: Array) -> Array:
    """|A|^2 - |W|^2 as a polynomial in x."""
    size = max(A.shape[-1], W.shape[-1])
    A, W = (np.pad(q, [(0, 0)] * (q.ndim - 1) + [(0, size - q.shape[-1])]) for q in (A, W))
    return squared(A) - squared(W)


def _angle(x: Array) -> Array:
    return np.asarray(2 * np.arctan2(np.sqrt(x), np.sqrt(4 - x)))


def _many_ends(A: Array, W: Array) -> Array:
    """The same for a W of many powers of z."""
    grid, angles, _ = _many(A, W)
    return np.concatenate([grid, angles], axis=-1)


def _many(A: Array, W: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
    """A grid that sees each root, where |A| = |W|, and which of these are there.

    A and W turn where a root is near the circle, on the scale of its distance.
    """
    size = W.shape[-1]
    grid = np.concatenate([np.geomspace(1e-6, 0.1, 60), np.linspace(0, np.pi, 8 * size)])
    near = [beside(roots(A) + 1, _AROUND), beside(roots(W), _AROUND), grid]
    rows = (np.broadcast_to(each, (*W.shape[:-1], each.shape[-1])) for each in near)
    theta = np.sort(np.clip(np.concatenate(list(rows), axis=-1), 0.0, np.pi), axis=-1)
    device, wall = _both(A, W, theta, True)
    sign = np.abs(device) >= np.abs(wall)
    changes = sign[..., 1:] != sign[..., :-1]
    most = max(1, int(changes.sum(axis=-1).max(initial=0)))
    first = np.sort(np.argsort(~changes, axis=-1, kind="stable")[..., :most], axis=-1)
    low, high = (np.take_along_axis(theta, first + k, axis=-1) for k in (0, 1))
    before = np.take_along_axis(sign, first, axis=-1)
    for _ in range(60):
        middle = (low + high) / 2
        device, wall = _both(A, W, middle, True)
        same = (np.abs(device) >= np.abs(wall)) == before
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return theta, high, np.take_along_axis(changes, first, axis=-1)


_AROUND = np.array([-9.0, -3.0, -1.0, -0.3, 0.0, 0.3, 1.0, 3.0, 9.0])
"""In units of the distance of a root from the circle, where it is looked at."""


def crossing(loop: Loop, theta: Array) -> tuple[Complex, Complex, Complex, Complex]:
    """z^M A, X, Y and E at angles that broadcast with the loops."""
    A, at = value(loop.A, point(theta, False)), point(theta, loop.in_z)
    X, Y, E = (value(q, at) for q in (loop.X, loop.Y, loop.E))
    return np.exp(1j * loop.M * theta) * A, X, Y, E

"""How many roots of a loop are not inside the unit circle; its cost does not grow with the delay.

On the circle z^M A outweighs the wall's part W = K X + B Y + E, or W outweighs it.  Where they
change places, |A| = |W|, is a polynomial equation in x = 2 - 2 cos(theta) whose degree does not
depend on M.  Between such angles the sum turns as the larger one does, but for a principal value
at both ends.  A and W themselves cross the real axis at the roots of polynomials in x, and between
these their turns are principal values.
"""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any

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
    terms,
    value,
    zeros,
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
    two parts, at the angles where they are equal; or over a 16th of the sum of the sizes of all
    their terms, which are rounded, where that is more.
    """
    K, B, whole = np.broadcast_arrays(K, B, loop.M)
    W = loop.wall(K, B)
    A = loop.device(K, B)
    if _count is not None and not loop.in_z and max(W.shape[-1], A.shape[-1]) <= _MOST:
        inside, near = _compiled(A, loop.M, W, K.shape)
    else:
        inside, near = _halved(A, loop.in_z, W, whole)
    if loop.doubtful.size:
        A, W = (np.broadcast_to(q, (*K.shape, q.shape[-1])) for q in (A, W))
        device, wall = _both(A, W, loop.doubtful, loop.in_z)
        late = np.exp(1j * whole[..., None] * loop.doubtful) * device
        apart = _nearest(late, wall, _rounded(A, W, loop.doubtful, loop.in_z))
        near = np.minimum(near, apart)
    return inside, near


def _halved(A: Array, in_z: bool, W: Array, whole: Array) -> tuple[Array, Array]:
    """The same in arrays, up to what is doubtful."""
    shape, rows = whole.shape, whole.size
    W = W.reshape(rows, W.shape[-1])
    A = np.broadcast_to(A, (*shape, A.shape[-1])).reshape(rows, A.shape[-1])
    delays, ends = whole.reshape(rows, 1), _ends(A, W, in_z)
    inside, near, left = np.empty(rows), np.empty(rows), np.arange(rows)
    for deep in range(_DEEPEST + 1):
        inside[left], near[left], middles = _turned(A, W, delays, ends, in_z)
        # where p is lost in rounding, halving does not help: the nearness says so
        again = np.isfinite(middles).any(axis=-1) & (near[left] > _ON)
        if not again.any() or deep == _DEEPEST:
            break
        A, W, delays, left = A[again], W[again], delays[again], left[again]
        added = np.sort(middles[again], axis=-1)
        added = added[:, : np.isfinite(added).sum(axis=-1).max()]
        ends = np.concatenate([ends[again], np.where(np.isfinite(added), added, np.pi)], axis=-1)
        ends.sort(axis=-1)
    return inside.reshape(shape), near.reshape(shape)


def _rounded(A: Array, W: Array, theta: Array, in_z: bool) -> Array:
    """The sum of the sizes of all terms at angles; each of them is rounded."""
    return terms(A, theta, False) + terms(W, theta, in_z)


def _nearest(late: Complex, wall: Complex, rounded: Array) -> Array:
    larger = np.maximum(np.maximum(np.abs(late), np.abs(wall)), rounded / _TERMS)
    with np.errstate(all="ignore"):
        apart = np.where(larger > 0, np.abs(late + wall) / larger, 0.0)
    return np.asarray(apart.min(axis=-1))


_TERMS = 16
"""Of 1e-13 a 16th of all terms is 28 roundings of them."""


def _turned(
    A: Array, W: Array, whole: Array, ends: Array, in_z: bool
) -> tuple[Array, Array, Array]:
    """Half turns, nearness, and the middles of arcs that have to be halved; NaN for the others.

    An arc fits if on all of it one part outweighs the other, and no part changes its half plane or
    turns by more than a right angle between its ends and its middle.
    """
    theta = np.empty((len(ends), 2 * ends.shape[-1] - 1))
    theta[:, ::2], theta[:, 1::2] = ends, (ends[:, 1:] + ends[:, :-1]) / 2
    device, wall = _both(A, W, theta, in_z)
    late = np.exp(1j * whole * ends) * device[:, ::2]
    its = wall[:, ::2]
    leads = np.abs(device[:, 1::2]) >= np.abs(wall[:, 1::2])
    sizes = np.abs(late) ** 2, np.abs(its) ** 2
    larger = np.maximum(*sizes)
    with np.errstate(all="ignore"):
        apart = np.where(larger > 0, np.abs(late + its) ** 2 / larger, 0.0)
        after_device, after_wall = np.angle(1 + its / late), np.angle(1 + late / its)
        turns = [np.angle(each[:, 1:] / each[:, :-1]) for each in (device, wall)]
        slack = 1 + 1e-14 + 1e-9 * apart
        most, least = (sizes[0] <= sizes[1] * slack), (sizes[1] <= sizes[0] * slack)
    fits = np.where(leads, least[:, 1:] & least[:, :-1], most[:, 1:] & most[:, :-1])
    for each, turn in zip((device, wall), turns, strict=True):
        side = np.where(np.abs(each.imag) < 1e-10 * np.abs(each), 0.0, np.sign(each.imag))
        known = (side[:, 1:] * side[:, :-1] >= 0) | (np.abs(turn) < np.pi / 2)
        fits &= known[:, ::2] & known[:, 1::2]
    of_device, of_wall = (np.nan_to_num(t[:, ::2] + t[:, 1::2]) for t in turns)
    turned = np.where(
        leads,
        of_device + whole * np.diff(ends) + _difference(after_device),
        of_wall + _difference(after_wall),
    )
    middles = np.where(fits, np.nan, theta[:, 1::2])
    return turned.sum(axis=-1) / np.pi, _nearest(late, its, _rounded(A, W, ends, in_z)), middles


_DEEPEST = 50
"""Halvings of an arc: below, its ends are next to each other."""

_MOST = 17
"""Coefficients for which the compiled loop has room."""


def _compiled(A: Array, M: NDArray[Any], W: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """The same, compiled."""
    inside, near = np.empty(shape), np.empty(shape)
    M = np.asarray(M, dtype=float)
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


def _ends(A: Array, W: Array, in_z: bool) -> Array:
    """Ends of arcs on which one part outweighs the other, and no part changes its half plane.

    Where their polynomials lose digits, some of the ends are missing.
    """
    zero = np.zeros((len(W), 1))
    found = _many_ends(A, W) if in_z else _few_ends(A, W)
    return np.concatenate([zero, np.sort(found, axis=-1), zero + np.pi], axis=-1)


def _few_ends(A: Array, W: Array) -> Array:
    sides = _balance(A, W), imaginary(A), imaginary(W)
    return _angle(np.concatenate([real_roots(each)[0] for each in sides], axis=-1))


def equal(A: Array, W: Array, in_z: bool) -> Array:
    """Angles at which |A| = |W|, in ascending order; NaN for those that are not there."""
    if in_z:
        _, angles, there = _many(A, W)
    else:
        x, there = real_roots(_balance(A, W))
        angles, there = _angle(x), there & (x > 0) & (x < 4)
    return np.sort(np.where(there, angles, np.nan), axis=-1)


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
    theta = np.sort(np.concatenate([theta, _touching(A, W, theta)], axis=-1), axis=-1)
    sign = _lead(A, W, theta) >= 0
    changes = sign[..., 1:] != sign[..., :-1]
    most = max(1, int(changes.sum(axis=-1).max(initial=0)))
    first = np.sort(np.argsort(~changes, axis=-1, kind="stable")[..., :most], axis=-1)
    low, high = (np.take_along_axis(theta, first + k, axis=-1) for k in (0, 1))
    return (
        theta,
        zeros(lambda at: _lead(A, W, at), low, high),
        np.take_along_axis(changes, first, axis=-1),
    )


def _lead(A: Array, W: Array, theta: Array) -> Array:
    """log |A/W| at angles, 0 where both vanish."""
    device, wall = _both(A, W, theta, True)
    with np.errstate(divide="ignore", invalid="ignore"):
        lead = np.log(np.abs(device)) - np.log(np.abs(wall))
    return np.where(np.isnan(lead), 0.0, lead)


def _touching(A: Array, W: Array, theta: Array) -> Array:
    """Angles next to which |A| and |W| are nearest to each other, though not equal on a grid.

    There two angles of |A| = |W| may lie between neighbours of the grid.
    """
    lead = _lead(A, W, theta)
    apart, sign = np.abs(lead), np.sign(lead)
    with np.errstate(invalid="ignore"):
        least = (apart[..., 1:-1] <= apart[..., 2:]) & (apart[..., 1:-1] <= apart[..., :-2])
    least &= (sign[..., 1:-1] == sign[..., 2:]) & (sign[..., 1:-1] == sign[..., :-2])
    least &= apart[..., 1:-1] < _NEARLY
    most = int(least.sum(axis=-1).max(initial=0))
    first = np.sort(np.argsort(~least, axis=-1, kind="stable")[..., :most], axis=-1)
    low, high = (np.take_along_axis(theta, first + k, axis=-1) for k in (0, 2))
    before = np.take_along_axis(sign, first + 1, axis=-1)
    for _ in range(40):
        one, two = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
        left = before * _lead(A, W, one) < before * _lead(A, W, two)
        low, high = np.where(left, low, one), np.where(left, two, high)
    return np.asarray((low + high) / 2)


_NEARLY = 0.1
"""Of log |A/W|: on the grid it changes by less between neighbours next to an extremum."""

_GOLDEN = (np.sqrt(5) - 1) / 2

_AROUND = np.array([-9.0, -3.0, -1.0, -0.3, 0.0, 0.3, 1.0, 3.0, 9.0])
"""In units of the distance of a root from the circle, where it is looked at."""


def crossing(loop: Loop, theta: Array) -> tuple[Complex, Complex, Complex, Complex]:
    """z^M A, all that K, B and 1 are the factors of, at angles that broadcast with the loops."""
    A, at = value(loop.A, point(theta, False)), point(theta, loop.in_z)
    X, Y, E = (value(q, at) for q in (loop.X, loop.Y, loop.E))
    late = np.exp(1j * loop.M * theta)
    if loop.ahead:
        X, Y = (q + late * value(own, at) for q, own in zip((X, Y), loop.ahead, strict=True))
    return late * A, X, Y, E

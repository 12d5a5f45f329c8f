"""Polynomials with real coefficients on the unit circle: values, squares, angles, roots."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize.elementwise import find_root

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def point(theta: Array, in_z: bool) -> Complex:
    """z = exp(j theta), or w = z - 1 without the difference: 2 j sin(theta/2) exp(j theta/2)."""
    if in_z:
        return np.asarray(np.exp(1j * theta))
    half = np.sin(theta / 2)
    return -2 * half * half + 1j * np.sin(theta)


def value(coefficients: Array, at: Complex) -> Complex:
    """By Horner's rule; the axes before the last of the coefficients broadcast with ``at``."""
    found = np.zeros(np.broadcast_shapes(coefficients.shape[:-1], at.shape), dtype=complex)
    for n in range(coefficients.shape[-1] - 1, -1, -1):
        found = found * at + coefficients[..., n]
    return found


def terms(coefficients: Array, theta: Array, in_z: bool) -> Array:
    """The sum of the sizes of a polynomial's terms at angles on an axis of their own."""
    size = np.ones_like(theta) if in_z else 2 * np.abs(np.sin(theta / 2))
    sizes = np.abs(coefficients)
    return real_value(sizes, np.broadcast_to(size, (*sizes.shape[:-1], size.shape[-1])))


def squared(coefficients: Array) -> Array:
    """|q|^2 on the circle as a polynomial in x = |w|^2 = 2 - 2 cos(theta), of a q in w.

    w^i times the conjugate of w^j and its mirror add to x^i s_(j-i), where s_k = w^k + its
    conjugate obeys s_(k+1) = -x (s_k + s_(k-1)), s_0 = 2, s_1 = -x.
    """
    size = coefficients.shape[-1]
    sums = np.zeros((size + 1, size + 1))
    sums[0, 0], sums[1, 1:2] = 2.0, -1.0
    for k in range(1, size):
        sums[k + 1, 1:] = -(sums[k, :-1] + sums[k - 1, :-1])
    found = np.zeros(coefficients.shape)
    for i in range(size):
        found[..., i] += coefficients[..., i] ** 2
        for j in range(i + 1, size):
            both = (coefficients[..., i] * coefficients[..., j])[..., None]
            found[..., i : j + 1] += both * sums[j - i, : j - i + 1]
    return found


def imaginary(coefficients: Array) -> Array:
    """Im q/sin(theta) on the circle as a polynomial in x, of a q in w.

    Im w^k = sin(theta) u_k with u_(k+1) = -x (u_k + u_(k-1)), u_0 = 0, u_1 = 1.
    """
    size = coefficients.shape[-1]
    parts = np.zeros((size + 1, size + 1))
    parts[1, 0] = 1.0
    for k in range(1, size):
        parts[k + 1, 1:] = -(parts[k, :-1] + parts[k - 1, :-1])
    return coefficients @ parts[:size, : max(size - 1, 1)]


def roots(coefficients: Array) -> Complex:
    """About where the roots are; eigenvalues of the companion matrix, by LAPACK."""
    n = coefficients.shape[-1] - 1
    largest = np.abs(coefficients).max(axis=-1, keepdims=True)
    lead = coefficients[..., -1:]
    lead = np.where(np.abs(lead) > 1e-12 * largest, lead, 1e-12 * largest)
    matrix = np.zeros((*coefficients.shape[:-1], n, n))
    matrix[..., np.arange(1, n), np.arange(n - 1)] = 1.0
    matrix[..., -1] = -coefficients[..., :-1] / np.where(lead == 0, 1.0, lead)
    return np.asarray(np.linalg.eigvals(matrix), dtype=complex)


def beside(z: Complex, multiples: Array) -> Array:
    """Angles next to roots: where they are nearest to the circle, and multiples of their distance.

    On that scale a quotient bends of which they are zeros or poles.
    """
    angle, apart = np.abs(np.angle(z)), np.abs(np.abs(z) - 1)
    found = angle[..., None] + apart[..., None] * multiples
    return np.asarray(found.reshape(*z.shape[:-1], z.shape[-1] * len(multiples)))


def grid(uniform: Array, first: float, *polynomials: Array) -> Array:
    """Angles from ``first`` on that see each bend of quotients of polynomials in w."""
    near = [beside(roots(q) + 1, _FINE) for q in polynomials if q.shape[-1] > 1]
    found = np.concatenate([uniform, *near])
    found = found[np.isfinite(found) & (found > first) & (found <= uniform[-1])]
    return np.unique(np.concatenate([np.geomspace(first, min(1.0, uniform[-1]), 400), found]))


_FINE = np.concatenate([-np.geomspace(1e3, 0.02, 80), [0.0], np.geomspace(0.02, 1e3, 80)])


def real_roots(coefficients: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Where polynomials change their signs for 0 < x < 4, in ascending order, and whether they do.

    Between neighbouring roots of the derivative, found first in the same way, a polynomial rises
    or falls, and Newton's steps are kept inside of brackets.  Where the sign does not change, the
    place is the right one of these neighbours, next to which it may nearly do so, or 4.
    """
    chain = [coefficients]
    while chain[-1].shape[-1] > 1:
        chain.append(chain[-1][..., 1:] * np.arange(1, chain[-1].shape[-1]))
    shape = coefficients.shape[:-1]
    found = np.zeros((*shape, 0))
    changes = np.zeros((*shape, 0), dtype=bool)
    for slope, each in zip(chain[:0:-1], chain[-2::-1], strict=True):
        ends = np.concatenate([np.zeros((*shape, 1)), found, np.full((*shape, 1), 4.0)], axis=-1)
        found, changes = _between(each, slope, ends)
    return found, changes


def real_value(coefficients: Array, x: Array) -> Array:
    """By Horner's rule, the polynomials in front and their places on the last axis."""
    found = np.broadcast_to(coefficients[..., -1:], x.shape).copy()
    for n in range(coefficients.shape[-1] - 2, -1, -1):
        found *= x
        found += coefficients[..., n, None]
    return found


def _between(each: Array, slope: Array, ends: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The root between neighbouring ends where the signs there differ, else the right end."""
    negative = real_value(each, ends) < 0
    changes = negative[..., 1:] != negative[..., :-1]
    found = ends[..., 1:].copy()
    if not changes.any():
        return found, changes
    rows = np.nonzero(changes)[:-1]
    low, high = ends[..., :-1][changes], ends[..., 1:][changes]
    before = negative[..., :-1][changes]
    f, df = each[rows], slope[rows]
    x = _middle(low, high)
    for _ in range(80):
        here, rise = real_value(f, x[:, None])[:, 0], real_value(df, x[:, None])[:, 0]
        left = (here < 0) == before
        low, high = np.where(left, x, low), np.where(left, high, x)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = x - here / rise
        step = np.where((step > low) & (step < high), step, _middle(low, high))
        done = np.abs(step - x) <= 4e-16 * np.abs(x)
        x = np.where(here == 0, x, step)
        if (done | (here == 0)).all():
            break
    found[changes] = x
    return found, changes


def zeros(function: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """Where functions of one place each change their signs between two, by Chandrupatla's rule."""
    if not low.size:
        return low
    at = low.copy()

    def some(place: Array, which: NDArray[np.intp]) -> Array:
        at.flat[which] = place
        return np.asarray(function(at).flat[which])

    which = np.arange(low.size).reshape(low.shape)
    with np.errstate(invalid="ignore"):
        found = find_root(some, (low, high), args=(which,))
    return np.where(found.success, found.x, high)  # places that only fill an array stay


def _middle(low: Array, high: Array) -> Array:
    """Half way in size where the ends differ in size, so that small roots are found as fast."""
    far = high > 4 * low
    return np.where(far, np.sqrt(np.maximum(low, 1e-20) * high), (low + high) / 2)

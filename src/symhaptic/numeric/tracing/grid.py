"""The paper's own method: a grid of walls, all zeros of each polynomial, and bisection.

Kept to compare with: it needs no formula for the boundary, and its cost per point grows with the
cube of the delay and with the digits asked for.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.containers import numbers_only
from symhaptic.numeric.plant import discretize

_ENTRIES = 4_000_000
"""Numbers in the companion matrices that are solved at a time: 32 MB."""

_DEGREE = 2000
"""The largest degree for which a companion matrix is made."""


def spectral_radius(
    alpha: ArrayLike, beta: ArrayLike, gamma: float, delta: float, delay: float | Fraction
) -> Array:
    """Largest modulus of the zeros of the characteristic polynomial, by companion eigenvalues.

    For a rational delay r/q the polynomial in z^(1/q), all of whose zeros count: the paper's
    substitution taken literally.  Its degree r + 3 q is at most 2000.  NaN gives NaN.

    Raises :class:`ValueError` for an infinite wall and an impossible plant or delay.

    >>> float(spectral_radius(0.5, 1.0, 0.0, 0.0, 0)) < 1
    True
    """
    al, be = np.broadcast_arrays(arguments.finite("alpha", alpha), arguments.finite("beta", beta))
    late = _rational(delay)
    q, degree = late.denominator, late.numerator + 3 * late.denominator
    g = arguments.single("gamma", arguments.checked("gamma", gamma))
    dl = arguments.single("delta", arguments.checked("delta", delta))
    n1, n0, a, e = (float(v) for v in discretize(g, dl))
    rows = np.zeros((al.size, degree + 1))
    rows[:, [0, q, 2 * q]] = 1.0, -a, e
    total, wall = (al + be).ravel(), -be.ravel()
    rows[:, degree - 2 * q] += n1 * total
    rows[:, degree - q] += n1 * wall + n0 * total
    rows[:, degree] += n0 * wall
    found = np.full(al.size, np.nan)
    known = np.flatnonzero(np.isfinite(rows).all(axis=1))
    at_once = max(_ENTRIES // degree**2, 1)
    for begin in range(0, known.size, at_once):
        some = known[begin : begin + at_once]
        companion = np.zeros((some.size, degree, degree))
        companion[:, 0, :] = -rows[some, 1:]
        companion[:, np.arange(1, degree), np.arange(degree - 1)] = 1.0
        found[some] = np.abs(np.linalg.eigvals(companion)).max(axis=1)
    return found.reshape(al.shape)


def _rational(delay: float | Fraction) -> Fraction:
    """The delay as a fraction that leaves a polynomial of reasonable degree."""
    allowed = f"rational numbers r/q >= 0 with r + 3 q <= {_DEGREE}"
    number = arguments.checked("delay", delay)
    arguments.refuse("delay", number, np.isnan(number), allowed)
    one = arguments.single("delay", number)
    late = Fraction(delay) if isinstance(delay, int | Fraction) else Fraction(one)
    if late.numerator + 3 * late.denominator > _DEGREE:
        raise ValueError(f"delay: {delay} is not allowed; give {allowed}")
    return late


@numbers_only
def grid_boundary(
    gamma: float,
    delta: float,
    delay: float | Fraction,
    alphas: ArrayLike,
    betas: ArrayLike,
    threshold: float = 1e-8,
) -> Array:
    """Points of the stability boundary by the grid search of Sec. IV-D of the paper.

    Parameters
    ----------
    gamma, delta : float
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : float or Fraction
        Delay in sampling periods, >= 0.
    alphas, betas : array_like of shape (n,) and (m,)
        Lines of the grid: values of K T^2/m and of B T/m, increasing.
    threshold : float, optional
        Distance along a grid line within which a point is found.

    Returns
    -------
    ndarray of shape (points, 2)
        Pairs (alpha, beta), to within ``threshold`` along a grid line.

    Raises
    ------
    ValueError
        If an argument is out of its range.

    See Also
    --------
    stable_region : The region with an outline to full precision, without a grid.

    Notes
    -----
    The stability is computed at every node of the grid.  If two neighbours differ, the interval
    between them is halved until it is shorter than the threshold.

    Examples
    --------
    >>> points = grid_boundary(0.0, 0.0, 0, np.linspace(-0.1, 1, 23), np.linspace(-0.1, 2.1, 23))
    >>> points.shape[1]
    2
    """
    al, be = arguments.finite("alphas", alphas), arguments.finite("betas", betas)
    for name, values in (("alphas", al), ("betas", be)):
        arguments.refuse(name, values, np.isnan(values), "finite numbers")
    threshold = arguments.one("threshold", threshold)
    if not threshold > 0:
        raise ValueError(f"threshold: {threshold!r} is not allowed; give numbers > 0")

    def stable(points: Array) -> NDArray[np.bool_]:
        radius = spectral_radius(points[..., 0], points[..., 1], gamma, delta, delay)
        return np.asarray(radius < 1)

    nodes = np.stack(np.meshgrid(al, be, indexing="ij"), axis=-1)
    inside = stable(nodes)
    pairs = []
    for axis in (0, 1):
        first, second = np.arange(nodes.shape[axis] - 1), np.arange(1, nodes.shape[axis])
        one, two = inside.take(first, axis), inside.take(second, axis)
        at = one != two
        low, high = nodes.take(first, axis)[at], nodes.take(second, axis)[at]
        swap = ~one[at][:, None]
        pairs.append((np.where(swap, high, low), np.where(swap, low, high)))
    good = np.concatenate([p[0] for p in pairs])
    bad = np.concatenate([p[1] for p in pairs])
    while good.size and np.abs(good - bad).max() > threshold:
        middle = (good + bad) / 2
        if np.all((middle == good) | (middle == bad)):
            break
        keeps = stable(middle)[:, None]
        good, bad = np.where(keeps, middle, good), np.where(keeps, bad, middle)
    return np.asarray((good + bad) / 2)

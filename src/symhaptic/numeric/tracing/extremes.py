"""The largest stable stiffness, and the largest delay that a wall bears."""

from __future__ import annotations

import math
import warnings
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import haptic
from symhaptic.numeric import arguments, slopes, stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.boundary import end, point, tangent
from symhaptic.numeric.compiled import MODULE, at_once, finite, of
from symhaptic.numeric.containers import kept
from symhaptic.numeric.crossings import wall
from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.given import Given
from symhaptic.numeric.plant import Device, device, stuck
from symhaptic.numeric.tracing.arcs import Loop
from symhaptic.numeric.tracing.region import NotTraced, farthest

_GRID = np.linspace(0, 1, 25)[1:]
"""Parts of the first half turn of z^(d+1) at which the first maximum of alpha is looked for."""

_LAST = np.pi * (1 - 1e-4)
"""Next to theta = pi, where alpha has its limit for d = 0 with no slope: what a maximum beyond
adds to the limit is of fourth order."""

_STIFFEST = 9.8
"""Up to this gamma, just below pi^2, the first maximum is trusted to be the largest."""


_FARTHEST = 1e60
"""Where no force reaches the device, the boundary is at infinity."""


_TRIED = np.geomspace(1e-16, 10.0, 100) * np.array([[-1.0], [1.0]])
"""Stiffnesses that are tried where none is found, in parts of gamma or 1."""


@at_once("max_stable_stiffness", into=Extremum, sure=finite)
@kept(Extremum, alpha=float, beta=float, theta=float)
@slopes.in_jax(
    Extremum._fields, instead="lambdify('max_stable_stiffness', modules='jax') has derivatives"
)
def max_stable_stiffness(
    gamma: ArrayLike, delta: ArrayLike, delay: ArrayLike, sheet: str = "exact"
) -> Extremum:
    """Largest stable stiffness, with its virtual damping and the angle of its roots.

    Parameters
    ----------
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).

    Returns
    -------
    Extremum
        ``alpha`` = K T^2/m, ``beta`` = B T/m and ``theta`` = omega T, of the shape to which the
        arguments broadcast.  The limit is a supremum: the wall there has roots on the unit circle,
        at exp(+-j theta).  A loop that no wall makes stable gives NaN, and so does NaN.

    Raises
    ------
    ValueError
        If ``gamma``, ``delta`` or ``delay`` is negative or too large, or if pieces of the boundary
        of a single loop are missed, see :func:`symhaptic.stable_region`.

    Warns
    -----
    RuntimeWarning
        If pieces of the boundary are missed for loops of an array.  It names the first one; their
        results are NaN.

    See Also
    --------
    limit_at : The largest stable stiffness for a given damping.
    max_passive_stiffness : The largest passive stiffness.

    Notes
    -----
    If gamma <= 9.8 and either d <= 1 or sqrt(gamma) (d+1) <= pi, the result is the first maximum of
    the explicit boundary (without a maximum, the end of the curve at theta = pi), and the time does
    not depend on the delay.  That no other piece reaches farther is tested by comparison with whole
    regions, not proved.  Otherwise every piece of the boundary is traced, one element after the
    other, which takes milliseconds times the delay; the delay is then at most 100 000 periods.

    Examples
    --------
    >>> alpha, beta, theta = max_stable_stiffness(0.0, 0.0, [0, 1])
    >>> alpha.round(6).tolist()
    [0.686292, 0.144469]
    """
    arguments.check_sheet(sheet)
    given = Given(gamma=gamma, delta=delta, delay=delay)
    alone = math.prod(arguments.together(*given.values)) == 1
    work = partial(arguments.in_blocks, partial(_rightmost, sheet=sheet, alone=alone))
    return Extremum(*given.by_numpy(work, 3))


def _rightmost(gamma: Array, delta: Array, delay: Array, sheet: str, alone: bool) -> Array:
    shape = np.broadcast_shapes(gamma.shape, delta.shape, delay.shape)
    g, dl, dy = (np.broadcast_to(a, shape).reshape(-1) for a in (gamma, delta, delay))
    found = np.full((3, g.size), np.nan)
    known = ~np.isnan(g + dl + dy) & ~stuck(g, dl)
    simple = known & (g <= _STIFFEST) & ((np.sqrt(g) * (dy + 1) <= np.pi) | (dy <= 1))
    if np.any(simple):
        first = _by_kernel if sheet == "exact" else _first_maximum
        found[:, simple] = first(g[simple], dl[simple], dy[simple])
    for i in np.flatnonzero(known & np.isnan(found[0])):
        loop = Loop(float(g[i]), float(dl[i]), float(dy[i]), sheet)
        try:
            found[:, i] = farthest(loop, np.array([1.0, 0.0]))
        except NotTraced as missed:
            if alone:
                raise
            warnings.warn(f"{missed}; it is NaN here", RuntimeWarning, stacklevel=2)
    return found.reshape(3, *shape)


def _by_kernel(gamma: Array, delta: Array, delay: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
        return np.stack(of(haptic.max_stable_stiffness)(gamma, delta, delay))


def _first_maximum(gamma: Array, delta: Array, delay: Array) -> Array:
    """The first maximum of alpha along the curve of the principal sheet.

    NaN where it does not border the region.
    """
    steps, x = delay, device(gamma, delta)
    whole = np.pi / (delay + 1)
    low, high = np.full_like(whole, np.nan), np.full_like(whole, np.nan)
    before, rose = np.zeros_like(whole), np.ones_like(whole, dtype=bool)
    for share in _GRID:
        theta = np.minimum(share * whole, _LAST)
        rises = tangent(x, theta, steps)[0] > 0
        first = rose & ~rises & np.isnan(low)
        low, high = np.where(first, before, low), np.where(first, theta, high)
        before, rose = theta, rises
    found = np.full((3, whole.size), np.nan)
    numbers = [np.broadcast_to(v, whole.shape) for v in x]

    def bordering(theta: Array, at: NDArray[np.bool_]) -> Array:
        """alpha, beta and theta, NaN where another root is outside."""
        some, st = Device(*(v[at] for v in numbers)), steps[at]
        alpha, beta = point(some, theta, st)
        others = stability.count(some, wall(alpha, beta), st, on_circle=theta)
        stable = (others == 0) & (alpha > -gamma[at])
        return np.where(stable, [alpha, beta, theta], np.nan)

    inner = ~np.isnan(low)
    if np.any(inner):
        low = np.maximum(low, high * 1e-3)[inner]
        args = (steps[inner], *(v[inner] for v in numbers))
        from scipy.optimize.elementwise import find_root  # takes as long to load as all else

        found[:, inner] = bordering(find_root(_rise, (low, high[inner]), args=args).x, inner)
    last = ~inner & (delay == 0)
    if np.any(last):
        alpha, beta = (v[last] for v in np.broadcast_arrays(*end(x, steps)))
        stable = ~np.isnan(bordering(np.full(alpha.shape, _LAST), last)[0]) & np.isfinite(alpha)
        limit = [alpha, beta, np.full_like(alpha, np.pi)]
        found[:, last] = np.where(stable, limit, np.nan)
    return found


def _rise(theta: Array, steps: Array, *numbers: Array) -> Array:
    return tangent(Device(*numbers), theta, steps)[0]


def stiffest_at(beta: float, gamma: float, delta: float, delay: float) -> Extremum:
    """The largest stiffness of a stable wall with a given damping, and the angle of its roots.

    At one damping the count of unstable roots can change only where the explicit boundary or a
    line of a real root has this damping; between neighbours of these it is told in the middle.
    NaN where no stiffness makes it stable.  Raises :class:`ValueError` where one of those tried
    does and pieces of the boundary are missed.
    """
    if MODULE is not None and (found := MODULE.one_limit_at(beta, gamma, delta, delay)) is not None:
        return Extremum(found[0], np.asarray(beta), found[1])
    nothing = Extremum(*np.array([np.nan, beta, np.nan]))
    if stuck(np.asarray(gamma), np.asarray(delta)):
        return nothing
    loop = Loop(gamma, delta, delay)
    theta = loop.meets(lambda _, damping: damping - beta)
    line = [] if loop.line is None else [loop.line - 2 * beta]
    walls = np.concatenate([loop.curve(theta)[:, 0], [-gamma], line])
    angles = np.concatenate([theta, [0.0], [np.pi] * len(line)])
    near = np.abs(walls) < _FARTHEST
    walls, angles = walls[near], angles[near]
    order = np.argsort(walls)
    walls, angles = walls[order], angles[order]
    middle = (walls[1:] + walls[:-1]) / 2
    good = stability.is_stable(middle, beta, gamma, delta, delay) & (walls[1:] > walls[:-1])
    if not np.any(good):
        if np.any(stability.is_stable(_TRIED * max(gamma, 1.0), beta, gamma, delta, delay)):
            raise NotTraced(loop)
        return nothing
    last = int(np.flatnonzero(good)[-1]) + 1
    return Extremum(walls[last], np.asarray(beta), angles[last])


@at_once("limit_at", sure=finite)
@kept(alpha=float, theta=float)
@slopes.in_jax(("alpha", "theta"))
def limit_at(
    beta: ArrayLike, gamma: ArrayLike, delta: ArrayLike, delay: ArrayLike
) -> tuple[Array, Array]:
    """Largest stable stiffness for a given virtual damping, and the angle of its roots.

    Parameters
    ----------
    beta : array_like
        Virtual damping B T/m, finite.
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.

    Returns
    -------
    alpha, theta : float or ndarray
        The largest alpha = K T^2/m, a supremum, and the angle omega T of its roots on the unit
        circle.  NaN if no stiffness makes the loop stable.

    Raises
    ------
    ValueError
        If ``beta`` is infinite, or ``gamma``, ``delta`` or ``delay`` is negative or too large.

    Warns
    -----
    RuntimeWarning
        If pieces of the boundary are missed; the result is then NaN.

    Notes
    -----
    The limit is found among all crossings of the explicit boundary
    (:func:`symhaptic.stability_boundary`) and of the lines with a real root on the circle.  There
    may also be a lower limit.
    Examples
    --------
    >>> alpha, theta = limit_at([0.0, 0.4, 3.0], 0.0, 0.0, 0)  # 2 beta (2 - beta)/(2 + beta)
    >>> alpha.round(6).tolist()
    [nan, 0.533333, nan]
    """
    given = Given(beta=beta, gamma=gamma, delta=delta, delay=delay)
    work = partial(arguments.in_blocks, _limits_at)
    alpha, theta = given.by_numpy(work, 2)
    return alpha, theta


def _limits_at(*loops: Array) -> Array:
    found = np.full((2, *np.broadcast_shapes(*(a.shape for a in loops))), np.nan)
    for i, (beta, *loop) in enumerate(np.nditer(loops)):
        if not np.isnan(beta + sum(loop)):
            try:
                alpha, _, theta = stiffest_at(float(beta), *map(float, loop))
                found[:, i] = alpha, theta
            except NotTraced as missed:
                warnings.warn(f"{missed}; it is NaN here", RuntimeWarning, stacklevel=2)
    return found


_INSIDE = np.arange(1, 16) / 16
"""Parts of an interval of dampings at which the loop has to be stable."""


def dampings_at(alpha: float, gamma: float, delta: float, delay: float) -> Array:
    """All dampings of stable walls with a given stiffness, as rows of lowest and highest.

    The ends are open.  Between neighbouring dampings at which the explicit boundary or the line of
    a root at -1 has this stiffness, the count of unstable roots does not change.  Raises
    :class:`ValueError` where it does, because pieces of the boundary are missed.
    """
    nothing = np.zeros((0, 2))
    if stuck(np.asarray(gamma), np.asarray(delta)) or alpha <= -gamma:
        return nothing
    loop = Loop(gamma, delta, delay)
    theta = loop.meets(lambda stiffness, _: stiffness - alpha)
    line = [] if loop.line is None else [(loop.line - alpha) / 2]
    ends = np.unique(np.concatenate([loop.curve(theta)[:, 1], line]))
    ends = ends[np.abs(ends) < _FARTHEST]
    low, high = ends[:-1, None], ends[1:, None]
    good = stability.is_stable(alpha, low + (high - low) * _INSIDE, gamma, delta, delay)
    whole = np.all(good, axis=1)
    if np.any(whole != np.any(good, axis=1)) or (
        not np.any(whole) and np.any(stability.is_stable(alpha, _TRIED, gamma, delta, delay))
    ):
        raise NotTraced(loop)
    return np.hstack([low, high])[whole]

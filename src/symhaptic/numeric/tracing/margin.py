"""The largest delay up to which a wall stays stable, and the delay margin.

For whole delays the first loss is known in closed form; between them it is enclosed
by :mod:`symhaptic.numeric.tracing.losses`.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.notation import sizes
from symhaptic.numeric import arguments, slopes
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import MODULE, at_once, told
from symhaptic.numeric.containers import kept
from symhaptic.numeric.crossings import wall
from symhaptic.numeric.given import Given
from symhaptic.numeric.plant import device
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.loops import Loops, leads_at_minus_one, next_changes
from symhaptic.numeric.tracing.losses import first_loss
from symhaptic.numeric.tracing.periods import EXACT, Window, first_periods

_AHEAD = 2**14
"""Whole delays that are looked at together, of all walls."""

_PASSES = 64
"""Looks at more and more whole delays; 20 are enough for walls that lead by a part in 1e10."""

_BLOCK = 8192
"""Walls that are worked on at a time: each has many parts of a period, which take memory."""


@at_once("max_delay", sure=told)
@kept(delay=float)
@slopes.in_jax(("delay",))
def max_delay(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    sheet: str = "exact",
) -> Array:
    """Largest delay, in sampling periods, such that the loop is stable for every smaller one.

    It is the delay at which the first root reaches the unit circle, exact to rounding.  If this
    cannot be decided within a fixed number of steps, it is a lower bound: a delay up to which the
    loop is stable.  A :class:`RuntimeWarning` then names the first of these loops and their number.
    This occurs for loops that are close to instability at every delay, such as a lightly damped
    device with omega_d T near a multiple of pi.

    Parameters
    ----------
    alpha, beta : array_like
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall.
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and damping b T/m >= 0.  All arguments broadcast.
    sheet : {"exact", "principal"}
        "principal" uses the paper's z^-d = exp(-j d theta), in closed form.

    Returns
    -------
    ndarray or float
        Delays in sampling periods.  0 if the loop is not certainly stable without delay,
        infinite if no delay up to 1e15 periods destabilises it, NaN if an argument is NaN.

    Raises
    ------
    ValueError
        For an infinite wall and an impossible plant.

    Warns
    -----
    RuntimeWarning
        If a value is only a lower bound.

    Notes
    -----
    For integer delays the crossings are known in closed form.  Between integers, the angle and the
    fraction of a period satisfy two equations that are transcendental in the fraction.  The period
    is divided into parts.  For each part, the angles at which plant and wall can have equal
    magnitude are enclosed to second order, and so are the phases there.  These bounds exclude roots
    on the circle for many integer delays at once, or show that all roots cross in one direction.
    They are computed in double precision without directed rounding.  At most 4096 parts of a period
    are examined for each loop, so that each call ends.

    See Also
    --------
    delay_margin : Delay that may be added.

    Examples
    --------
    >>> round(float(max_delay(0.01, 0.05, 0.0, 0.0)), 6)
    3.969213
    """
    arguments.check_sheet(sheet)
    given = Given(alpha=alpha, beta=beta, gamma=gamma, delta=delta)
    return given.by_numpy(partial(_largest, sheet))[0]  # type: ignore[no-any-return]


def _largest(sheet: str, *loop: Array) -> list[Array]:
    search: Callable[..., Array] = _principal if sheet == "principal" else _exact
    bounds: list[tuple[float, ...]] = []
    found = arguments.in_blocks(
        lambda *block: [search(*block, bounds)], *loop, block=_BLOCK, told="delay margins"
    )[0]
    if bounds:
        numbers = zip(("alpha", "beta", "gamma", "delta"), bounds[0], strict=True)
        warnings.warn(
            f"max_delay: {', '.join(f'{name}={value!r}' for name, value in numbers)} gives a "
            f"lower bound of the largest delay only ({len(bounds)} of {np.size(found)} values)",
            RuntimeWarning,
            stacklevel=7,
        )
    return [found]


@at_once("delay_margin", sure=told)
@kept(margin=float)
@slopes.in_jax(("margin",))
def delay_margin(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike = 0.0,
    sheet: str = "exact",
) -> Array:
    """Delay that may be added to ``delay`` until the loop is unstable, in sampling periods.

    Parameters
    ----------
    alpha, beta : array_like
        Stiffness and damping of the wall, finite.
    gamma, delta : array_like
        Stiffness and damping of the plant, >= 0.
    delay : array_like, optional
        Delay of the loop in sampling periods, >= 0.  Arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay, as in :func:`max_delay`.

    Returns
    -------
    Array
        The loop is stable for every delay from ``delay`` to ``delay`` plus the margin.  0 if the
        loop is unstable at ``delay``.  Infinite if no delay destabilises it.  NaN if the loop is
        stable at ``delay`` but not at every smaller delay (not computed), or if an argument is
        NaN.

    Raises
    ------
    ValueError
        If the wall is infinite, the plant is impossible or ``delay`` is negative.

    See Also
    --------
    max_delay : Largest delay of a loop that is stable for every smaller one.

    Notes
    -----
    The margin is ``max_delay(alpha, beta, gamma, delta) - delay`` if this is positive.  For
    ``delay = 0`` both functions agree.

    Examples
    --------
    >>> [round(float(x), 6) for x in delay_margin(0.01, 0.05, 0.0, 0.0, [0.0, 1.5, 5.0])]
    [3.969213, 2.469213, 0.0]
    """
    arguments.check_sheet(sheet)
    given = Given(alpha=alpha, beta=beta, gamma=gamma, delta=delta, delay=delay)
    return given.by_numpy(partial(_added, sheet))[0]  # type: ignore[no-any-return]


def _added(sheet: str, *loop: Array) -> list[Array]:
    """The delay margin of walls, plants and delays."""
    al, be, g, dl, delay = loop
    margin = np.asarray(_largest(sheet, al, be, g, dl)[0] - delay)
    lost = margin <= 0  # not for NaN
    al, be, g, dl, delay = (np.broadcast_to(a, margin.shape)[lost] for a in loop)
    late = (delay > 0) & is_stable(al, be, g, dl, delay, sheet)
    margin[lost] = np.where(late, np.nan, 0.0)
    return [margin]


def _exact(
    alpha: Array, beta: Array, gamma: Array, delta: Array, bounds: list[tuple[float, ...]]
) -> Array:
    known = ~np.isnan(alpha + beta + gamma + delta)
    shape = known.shape
    numbers = (np.where(known, a, 0.0).reshape(-1) for a in (alpha, beta, gamma, delta))
    al, be, g, dl = (np.broadcast_to(a, (known.size,)) for a in numbers)
    found = np.full(known.size, np.nan) if MODULE is None else MODULE.max_delay(al, be, g, dl)
    some = np.flatnonzero(np.isnan(found))
    found[some] = 0.0
    some = some[is_stable(al[some], be[some], g[some], dl[some], 0.0)]
    loops = Loops(wall(al[some], be[some]), g[some], dl[some], device(g[some], dl[some]))
    found[some], bound = first_loss(loops, _first_lost(loops))
    at = some[bound]
    bounds += zip(*(a[at].tolist() for a in (al, be, g, dl)), strict=True)
    return np.where(known, found.reshape(shape), np.nan)


def _finished(
    lost: Array, al: Array, be: Array, g: Array, dl: Array, known: NDArray[np.bool_]
) -> Array:
    lost = np.where(is_stable(al, be, g, dl, 0.0), lost, 0.0)
    return np.where(known, lost, np.nan)


def _first_lost(loops: Loops) -> Array:
    """The first whole number of periods at which a root is outside; infinite if there is none."""
    steps, none = np.zeros((2, loops.gamma.size))
    lost = none + np.inf
    left, count = np.arange(steps.size), 1
    between, window = loops.window()
    for _ in range(_PASSES):  # what is left then is no upper bound for who looks between
        if not left.size:
            break
        at = np.flatnonzero(between[left])
        some = Window(*(a[left[at]] for a in window))
        steps[left[at]] = (
            first_periods(some, steps[left[at]] + 1, none[at] + sizes.LONGEST, EXACT) - 1
        )
        left = left[steps[left] <= sizes.LONGEST]
        ahead, last = loops.take(left).leaving(steps[left], none[left], count)
        row, column = np.nonzero(ahead <= sizes.LONGEST)
        outside = np.zeros(ahead.shape, dtype=bool)
        here = ahead[row, column]
        outside[row, column] = ~loops.take(left[row]).stable(here, np.zeros(here.size))
        first = ahead[np.arange(left.size), outside.argmax(axis=1)]
        found = outside.any(axis=1)
        lost[left[found]] = first[found]
        steps[left] = last
        left = left[~found & (last <= sizes.LONGEST)]
        count = max(1, min(4 * count, _AHEAD // max(left.size, 1)))
    return lost


def _principal(
    alpha: Array, beta: Array, gamma: Array, delta: Array, bounds: list[tuple[float, ...]]
) -> Array:
    """In closed form, so that none is a bound only."""
    known = ~np.isnan(alpha + beta + gamma + delta)
    al, be, g, dl = (np.where(known, a, 0.0) for a in (alpha, beta, gamma, delta))
    x, v = device(g, dl), wall(al, be)
    change = np.minimum.reduce(next_changes(x, v, np.zeros_like(g), np.zeros(())))
    # where the wall leads at -1, the phase of z^d there is the next to change
    side = np.where(v.slope >= 0, 1.0, -1.0)
    end = np.where(v.at_minus_one > 0, side, 0.0) + (x.numerator_at_minus_one > 0)
    turns = np.rint((end - 3) / 2)
    at = end - 3 - (2 * turns - 1)
    change = np.where(leads_at_minus_one(x, v), np.minimum(change, at), change)
    return _finished(change, al, be, g, dl, known)

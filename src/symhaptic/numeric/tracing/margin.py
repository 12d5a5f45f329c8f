"""The delay margin: the largest delay up to which a wall stays stable.

For whole delays the first loss is known in closed form; between them it is enclosed
by :mod:`symhaptic.numeric.tracing.losses`.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.notation import sizes
from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.containers import kept
from symhaptic.numeric.crossings import wall
from symhaptic.numeric.given import Given
from symhaptic.numeric.plant import device
from symhaptic.numeric.stability import SHEETS, is_stable
from symhaptic.numeric.tracing.loops import Loops, leads_at_minus_one, next_changes
from symhaptic.numeric.tracing.losses import first_loss
from symhaptic.numeric.tracing.periods import EXACT, Window, first_periods

_AHEAD = 2**14
"""Whole delays that are looked at together, of all walls."""

_BLOCK = 8192
"""Walls that are worked on at a time: each has many parts of a period, which take memory."""


@kept(delay=float)
def delay_margin(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    sheet: str = "exact",
) -> Array:
    """Largest delay, in sampling periods, such that the loop is stable for every smaller one.

    Wall ``alpha``, ``beta``, plant ``gamma`` >= 0, ``delta`` >= 0; arrays broadcast.  0 where the
    loop is not stable without delay, infinite where no delay up to 1e15 destabilises it.  The
    time does not grow with the margin: some 20 microseconds for a wall among many, some
    milliseconds for one alone, up to a tenth of a second next to a device that swings thousands
    of periods long or where plant and wall all but touch.  Of devices within 1e-13 of making whole
    swings in a period, hardly damped, one in some thousand takes a minute.

    Behind a fraction of a period the crossings have no closed form: two equations, for the angle
    and the fraction, that are transcendental in the fraction.  The curve on which plant and wall
    are equally strong does not contain the whole periods.  Each part of a period encloses its
    piece of that curve to second order, and the phase along it tells at once for which of all
    whole delays a root can be there; a part is left only where none can, or where all cross in
    one direction, so that root counts at its ends decide.  Parts of 2^-20 of a period are not
    divided any more; where the bounds decide nothing, roots are counted at their ends, for the
    first 32 whole delays at which something could happen.  What may be missed is an instability
    that begins and ends within such a part: there the margin is that of the next one.  The bounds
    are float64's, without directed rounding.  With ``sheet="principal"`` the paper's z^-d, in
    closed form.

    Raises :class:`ValueError` for an infinite wall and an impossible plant; NaN gives NaN.

    >>> round(float(delay_margin(0.01, 0.05, 0.0, 0.0)), 6)
    3.969213
    """
    arguments.one_of("sheet", sheet, SHEETS)
    given = Given(alpha=alpha, beta=beta, gamma=gamma, delta=delta)
    search = _principal if sheet == "principal" else _exact
    work = partial(
        arguments.in_blocks,
        lambda *block: [search(*block)],
        block=_BLOCK,
        told="delay margins",
    )
    return given.by_numpy(work)[0]  # type: ignore[no-any-return]


def _exact(alpha: Array, beta: Array, gamma: Array, delta: Array) -> Array:
    known = ~np.isnan(alpha + beta + gamma + delta)
    shape = known.shape
    numbers = (np.where(known, a, 0.0).reshape(-1) for a in (alpha, beta, gamma, delta))
    al, be, g, dl = (np.broadcast_to(a, (known.size,)) for a in numbers)
    lost = np.asarray(is_stable(al, be, g, dl, 0.0))
    some = np.flatnonzero(lost)
    found = np.zeros(known.size)
    loops = Loops(wall(al[some], be[some]), g[some], dl[some], device(g[some], dl[some]))
    found[some] = first_loss(loops, _first_lost(loops))
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
    while left.size:
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


def _principal(alpha: Array, beta: Array, gamma: Array, delta: Array) -> Array:
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

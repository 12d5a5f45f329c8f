"""Where to begin: the walls that are stable for many arms of a range, by the compiled boundary.

Nothing here has to be believed; what is too high is cut off by :mod:`symhaptic.bounds.safe.prove`.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import product

import numpy as np
from flint import ctx
from numpy.typing import NDArray

from symhaptic.bounds.safe import check, prove
from symhaptic.bounds.safe.arms import Loops, ratios
from symhaptic.bounds.safe.prove import Columns
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.stability import is_stable

_MASSES = 8
"""So many arms by mass, and each with the least and the most damping and stiffness."""

_ANGLES = 8000

_TRIED, _SHARES = 300, (1e-3, 0.1, 0.3, 0.5, 0.7, 0.9)
"""So many virtual dampings are tried, each with stiffnesses at these shares of a bound."""

_TOO_LONG = 60
"""Periods of delay from which on nothing is tried."""

_TOO_STRONG = 4
"""The largest gamma and delta; stronger springs and dampers have no bounded series."""

_CONFIRMED = 1, 0.98, 0.9
"""Shares of the stiffnesses: the second check encloses less tightly than the first."""

_SLOWEST = 2.0 ** (9 - prove.BITS)
"""The smallest theta^2 of a softest wall that balls tell from 0; heavier arms are not searched."""


_UNSTABLE = "arms: no wall is found that is stable for all of them"


class NothingSafe(ValueError):
    """No wall is shown to be stable for all arms; the message is one line that says why."""


def arms(loops: Loops, masses: int = _MASSES) -> Iterator[tuple[float, float, float]]:
    """Mass, damping and stiffness of what moves, for some arms, each with no other's numbers."""
    (h0, h1), dampings, stiffnesses = (tuple(map(float, ends)) for ends in loops.hands)
    own = float(loops.mass)
    for mass in np.unique(np.geomspace(own + h0, own + h1, masses)):
        h = max(mass - own, 0.0)
        by_r, by_s = (h if by else 1.0 for by in loops.by_mass)
        for r, s in {(r * by_r, s * by_s) for r, s in product(dampings, stiffnesses)}:
            yield mass, float(loops.damping) + r, float(loops.stiffness) + s


def outlines(loops: Loops) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """K and B along the boundary of some arms."""
    period, delay = float(loops.period), float(loops.periods[0])
    theta = np.geomspace(1e-6, np.pi - 1e-9, _ANGLES)
    found = []
    for mass, damping, stiffness in arms(loops):
        gamma, delta = stiffness * period**2 / mass, damping * period / mass
        alpha, beta = stability_boundary(theta, gamma, delta, delay)
        with np.errstate(over="ignore"):  # what no float holds is no bound
            found.append((alpha * mass / period**2, beta * mass / period))
    return found


def largest_damping(loops: Loops) -> float:
    """The largest virtual damping with which some wall is stable for some arms; 0 if none is.

    Walls are tried at shares of the linear condition, in steps of 1 % and less.
    """
    mass, damping, stiffness = np.array(list(arms(loops))).T
    period, delay = float(loops.period), float(loops.periods[0])
    most, least, count = 4 * (mass.min() / period + damping.min()), 1e-7, _TRIED
    for _ in range(2):
        B = most * np.geomspace(least, 1, count)
        K = np.array(_SHARES)[:, None] * linear(loops, B)
        good = np.ones(K.shape, dtype=bool)
        for m, b, k in zip(mass, damping, stiffness, strict=True):
            heavy = period / m
            good &= is_stable(K * period * heavy, B * heavy, k * period * heavy, b * heavy, delay)
        found = np.flatnonzero(good.any(axis=0))
        if not len(found):
            return 0.0
        last = found[-1]
        least, most = B[last] / B[min(last + 1, count - 1)], B[min(last + 1, count - 1)]
        count = 20
    return float(B[last])


def linear(loops: Loops, B: NDArray[np.float64]) -> NDArray[np.float64]:
    """The stiffness of the linear condition (24), for the arm of least damping."""
    least = float(loops.hands[1][0]) * (float(loops.hands[0][0]) if loops.by_mass[0] else 1.0)
    return (B + float(loops.damping) + least) / float(
        loops.period * (loops.periods[0] + Fraction(1, 2))
    )


def guessed(loops: Loops, columns: int = 96) -> Columns:
    """Columns from B = 0 on, as high as the boundaries of some arms leave them, but a little."""
    width = largest_damping(loops)
    if not width > 0:
        raise NothingSafe(_UNSTABLE)
    edges = np.linspace(0, width, columns + 1)
    tops = np.full(columns, np.inf)
    for K, B in outlines(loops):
        known = np.isfinite(K) & np.isfinite(B)
        K, B = K[known], B[known]
        place = np.searchsorted(edges, B, side="right") - 1
        left = (B[:, None] < edges)[:-1]
        step, edge = np.nonzero(left != (B[:, None] < edges)[1:])
        share = (edges[edge] - B[step]) / (B[step + 1] - B[step])
        on_edge = K[step] + share * (K[step + 1] - K[step])
        for at, there in ((place, K), (edge, on_edge), (edge - 1, on_edge)):
            inside = (at >= 0) & (at < len(tops)) & (there > 0)
            np.minimum.at(tops, at[inside], there[inside])
    tops = np.where(np.isfinite(tops), tops, np.max(tops[np.isfinite(tops)], initial=0.0))
    low = float(1e-6 * max(tops))
    if not low > 0:
        raise NothingSafe(_UNSTABLE)
    tops = np.where(tops > 4 * low, 0.99 * tops, 0.0)
    return Columns(tuple(map(float, edges)), tuple(map(float, tops)), low)


def certified(loops: Loops, columns: int = 96) -> check.Certificate:
    """The walls that are stable for every arm, found, shown and checked again.

    Raises :class:`NothingSafe` where no wall is shown.
    """
    if loops.periods[0] > _TOO_LONG:
        raise NothingSafe(f"delay: nothing is shown for more than {_TOO_LONG} sampling periods")
    with ctx.workprec(check.BITS):
        strongest = max(float(x.upper()) for x in ratios(loops, loops.hands))
    if strongest > _TOO_STRONG:
        raise NothingSafe(
            f"arms: k T^2/m or b T/m is up to {strongest:.3g}; nothing is shown above {_TOO_STRONG}"
        )
    begun = guessed(loops, columns)
    heaviest = begun.low * float(loops.period) ** 2 / (4 * _SLOWEST) - float(loops.mass)
    if loops.hands[0][1] > heaviest:
        raise NothingSafe(
            f"arms: mass is up to {float(loops.hands[0][1]):.3g} kg; with this device nothing is "
            f"shown above {heaviest:.2g} kg"
        )
    found = prove.shown(loops, begun)
    for share in _CONFIRMED:
        claim = _claimed(loops, found, share)
        if check.recheck(claim):
            return claim
    raise NothingSafe("arms: the second check does not confirm the walls that were found")


def _claimed(loops: Loops, found: prove.Shown, share: float) -> check.Certificate:
    """The runs of columns in which one wall is stable, with this share of their height.

    Raises :class:`NothingSafe` where there is none.
    """
    low, edges = found.columns.low, found.columns.edges
    tops = [share * top if share * top > low else 0.0 for top in found.columns.tops]
    stable = []
    with ctx.workprec(check.BITS):
        for run in Columns(edges, tuple(tops), low).runs():
            best = max(run, key=tops.__getitem__)
            wall = (low + tops[best]) / 2, (edges[best] + edges[best + 1]) / 2
            if check.stable(loops, wall):
                stable.append(wall)
            else:
                tops[run.start : run.stop] = [0.0] * len(run)
    if not stable:
        raise NothingSafe("arms: no wall is shown to be stable for all of them")
    columns = Columns(edges, tuple(tops), low)
    return check.Certificate(loops, columns, found.cuts, found.angles, tuple(stable))

"""Where to begin: the walls that are stable for many arms of a range, by the compiled boundary.

Nothing here has to be believed; what is too high is cut off by :mod:`symhaptic.bounds.safe.prove`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np
from flint import ctx
from numpy.typing import NDArray

from symhaptic.bounds.safe import check, prove
from symhaptic.bounds.safe.arms import Loops, ratios
from symhaptic.bounds.safe.prove import Columns
from symhaptic.numeric.boundary import stability_boundary

_MASSES = 8
"""So many arms by mass, and each with the least and the most damping and stiffness."""

_ANGLES = 8000

_TOO_LONG = 60
"""Periods of delay from which on nothing is tried."""

_TOO_STRONG = 4
"""The largest gamma and delta; stronger springs and dampers have no bounded series."""

_SLOWEST = 2.0 ** (9 - prove.BITS)
"""The smallest theta^2 of a softest wall that balls tell from 0; heavier arms are not searched."""


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


def guessed(loops: Loops, columns: int = 96) -> Columns:
    """Columns from B = 0 on, as high as the boundaries of some arms leave them, but a little."""
    curves = outlines(loops)
    widths, heights = [], []
    for K, B in curves:
        positive = np.nonzero(K > 0)[0]
        if len(positive):
            first = positive[0]
            after = np.nonzero(K[first:] <= 0)[0]
            arc = slice(first, first + after[0] if len(after) else None)
            width = float(np.nanmax(B[arc]))
            if width <= 0 and len(after):  # B = 0 is between its last point and K = 0
                ends = slice(arc.stop - 1, arc.stop + 1)
                width = float(np.interp(0.0, -K[ends], B[ends]))
            widths.append(width)
            heights.append(np.nanmax(K[arc]))
    width, height = min(widths, default=0.0), min(heights, default=0.0)
    if not (width > 0 and height > 0):
        raise NothingSafe("arms: no virtual damping is stable for all of them")
    edges = np.linspace(0, 1.01 * width, columns + 1)
    tops = np.full(len(edges) - 1, height)
    for K, B in curves:
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
    low = float(1e-6 * height)
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
    kept = found.columns
    tops, stable = list(kept.tops), []
    with ctx.workprec(check.BITS):
        for run in kept.runs():
            best = max(run, key=kept.tops.__getitem__)
            wall = (
                float(kept.low + kept.tops[best]) / 2,
                float(kept.edges[best] + kept.edges[best + 1]) / 2,
            )
            if check.stable(loops, wall):
                stable.append(wall)
            else:
                tops[run.start : run.stop] = [0.0] * len(run)
    if not stable:
        raise NothingSafe("arms: no wall is shown to be stable for all of them")
    proved = Columns(kept.edges, tuple(tops), kept.low)
    claim = check.Certificate(loops, proved, found.cuts, found.angles, tuple(stable))
    if not check.recheck(claim):
        raise NothingSafe("arms: what was found is not confirmed by the second check")
    return claim

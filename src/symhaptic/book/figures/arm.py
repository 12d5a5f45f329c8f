"""The plot of the human arms of Table II, normalised by their mass."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symhaptic.book.figures.style import COLOURS
from symhaptic.paper.tables import EXCLUDED, TABLE_II

if TYPE_CHECKING:
    from matplotlib.axes import Axes

CONSIDERED, LARGEST = (1000.0, 20.0), (710.0, 14.6)
"""Corners of the ranges (23) at T = 1 ms and of (21), in 1/s^2 and 1/s."""

SHIFTS = {
    "Daniel et al.": ((-5, -2), "right"),
    "Hogan": ((-5, -2), "right"),
    "Kuchenbecker et al.": ((-5, -2), "right"),
    "Lawrence": ((-5, -2), "right"),
    "Lawrence and Chapel": ((0, -11), "center"),
    "Tsuji et al.": ((0, 4), "center"),
}
"""Where a label does not stand right of its point: shift in points, and its alignment."""


def arms(axes: Axes) -> None:
    """Fig. 6: stiffness and damping per mass of each row, with the two ranges."""
    for (right, top), colour, style, label in (
        (CONSIDERED, COLOURS[0], "solid", r"range (23) at $T=1\,$ms"),
        (LARGEST, COLOURS[2], (0, (4, 2)), "bounds (21)"),
    ):
        frame = [right, right, 1], [0.5, top, top]
        axes.fill_between([1, right], 0.5, top, color=colour, alpha=0.08, linewidth=0)
        axes.plot(*frame, color=colour, linestyle=style, linewidth=0.9, label=label)
    for row in TABLE_II:
        mass = float(row.mass)
        place = float(row.stiffness) / mass, float(row.damping) / mass
        colour = COLOURS[5] if row.authors == EXCLUDED else "black"
        shift, side = SHIFTS.get(row.authors, ((5, -2), "left"))
        axes.plot(*place, "o", color=colour, markersize=3)
        axes.annotate(
            row.authors,
            place,
            shift,
            textcoords="offset points",
            fontsize=8,
            color=colour,
            horizontalalignment=side,
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(1, 20000)
    axes.set_ylim(0.5, 100)
    axes.set_xlabel("stiffness over mass $k_H/m_H$ in s$^{-2}$")
    axes.set_ylabel("damping over mass $b_H/m_H$ in s$^{-1}$")
    axes.legend(loc="upper left")

"""The plots for fractional delays: what is passive and what is stable, exactly and in the paper."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.book.figures.style import COLOURS
from symhaptic.numeric.passivity import max_passive_stiffness, passivity_boundary, passivity_margin

if TYPE_CHECKING:
    from matplotlib.axes import Axes

GREEN, BLUE, RED = COLOURS[0], COLOURS[2], COLOURS[5]
PASSIVE_DELAYS = ((0.25, GREEN), (0.5, BLUE))
SPRING = 4 * np.pi**2 / 9
"""gamma of the plot of stable walls: a third of a turn per period."""

DAMPER = 0.5
"""Its delta."""


def passive_outline(delay: float, sheet: str = "exact") -> tuple[Any, Any]:
    """(KT/b, B/b) around the passive walls, from (0, -1) to the end of the boundary at K = 0."""
    angles = np.linspace(0, np.pi / (delay + 1) * 1.1, 1200)[1:]
    stiffness, damping = passivity_boundary(angles[angles < np.pi], 1.0, delay, sheet)
    kept = stiffness > 0
    part = 0.0 if sheet == "principal" else delay % 1
    low = np.linspace(0, stiffness[0], 60)
    arc = low * (delay + 0.5) + part * (1 - part) * low**2 / 4 - 1
    top = 1 / (1 - passivity_margin(0.0, 1.0, 1.0, delay, sheet))
    return (
        np.concatenate([low, stiffness[kept], [0]]),
        np.concatenate([arc, damping[kept], [top]]),
    )


def passive_regions(axes: Axes) -> None:
    """Passive walls for two fractional delays: exact, by the paper, for the next integer delay."""
    for delay, colour in PASSIVE_DELAYS:
        exact, printed = passive_outline(delay), passive_outline(delay, "principal")
        axes.fill(*exact, color=colour, alpha=0.12, linewidth=0)
        axes.plot(*exact, color=colour, label=f"$d = {delay:g}$")
        axes.plot(*printed, color=colour, linestyle="dashed", label=f"$d = {delay:g}$ by (7)")
    axes.plot(*passive_outline(1.0), color="black", linestyle="dotted", label="$d = 1$")
    axes.axhline(0, color="black", linewidth=0.4)
    axes.set_xlim(0, 2.05)
    axes.set_ylim(-1.05, 1.4)
    axes.set_xlabel("virtual stiffness $KT/b$")
    axes.set_ylabel("virtual damping $B/b$")
    axes.legend(loc="upper right")


def largest_stiffness(axes: Axes) -> None:
    """The largest passive stiffness: exact, by (11), and by (11) with the delay rounded up."""
    delays = np.linspace(0, 3, 601)
    whole = np.ceil(delays)
    curves = (
        (delays, "exact", "exact", GREEN, "solid"),
        (delays, "principal", "by (11)", RED, "dashed"),
        (whole, "principal", "by (11), rounded up", "black", "dotted"),
    )
    for delay, sheet, label, colour, style in curves:
        stiffness = max_passive_stiffness(1.0, delay, sheet).alpha
        axes.plot(delays, stiffness, color=colour, linestyle=style, label=label)
    axes.set_xlim(0, 3)
    axes.set_ylim(0, 2.05)
    axes.set_xlabel("delay factor $d$")
    axes.set_ylabel(r"largest passive stiffness $K_{\max}T/b$")
    axes.legend(loc="upper right")


def stable_readings(axes: Axes) -> None:
    """Stable walls with half a period of delay: exact, on the principal sheet, on both sheets."""
    import shapely

    from symhaptic.numeric.tracing.region import stable_region

    exact = stable_region(SPRING, DAMPER, 0.5)
    principal = stable_region(SPRING, DAMPER, 0.5, "principal")
    mirrored = shapely.affinity.scale(principal.polygon, -1, -1, origin=(0, 0))
    both = principal.polygon.intersection(mirrored)
    for polygon, colour, style, label in (
        (exact.polygon, GREEN, "solid", "exact"),
        (principal.polygon, RED, "dashed", "principal sheet"),
        (both, "black", "dotted", "all sheets"),
    ):
        x, y = np.asarray(polygon.exterior.coords).T
        if style == "solid":
            axes.fill(x, y, color=colour, alpha=0.12, linewidth=0)
        axes.plot(x, y, color=colour, linestyle=style, label=label)
    axes.set_xlabel(r"virtual stiffness $\alpha$")
    axes.set_ylabel(r"virtual damping $\beta$")
    axes.legend(loc="upper right")

"""The plot of what the parts of a loop cost that are left out of its model."""

from __future__ import annotations

from typing import Any

import numpy as np

from symhaptic.book.figures.passivity import COLOURS
from symhaptic.numeric.tracing.extremes import max_stable_stiffness

DELAYS = (0, 1, 2)
STIFF, DAMPED = 0.001, 0.02
"""The far corner of the paper's (23)."""


def costs(panels: Any) -> None:
    """Error without damper over delta, and without spring over gamma, in per cent."""
    left, right = panels.flat
    dampers, springs = np.linspace(0, DAMPED, 60), np.linspace(0, STIFF, 60)
    for colour, delay in zip(COLOURS, DELAYS, strict=False):
        for axes, across, whole, part in (
            (left, dampers, (STIFF, dampers), (STIFF, 0.0)),
            (right, 1000 * springs, (springs, DAMPED), (0.0, DAMPED)),
        ):
            full, less = (max_stable_stiffness(g, f, delay).alpha for g, f in (whole, part))
            axes.plot(across, 100 * (less / full - 1), color=colour, label=f"$d={delay}$")
    left.set_xlabel(r"physical damping $\delta$")
    right.set_xlabel(r"physical stiffness $1000\,\gamma$")
    left.set_ylabel("error of largest stable stiffness in %")
    for axes, names in ((left, "without damper"), (right, "without spring")):
        axes.set_title(names, loc="left", fontsize=9)
        axes.axhline(0, color="black", linewidth=0.4)
    left.legend(loc="lower left")

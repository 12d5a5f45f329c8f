"""The plot of the linear condition beside the exact boundary, as vector graphics."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import sympy as sp

from symhaptic.book.figures.stability import GREY, plane
from symhaptic.book.figures.style import COLOURS
from symhaptic.bounds.linear_points import Arc, Point, points
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.linear import linear_limit

GAMMA = sp.Rational(1, 1000)
DAMPINGS = tuple(sp.Rational(k, 200) for k in range(5))
DELAYS = (0, 1)
"""Parameters of Fig. 10."""

LEVELS = tuple(sp.Rational(percent, 100) for percent in (-5, -2, 0, 2, 5))
"""Errors that are marked, with their sign."""

MARKS = {0: "o", 2: "^", 5: "s"}
WINDOWS = ((-0.004, 0.155, -0.0245, 0.0605), (-0.0015, 0.0485, -0.0255, 0.054))
"""Limits of alpha and beta that are drawn."""


@cache
def marks(delay: int, damping: sp.Rational) -> tuple[tuple[sp.Rational, Point], ...]:
    """All marked points of one boundary with their errors, in order of the angle."""
    arc = Arc(GAMMA, damping, delay)
    found = [(level, point) for level in LEVELS for point in points(arc, level)]
    return tuple(sorted(found, key=lambda mark: float(mark[1].theta.mid())))


def linear(panels: Any) -> None:
    """Fig. 10: exact boundaries (solid) and lines of (25) (dashed), errors marked."""
    for axes, delay, (left, right, low, high) in zip(panels.flat, DELAYS, WINDOWS, strict=True):
        angles = np.geomspace(1e-4, 0.5, 500)
        for colour, damping in zip(COLOURS, DAMPINGS, strict=False):
            delta = float(damping)
            alpha, beta = stability_boundary(angles, float(GAMMA), delta, delay)
            axes.plot(alpha, beta, color=colour, label=rf"$\delta={delta:g}$")
            ends = np.array([-delta - (delay + 0.5) * float(GAMMA), high])
            line = linear_limit(ends, delta, delay)
            axes.plot(line, ends, color=colour, linestyle=(0, (4, 2)), linewidth=0.8)
            for level, point in marks(delay, damping):
                if not point.alpha < 0:
                    axes.plot(
                        float(point.alpha.mid()),
                        float(point.beta.mid()),
                        MARKS[abs(int(100 * level))],
                        color=colour,
                        markersize=3.5,
                        markerfacecolor="white",
                        zorder=4,
                    )
        axes.axvline(-float(GAMMA), color=GREY, linewidth=0.8)
        plane(axes)
        axes.set_xlim(left, right)
        axes.set_ylim(low, high)
        axes.set_title(f"$d={delay}$", loc="left", fontsize=9)
    first = panels.flat[0]
    for percent, mark in MARKS.items():
        first.plot([], [], mark, color="black", mfc="white", markersize=3.5, label=f"{percent} %")
    handles, labels = first.get_legend_handles_labels()
    first.figure.legend(
        handles, labels, loc="outside lower center", ncols=4, handlelength=1.6, columnspacing=1.4
    )

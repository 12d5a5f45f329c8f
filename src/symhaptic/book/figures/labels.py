"""Names beside points, where no other name, point or line is."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_AWAY = (5, 8, 12, 16, 21, 27, 34, 42, 52, 64)
"""Points of the page between a point and its name, the nearest place first."""

_NEAR = 16
"""Up to here a name needs no line."""

_SIDES = [side for side in product((1, 0, -1), (0, 1, -1)) if side != (0, 0)]

Named = tuple[float, float, str, Any]
"""Where a point is, its name and its colour."""


Panel = tuple["Axes", Sequence[Named], Sequence[tuple[Any, Any]]]
"""Axes, the names in them, and lines, of which each has its x and y."""


def place(*panels: Panel) -> None:
    """Write each name beside its point, clear of all lines, in panels of one figure.

    A name that had to go far is joined to its point by a thin line.  The limits of the axes must
    be set.
    """
    figure: Any = panels[0][0].figure
    figure.draw_without_rendering()  # a layout that moves axes has moved them
    for axes, names, lines in panels:
        _place(figure, axes, names, lines)


def _place(figure: Any, axes: Axes, names: Sequence[Named], lines: Any) -> None:
    scale = figure.dpi / 72
    renderer = figure.canvas.get_renderer()
    points = axes.transData.transform([(x, y) for x, y, *_ in names])
    crowd = [(p, 3.0) for p in points]
    for xs, ys in lines:
        ends = axes.transData.transform(np.column_stack([xs, ys]))
        steps = np.linspace(0, len(ends) - 1, 40 * len(ends))
        along = [np.interp(steps, range(len(ends)), ends[:, k]) for k in (0, 1)]
        crowd += [(p, 1.0) for p in np.column_stack(along)]
    centres = np.array([p for p, _ in crowd])
    radii = scale * np.array([[radius] for _, radius in crowd])
    low, high = centres - radii, centres + radii  # corners of what must not be written over
    floor, roof = (np.array(c) for c in axes.get_window_extent(renderer).get_points())
    for (x, y, name, colour), at in zip(names, points, strict=True):
        text = axes.annotate(
            name, (x, y), (0, 0), textcoords="offset points", fontsize=7, color=colour
        )
        text.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 0.2})
        text.set_in_layout(False)
        size = text.get_window_extent(renderer)
        drop = size.y0 - at[1]
        extent = np.array([size.width, size.height])
        best, least = (at, _AWAY[0]), float("inf")
        for away, (right, up) in product(_AWAY, _SIDES):
            corner = at + scale * away * np.array([right, up])
            corner -= np.array([(1 - right) / 2 * size.width, size.height / 2])
            out = (corner < floor + 2).any() or (corner + extent > roof - 2).any()
            hit = int(np.all((corner <= high) & (low <= corner + extent), axis=1).sum()) + 100 * out
            if away > _NEAR:  # nor may the line that joins it cross a name
                end = np.clip(at, corner, corner + extent)
                way = (at + np.linspace(0, 1, 30)[:, None] * (end - at))[:, None]
                crossed = np.all((low[len(crowd) :] < way) & (way < high[len(crowd) :]), axis=2)
                hit += int(crossed.any(axis=0).sum())
            if hit < least:
                best, least = (corner, away), hit
            if not hit:
                break
        corner, away = best
        shift = (corner - at) / scale
        text.set_position((shift[0], shift[1] - drop / scale))
        low, high = np.vstack([low, corner]), np.vstack([high, corner + extent])
        if away > _NEAR:
            end = np.clip(at, corner, corner + extent)
            axes.plot(
                *axes.transData.inverted().transform([at, end]).T,
                color=colour,
                linewidth=0.35,
                zorder=1,
            )

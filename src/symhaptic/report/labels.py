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


def place(axes: Axes, names: Sequence[Named], lines: Sequence[tuple[Any, Any]] = ()) -> None:
    """Write each name beside its point, clear of all ``lines``, of which each has its x and y.

    A name that had to go far is joined to its point by a thin line.  The limits of the axes must
    be set.
    """
    from matplotlib.transforms import Bbox

    figure: Any = axes.figure
    figure.draw_without_rendering()  # a layout that moves axes has moved them
    scale = figure.dpi / 72
    renderer = figure.canvas.get_renderer()
    points = axes.transData.transform([(x, y) for x, y, *_ in names])
    crowd = [(p, 3.0) for p in points]
    for xs, ys in lines:
        ends = axes.transData.transform(np.column_stack([xs, ys]))
        steps = np.linspace(0, len(ends) - 1, 40 * len(ends))
        along = [np.interp(steps, range(len(ends)), ends[:, k]) for k in (0, 1)]
        crowd += [(p, 1.0) for p in np.column_stack(along)]
    taken = [Bbox.from_extents(*(p - radius * scale), *(p + radius * scale)) for p, radius in crowd]
    inside = axes.get_window_extent(renderer)
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
            box = Bbox([corner, corner + extent])
            out = box.x0 < inside.x0 + 2 or box.x1 > inside.x1 + 2
            out = out or box.y0 < inside.y0 + 2 or box.y1 > inside.y1 + 2
            hit = sum(box.overlaps(other) for other in taken) + 100 * out
            if away > _NEAR:  # nor may the line that joins it cross a name
                end = np.clip(at, box.min, box.max)
                way = at + np.linspace(0, 1, 30)[:, None] * (end - at)
                hit += sum(other.count_contains(way) > 0 for other in taken[len(crowd) :])
            if hit < least:
                best, least = (corner, away), hit
            if not hit:
                break
        corner, away = best
        shift = (corner - at) / scale
        text.set_position((shift[0], shift[1] - drop / scale))
        box = Bbox([corner, corner + extent])
        taken.append(box)
        if away > _NEAR:
            end = np.clip(at, box.min, box.max)
            axes.plot(
                *axes.transData.inverted().transform([at, end]).T,
                color=colour,
                linewidth=0.35,
                zorder=1,
            )

"""Names beside points, where no other name or point is."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_AWAY = (5, 9, 14, 20, 28, 38, 50, 64)
"""Points of the page between a point and its name, the nearest place first."""


def place(
    axes: Axes, names: Sequence[tuple[float, float, str, Any]], others: Sequence[Any] = ()
) -> None:
    """Write each name, with its colour, beside its point; ``others`` are points to keep clear.

    A name that had to go far is joined to its point by a thin line.  The limits of the axes must
    be set.
    """
    from matplotlib.transforms import Bbox

    figure: Any = axes.figure
    figure.draw_without_rendering()  # a layout that moves axes has moved them
    scale = figure.dpi / 72
    renderer = figure.canvas.get_renderer()
    points = [axes.transData.transform(p) for p in [(x, y) for x, y, *_ in names] + [*others]]
    near = 3 * scale
    taken = [Bbox.from_extents(x - near, y - near, x + near, y + near) for x, y in points]
    inside = axes.get_window_extent(renderer)
    for (x, y, name, colour), at in zip(names, points, strict=False):
        text = axes.annotate(
            name, (x, y), (0, 0), textcoords="offset points", fontsize=7, color=colour
        )
        size = text.get_window_extent(renderer)
        best, least = None, float("inf")
        for away, (right, up) in product(_AWAY, product((1, 0, -1), (0, 1, -1))):
            if not right and not up:
                continue
            left = away * right * scale - (size.width if right < 0 else 0)
            left -= size.width / 2 if right == 0 else 0
            low = away * up * scale - size.height / 2
            box = Bbox.from_bounds(at[0] + left, at[1] + low, size.width, size.height)
            out = not (inside.x0 <= box.x0 and box.x1 <= inside.x1 + 2 * scale)
            out = out or not (inside.y0 <= box.y0 and box.y1 <= inside.y1)
            hit = sum(box.overlaps(t) for t in taken) + 3 * out
            if hit < least:
                best, least = (left, low, box, away), hit
            if not hit:
                break
        assert best is not None
        left, low, box, away = best
        text.set_position((left / scale, low / scale + 0.2 * size.height / scale))
        taken.append(box)
        if away > 14:
            end = (min(max(at[0], box.x0), box.x1), min(max(at[1], box.y0), box.y1))
            line = axes.transData.inverted().transform(np.array([at, end]))
            axes.plot(*line.T, color=colour, linewidth=0.35, zorder=1)

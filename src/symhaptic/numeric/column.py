"""Pictures that fit a column of a journal."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLUMN = 3.5
"""Width in inches of a column of a journal."""

STYLE: Any = {
    "font.size": 8,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.limits": (-3, 5),
    "legend.frameon": False,
    "savefig.dpi": 300,
    "pdf.fonttype": 42,  # journals refuse Type 3
    "ps.fonttype": 42,
    "svg.hashsalt": "symhaptic",
}
"""Matplotlib's settings of a picture for a column."""


@cache
def column_figure() -> type[Figure]:
    """Matplotlib's figure of the width of a column, which keeps its style when it is saved."""
    from matplotlib import rc_context
    from matplotlib.figure import Figure as Plain

    class ColumnFigure(Plain):
        def __init__(self, **given: Any) -> None:
            size = {"figsize": (COLUMN, 0.95 * COLUMN), "layout": "constrained"}
            super().__init__(**(size | {k: v for k, v in given.items() if v is not None}))

        def savefig(self, *args: Any, **given: Any) -> None:
            with rc_context(STYLE):
                super().savefig(*args, **given)

    return ColumnFigure


def legend_below(axes: Axes, columns: int = 2) -> None:
    """A legend below the label of the axis, in one column if the figure is narrow."""
    from matplotlib.transforms import ScaledTranslation

    size = 0.9 * float(axes.xaxis.label.get_fontsize())
    drop = ScaledTranslation(0, -(11 + 2.7 * size) / 72, axes.figure.dpi_scale_trans)
    wide = axes.figure.bbox.width / axes.figure.dpi > 1.5 * COLUMN
    place: dict[str, Any] = {"bbox_to_anchor": (0.5, 0), "bbox_transform": axes.transAxes + drop}
    room: dict[str, Any] = {"borderaxespad": 0, "columnspacing": 1.2, "fontsize": size}
    axes.legend(loc="upper center", frameon=False, ncols=columns if wide else 1, **place, **room)

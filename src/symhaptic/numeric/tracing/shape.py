"""What every region of the (alpha, beta) plane has: an outline, an area, a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.numeric.arguments import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Shape:
    """A region given by Shapely's polygon or polygons."""

    polygon: Any

    @property
    def labels(self) -> tuple[str, str]:
        """What the axes of the plane are."""
        return r"virtual stiffness $\alpha=KT^2/m$", r"virtual damping $\beta=BT/m$"

    @property
    def outline(self) -> tuple[Array, ...]:
        """Closed rings, one row (alpha, beta) per point; one ring for each piece of the region."""
        parts = getattr(self.polygon, "geoms", [self.polygon])
        return tuple(np.asarray(p.exterior.coords) for p in parts if not p.is_empty)

    @property
    def area(self) -> float:
        """Area in the (alpha, beta) plane, to within error times length of the outline."""
        return float(self.polygon.area)

    def plot(self, axes: Axes, **style: Any) -> None:
        """Draw the outline on Matplotlib's axes; ``style`` as for a line, ``fill`` for the area.

        Axes without labels get those of the plane.
        """
        fill = style.pop("fill", None)
        if not axes.get_xlabel() and not axes.get_ylabel():
            across, up = self.labels
            axes.set(xlabel=across, ylabel=up)
        for ring in self.outline:
            if fill is not None:
                axes.fill(ring[:, 0], ring[:, 1], color=fill, linewidth=0)
            (line,) = axes.plot(ring[:, 0], ring[:, 1], **style)
            style = {**style, "color": line.get_color(), "label": None}

"""How the plots of the report look: their colours, their type, and how they are written to files.

The pictures of a scene have the colours of `scene/picture.py`, and those of a sweep the colours of
`sweeps/drawing.py`.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

COLOURS = ("#1B6E4B", "#2E7FA3", "#33558B", "#6A4C93", "#A2416B", "#B3261E", "#A86B00")
WIDTH = 132 / 25.4
"""Width of the text in inches."""

STYLE: Any = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.1,
    "legend.frameon": False,
    "svg.hashsalt": "symhaptic",
    "pdf.fonttype": 42,
}

_METADATA: dict[str, Any] = {
    ".pdf": {"CreationDate": None, "Creator": "symhaptic", "Producer": None},
    ".svg": {"Date": None},
    ".png": {"Software": None},
}


def save(
    draw: Callable[..., None], target: Path, panels: tuple[int, int] = (1, 1), height: float = 0.62
) -> None:
    """Draw a figure into a file, PDF, SVG or PNG, that is the same from run to run.

    ``panels`` are rows and columns; ``draw`` gets the axes, or the array of them where there are
    several.  ``height`` is in widths of the text.
    """
    save_all(draw, [target], panels, height)


def save_all(
    draw: Callable[..., None], targets: Sequence[Path], panels: tuple[int, int], height: float
) -> None:
    """The same into several files, drawn once."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    with matplotlib.rc_context(STYLE):
        size = (WIDTH, height * WIDTH)
        figure, axes = plt.subplots(*panels, figsize=size, layout="constrained")
        draw(axes)
        for target in targets:
            clear = target.suffix == ".svg"  # a page of the site gives it its background
            figure.savefig(target, dpi=200, transparent=clear, metadata=_METADATA[target.suffix])
        plt.close(figure)

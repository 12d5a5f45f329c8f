"""Runs programs that draw, one after the other, and keeps what each has drawn as SVG.

``python -m symhaptic.book.figures.programs FOLDER PROGRAM...``, in a process of its own, since
a program may leave behind what it likes.
"""

from __future__ import annotations

import runpy
import sys
from collections.abc import Sequence
from pathlib import Path


def draw(programs: Sequence[Path], folder: Path) -> None:
    """One picture for each program, in the style of the book, named after it."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot, rc_context

    from symhaptic.book.figures.style import STYLE, WIDTH

    size = {"figure.figsize": (WIDTH, 0.62 * WIDTH), "figure.constrained_layout.use": True}
    with rc_context(STYLE | size):
        for program in programs:
            runpy.run_path(str(program))
            picture = folder / f"{program.stem}.svg"
            pyplot.savefig(picture, transparent=True, metadata={"Date": None})
            pyplot.close("all")


if __name__ == "__main__":
    target, *given = map(Path, sys.argv[1:])
    draw(given, target)

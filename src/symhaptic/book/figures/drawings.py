"""Figures of chapters, each drawn once as all files that are wanted, beside the other work."""

from __future__ import annotations

import multiprocessing
import shutil
from collections.abc import Sequence
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor
from contextlib import ExitStack, suppress
from pathlib import Path

from symhaptic.book.chapters import Chapter
from symhaptic.book.figures.style import save, save_all
from symhaptic.book.processes import end_with_parent, folder
from symhaptic.book.record import Block

ENDINGS = (".pdf", ".svg")


class Drawings(ExitStack):
    """A process that draws what :meth:`begin` hears of, while chapters are derived.

    Figures of code outside of the package, figures that were not begun, and those that a killed
    process has not drawn are drawn where they are taken.
    """

    def __init__(self) -> None:
        super().__init__()
        self._folder = self.enter_context(folder())
        spawn = multiprocessing.get_context("spawn")  # nothing of the chapters is in it
        self._pool = ProcessPoolExecutor(1, spawn, end_with_parent)
        self.callback(self._pool.shutdown, cancel_futures=True)
        self._begun: dict[str, Future[None]] = {}

    def begin(self, chapter: Chapter) -> None:
        """Draw the figures of a chapter as soon as there is time."""
        for block in chapter.page.blocks:
            if block.draw is not None and _ours(block):
                files = [self._file(block, ending) for ending in ENDINGS]
                with suppress(BrokenExecutor):
                    self._begun[block.title] = self._pool.submit(
                        save_all, block.draw, files, block.panels, block.height
                    )

    def take(self, block: Block, target: Path) -> None:
        """Put a figure into a file, PDF or SVG, once it is drawn."""
        if drawn := self._begun.get(block.title):
            with suppress(BrokenExecutor):
                drawn.result()
                shutil.copyfile(self._file(block, target.suffix), target)
                return
        take(block, target)

    def _file(self, block: Block, ending: str) -> Path:
        return self._folder / f"{block.title}{ending}"


def take(block: Block, target: Path) -> None:
    """Draw a figure into a file, here and now."""
    assert block.draw is not None
    save(block.draw, target, block.panels, block.height)


def figures(chapters: Sequence[Chapter]) -> list[Block]:
    """The figures of chapters, in their order."""
    blocks = [block for chapter in chapters for block in chapter.page.blocks]
    return [block for block in blocks if block.draw is not None]


def _ours(block: Block) -> bool:
    """Whether another process finds what draws: a function of the package, or one given values."""
    function = getattr(block.draw, "func", block.draw)
    return getattr(function, "__module__", "").startswith("symhaptic.book.figures.")

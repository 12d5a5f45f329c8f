"""Derivations side by side: each settles its statements on its own, in a process of its own."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from pathlib import Path

from symhaptic.ledger import Entry, of_derivation

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""


def workers() -> int:
    """How many processes are worth while here."""
    return min(MOST, os.cpu_count() or 1)


def settled(
    paths: Sequence[Path],
    workers: int,
    told: Callable[[int, Path], None] = lambda done, path: None,
) -> list[Entry]:
    """The statements that the derivations settle, in the order of the derivations.

    ``told`` hears how many are done and which one is under way.  What a derivation raises is
    raised here; the others are then not begun.
    """
    if workers == 1 or len(paths) <= 1:
        entries = []
        for done, path in enumerate(paths):
            told(done, path)
            entries += of_derivation(path)
        return entries
    with ProcessPoolExecutor(min(workers, len(paths))) as pool:
        futures = [pool.submit(of_derivation, path) for path in paths]
        open_ = set(futures)
        try:
            while open_:
                told(len(futures) - len(open_), paths[_first(futures)])
                ended, open_ = wait(open_, return_when=FIRST_COMPLETED)
                for future in ended:
                    future.result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
        return [entry for future in futures for entry in future.result()]


def _first(futures: Sequence[Future[list[Entry]]]) -> int:
    return next(i for i, future in enumerate(futures) if not future.done())

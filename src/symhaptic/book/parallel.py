"""Run derivations side by side, each chapter of a user's own in a process of its own.

The package's chapters share a few worker processes, which keep the lemmas that they derive.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack
from pathlib import Path
from typing import NoReturn, TypeAlias, TypeVar

from symhaptic.book import SELDOM
from symhaptic.book.chapters import BadChapter, folder
from symhaptic.book.ledger import Entry, of_derivation
from symhaptic.book.processes import end_with_parent

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""

FORKED = "fork" if sys.platform.startswith("linux") else "spawn"
"""A forked worker has imported SymPy already; elsewhere than on Linux forking is not safe."""

PAUSE = 0.5
"""Seconds between two reports of progress."""

Result = TypeVar("Result")
Told: TypeAlias = Callable[[int, Path], None]


def workers() -> int:
    """Return the number of worker processes for this machine."""
    return min(MOST, os.cpu_count() or 1)


def _raised(wrong: BadChapter) -> NoReturn:
    raise wrong


def settled(
    paths: Sequence[Path],
    workers: int,
    told: Told = lambda done, path: None,
    failed: Callable[[BadChapter], None] = _raised,
) -> list[Entry]:
    """Return the statements that the derivations settle, in the order of the derivations.

    ``told`` receives the number of finished chapters and one that is running.  ``failed`` receives
    a chapter that cannot be run as soon as that is known; the others still run unless it raises.
    """
    found: dict[int, list[Entry]] = {}
    for i, result in each(of_derivation, paths, workers, told):
        if isinstance(result, BadChapter):
            failed(result)
        else:
            found[i] = result
    return [entry for i in sorted(found) for entry in found[i]]


def each(
    work: Callable[[Path], Result],
    paths: Sequence[Path],
    workers: int,
    told: Told = lambda done, path: None,
) -> Iterator[tuple[int, Result | BadChapter]]:
    """Yield the number and the result of each derivation as they finish."""
    shipped = folder().resolve()
    own = [i for i, path in enumerate(paths) if path.resolve().parent != shipped]
    waiting = [i for i in range(len(paths)) if i not in own]
    running: dict[Future[Result | BadChapter], int] = {}
    apart: dict[int, ProcessPoolExecutor] = {}
    done = 0
    with ExitStack() as pools:
        if waiting:
            pool = pools.enter_context(_pool(min(workers, len(waiting)), FORKED))
            pools.callback(pool.shutdown, cancel_futures=True)
            running = {pool.submit(_run, work, paths[i]): i for i in waiting}
        while running or own:
            while own and len(apart) < workers:
                i = own.pop(0)
                apart[i] = pools.enter_context(_pool(1, "spawn"))
                running[apart[i].submit(_run, work, paths[i])] = i
            told(done, paths[min(running.values())])
            for future in wait(running, PAUSE, FIRST_COMPLETED).done:
                i, done = running.pop(future), done + 1
                if i in apart:
                    apart.pop(i).shutdown()
                try:
                    yield i, future.result()
                except BrokenProcessPool:
                    yield i, BadChapter(paths[i], "its process ended without a result")


def _run(work: Callable[[Path], Result], path: Path) -> Result | BadChapter:
    """Work on one chapter, in a worker process."""
    try:
        return work(path)
    except BadChapter as wrong:
        return wrong
    except KeyboardInterrupt:  # raised by the chapter: the keyboard's does not reach a worker
        return BadChapter(path, "KeyboardInterrupt: no message")


def _pool(size: int, how: str) -> ProcessPoolExecutor:
    gc.freeze()
    return ProcessPoolExecutor(size, multiprocessing.get_context(how), _begin)


def _begin() -> None:
    """Prepare a worker: it ends with its parent, and what a chapter prints goes to stderr."""
    end_with_parent()
    gc.set_threshold(SELDOM)
    os.dup2(2, 1)

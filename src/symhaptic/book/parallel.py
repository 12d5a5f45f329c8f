"""Run derivations side by side, each chapter of a user's own in a process of its own.

The package's chapters share a few worker processes, which keep the lemmas that they derive.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from multiprocessing.connection import Connection, wait
from multiprocessing.context import ForkContext, SpawnContext
from pathlib import Path
from typing import Generic, NoReturn, TypeAlias, TypeVar

from symhaptic.book import SELDOM
from symhaptic.book.chapters import BadChapter, folder
from symhaptic.book.ledger import Entry, of_derivation
from symhaptic.book.processes import end_with_parent

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""

_FORKED = sys.platform.startswith("linux")
"""A forked worker has imported SymPy already; elsewhere than on Linux forking is not safe."""

_CONTEXT: ForkContext | SpawnContext = (
    multiprocessing.get_context("fork") if _FORKED else multiprocessing.get_context("spawn")
)

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
    jobs = [*own, *(i for i in range(len(paths)) if i not in own)]
    gc.freeze()
    with ExitStack() as ends:
        # all are forked here: later a progress bar has a thread, whose locks a fork would copy
        alone = {i: _Worker(work, ends) for i in own}
        count = min(workers, len(paths) - len(own))
        idle = [_Worker(work, ends, len(paths) * k // count) for k in range(count)]
        running: dict[Connection, tuple[int, _Worker[Result]]] = {}
        while running or jobs:
            while jobs and len(running) < workers:
                i = jobs[0]
                worker = alone[i] if i in alone else idle.pop()
                if i not in alone:
                    i = worker.near(jobs)
                jobs.remove(i)
                running[worker.give(paths[i])] = i, worker
            told(len(paths) - len(jobs) - len(running), paths[min(i for i, _ in running.values())])
            ready = wait(list(running), PAUSE)
            for pipe in [one for one in running if one in ready]:
                i, worker = running.pop(pipe)
                result = worker.result(paths[i])
                if i in alone:
                    worker.end()
                else:
                    idle.append(worker if worker.process.is_alive() else _Worker(work, ends, i))
                yield i, result


class _Worker(Generic[Result]):
    """A process that works on chapters, one after the other."""

    def __init__(self, work: Callable[[Path], Result], ends: ExitStack, first: int = 0) -> None:
        self.last = first
        self.pipe, self._theirs = _CONTEXT.Pipe()
        self.process = _CONTEXT.Process(target=_serve, args=(work, self._theirs))
        ends.callback(self.end)
        if _FORKED:
            self._start()

    def _start(self) -> None:
        self.process.start()
        self._theirs.close()

    def near(self, jobs: Sequence[int]) -> int:
        """Return the next chapter after its last one, because neighbours share lemmas."""
        self.last = next((i for i in jobs if i >= self.last), jobs[0])
        return self.last

    def give(self, path: Path) -> Connection:
        """Begin with a chapter, and return what will be readable at its end."""
        if self.process.pid is None:
            self._start()
        self.pipe.send(path)
        return self.pipe

    def result(self, path: Path) -> Result | BadChapter:
        try:
            found: Result | BadChapter = self.pipe.recv()
        except EOFError:
            self.end()
            found = BadChapter(path, "its process ended without a result")
        return found

    def end(self) -> None:
        if self.process.pid is not None:
            self.process.kill()
            self.process.join()


def _serve(work: Callable[[Path], Result], pipe: Connection) -> None:
    """Work on the chapters that come through a pipe; what they print goes to stderr."""
    end_with_parent()
    gc.set_threshold(SELDOM)
    os.dup2(2, 1)
    while True:
        pipe.send(_run(work, pipe.recv()))


def _run(work: Callable[[Path], Result], path: Path) -> Result | BadChapter:
    """Work on one chapter, in a worker process."""
    try:
        return work(path)
    except BadChapter as wrong:
        return wrong
    except KeyboardInterrupt:  # raised by the chapter: the keyboard's does not reach a worker
        return BadChapter(path, "KeyboardInterrupt: no message")

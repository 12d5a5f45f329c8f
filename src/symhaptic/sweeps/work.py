"""Who computes: threads, processes, or any executor of ``concurrent.futures``."""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    Executor,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from contextlib import contextmanager
from itertools import islice
from typing import Any

from symhaptic.book.processes import end_with_parent
from symhaptic.notation.quantities import shown
from symhaptic.sweeps.plan import Piece

_AT_ONCE = 1024
"""Blocks that are submitted at a time, so that a sweep of a million blocks needs little memory."""


_KILLED = (
    "a worker process was killed or could not start; where memory is short, give fewer workers or "
    'smaller chunks; a script needs `if __name__ == "__main__":` around its sweep; the same call '
    "continues with the blocks that are not finished if it has to="
)


@contextmanager
def executor(on: Any, workers: int | None) -> Iterator[Executor]:
    """Threads, processes, a client of Dask's, or the user's own executor, which stays open."""
    if workers is not None and (not isinstance(workers, int) or workers < 1):
        raise ValueError(f"workers: {shown(workers)} is not allowed; give whole numbers > 0")
    if on in ("threads", "processes"):
        if workers is None:
            from dask.system import CPU_COUNT

            workers = CPU_COUNT
        made: Executor = ThreadPoolExecutor(workers)
        context = multiprocessing.get_context("spawn")  # a forked process may inherit locked locks
        watched, held = context.Pipe(duplex=False)
        if on == "processes":
            made = ProcessPoolExecutor(workers, context, end_with_parent, (watched,))
        finished = False
        try:
            yield made
            finished = True
        finally:
            if not finished:
                held.close()  # the worker processes end at once
            made.shutdown(cancel_futures=True)
            held.close()
            watched.close()
        return
    if workers is not None:
        raise ValueError(f"workers: {shown(on)} has its own workers; leave workers={workers!r} out")
    if hasattr(on, "get_executor"):
        client = on.get_executor(pure=False)
        try:
            yield client
        finally:
            client.shutdown(wait=False)  # only its hold of what is done
    elif isinstance(on, Executor):
        yield on
    else:
        raise ValueError(
            f"on: {shown(on)} is not allowed; give 'threads', 'processes', a client of "
            "dask.distributed or an executor of concurrent.futures"
        )


def done(
    pool: Executor, work: Callable[[Piece], Any], pieces: Iterable[Piece], count: int, total: int
) -> Iterator[Any]:
    """The results in the order in which they are finished; the first error is raised at once.

    On a terminal a bar shows how many blocks of ``total`` are done, ``count`` of which are to do.
    """
    with _bar(total - count, total) as advance:
        waiting = iter(pieces)
        futures = {pool.submit(work, piece) for piece in islice(waiting, _AT_ONCE)}
        try:
            while futures:
                ready, futures = wait(futures, return_when=FIRST_COMPLETED)
                futures |= {pool.submit(work, piece) for piece in islice(waiting, len(ready))}
                for future in ready:
                    try:
                        found = future.result()
                    except BrokenExecutor:
                        raise BrokenExecutor(_KILLED) from None
                    yield found
                    advance()
        finally:
            for future in futures:
                future.cancel()


@contextmanager
def _bar(begun: int, total: int) -> Iterator[Callable[[], Any]]:
    if not sys.stderr.isatty():
        yield lambda: None
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    columns = (TextColumn("sweep"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("sweep", completed=begun, total=total)
        yield lambda: progress.advance(task)

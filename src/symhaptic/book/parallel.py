"""Derivations side by side, each in a process of its own that has run nothing else before.

What one chapter changes in the package, the next does not see.  Where processes can be forked, a
chapter's is a copy of one that has run the package's own code only; elsewhere it starts from
nothing.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import pickle
import signal
import sys
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from multiprocessing.context import BaseContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import NoReturn, TypeVar

from symhaptic.book.arrivals import arrived as read
from symhaptic.book.beforehand import Beforehand
from symhaptic.book.chapters import BadChapter, untouched
from symhaptic.book.ledger import Entry, of_derivation

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""

SELDOM = 200_000
"""Objects made after which a derivation's process looks for cycles of them; SymPy makes few."""

BEHIND = 5
"""How far a derivation's process stands back: who derives anew what arrives is never waited for."""

PAUSE = 0.5
"""Seconds after which who waits is told again what is under way."""

Result = TypeVar("Result")
Told = Callable[[int, Path], None]


def workers() -> int:
    """How many processes are worth while here."""
    return min(MOST, os.cpu_count() or 1)


def _raised(wrong: BadChapter) -> NoReturn:
    raise wrong


def settled(
    paths: Sequence[Path],
    workers: int,
    told: Told = lambda done, path: None,
    failed: Callable[[BadChapter], None] = _raised,
) -> list[Entry]:
    """The statements that the derivations settle, in the order of the derivations.

    ``told`` hears how many are done and which one is under way, ``failed`` at once of one that
    cannot be run; the others are run all the same, unless ``failed`` raises, as it does if not
    given.
    """
    found: dict[int, list[Entry]] = {}
    for i, result in each(of_derivation, paths, workers, told):
        if isinstance(result, BadChapter):
            failed(result)
        else:
            found[i] = result
            for entry in result:
                entry.looked_at()
    return [entry for i in sorted(found) for entry in found[i]]


def each(
    work: Callable[[Path], Result],
    paths: Sequence[Path],
    workers: int,
    told: Told = lambda done, path: None,
) -> Iterator[tuple[int, Result | BadChapter]]:
    """What becomes of each derivation, with its number, as they end.

    They begin in their order, but for those that share a lemma which is not derived yet: these
    wait, while others run.  What arrives is derived anew here once the next is under way.
    """
    context = _context()
    lemmas = Beforehand(paths) if context.get_start_method() == "fork" else None
    waiting, done = list(range(len(paths))), 0
    running, arrived = dict[Connection, tuple[int, BaseProcess]](), deque[tuple[int, bytes]]()
    before = gc.get_threshold()
    gc.set_threshold(SELDOM)
    try:
        while done < len(paths):
            while len(running) < workers:
                number = next((n for n in waiting if lemmas is None or lemmas.ready(n)), None)
                if number is None:
                    break
                waiting.remove(number)
                connection, process = _begin(context, work, paths[number])
                running[connection] = number, process
            under_way = [number for number, _ in running.values()] or waiting or [len(paths) - 1]
            told(done, paths[min(under_way)])
            starving = bool(waiting) and len(running) < workers
            busy = lemmas is not None and (starving or not arrived) and lemmas.derive()
            if arrived and not busy:
                number, sent = arrived.popleft()
                done += 1
                yield number, read(sent, paths[number])
            for ready in wait(list(running), 0 if busy or arrived else PAUSE):
                assert isinstance(ready, Connection)
                number, process = running.pop(ready)
                arrived.append((number, _sent(ready, process, paths[number])))
    finally:
        gc.set_threshold(*before)
        gc.unfreeze()
        for connection, (_, process) in running.items():
            process.kill()
            process.join()
            connection.close()


def _context() -> BaseContext:
    """Forked where that is safe and nothing was left behind by a chapter; spawned elsewhere."""
    fork = sys.platform.startswith("linux") and untouched()
    return multiprocessing.get_context("fork" if fork else "spawn")


def _begin(
    context: BaseContext, work: Callable[[Path], Result], path: Path
) -> tuple[Connection, BaseProcess]:
    gc.freeze()  # what is there stays, and is not looked through again in the process
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_child, args=(work, path, theirs), daemon=True)  # type: ignore[attr-defined]
    process.start()
    theirs.close()
    return ours, process


def _child(work: Callable[[Path], Result], path: Path, connection: Connection) -> None:
    """What the process of a derivation does; who started it ends it when interrupted."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.set_threshold(SELDOM)
    if hasattr(os, "nice"):
        os.nice(BEHIND)
    result: Result | BadChapter
    try:
        result = work(path)
    except BadChapter as wrong:
        result = BadChapter(*wrong.args)
    sys.stderr.flush()
    connection.send(result)


def _sent(connection: Connection, process: BaseProcess, path: Path) -> bytes:
    """What the process of a derivation has sent; it ends."""
    try:
        sent = connection.recv_bytes()
    except EOFError:
        process.join()
        what = f"its process ended without a result (exit status {process.exitcode})"
        sent = pickle.dumps(BadChapter(path, what))
    connection.close()
    process.join(PAUSE)
    if process.is_alive():
        process.kill()
        process.join()
    return sent

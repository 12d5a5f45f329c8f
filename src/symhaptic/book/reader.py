"""What a reader does: it has chapters run, one by one, and reads what they send.

A reader is a process that runs the package's own code only.  It derives the lemmas that a chapter
takes from the package, starts the chapter's process, and derives anew what that sends.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.context import BaseContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any

from symhaptic.book import SELDOM
from symhaptic.book.arrivals import Places, arrived, places, sent, without_text
from symhaptic.book.beforehand import Beforehand
from symhaptic.book.chapters import BadChapter, Said, keep, untouched
from symhaptic.book.ledger import NoEntries
from symhaptic.proof.theorems.kernel import Theorem, at_hand

GRACE = 0.5
"""Seconds after which a process that has nothing left to say has to end."""


def context() -> BaseContext:
    """Forked where that is safe and nothing was left behind by a chapter; spawned elsewhere."""
    fork = sys.platform.startswith("linux") and untouched()
    return multiprocessing.get_context("fork" if fork else "spawn")


def ended(process: BaseProcess, path: Path) -> BadChapter:
    """What is said of a chapter whose process ended by itself."""
    what = f"its process ended without a result (exit status {process.exitcode})"
    return BadChapter(path, what)


def reads(
    work: Callable[[Path], Any],
    then: Callable[[Any], Any],
    paths: Sequence[Path],
    lemmas: Beforehand | None,
    sources: Mapping[Path, Said],
    asked: Connection,
    not_its_own: Sequence[Connection],
) -> None:
    """Have chapters run, one by one as they are asked for, until nobody asks."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # who started it ends it when interrupted
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    gc.set_threshold(SELDOM)
    for connection in not_its_own:
        connection.close()
    for folder, said in sources.items():
        keep(folder, said)
    how = context()
    if lemmas is None and how.get_start_method() == "fork":
        lemmas = Beforehand(paths)
    known: Sequence[Theorem] = ()
    there = places(known)
    while True:
        try:
            number = asked.recv()
        except EOFError:
            return
        if lemmas is not None and lemmas.derive(number):
            known = at_hand()
            there = places(known)  # so that the chapter's process need not touch each theorem
        result = _of_chapter(how, work, paths[number], known, there, asked)
        try:
            with without_text():
                found = result if isinstance(result, BadChapter) else then(result)
        except NoEntries as wrong:
            found = BadChapter(paths[number], f"what its process sent is no result: {wrong}")
        asked.send_bytes(sent(found))


def _of_chapter(
    how: BaseContext,
    work: Callable[[Path], Any],
    path: Path,
    known: Sequence[Theorem],
    there: Places,
    asked: Connection,
) -> Any:
    """What arrives from a chapter that runs in a process of its own, derived anew."""
    gc.freeze()
    ours, theirs = how.Pipe(duplex=False)
    not_its_own = (ours, asked) if how.get_start_method() == "fork" else ()
    process = how.Process(  # type: ignore[attr-defined]
        target=_child, args=(work, path, theirs, there, not_its_own), daemon=True
    )
    process.start()
    gc.unfreeze()
    theirs.close()
    try:
        came = ours.recv_bytes()
        return arrived(came, path, known)
    except EOFError:
        process.join()
        return ended(process, path)
    finally:
        process.join(GRACE)
        if process.is_alive():
            process.kill()
            process.join()
        ours.close()


def _child(
    work: Callable[[Path], Any],
    path: Path,
    connection: Connection,
    known: Places,
    not_its_own: Sequence[Connection],
) -> None:
    """What the process of a chapter does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    gc.set_threshold(SELDOM)
    for other in not_its_own:
        other.close()
    with suppress(OSError):
        os.dup2(2, 1)  # what it writes is for people, not part of a listing
    result: Any
    try:
        result = work(path)
    except BadChapter as wrong:
        result = BadChapter(*wrong.args)
    except KeyboardInterrupt:  # its own: that of the keyboard does not come here
        result = BadChapter(path, "KeyboardInterrupt: no message")
    sys.stderr.flush()
    connection.send_bytes(sent(result, known))

"""Derivations side by side, each in a process of its own: nothing that one does reaches another."""

from __future__ import annotations

import multiprocessing
import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

from symhaptic.ledger import Entry, of_derivation
from symhaptic.library import BadChapter

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""


@dataclass
class Outcome:
    """What became of one derivation: its statements, or why there are none."""

    path: Path
    entries: list[Entry] = field(default_factory=list)
    error: str | None = None


def workers() -> int:
    """How many processes are worth while here."""
    return min(MOST, os.cpu_count() or 1)


def settled(
    paths: Sequence[Path],
    workers: int,
    told: Callable[[int, Path], None] = lambda done, path: None,
) -> list[Outcome]:
    """What the derivations settle, in their order.

    ``told`` hears how many are done and which one is under way.  What goes wrong in one is said in
    its outcome; the others go on.
    """
    # a child that is forked has the package in memory, and no chapter that ran before
    forked = sys.platform.startswith("linux")
    context: Any = multiprocessing.get_context("fork" if forked else "spawn")
    outcomes = [Outcome(path) for path in paths]
    waiting = list(range(len(paths)))
    active: dict[Connection, tuple[int, multiprocessing.process.BaseProcess]] = {}
    try:
        while waiting or active:
            while waiting and len(active) < workers:
                i = waiting.pop(0)
                ours, theirs = context.Pipe(duplex=False)
                child = context.Process(target=_settle, args=(paths[i], theirs), daemon=True)
                child.start()
                theirs.close()
                active[ours] = (i, child)
            done = len(paths) - len(waiting) - len(active)
            told(done, paths[min(i for i, _ in active.values())])
            for ready in wait(list(active)):
                assert isinstance(ready, Connection)
                i, child = active.pop(ready)
                _received(outcomes[i], ready, child)
    finally:
        for _, child in active.values():
            child.terminate()
    return outcomes


def _received(
    outcome: Outcome, ready: Connection, child: multiprocessing.process.BaseProcess
) -> None:
    """What a child has to say; one that ended without a word is told of."""
    try:
        found = ready.recv()
        if isinstance(found, str):
            outcome.error = found
        else:
            outcome.entries = found
    except EOFError:
        child.join()
        outcome.error = f"{outcome.path}: its process ended with status {child.exitcode}"
    ready.close()
    child.join()


def _settle(path: Path, out: Connection) -> None:
    try:
        out.send(of_derivation(path))
    except BadChapter as wrong:
        out.send(str(wrong))
    out.close()

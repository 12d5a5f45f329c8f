"""Derivations side by side, each in a process of its own that has run nothing else before.

What one chapter changes in the package, the next does not see.  A few *readers*
(:mod:`symhaptic.book.reader`) start the chapters' processes, and what they find of what these send
goes to who asked.  Where processes can be forked a chapter's is a copy of its reader, elsewhere it
starts from nothing.
"""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from multiprocessing.connection import Connection, wait
from multiprocessing.context import BaseContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any, NoReturn, TypeAlias, TypeVar

from symhaptic.book.arrivals import arrived
from symhaptic.book.beforehand import Beforehand, Lemma
from symhaptic.book.chapters import (
    BadChapter,
    keep,
    known_sources,
    said_beside,
    source,
)
from symhaptic.book.ledger import Entry, looked_at, of_derivation
from symhaptic.book.reader import context, ended, reads
from symhaptic.paper.statement import Source

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""

PAUSE = 0.5
"""Seconds after which who waits is told again what is under way."""

Result = TypeVar("Result")
Found = TypeVar("Found")
Told: TypeAlias = Callable[[int, Path], None]


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
    for i, result in each(of_derivation, paths, workers, told, looked_at):
        if isinstance(result, BadChapter):
            failed(result)
        else:
            found[i] = [replace(entry, derivation=source(paths[i])) for entry in result]
    return [entry for i in sorted(found) for entry in found[i]]


def source_apart(path: Path) -> Source | None:
    """The source in whose folder a chapter stands, read in a process of its own, if it is one.

    Raises :class:`BadChapter` with what is wrong with its ``source.py``.
    """
    folder = path.resolve().parent
    if folder not in known_sources():
        for _, said in each(said_beside, [path], 1):
            if isinstance(said, BadChapter):
                raise said
            return None if said is None else keep(folder, said)
    return known_sources()[folder][0]


def _itself(result: Any) -> Any:
    return result


def each(
    work: Callable[[Path], Result],
    paths: Sequence[Path],
    workers: int,
    told: Told = lambda done, path: None,
    then: Callable[[Result], Found] = _itself,
) -> Iterator[tuple[int, Found | BadChapter]]:
    """What becomes of each derivation, with its number, as they end.

    ``work`` is done in the chapter's process, and ``then`` in its reader with what arrives of it.
    They begin in their order, but for those of which another reader has derived a lemma already.
    """
    how = context()
    lemmas = Beforehand(paths) if how.get_start_method() == "fork" else None
    waiting, done = list(range(len(paths))), 0
    readers: list[_Reader] = []
    try:
        while done < len(paths):
            while waiting and len(readers) < min(workers, len(paths)):
                readers.append(_begun(how, work, then, paths, lemmas, readers))
            for reader in readers:
                if waiting and reader.busy is None:
                    reader.busy = _next(waiting, reader, readers, lemmas)
                    waiting.remove(reader.busy)
                    reader.connection.send(reader.busy)
            busy = {reader.connection: reader for reader in readers if reader.busy is not None}
            told(done, paths[min(reader.busy or 0 for reader in busy.values())])
            for ready in wait(list(busy), PAUSE):
                assert isinstance(ready, Connection)
                reader = busy[ready]
                number, reader.busy = reader.busy, None
                assert number is not None
                done += 1
                found = reader.found(paths[number])
                if reader.gone:
                    readers.remove(reader)
                yield number, found
    finally:
        for reader in readers:
            reader.end()


@dataclass
class _Reader:
    """A process that reads what chapters send, and the chapter that it has in hand."""

    process: BaseProcess
    connection: Connection
    busy: int | None = None
    lemmas: set[Lemma] = field(default_factory=set)
    gone: bool = False

    def found(self, path: Path) -> Any:
        """What it says of a chapter; that it ended, if it did."""
        try:
            return arrived(self.connection.recv_bytes(), path)
        except EOFError:
            self.gone = True
            self.end()
            return ended(self.process, path)

    def end(self) -> None:
        """Have it end, and its chapter with it."""
        self.process.terminate()
        self.process.join()
        self.connection.close()


def _begun(
    how: BaseContext,
    work: Callable[[Path], Any],
    then: Callable[[Any], Any],
    paths: Sequence[Path],
    lemmas: Beforehand | None,
    others: Sequence[_Reader],
) -> _Reader:
    gc.freeze()  # what is there stays, and is not looked through again in the process
    ours, theirs = how.Pipe()
    not_its_own = [ours, *(other.connection for other in others)] if lemmas else []
    process = how.Process(  # type: ignore[attr-defined]
        target=reads,
        args=(work, then, paths, lemmas, known_sources(), theirs, not_its_own),
    )
    process.start()
    gc.unfreeze()
    theirs.close()
    return _Reader(process, ours)


def _next(
    waiting: Sequence[int], reader: _Reader, readers: Sequence[_Reader], lemmas: Beforehand | None
) -> int:
    """The chapter that a reader takes in hand."""
    if lemmas is None:
        return waiting[0]
    elsewhere = set[Lemma]().union(*(other.lemmas for other in readers if other is not reader))
    number = lemmas.next(waiting, reader.lemmas, elsewhere)
    reader.lemmas.update(lemmas.lemmas[number])
    return number

"""Derivations side by side, each in a process of its own that has run nothing else before.

What one chapter changes in the package, the next does not see.  A few processes that run the
package's own code only, the *readers*, derive the lemmas that a chapter takes from the package,
start the chapter's process, and derive anew what it sends; what they find of it goes to who asked.
Where processes can be forked a chapter's is a copy of its reader, elsewhere it starts from nothing.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from multiprocessing.context import BaseContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any, NoReturn, TypeAlias, TypeVar

from symhaptic.book.arrivals import arrived, sent
from symhaptic.book.beforehand import Beforehand, Lemma
from symhaptic.book.chapters import (
    BadChapter,
    Said,
    keep,
    known_sources,
    said_beside,
    untouched,
)
from symhaptic.book.ledger import Entry, looked_at, of_derivation
from symhaptic.paper.statement import Source
from symhaptic.proof.theorems.kernel import Theorem, at_hand

MOST = 4
"""Workers unless told otherwise: each has a computer algebra system in memory."""

SELDOM = 200_000
"""Objects made after which a process looks for cycles of them; SymPy makes few."""

PAUSE = 0.5
"""Seconds after which who waits is told again what is under way, and that a process has to end."""

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
            found[i] = result
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
    context = _context()
    lemmas = Beforehand(paths) if context.get_start_method() == "fork" else None
    waiting, done = list(range(len(paths))), 0
    readers: list[_Reader] = []
    try:
        while done < len(paths):
            while waiting and len(readers) < min(workers, len(paths)):
                readers.append(_begun(context, work, then, paths, lemmas, readers))
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


def _context() -> BaseContext:
    """Forked where that is safe and nothing was left behind by a chapter; spawned elsewhere."""
    fork = sys.platform.startswith("linux") and untouched()
    return multiprocessing.get_context("fork" if fork else "spawn")


# -- readers, seen from outside --------------------------------------------------------


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
            return _ended(self.process, path)

    def end(self) -> None:
        """Have it end, and its chapter with it."""
        self.process.terminate()
        self.process.join()
        self.connection.close()


def _ended(process: BaseProcess, path: Path) -> BadChapter:
    what = f"its process ended without a result (exit status {process.exitcode})"
    return BadChapter(path, what)


def _begun(
    context: BaseContext,
    work: Callable[[Path], Any],
    then: Callable[[Any], Any],
    paths: Sequence[Path],
    lemmas: Beforehand | None,
    others: Sequence[_Reader],
) -> _Reader:
    gc.freeze()  # what is there stays, and is not looked through again in the process
    ours, theirs = context.Pipe()
    not_its_own = [ours, *(other.connection for other in others)] if lemmas else []
    process = context.Process(  # type: ignore[attr-defined]
        target=_reads,
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


# -- what a reader does ----------------------------------------------------------------


def _reads(
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
    context = _context()
    if lemmas is None and context.get_start_method() == "fork":
        lemmas = Beforehand(paths)
    while True:
        try:
            number = asked.recv()
        except EOFError:
            return
        if lemmas is not None:
            lemmas.derive(number)
        known = at_hand() if lemmas is not None else []
        result = _of_chapter(context, work, paths[number], known, asked)
        found = result if isinstance(result, BadChapter) else then(result)
        asked.send_bytes(sent(found))


def _of_chapter(
    context: BaseContext,
    work: Callable[[Path], Any],
    path: Path,
    known: Sequence[Theorem],
    asked: Connection,
) -> Any:
    """What arrives from a chapter that runs in a process of its own, derived anew."""
    gc.freeze()
    ours, theirs = context.Pipe(duplex=False)
    not_its_own = (ours, asked) if context.get_start_method() == "fork" else ()
    process = context.Process(  # type: ignore[attr-defined]
        target=_child, args=(work, path, theirs, known, not_its_own), daemon=True
    )
    process.start()
    gc.unfreeze()
    theirs.close()
    try:
        came = ours.recv_bytes()
        return arrived(came, path, known)
    except EOFError:
        process.join()
        return _ended(process, path)
    finally:
        process.join(PAUSE)
        if process.is_alive():
            process.kill()
            process.join()
        ours.close()


def _child(
    work: Callable[[Path], Any],
    path: Path,
    connection: Connection,
    known: Sequence[Theorem],
    not_its_own: Sequence[Connection],
) -> None:
    """What the process of a chapter does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    gc.set_threshold(SELDOM)
    for other in not_its_own:
        other.close()
    result: Any
    try:
        result = work(path)
    except BadChapter as wrong:
        result = BadChapter(*wrong.args)
    sys.stderr.flush()
    connection.send_bytes(sent(result, known))

"""Chapters that are asked together on what they rest.

Rocq takes as long to list the axioms of one chapter as of twenty.  Asked together they rest on what
is listed, which is more than each of them needs to; so only those are of which the record has the
same axioms of the library.  One of which this gives anything else than the record has is asked
alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from symhaptic.book.foreign import LIBRARY
from symhaptic.rocq.compiled import NoRocq, Taken, listed
from symhaptic.rocq.outcome import Outcome


def groups(chapters: Mapping[str, Iterable[str]], known: Mapping[str, Any]) -> list[list[str]]:
    """Chapters of whose statements a record says that they rest on the same, the others alone.

    >>> known = {id: {"rests": [*LIBRARY]} for id in ("eq1", "eq2")} | {"eq4": {"rests": ["mine"]}}
    >>> chapters = {"a": ["eq1"], "b": ["eq2", "eq4"], "c": ["eq3", "mine"]}
    >>> groups(chapters, {"statements": known})
    [['a', 'b'], ['c']]
    """
    found: dict[object, list[str]] = {}
    for name, ids in chapters.items():
        found.setdefault(_shared(ids, known) or name, []).append(name)
    return [*found.values()]


def _shared(ids: Iterable[str], known: Mapping[str, Any]) -> frozenset[str]:
    """The axioms of the library on which statements rest by a record.

    Nothing where the record does not have them all.
    """
    statements = [known["statements"].get(id) for id in ids]
    if None in statements:
        return frozenset()
    return frozenset(name for said in statements for name in said["rests"] if name in LIBRARY)


def asked(
    taken: Sequence[Taken],
    folder: Path,
    known: Mapping[str, Any],
    workers: int = 1,
    told: Callable[[int, Path], None] = lambda done, path: None,
) -> dict[str, Outcome]:
    """What Rocq says of chapters that it has taken, by their names."""
    found: dict[str, Outcome] = {}
    named = {one.outcome.chapter: one for one in taken}
    alike = groups({name: one.file.statements for name, one in named.items()}, known)
    with ThreadPoolExecutor(workers) as pool, ExitStack() as stack:
        stack.callback(pool.shutdown, wait=False, cancel_futures=True)
        running = [
            pool.submit(_asked, [named[name] for name in names], folder, known) for names in alike
        ]
        for done in as_completed(running):
            found |= {one.chapter: one for one in done.result()}
            told(len(found), folder / next(reversed(found)))
    return found


def _asked(group: Sequence[Taken], folder: Path, known: Mapping[str, Any]) -> list[Outcome]:
    """The same of one group; of each alone where Rocq does not list what it rests on."""
    if len(group) == 1:
        return [group[0].alone()]
    try:
        said = listed(folder, [one.module for one in group])
    except NoRocq:
        return [one.alone() for one in group]
    return [_as_recorded(one, one.rests_on(said, group), known) for one in group]


def _as_recorded(one: Taken, found: Outcome, known: Mapping[str, Any]) -> Outcome:
    """What was found with others, or alone where that is not what is recorded."""
    recorded = {id: known["statements"][id]["rests"] for id in one.file.statements}
    return found if {id: found.rules(id) for id in recorded} == recorded else one.alone()

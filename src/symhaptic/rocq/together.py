"""Chapters that are asked together on what they rest.

Rocq takes as long to list the axioms of one chapter as of twenty.  Asked together they rest on what
is listed, which is more than each of them needs to; so only those are of which the record has the
same predicates, rules of a prelude and axioms of the library.  Where Rocq lists anything else of
these, each is asked alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any

from symhaptic.book.foreign import INTEGERS, REALS
from symhaptic.rocq.assumptions import axioms, rule_of
from symhaptic.rocq.compiled import Outcome, Taken, listed
from symhaptic.rocq.preludes import known_there, meant


def groups(taken: Iterable[Taken], known: dict[str, Any]) -> list[list[Taken]]:
    """Chapters of which a record says that they rest on the same, the others alone.

    >>> groups([], {"statements": {}})
    []
    """
    found: dict[object, list[Taken]] = {}
    for one in taken:
        rests = expected(one, known)
        found.setdefault(rests or one.module, []).append(one)
    return [*found.values()]


def expected(one: Taken, known: dict[str, Any]) -> frozenset[str]:
    """What a chapter rests on by a record, of what others may rest on, too."""
    statements = [known["statements"].get(id, {}) for id in one.file.statements]
    if any(one.get("checked") is None for one in statements):
        return frozenset()
    return _common() & frozenset(name for said in statements for name in said["rests"])


def _common() -> frozenset[str]:
    return frozenset(map(rule_of, meant() | known_there())) | {REALS, INTEGERS}


def asked(
    taken: Sequence[Taken],
    folder: Path,
    known: dict[str, Any],
    workers: int = 1,
    told: Callable[[int, Path], None] = lambda done, path: None,
) -> dict[str, Outcome]:
    """What Rocq says of chapters that it has taken, by their names."""
    found: dict[str, Outcome] = {}
    with ThreadPoolExecutor(workers) as pool:
        for done in as_completed(
            [pool.submit(_asked, group, folder, known) for group in groups(taken, known)]
        ):
            found |= {one.chapter: one for one in done.result()}
            told(len(found), folder / next(reversed(found)))
    return found


def _asked(group: Sequence[Taken], folder: Path, known: dict[str, Any]) -> list[Outcome]:
    """The same of one group."""
    said = listed(folder, [one.module for one in group])
    if len(group) > 1 and _common() & set(map(rule_of, axioms(said))) != expected(group[0], known):
        return [one.rests_on(listed(folder, [one.module])) for one in group]
    return [one.rests_on(said, group) for one in group]

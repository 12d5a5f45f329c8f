"""The committed ledger: every statement with its verdict in JSON, and what differs from it now."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from symhaptic.book.ledger import Entry
from symhaptic.proof.settle import ACCEPTED
from symhaptic.proof.verdict import Kind

GENERATED = "written by `symhaptic report`; do not edit"


def committed(entries: Iterable[Entry]) -> str:
    """The ledger as committed text: no times, so that it is the same from run to run.

    What Rocq says stands in its own record.
    """
    left_out = ("seconds", "rocq")
    records = [{k: v for k, v in e.as_json().items() if k not in left_out} for e in entries]
    data = {"generated": GENERATED, "statements": records}
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


class NoLedger(ValueError):
    """A file that is not a ledger; the message is one line that names it."""

    def __init__(self, path: Path, what: str) -> None:
        super().__init__(f"{path}: {what}; `symhaptic verify --format json -o` writes a ledger")


def records(path: Path) -> list[dict[str, Any]]:
    """The records of a committed ledger, one for each statement.

    Raises :class:`NoLedger` for anything else: no file, no JSON, a record without an id or a known
    verdict, or two records with one id.
    """
    if not path.is_file():
        raise NoLedger(path, "is a folder" if path.is_dir() else "is no file")
    try:
        text = path.read_text(encoding="utf-8")
        data = json.loads(text, parse_constant=_no_number, object_pairs_hook=_object)
        found = [dict(record) for record in data["statements"]]
        for record in found:
            Kind(record["verdict"])
            if not isinstance(record["id"], str):
                raise TypeError
        counts = Counter(record["id"] for record in found)
    except (ValueError, KeyError, TypeError, RecursionError) as wrong:
        raise NoLedger(path, "is no ledger") from wrong
    for id, count in counts.items():
        if count > 1:
            raise NoLedger(path, f"has the id {id!r} {count} times; give one record of each")
    return found


def _no_number(text: str) -> Any:
    raise ValueError(f"{text} is no number in JSON")


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise ValueError("a key stands twice")
    return found


def expected(path: Path) -> dict[str, str]:
    """The committed verdict of each statement."""
    return {r["id"]: r["verdict"] for r in records(path)}


def places(path: Path) -> dict[str, str]:
    """The derivation of each statement, as far as the committed ledger tells."""
    return {r["id"]: r["derivation"] for r in records(path) if r.get("derivation")}


def surprises(entries: Iterable[Entry], known: dict[str, str], whole: bool = True) -> list[str]:
    """Statements whose verdict is not the committed one; new ones of one's own have to hold.

    In a ``whole`` ledger each of the committed ones is there.
    """
    entries = list(entries)
    gone = set(known) - {entry.statement.id for entry in entries} if whole else set()
    lines = [f"{id}: nothing, but the ledger says {known[id]}" for id in sorted(gone)]
    for entry in entries:
        id, kind = entry.statement.id, str(entry.verdict.kind)
        if entry.own and id not in known:
            if entry.verdict.kind not in ACCEPTED | {Kind.EXTERNAL}:
                lines.append(f"{id}: {entry.verdict}; a statement of one's own is to hold")
        elif kind != known.get(id):
            lines.append(f"{id}: {kind}, but the ledger says {known.get(id, 'nothing')}")
    return lines


_SAID = {
    "statement": "print",
    "proposition": "proposition",
    "definitions": "list of definitions",
    "condition": "condition",
    "corrected": "correction",
    "counterexample": "counterexample",
}
"""What a record says beside its verdict, and how it is called."""


def reworded(entries: Iterable[Entry], path: Path) -> list[str]:
    """Statements of which what is said is not what is committed.

    A misprint that becomes another one has the same verdict.
    """
    committed, lines = {r["id"]: r for r in records(path)}, []
    for entry in entries:
        id, said = entry.statement.id, entry.as_json()
        known = committed.get(id, {})
        lines += [
            f"{id}: the {called} is {said[name]}, but the ledger says {known.get(name, 'nothing')}"
            for name, called in _SAID.items()
            if id in committed and (name not in known or known[name] != said[name])
        ]
    return lines


UNPROVED = frozenset({Kind.EXTERNAL, Kind.SLIP, Kind.UNDECIDED})
"""Verdicts that no theorem gives: they rest on data outside, on a wrong name, or on nothing yet."""


def unproved(entries: Iterable[Entry], known: dict[str, str] | None) -> list[str]:
    """Statements that no theorem settles, where no ledger is to have them."""
    found = (e for e in entries if e.verdict.kind in UNPROVED)
    new = (e for e in found if known is None or (e.own and e.statement.id not in known))
    return [f"{e.statement.id}: {e.verdict.kind}, and no ledger says so" for e in new]

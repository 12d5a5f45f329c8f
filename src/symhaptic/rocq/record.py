"""What Rocq found, as the record that the ledger and the book read: `book.foreign` tells it."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from symhaptic.book.foreign import LEAVES, NOT, WHOLE, listed
from symhaptic.rocq.outcome import Outcome

GENERATED = "written by `symhaptic verify --rocq DIR --format json -o FILE`; do not edit"


def extent(said: str) -> str:
    """How far a statement is checked.

    >>> extent("whole"), extent("2 steps open: not checked: the rule gains")
    ('whole', 'leaves')
    """
    if said == "whole":
        return WHOLE
    return LEAVES if re.match(r"\d+ steps? open", said) else NOT


def why(said: str) -> str | None:
    """Why it is not checked further.

    >>> why("1 steps open: not checked: the rule gains")
    '1 step open: the rule gains'
    """
    if said == "whole":
        return None
    told = said.replace("not checked: ", "").removesuffix(".")
    return re.sub(r"^1 steps", "1 step", told)


KINDS = {
    "identities": ("identity",),
    "sums of products": ("combined", "factor"),
    "scalar enclosures": ("number", "broken"),
    "limits": ("tends",),
}
"""Leaves by what they are."""


def leaves(outcomes: Iterable[Outcome]) -> dict[str, list[int]]:
    """Of each kind of leaf how many were checked and how many there are; of boxes their pieces.

    >>> from symhaptic.rocq.outcome import Outcome
    >>> one = Outcome("mine", steps={"identity": [1, 2], "combined": [5, 5]}, pieces=[7, 9])
    >>> leaves([one, one])["identities"], leaves([one])["pieces of boxes"]
    ([2, 4], [7, 9])
    """
    outcomes = list(outcomes)
    counts = {
        kind: [one.steps.get(rule, [0, 0]) for one in outcomes for rule in rules]
        for kind, rules in KINDS.items()
    } | {"pieces of boxes": [one.pieces for one in outcomes]}
    return {
        kind: [sum(n) for n in zip((0, 0), *some, strict=True)] for kind, some in counts.items()
    }


def record(outcomes: Iterable[Outcome], rocq: str | None) -> dict[str, Any]:
    """All that was found, without times, so that it is the same from run to run."""
    outcomes = list(outcomes)
    checked, total = Counter[str](), Counter[str]()
    for one in outcomes:
        checked.update({rule: count[0] for rule, count in one.steps.items()})
        total.update({rule: count[1] for rule, count in one.steps.items()})
    return {
        "generated": GENERATED,
        "rocq": rocq,
        "statements": {
            id: {
                "checked": extent(said),
                "why": why(said),
                "rests": one.rules(id) if extent(said) != NOT else [],
                "says": one.says.get(id),
            }
            for one in outcomes
            for id, said in one.statements.items()
        },
        "steps": {rule: [checked[rule], total[rule]] for rule in sorted(total)},
        "leaves": leaves(outcomes),
        "chapters": {
            one.chapter: {"text": one.text, "leaves": one.leaves, "open": one.open}
            for one in outcomes
        },
    }


def text(found: Mapping[str, Any]) -> str:
    """A record as it is committed."""
    return json.dumps(found, indent=1, ensure_ascii=False) + "\n"


def differences(found: Mapping[str, Any], known: Mapping[str, Any]) -> list[str]:
    """Statements that Rocq has checked further, or not as far, or with more assumed, than recorded.

    Before them stand chapters of which it was given another text, the library included.

    >>> whole = {"checked": "whole", "rests": ["excluded middle"]}
    >>> found = {"statements": {"eq1": whole}, "chapters": {}}
    >>> differences(found, {"statements": {"eq1": {**whole, "rests": []}}, "chapters": {}})
    ['eq1: rests on excluded middle, which the record does not name']
    """
    lines = [
        f"{name}: its text, or the library that it imports, is not that of the record"
        for name, one in found["chapters"].items()
        for before in [known["chapters"].get(name, one)]
        if one["text"] != before["text"] and one["leaves"] == before["leaves"]
    ]
    for id, one in found["statements"].items():
        recorded = known["statements"].get(id, {})
        before = recorded.get("checked", "nothing")
        if one["checked"] != before:
            lines.append(f"{id}: {one['checked']}, but the record says {before}")
        elif more := [name for name in one["rests"] if name not in recorded.get("rests", ())]:
            lines.append(f"{id}: rests on {listed(more)}, which the record does not name")
    return lines


__all__ = ["differences", "extent", "leaves", "record", "text", "why"]

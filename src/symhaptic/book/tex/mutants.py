"""The committed outcome of `symhaptic mutants` as tables of the book."""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path
from typing import Any

from symhaptic.book.tex.words import literally, prose

KINDS = {
    "formula": "a sign, factor, exponent, index or function of a formula",
    "digit": "a digit of a number, or a sign in print",
    "negated": "a number's print that says the contrary",
    "claim": "a claim with a part changed, left out or turned round",
    "counterexample": "a counterexample left out",
    "grounds": "the example of the hypotheses left out",
}
"""Kinds of change, in the order of the columns."""


TOGETHER = 12
"""So many changes stand in a row of the table: no row is longer than a page."""

BREAK = r"\allowbreak{}"
_BREAKS = r"[-+*/ ,=()_]"


def mutants_listed(path: Path) -> dict[str, Any]:
    """What the template of the section needs; empty where nothing is committed."""
    if not path.is_file():
        return {}
    chapters = json.loads(path.read_text(encoding="utf-8"))["chapters"]
    rows, survivors, total = [], [], Counter[str]()
    for name, record in chapters.items():
        counted = [*record["statements"].items(), (f"tables of {name}", record["tables"])]
        for of, counts in counted:
            total.update(counts)
            if counts:
                rows.append([_code(of), *(counts.get(kind, "") for kind in KINDS)])
        survivors += [
            {
                "of": _name(of, record),
                "changes": "; ".join(map(_code, changes[at : at + TOGETHER])),
                "why": prose(why or "DEFECT"),
            }
            for (of, why), changes in _grouped(record["survivors"]).items()
            for at in range(0, len(changes), TOGETHER)
        ]
    return {
        "kinds": [(kind, meaning, total[kind]) for kind, meaning in KINDS.items()],
        "total": total.total(),
        "mutants": rows,
        "survivors": survivors,
        "surviving": sum(len(record["survivors"]) for record in chapters.values()),
    }


def _grouped(survivors: list[list[str]]) -> dict[tuple[str, str], list[str]]:
    """Changes by what they are of and why they may stand."""
    found: dict[tuple[str, str], list[str]] = {}
    for of, _, change, why in survivors:
        found.setdefault((of, why), []).append(change)
    return found


def _name(of: str, record: dict[str, Any]) -> str:
    return _code(of) if of in record["statements"] else prose(of)


def _code(text: str) -> str:
    """Plain text in a type of its own, to be broken after signs."""
    plain = literally(text.replace("^", "**"))
    return rf"\texttt{{{re.sub(_BREAKS, lambda sign: sign.group() + BREAK, plain)}}}"

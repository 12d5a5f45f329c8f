"""The record of a measurement: machine, versions and all figures, as one JSON document."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

SCHEMA = 1

NUMBER = (int, float)
MAYBE = (int, float, type(None))
FIELDS: dict[str, dict[str, Any]] = {
    "functions": {
        "function": str, "set": str, "way": str, "precision": str, "seconds": NUMBER,
        "points": int, "median": MAYBE, "worst": MAYBE, "at": list, "missing": NUMBER,
        "last": NUMBER,
    },
    "boundary": {
        "method": str, "delay": int, "threshold": MAYBE, "points": int, "seconds": NUMBER,
        "median": NUMBER, "worst": NUMBER,
    },
    "stability": {
        "delay": int, "method": str, "walls": int, "seconds": NUMBER, "wrong": dict,
        "open": dict, "near": dict, "refused": NUMBER,
    },
    "models": {
        "delay": int, "model": str, "damping": NUMBER, "seconds": NUMBER, "median": NUMBER,
        "most": NUMBER, "least": NUMBER,
    },
    "peers": {"task": str, "tool": str, "installed": bool},
}  # fmt: skip
"""Sections of a record and the fields of each row."""


class BadRecord(ValueError):
    """A file that is no record; the message is one line."""


def text(record: dict[str, Any]) -> str:
    """JSON, one row a line."""
    lines = ["{"]
    for i, (name, value) in enumerate(record.items()):
        comma = "," if i < len(record) - 1 else ""
        if isinstance(value, list):
            rows = [f"  {json.dumps(row, allow_nan=False)}" for row in value]
            lines += [f" {json.dumps(name)}: [", ",\n".join(rows), f" ]{comma}"]
        else:
            lines.append(f" {json.dumps(name)}: {json.dumps(value, allow_nan=False)}{comma}")
    return "\n".join([*lines, "}"]) + "\n"


def read(path: Path) -> dict[str, Any]:
    """A record from a file.

    Raises :class:`BadRecord` for a file that is none.
    """
    try:
        record: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as wrong:
        raise BadRecord(f"{path}: is no record of a measurement ({wrong})") from None
    check(record, str(path))
    return record


def check(record: Any, where: str) -> None:
    """Raise :class:`BadRecord` with the first thing that is missing or of the wrong type."""
    if not isinstance(record, dict) or record.get("schema") != SCHEMA:
        raise BadRecord(f"{where}: is no record of a measurement; schema {SCHEMA} is")
    for name in ("machine", "versions"):
        if not isinstance(record.get(name), dict):
            raise BadRecord(f"{where}: has no {name}")
    for name, fields in FIELDS.items():
        rows = record.get(name)
        if not isinstance(rows, list) or not rows:
            raise BadRecord(f"{where}: has no {name}")
        for i, row in enumerate(rows):
            for field, kind in fields.items():
                if not isinstance(row, dict) or not isinstance(row.get(field, ...), kind):
                    raise BadRecord(f"{where}: {name}, row {i}: {field} is missing or wrong")

"""What does the paper say?  Its statements exactly as published, misprints included.

Hulin, Albu-Schaeffer and Hirzinger, *Passivity and Stability Boundaries for Haptic Systems with
Time Delay*, IEEE Transactions on Control Systems Technology, 2014.  Nothing is computed here and
nothing is corrected; what is right instead is part of the verdict, in a chapter (see ``book``).

* ``statements.toml``: equations, figures, tables, claims with their numbers such as 17.8, slips
* ``tables``, ``ranges``: numbers of Table II, of the figures, and the ranges (23)
* ``statement``, ``quoted``: what a statement is made of
* ``reading``: reads a published formula
* ``propositions``: what each statement claims

Imports ``notation``; used by ``rules``, ``proof``, ``book``, ``scene``, ``bench``, ``check`` and
``cli``, and never reached from ``model``.
"""

from __future__ import annotations

import tomllib
from importlib.resources import files
from typing import Any

from symhaptic.notation import TABLE_I
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.statement import Statement


def _statement(row: dict[str, Any]) -> Statement:
    """A statement as the transcription has it; its texts are folded lines."""
    for name, value in row.items():
        if isinstance(value, str):
            row[name] = " ".join(value.split())
        elif name == "quoted":
            row[name] = tuple(Quoted(*pair) for pair in value)
        elif name in ("latex", "reading"):
            row[name] = tuple(" ".join(line.split()) for line in value)
    if row["id"] == "tab1":
        row["latex"] = tuple(r.dimensionless for r in TABLE_I if r.dimensionless is not None)
    return Statement(**row)


def _transcription() -> dict[str, Statement]:
    text = files(__name__).joinpath("statements.toml").read_text(encoding="utf-8")
    found = [_statement(row) for kind in tomllib.loads(text).values() for row in kind]
    return {statement.id: statement for statement in found}


STATEMENTS = _transcription()
"""The statements of the paper by their ids: equations, tables, figures, claims and slips."""

__all__ = ["STATEMENTS", "Statement"]

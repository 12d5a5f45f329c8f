"""The sources of statements, the paper first; the one place to add another.

A user's source is a folder with a file ``source.py``, which has ``SOURCE`` and ``STATEMENTS``, and
beside it the chapters that settle these.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import sympy as sp

from symhaptic import paper, rules
from symhaptic.notation import SYMBOLS
from symhaptic.notation.latex import matching
from symhaptic.notation.proposition import Proposition, of_print, proposition
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.reading import Printed, Unreadable
from symhaptic.paper.statement import Source, Statement
from symhaptic.rules import claims as _claims  # noqa: F401  registered in CLAIMED

PAPER = Source(
    "",
    "Passivity and Stability Boundaries for Haptic Systems with Time Delay",
    "T. Hulin, A. Albu-Schäffer, G. Hirzinger",
    "2014",
    "IEEE Transactions on Control Systems Technology",
)
SHIPPED = (PAPER, rules.SOURCE)
SOURCES = [*SHIPPED]

STATEMENTS: dict[str, Statement] = {**paper.STATEMENTS, **rules.STATEMENTS}
"""Of all sources, in their order."""


def source_of(id: str) -> Source | None:
    """The source of a statement; None of one that a chapter states itself."""
    if id not in STATEMENTS:
        return None
    key = id.partition(":")[0] if ":" in id else ""
    return next(source for source in SOURCES if source.key == key)


def claimed(source: Source, statements: Iterable[Statement]) -> dict[str, Proposition]:
    """What a source that was read in this process claims of its statements, as they are printed.

    Raises ``ValueError`` for a claim of what it does not state.
    """
    own = {s.id: replace(s, notation=source.notation) for s in statements}
    for id in CLAIMED.keys() - STATEMENTS.keys() - own.keys():
        raise ValueError(f"something is claimed of {id!r}, which it does not state")
    return {id: CLAIMED[id](s.printed) for id, s in own.items() if id in CLAIMED}


def _of_its_print(claim: Proposition, own: Printed, printed: Printed) -> Proposition:
    """What was claimed of a statement, whose print this is to be."""
    if tuple(printed) != tuple(own):
        raise ValueError("what the source claims was told of the print as it stands")
    return claim


def add(
    source: Source, statements: Iterable[Statement], claims: Mapping[str, Proposition]
) -> Source:
    """Another source, with its statements, whose ids begin with its key and a colon.

    ``claims`` has what it claims of some of them, by their ids.

    Raises ``ValueError`` with one line on what is wrong with it.
    """
    found = {}
    for side in zip(*source.notation, strict=True):
        if twice := [word for word in side if side.count(word) > 1]:
            raise ValueError(f"the notation has {twice[0]!r} twice on a side; once is allowed")
    for tex, name in source.notation:
        if name not in SYMBOLS:
            raise ValueError(f"the notation has {name!r} for {tex!r}; a symbol of ours is allowed")
    if not source.key.isidentifier() or any(source.key == other.key for other in SOURCES):
        raise ValueError(f"the key {source.key!r} of a source is a name that no other source has")
    for statement in statements:
        if wrong := _not_text(statement):
            raise ValueError(wrong)
        if not is_id(statement.id.removeprefix(f"{source.key}:")):
            raise ValueError(NO_ID.format(statement.id))
        if not statement.id.startswith(f"{source.key}:") or statement.id in found:
            raise ValueError(
                f"the id {statement.id!r} is to begin with '{source.key}:' and to stand once"
            )
        found[statement.id] = replace(statement, notation=source.notation)
        found[statement.id].printed  # noqa: B018  raises where it cannot be read
        if _reads_otherwise(found[statement.id]):
            raise ValueError(f"{statement.id}: reading: says something else than the print does")
        for line in (*statement.latex, statement.domain):
            if not matching(line):
                raise ValueError(f"{statement.id}: {line!r} has braces that do not match")
    if not claims.keys() <= found.keys() or any(
        not isinstance(claim, Proposition) for claim in claims.values()
    ):
        raise ValueError("what is claimed is no proposition on a statement of it")
    for id, claim in claims.items():
        for relation in found[id].printed:
            if isinstance(relation, sp.core.relational.Relational) and not _is_of(claim, relation):
                raise ValueError(f"{id}: what is claimed does not conclude its print {relation}")
    SOURCES.append(source)
    STATEMENTS.update(found)
    for id, claim in claims.items():
        CLAIMED.setdefault(id, partial(_of_its_print, claim, found[id].printed))
    return source


def _is_of(claim: Proposition, printed: Any) -> bool:
    """Whether a claim concludes what is printed or, of the bound that is a rule, supposes it."""
    try:
        of_print(claim, [printed])
    except ValueError:
        bound, left = proposition(printed), [claim]
        for part in left:
            left += part.parts
        return not isinstance(printed, sp.Eq) and bound in left
    return True


def _reads_otherwise(statement: Statement) -> bool:
    """Whether a print that can be read, and quotes no number, is taken for another formula."""
    if statement.reading is None or statement.quoted:
        return False
    try:
        return replace(statement, reading=None).printed != statement.printed
    except Unreadable:
        return False


def _not_text(statement: Statement) -> str | None:
    """What a statement has in place of text, or of several texts, if it has anything else."""
    for name in ("id", "location", "says", "domain", "quote"):
        if not isinstance(found := getattr(statement, name), str):
            return f"{statement.id}: {name}: {found!r} is not allowed; text is"
    for name in ("latex", "reading"):
        found = getattr(statement, name)
        several = isinstance(found, tuple) and all(isinstance(line, str) for line in found)
        if not (several or (name == "reading" and found is None)):
            return f"{statement.id}: {name}: {found!r} is not allowed; a tuple of texts is"
    return None


def of_source(source: Source) -> dict[str, Statement]:
    """The statements of a source, in their order."""
    return {id: s for id, s in STATEMENTS.items() if source_of(id) is source}


NO_ID = "the id {!r} has no characters, too many, or blanks; up to 100 that are printed are allowed"


def is_id(text: str) -> bool:
    """Whether a line of a listing, a case of JUnit and a place of a page can be named so."""
    return (
        isinstance(text, str) and text.isprintable() and text.split() == [text] and len(text) <= 100
    )


__all__ = [
    "CLAIMED",
    "NO_ID",
    "PAPER",
    "SHIPPED",
    "SOURCES",
    "STATEMENTS",
    "add",
    "is_id",
    "of_source",
    "source_of",
]

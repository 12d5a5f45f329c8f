"""The sources of statements, the paper first; the one place to add another.

A user's source is a folder with a file ``source.py``, which has ``SOURCE`` and ``STATEMENTS``, and
beside it the chapters that settle these.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import partial

import sympy as sp

from symhaptic import paper, rules
from symhaptic.notation import SYMBOLS
from symhaptic.notation.latex import refused
from symhaptic.notation.proposition import Predicate, Proposition, Relation, proposition
from symhaptic.notation.quantities import shown
from symhaptic.notation.written import written
from symhaptic.paper.propositions import CLAIMED as REGISTERED
from symhaptic.paper.propositions import Claim
from symhaptic.paper.reading import Printed, Unreadable, read, sides_of, signs_of
from symhaptic.paper.statement import Source, Statement
from symhaptic.proof.theorems.judge import of_print, supposed, taken_apart
from symhaptic.rules import claims as _claims  # noqa: F401  registered there
from symhaptic.rules import other_loops as _other_loops  # noqa: F401  registered there, too

PAPER = Source(
    "",
    "Passivity and Stability Boundaries for Haptic Systems with Time Delay",
    "T. Hulin, A. Albu-Schäffer, G. Hirzinger",
    "2014",
    "IEEE Transactions on Control Systems Technology",
)
SHIPPED = (PAPER, *rules.SOURCES)
SOURCES = [*SHIPPED]

STATEMENTS: dict[str, Statement] = {**paper.STATEMENTS, **rules.STATEMENTS}
"""Of all sources, in their order."""

CLAIMED: dict[str, Claim] = dict(REGISTERED)
"""What the sources claim of their statements; what a chapter registers later is not in it."""


def source_of(id: str) -> Source | None:
    """The source of a statement; None of one that a chapter states itself."""
    if id not in STATEMENTS:
        return None
    key = id.partition(":")[0] if ":" in id else ""
    return next(source for source in SOURCES if source.key == key)


def add(source: Source, statements: Iterable[Statement]) -> Source:
    """Add a source with its statements, whose ids begin with its key and a colon.

    Its claims are those that ``source.py`` has registered.  Raises ``ValueError`` with one line on
    what is wrong.
    """
    for field in ("key", "title", "authors", "year", "where"):
        if not isinstance(value := getattr(source, field), str):
            raise ValueError(f"{field}: {shown(value)} of a source is not allowed; give text")
    for side in zip(*source.notation, strict=True):
        if twice := [word for word in side if side.count(word) > 1]:
            raise ValueError(f"the notation has {twice[0]!r} twice on a side; give it once")
    for tex, name in source.notation:
        if name not in SYMBOLS:
            raise ValueError(
                f"the notation has {name!r} for {tex!r}; give a symbol of symhaptic.notation"
            )
    named = source.key.isidentifier() and source.key.isascii()
    if not named or any(source.key == other.key for other in SOURCES):
        raise ValueError(
            f"the key {source.key!r} of a source is not allowed; give an identifier in ASCII that "
            "no other source has"
        )
    found: dict[str, Statement] = {}
    for statement in statements:
        if wrong := _not_text(statement):
            raise ValueError(wrong)
        if not is_id(statement.id.removeprefix(f"{source.key}:")):
            raise ValueError(NO_ID.format(statement.id))
        if not statement.id.startswith(f"{source.key}:") or statement.id in found:
            raise ValueError(
                f"the id {statement.id!r} is to begin with '{source.key}:' and to stand once"
            )
        found[statement.id] = own = replace(statement, notation=source.notation)
        own.printed  # noqa: B018  raises if the print cannot be read
        if wrong := _reads_otherwise(own):
            raise ValueError(f"{statement.id}: {wrong}")
        for line in (*statement.latex, statement.domain):
            if why := refused(line):
                raise ValueError(f"{statement.id}: {line!r} {why}")
        own.given  # noqa: B018  raises if the domain cannot be read
    for id in REGISTERED.keys() - STATEMENTS.keys() - found.keys():
        if id.startswith(f"{source.key}:"):
            raise ValueError(f"something is claimed of {id!r}, which it does not state")
    claimed = {
        id: partial(_of_source, found[id], REGISTERED[id])
        for id in found.keys() & REGISTERED.keys()
    }
    for id, claim in claimed.items():
        try:
            claim(found[id].printed)
        except ValueError as wrong_claim:
            raise ValueError(f"{id}: {wrong_claim}") from None
    SOURCES.append(source)
    STATEMENTS.update(found)
    CLAIMED.update(claimed)
    return source


def _of_source(statement: Statement, claim: Claim, printed: Printed) -> Proposition:
    """What a user's source claims of a print, under hypotheses that the source states."""
    made = claim(printed)
    _, given, then = taken_apart(made)
    stated = (*statement.given, *map(proposition, printed if statement.condition else ()))
    if statement.condition:  # an example shows that these can hold
        stated += tuple(h for h in given if isinstance(h, Predicate) and h.name != "whole")
    for hypothesis in (*given, *supposed(then)):
        if hypothesis not in stated and not _in_domain(hypothesis):
            raise ValueError(
                f"the claim supposes {written(hypothesis)}, which the source does not state; give "
                "it in the statement's domain"
            )
    return of_print(made, printed, statement.condition)


def _in_domain(hypothesis: Proposition) -> bool:
    """Whether a hypothesis says of one symbol what the notation says of it."""
    if len(hypothesis.free) != 1 or not isinstance(hypothesis, Relation):
        return False
    [symbol] = hypothesis.free
    known = SYMBOLS.get(symbol.name)
    weak = Relation(sp.S.Zero, "<=", symbol), Relation(sp.S.Zero, "<", symbol)
    return known is not None and hypothesis in {"nonnegative": weak[:1], "positive": weak}.get(
        known.domain, ()
    )


def _reads_otherwise(statement: Statement) -> str | None:
    """What is wrong with a ``reading`` that is not what the print says."""
    if statement.reading is None:
        return None
    try:
        plain = replace(statement, reading=None).printed
    except Unreadable:
        if signs_of(statement.latex) != signs_of(statement.reading):
            return "reading: has other relation signs than the print"
        return _other_sides(statement)
    left_out = [relation for relation in plain if relation not in statement.printed]
    known = all(relation in plain for relation in statement.printed)
    quotes = signs_of(statement.latex).count(r"\approx")
    if known and len(left_out) <= min(quotes, len(statement.quoted)):
        return None
    return "reading: says something else than the print does"


def _other_sides(statement: Statement) -> str | None:
    """What is wrong with the sides of a reading: what can be read of the print stands in it, and
    what cannot is no number."""
    printed, reading = (
        [side for line in lines for side in sides_of(line)]
        for lines in (statement.latex, statement.reading or ())
    )
    for print_, ours in zip(printed, reading, strict=True):
        found = read(ours, statement.notation)
        try:
            same = read(print_, statement.notation) == found
        except Unreadable:
            same = all(form.free_symbols for form in found)
        if not same:
            return f"reading: {ours} is not what {print_} says"
    return None


def _not_text(statement: Statement) -> str | None:
    """What a statement has in place of text, or of several texts, if it has anything else."""
    for name in ("id", "location", "says", "domain", "quote"):
        if not isinstance(found := getattr(statement, name), str):
            return f"{statement.id}: {name}: {found!r} is not allowed; give text"
    for name in ("latex", "reading"):
        found = getattr(statement, name)
        several = isinstance(found, tuple) and all(isinstance(line, str) for line in found)
        if not (several or (name == "reading" and found is None)):
            return f"{statement.id}: {name}: {found!r} is not allowed; give a tuple of texts"
    return None


def of_source(source: Source) -> dict[str, Statement]:
    """The statements of a source, in their order."""
    return {id: s for id, s in STATEMENTS.items() if source_of(id) is source}


NO_ID = (
    "the id {!r} is not allowed; give a letter or digit and up to 99 further letters, "
    "digits and : . _ + -, all of ASCII, since other letters can look the same"
)


def is_id(text: str) -> bool:
    """Whether a statement can be named so: in a listing, in JUnit, on a page and in a shell."""
    return isinstance(text, str) and _ID.fullmatch(text) is not None


_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9:._+-]{0,99}")


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

"""A verdict that another process gives, judged again: by theorems, or by comparing the print."""

from __future__ import annotations

import pickle
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from symhaptic.book.arrivals import arrived
from symhaptic.book.grounds import not_defined, not_shown
from symhaptic.book.sources import CLAIMED, PAPER, SHIPPED, STATEMENTS, source_of
from symhaptic.notation.latex import latex
from symhaptic.notation.proposition import of_print
from symhaptic.paper.reading import Printed
from symhaptic.proof.settle import ACCEPTED, WEIGHED, Settlement
from symhaptic.proof.units import of_another_unit
from symhaptic.proof.verdict import Kind, Unfounded, Verdict

if TYPE_CHECKING:
    from symhaptic.book.ledger import Entry


def to_be_compared(entry: Entry, grounds: Settlement) -> Entry:
    """With what the print was compared with; *argued* where that cannot be sent to be compared."""
    kind = entry.verdict.kind
    numbers = bool(grounds.values) and not _comes_with_the_package(entry.statement.id)
    if grounds.judged is not None or not (grounds.derived or numbers) or kind not in WEIGHED:
        return entry
    compared = replace(_forms(grounds), values=tuple(grounds.values) if numbers else ())
    try:
        arrives = isinstance(arrived(pickle.dumps(compared), Path()), Settlement)
    except (pickle.PicklingError, AttributeError, TypeError):
        arrives = False
    if arrives:
        return replace(entry, compared=compared)
    if entry.source is PAPER or kind not in ACCEPTED:
        return entry
    return replace(entry, verdict=replace(entry.verdict, kind=Kind.ARGUED, argued_for=kind))


def _forms(grounds: Settlement) -> Settlement:
    """Of the grounds of a verdict those that are forms, and what is done with them."""
    return Settlement(
        tuple(grounds.derived),
        dict(grounds.given),
        definition=grounds.definition,
        unless=grounds.unless and dict(grounds.unless),
        corrected=grounds.corrected,
        misprint=grounds.misprint,
        definitions=tuple(grounds.definitions),
        signs=tuple(grounds.signs),
        values=tuple(grounds.values),
    )


def _comes_with_the_package(id: str) -> bool:
    """Whether a statement's chapter is one of ours."""
    return id in STATEMENTS and source_of(id) in SHIPPED


def _compared_again(entry: Entry, printed: Printed) -> str | None:
    """What is wrong with the verdict that another process gives by comparing, if anything is."""
    id, kind, compared = entry.statement.id, entry.verdict.kind, entry.compared
    quoted = STATEMENTS[id].quoted if id in STATEMENTS else ()
    if compared is None:
        return None if entry.source is PAPER else f"{id}: {kind}, of what was not compared again"
    try:
        if wrong := not_defined(compared.given, compared.definitions):
            return f"{id}: {wrong}"
        for name, meaning in compared.given.items():
            if wrong := of_another_unit(name, meaning):
                return f"{id}: compared again: {wrong}"
        forms = replace(_forms(compared), quoted=quoted)
        found = replace(forms, assumed=not_shown(forms)).decide(printed)
    except (ArithmeticError, AttributeError, TypeError, ValueError) as wrong_data:
        return f"{id}: compared again: {' '.join(str(wrong_data).split())}"
    return _says_else(entry, found, "compared again")


_SAID = {"counterexample": "counterexample", "rests": "ground", "claim": "claim"}
"""What a verdict says that is found here as well, and how it is called."""


def _says_else(entry: Entry, found: Verdict, how: str) -> str | None:
    """What another process says of a verdict that was not found here, if anything is."""
    id, said = entry.statement.id, entry.verdict
    ours = _comes_with_the_package(id)
    numbers = ours and said.kind is Kind.ENCLOSED and found.kind is Kind.PROVED
    if (found.kind is not said.kind and not numbers) or found.condition != said.condition:
        return f"{id}: {how} it is {found.kind}"
    other = [w for name, w in _SAID.items() if getattr(found, name) != getattr(said, name)]
    if corrected_form(found) != corrected_form(said):
        other.append("correction")
    if not ours and (found.value, found.radius) != (said.value, said.radius):
        other.append("value")
    return f"{id}: {how} it has another {other[0]}" if other else None


def judged_again(entry: Entry) -> str | None:
    """What is wrong with the verdict that another process gives, if anything is.

    The theorems were derived again when they arrived; here they are held against what the
    statement claims.  Without theorems the print is compared again with what was derived.
    """
    judged, statement, kind = entry.judged, entry.statement, entry.verdict.kind
    known, claim = STATEMENTS.get(statement.id), entry.claim
    if judged is None:
        printed, free = (known or statement).printed, statement.id not in CLAIMED
        if kind is Kind.SLIP and printed:
            return f"{statement.id}: a slip is a statement in words; a formula is compared"
        if kind not in WEIGHED:
            return None
        if free and not printed and known and known.quoted:
            ours = _comes_with_the_package(statement.id)
            return None if ours else _compared_again(entry, printed)
        if free and printed:
            return _compared_again(entry, printed)
        return f"{statement.id}: {kind} without a theorem, of what is not compared with a formula"
    own = None if claim is None else partial(of_print, claim)
    claimed = CLAIMED.get(statement.id) if known else own
    try:
        found = Settlement(judged=judged, claim=claimed).decide((known or statement).printed)
    except Unfounded as wrong:
        return f"{statement.id}: {wrong}"
    return _says_else(entry, found, "judged again")


def corrected_form(verdict: Verdict) -> str | None:
    """LaTeX of the right form."""
    if verdict.corrected_latex is None and verdict.corrected is not None:
        return latex(verdict.corrected)
    return verdict.corrected_latex

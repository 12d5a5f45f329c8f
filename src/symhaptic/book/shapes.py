"""What a chapter's process may send of a statement: each part is of the class that it should be.

Arrivals read it as data of ours; that its fields hold what our code puts there, and text that is
listed in a line, is asked here, part by part.
"""

from __future__ import annotations

from typing import Any

from symhaptic.book.sources import is_id
from symhaptic.notation.proposition import Proposition
from symhaptic.paper.statement import Statement
from symhaptic.proof.theorems.judge import Case, Judged
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.verdict import Kind, Verdict


def is_statement(statement: Any) -> bool:
    """Whether a statement can be named, told and read."""
    if type(statement) is not Statement:
        return False
    told = (statement.location, statement.says, statement.domain, statement.quote)
    reading = () if statement.reading is None else statement.reading
    try:
        printed = is_id(statement.id) and isinstance(statement.printed, tuple)
    except (AttributeError, TypeError, ValueError, RecursionError):
        return False
    return printed and are_text(told) and are_text(statement.latex) and are_text(reading)


def is_verdict(verdict: Any) -> bool:
    """Whether a verdict has text where text is told, printed in a line where it is listed."""
    if type(verdict) is not Verdict:
        return False
    lines = [verdict.condition, verdict.corrected_latex, verdict.value, verdict.radius]
    point = verdict.counterexample or {}
    if type(point) is not dict:
        return False
    lines += [*point.keys(), *point.values()]
    return (
        type(verdict.kind) is Kind
        and (verdict.argued_for is None or type(verdict.argued_for) is Kind)
        and type(verdict.method) is str
        and all(t is None or type(t) is str for t in (verdict.shows, verdict.note))
        and all(t is None or (type(t) is str and t.isprintable()) for t in lines)
        and None not in (*point.keys(), *point.values())
        and are_text(verdict.rests)
    )


def is_judged(judged: Any) -> bool:
    """Whether theorems came, and points with theorems."""
    if type(judged) is not Judged or type(judged.unless) is not tuple:
        return False
    cases = [*judged.unless, *(() if judged.example is None else (judged.example,))]
    return (
        type(judged.theorem) is Theorem
        and (judged.corrected is None or are_text(judged.corrected))
        and (judged.instead is None or isinstance(judged.instead, Proposition))
        and all(
            type(case) is Case and type(case.theorem) is Theorem and type(case.values) is dict
            for case in cases
        )
    )


def are_text(parts: Any) -> bool:
    """Whether they are some texts, and nothing that is like one."""
    return type(parts) is tuple and all(type(part) is str for part in parts)

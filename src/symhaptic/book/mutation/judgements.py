"""A question with one thing changed: a statement's theorem held against another claim.

A claim is changed everywhere: each quantifier, connective, sign and formula in it, one at a time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Protocol, TypeAlias

from symhaptic.book.record import Settled
from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
    implied,
)
from symhaptic.notation.terms import NoTerm
from symhaptic.notation.written import written
from symhaptic.paper.reading import read
from symhaptic.proof.mutants import few
from symhaptic.proof.settle import WRONG
from symhaptic.proof.theorems.judge import Judged, taken_apart
from symhaptic.proof.verdict import Kind, Unfounded, Verdict

Words: TypeAlias = tuple[str | Proposition, ...]
"""Of a change; its propositions are written only if the change survives."""


class Check(Protocol):
    """A question that a checker answers."""

    def holds(self) -> bool:
        """Whether the checker says yes."""
        ...


def inexcusable() -> str | None:
    """Nothing excuses it."""
    return None


def because(reason: str) -> Callable[[], str | None]:
    """A reason that is known beforehand."""
    return lambda: reason


@dataclass(frozen=True)
class Change:
    """A question with one thing changed."""

    kind: str
    words: Words
    check: Check
    excuse: Callable[[], str | None] = inexcusable

    @property
    def what(self) -> str:
        """What was changed."""
        return "".join(w if isinstance(w, str) else written(w) for w in self.words)


CONTRARY = ("the contrary",)

_TURNED = {"<": "<=", "<=": "<", "=": "!=", "!=": "="}

_FORMULAS = 2
"""So many changes of the terms of each relation and predicate."""


@dataclass(frozen=True)
class Rejudged:
    """These theorems give a claim this verdict."""

    judged: Judged
    claim: Proposition
    verdict: Verdict

    def holds(self) -> bool:
        """By judging again; a correction that gets another condition is another verdict."""
        try:
            found = self.judged.decide(self.claim)
        except Unfounded:
            return False
        same = found.kind not in WRONG or found.condition == self.verdict.condition
        return same and found.kind is self.verdict.kind


def changes_of_judgement(settled: Settled) -> Iterator[Change]:
    """The claim wider, weaker or denied; the case without its example or a counterexample."""
    settlement, judged = settled.settlement, settled.settlement.judged
    if judged is None or settlement.claim is None:
        return
    claim = settlement.claim(settled.statement.printed)
    if judged.corrected is not None and judged.instead is None:
        right = tuple(form for line in judged.corrected for form in read(line))
        judged = replace(judged, instead=settlement.claim(right))
    verdict = judged.decide(claim)  # numbers and definitions make another kind of it
    kind = verdict.kind

    def put(kind: str, what: Words, judged: Judged = judged, said: Proposition = claim) -> Change:
        return Change(kind, what, Rejudged(judged, said, verdict))

    if taken_apart(judged.theorem.conclusion)[1]:
        yield put("grounds", ("no example of its hypotheses",), replace(judged, example=None))
    for i, case in enumerate(judged.unless):
        others = (*judged.unless[:i], *judged.unless[i + 1 :])
        at = ", ".join(f"{s} = {v}" for s, v in case.values.items())
        if kind is Kind.QUALIFIED or not others:
            dropped = replace(judged, unless=others)
            yield put("counterexample", (f"without that at {at}",), dropped)
    for what, other in _others(claim):
        # what is false is so when it is said of more as well
        if kind not in WRONG or what == CONTRARY:
            yield put("claim", what, said=other)
    if judged.instead is not None:
        yield put("claim", ("what holds instead",), said=judged.instead)
    if kind not in WRONG:
        for how, what, other in _changed(claim):
            yield put(how, what, said=other)
    elif judged.instead is not None:
        for how, what, other in _changed(judged.instead):
            yield put(how, ("instead: ", *what), replace(judged, instead=other))


def _changed(
    claim: Proposition, put: Callable[[Proposition], Proposition] = lambda whole: whole
) -> Iterator[tuple[str, Words, Proposition]]:
    """Every part of a claim changed at its root: kind, what was done, and the whole."""
    for kind, other in _here(claim):
        if other != claim:  # x <= x turned round
            yield kind, (other, " for ", claim), put(other)
    for i, part in enumerate(claim.parts):
        yield from _changed(part, partial(_replaced, claim, i, put))


def _replaced(
    whole: Proposition, place: int, put: Callable[[Proposition], Proposition], part: Proposition
) -> Proposition:
    parts = (*whole.parts[:place], part, *whole.parts[place + 1 :])
    return put(whole.made(whole.bound, whole.terms, parts))


def _here(claim: Proposition) -> Iterator[tuple[str, Proposition]]:
    """The other quantifier, connective or sign, or another formula on a side."""
    if isinstance(claim, ForAll | Exists):
        other = Exists if isinstance(claim, ForAll) else ForAll
        yield "claim", other(claim.over, claim.body)
    elif isinstance(claim, Implies | Iff):
        one, then = claim.of
        if isinstance(claim, Implies):
            yield "claim", Implies((then, one))
        yield "claim", Iff((one, Not((then,))))
    elif isinstance(claim, And | Or) and len(claim.of) > 1:
        yield "claim", (Or if isinstance(claim, And) else And)(claim.of)
    elif isinstance(claim, Not):
        yield "claim", claim.of[0]
    elif isinstance(claim, Relation):
        yield "claim", Relation(claim.left, _TURNED[claim.sign], claim.right)
        if claim.sign in ("<", "<="):
            yield "claim", Relation(claim.right, claim.sign, claim.left)
    if isinstance(claim, Relation | Predicate):
        for mutant in few(claim.terms, _FORMULAS):
            try:
                yield "formula", claim.made(claim.bound, mutant.form, ())
            except NoTerm:  # 1/0 for 1/x
                continue


def _others(claim: Proposition) -> Iterator[tuple[Words, Proposition]]:
    """Other claims: a hypothesis dropped, a border let in, the conclusion denied; of several that
    are made together, one so changed or left out."""
    symbols, given, then = taken_apart(claim)
    if isinstance(claim, And):
        for i, part in enumerate(claim.of):
            before, after = claim.of[:i], claim.of[i + 1 :]
            for what, other in _others(part):
                yield (*what, f", in part {i + 1}"), And((*before, other, *after))
            yield (f"without part {i + 1}",), And((*before, *after))

    def of(given: tuple[Proposition, ...], then: Proposition) -> Proposition:
        inner = implied(given, then)
        return ForAll(symbols, inner) if symbols else inner

    for i, hypothesis in enumerate(given):
        yield ("without ", hypothesis), of((*given[:i], *given[i + 1 :]), then)
        if isinstance(hypothesis, Relation) and hypothesis.sign == "<":
            weak = Relation(hypothesis.left, "<=", hypothesis.right)
            yield (weak, " for <"), of((*given[:i], weak, *given[i + 1 :]), then)
    yield CONTRARY, of(given, Not((then,)))

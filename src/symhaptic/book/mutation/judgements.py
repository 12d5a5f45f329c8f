"""A statement's theorem held against another claim, or with a part of its case left out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from symhaptic.book.record import Settled
from symhaptic.notation.proposition import (
    And,
    ForAll,
    Not,
    Proposition,
    Relation,
    implied,
)
from symhaptic.notation.written import written
from symhaptic.proof.change import Change
from symhaptic.proof.settle import WRONG
from symhaptic.proof.theorems.judge import Judged, taken_apart
from symhaptic.proof.verdict import Kind, Unfounded

CONTRARY = "the contrary"


@dataclass(frozen=True)
class Rejudged:
    """These theorems give a claim this verdict."""

    judged: Judged
    claim: Proposition
    kind: Kind

    def holds(self) -> bool:
        """By judging again."""
        try:
            return self.judged.decide(self.claim).kind is self.kind
        except Unfounded:
            return False


def changes_of_judgement(settled: Settled) -> Iterator[Change]:
    """The claim wider, weaker or denied; the case without its example or a counterexample."""
    settlement, kind = settled.settlement, settled.verdict.kind
    judged = settlement.judged
    if judged is None or settlement.claim is None or judged.corrected is not None:
        return
    claim = settlement.claim(settled.statement.printed)

    def put(what: str, other: str, judged: Judged = judged, said: Proposition = claim) -> Change:
        return Change(what, other, Rejudged(judged, said, kind))

    if taken_apart(judged.theorem.conclusion)[1]:
        yield put("grounds", "no example of its hypotheses", replace(judged, example=None))
    for i, case in enumerate(judged.unless):
        others = (*judged.unless[:i], *judged.unless[i + 1 :])
        at = ", ".join(f"{s} = {v}" for s, v in case.values.items())
        if kind is Kind.QUALIFIED or not others:
            dropped = replace(judged, unless=others)
            yield put("counterexample", f"without that at {at}", dropped)
    for what, other in _others(claim):
        # what is false is so when it is said of more as well
        if kind not in WRONG or what == CONTRARY:
            yield put("claim", what, said=other)
    if judged.instead is not None:
        yield put("claim", "what holds instead", said=judged.instead)


def _others(claim: Proposition) -> Iterator[tuple[str, Proposition]]:
    """Other claims: a hypothesis dropped, a border let in, the conclusion denied; of several that
    are made together, one so changed or left out."""
    symbols, given, then = taken_apart(claim)
    if isinstance(claim, And):
        for i, part in enumerate(claim.of):
            before, after = claim.of[:i], claim.of[i + 1 :]
            for what, other in _others(part):
                yield f"{what}, in part {i + 1}", And((*before, other, *after))
            yield f"without part {i + 1}", And((*before, *after))

    def of(given: tuple[Proposition, ...], then: Proposition) -> Proposition:
        inner = implied(given, then)
        return ForAll(symbols, inner) if symbols else inner

    for i, hypothesis in enumerate(given):
        yield f"without {written(hypothesis)}", of((*given[:i], *given[i + 1 :]), then)
        if isinstance(hypothesis, Relation) and hypothesis.sign == "<":
            weak = Relation(hypothesis.left, "<=", hypothesis.right)
            yield f"{written(weak)} for <", of((*given[:i], weak, *given[i + 1 :]), then)
    yield CONTRARY, of(given, Not((then,)))

"""What is settled, settled again with one thing changed: print, number, condition, counterexample.

The changes of what a chapter asked of the checkers are in :mod:`symhaptic.proof.changes`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import sympy as sp
from sympy import Expr
from sympy.core.relational import Relational

from symhaptic.book.mutation.judgements import changes_of_judgement
from symhaptic.book.record import Settled
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import Notation, Printed, Unreadable, read
from symhaptic.proof import second_opinion
from symhaptic.proof.change import Change, because
from symhaptic.proof.changes import AGAIN, opposite
from symhaptic.proof.checks import Same, confirmed
from symhaptic.proof.condition import holds as holds_at
from symhaptic.proof.constants import measured
from symhaptic.proof.mutants import misprints, mutants
from symhaptic.proof.points import Point, choices
from symhaptic.proof.settle import ACCEPTED, WRONG, Settlement
from symhaptic.proof.sign import Fact, assume
from symhaptic.proof.verdict import Kind


@dataclass(frozen=True)
class Decided:
    """A printed form has a verdict of these kinds."""

    settlement: Settlement
    printed: Printed
    kinds: frozenset[Kind] = ACCEPTED

    def holds(self) -> bool:
        """By deciding it again."""
        return self.settlement.accepts(self.printed, self.kinds)


def changes_of(settled: Settled) -> Iterator[Change]:
    """All changes of a statement and of the grounds that it is settled on."""
    yield from _print(settled)
    yield from _numbers(settled)
    yield from _claim(settled)
    yield from _correction(settled)
    yield from _counterexample(settled)
    yield from changes_of_judgement(settled)


def _print(settled: Settled) -> Iterator[Change]:
    """Another formula in print, another digit."""
    statement, settlement = settled.statement, settled.settlement
    printed = statement.printed
    if not printed or not settlement.derived:
        return
    right = ACCEPTED if settlement.external is None else ACCEPTED | {Kind.EXTERNAL}
    lines = statement.latex if statement.reading is None else statement.reading
    digits = {form: what for form, what in _misread(lines, statement.notation) if form != printed}
    for mutant in mutants(printed):
        check = Decided(settlement, mutant.form, right)
        yield Change("formula", mutant.change, check, _excuse(settled, mutant.form))
        digits.pop(mutant.form, None)
    for form, what in digits.items():
        yield Change("digit", what, Decided(settlement, form, right), _excuse(settled, form))


def _misread(lines: Sequence[str], notation: Notation = ()) -> Iterator[tuple[Printed, str]]:
    """Print read with one digit or sign changed, where that is a formula still."""
    for i, line in enumerate(lines):
        for other, what in misprints(line):
            try:
                read_ = [read(text, notation) for text in (*lines[:i], other, *lines[i + 1 :])]
            except (Unreadable, ZeroDivisionError):
                continue
            yield tuple(part for form in read_ for part in form), what


def _excuse(settled: Settled, form: Printed) -> Callable[[], str | None]:
    settlement = settled.settlement

    def excuse() -> str | None:
        if second_opinion.alike(settled.statement.printed, form, settlement.given):
            return AGAIN
        wrong = settled.verdict.claimed in WRONG
        if wrong and second_opinion.alike(settlement.derived, form, settlement.given):
            return "this is the corrected form"
        return None

    return excuse


def _numbers(settled: Settled) -> Iterator[Change]:
    """Another digit in a number of the text, or the other side of a bound."""
    settlement, quoted = settled.settlement, settled.settlement.quoted
    if len(settlement.values) != len(quoted):
        return
    for i, (number, value) in enumerate(zip(quoted, settlement.values, strict=True)):
        ball = measured(value)
        others = [*number.changed(), *_turned(number)]
        for other in others:
            changed = replace(settlement, quoted=(*quoted[:i], other, *quoted[i + 1 :]))
            kind = "digit" if other.how == number.how else "negated"
            what = f"{other.how} {other.digits} for {number.how} {number.digits}"
            check = Decided(changed, settled.statement.printed)
            near = ball.str(8, radius=False)
            yield Change(
                kind, what, check, _true(number, other, near, second_opinion.says(other, ball))
            )


def _turned(number: Quoted) -> Iterator[Quoted]:
    for how in {"below": ("above",), "above": ("below",)}.get(number.how, ()):
        yield replace(number, how=how)  # type: ignore[arg-type]


def _true(number: Quoted, other: Quoted, near: str, says: bool | None) -> Callable[[], str | None]:
    """Why a changed number may stand: it is true, and weaker or sharper than the printed one."""
    if not says:
        return lambda: None
    rises = Decimal(other.digits) > Decimal(number.digits)
    weaker = {"below": rises, "above": not rises}.get(number.how)
    how = "still true" if weaker is None else f"{'weaker' if weaker else 'sharper'}, and true"
    return because(f"{how}: the number is {near}")


def _claim(settled: Settled) -> Iterator[Change]:
    """The claim without its condition, without its grounds, or turned into its contrary."""
    settlement, printed, verdict = settled.settlement, settled.statement.printed, settled.verdict
    if settlement.external is not None:
        return
    if settlement.provided is not None and verdict.claimed not in WRONG:
        free = replace(settlement, provided=None)
        yield Change("domain", "without the condition", Decided(free, printed))
    if verdict.claimed in WRONG:
        right = replace(settlement, corrected=None, provided=None)
        yield Change("negated", "said to be right", Decided(right, printed))
    if settlement.proofs:
        bare = replace(settlement, proofs=(), values=())
        yield Change("grounds", "without grounds", Decided(bare, (), ACCEPTED | WRONG))
        others = [other for other in map(opposite, settled.grounds) if other is not None]
        if others:
            proofs = tuple("the contrary" for other in others if confirmed(other))
            turned = replace(settlement, proofs=proofs, values=())
            yield Change("negated", "the contrary", Decided(turned, (), ACCEPTED | WRONG))


def _correction(settled: Settled) -> Iterator[Change]:
    """Another formula in the correction."""
    settlement, printed = settled.settlement, settled.statement.printed
    lines = settlement.corrected or ()
    if lines and not (printed and settlement.derived):
        excuse = "a correction of words: argued for, not compared"
        yield Change("correction", "another correction", None, because(excuse))
        return
    derived = settlement.read(settlement.derived)
    for form, what in _misread(lines):
        check = Same(settlement.read(form), derived)
        yield Change("correction", what, check, _excuse(settled, form))


def _counterexample(settled: Settled) -> Iterator[Change]:
    """No counterexample, one at a harmless point, or without what is true there."""
    settlement, printed = settled.settlement, settled.statement.printed
    if settlement.unless is None:
        return
    same = frozenset({settled.verdict.claimed})

    def put(**changed: object) -> Decided:
        return Decided(replace(settlement, **changed), printed, same)  # type: ignore[arg-type]

    if settlement.truth is not None:
        yield Change("counterexample", "nothing true beside it", put(truth=None))
        if isinstance(settlement.truth, Relational):
            yield Change(
                "counterexample", "the contrary beside it", put(truth=_negated(settlement.truth))
            )
        elif isinstance(settlement.truth, Fact):
            bare = put(truth=_assumed(settlement.truth))
            yield Change("counterexample", "an assumption beside it", bare)
        elif isinstance(settlement.truth, tuple) and isinstance(settlement.truth[-1], Fact):
            relation, fact = settlement.truth
            bare, other = (
                put(truth=(relation, _assumed(fact))),
                put(truth=(_negated(relation), fact)),
            )
            yield Change("counterexample", "an assumption beside it", bare)
            yield Change("counterexample", "the contrary beside it", other)
    if not (printed and settlement.derived) or settlement.truth is not None:
        yield Change("counterexample", "none", put(unless=None))
    for symbol, value in settlement.unless.items():
        others = [v for v in choices(symbol) if v != value]
        points = [{**settlement.unless, symbol: v} for v in others]
        for other, point in zip(others, points, strict=True):
            if not confirmed(put(unless=point)):
                what = f"{symbol} = {other} for {value}"
                yield Change("counterexample", what, put(unless=point))
                break
        else:
            what = f"{symbol} = {', '.join(map(str, others))} for {value}"
            excuse = because(_why_not(settlement, symbol, points))
            yield Change("counterexample", what, None, excuse)


def _why_not(settlement: Settlement, symbol: Expr, points: list[Point]) -> str:
    """Why other values of a symbol do not make a counterexample harmless."""
    truth = settlement.truth
    if truth is None:
        return "the two forms differ there, too"
    if isinstance(truth, Expr | Relational) and symbol in truth.free_symbols:
        return "the statement fails there, too"
    if settlement.provided and all(holds_at(settlement.provided, p) is False for p in points):
        return "the condition fails there, too"
    return "not told apart: what is true beside it is said of this point"


def _assumed(fact: Fact) -> Fact:
    """The same as an assumption."""
    return assume(fact.expr, fact.strict)


def _negated(relation: Expr) -> Expr:
    """The contrary, as it is written."""
    contrary = {sp.Eq: sp.Ne, sp.Ne: sp.Eq, sp.StrictLessThan: sp.GreaterThan}
    contrary |= {sp.GreaterThan: sp.StrictLessThan, sp.StrictGreaterThan: sp.LessThan}
    contrary |= {sp.LessThan: sp.StrictGreaterThan}
    return contrary[relation.func](*relation.args, evaluate=False)

"""Statements settled again with one thing changed: print, digit, number or theorem."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction

from flint import arb

from symhaptic.book.mutation.judgements import Change, because, changes_of_judgement
from symhaptic.book.record import Settled
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import Notation, Printed, Unreadable, read
from symhaptic.proof.constants import measured
from symhaptic.proof.mutants import misprints, mutants
from symhaptic.proof.refute import told_apart
from symhaptic.proof.settle import ACCEPTED, WRONG, Settlement
from symhaptic.proof.verdict import Kind

AGAIN = "says the same in other words"


@dataclass(frozen=True)
class Decided:
    """The question whether a printed form has a verdict of one of these kinds."""

    settlement: Settlement
    printed: Printed
    kinds: frozenset[Kind] = ACCEPTED

    def holds(self) -> bool:
        """Decide it again."""
        return self.settlement.accepts(self.printed, self.kinds)


def changes_of(settled: Settled) -> Iterator[Change]:
    """All changes of a statement and of the theorems on which it is settled."""
    yield from _print(settled)
    yield from _numbers(settled)
    yield from changes_of_judgement(settled)


def _print(settled: Settled) -> Iterator[Change]:
    """Another formula in print, another digit, where the print is compared with a formula."""
    statement, settlement = settled.statement, settled.settlement
    printed = statement.printed
    if not printed or not (settlement.derived or settlement.definitions):
        return
    right = ACCEPTED if settlement.external is None else ACCEPTED | {Kind.EXTERNAL}
    if settled.verdict.kind in WRONG:
        right = frozenset(Kind) - WRONG - {Kind.UNDECIDED}
    lines = statement.latex if statement.reading is None else statement.reading
    digits = {form: what for form, what in _misread(lines, statement.notation) if form != printed}

    def excuse(form: Printed) -> Callable[[], str | None]:
        return lambda: AGAIN if _alike(printed, form) else None

    for mutant in mutants(printed):
        check = Decided(settlement, mutant.form, right)
        yield Change("formula", (mutant.change,), check, excuse(mutant.form))
        digits.pop(mutant.form, None)
    for form, what in digits.items():
        yield Change("digit", (what,), Decided(settlement, form, right), excuse(form))


def _alike(one: Printed, other: Printed) -> bool:
    """Whether no point is found at which two prints differ."""
    return len(one) == len(other) and all(
        told_apart(left, right) is None for left, right in zip(one, other, strict=True)
    )


def _misread(lines: Sequence[str], notation: Notation = ()) -> Iterator[tuple[Printed, str]]:
    """Print read with one digit or sign changed, where that is a formula still."""
    for i, line in enumerate(lines):
        for other, what in misprints(line):
            try:
                read_ = [read(text, notation) for text in (*lines[:i], other, *lines[i + 1 :])]
            except (Unreadable, ZeroDivisionError):
                continue
            yield tuple(part for form in read_ for part in form), what


def _numbers(settled: Settled) -> Iterator[Change]:
    """Another digit in a number of the text, or the other side of a bound."""
    settlement, quoted = settled.settlement, settled.settlement.quoted
    if len(settlement.values) != len(quoted):
        return
    for i, (number, value) in enumerate(zip(quoted, settlement.values, strict=True)):
        ball = measured(value)
        for other in (*number.changed(), *_turned(number)):
            changed = replace(settlement, quoted=(*quoted[:i], other, *quoted[i + 1 :]))
            kind = "digit" if other.how == number.how else "negated"
            what = f"{other.how} {other.digits} for {number.how} {number.digits}"
            check = Decided(changed, settled.statement.printed)
            near = ball.str(8, radius=False)
            yield Change(kind, (what,), check, _true(number, other, near, says(other, ball)))


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


def says(quoted: Quoted, ball: arb) -> bool | None:
    """Whether a quoted number is right, from the ends of the ball in exact fractions.

    >>> says(Quoted("about", "0.41"), arb("0.414 +/- 0.0001")), says(Quoted("below", "3"), arb(4))
    (True, False)
    """
    ends = [_fraction(ball.lower()), _fraction(ball.upper())]
    printed, half = Fraction(quoted.digits), Fraction(quoted.unit) / 2
    answers = {
        {"about": abs(end - printed) < half, "below": end < printed, "above": end > printed}[
            quoted.how
        ]
        for end in ends
    }
    return answers.pop() if len(answers) == 1 else None


def _fraction(number: arb) -> Fraction:
    mantissa, exponent = number.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)

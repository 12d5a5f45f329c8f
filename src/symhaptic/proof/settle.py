"""From theorems to a verdict.  The same theorems can be held against a changed print (a mutant)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from flint import arb
from sympy import Eq, Expr, Rational, Symbol
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from symhaptic.notation.proposition import Proposition
from symhaptic.notation.terms import NoTerm, Term
from symhaptic.notation.written import written
from symhaptic.paper.propositions import Claim
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import Printed, read
from symhaptic.proof.constants import decimals, holds, measured, rounding
from symhaptic.proof.decide import compare
from symhaptic.proof.names import carrying
from symhaptic.proof.shape import misfit
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.units import UnitError, dimension_of
from symhaptic.proof.verdict import PASSES, UNSETTLED, Kind, Unfounded, Verdict

OPEN = "no theorem decides it"
"""The method of a verdict that a chapter leaves open."""

ACCEPTED = PASSES | {Kind.QUALIFIED}
"""Verdicts of what is right, with a condition or without."""

WRONG = frozenset({Kind.MISPRINT, Kind.REFUTED})
"""Verdicts of what is false as printed."""


@dataclass(frozen=True)
class Settlement:
    """Theorems of what is claimed; or a form that is a definition, or rests on data outside."""

    judged: Judged | None = None
    claim: Claim | None = None
    derived: tuple[Expr, ...] = ()
    """The form that is handed out as the derived one, or that is compared with the print."""
    external: str | None = None
    values: tuple[Expr | arb, ...] = ()
    quoted: tuple[Quoted, ...] = ()
    slip: str | None = None
    """What is meant, of a wrong name, number or reference in the text, in LaTeX."""
    left_open: bool = False
    """No theorem decides the statement; the note says what is known."""
    shows: str | None = None
    note: str | None = None
    meant: Callable[[Expr], Expr] | None = None
    """A form with what its names stand for in the chapter."""
    definitions: tuple[str, ...] = ()
    """LaTeX of the chapter's definitions from which the statement follows."""
    defines: bool = False
    """Whether the print is one of these, or they define a number of the wall: no result."""

    def decide(self, printed: Printed) -> Verdict:
        """The verdict on a printed form."""
        if self.judged is not None:
            verdict = self._judged(printed)
            if self.defines and verdict.kind is Kind.PROVED:
                verdict = replace(verdict, kind=Kind.DEFINITION)
            verdict = replace(verdict, definitions=self.definitions)
            if self.values:
                return self._constants(verdict)
            if unsaid := [q.digits for q in self.quoted if not stands_in(verdict.claim, q)]:
                raise Unfounded(f"{unsaid[0]} is printed, and neither measured nor in the claim")
            return verdict
        if told := carrying(*self.derived):
            raise Unfounded(told)
        if self.slip is not None:
            if printed:
                raise Unfounded("a slip is a statement in words; a formula is compared")
            return Verdict(Kind.SLIP, "", corrected=self.slip, shows=self.shows, note=self.note)
        if self.left_open:
            claim = None if self.claim is None else self.claim(printed)
            shown = None if claim is None else written(claim)
            return Verdict(Kind.UNDECIDED, OPEN, note=self.note, claim=claim, proposition=shown)
        if self.external is not None and not self.derived:
            return Verdict(Kind.EXTERNAL, self.external, note=self.note)
        return self._compared(printed)

    def accepts(self, printed: Printed, kinds: frozenset[Kind] = ACCEPTED) -> bool:
        """Whether the verdict on a printed form is one of these kinds."""
        try:
            return self.decide(printed).kind in kinds
        except Unfounded:
            return False

    def _judged(self, printed: Printed) -> Verdict:
        """The verdict that the theorems give."""
        assert self.judged is not None
        if self.claim is None:
            raise Unfounded("the statement has no claim that a theorem could show")
        right, lines = None, printed
        try:
            if self.judged.corrected is not None and self.judged.instead is None:
                lines = tuple(p for line in self.judged.corrected for p in read(line))
                right = self.claim(lines)
            claim = self.claim(printed)
        except (NoTerm, ValueError) as wrong:
            raise Unfounded(f"no claim can be made of the print: {wrong}") from None
        found = self.judged.decide(claim, right)
        if self.derived and self.judged.instead is None and not self._derives(lines):
            raise Unfounded("the derived form is another than what the theorem is about")
        return found

    def _derives(self, lines: Printed) -> bool:
        """Whether the derived form is this one, as they are or with what their names stand for."""
        forms = lines, self.derived
        if compare(*forms).equal:
            return True
        if self.meant is None:
            return False
        theirs, ours = (tuple(self._meant(f) for f in form) for form in forms)
        return bool(compare(theirs, ours).equal)

    def _meant(self, form: Expr) -> Expr:
        """A form with what its names stand for; a relation stays one."""
        assert self.meant is not None
        if isinstance(form, Relational):
            return form.func(*map(self.meant, form.args), evaluate=False)
        return self.meant(form)

    def _compared(self, printed: Printed) -> Verdict:
        """Compare the print of a definition, or of what rests on data outside, with our form."""
        if not printed or not self.derived:
            return UNSETTLED
        wrong = units_disagree(printed)
        note = "; ".join(filter(None, [wrong, self.note])) or None
        if unlike := misfit(printed, self.derived):
            raise Unfounded(f"what is derived is not of the shape of the print: {unlike}")
        result = compare(printed, self.derived)
        if not result.equal:
            return Verdict(Kind.UNDECIDED, result.method, note=note)
        if self.external is None and (wrong or not all(map(_defines, printed))):
            return Verdict(Kind.UNDECIDED, "it defines nothing", note=note)
        kind = Kind.DEFINITION if self.external is None else Kind.EXTERNAL
        return Verdict(kind, self.external or result.method, note=note)

    def _constants(self, verdict: Verdict) -> Verdict:
        """The verdict on the rest of the statement, with the numbers that it quotes."""
        if len(self.values) != len(self.quoted):
            raise Unfounded(f"{len(self.values)} numbers for {len(self.quoted)} that are printed")
        found = [measured(value) for value in self.values]
        each = [holds(q, number) for q, number in zip(self.quoted, found, strict=True)]
        text, radius = decimals(found[0])
        notes = [rounding(q, number) for q, number in zip(self.quoted, found, strict=True)]
        kind = verdict.kind
        if None in each:
            kind = Kind.UNDECIDED
        elif False in each:
            kind = Kind.REFUTED
        elif kind is Kind.PROVED:
            kind = Kind.ENCLOSED
        return replace(
            verdict,
            kind=kind,
            method="; ".join(dict.fromkeys([verdict.method, "ball arithmetic"])).strip("; "),
            value=text,
            radius=radius,
            note="; ".join(filter(None, [*notes, verdict.note])),
        )


def stands_in(claim: Proposition | None, quoted: Quoted) -> bool:
    """Whether a claim has a quoted number, or half a unit more or less, from where one rounds."""
    if claim is None:
        return False
    number, half = Rational(quoted.digits), Rational(str(quoted.unit)) / 2
    numbers = {Term(number + share * half) for share in (-1, 0, 1)}
    own = any(part in numbers for tree in claim.trees for part in tree.walk())
    return own or any(stands_in(part, quoted) for part in claim.parts)


def units_disagree(printed: Sequence[Expr]) -> str | None:
    """What is wrong with the units of a print; None if they agree."""
    for form in printed:
        try:
            dimension_of(form)
        except UnitError as wrong:
            return f"units disagree: {wrong}"
    return None


def _defines(form: Expr) -> bool:
    """Whether a relation says what a name stands for, and not by that name; or an expression.

    What is no equation is a range of the name, between numbers.
    """
    if not isinstance(form, Relational):
        return True
    return any(
        isinstance(name, (Symbol, AppliedUndef))
        and not other.has(name)
        and (isinstance(form, Eq) or other.is_number)
        for name, other in (form.args, form.args[::-1])
    )

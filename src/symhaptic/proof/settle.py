"""From grounds to a verdict.  The same grounds can be held against a changed print (a mutant)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import sympy as sp
from flint import arb
from sympy import Expr
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from symhaptic.notation.terms import NoTerm
from symhaptic.paper.propositions import Claim
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import Printed, read
from symhaptic.proof.condition import holds as holds_at
from symhaptic.proof.constants import decimals, holds, measured, rounding
from symhaptic.proof.counterexample import Truth, check_opposed, truth_at
from symhaptic.proof.decide import compare, equal, named
from symhaptic.proof.names import carrying
from symhaptic.proof.points import Point
from symhaptic.proof.refute import differ
from symhaptic.proof.shape import misfit
from symhaptic.proof.sign import Recipe
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.units import UnitError, dimension_of
from symhaptic.proof.verdict import PASSES, UNSETTLED, Kind, Unfounded, Verdict

OPEN = "no theorem decides it"
"""The method of a verdict that a chapter leaves open."""

ACCEPTED = PASSES | {Kind.QUALIFIED}
"""Verdicts of what is right, with a condition or without."""

WEIGHED = ACCEPTED | {Kind.MISPRINT, Kind.REFUTED}
"""Verdicts that need more than words."""

WRONG = frozenset({Kind.MISPRINT, Kind.REFUTED})
"""Verdicts of what is false as printed."""


@dataclass(frozen=True)
class Settlement:
    """The grounds on which a statement is judged; see :meth:`symhaptic.book.page.Page.settle`."""

    derived: tuple[Expr, ...] = ()
    given: Mapping[Expr, Expr] = field(default_factory=dict)
    proofs: tuple[str, ...] = ()
    definition: bool = False
    provided: str | None = None
    unless: Point | None = None
    truth: Truth = None
    specialise: Callable[[Expr], Expr] | None = None
    corrected: tuple[str, ...] | None = None
    misprint: bool = True
    values: tuple[Expr | arb, ...] = ()
    quoted: tuple[Quoted, ...] = ()
    external: str | None = None
    slip: str | None = None
    """What is meant, of a wrong name, number or reference in the text, in LaTeX."""
    left_open: bool = False
    """No theorem decides the statement; the note says what is known."""
    shows: str | None = None
    note: str | None = None
    assumed: bool = False
    """Whether what is derived is only typed, and nothing on the page shows it."""
    definitions: tuple[tuple[Expr, Expr], ...] = ()
    """What names stand for on the page."""
    signs: tuple[Recipe, ...] = ()
    """The signs that the page shows."""
    judged: Judged | None = None
    """The theorems that show it, of what is claimed."""
    claim: Claim | None = None

    def decide(self, printed: Printed) -> Verdict:
        """The verdict on a printed form; *argued* where words join what was checked, if any."""
        found = self.found(printed)
        if self.judged is not None or found.kind not in WEIGHED:
            return found
        assumed = self.assumed and found.kind is not Kind.DEFINITION
        if not assumed and not self._rests_on_words(found):
            return found
        return replace(found, kind=Kind.ARGUED, argued_for=found.kind)

    def _rests_on_words(self, found: Verdict) -> bool:
        """Whether a condition is not read, nor what a number is of, or grounds do not say what the
        statement does."""
        unread = bool(found.condition or self.values)
        return unread or (bool(self.proofs) and not self.derived)

    def found(self, printed: Printed) -> Verdict:
        """The verdict that is claimed, whatever joins its grounds."""
        if self.judged is not None:
            verdict = self._judged(printed)
            return self._constants(verdict) if self.values else verdict
        if told := carrying(*self.derived, *self.given, *self.given.values()):
            raise Unfounded(told)
        if self.slip is not None:
            if printed:
                raise Unfounded("a slip is a statement in words; a formula is compared")
            return Verdict(
                Kind.SLIP, "", corrected_latex=self.slip, shows=self.shows, note=self.note
            )
        if self.left_open:
            claim = None if self.claim is None else self.claim(printed)
            return Verdict(Kind.UNDECIDED, OPEN, note=self.note, claim=claim)
        if self.external is not None and not self.derived:
            return Verdict(Kind.EXTERNAL, self.external, note=self.note)
        if not self.values:
            return self._without_constants(printed)
        if not printed and not self.proofs:
            return self._constants(Verdict(Kind.ENCLOSED, "", note=self.note))
        return self._constants(self._without_constants(printed))

    def accepts(self, printed: Printed, kinds: frozenset[Kind] = ACCEPTED) -> bool:
        """Whether the verdict on a printed form is one of these kinds.

        As :meth:`decide`, without asking at which point a wrong form fails where that decides it.
        """
        right = not WRONG & kinds
        if (
            self.judged is None
            and right
            and printed
            and self.derived
            and not self._derives(printed)
        ):
            return False
        try:
            return self.found(printed).kind in kinds
        except Unfounded:
            return False

    def _judged(self, printed: Printed) -> Verdict:
        """The verdict that the theorems give; a printed form has to be the derived one, too."""
        if self.judged is None or self.claim is None:
            raise Unfounded("nothing formal is claimed by the statement")
        right = None
        try:
            if self.judged.corrected is not None and self.judged.instead is None:
                lines = tuple(p for line in self.judged.corrected for p in read(line))
                right = self.claim(lines)
            claim = self.claim(printed)
        except (NoTerm, ValueError) as wrong:
            raise Unfounded(f"no claim can be made of the print: {wrong}") from None
        return self.judged.decide(claim, right)

    def _without_constants(self, printed: Printed) -> Verdict:
        if not printed or not self.derived:
            return self._in_words(printed)
        note = self._noted(printed)
        if unlike := misfit(self.read(printed), self.read(self.derived)):
            raise Unfounded(f"what is derived is not of the shape of the print: {unlike}")
        result = compare(self.read(printed), self.read(self.derived))
        if result.equal is None:
            return Verdict(Kind.UNDECIDED, result.method, note=note)
        if not result.equal:
            kind = Kind.MISPRINT if self.misprint else Kind.REFUTED
            point = self._chosen(printed)
            if point is None and self.corrected is not None and self.unless is not None:
                raise Unfounded("nothing differs at the counterexample")
            point = point or result.point
            return Verdict(
                kind,
                self._right_form(),
                condition=self.provided,
                corrected=self.derived,
                corrected_latex=self._correction(),
                counterexample=named(point),
                shows=self.shows,
                note=note,
            )
        if self.external is not None:
            return Verdict(Kind.EXTERNAL, self.external, note=note)
        if self.provided is not None:
            return self._qualified(printed, result.method, note)
        self._check_unopposed()
        agree = not any(map(_of_two_units, printed))
        defined = self.definition and agree and all(map(_defines, self.derived))
        return Verdict(Kind.DEFINITION if defined else Kind.PROVED, result.method, note=note)

    # -- the kinds ----------------------------------------------------------------------

    def _in_words(self, printed: Printed) -> Verdict:
        if not self.proofs:
            return UNSETTLED
        if printed:
            raise Unfounded("a printed formula is compared with a derived one, not argued for")
        method = "; ".join(dict.fromkeys(self.proofs))
        if self.corrected is not None:
            if self.unless is None:
                raise Unfounded("a false statement needs a counterexample")
            self._check_counterexample(printed)
            kind = Kind.MISPRINT if self.misprint else Kind.REFUTED
            return Verdict(
                kind,
                method,
                condition=self.provided,
                corrected_latex=r",\quad ".join(self.corrected),
                counterexample=named(self.unless),
                shows=self.shows,
                note=self.note,
            )
        if self.provided is not None:
            return self._qualified(printed, method, self.note)
        self._check_unopposed()
        return Verdict(Kind.PROVED, method, note=self.note)

    def _qualified(self, printed: Printed, method: str, note: str | None) -> Verdict:
        if self.unless is None:
            raise Unfounded("a condition needs a counterexample without it")
        self._check_counterexample(printed)
        return Verdict(
            Kind.QUALIFIED,
            method,
            condition=self.provided,
            counterexample=named(self.unless),
            shows=self.shows,
            note=note,
        )

    def _constants(self, verdict: Verdict) -> Verdict:
        """The verdict on the rest of the statement, with the numbers that it quotes."""
        if len(self.values) != len(self.quoted):
            raise Unfounded(f"{len(self.values)} numbers for {len(self.quoted)} that are printed")
        found = [measured(value) for value in self.values]
        each = [holds(q, number) for q, number in zip(self.quoted, found, strict=True)]
        text, radius = decimals(found[0])
        notes = [rounding(q, number) for q, number in zip(self.quoted, found, strict=True)]
        kind, shows, point = verdict.kind, verdict.shows, verdict.counterexample
        if None in each:
            kind = Kind.UNDECIDED
        elif False in each:
            kind, shows, point = Kind.REFUTED, self.shows, point or {}
        elif kind in PASSES:
            kind = Kind.ENCLOSED
        return replace(
            verdict,
            kind=kind,
            method="; ".join(dict.fromkeys([verdict.method, "ball arithmetic"])).strip("; "),
            counterexample=point,
            shows=shows,
            value=text,
            radius=radius,
            note="; ".join(filter(None, [*notes, verdict.note])),
        )

    # -- checks -------------------------------------------------------------------------

    def _check_unopposed(self) -> None:
        """What is proved without a condition has no counterexample."""
        if self.unless is not None:
            raise Unfounded("a counterexample stands against what is said to be proved")

    def _check_counterexample(self, printed: Printed) -> None:
        point = self.unless or {}
        if self.truth is None:
            if self.shows is None:
                raise Unfounded("the counterexample shows nothing")
            raise Unfounded("the counterexample needs the truth beside it")
        if self.provided is not None and holds_at(self.provided, point):
            raise Unfounded("the condition holds at the counterexample")
        theirs = truth_at(self.truth, point)
        special = self.specialise or (lambda form: form)
        check_opposed(tuple(special(p) for p in printed), theirs, point)

    def _derives(self, printed: Printed) -> bool:
        return equal(self.read(printed), self.read(self.derived))

    def _chosen(self, printed: Printed) -> Point | None:
        """The counterexample that was chosen, if printed and derived form do differ there."""
        if self.unless is None or len(printed) != len(self.derived):
            return None
        for ours, theirs in zip(self.read(printed), self.read(self.derived), strict=True):
            if isinstance(ours, sp.Eq) and isinstance(theirs, sp.Eq) and ours.lhs == theirs.lhs:
                ours, theirs = ours.rhs, theirs.rhs
            if differ(ours, theirs, self.unless) is not None:
                return self.unless
        return None

    def read(self, forms: tuple[Expr, ...]) -> tuple[Expr, ...]:
        """Forms with the definitions that are in force put in."""
        return tuple(_placed(form, self.given) for form in forms)

    def _noted(self, printed: Printed) -> str | None:
        wrong = next(filter(None, map(_of_two_units, printed)), None)
        told = f"units disagree: {wrong}" if wrong else None
        return "; ".join(filter(None, [told, self.note])) or None

    def _right_form(self) -> str:
        if self.corrected is None:
            return "the derived form is another"
        right = tuple(p for line in self.corrected for p in read(line))
        result = compare(self.read(right), self.read(self.derived))
        if not result.equal:
            raise Unfounded(f"the corrected form is not the derived one: {result.method}")
        return f"as corrected {result.method}"

    def _correction(self) -> str | None:
        return None if self.corrected is None else r",\quad ".join(self.corrected)


def is_name(of: Expr) -> bool:
    """Whether it has no value of its own, so that one may say what it stands for."""
    return isinstance(of, (sp.Symbol, AppliedUndef))


def _of_two_units(printed: Expr) -> str | None:
    """What is wrong with a printed form by its units, if anything is."""
    try:
        dimension_of(printed)
    except UnitError as wrong:
        return str(wrong)
    return None


def _defines(form: Expr) -> bool:
    """Whether a relation says what a name stands for, and not by that name; or an expression."""
    if not isinstance(form, Relational):
        return True
    return any(is_name(s) and not o.has(s) for s, o in (form.args, form.args[::-1]))


def _placed(form: Expr, given: Mapping[Expr, Expr]) -> Expr:
    """A form with definitions put in, its relations left as they are."""
    if isinstance(form, Relational):
        return form.func(*(side.xreplace(dict(given)) for side in form.args), evaluate=False)
    return form.xreplace(dict(given))

"""A chapter: steps that are proved as they are written down, and the verdicts they lead to.

A derivation file has a docstring (title, blank line, introduction) and a function
``derive(page)``.  It talks to the :class:`Page`, whose steps (:mod:`symhaptic.book.steps`) are
proved or raise :class:`FalseStep`, and which finds the verdicts of statements on what they show.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from typing import Any, TypeAlias

from sympy import Eq, Expr, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.book import following
from symhaptic.book.record import FalseStep, in_latex
from symhaptic.book.sources import CLAIMED, NO_ID, STATEMENTS, is_id
from symhaptic.book.steps import Steps
from symhaptic.notation.latex import latex
from symhaptic.notation.proposition import Proposition, Terms, proposition
from symhaptic.notation.terms import NoTerm
from symhaptic.paper import Statement
from symhaptic.paper.reading import Printed, Unreadable, read
from symhaptic.proof.enclosed import Source
from symhaptic.proof.settle import Settlement, stands_in
from symhaptic.proof.shape import Form, parts
from symhaptic.proof.theorems.judge import Case, Judged, concludes, of_print, taken_apart
from symhaptic.proof.theorems.kernel import NotShown, Theorem, conj
from symhaptic.proof.theorems.tactics import as_claimed, counterexample, example
from symhaptic.proof.verdict import Kind, Verdict

At: TypeAlias = Case | Terms | tuple[Any, ...]
"""A case, as a point at which all is numbers, or as a point and theorems of what holds there."""


class Page(Steps):
    """What a derivation writes on; see the module for what is proved."""

    def state(
        self,
        id: str,
        says: str,
        *printed: str,
        claim: Proposition | None = None,
        condition: bool = False,
    ) -> Statement:
        """State something of one's own, to be settled like the paper's statements.

        Formulas are LaTeX; ``claim`` is what is said, as a proposition, in which the print is
        concluded or, as a ``condition``, stands beside a predicate.
        """
        for line in printed:
            read(line)
        in_latex(id, *printed)
        if id in STATEMENTS:
            raise FalseStep(f"the id {id!r} is taken by the paper")
        if not is_id(id):
            raise FalseStep(NO_ID.format(id))
        self._once("stated", id)
        if claim is not None:
            self.claimed[id] = partial(of_print, claim, condition=condition)
        self.own[id] = Statement(id, self.name, says, printed, condition=condition)
        return self.own[id]

    def settle(
        self,
        id: str,
        *grounds: Form | Theorem,
        definition: bool = False,
        unless: Sequence[At] | Mapping[Any, Any] | None = None,
        example: At | None = None,
        instead: Proposition | None = None,
        enclosed: bool = False,
        corrected: Sequence[str] | None = None,
        misprint: bool = True,
        value: Source | Sequence[Source] | None = None,
        shows: str | None = None,
        note: str | None = None,
    ) -> Verdict:
        """Settle a statement; the verdict is found, not given.

        A theorem has to say what the statement claims (:mod:`symhaptic.proof.theorems.judge`).  A
        theorem of its conclusion is taken under the claim's own hypotheses, for all values of its
        symbols.  With further hypotheses the statement is qualified, if there is an ``example`` at
        which all hypotheses hold and, in ``unless``, a case for each further one in which it alone
        is violated and the claim fails: a mapping of hypotheses to cases.  Of what is false, the
        theorem is of the ``corrected`` print, or of what holds ``instead``, and ``unless`` lists
        cases in which the claim fails.  A case is a point, or a tuple of a point and theorems
        of what holds there.  ``value`` is the number that the text quotes.

        Without a theorem, equations are shown from the definitions on the page: the verdict names
        those.  A print that is wrong is a misprint of the equations given, and ``unless`` may be
        a point at which it fails.  With ``definition`` the print introduces a name.
        """
        statement = self._statement(id)
        in_latex(id, *(corrected or ()))
        if instead is not None:
            _told(id, corrected or (), instead)
        theorems = [g for g in grounds if isinstance(g, Theorem)]
        forms = tuple(p for g in grounds if not isinstance(g, Theorem) for p in parts(g))
        if definition:
            for form in forms:
                if isinstance(form, Eq) and isinstance(form.lhs, (Symbol, AppliedUndef)):
                    self._defined(form.lhs, form.rhs, once=False)
            return self._record(statement, Settlement(derived=forms, note=note))
        if not theorems:
            point = dict(unless) if isinstance(unless, Mapping) else None
            return self._follows(statement, forms, point, corrected, value, note)
        theorem = theorems[0] if len(theorems) == 1 else conj(*theorems)
        if theorem.hypotheses or theorem.conclusion.free:
            more = tuple(unless) if isinstance(unless, Mapping) else ()
            with suppress(NoTerm, NotShown, ValueError):  # the judge says what is wrong
                theorem = as_claimed(instead or self._right(id, corrected), theorem, *more)
        judged = Judged(
            theorem=theorem,
            example=_example(example, theorem),
            unless=tuple(self._failures(id, unless or (), theorem)),
            corrected=None if corrected is None else tuple(corrected),
            instead=instead,
            misprint=misprint,
            enclosed=enclosed,
            shows=shows,
            note=note,
        )
        settlement = Settlement(
            judged,
            self.claimed.get(id) or CLAIMED.get(id),
            forms,
            values=self._quoted(value, statement, judged.theorem.conclusion),
            quoted=statement.quoted,
            note=note,
            meant=self._meant,
        )
        return self._record(statement, settlement)

    def claim(self, id: str, printed: Sequence[Expr] | None = None) -> Proposition:
        """Return what a statement claims, or would claim with another print."""
        claim = self.claimed.get(id) or CLAIMED.get(id)
        if claim is None:
            raise NotShown(f"{id} claims nothing that a theorem could show")
        return claim(self._statement(id).printed if printed is None else tuple(printed))

    def _right(self, id: str, corrected: Sequence[str] | None) -> Proposition:
        """The claim of a statement with its correct print."""
        lines = None if corrected is None else [p for line in corrected for p in read(line)]
        return self.claim(id, lines)

    def _failures(
        self, id: str, unless: Sequence[At] | Mapping[Any, Any], theorem: Theorem
    ) -> Iterator[Case]:
        """Cases in which the claim fails, and of the further hypotheses just one."""
        pairs = unless.items() if isinstance(unless, Mapping) else ((None, at) for at in unless)
        for but, at in pairs:
            if isinstance(at, Case):
                yield at
                continue
            point, *theorems = at if isinstance(at, tuple) else (at,)
            claim, holds = self.claim(id), []
            if but is not None:
                supposed = (*taken_apart(claim)[1], proposition(but))
                holds = [p for p in taken_apart(theorem.conclusion)[1] if p not in supposed]
            yield counterexample(claim, point, *theorems, holds=holds, but=but)

    def _follows(
        self,
        statement: Statement,
        derived: Sequence[Expr],
        point: dict[Expr, Expr] | None,
        corrected: Sequence[str] | None,
        value: Source | Sequence[Source] | None,
        note: str | None,
    ) -> Verdict:
        """Settle equations by the definitions on the page."""
        definitions = tuple(self.definitions)
        if not statement.printed or statement.id in CLAIMED or statement.id in self.claimed:
            return self._record(statement, Settlement(note=note))
        if statement.quoted and value is None:
            raise FalseStep(f"{statement.id}: the text quotes a number, too; give value=")
        right = tuple(p for line in corrected or () for p in read(line)) or derived
        try:
            judged, claimed = following.settled(statement.printed, right, definitions, point)
        except NotShown as wrong:
            verdict = Verdict(Kind.UNDECIDED, f"it does not follow from the definitions: {wrong}")
            return self._record(statement, Settlement(note=note), verdict)
        except (NoTerm, following.Undefinable) as wrong:
            raise FalseStep(f"{statement.id}: {wrong}") from None

        def claim(printed: Printed) -> Proposition:
            return following.of_print(printed, definitions).claim

        used = tuple(f"{latex(name)}:={latex(meaning)}" for name, meaning in claimed.used)
        settlement = Settlement(
            judged,
            claim,
            values=self._quoted(value, statement, claimed.claim),
            quoted=statement.quoted,
            note=note,
            definitions=used,
            defines=claimed.is_definition,
        )
        return self._record(statement, settlement)

    def _statement(self, id: str) -> Statement:
        statement = STATEMENTS.get(id) or self.own.get(id)
        if statement is None:
            raise FalseStep(f"no statement {id!r}")
        return statement

    def _quoted(
        self, value: Source | Sequence[Source] | None, statement: Statement, shown: Proposition
    ) -> tuple[Expr, ...]:
        """The numbers that a text quotes, as expressions; a number that only the chapter gives
        shows nothing."""
        values = () if value is None else value if isinstance(value, Sequence) else (value,)
        if values and (unsaid := [q for q in statement.quoted if not stands_in(shown, q)]):
            raise FalseStep(f"{statement.id}: {unsaid[0].digits} does not stand in what is shown")
        return tuple(v if isinstance(v, Expr) else self._shown(v) for v in values)

    def settle_external(self, id: str, rests: str, checked: str, *follows: Form) -> Verdict:
        """Settle a statement that rests on something outside the paper: on what, what was checked.

        A printed formula that ``follows`` from it is compared with what was derived.
        """
        derived = tuple(p for form in follows for p in parts(form))
        settlement = Settlement(derived=derived, external=rests, note=checked)
        return self._record(self._statement(id), settlement)

    def settle_slip(self, id: str, wrong: str, right: str, shows: str) -> Verdict:
        """A ``wrong`` name, number or reference in the text: LaTeX of the right one, and why.

        What is wrong stands in the quotation.  A slip is no theorem, and is not counted as one.
        """
        statement = self._statement(id)
        if not wrong.strip() or wrong not in statement.quote:
            raise FalseStep(f"{id}: {wrong!r} does not stand in the quotation of the statement")
        in_latex(id, right)
        return self._record(statement, Settlement(slip=right, shows=shows))

    def leave_open(self, id: str, note: str) -> Verdict:
        """List a statement as undecided; ``note`` says which parts of it are known.

        An undecided statement never passes.
        """
        statement = self._statement(id)
        claim = self.claimed.get(id) or CLAIMED.get(id)
        return self._record(statement, Settlement(left_open=True, note=note, claim=claim))


def _example(at: At | None, theorem: Theorem) -> Case | None:
    """The case in which all hypotheses of a theorem hold."""
    if at is None or isinstance(at, Case):
        return at
    point, *theorems = at if isinstance(at, tuple) else (at,)
    return example(point, taken_apart(theorem.conclusion)[1], *theorems)


def _told(id: str, corrected: Sequence[str], instead: Proposition) -> None:
    """Refuse relations that are shown for what holds instead, and are no part of it.

    Words are shown as they are.
    """
    for line in corrected:
        try:
            forms = read(line)
        except Unreadable:
            continue
        if not all(concludes(instead, form) for form in forms):
            raise FalseStep(f"{id}: what holds instead does not conclude {line}")

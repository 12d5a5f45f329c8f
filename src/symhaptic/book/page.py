"""A chapter: steps that are proved as they are written down, and the verdicts they lead to.

A derivation file has a docstring (title, blank line, introduction) and a function
``derive(page)``.  It talks to the :class:`Page`, whose steps (:mod:`symhaptic.book.steps`) are
proved or raise :class:`FalseStep`, and which finds the verdicts of statements on what they show.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import sympy as sp
from sympy import Expr
from sympy.core.function import AppliedUndef

from symhaptic.book.grounds import not_defined, shows, unproved
from symhaptic.book.record import Evidence, FalseStep, in_latex
from symhaptic.book.sources import CLAIMED, NO_ID, STATEMENTS, is_id
from symhaptic.book.steps import Steps
from symhaptic.notation.proposition import Proposition, of_print
from symhaptic.paper import Statement
from symhaptic.paper.reading import read
from symhaptic.proof.checks import Check, Sign
from symhaptic.proof.counterexample import Truth, Witness
from symhaptic.proof.enclosed import Source
from symhaptic.proof.points import Point
from symhaptic.proof.settle import ACCEPTED, Settlement
from symhaptic.proof.shape import Form, parts
from symhaptic.proof.sign import Fact, recipe
from symhaptic.proof.theorems.judge import Case, Judged
from symhaptic.proof.theorems.kernel import Theorem, conjoined
from symhaptic.proof.verdict import Verdict


class Page(Steps):
    """What a derivation writes on; see the module for what is proved."""

    def state(
        self, id: str, says: str, *printed: str, claim: Proposition | None = None
    ) -> Statement:
        """A statement of one's own, to be settled like those of the paper; formulas in LaTeX.

        ``claim`` is what it says, as a proposition.
        """
        for line in printed:
            read(line)
        if id in STATEMENTS:
            raise FalseStep(f"the id {id!r} is taken by the paper")
        if not is_id(id):
            raise FalseStep(NO_ID.format(id))
        self._once("stated", id)
        if claim is not None:
            self.claimed[id] = partial(of_print, claim)
        self.own[id] = Statement(id, self.name, says, printed)
        return self.own[id]

    def settle(
        self,
        id: str,
        *grounds: Form | Evidence | Fact | Witness | Theorem,
        definition: bool = False,
        given: Mapping[Expr, Expr] | None = None,
        provided: str | None = None,
        unless: Point | Sequence[Case] | None = None,
        example: Case | None = None,
        instead: Proposition | None = None,
        enclosed: bool = False,
        truth: Truth = None,
        specialise: Callable[[Expr], Expr] | None = None,
        corrected: Sequence[str] | None = None,
        misprint: bool = True,
        value: Source | Sequence[Source] | None = None,
        shows: str | None = None,
        note: str | None = None,
    ) -> Verdict:
        """Settle a statement on these grounds; the verdict is found, not given.

        ``grounds`` are the derived form (compared with the printed one) or proofs of what the
        statement says in words; of a form that no definition, step with a ``name`` or sign on the
        page shows the verdict is *argued*; ``given`` are definitions in force, put into both.
        ``provided`` names a condition that the paper leaves out and ``unless`` a point without
        it where the statement fails, that is where the printed form (after ``specialise``) and
        the ``truth`` differ.  ``corrected`` is LaTeX of the right form, proved like any other.
        ``value`` is the number that the text quotes, or several, each given by what shows it.

        A theorem among the grounds has to say what the statement claims, see
        :mod:`symhaptic.proof.theorems.judge`: with further hypotheses it is qualified, if there is
        an ``example`` at which they hold and, in ``unless``, a case for each in which it alone is
        violated and the claim fails.  Of what is false, the theorem is of the ``corrected`` print,
        or of what holds ``instead``, which ``corrected`` then says in short.
        """
        statement = STATEMENTS.get(id) or self.own.get(id)
        if statement is None:
            raise FalseStep(f"no statement {id!r}")
        if not isinstance(provided, str | None):
            raise FalseStep(f"{id}: provided: {provided} is not allowed; LaTeX of a condition is")
        in_latex(id, provided, shows)
        theorems = [g for g in grounds if isinstance(g, Theorem)]
        proving = (Evidence, Fact, Witness, Theorem)
        forms = [p for g in grounds if not isinstance(g, proving) for p in parts(g)]
        proofs = [
            g.reason if isinstance(g, Fact) else g.method
            for g in grounds
            if isinstance(g, (Evidence, Fact, Witness))
        ]
        if theorems:
            judged = Judged(
                theorem=theorems[0] if len(theorems) == 1 else conjoined(*theorems),
                example=example,
                unless=tuple(unless or ()),
                corrected=None if corrected is None else tuple(corrected),
                instead=instead,
                misprint=misprint,
                enclosed=enclosed,
                shows=shows,
                note=note,
            )
            settlement = Settlement(
                tuple(forms),
                judged=judged,
                claim=self.claimed.get(id) or CLAIMED.get(id),
                values=self._quoted(value),
                quoted=statement.quoted,
            )
            return self._record(statement, settlement)
        checks = tuple(check for g in grounds for check in _checks(g))
        for ground in grounds:
            if isinstance(ground, Fact):
                self._keep(ground)
                if wrong := unproved(ground, self.supposed):
                    raise FalseStep(f"{id}: {wrong}")
        for fact in _facts(truth):
            if wrong := unproved(fact, self.supposed):
                raise FalseStep(f"{id}: {wrong}")
        self._put_in(id, given)
        settlement = Settlement(
            derived=tuple(forms),
            proofs=tuple(proofs),
            given=dict(given or {}),
            definition=definition,
            provided=provided,
            unless=unless,  # type: ignore[arg-type]
            truth=truth,
            specialise=specialise,
            corrected=None if corrected is None else tuple(corrected),
            misprint=misprint,
            values=self._quoted(value),
            quoted=statement.quoted,
            shows=shows,
            note=note,
        )
        verdict = self._record(statement, self._beside_the_page(settlement), checks)
        if verdict.kind in ACCEPTED:
            for form in forms:
                if isinstance(form, sp.Eq) and isinstance(form.lhs, (sp.Symbol, AppliedUndef)):
                    self._defined(form.lhs, form.rhs)
        return verdict

    def _quoted(self, value: Source | Sequence[Source] | None) -> tuple[Expr, ...]:
        """The numbers that a text quotes, as expressions."""
        values = () if value is None else value if isinstance(value, Sequence) else (value,)
        return tuple(v if isinstance(v, Expr) else self._shown(v) for v in values)

    def settle_external(
        self,
        id: str,
        rests: str,
        checked: str,
        *follows: Form,
        given: Mapping[Expr, Expr] | None = None,
    ) -> Verdict:
        """A statement that rests on something outside the paper: on what, and what was checked.

        A printed formula that ``follows`` from it is compared with what was derived.
        """
        statement = STATEMENTS.get(id) or self.own.get(id)
        if statement is None:
            raise FalseStep(f"no statement {id!r}")
        derived = tuple(p for form in follows for p in parts(form))
        self._put_in(id, given)
        settlement = Settlement(derived, dict(given or {}), external=rests, note=checked)
        return self._record(statement, settlement)

    def settle_slip(self, id: str, wrong: str, right: str, shows: str) -> Verdict:
        """A ``wrong`` name, number or reference in the text: LaTeX of the right one, and why.

        What is wrong stands in the quotation.  A slip is no theorem, and is not counted as one.
        """
        statement = STATEMENTS.get(id) or self.own.get(id)
        if statement is None:
            raise FalseStep(f"no statement {id!r}")
        if wrong not in statement.quote:
            raise FalseStep(f"{id}: {wrong!r} does not stand in the quotation of the statement")
        in_latex(id, right, shows)
        return self._record(statement, Settlement(slip=right, shows=shows))

    def leave_open(self, id: str, note: str) -> Verdict:
        """List a statement as undecided; ``note`` says which parts of it are known.

        An undecided statement never passes.
        """
        statement = STATEMENTS.get(id) or self.own.get(id)
        if statement is None:
            raise FalseStep(f"no statement {id!r}")
        in_latex(id, note)
        claim = self.claimed.get(id) or CLAIMED.get(id)
        return self._record(statement, Settlement(left_open=True, note=note, claim=claim))

    def _beside_the_page(self, settlement: Settlement) -> Settlement:
        """With what the page shows of the forms."""
        facts = [check.fact for _, check in self.checks if isinstance(check, Sign)]
        return replace(
            settlement,
            assumed=not shows(settlement.derived, self.definitions, facts),
            definitions=tuple(self.definitions),
            signs=tuple(map(recipe, facts)),
        )

    def _put_in(self, id: str, given: Mapping[Expr, Expr] | None) -> None:
        """Only definitions are put into a statement."""
        if wrong := not_defined(given or {}, self.definitions):
            raise FalseStep(f"{id}: {wrong}")


def _facts(truth: Truth) -> tuple[Fact, ...]:
    """The fact in what is true at a counterexample."""
    last = truth[-1] if isinstance(truth, tuple) and truth else truth
    return (last,) if isinstance(last, Fact) else ()


def _checks(ground: Any) -> tuple[Check, ...]:
    """What was asked for a ground that is no form."""
    match ground:
        case Evidence():
            return ground.checks
        case Witness():
            return () if ground.check is None else (ground.check,)
        case Fact():
            return (Sign(ground),)
    return ()

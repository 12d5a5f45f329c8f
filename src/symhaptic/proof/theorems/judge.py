"""From a theorem to a verdict: what it says is held against what the statement claims.

A claim is a proposition, for all values of some symbols under hypotheses.  It is *proved* by a
theorem that says just that, *qualified* by one with further hypotheses and, for each of these, a
point at which that one alone fails and with it the claim, and *wrong* where the claim is denied;
then what holds instead is a theorem, too.  Nothing open, nothing vacuous.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from sympy import Eq, Expr, Le, Lt, Ne, Symbol
from sympy.core.relational import Relational

from symhaptic.notation.predicates import JUDGING
from symhaptic.notation.proposition import (
    FALSE,
    TRUE,
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Predicate,
    Proposition,
    Relation,
    Terms,
    both,
    conjuncts,
    negated,
    proposition,
)
from symhaptic.notation.written import listed, point, written
from symhaptic.proof.decide import equal
from symhaptic.proof.theorems.derivation import leaves_of
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    assume,
    conjunct,
    contr,
    covers,
    exists,
    mp,
    not_intro,
    spec,
)
from symhaptic.proof.verdict import Kind, Unfounded, Verdict


@dataclass(frozen=True)
class Case:
    """A point, and the theorem of what is true there."""

    values: Terms
    theorem: Theorem

    def exists(self, symbols: Sequence[Symbol], given: Sequence[Proposition]) -> bool:
        """Whether the theorem shows that all of these hold at the point."""
        claim = And(tuple(given))
        wanted = claim.at(self.values)
        if not covers(self.theorem.conclusion, wanted):
            return False
        try:
            there = conjunct(self.theorem, wanted)
            values = {s: v for s, v in self.values.items() if s in symbols}
            return not exists(there, Exists(tuple(values), claim), values).hypotheses
        except NotShown:
            return False

    def refutes(self, claim: Proposition) -> bool:
        """Whether the theorem shows that the claim is false, by this instance of it."""
        try:
            denial = assume(claim)
            if isinstance(denial.conclusion, ForAll):
                denial = spec(denial, {s: self.values[s] for s in denial.conclusion.over})
            if isinstance(denial.conclusion, Implies):
                given, _ = denial.conclusion.of
                denial = mp(denial, conjunct(self.theorem, given))
            if FALSE in conjuncts(denial.conclusion):  # a side of a relation has no value there
                never = conjunct(denial, FALSE)
                contrary = contr(never, TRUE), contr(never, Not((TRUE,)))
                return not not_intro(*contrary, claim).hypotheses
            for known in conjuncts(self.theorem.conclusion):
                if _opposed(known, denial.conclusion):
                    return not not_intro(denial, conjunct(self.theorem, known), claim).hypotheses
        except (NotShown, KeyError):
            pass
        return False

    def denies(self, condition: Proposition) -> bool:
        """Whether the theorem says that a condition is violated at the point."""
        there = condition.at(self.values)
        return any(_opposed(known, there) for known in conjuncts(self.theorem.conclusion))


def _opposed(one: Proposition, other: Proposition) -> bool:
    """Whether one proposition is the negation of the other, or the opposite relation."""
    return one == Not((other,)) or (isinstance(other, Relation) and one == negated(other))


@dataclass(frozen=True)
class Judged:
    """The theorems on which a statement is settled."""

    theorem: Theorem
    example: Case | None = None
    """A point at which all hypotheses hold: the theorem is not vacuous."""
    unless: tuple[Case, ...] = ()
    corrected: tuple[str, ...] | None = None
    """LaTeX of the right form; the theorem is then that of the corrected claim."""
    instead: Proposition | None = None
    """What holds instead of a false statement in words; the theorem is then of this.

    ``corrected`` is then what a reader sees of it, short.
    """
    misprint: bool = True
    enclosed: bool = False
    shows: str | None = None
    note: str | None = None

    def decide(self, claim: Proposition, right: Proposition | None = None) -> Verdict:
        """The verdict on a claim; ``right`` is the claim with the corrected print."""
        if self.theorem.hypotheses:
            raise Unfounded(f"open: {listed(sorted(self.theorem.hypotheses, key=written))}")
        right = self.instead if right is None else right
        if right is not None:
            return self._wrong(claim, right)
        extra = _extra(claim, self.theorem.conclusion)
        self._check_example(self.theorem.conclusion)
        if not extra:
            if self.unless:
                raise Unfounded("a counterexample stands against what is said to be proved")
            return self._verdict(Kind.ENCLOSED if self.enclosed else Kind.PROVED, claim)
        for condition in extra:
            others = [c for c in extra if c is not condition]
            if not any(_violates(case, claim, others, condition) for case in self.unless):
                raise Unfounded(f"no counterexample violates just {written(condition)}")
        found = self._verdict(Kind.QUALIFIED, claim)
        return replace(
            found, condition=written(both(extra)), counterexample=point(dict(self.unless[0].values))
        )

    def _wrong(self, claim: Proposition, right: Proposition) -> Verdict:
        if not self.unless or not all(case.refutes(claim) for case in self.unless):
            raise Unfounded("a false statement needs a counterexample")
        extra = _extra(right, self.theorem.conclusion)
        self._check_example(self.theorem.conclusion)
        return replace(
            self._verdict(Kind.MISPRINT if self.misprint else Kind.REFUTED, claim),
            condition=written(both(extra)) if extra else None,
            counterexample=point(dict(self.unless[0].values)),
            corrected=r",\quad ".join(self.corrected or ()) or written(right),
        )

    def _check_example(self, conclusion: Proposition) -> None:
        symbols, given, _ = taken_apart(conclusion)
        if not given:
            return
        if self.example is None or not self.example.exists(symbols, given):
            raise Unfounded("no point is given at which all hypotheses hold")

    def _verdict(self, kind: Kind, claim: Proposition) -> Verdict:
        rests = leaves_of(self.theorem)
        for case in self.unless:
            for name, count in leaves_of(case.theorem).items():
                rests[name] = rests.get(name, 0) + count
        return Verdict(
            kind,
            "a theorem of the kernel",
            shows=self.shows,
            note=self.note,
            claim=claim,
            proposition=written(claim),
            rests=tuple(sorted(rests)),
        )


def taken_apart(
    claim: Proposition,
) -> tuple[tuple[Symbol, ...], tuple[Proposition, ...], Proposition]:
    """Symbols, hypotheses and conclusion of a claim."""
    symbols: tuple[Symbol, ...] = ()
    if isinstance(claim, ForAll):
        symbols, claim = claim.over, claim.body
    if isinstance(claim, Implies):
        return symbols, conjuncts(claim.of[0]), claim.of[1]
    return symbols, (), claim


def supposed(conclusion: Proposition) -> Iterator[Proposition]:
    """The hypotheses that a conclusion has of its own, in the parts that may hold a print."""
    if isinstance(conclusion, Implies):
        yield from conjuncts(conclusion.of[0])
    parts = conclusion.of[1:] if isinstance(conclusion, Implies) else conclusion.parts
    for part in parts if isinstance(conclusion, (And, Iff, ForAll, Implies)) else ():
        yield from supposed(part)


def of_print(claim: Proposition, printed: Iterable[Expr], condition: bool = False) -> Proposition:
    """Return a claim that says what is printed; raise :class:`ValueError` for another one.

    What is printed as a relation is concluded as that relation, for all values of its symbols under
    hypotheses that do not decide it; a claim may conclude more.  A print that is a ``condition``
    implies named predicates, is implied by one, or is equivalent to it.
    """
    _, given, then = taken_apart(claim)
    concluded = conjuncts(then)
    for form in printed:
        if not isinstance(form, Relational):
            raise ValueError(f"the print {form} is no relation that could be claimed")
        relation = proposition(form)
        supposed = any(_says(hypothesis, relation) for hypothesis in given)
        if condition:
            joined = [p for p in concluded if isinstance(p, (Implies, Iff))]
            pairs = [(And(given), then), *(p.of for p in joined)]
            pairs += [p.of[::-1] for p in joined if isinstance(p, Iff)]
            if not any(_is_condition(relation, *pair) for pair in pairs):
                raise ValueError(f"the print {form} is no condition of a predicate in the claim")
            supposed = supposed and relation in concluded
        elif relation not in concluded:
            raise ValueError(f"the claim does not conclude the print {form}")
        if supposed:
            raise ValueError(f"the claim supposes the print {form}")
    return claim


def concludes(claim: Proposition, form: Expr) -> bool:
    """Whether a claim has a relation, or a positive multiple of it, among its conclusions."""
    if not isinstance(form, Relational):
        return False
    return any(_says(part, proposition(form)) for part in conjuncts(taken_apart(claim)[2]))


def _is_condition(relation: Proposition, one: Proposition, other: Proposition) -> bool:
    """Whether, of one proposition that implies another, a relation is on a predicate's side.

    The predicate judges a wall or a loop, and has all symbols of the relation: that a number is
    whole, or a polynomial of degree 2, says nothing of which walls are passive.
    """

    def judges(claim: Proposition, stated: Proposition) -> bool:
        named = isinstance(claim, Predicate) and claim.name in JUDGING
        return named and relation.free & stated.free <= claim.free

    if relation in _stated(one):
        return all(judges(p, one) for p in conjuncts(other))
    return relation in _stated(other) and any(judges(p, other) for p in conjuncts(one))


def _stated(of: Proposition) -> list[Proposition]:
    """The parts of a conjunction, those for all values of a symbol included."""
    if isinstance(of, And):
        return [p for part in of.parts for p in _stated(part)]
    if isinstance(of, ForAll):
        return _stated(taken_apart(of)[2])
    return [of]


def _says(hypothesis: Proposition, print_: Proposition) -> bool:
    """Whether a hypothesis is the print or a multiple of it, or is made of such."""
    if hypothesis == print_:
        return True
    if hypothesis.parts:
        return any(_says(part, print_) for part in hypothesis.parts)
    pair = (hypothesis, print_)
    if not all(isinstance(p, Relation) for p in pair):
        return False
    one, other = (_SYMPY[p.sign](p.left, p.right, evaluate=False) for p in pair)  # type: ignore[attr-defined]
    return equal(one, other)


_SYMPY = {"=": Eq, "!=": Ne, "<": Lt, "<=": Le}


class SaysElse(Unfounded):
    """A theorem says something else than the statement; both are written when that is read."""

    def __init__(self, shown: Proposition, claim: Proposition) -> None:
        super().__init__(shown, claim)
        self.shown, self.claim = shown, claim

    def __str__(self) -> str:
        return f"the theorem says {written(self.shown)}, the statement {written(self.claim)}"


def _extra(claim: Proposition, shown: Proposition) -> tuple[Proposition, ...]:
    """The hypotheses that what was shown has beside those of the claim."""
    if claim == shown:
        return ()
    symbols, given, then = taken_apart(claim)
    others, more, same = taken_apart(shown)
    if symbols != others or then != same or not set(given) <= set(more):
        raise SaysElse(shown, claim)
    extra = tuple(p for p in more if p not in given)
    if set(conjuncts(then)) & set(extra):
        raise Unfounded("the condition is what is claimed")
    return extra


def _violates(
    case: Case, claim: Proposition, others: Sequence[Proposition], condition: Proposition
) -> bool:
    """Whether a claim fails at a point where one condition is violated and the others hold."""
    symbols, given, _ = taken_apart(claim)
    shown = case.exists(symbols, [*given, *others])
    return shown and case.denies(condition) and case.refutes(claim)

"""Steps that are taken often, made of rules; nothing here has to be believed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Symbol

from symhaptic.notation.proposition import (
    TRUE,
    ForAll,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
    Terms,
    conjuncts,
    implied,
    negated,
    proposition,
)
from symhaptic.proof.theorems.familiar import decided, divided, ordered, sign_of
from symhaptic.proof.theorems.judge import Case, taken_apart
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    add_assum,
    assume,
    conj,
    conjunct,
    contr,
    disch,
    disj_cases,
    gen,
    imp_antisym,
    mp,
    not_intro,
    prove_hyp,
    relation,
    spec,
)
from symhaptic.proof.theorems.leaves import broken, combined, is_whole, number
from symhaptic.proof.theorems.roots import first_minors


def closed(theorem: Theorem, *lemmas: Theorem) -> Theorem:
    """Hypotheses cut by lemmas, as often as one lemma may need another."""
    for _ in lemmas:
        usable = [x for x in lemmas if x.conclusion in theorem.hypotheses]
        if not usable:
            break
        theorem = prove_hyp(theorem, *usable)
    return theorem


def follows(implication: Theorem, *given: Theorem) -> Theorem:
    """What is implied by the conjunction of the given theorems."""
    return mp(implication, given[0] if len(given) == 1 else conj(*given))


def at(theorem: Theorem, values: Terms, *given: Theorem) -> Theorem:
    """For all x: p(x) => q(x) at a value, with p there given."""
    found = spec(theorem, values)
    return follows(found, *given) if given else found


def for_all(symbols: Sequence[Symbol], given: Sequence[Any], theorem: Theorem) -> Theorem:
    """The theorem for all values of the symbols under the hypotheses given."""
    return gen(disch(theorem, *given) if given else theorem, *symbols)


def every(symbols: Sequence[Symbol], given: Sequence[Any], then: Any) -> Proposition:
    """The proposition that :func:`for_all` concludes."""
    return ForAll(tuple(symbols), implied(given, then))


def as_claimed(claim: Proposition, theorem: Theorem, *more: Any) -> Theorem:
    """Return a theorem for all values of the claim's symbols under its hypotheses, and more.

    A theorem without hypotheses and free symbols is returned as it is.
    """
    if not theorem.hypotheses and not theorem.conclusion.free:
        return theorem
    symbols, given, _ = taken_apart(claim)
    given = (*given, *map(proposition, more))
    return for_all(symbols, given, add_assum(theorem, *given) if given else theorem)


def positive(claim: Any, *products: Any) -> Theorem:
    """A relation from products, each a theorem, an assumed relation or a sequence of these.

    A factor that is an expression is the multiplier of an equation.
    """

    def known(part: Any) -> Any:
        if isinstance(part, (list, tuple)):
            return [known(p) for p in part]
        if isinstance(part, (Theorem, int, sp.Expr)):
            return part
        return assume(part)

    rows = [known(p) if isinstance(p, (list, tuple)) else [known(p)] for p in products]
    return combined(claim, *rows)


def over(claim: Any, numerator: Any, denominator: Any) -> Theorem:
    """A quotient's sign from the signs of both, assumed where they are relations."""
    top = numerator if isinstance(numerator, Theorem) else assume(numerator)
    bottom = denominator if isinstance(denominator, Theorem) else assume(denominator)
    return divided(claim, top, bottom)


def one() -> Theorem:
    """0 < 1."""
    return number(proposition(sp.Lt(0, 1, evaluate=False)))


def fact(claim: Proposition) -> Theorem:
    """A proposition without symbols: a relation between numbers, or what is whole or is not."""
    if isinstance(claim, Not) and isinstance(claim.of[0], Relation):
        return denied(number(negated(claim.of[0])), claim.of[0])
    if isinstance(claim, Not) and isinstance(claim.of[0], Predicate):
        return broken(claim.of[0].of[0])
    if isinstance(claim, Predicate):
        if claim.name != "whole":
            raise NotShown(f"{claim} is no relation between numbers; give a theorem of it")
        return is_whole(claim.of[0])
    return number(claim)


def example(values: Terms, given: Sequence[Any], *theorems: Theorem) -> Case:
    """A point at which all of these hold; what is no relation of numbers is among the theorems."""
    values = {s: sp.sympify(v) for s, v in values.items()}
    known = {t.conclusion: t for t in theorems}
    there = [proposition(g).at(values) for g in given]
    parts = [known[p] if p in known else fact(p) for p in there]
    extra = [t for t in theorems if t.conclusion not in there]
    return Case(values, conj(*parts, *extra))


def counterexample(
    claim: Proposition,
    values: Terms,
    *theorems: Theorem,
    holds: Sequence[Any] = (),
    but: Any = None,
) -> Case:
    """A point at which a claim fails and so does one condition, while the others hold."""
    values = {s: sp.sympify(v) for s, v in values.items()}
    _, given, then = taken_apart(claim)
    extra = [] if but is None else [_denial(proposition(but).at(values))]
    there = then.at(values)
    if isinstance(there, Relation) and not there.free:
        extra.append(_denial(there))
    return example(values, [*given, *map(proposition, holds), *extra], *theorems)


def none_of(claim: Or, *denials: Theorem) -> Theorem:
    """not (p or q), from what contradicts each."""
    cases = [not_intro(assume(p), denial) for p, denial in zip(claim.of, denials, strict=True)]
    return reductio(disj_cases(assume(claim), *cases), claim)


def _denial(claim: Proposition) -> Proposition:
    return negated(claim) if isinstance(claim, Relation) else Not((claim,))


def either_way(there: Theorem, back: Theorem, left: Any, right: Any) -> Theorem:
    """p <=> q from q under the hypothesis p, and p under the hypothesis q."""
    return imp_antisym(disch(there, left), disch(back, right))


def chained(one: Theorem, other: Theorem) -> Theorem:
    """p <=> r from p <=> q and q <=> r."""
    p, r = one.conclusion.of[0], other.conclusion.of[1]  # type: ignore[attr-defined]
    return either_way(mp(other, mp(one, assume(p))), mp(one, mp(other, assume(r))), p, r)


def sine_of_half(angle: Any) -> Theorem:
    """0 < sin(theta/2) for 0 < theta < pi."""
    half = sp.S.Half
    low = positive(angle / 2 > 0, [half, angle > 0])
    high = positive(
        angle / 2 < sp.pi, [half, angle < sp.pi], [number(sp.Lt(0, sp.pi / 2, evaluate=False))]
    )
    return closed(sign_of(sp.sin, angle / 2), low, high)


def denied_by(equivalence: Theorem, denial: Theorem) -> Theorem:
    """not p, from p <=> q and not q."""
    claim = equivalence.conclusion.of[0]  # type: ignore[attr-defined]
    return not_intro(mp(equivalence, assume(claim)), denial, claim)


def not_all(claim: Proposition, denial: Theorem) -> Theorem:
    """not (p and q), from not p."""
    parts = (conjunct(assume(claim), p) for p in conjuncts(claim))
    for known in parts:
        try:
            return not_intro(known, denial, claim)
        except NotShown:
            continue
    raise NotShown(f"{denial.conclusion} denies no part of {claim}")


def denied(theorem: Theorem, wanted: Any) -> Theorem:
    """From b <= a the negation of a < b, and so on for each relation that cannot hold beside."""
    return not_intro(assume(wanted), theorem, wanted)


def reductio(falsehood: Theorem, given: Any) -> Theorem:
    """p |- false gives not p."""
    return not_intro(contr(falsehood, TRUE), contr(falsehood, Not((TRUE,))), given)


def zero_beyond(polynomial: Any, variable: Symbol, value: Theorem) -> Theorem:
    """p(1) <= 0, or p(1) < 0, for a monic real polynomial: not all zeros lie inside."""
    zeros = Predicate("stable", (variable,), (polynomial,))
    at_one = sp.sympify(polynomial).xreplace({variable: sp.S.One})
    start = first_minors(assume(zeros), 0)
    (claim,) = start.conclusion.parts
    above = combined(Relation(sp.S.Zero, "<", at_one), [conjunct(start, claim)])
    return not_intro(above, value, zeros)


def by_contradiction(wanted: Any, one: Theorem, other: Theorem) -> Theorem:
    """A relation, from two theorems of which one denies the other where the relation fails."""
    claim = proposition(wanted)
    assert isinstance(claim, Relation)
    left, right, holds = claim.left, claim.right, assume(claim)
    fails = contr(not_intro(one, other), claim)
    if claim.sign in ("=", "!="):
        cases = (holds, fails) if claim.sign == "=" else (fails, holds)
        return disj_cases(decided(left, right), *cases)
    if claim.sign == "<":
        return disj_cases(ordered(left, right), holds, fails)
    return disj_cases(ordered(right, left), fails, holds)


def by_multiple(claim: Any, weight: Theorem, *products: Any) -> Theorem:
    """A relation, from products whose sum is 0 < ``weight`` times it."""
    wanted, scale = proposition(claim), relation(weight)
    assert isinstance(wanted, Relation)
    of, share = wanted.right - wanted.left, scale.right - scale.left
    above = positive(Relation(sp.S.Zero, wanted.sign, share * of), *products)
    found = divided(Relation(sp.S.Zero, wanted.sign, of), above, weight)
    return closed(combined(wanted, [found]), combined(Relation(share, "!=", sp.S.Zero), [weight]))

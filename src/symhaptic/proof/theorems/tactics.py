"""Steps that are taken often, made of rules; nothing here has to be believed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Symbol

from symhaptic.notation.proposition import ForAll, Proposition, Terms, implied, proposition
from symhaptic.proof.theorems.kernel import (
    Theorem,
    applied,
    assume,
    conjoined,
    cut,
    discharged,
    general,
    instance,
)
from symhaptic.proof.theorems.leaves import combined, divided, number


def closed(theorem: Theorem, *lemmas: Theorem) -> Theorem:
    """Hypotheses cut by lemmas, again and again, as long as one of them is concluded."""
    while usable := [x for x in lemmas if x.conclusion in theorem.hypotheses]:
        theorem = cut(theorem, *usable)
        lemmas = tuple(x for x in lemmas if x not in usable)
    return theorem


def follows(implication: Theorem, *given: Theorem) -> Theorem:
    """What is implied by the conjunction of the given theorems."""
    return applied(implication, given[0] if len(given) == 1 else conjoined(*given))


def at(theorem: Theorem, values: Terms, *given: Theorem) -> Theorem:
    """For all x: p(x) => q(x) at a value, with p there given."""
    found = instance(theorem, values)
    return follows(found, *given) if given else found


def for_all(symbols: Sequence[Symbol], given: Sequence[Any], theorem: Theorem) -> Theorem:
    """The theorem for all values of the symbols under the hypotheses given."""
    found = discharged(theorem, *given) if given else theorem
    return general(found, *symbols)


def every(symbols: Sequence[Symbol], given: Sequence[Any], then: Any) -> Proposition:
    """The proposition that :func:`for_all` concludes."""
    return ForAll(tuple(symbols), implied(given, then))


def positive(claim: Any, *products: Any) -> Theorem:
    """A relation from products, each a theorem, an assumed relation or a sequence of these."""

    def known(part: Any) -> Any:
        if isinstance(part, (list, tuple)):
            return [known(p) for p in part]
        if isinstance(part, (Theorem, int, sp.Rational)):
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

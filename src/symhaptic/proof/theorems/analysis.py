"""Theorems of analysis: what a slope, a limit or a step says of a whole interval.

They are applied and not proved: with those of ``energy`` and ``roots`` they are the list of what
has to be believed beside logic and the deciders.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import (
    And,
    Exists,
    Implies,
    Not,
    Predicate,
    Proposition,
    Relation,
    both,
    whole,
)
from symhaptic.notation.terms import term
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import (
    Judgement,
    NotShown,
    Theorem,
    predicate,
    put,
    relation,
    rule,
    without,
)

SOURCES = {
    "increases": "mean value theorem; Rudin, Principles of Mathematical Analysis, 3rd ed., 5.10",
    "grows": "mean value theorem; Rudin, 5.10 and 5.11",
    "above_its_start": "monotone functions have one-sided limits; Rudin, 4.29",
    "crosses_zero": "intermediate value theorem; Rudin, 4.23",
    "no_other_limit": "a limit is unique; Rudin, 4.2 and 3.2",
    "in_the_limit": "limits preserve weak inequalities; Rudin, 3.19 and 4.2",
    "induction": "mathematical induction",
}
"""Each rule of this module with its source."""

_ZERO = sp.S.Zero


@rule
def increases(
    expr: Any, variable: Symbol, lower: Any, upper: Any, slope: Theorem, *defined: Theorem
) -> Judgement:
    """f increases on (lower, upper) if its derivative is positive there.

    The premises show 0 < f' (``slope``) and that no divisor of f vanishes (``defined``).  They
    assume of the variable only that it lies between the ends.
    """
    expr, lower, upper = term(expr), term(lower), term(upper)
    hypotheses = _rising(expr, variable, (lower, upper), slope, defined) | conditions(lower, upper)
    return hypotheses, Predicate("increasing", (variable,), (expr, lower, upper))


def _rising(
    expr: Expr, variable: Symbol, ends: tuple[Expr, Expr], slope: Theorem, shown: Sequence[Theorem]
) -> set[Proposition]:
    """What is left to show so that f is defined and rises between the ends."""
    claim, hypotheses = relation(slope, "<"), _smooth(expr, variable, ends, (slope, *shown))
    if claim.left != 0 or not is_zero(sp.diff(expr, variable) - claim.right):
        raise NotShown(f"{claim} is not the sign of the derivative of {expr}")
    return hypotheses


def _smooth(
    expr: Expr, variable: Symbol, ends: tuple[Expr, Expr], shown: Sequence[Theorem]
) -> set[Proposition]:
    """What is left to show so that f is defined, and what is ``shown`` holds, between the ends."""
    if expr.has(sp.Abs, sp.re, sp.im, sp.conjugate) or not real(expr):
        raise NotShown(f"{expr} is not differentiable, or not real, by its form")
    hypotheses = conditions(expr) - {t.conclusion for t in shown}
    hypotheses = hypotheses.union(*(t.hypotheses for t in shown)) - {*_between(variable, *ends)}
    without([variable], hypotheses)
    return set(hypotheses)


def _between(variable: Symbol, lower: Expr, upper: Expr) -> tuple[Proposition, Proposition]:
    return Relation(lower, "<", variable), Relation(variable, "<", upper)


@rule
def grows(
    expr: Any, variable: Symbol, smaller: Any, larger: Any, slope: Theorem, *defined: Theorem
) -> Judgement:
    """f(x) < f(y) for x < y, if the derivative is positive between and f is defined at both ends.

    The premises show 0 < f' (``slope``) for x < v < y, and that no divisor of f vanishes there
    (``defined``).
    """
    expr, x, y = term(expr), term(smaller), term(larger)
    if variable in x.free_symbols | y.free_symbols or not (real(x) and real(y)):
        raise NotShown(f"{x} and {y} are no ends for {variable}")
    inside = _rising(expr, variable, (x, y), slope, defined)
    ends = [expr.xreplace({variable: v}) for v in (x, y)]
    hypotheses = inside | {Relation(x, "<", y)} | conditions(*ends, x, y)
    for end in (x, y):
        # SymPy may cancel a divisor that vanishes at an end
        hypotheses |= {c.at({variable: end}) for c in conditions(expr)}
    return hypotheses, Relation(ends[0], "<", ends[1])


@rule
def above_its_start(theorem: Theorem, start: Theorem) -> Judgement:
    """A function that increases on (lower, upper) exceeds its limit at the lower end."""
    rise, claim = predicate(theorem, "increasing"), predicate(start, "limit")
    [variable], (expr, lower, upper) = rise.over, rise.of
    if claim != Predicate("limit", (variable,), (expr, lower, claim.of[2])):
        raise NotShown(f"{claim} is not the limit at the lower end")
    hypotheses = theorem.hypotheses | start.hypotheses
    without([variable], hypotheses)
    return {*hypotheses, *_between(variable, lower, upper)}, Relation(claim.of[2], "<", expr)


@rule
def in_the_limit(
    theorem: Theorem, variable: Symbol, lower: Any, upper: Any, end: Theorem
) -> Judgement:
    """An inequality on (lower, upper) becomes a weak inequality in the limit at either end.

    The limit of the difference of its two sides (``end``) is a premise.
    """
    lower, upper = term(lower), term(upper)
    claim, limit = relation(theorem, "<", "<="), predicate(end, "limit")
    difference = claim.right - claim.left
    ends = [Predicate("limit", (variable,), (difference, e, limit.of[2])) for e in (lower, upper)]
    if limit not in ends:
        raise NotShown(f"{limit} is no limit of {difference} at an end")
    hypotheses = theorem.hypotheses - {*_between(variable, lower, upper)} | end.hypotheses
    without([variable], hypotheses)
    return hypotheses | {Relation(lower, "<", upper)}, Relation(_ZERO, "<=", limit.of[2])


@rule
def crosses_zero(below: Theorem, above: Theorem, *defined: Theorem) -> Judgement:
    """f(v) = 0 for some v in (lower, upper), if f changes its sign from minus to plus.

    The premises are the limits at the lower end (``below``) and at the upper end (``above``), and
    that no divisor of f vanishes in between (``defined``).  That the first limit is negative and
    the second positive is a hypothesis.
    """
    claim, other = predicate(below, "limit"), predicate(above, "limit")
    [variable], (expr, lower, start), (_, upper, end) = claim.over, claim.of, other.of
    if other != Predicate("limit", (variable,), (expr, upper, end)):
        raise NotShown(f"{other} is no limit of {expr}")
    order = {Relation(start, "<", _ZERO), Relation(_ZERO, "<", end), Relation(lower, "<", upper)}
    hypotheses = order | _smooth(expr, variable, (lower, upper), defined)
    there = And((*_between(variable, lower, upper), Relation(expr, "=", _ZERO)))
    return hypotheses | below.hypotheses | above.hypotheses, Exists((variable,), there)


@rule
def no_other_limit(limit: Theorem, apart: Theorem) -> Judgement:
    """If f tends to p, it does not tend to any q != p."""
    claim, other = predicate(limit, "limit"), relation(apart, "!=")
    if other.left != claim.of[2] or set(claim.over) & other.right.free_symbols:
        raise NotShown(f"{other} does not say that a number is not {claim.of[2]}")
    denied = Not((Predicate("limit", claim.over, (*claim.of[:2], other.right)),))
    return limit.hypotheses | apart.hypotheses, denied


@rule
def induction(claim: Proposition, number: Symbol, start: Theorem, step: Theorem) -> Judgement:
    """p(0), and p(n) => p(n + 1) for whole n, imply p(n) for every whole n."""
    (first, gone), (after, too) = (put(claim, {number: at}) for at in (_ZERO, number + 1))
    if gone or too:
        raise NotShown(f"a divisor of {claim} is lost on the way")
    following = Implies((both([whole(number), claim]), after))
    if start.conclusion != first or step.conclusion != following:
        raise NotShown("the start or the step is another claim")
    hypotheses = start.hypotheses | step.hypotheses
    without([number], hypotheses)
    return hypotheses | {whole(number)}, claim

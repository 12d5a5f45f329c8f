"""Theorems of the literature that are applied and not proved: the list of what has to be believed.

Each is an entry with its statement, its source and its hypotheses; a hypothesis is discharged by a
theorem that the rule is given.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, rule, whole
from symhaptic.notation.proposition import (
    And,
    ForAll,
    Iff,
    Implies,
    Predicate,
    Proposition,
    Relation,
    term,
)

SOURCES = {
    "increases": "mean value theorem; Rudin, Principles of Mathematical Analysis, 3rd ed., 5.10",
    "above_its_start": "monotone functions have one-sided limits; Rudin, 4.29",
    "from_there_on": "definition of an increasing function; Rudin, 4.28",
    "toeplitz": "a Toeplitz form is non-negative where its symbol is, and only there; "
    "Grenander and Szego, Toeplitz Forms and Their Applications, 5.2",
    "induction": "mathematical induction",
    "roots_stay": "zeros of a polynomial are continuous in its coefficients; Marden, Geometry of "
    "Polynomials, Theorem 1.4",
}
"""Each rule of this module with its source."""

_ZERO = sp.S.Zero


@rule
def increases(
    expr: Any, variable: Symbol, lower: Any, upper: Any, slope: Theorem, *defined: Theorem
) -> Judgement:
    """f increases on (lower, upper): its derivative is positive there.

    ``slope`` concludes 0 < f', ``defined`` that no divisor of f vanishes; what they know of the
    variable is that it lies between the ends.
    """
    expr, lower, upper = term(expr), term(lower), term(upper)
    claim = slope.conclusion
    if not (isinstance(claim, Relation) and claim.sign == "<" and claim.left == 0):
        raise NotShown(f"{claim} is not the sign of a slope")
    if expr.has(sp.Abs, sp.re, sp.im, sp.conjugate) or not real(expr):
        raise NotShown(f"{expr} is not differentiable, or not real, by its form")
    if not is_zero(sp.diff(expr, variable) - claim.right):
        raise NotShown(f"{claim.right} is not the derivative of {expr}")
    between = {Relation(lower, "<", variable), Relation(variable, "<", upper)}
    shown = {d.conclusion for d in defined}
    open_ = conditions(expr) - shown
    hypotheses = slope.hypotheses.union(open_, *(d.hypotheses for d in defined)) - between
    for hypothesis in hypotheses:
        if variable in hypothesis.free:
            raise NotShown(f"{hypothesis} is not known on all of the interval")
    return hypotheses, Predicate("increasing", (variable,), (expr, lower, upper))


def _increasing(theorem: Theorem) -> tuple[Symbol, Expr, Expr, Expr]:
    claim = theorem.conclusion
    if not (isinstance(claim, Predicate) and claim.name == "increasing"):
        raise NotShown(f"{claim} does not say that something increases")
    return (claim.over[0], *claim.of)  # type: ignore[return-value]


@rule
def above_its_start(theorem: Theorem, start: Theorem) -> Judgement:
    """What increases on (lower, upper) lies above its limit at the lower end."""
    variable, expr, lower, upper = _increasing(theorem)
    claim = start.conclusion
    if not (isinstance(claim, Predicate) and claim.name == "limit"):
        raise NotShown(f"{claim} is no limit")
    if claim != Predicate("limit", (variable,), (expr, lower, claim.of[2])):
        raise NotShown(f"{claim} is not the limit at the lower end")
    between = {Relation(lower, "<", variable), Relation(variable, "<", upper)}
    if any(variable in p.free for p in theorem.hypotheses | start.hypotheses):
        raise NotShown(f"a hypothesis is about {variable}")
    return theorem.hypotheses | start.hypotheses | between, Relation(claim.of[2], "<", expr)


@rule
def from_there_on(theorem: Theorem, smaller: Any, larger: Any) -> Judgement:
    """f(x) < f(y) for lower < x < y < upper, where f increases."""
    variable, expr, lower, upper = _increasing(theorem)
    x, y = term(smaller), term(larger)
    if not (real(x) and real(y)):
        raise NotShown(f"{x} or {y} is not real by its form")
    at = [expr.xreplace({variable: v}) for v in (x, y)]
    order = {Relation(lower, "<", x), Relation(x, "<", y), Relation(y, "<", upper)}
    return theorem.hypotheses | order | conditions(*at, x, y), Relation(at[0], "<", at[1])


@rule
def toeplitz(response: Any, variable: Symbol, damping: Any, angle: Symbol) -> Judgement:
    """No motion gains energy if and only if H(1) >= 0 and 0 <= c + Re H/(z - 1) on the circle.

    H is a polynomial in 1/z with real coefficients; that its exponents are whole is a hypothesis.
    Of z^-e/(z - 1) the real part is (cos (e+1) theta - cos e theta)/(2 - 2 cos theta).
    With x = p/(z - 1) the energy is the integral of |p|^2 (c + Re H/(z - 1)) over the circle, and
    H(1)/2 times the square of the whole way.
    """
    response, damping = term(response), term(damping)
    if {variable, angle} & damping.free_symbols or angle in response.free_symbols:
        raise NotShown("the angle and the variable are bound")
    if not real(damping):
        raise NotShown(f"{damping} is not real by its form")
    hypotheses: set[Proposition] = set(conditions(damping))
    static, margin = _ZERO, damping
    for summand in sp.Add.make_args(sp.expand(response)):
        coefficient, powers = summand.as_independent(variable, as_Add=False)
        factors = [f.as_base_exp() for f in sp.Mul.make_args(powers) if f != 1]
        exponent = sp.Add(*(e for _, e in factors))
        if any(base != variable or variable in e.free_symbols for base, e in factors):
            raise NotShown(f"{summand} is no multiple of a power of {variable}")
        if not real(coefficient):
            raise NotShown(f"{coefficient} is not real by its form")
        hypotheses |= {whole(-exponent), *conditions(coefficient)}
        static += coefficient
        turn = sp.cos((1 - exponent) * angle) - sp.cos(exponent * angle)
        margin += coefficient * turn / (2 - 2 * sp.cos(angle))
    inside = And((Relation(_ZERO, "<", angle), Relation(angle, "<", sp.pi)))
    always = ForAll((angle,), Implies((inside, Relation(_ZERO, "<=", margin))))
    energy = Predicate("passive", (variable,), (response, damping))
    return hypotheses, Iff((energy, And((Relation(_ZERO, "<=", static), always))))


@rule
def induction(claim: Proposition, number: Symbol, start: Theorem, step: Theorem) -> Judgement:
    """p(0), and p(n) => p(n + 1) for whole n, give p(n) for every whole n."""
    following = Implies((both([whole(number), claim]), claim.at({number: number + 1})))
    if start.conclusion != claim.at({number: _ZERO}) or step.conclusion != following:
        raise NotShown("the start or the step is another claim")
    if any(number in p.free for p in start.hypotheses | step.hypotheses):
        raise NotShown(f"a hypothesis is about {number}")
    return start.hypotheses | step.hypotheses | {whole(number)}, claim

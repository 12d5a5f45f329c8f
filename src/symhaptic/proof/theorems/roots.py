"""Theorems on the zeros of polynomials: when do all of them lie inside the unit circle?

They are applied and not proved: with those of ``analysis`` and ``energy`` they are the list of what
has to be believed beside logic and the deciders.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Not, Predicate, Relation, term
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, rule

SOURCES = {
    "zero_beyond": "a real polynomial that is not positive at 1 and grows has a zero there or "
    "beyond: intermediate value theorem; Rudin, 4.23",
    "zero_on_circle": "definition of a zero",
}
"""Each rule of this module with its source."""

_ZERO = sp.S.Zero


@rule
def zero_on_circle(polynomial: Any, variable: Symbol, angle: Any, zero: Theorem) -> Judgement:
    """p(exp(j theta)) = 0 for a real theta gives that not all zeros lie inside."""
    polynomial, angle = term(polynomial), term(angle)
    if not real(angle):
        raise NotShown(f"{angle} is not real by its form")
    _coefficients(polynomial, variable)
    there = polynomial.xreplace({variable: sp.exp(sp.I * angle)})
    if zero.conclusion != Relation(there, "=", _ZERO):
        raise NotShown(f"{zero.conclusion} is not the value of {polynomial} there")
    return zero.hypotheses | conditions(angle), Not(
        (Predicate("stable", (variable,), (polynomial,)),)
    )


@rule
def zero_beyond(polynomial: Any, variable: Symbol, value: Theorem) -> Judgement:
    """p(1) <= 0 for a monic real polynomial gives a zero at 1 or beyond: not all lie inside.

    So does p(1) < 0; the degree is a number.
    """
    polynomial = term(polynomial)
    coefficients = _coefficients(polynomial, variable)
    if coefficients[0] != 1 or not all(real(c) for c in coefficients):
        raise NotShown(f"{polynomial} is not monic and real by its form")
    claim = value.conclusion
    at_one = polynomial.xreplace({variable: sp.S.One})
    if claim not in (Relation(at_one, "<=", _ZERO), Relation(at_one, "<", _ZERO)):
        raise NotShown(f"{claim} does not say that {at_one} is not positive")
    return value.hypotheses, Not((Predicate("stable", (variable,), (polynomial,)),))


def _coefficients(polynomial: Expr, variable: Symbol) -> list[Expr]:
    """Coefficients of a polynomial of a degree that is a number, highest power first."""
    try:
        return [sp.sympify(c) for c in sp.Poly(polynomial, variable).all_coeffs()]
    except sp.PolynomialError:
        raise NotShown(f"{polynomial} is no polynomial in {variable} of a known degree") from None

"""Limits by exact series: the lowest terms of numerator and denominator, nothing sampled.

Exponentials become their Taylor polynomials, which makes the expression a quotient of two
polynomials in the small variable.  Every coefficient below the order of truncation is exact, and
whether it vanishes is decided by the normal form.
"""

from __future__ import annotations

import itertools
from functools import lru_cache

import sympy as sp
from sympy import Expr

from symhaptic.notation.fresh import fresh
from symhaptic.proof.ball import differs_from_zero
from symhaptic.proof.normal import Field, Small
from symhaptic.proof.points import points
from symhaptic.proof.rewriting import Undefined, Unsupported, as_exponentials

ORDERS = (4, 8, 16)
"""Orders of truncation tried one after the other."""


def _nonzero(coefficient: Expr) -> bool:
    """Whether a ball at some point of the domain shows that a coefficient is not zero."""
    if coefficient.is_Rational:
        return bool(coefficient != 0)
    for point in itertools.islice(points(coefficient), 20):
        try:
            if differs_from_zero(coefficient, point):
                return True
        except (Undefined, Unsupported):
            return False
    return False


def lowest_term(expr: Expr, variable: sp.Symbol, at: Expr = sp.S.Zero) -> tuple[int, Expr]:
    """Exponent n and coefficient C of the leading term C (variable - at)^n, cancelled.

    Raises :class:`Unsupported` where it cannot be found exactly.

    >>> x = sp.Symbol("x")
    >>> lowest_term((x - sp.sin(x))/x**2, x)
    (1, 1/6)
    """
    order, coefficient = _lowest_term(expr, variable, at)
    return order, shortened(coefficient)


@lru_cache(maxsize=1 << 10)
def _lowest_term(expr: Expr, variable: sp.Symbol, at: Expr) -> tuple[int, Expr]:
    """The same with a coefficient as it is found, a quotient."""
    eps = variable if at == 0 else fresh(expr.free_symbols | at.free_symbols, "eps")
    moved = as_exponentials(sp.sympify(expr, strict=True))
    moved = moved if at == 0 else moved.xreplace({variable: at + eps})
    for order in ORDERS:
        try:
            found = Field([moved, eps], Small(eps, order)).lowest(moved, _nonzero)
        except Undefined:  # a divisor may begin with a higher power
            if order == ORDERS[-1]:
                raise
            continue
        if found is not None:
            return found
    raise Unsupported(f"no leading term up to order {ORDERS[-1]} in {variable}")


def shortened(quotient: Expr) -> Expr:
    """As ``cancel``, which first looks for common terms that a quotient does not need.

    >>> d = sp.Symbol("d")
    >>> shortened((sp.exp(d) - 1)/(sp.exp(2*d) - 1))
    1/(exp(d) + 1)
    """
    number, above, below = sp.cancel(quotient.as_numer_denom())
    return number * above / below


def limit(expr: Expr, variable: sp.Symbol, at: Expr = sp.S.Zero) -> Expr:
    """The limit of ``expr`` as ``variable`` tends to ``at``, a quotient that is not cancelled.

    Raises :class:`Unsupported` where the expression has a pole there.

    >>> x, d = sp.symbols("x d")
    >>> limit(sp.sin(d*x)/sp.sin(x), x)
    d
    """
    order, coefficient = _lowest_term(expr, variable, at)
    if order < 0:
        raise Unsupported(f"pole of order {-order} at {variable} = {at}")
    return coefficient if order == 0 else sp.S.Zero

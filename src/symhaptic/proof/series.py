"""Limits by exact series: the lowest terms of numerator and denominator, nothing sampled.

Exponentials are replaced by their Taylor polynomials, which makes the expression a quotient
of two polynomials in the small variable.  Every coefficient below the order of truncation is
exact, and whether it vanishes is decided by the normal form.
"""

from __future__ import annotations

import itertools
from functools import lru_cache

import sympy as sp
from sympy import Expr

from symhaptic.proof.ball import differs_from_zero
from symhaptic.proof.normal import Field
from symhaptic.proof.points import points
from symhaptic.proof.rewriting import Undefined, Unsupported, as_exponentials

ORDERS = (4, 8, 16)
"""Orders of truncation tried one after the other."""


def _truncated(expr: Expr, eps: sp.Symbol, order: int) -> Expr:
    if not expr.has(eps):
        return expr
    args = [_truncated(a, eps, order) for a in expr.args]
    if isinstance(expr, sp.exp):
        exponent = sp.expand(args[0])
        still = exponent.subs(eps, 0)
        small = sp.expand(exponent - still)
        if not small.is_polynomial(eps):
            raise Unsupported(f"the exponent {exponent} is no polynomial in {eps}")
        taylor = sp.Add(*(small**k / sp.factorial(k) for k in range(order)))
        return sp.exp(still) * taylor
    if expr.is_Pow and not expr.args[1].is_Integer:
        if expr.args[0].has(eps):
            raise Unsupported(f"a root or power of {expr.args[0]}, which depends on {eps}")
        # a fixed base with a small exponent: base**(a + eps b)
        exponent = sp.expand(args[1])
        still = exponent.subs(eps, 0)
        small = sp.expand(exponent - still) * sp.log(expr.args[0])
        taylor = sp.Add(*(small**k / sp.factorial(k) for k in range(order)))
        return expr.args[0] ** still * taylor
    if not (expr.is_Add or expr.is_Mul or expr.is_Pow or expr.is_Symbol):
        raise Unsupported(f"no series of {type(expr).__name__} of {eps}")
    return expr.func(*args) if args else expr


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


@lru_cache(maxsize=1 << 10)
def lowest_term(expr: Expr, variable: sp.Symbol, at: Expr = sp.S.Zero) -> tuple[int, Expr]:
    """Exponent n and coefficient C of the leading term C (variable - at)^n.

    Raises :class:`Unsupported` where it cannot be found exactly.

    >>> x = sp.Symbol("x")
    >>> lowest_term((x - sp.sin(x))/x**2, x)
    (1, 1/6)
    """
    eps = sp.Dummy("eps")
    moved = as_exponentials(sp.sympify(expr, strict=True)).xreplace({variable: at + eps})
    for order in ORDERS:
        polynomial = _truncated(moved, eps, order)
        field = Field([polynomial, eps], small=eps)
        found = field.lowest(polynomial, eps, order, _nonzero)
        if found is not None:
            return found[0], sp.cancel(found[1])
    raise Unsupported(f"no leading term up to order {ORDERS[-1]} in {variable}")


def limit(expr: Expr, variable: sp.Symbol, at: Expr = sp.S.Zero) -> Expr:
    """The limit of ``expr`` as ``variable`` tends to ``at``, from its leading term.

    Raises :class:`Unsupported` where the expression has a pole there.

    >>> x, d = sp.symbols("x d")
    >>> limit(sp.sin(d*x)/sp.sin(x), x)
    d
    """
    order, coefficient = lowest_term(expr, variable, at)
    if order < 0:
        raise Unsupported(f"pole of order {-order} at {variable} = {at}")
    return coefficient if order == 0 else sp.S.Zero

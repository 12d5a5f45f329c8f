"""The exact value of an expression or relation at a point, or that it has none there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import sympy as sp
from sympy import Expr
from sympy.core.function import AppliedUndef

from symhaptic.notation.terms import FUNCTIONS
from symhaptic.proof.ball import differs_from_zero, sign
from symhaptic.proof.budget import size_of, spend
from symhaptic.proof.normal import Field, is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported

_POWER = 1_000_000
"""Powers of numbers are not written out with more bits."""

Value: TypeAlias = bool | Expr | None
"""What an expression or relation is at a point; None stands for undefined."""


def value_at(expr: Expr, at: Mapping[Expr, Expr]) -> Value:
    """Exact value at a point: a number, the truth of a relation, None where undefined.

    A division by zero at the point is found exactly, by the normal form of the denominator.
    Raises :class:`Unsupported` where a relation cannot be decided.

    >>> x = sp.Symbol("x")
    >>> value_at(x/(x - 1), {x: 1}) is None, value_at(x > 0, {x: 2})
    (True, True)
    """
    if expr in (sp.true, sp.false):
        return bool(expr)
    if isinstance(expr, sp.core.relational.Relational):
        left, right = value_at(expr.lhs, at), value_at(expr.rhs, at)
        if left is None or right is None:
            return None
        if isinstance(expr, (sp.Eq, sp.Ne)):
            if is_zero(left - right):
                return isinstance(expr, sp.Eq)
            if not differs_from_zero(left - right):
                raise Unsupported(f"undecided at {at}: {expr}")
            return isinstance(expr, sp.Ne)
        order = sign(left - right)
        if order is None:
            raise Unsupported(f"undecided at {at}: {expr}")
        return bool(expr.func(order, 0))
    try:
        return _placed(expr, at)
    except Undefined:
        return None


_TO_EVALUATE = 100
"""Steps for each part of a number that a function is of: SymPy works out its decimals and sign."""


_PLACED = (sp.Add, sp.Mul, sp.Pow, *FUNCTIONS, AppliedUndef)
"""Whose symbols are replaced by numbers."""


def _placed(expr: Expr, at: Mapping[Expr, Expr]) -> Expr:
    """Symbols replaced, every divisor tested, so that SymPy cannot cancel a zero with a pole."""
    if expr in at:
        return sp.sympify(at[expr], strict=True)
    if not expr.args:
        return expr
    # of other functions SymPy takes long; of a derivative it must stay a symbol by what it is
    if not isinstance(expr, _PLACED):
        raise Unsupported(f"no exact value of {type(expr).__name__}: {expr}")
    args = [_placed(a, at) for a in expr.args]
    if expr.is_Pow:
        base, power = args
        if power.could_extract_minus_sign() and Field([base]).is_zero(base):
            raise Undefined(f"division by {expr.args[0]}, which is zero")
        bits = max(abs(base.p), base.q).bit_length() if base.is_Rational else 1
        if power.is_Rational and abs(power) * bits > _POWER and base not in (-1, 0, 1):
            raise Unsupported(f"a number of {bits} bits to the power of {power}")
    if expr.is_Function:
        spend(_TO_EVALUATE * sum(map(size_of, args)))
    found = expr.func(*args)
    if found.has(sp.nan, sp.zoo, sp.oo, -sp.oo):
        raise Undefined(f"{expr} is not defined")
    return found

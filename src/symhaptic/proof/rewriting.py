"""Sines, cosines and real parts as exponentials; what the zero test cannot do is said here."""

from __future__ import annotations

import sympy as sp
from sympy import Expr

from symhaptic.notation import SYMBOLS


class Undefined(ArithmeticError):
    """The expression divides by something that is identically zero."""


class Unsupported(ValueError):
    """The expression holds something that the normal form does not know."""


def conjugated(expr: Expr) -> Expr:
    """The complex conjugate; symbols and coefficients of unknown functions are real.

    Raises :class:`Unsupported` where the conjugate is not found by exchanging j and -j: for
    complex symbols, and for roots and powers that need not be real.
    """
    for symbol in expr.free_symbols:
        if symbol.name in SYMBOLS and SYMBOLS[symbol.name].domain == "complex":
            raise Unsupported(f"the conjugate of an expression in {symbol}, which is complex")
    for power in expr.atoms(sp.Pow):
        if not (power.exp.is_Integer or (power.base.is_positive and power.exp.is_real)):
            raise Unsupported(f"the conjugate of {power}, which need not be real")
    return expr.xreplace({sp.I: -sp.I})


def as_exponentials(expr: Expr) -> Expr:
    """Sines, cosines, tangents and real parts rewritten with exponentials, nothing else touched."""
    j = sp.I
    args = [as_exponentials(a) for a in expr.args]

    def pair(u: Expr) -> tuple[Expr, Expr]:
        return sp.exp(u, evaluate=False), sp.exp(-u, evaluate=False)

    if isinstance(expr, (sp.sin, sp.cos, sp.tan, sp.cot)):
        up, down = pair(j * args[0])
        sine, cosine = (up - down) / (2 * j), (up + down) / 2
        return {sp.sin: sine, sp.cos: cosine, sp.tan: sine / cosine, sp.cot: cosine / sine}[
            expr.func
        ]
    if isinstance(expr, (sp.sinh, sp.cosh, sp.tanh)):
        up, down = pair(args[0])
        sine, cosine = (up - down) / 2, (up + down) / 2
        return {sp.sinh: sine, sp.cosh: cosine, sp.tanh: sine / cosine}[expr.func]
    if isinstance(expr, sp.re):
        return (args[0] + as_exponentials(conjugated(expr.args[0]))) / 2
    if isinstance(expr, sp.exp):
        return sp.exp(args[0], evaluate=False)
    if not expr.args or isinstance(expr, (sp.core.function.AppliedUndef, sp.conjugate)):
        return expr
    return expr.func(*args, evaluate=False) if expr.is_Add or expr.is_Mul else expr.func(*args)

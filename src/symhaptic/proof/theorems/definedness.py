"""Where does an expression have a value, and where is it real?

Definedness is an obligation like any other: what is sufficient for it is said in relations, which
become hypotheses of a theorem until they are shown.  Roots and powers are principal values.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Proposition, Relation, is_complex
from symhaptic.proof.ball import differs_from_zero
from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported

_DIVISORS = {sp.tan: sp.cos, sp.cot: sp.sin, sp.tanh: sp.cosh}
_REAL = (sp.exp, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.atan)
_ALWAYS_REAL = (sp.Abs, sp.re, sp.im)


def conditions(*exprs: Expr, at: Mapping[Symbol, Expr] | None = None) -> frozenset[Proposition]:
    """Relations that together are sufficient for all the expressions to have a value.

    ``at`` are values of symbols: a power that is not negative there asks for nothing.

    >>> x = sp.Symbol("x")
    >>> conditions(1/x + sp.sin(x)) == {Relation(x, "!=", sp.S.Zero)}
    True
    """
    if at and not any(_powers(expr) & at.keys() for expr in exprs):
        at = None
    if not at:
        return frozenset().union(*map(_everywhere, exprs))
    parts = (part for expr in exprs for part in sp.preorder_traversal(expr))
    return frozenset(p for part in parts for p in _asked(part, at))


@lru_cache(maxsize=2**15)
def _everywhere(expr: Expr) -> frozenset[Proposition]:
    """The conditions of an expression, those of its parts included, each found once."""
    return frozenset(_asked(expr, {})).union(*map(_everywhere, expr.args))


@lru_cache(maxsize=2**15)
def _powers(expr: Expr) -> frozenset[Symbol]:
    """The symbols in exponents, by which a power may be one that divides, or none."""
    own = expr.exp.free_symbols if expr.is_Pow else ()
    return frozenset(own).union(*map(_powers, expr.args))


def _asked(part: Expr, at: Mapping[Symbol, Expr]) -> Iterable[Proposition]:
    """What an expression asks for by itself."""
    divisors = (divisor for divisor in _divisors(part, at) if not differs(divisor))
    return (Relation(divisor, "!=", sp.S.Zero) for divisor in divisors)


def _divisors(part: Expr, at: Mapping[Symbol, Expr]) -> Iterable[Expr]:
    if part.is_Pow:
        power = part.exp.xreplace(dict(at)) if at else part.exp
        if not (power.is_Rational and power >= 0):
            yield part.base
    elif part.func in _DIVISORS:
        yield _DIVISORS[part.func](part.args[0])
    elif isinstance(part, sp.log):
        yield part.args[0]
    elif isinstance(part, sp.atan) and not real(part.args[0]):
        yield 1 + part.args[0] ** 2


def differs(number: Expr) -> bool:
    """Whether a ball shows that a number is not zero; an exponential never is."""
    if isinstance(number, sp.exp):
        return True
    if number.free_symbols:
        return False
    try:
        return bool(differs_from_zero(number))
    except Unsupported:
        return False


def real(expr: Expr) -> bool:
    """Whether an expression is real wherever it is defined, by its form alone.

    >>> x, z = sp.symbols("x z")
    >>> real(sp.sin(x)/x), real(sp.sqrt(x)), real(z**2)
    (True, False, False)
    """
    if expr.is_Rational or expr in (sp.pi, sp.E):
        return True
    if expr.is_Symbol:
        return not is_complex(expr)
    if isinstance(expr, _ALWAYS_REAL):
        return True
    if not mirrors(expr):
        return False
    if not expr.has(sp.I):
        return True
    try:
        return is_zero(expr - expr.xreplace({sp.I: -sp.I}))
    except (Unsupported, Undefined):
        return False


def mirrors(expr: Expr) -> bool:
    """Whether the conjugate of an expression is found by exchanging j and -j."""
    if expr.is_Rational or expr in (sp.pi, sp.E, sp.I):
        return True
    if expr.is_Symbol:
        return not is_complex(expr)
    if expr.is_Pow:
        base, power = expr.args
        if power.is_Integer:
            return mirrors(base)
        return bool(base.is_Rational and base > 0) and mirrors(power)
    if expr.is_Add or expr.is_Mul or isinstance(expr, _REAL):
        return all(mirrors(a) for a in expr.args)
    return isinstance(expr, _ALWAYS_REAL)

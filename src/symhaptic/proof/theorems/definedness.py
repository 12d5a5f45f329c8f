"""Where does an expression have a value, and where is it real?

Definedness is an obligation like any other: what is sufficient for it is said in relations, which
become hypotheses of a theorem until they are shown.  Roots and powers are principal values.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Predicate, Proposition, Relation
from symhaptic.notation.terms import is_complex, symbols_in
from symhaptic.proof.ball import differs_from_zero
from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported

_DIVISORS = {sp.tan: sp.cos, sp.cot: sp.sin, sp.tanh: sp.cosh}
_SMOOTH = (sp.exp, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh)
_REAL = (*_SMOOTH, sp.atan)
_ALWAYS_REAL = (sp.Abs, sp.re, sp.im)


def conditions(
    *exprs: Expr,
    at: Mapping[Symbol, Expr] | None = None,
    but: Symbol | None = None,
    beside: Iterable[Expr] = (),
) -> frozenset[Proposition]:
    """Relations that together are sufficient for all the expressions to have a value.

    ``at`` are values of symbols: a power that is not negative there asks for nothing.  Those that
    know a symbol are left out (``but``), such as that z != 0 for a polynomial in z, and those of a
    power that, with ``at``, stands as it is in an expression that has a value (``beside``).

    >>> x = sp.Symbol("x")
    >>> conditions(1/x + sp.sin(x)) == {Relation(x, "!=", sp.S.Zero)}
    True
    """
    there, known = dict(at or {}), _all_conditions(beside)
    return frozenset(
        condition
        for expr in exprs
        for condition, power in _conditions(expr)
        if but not in condition.free and not (at and _not_negative(power.xreplace(there)))
        if not (known and (condition.at(there), power.xreplace(there)) in known)
    )


def needed(*exprs: Expr, by: Proposition | None = None) -> frozenset[Proposition]:
    """Those of the conditions that hold wherever all the expressions have a value.

    A power with a symbol in its exponent may have one where its base is 0.  What ``by`` says of
    them may be about other places alone: a zero that is not inside the circle is not 0, nor is z
    in a polynomial in 1/z.

    >>> x, y = sp.symbols("x y")
    >>> needed(1/x + x**y) == conditions(1/x), needed(x**y) == frozenset()
    (True, True)
    """
    found = {c for c, power in _all_conditions(exprs) if power.is_Rational}
    if isinstance(by, Predicate) and by.name in ("stable", "passive"):
        found |= {Relation(s, "!=", sp.S.Zero) for s in by.over}
    return frozenset(found)


def _all_conditions(exprs: Iterable[Expr]) -> frozenset[tuple[Proposition, Expr]]:
    return frozenset[tuple[Proposition, Expr]]().union(*map(_conditions, exprs))


@lru_cache(maxsize=1 << 16)
def _conditions(expr: Expr) -> frozenset[tuple[Relation, Expr]]:
    """A condition for each divisor that is not shown to differ from zero, and its power."""
    own = frozenset(
        (Relation(divisor, "!=", sp.S.Zero), power)
        for divisor, power in _divisors(expr)
        if not differs(divisor)
    )
    return own.union(*map(_conditions, expr.args))


def _divisors(part: Expr) -> Iterable[tuple[Expr, Expr]]:
    if part.is_Pow:
        if not _not_negative(part.exp):
            yield part.base, part.exp
    elif part.func in _DIVISORS:
        yield _DIVISORS[part.func](part.args[0]), sp.S.NegativeOne
    elif isinstance(part, sp.log):
        yield part.args[0], sp.S.NegativeOne
    elif isinstance(part, sp.atan) and not real(part.args[0]):
        yield 1 + part.args[0] ** 2, sp.S.NegativeOne


def _not_negative(power: Expr) -> bool:
    return bool(power.is_Rational and power.p >= 0)


def differs(number: Expr) -> bool:
    """Whether a ball shows that a number is not zero; an exponential never is."""
    if isinstance(number, sp.exp):
        return True
    if symbols_in(number):
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
    if expr.is_Rational or expr is sp.pi or expr is sp.E:
        return True
    if expr.is_Symbol:
        return not is_complex(expr)
    if isinstance(expr, _ALWAYS_REAL):
        return True
    if not mirrors(expr):
        return False
    if not _holds_j(expr):
        return True
    try:
        return is_zero(expr - expr.xreplace({sp.I: -sp.I}))
    except (Unsupported, Undefined):
        return False


def smooth(expr: Expr, symbol: Symbol) -> bool:
    """Whether an expression has a slope wherever it has a value, by its form alone.

    An absolute value has a corner; logarithms, arcs and roots have cuts, across which they jump.

    >>> x, y = sp.symbols("x y")
    >>> smooth(sp.exp(sp.sqrt(y)*x)/x, x), smooth(sp.log(sp.exp(sp.I*x)), x)
    (True, False)
    """
    if symbol not in symbols_in(expr) or expr == symbol:
        return True
    if expr.is_Pow and not expr.exp.is_Integer:
        return symbol not in symbols_in(expr.base) and smooth(expr.exp, symbol)
    known = expr.is_Add or expr.is_Mul or expr.is_Pow or isinstance(expr, _SMOOTH)
    return known and all(smooth(part, symbol) for part in expr.args)


@lru_cache(maxsize=1 << 16)
def _holds_j(expr: Expr) -> bool:
    return expr is sp.I or any(map(_holds_j, expr.args))


@lru_cache(maxsize=1 << 16)
def mirrors(expr: Expr) -> bool:
    """Whether the conjugate of an expression is found by exchanging j and -j."""
    if expr.is_Rational or expr is sp.pi or expr is sp.E or expr is sp.I:
        return True
    if expr.is_Symbol:
        return not is_complex(expr)
    if expr.is_Pow:
        base, power = expr.args
        if power.is_Integer:
            return mirrors(base)
        return bool(base.is_Rational and base > 0) and mirrors(power)
    if isinstance(expr, sp.atan):
        return real(expr.args[0])  # elsewhere it has cuts
    if expr.is_Add or expr.is_Mul or isinstance(expr, _REAL):
        return all(map(mirrors, expr.args))
    if not _holds_j(expr):
        return isinstance(expr, _ALWAYS_REAL)
    return isinstance(expr, (sp.Abs, sp.re)) and mirrors(expr.args[0])

"""Where does an expression have a value, and where is it real?

Definedness is an obligation like any other: what is sufficient for it is said in relations, which
become hypotheses of a theorem until they are shown.  Roots and powers are principal values.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache, lru_cache

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Predicate, Proposition, Relation
from symhaptic.notation.terms import Term, is_complex, symbols_in, tree
from symhaptic.proof.ball import differs_from_zero
from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported

_DIVISORS = {sp.tan: sp.cos, sp.cot: sp.sin, sp.tanh: sp.cosh}
_SMOOTH = (sp.exp, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh)
_REAL = (*_SMOOTH, sp.atan)
_ALWAYS_REAL = (sp.Abs, sp.re, sp.im)


def conditions(*terms: Expr | Term) -> frozenset[Proposition]:
    """Relations that together are sufficient for all the terms to have a value.

    >>> x = sp.Symbol("x")
    >>> conditions(1/x + sp.sin(x)) == {Relation(x, "!=", sp.S.Zero)}
    True
    >>> conditions(sp.Add(1/x, -1/x, evaluate=False)) == conditions(1/x)
    True
    """
    return frozenset(c for t in terms for c, _ in limits(t))


def needed(*terms: Expr | Term, by: Proposition | None = None) -> frozenset[Proposition]:
    """Those of the conditions that hold wherever all the terms have a value.

    A power with a symbol in its exponent may have one where its base is 0.  What ``by`` says of
    them may be about other places alone: a zero that is not inside the circle is not 0, nor is z
    in a polynomial in 1/z.

    >>> x, y = sp.symbols("x y")
    >>> needed(1/x + x**y) == conditions(1/x), needed(x**y) == frozenset()
    (True, True)
    """
    found = {c for t in terms for c, power in limits(t) if isinstance(power.head, sp.Rational)}
    if isinstance(by, Predicate) and by.name in ("stable", "passive"):
        found |= {Relation(s, "!=", sp.S.Zero) for s in by.over}
    return frozenset(found)


def beyond(terms: Iterable[Expr], known: Iterable[Expr]) -> frozenset[Proposition]:
    """Conditions of terms that need not hold wherever the known ones have a value.

    >>> x, y = sp.symbols("x y")
    >>> beyond([1 / x, 1 / y], [x + 1 / y]) == conditions(1 / x)
    True
    """
    known = tuple(known)
    there = frozenset[tuple[Relation, Term]]().union(*map(limits, known))
    left = frozenset(c for t in terms for c, power in limits(t) if (c, power) not in there)
    return left - needed(*known)


def limits(of: Expr | Term) -> frozenset[tuple[Relation, Term]]:
    """A condition for each divisor that is not shown to differ from zero, and its power."""
    return _limits(of if isinstance(of, Term) else tree(of))


@cache
def _limits(of: Term) -> frozenset[tuple[Relation, Term]]:
    own = frozenset(
        (Relation(divisor.shown, "!=", sp.S.Zero), power)
        for divisor, power in _divisors(of)
        if not differs(divisor)
    )
    return own.union(*map(_limits, of.args))


_ONCE = tree(sp.S.NegativeOne)


def _divisors(part: Term) -> Iterable[tuple[Term, Term]]:
    if part.head is sp.Pow:
        base, power = part.args
        power = power.evaluated or power  # what it divides by itself is asked for apart
        if not (isinstance(power.head, sp.Rational) and power.head >= 0):
            yield base, power
    elif part.head in _DIVISORS:
        yield Term(_DIVISORS[part.head], part.args), _ONCE
    elif part.head is sp.log:
        yield part.args[0], _ONCE
    elif part.head is sp.atan and not real(part.args[0].sympy):
        yield tree(1 + part.args[0].sympy ** 2), _ONCE


def kept(divisor: Term, known: frozenset[Proposition]) -> bool:
    """Whether a divisor is a product of powers of what is known not to be zero, or differs from it.

    >>> x = sp.Symbol("x")
    >>> kept(tree(2 * x**2), conditions(1 / x))
    True
    """
    for factor in divisor.args if divisor.head is sp.Mul else (divisor,):
        base = factor
        if factor.head is sp.Pow:
            power = factor.args[1].head
            base = factor.args[0] if isinstance(power, sp.Rational) and power > 0 else factor
        if Relation(base.shown, "!=", sp.S.Zero) not in known and not differs(base):
            return False
    return True


def differs(number: Expr | Term) -> bool:
    """Whether a ball shows that a number is not zero; an exponential never is."""
    number = number if isinstance(number, Term) else tree(number)
    if number.head is sp.exp:
        return True
    if number.free:
        return False
    try:
        return bool(differs_from_zero(number.sympy))
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

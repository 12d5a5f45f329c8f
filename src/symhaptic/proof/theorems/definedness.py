"""Where does an expression have a value, and where is it real?

Definedness is an obligation like any other: what is sufficient for it is said in relations, which
become hypotheses of a theorem until they are shown.  Roots and powers are principal values.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Proposition, Relation, is_complex, symbols_in
from symhaptic.proof.ball import differs_from_zero
from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported

_DIVISORS = {sp.tan: sp.cos, sp.cot: sp.sin, sp.tanh: sp.cosh}
_REAL = (sp.exp, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.atan)
_ALWAYS_REAL = (sp.Abs, sp.re, sp.im)


def conditions(
    *exprs: Expr, at: Mapping[Symbol, Expr] | None = None, but: Symbol | None = None
) -> frozenset[Proposition]:
    """Relations that together are sufficient for all the expressions to have a value.

    ``at`` are values of symbols: a power that is not negative there asks for nothing.  Those that
    know a symbol are left out (``but``), such as that z != 0 for a polynomial in z.

    >>> x = sp.Symbol("x")
    >>> conditions(1/x + sp.sin(x)) == {Relation(x, "!=", sp.S.Zero)}
    True
    """
    if at:
        return frozenset(c for expr in exprs for c in _conditions(expr, at))
    return frozenset(c for expr in exprs for c in _anywhere(expr) if but not in c.free)


@lru_cache(maxsize=1 << 14)
def _anywhere(expr: Expr) -> frozenset[Proposition]:
    """The conditions where nothing is known of the symbols."""
    return frozenset(_conditions(expr, {}))


def _conditions(expr: Expr, at: Mapping[Symbol, Expr]) -> Iterator[Proposition]:
    """A condition for each divisor that is not shown to differ from zero."""
    left, seen = [expr], set[int]()
    while left:
        part = left.pop()
        if not part.args or id(part) in seen:
            continue
        seen.add(id(part))
        left += part.args
        if not (part.is_Add or part.is_Mul):
            for divisor in _divisors(part, at):
                if not differs(divisor):
                    yield Relation(divisor, "!=", sp.S.Zero)


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
    if isinstance(expr, sp.atan):
        return real(expr.args[0])  # elsewhere it has cuts
    if expr.is_Add or expr.is_Mul or isinstance(expr, _REAL):
        return all(mirrors(a) for a in expr.args)
    if not expr.has(sp.I):
        return isinstance(expr, _ALWAYS_REAL)
    return isinstance(expr, (sp.Abs, sp.re)) and mirrors(expr.args[0])

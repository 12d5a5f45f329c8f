"""What may stand in a proposition: terms of SymPy's, made of few functions and looked through.

A symbol stands for a real number, unless :mod:`symhaptic.notation` says that it is complex.  A term
lasts: SymPy makes it anew of its parts as it is, so that two that look alike are the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import gcd
from numbers import Number
from typing import Any

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef, UndefinedFunction

from symhaptic.notation import SYMBOLS
from symhaptic.notation.fresh import made_before, mark

FUNCTIONS = (
    *(sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.atan),
    *(sp.Abs, sp.re, sp.im, sp.conjugate),
)
"""The functions that a term may be made of, beside sums, products, powers and unknown ones."""

PLACES = tuple(sp.Dummy(f"bound_{i}") for i in range(64))
"""They stand for bound symbols where propositions are compared, and in no term."""
_RESERVED = frozenset(PLACES)
_PLAIN = Symbol("x").assumptions0


class NoTerm(TypeError):
    """Something that is no term of the language, or no proposition; the message is one line."""


def term(of: Any) -> Expr:
    """A term: an exact, commutative expression in plain symbols.  Text is refused."""
    if isinstance(of, Expr):
        expr = of
    elif isinstance(of, Number) and not isinstance(of, (float, complex, bool)):
        expr = sp.sympify(of, strict=True)
    else:
        raise NoTerm(f"{of!r} is no term; an exact SymPy expression is")
    if not isinstance(expr, Expr):
        raise NoTerm(f"{expr!r} is no term; a SymPy expression is")
    _looked_through(expr)
    return expr


@lru_cache(maxsize=1 << 15, typed=True)
def _looked_through(expr: Expr) -> None:
    """Raise :class:`NoTerm` of an expression that is none; of one that is, nothing."""
    left = [expr]
    while left:
        part = left.pop()
        if type(part) is sp.Rational:
            _check_lowest(part)
        elif type(part) not in _ATOMS:
            if type(part) not in _MADE:
                _check(part)
            elif type(part) in FUNCTIONS and len(part.args) != 1:
                raise NoTerm(f"{part} is a function of {len(part.args)} arguments, not of one")
            left += part.args[::-1]
    if not _lasting(expr):
        raise NoTerm(f"{expr} loses a divisor when SymPy writes it anew; write it without")


def _lasting(expr: Expr) -> bool:
    """Whether all that limits where a term has a value outlives its being written anew."""
    if not _limited(expr) or _as_it_stands(expr):
        return True
    limits = set(_limits(expr))
    there = {s: _other(s) for s in expr.free_symbols}
    if {limit.xreplace(there) for limit in limits} <= set(_limits(expr.xreplace(there))):
        return True
    back = {d: s for s, d in there.items()}

    def anew(part: Expr) -> Expr:
        return part.xreplace(there).xreplace(back)

    # other names may turn signs; in these names a divisor may have become several
    kept = set(_limits(anew(expr)))
    factors = (f for limit in limits for f in sp.Mul.make_args(anew(limit)))
    return all(
        f in kept or f.as_base_exp()[0] in kept or (f.is_Rational and f != 0) for f in factors
    )


@lru_cache(maxsize=1 << 16)
def _limited(part: Expr) -> bool:
    """Whether something in a term need not have a value."""
    return _may_have_none(part) or any(map(_limited, part.args))


@lru_cache(maxsize=1 << 16)
def _as_it_stands(part: Expr) -> bool:
    """Whether SymPy writes a term, and each part of it, as it stands: then under any names."""
    return not part.args or (all(map(_as_it_stands, part.args)) and part.func(*part.args) == part)


@lru_cache(maxsize=1 << 10)
def _other(symbol: Symbol) -> Symbol:
    """A symbol that stands for another one, always the same, of which SymPy then knows."""
    return sp.Dummy(symbol.name)


@lru_cache(maxsize=1 << 16)
def symbols_in(expr: Expr) -> frozenset[Symbol]:
    """The free symbols of a term."""
    if type(expr) in _MADE:
        return frozenset[Symbol]().union(*map(symbols_in, expr.args))
    return frozenset(expr.free_symbols)


def _limits(expr: Expr) -> Iterator[Expr]:
    """Bases of powers that need not have a value, and functions that need not."""
    for part in sp.preorder_traversal(expr):
        if _may_have_none(part):
            yield part.base if part.is_Pow else part


def _may_have_none(part: Expr) -> bool:
    """Whether a power or a function need not have a value where its arguments have."""
    if part.is_Pow:
        exponent = part.exp
        return not (exponent.is_Rational and exponent.p >= 0)
    return part.func in _PARTIAL


_PARTIAL = (sp.log, sp.tan, sp.cot, sp.tanh, sp.atan)
_ATOMS = frozenset(map(type, (sp.I, sp.pi, sp.E, *map(sp.Rational, (0, 1, -1, "1/2", "2/3", 2)))))
_MADE = frozenset({sp.Add, sp.Mul, sp.Pow, *FUNCTIONS})
_OF_UNKNOWN = frozenset(vars(sp.Function("f", commutative=True)))


def _check_lowest(number: sp.Rational) -> None:
    """Raise :class:`NoTerm` of a fraction that can be shortened: it is not equal to its value."""
    if number.q < 2 or gcd(number.p, number.q) != 1:
        raise NoTerm(f"{number} is not in lowest terms")


def _check(part: Expr) -> None:
    """Raise :class:`NoTerm` of what stands in no term."""
    if part.is_Symbol:
        if type(part) not in (Symbol, sp.Dummy):
            raise NoTerm(f"the symbol {part} carries assumptions; hypotheses say them here")
        _check_symbol(part)
    elif isinstance(part, AppliedUndef) and set(getattr(part.func, "_kwargs", {})) - set(_PLAIN):
        raise NoTerm(f"the function {part.func} carries assumptions; hypotheses say them here")
    elif not _is_unknown(type(part)):
        raise NoTerm(f"{part} ({type(part).__name__}) is no part of a term")


@lru_cache(maxsize=1 << 12)
def _check_symbol(symbol: Symbol) -> None:
    """The same of a symbol; one that was made before stays so."""
    # an assumption would change what SymPy makes of an expression without saying so
    if symbol.assumptions0 != _PLAIN:
        raise NoTerm(f"the symbol {symbol} carries assumptions; hypotheses say them here")
    if symbol in _RESERVED:
        raise NoTerm(f"the symbol {symbol} stands for bound ones where propositions are compared")
    if not made_before(symbol, mark()):
        raise NoTerm(f"the symbol {symbol} has a number by hand; another one may get it yet")


def _is_unknown(function: type[Expr]) -> bool:
    """Whether a function is what SymPy makes of a name, and no class with ways of its own."""
    plain = type(function) is UndefinedFunction and function.__bases__ == (AppliedUndef,)
    return plain and vars(function).keys() <= _OF_UNKNOWN


def without_value(number: Expr) -> bool:
    """Whether SymPy met a division by zero; to be asked of numbers, since 0^x may have a value."""
    return bool(number.has(sp.zoo, sp.nan, sp.oo, -sp.oo))


def is_complex(symbol: Expr) -> bool:
    """Whether a symbol stands for a complex number."""
    known = SYMBOLS.get(symbol.name)
    return known is not None and known.domain == "complex"

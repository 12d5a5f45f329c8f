"""A point at which two forms certainly differ, and one at which all of some forms are defined.

Both are shown by balls of the forms as they are written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache

import sympy as sp
from flint import acb, ctx
from sympy import Expr
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from symhaptic.notation import SYMBOLS
from symhaptic.proof.ball import ball, is_real
from symhaptic.proof.budget import size_of, spend
from symhaptic.proof.names import admissible, replaced
from symhaptic.proof.points import Point, points
from symhaptic.proof.program import Uncheckable, program, value
from symhaptic.proof.rewriting import Unsupported, is_complex
from symhaptic.proof.values import value_at

_BITS = (64, 256, 1024, 4096)
_FEW_BITS = (64, 256)
"""Precisions at which a form that is defined has a finite ball, unless it is near a pole."""


def told_apart(left: Expr, right: Expr, anywhere: bool = False) -> Point | None:
    """A point where both are defined and certainly differ; an unknown H is tried as H_0 + H_1 x.

    It has what the symbols are assumed to be.  Of two definitions of one thing the right sides are
    told apart.  ``anywhere``: at real numbers outside the domains of the notation, too.

    >>> x = sp.Symbol("x")
    >>> told_apart(x < 1, x <= 1)
    {x: 1}
    """
    found = None
    if defines_one(left, right):
        found = _differing(left.rhs, right.rhs, anywhere, left.lhs)
        if found == {} and isinstance(left.lhs, sp.Symbol):  # one of two numbers that it may be
            sides = (left.rhs, right.rhs)
            return {left.lhs: next(side for side in sides if _may_be(left.lhs, side, {}))}
    return found or _differing(left, right, anywhere)


def defines_one(left: Expr, right: Expr) -> bool:
    """Whether both are equations for one thing, which stands left only.

    It is a symbol, an unknown function, or a rational function of a complex symbol.
    """
    kinds = (sp.Eq, sp.Ne)
    if not (isinstance(left, kinds) and isinstance(right, kinds) and left.lhs == right.lhs):
        return False
    defined = left.lhs
    things = [defined] if isinstance(defined, (sp.Symbol, AppliedUndef)) else _variables(defined)
    return any(not (left.rhs.has(thing) or right.rhs.has(thing)) for thing in things)


def _variables(expr: Expr) -> list[Expr]:
    """The complex symbols of which it is a rational function."""
    return [s for s in expr.free_symbols if is_complex(s) and expr.is_rational_function(s)]


def _differing(
    left: Expr, right: Expr, anywhere: bool, defined: Expr | None = None
) -> Point | None:
    try:
        left, right = _with_lines(left), _with_lines(right)
        size = size_of(left) + size_of(right)
        for point in points(left, right, anywhere=anywhere):
            spend(100 * size)
            if _differ(left, right, point) and (
                defined is None or any(_may_be(defined, side, point) for side in (left, right))
            ):
                return point
    except (Uncheckable, Unsupported):
        pass
    return None


def _with_lines(form: Expr) -> Expr:
    """A form with a line for each unknown function."""

    def line(part: Expr) -> Expr | None:
        if not isinstance(part, AppliedUndef):
            return None
        if set(getattr(part.func, "_kwargs", {})) - {"commutative"}:
            raise Unsupported(f"something is assumed of {part}")
        first, second = _coefficients(part.func)
        arguments = sp.Add(*map(_with_lines, part.args), evaluate=False)
        return sp.Add(first, sp.Mul(second, arguments, evaluate=False), evaluate=False)

    return replaced(form, line)


@cache
def _coefficients(function: type[Expr]) -> tuple[sp.Dummy, sp.Dummy]:
    """Two numbers of which no formula knows, whatever its symbols are called."""
    return sp.Dummy(f"{function.__name__}_0"), sp.Dummy(f"{function.__name__}_1")


def _may_be(thing: Expr, side: Expr, at: Point) -> bool:
    """Whether what is defined can be this number or, rational in a complex symbol, all but one."""
    if isinstance(thing, AppliedUndef):
        return True
    if not isinstance(thing, sp.Symbol):
        return any(sp.cancel(thing.xreplace(at)).has(s) for s in _variables(thing))
    if len(thing.assumptions0) > 1:
        number = value_at(side, at)
        return isinstance(number, Expr) and admissible(thing, number)
    if is_complex(thing):
        return True
    there = ball(side, at)
    if not there.imag.contains(0):
        return False
    entry = SYMBOLS.get(thing.name)
    return entry is None or entry.domain == "real" or not bool(there.real < 0)


def differs(left: Expr, right: Expr, at: Mapping[Expr, Expr]) -> bool:
    """Whether two forms certainly differ at a point where both are defined.

    Two numbers differ if their balls do, by both routines that compute them; two relations if one
    is true and the other is not.
    """
    try:
        return _differ(left, right, at)
    except (Uncheckable, Unsupported):
        return False


def _differ(left: Expr, right: Expr, at: Mapping[Expr, Expr]) -> bool:
    """The same; raises :class:`Uncheckable` for a function without balls."""
    if isinstance(left, Relational) or isinstance(right, Relational):
        truths = (truth(form, at) for form in (left, right))
        return set(truths) == {True, False}
    if not (isinstance(left, Expr) and isinstance(right, Expr)):
        return {left, right} == {sp.true, sp.false}
    for bits in _BITS:
        with ctx.workprec(bits):
            ours, theirs = _number(left, at), _number(right, at)
            if ours.is_finite() and theirs.is_finite() and not ours.overlaps(theirs):
                return not ball(left, at, bits).overlaps(ball(right, at, bits))
            if bits > _FEW_BITS[0] and not (ours.is_finite() and theirs.is_finite()):
                return False
    return False


def truth(form: Expr, at: Mapping[Expr, Expr]) -> bool | None:
    """The truth of a relation at a point; None where a side is undefined, or it is not known.

    That two sides are equal is not seen by balls but known from the normal form.  Raises
    :class:`Uncheckable` for a function without balls.

    >>> x = sp.Symbol("x")
    >>> truth(x < 1, {x: sp.S.One}), truth(1 / x < 1, {x: sp.S.Zero}) is None
    (False, True)
    """
    if form in (sp.true, sp.false):
        return bool(form)
    if not isinstance(form, Relational):
        return None
    equation, defined = isinstance(form, (sp.Eq, sp.Ne)), False
    for left, right in _balls(form.args, at, _FEW_BITS):
        defined = True
        if equation and not left.overlaps(right):
            return isinstance(form, sp.Ne)
        if not equation:
            if not _real(form.args, (left, right)):
                return None
            if left.real < right.real or left.real > right.real:
                return bool(form.func(int(left.real > right.real), int(left.real < right.real)))
    try:
        known = value_at(form, at) if defined else None
    except Unsupported:
        return None
    return known if isinstance(known, bool) else None


def _balls(
    sides: Iterable[Expr], at: Mapping[Expr, Expr], precisions: Iterable[int]
) -> Iterator[list[acb]]:
    """Balls of all sides at a point, at each precision at which all are finite."""
    sides = list(sides)
    for bits in precisions:
        with ctx.workprec(bits):
            found = [_number(side, at) for side in sides]
        if all(number.is_finite() for number in found):
            yield found


def _real(sides: Iterable[Expr], numbers: Iterable[acb]) -> bool:
    """Whether numbers are shown to be real."""
    pairs = zip(sides, numbers, strict=True)
    return all(x.imag.is_zero() or (x.imag.contains(0) and is_real(side)) for side, x in pairs)


def _number(expr: Expr, at: Mapping[Expr, Expr]) -> acb:
    symbols = sorted(expr.free_symbols, key=str)
    if not at.keys() >= set(symbols):
        raise Uncheckable(f"not every symbol of {expr} has a value")
    found: acb = program(expr, symbols)(*(value(at[s]) for s in symbols))
    return found


def where_defined(*forms: Expr, at: Point | None = None) -> Point | None:
    """A point at which all sides of some forms are defined, those of an inequality real.

    Some symbols have values already (``at``).  Raises :class:`Uncheckable` or
    :class:`Unsupported` for a function without balls.

    >>> x = sp.Symbol("x")
    >>> where_defined(1 / x), where_defined(1 / sp.Add(x, -x, evaluate=False))
    ({x: 1}, None)
    """
    known, sides, ordered = at or {}, list[Expr](), list[Expr]()
    for form in forms:
        placed = replaced(_with_lines(form), known.get)
        both = placed.args if isinstance(placed, Relational) else (placed,)
        sides += (side for side in both if isinstance(side, Expr))
        if isinstance(placed, Relational) and not isinstance(placed, (sp.Eq, sp.Ne)):
            ordered += both
    size = sum(map(size_of, sides))
    for point in points(*sides):
        spend(10 * size)
        for numbers in _balls(sides, point, _FEW_BITS):
            found = dict(zip(sides, numbers, strict=True))
            if _real(ordered, [found[side] for side in ordered]):
                return {**known, **point}
    return None

"""A point at which two forms certainly differ, looked for exactly and confirmed by balls."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

import sympy as sp
from flint import acb, ctx
from sympy import Expr
from sympy.core.function import Application, AppliedUndef
from sympy.core.relational import Relational

from symhaptic.notation import SYMBOLS
from symhaptic.proof.ball import ball, differs_from_zero
from symhaptic.proof.budget import spend
from symhaptic.proof.names import admissible
from symhaptic.proof.points import Point, points
from symhaptic.proof.program import Uncheckable, known, program, value
from symhaptic.proof.rewriting import Unsupported, is_complex
from symhaptic.proof.values import Value, value_at

_BITS = (64, 256, 1024, 4096)


def told_apart(
    left: Expr, right: Expr, anywhere: bool = False
) -> tuple[Point, tuple[Value, Value]] | None:
    """A point where both are defined and certainly differ; an unknown H is tried as H_0 + H_1 x.

    It has what the symbols are assumed to be, and is confirmed by a second routine from the forms
    as they are written.  Of two definitions of one thing the right sides are told apart.
    ``anywhere``: at real numbers outside the domains of the notation, too.

    >>> x = sp.Symbol("x")
    >>> told_apart(x < 1, x <= 1)[0]
    {x: 1}
    """
    one = defines_one(left, right)
    found = _differing(left.rhs, right.rhs, anywhere, left.lhs) if one else None
    if found and not found[0] and isinstance(left.lhs, sp.Symbol):
        return _solved(left.lhs, found[1])
    return found or _differing(left, right, anywhere)


def _solved(symbol: Expr, numbers: tuple[Value, Value]) -> tuple[Point, tuple[Value, Value]] | None:
    """Where nothing else has to be chosen, one of the two numbers that a symbol is said to be."""
    number = next(n for n in numbers if _may_have(symbol, n, {}))
    return ({symbol: number}, numbers) if isinstance(number, Expr) else None


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
) -> tuple[Point, tuple[Value, Value]] | None:
    try:
        left, right = _with_lines(left), _with_lines(right)
    except Unsupported:
        return None
    size = sum(1 for form in (left, right) for _ in sp.preorder_traversal(form))
    for point in points(left, right, anywhere=anywhere):
        spend(100 * size)
        values = differ(left, right, point)
        if values is None or None in values:
            continue
        if defined is not None and not any(_may_have(defined, v, point) for v in values):
            continue
        try:
            if confirmed(left, right, point, values):
                return point, values
        except Uncheckable:
            return None
    return None


def _with_lines(expr: Expr) -> Expr:
    if isinstance(expr, AppliedUndef):
        if set(getattr(expr.func, "_kwargs", {})) - {"commutative"}:
            raise Unsupported(f"{expr}, of which something is assumed")
        first, second = _line(expr.func)
        return first + second * sum(_with_lines(a) for a in expr.args)
    if not expr.args:
        return expr
    inner = [_with_lines(a) for a in expr.args]
    if all(new is old for new, old in zip(inner, expr.args, strict=True)):
        return expr
    if isinstance(expr, (Relational, sp.re)):
        return expr.func(*inner, evaluate=False)
    return expr.func(*inner)


@cache
def _line(function: type[Expr]) -> tuple[sp.Dummy, sp.Dummy]:
    """Two numbers of which no formula knows, whatever its symbols are called."""
    return sp.Dummy(f"{function.__name__}_0"), sp.Dummy(f"{function.__name__}_1")


def _may_have(thing: Expr, number: Value, at: Point) -> bool:
    """Whether what is defined can be this number or, rational in a complex symbol, all but one."""
    if not isinstance(number, Expr) or isinstance(thing, AppliedUndef):
        return True
    if not isinstance(thing, sp.Symbol):
        return any(sp.cancel(thing.xreplace(at)).has(s) for s in _variables(thing))
    if len(thing.assumptions0) > 1:
        return admissible(thing, number)
    if is_complex(thing):
        return True
    there = ball(number)
    if not there.imag.contains(0):
        return False
    entry = SYMBOLS.get(thing.name)
    return entry is None or entry.domain == "real" or not bool(there.real < 0)


def differ(left: Expr, right: Expr, at: Mapping[Expr, Expr]) -> tuple[Value, Value] | None:
    """The two values at a point if they are certainly different, else None."""
    try:
        ours, theirs = value_at(left, at), value_at(right, at)
        if ours is None or theirs is None or isinstance(ours, bool) or isinstance(theirs, bool):
            return (ours, theirs) if ours is not theirs else None
        return (ours, theirs) if differs_from_zero(ours - theirs) else None
    except Unsupported:
        return None


# -- the second routine ----------------------------------------------------------------


def confirmed(
    left: Expr, right: Expr, at: Mapping[Expr, Expr], values: tuple[Value, Value]
) -> bool:
    """Whether balls of the forms as they are written agree that they differ at a point.

    All sides must be defined.  Balls may only not contradict what is known of relations, for that
    two numbers are equal is not seen by balls but known from the normal form.
    """
    if not (isinstance(left, Expr) and isinstance(right, Expr)):
        pairs = zip(values, (left, right), strict=True)
        return all(truth in _truths(form, at) for truth, form in pairs)
    for bits in _BITS:
        with ctx.workprec(bits):
            ours, theirs = _number(left, at), _number(right, at)
            difference = ours - theirs
            if difference.is_finite() and not difference.contains(acb(0)):
                return True
    return False


def defined_somewhere(forms: Iterable[Expr]) -> bool:
    """Whether a point is found at which all sides of some forms are defined.

    Functions that balls do not know are taken for defined.

    >>> x = sp.Symbol("x")
    >>> defined_somewhere([1/x]), defined_somewhere([1/sp.Add(x, -x, evaluate=False)])
    (True, False)
    """
    each = (form.args if isinstance(form, Relational) else (form,) for form in forms)
    sides = [_without_unknown(side) for pair in each for side in pair if isinstance(side, Expr)]
    size = sum(1 for side in sides for _ in sp.preorder_traversal(side))
    for point in points(*sides):
        spend(10 * size)
        for bits in _BITS[:2]:
            with ctx.workprec(bits):
                if all(_number(side, point).is_finite() for side in sides):
                    return True
    return False


def _without_unknown(expr: Expr) -> Expr:
    if isinstance(expr, Application) and not known(expr.func):
        return sp.Dummy()
    if not expr.args:
        return expr
    inner = [_without_unknown(a) for a in expr.args]
    if all(new is old for new, old in zip(inner, expr.args, strict=True)):
        return expr
    return expr.func(*inner, evaluate=False)


def _number(expr: Expr, at: Mapping[Expr, Expr]) -> acb:
    symbols = sorted(expr.free_symbols, key=str)
    found: acb = program(expr, symbols)(*(value(at[s]) for s in symbols))
    return found


def _truths(form: Expr, at: Mapping[Expr, Expr]) -> set[bool]:
    """The truth values that a relation can have at a point; none where it is not defined."""
    if not isinstance(form, Relational):
        return {bool(form)} if form in (sp.true, sp.false) else set()
    possible: set[bool] = set()
    for bits in _BITS:
        with ctx.workprec(bits):
            sides = [_number(side, at) for side in form.args]
        if not all(side.is_finite() for side in sides):
            continue
        if isinstance(form, (sp.Eq, sp.Ne)):
            unlike = isinstance(form, sp.Ne)
            possible = {unlike} if not sides[0].overlaps(sides[1]) else {True, False}
        else:
            if not all(side.imag.contains(0) for side in sides):
                return set()
            possible = _orders(form, sides[0], sides[1])
        if len(possible) == 1:
            break
    return possible


def _orders(form: Relational, left: acb, right: acb) -> set[bool]:
    upwards = isinstance(form, (sp.StrictLessThan, sp.LessThan))
    if left.real < right.real:
        return {upwards}
    if left.real > right.real:
        return {not upwards}
    return {True, False}

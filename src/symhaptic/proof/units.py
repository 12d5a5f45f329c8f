"""Dimensional analysis of a formula: every sum, relation and function argument is checked."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp
from sympy import Expr

from symhaptic.notation import FUNCTIONS, ONE, SYMBOLS, UNITS, Dimension

Place = tuple[Expr, Dimension]


class UnitError(ValueError):
    """A formula that adds, compares or exponentiates what does not match."""

    def __init__(self, what: str, *places: Place) -> None:
        super().__init__(what)
        self.places = places
        """The offending parts with their dimensions."""


def shown(unit: Dimension) -> str:
    """A dimension in words: a named unit where there is one.

    >>> shown(UNITS["N/m"])
    'N/m'
    """
    for name, known in UNITS.items():
        if known == unit:
            return name
    parts = [f"{n}^{e}" for n, e in zip(("kg", "m", "s"), unit, strict=True) if e]
    return " ".join(parts)


def _times(left: Dimension, right: Dimension) -> Dimension:
    return (left[0] + right[0], left[1] + right[1], left[2] + right[2])


def dimension_of(expr: Expr, extra: Mapping[str, Dimension] | None = None) -> Dimension:
    """The dimension of an expression.

    ``extra`` gives the dimensions of symbols that are not in the notation.  Raises
    :class:`UnitError`, which names the parts that disagree.

    >>> from symhaptic.notation import K, T, m
    >>> shown(dimension_of(K*T**2/m))
    '1'
    """
    known = {name: entry.dimension for name, entry in SYMBOLS.items()} | dict(extra or {})
    return _dimension(expr, known)


def of_another_unit(name: Expr, meaning: Expr) -> str | None:
    """What is wrong with a name that stands for something, by their units; nothing where they are
    the same, the notation knows no unit of one, or the meaning is zero.

    >>> from symhaptic.notation import K, T, m
    >>> of_another_unit(K, m/T)
    'K is in N/m, what it stands for in Ns/m'
    """
    if meaning == 0:
        return None
    try:
        ours, theirs = dimension_of(name), dimension_of(meaning)
    except UnitError as wrong:
        return str(wrong) if all(s.name in SYMBOLS for s in name.free_symbols) else None
    if ours == theirs:
        return None
    return f"{name} is in {shown(ours)}, what it stands for in {shown(theirs)}"


def _dimension(expr: Expr, known: Mapping[str, Dimension]) -> Dimension:
    if expr.is_Symbol:
        if expr.name not in known:
            raise UnitError(f"the symbol {expr.name} has no unit")
        return known[expr.name]
    if expr.is_number:
        return ONE
    if expr.is_Mul:
        unit = ONE
        for arg in expr.args:
            unit = _times(unit, _dimension(arg, known))
        return unit
    if expr.is_Add:
        return _agreed(expr, [a for a in expr.args if a != 0], known, "adds")
    if isinstance(expr, sp.core.relational.Relational):
        return _agreed(expr, [a for a in expr.args if a != 0], known, "compares")
    if expr.is_Pow:
        base, power = expr.args
        unit = _dimension(base, known)
        if power.is_Rational:
            q = int(power.p), int(power.q)
            return (unit[0] * q[0] / q[1], unit[1] * q[0] / q[1], unit[2] * q[0] / q[1])
        _pure(power, known)
        _pure(base, known)
        return ONE
    if isinstance(expr, (sp.Abs, sp.re, sp.im, sp.conjugate)):
        return _dimension(expr.args[0], known)
    if isinstance(expr, sp.core.function.AppliedUndef) and expr.func.__name__ in FUNCTIONS:
        _pure(expr.args[0], known)
        return UNITS[FUNCTIONS[expr.func.__name__][0]]
    if expr.is_Function:
        for arg in expr.args:
            _pure(arg, known)
        return ONE
    raise UnitError(f"no unit for {type(expr).__name__}")


def _agreed(whole: Expr, parts: list[Expr], known: Mapping[str, Dimension], verb: str) -> Dimension:
    places = [(part, _dimension(part, known)) for part in parts]
    if not places:
        return ONE
    first = places[0]
    for place in places[1:]:
        if place[1] != first[1]:
            raise UnitError(f"{verb} {shown(first[1])} and {shown(place[1])}", first, place)
    return first[1]


def _pure(expr: Expr, known: Mapping[str, Dimension]) -> None:
    unit = _dimension(expr, known)
    if unit != ONE:
        raise UnitError(f"takes a function of a quantity in {shown(unit)}", (expr, unit))

"""What a user may ask about: formulas, boxes and exact numbers; all else is refused in a line."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from fractions import Fraction
from numbers import Number
from typing import Any, TypeAlias

import sympy as sp
from sympy import Expr
from sympy.core.function import AppliedUndef, UndefinedFunction
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanAtom

from symhaptic.proof.ball import ball
from symhaptic.proof.budget import size_of, spend
from symhaptic.proof.certificate import Box
from symhaptic.proof.names import renamed, shared
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.shape import Form

Ends: TypeAlias = Mapping[sp.Symbol, tuple[object, object]]
"""Closed interval of each symbol."""

_TO_READ = 20
"""Steps for each part of a formula."""

_SYMBOLS = (sp.Symbol, sp.Dummy)

_DEEP = 100
"""Lists within lists."""


def form_of(caller: str, form: Any, depth: int = 0) -> Form:
    """A formula, relation, matrix or list of them with exact or floating numbers as SymPy's.

    Raises :class:`TypeError` for anything else; text is not read, since SymPy would run it.
    """
    if depth > _DEEP:
        raise ValueError(f"{caller}: lists are nested more than {_DEEP} deep")
    if isinstance(form, sp.MatrixBase):
        for entry in form:
            form_of(caller, entry, depth + 1)
        return form
    if isinstance(form, (Sequence, sp.Tuple)) and not isinstance(form, (str, bytes, bytearray)):
        return [form_of(caller, part, depth + 1) for part in form]
    if isinstance(form, Number) and not isinstance(form, sp.Basic):
        return _number(caller, form)
    if isinstance(form, Relational):
        if all(isinstance(side, Expr) and not side.is_Matrix for side in form.args):
            return _known(caller, form)
    elif isinstance(form, (Expr, BooleanAtom)) and not isinstance(form, sp.Lambda):
        return _known(caller, form)
    raise TypeError(
        f"{caller}: {form!r} is no formula; give SymPy expressions, relations or sequences of them"
    )


def _number(caller: str, number: Any) -> Expr:
    """A number of Python's as one of SymPy's; an interval, say, is none."""
    try:
        return sp.sympify(number, strict=True)
    except (sp.SympifyError, ValueError, OverflowError):
        raise TypeError(
            f"{caller}: {number!r} ({type(number).__name__}) is no number; give one of SymPy"
        ) from None


def _known(caller: str, form: Any) -> Any:
    """A form of which all parts are made by SymPy or this package, and can be printed.

    A class of a user's own may say of itself what it likes: that it is rational, or equal to x.
    """
    left, seen, digits = [form], set[int](), sys.get_int_max_str_digits()
    while left:
        part = left.pop()
        if id(part) in seen:
            continue
        seen.add(id(part))
        if not _made_here(type(part)) or (part.is_Symbol and type(part) not in _SYMBOLS):
            raise TypeError(
                f"{caller}: {type(part).__name__} is an unknown class; give formulas of SymPy"
            )
        if part.is_Rational and digits and _longer(part, digits):
            raise ValueError(f"{caller}: a number is too long; give at most {digits} digits")
        left += (arg for arg in part.args if isinstance(arg, sp.Basic))
    return form


def _made_here(kind: type) -> bool:
    if isinstance(kind, UndefinedFunction):
        return bool(kind.__bases__ == (AppliedUndef,))
    return kind.__module__.partition(".")[0] in ("sympy", "symhaptic")


def _longer(number: sp.Rational, digits: int) -> bool:
    """Whether it may have more digits than Python prints."""
    return bool(max(abs(number.p), number.q).bit_length() > 3.3 * digits)


def exact(caller: str, name: str, number: Any) -> Expr:
    """An expression with exact numbers; :class:`TypeError` for text and what is no number."""
    if not isinstance(number, (Expr, int, Fraction)) and not (
        isinstance(number, Number) and not isinstance(number, complex)
    ):
        kind = ValueError if number is None or isinstance(number, (list, tuple)) else TypeError
        raise kind(f"{caller}: {name}: {number!r} is not allowed; give a SymPy expression")
    found = number if isinstance(number, Expr) else _number(caller, number)
    if not isinstance(found, Expr) or isinstance(found, sp.Lambda):
        raise TypeError(f"{caller}: {name}: {number!r} is not allowed; give a SymPy expression")
    if _known(caller, found).has(sp.Float):
        raise ValueError(
            f"{caller}: {name}: {number} has a float; give exact numbers, such as Rational(1, 10)"
        )
    return found


def spend_reading(*forms: Expr) -> None:
    """Take off the budget what looking costs: SymPy sees each part as often as it occurs."""
    spend(_TO_READ * sum(map(size_of, forms)))


def allowed_steps(caller: str, steps: Any) -> None:
    """Raises unless it is a positive whole number."""
    if not isinstance(steps, int) or isinstance(steps, bool):
        raise TypeError(f"{caller}: steps: {steps!r} is not allowed; give a whole number")
    if steps < 1:
        raise ValueError(f"{caller}: steps: {steps} is not allowed; give 1 or more")


def box_of(caller: str, ends: Any, *forms: Expr) -> tuple[Box, list[Expr]]:
    """A box with exact ends and forms of its symbols; an error names what is wrong with it."""
    if not isinstance(ends, Mapping):
        raise TypeError(f"{caller}: box: {ends!r} is no mapping of symbols to intervals")
    given = list(ends.items())  # read once: a class of one's own may say something else again
    for symbol, _ in given:
        if type(symbol) not in _SYMBOLS:
            raise TypeError(f"{caller}: box: {symbol!r} is no symbol")
    names = shared(
        caller, {s for form in forms for s in form.free_symbols} | {symbol for symbol, _ in given}
    )
    box: dict[sp.Symbol, tuple[Expr, Expr]] = {}
    for written, pair in given:
        symbol = names.get(written, written)
        if symbol in box:
            raise ValueError(f"{caller}: box: two intervals for {symbol}; give one")
        box[symbol] = _interval(caller, symbol, pair)
    told = [renamed(form, names) for form in forms]
    missing = set().union(*(form.free_symbols for form in told)) - set(box)
    if missing:
        listed = ", ".join(sorted(map(str, missing)))
        raise ValueError(f"{caller}: box: no interval for {listed}; one for each symbol is needed")
    return box, told


def _interval(caller: str, symbol: sp.Symbol, pair: Any) -> tuple[Expr, Expr]:
    if isinstance(pair, str):
        raise TypeError(f"{caller}: box: {pair!r} of {symbol} is no pair (lower, upper)")
    if not isinstance(pair, (tuple, list, sp.Tuple)) or len(pair) != 2:
        raise ValueError(f"{caller}: box: {pair!r} of {symbol} is no pair (lower, upper)")
    ends = tuple(pair)
    for end in ends:
        if isinstance(end, (str, bytes)):
            raise TypeError(
                f"{caller}: box: {end!r} of {symbol} is text; give an exact real number, "
                "such as Rational(1, 10)"
            )
    low, high = (_end(caller, symbol, end) for end in ends)
    if (high - low).is_negative:
        raise ValueError(f"{caller}: box: ({low}, {high}) of {symbol} is empty")
    beyond = (low.is_negative and symbol.is_extended_nonnegative) or (
        high.is_positive and symbol.is_extended_nonpositive
    )
    unlike = symbol.is_integer or symbol.is_antihermitian or not symbol.is_commutative
    if beyond or unlike or False in (symbol.is_real, symbol.is_finite):
        raise ValueError(
            f"{caller}: box: ({low}, {high}) has numbers that {symbol} is assumed not to be"
        )
    return low, high


def _end(caller: str, symbol: sp.Symbol, end: Any) -> Expr:
    known = end
    if isinstance(end, Number) and not isinstance(end, (sp.Basic, complex)):
        known = _number(caller, end)
    if not (
        isinstance(known, Expr)
        and _known(caller, known).is_commutative
        and not known.free_symbols
        and not known.has(sp.Float)
        and _has_ball(known)
        and known.is_finite
        and known.is_real
    ):
        raise ValueError(
            f"{caller}: box: {end} of {symbol} is not allowed; give an exact real number, "
            "such as Rational(1, 10)"
        )
    return known


def _has_ball(number: Expr) -> bool:
    try:
        found = ball(number)
    except Unsupported:
        return False
    return bool(found.is_finite() and found.imag.contains(0))

"""Two forms compared: proved equal, told apart by a counterexample, or left undecided."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import sympy as sp
from sympy import Expr
from sympy.core.relational import Relational

from symhaptic.notation.latex import latex
from symhaptic.proof.names import renamed, shared
from symhaptic.proof.normal import Field
from symhaptic.proof.points import Point, choices, points
from symhaptic.proof.refute import defines_one, told_apart
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.shape import Form, misfit, parts
from symhaptic.proof.values import value_at


@dataclass(frozen=True)
class Comparison:
    """``equal`` is None where neither a proof nor a counterexample was found."""

    equal: bool | None
    how: str | Field
    """In words, or the field in which the difference is zero."""
    point: Point | None = None
    """Where they differ; empty where they differ in kind or number."""

    @property
    def method(self) -> str:
        """How it was found, in words; a field is named when somebody asks."""
        return self.how if isinstance(self.how, str) else f"zero in {field_name(self.how)}"


def compare(left: Form, right: Form, anywhere: bool = False) -> Comparison:
    """Whether two forms say the same, component by component.

    Two relations say the same if they are of one kind and their two sides differ by the same
    amount, up to a positive rational factor.  Where they are not the same, a point is looked
    for at which one holds and the other does not.  It lies in the domains of the notation; one
    that lies ``anywhere`` is told where that is asked for, and tells nothing apart.

    >>> x = sp.Symbol("x")
    >>> compare(sp.cos(2*x), 1 - 2*sp.sin(x)**2).equal
    True
    >>> compare(x < 1, x <= 1).equal, compare(x < 1, 2*x < 2).equal
    (False, True)
    """
    unlike = misfit(left, right)
    if unlike:
        return Comparison(False, unlike, {})
    ours, theirs = _unified(parts(left), parts(right))
    if not ours:
        return Comparison(None, "nothing to compare")
    how: str | Field = ""
    for one, other in zip(ours, theirs, strict=True):
        result = _shown(one, other)
        if result is None:
            result = _told_apart(one, other, anywhere)
        elif result.equal is None:  # the normal form cannot say; a point may
            told = _told_apart(one, other, False)
            result = told if told.equal is False else result
        if not result.equal:
            return result
        how = result.how or how
    return Comparison(True, how)


def equal(left: Form, right: Form) -> bool:
    """Whether two forms are proved to say the same, without asking why they should not.

    >>> x = sp.Symbol("x")
    >>> equal(sp.tan(x), sp.sin(x)/sp.cos(x)), equal(x < 1, x <= 1)
    (True, False)
    """
    if misfit(left, right):
        return False
    ours, theirs = _unified(parts(left), parts(right))
    if not ours:
        return False
    found = (_shown(one, other) for one, other in zip(ours, theirs, strict=True))
    return all(result is not None and result.equal for result in found)


def _unified(*forms: tuple[Expr, ...]) -> list[tuple[Expr, ...]]:
    """The forms with one symbol for each name."""
    symbols = {s for form in forms for part in form for s in part.free_symbols}
    names = shared("compare", symbols)
    return [tuple(renamed(part, names) for part in form) for form in forms]


def _shown(left: Expr, right: Expr) -> Comparison | None:
    """What the normal form shows; None where that is not enough to say that they are equal."""
    try:
        if isinstance(left, Relational) and isinstance(right, Relational):
            return _relations(_turned(left), _turned(right))
        if not (isinstance(left, Expr) and isinstance(right, Expr)):
            return Comparison(True, "identical") if left == right else None
        field = Field([left, right])
        if field.are_equal(left, right):
            return Comparison(True, field)
    except (Unsupported, Undefined) as unknown:
        return Comparison(None, str(unknown))
    return None


def _relations(left: Relational, right: Relational) -> Comparison | None:
    if left.func != right.func:
        return None
    if isinstance(left, (sp.Eq, sp.Ne)) and left.lhs == right.lhs:
        same = _shown(left.rhs, right.rhs)
        if defines_one(left, right) or (same and same.equal):
            return same
    ours, theirs = left.lhs - left.rhs, right.lhs - right.rhs
    field = Field([ours, theirs])
    if _proportional(field, ours, theirs, signed=isinstance(left, (sp.Eq, sp.Ne))):
        return Comparison(True, field)
    return None


def _turned(relation: Expr) -> Expr:
    """The relation with its smaller side on the right."""
    if isinstance(relation, (sp.StrictLessThan, sp.LessThan)):
        return relation.reversed
    return relation


def _proportional(field: Field, ours: Expr, theirs: Expr, signed: bool) -> bool:
    if field.is_zero(ours) or field.is_zero(theirs):
        return field.is_zero(ours) and field.is_zero(theirs)
    if field.are_equal(ours, theirs):
        return True
    for point in itertools.islice(points(ours, theirs), 3):
        top, bottom = value_at(ours, point), value_at(theirs, point)
        if isinstance(top, Expr) and isinstance(bottom, Expr) and bottom != 0:
            ratio = top / bottom
            if not ratio.is_Rational or (ratio < 0 and not signed):
                return False
            scaled = ratio * theirs
            return Field([ours, scaled]).are_equal(ours, scaled)
    return False


def field_name(field: Field) -> str:
    """A field by its generators, as LaTeX."""
    return _named_field(tuple(g for g in field.generators() if not g.has(sp.Dummy)))


@lru_cache(maxsize=1 << 8)
def _named_field(generators: tuple[Expr, ...]) -> str:
    inner = ",".join(map(latex, generators))
    return rf"$\mathbb{{Q}}({inner})$" if inner else r"$\mathbb{Q}$"


def _told_apart(left: Expr, right: Expr, anywhere: bool) -> Comparison:
    if isinstance(left, Expr) != isinstance(right, Expr):
        return Comparison(False, "a relation against an expression", {})
    point = told_apart(left, right)
    if point is None:
        outside = _told_apart_outside(left, right) if anywhere else ""
        return Comparison(None, f"neither proved nor told apart{outside}")
    return Comparison(False, "the two sides differ", point)


def _told_apart_outside(left: Expr, right: Expr) -> str:
    """Where two forms differ that may be equal in the domains of the notation, or nothing."""
    symbols = left.free_symbols | right.free_symbols
    if all(choices(symbol) == choices(symbol, anywhere=True) for symbol in symbols):
        return ""
    at = named(told_apart(left, right, anywhere=True)) or {}
    where = ", ".join(f"{name} = {number}" for name, number in at.items())
    return f", but outside the domains of the notation, at {where}" if at else ""


def named(point: Mapping[Expr, Expr] | None) -> dict[str, str] | None:
    """A point with plain names and exact numbers as text; of two dummies one is marked.

    >>> named({sp.Dummy("x"): sp.S.Half, sp.Dummy("x"): sp.S.One})
    {'x': '1/2', 'x_2': '1'}
    """
    if point is None:
        return None
    found: dict[str, str] = {}
    for symbol, number in point.items():
        names = (f"{symbol.name}_{k}" if k > 1 else symbol.name for k in itertools.count(1))
        found[next(name for name in names if name not in found)] = str(number)
    return found

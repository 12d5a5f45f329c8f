"""Two forms compared: proved equal, told apart by a counterexample, or left undecided."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp
from sympy import Expr
from sympy.core.relational import Relational

from symhaptic.latex import latex
from symhaptic.proof.ball import Value, differs_from_zero, value_at
from symhaptic.proof.normal import Field
from symhaptic.proof.points import Point, points
from symhaptic.proof.rewriting import Undefined, Unsupported

Form: TypeAlias = Expr | Sequence[Expr]


@dataclass(frozen=True)
class Comparison:
    """``equal`` is None where neither a proof nor a counterexample was found."""

    equal: bool | None
    method: str
    point: Point | None = None
    values: tuple[Value, Value] | None = None


def parts(form: Form) -> tuple[Expr, ...]:
    """A form as a tuple of expressions or relations: vectors and lists of equations unfold.

    >>> parts(sp.Matrix([1, 2]))
    (1, 2)
    """
    if isinstance(form, sp.MatrixBase):
        return tuple(form)
    if isinstance(form, (Sequence, sp.Tuple)):
        return tuple(p for part in form for p in parts(part))
    return (sp.sympify(form),)


def compare(left: Form, right: Form) -> Comparison:
    """Whether two forms say the same, component by component.

    Two relations say the same if they are of one kind and their two sides differ by the same
    amount, up to a positive rational factor.  Where they are not the same, a point is looked
    for at which one holds and the other does not.

    >>> x = sp.Symbol("x")
    >>> compare(sp.cos(2*x), 1 - 2*sp.sin(x)**2).equal
    True
    >>> compare(x < 1, x <= 1).equal, compare(x < 1, 2*x < 2).equal
    (False, True)
    """
    ours, theirs = parts(left), parts(right)
    if not ours and not theirs:
        return Comparison(None, "nothing to compare")
    if len(ours) != len(theirs):
        return Comparison(False, f"{len(ours)} components against {len(theirs)}", {})
    method = ""
    for one, other in zip(ours, theirs, strict=True):
        result = _shown(one, other) or _told_apart(one, other)
        if not result.equal:
            return result
        method = result.method or method
    return Comparison(True, method)


def equal(left: Form, right: Form) -> bool:
    """Whether two forms are proved to say the same, without asking why they should not.

    >>> x = sp.Symbol("x")
    >>> equal(sp.tan(x), sp.sin(x)/sp.cos(x)), equal(x < 1, x <= 1)
    (True, False)
    """
    ours, theirs = parts(left), parts(right)
    if not ours or len(ours) != len(theirs):
        return False
    found = (_shown(one, other) for one, other in zip(ours, theirs, strict=True))
    return all(result is not None and result.equal for result in found)


def _shown(left: Expr, right: Expr) -> Comparison | None:
    """What the normal form shows; None where that is not enough to say that they are equal."""
    try:
        if isinstance(left, Relational) and isinstance(right, Relational):
            return _relations(_turned(left), _turned(right))
        if not (isinstance(left, Expr) and isinstance(right, Expr)):
            return Comparison(True, "identical") if left == right else None
        field = Field([left, right])
        if field.are_equal(left, right):
            return Comparison(True, f"zero in {field_name(field)}")
    except Unsupported as missing:
        return Comparison(None, str(missing))
    except Undefined as pole:
        return Comparison(False, str(pole), {})
    return None


def _relations(left: Relational, right: Relational) -> Comparison | None:
    if left.func != right.func:
        return None
    if _of_one_thing(left, right):
        same = _shown(left.rhs, right.rhs)
        if not (left.rhs.has(left.lhs) or right.rhs.has(left.lhs)) or (same and same.equal):
            return same
    ours, theirs = left.lhs - left.rhs, right.lhs - right.rhs
    field = Field([ours, theirs])
    if _proportional(field, ours, theirs, signed=isinstance(left, (sp.Eq, sp.Ne))):
        return Comparison(True, f"zero in {field_name(field)}")
    return None


def _of_one_thing(left: Expr, right: Expr) -> bool:
    """Two equations with the same left side."""
    kinds = (sp.Eq, sp.Ne)
    return isinstance(left, kinds) and isinstance(right, kinds) and left.lhs == right.lhs


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
    generators = [g for g in field.generators() if not g.has(sp.Dummy)]
    inner = ",".join(latex(g) for g in generators)
    return rf"$\mathbb{{Q}}({inner})$" if inner else r"$\mathbb{Q}$"


# -- counterexamples -------------------------------------------------------------------


def _told_apart(left: Expr, right: Expr) -> Comparison:
    """A point where both are defined and certainly differ; an unknown H is tried as H_0 + H_1 x."""
    if _of_one_thing(left, right):
        found = _told_apart(left.rhs, right.rhs)
        if found.equal is False:
            return found
    left, right = _with_lines(_turned(left)), _with_lines(_turned(right))
    for point in points(left, right):
        values = differ(left, right, point)
        if values is not None and None not in values:
            return Comparison(False, "the two sides differ", point, values)
    return Comparison(None, "neither proved nor told apart")


def _with_lines(expr: Expr) -> Expr:
    if isinstance(expr, sp.core.function.AppliedUndef):
        first, second = sp.symbols(f"{expr.func.__name__}_0 {expr.func.__name__}_1")
        return first + second * sum(_with_lines(a) for a in expr.args)
    if not expr.args:
        return expr
    parts_ = [_with_lines(a) for a in expr.args]
    if isinstance(expr, (Relational, sp.re)):
        return expr.func(*parts_, evaluate=False)
    return expr.func(*parts_)


def differ(left: Expr, right: Expr, at: Mapping[Expr, Expr]) -> tuple[Value, Value] | None:
    """The two values at a point if they are certainly different, else None."""
    try:
        ours, theirs = value_at(left, at), value_at(right, at)
        if ours is None or theirs is None or isinstance(ours, bool) or isinstance(theirs, bool):
            return (ours, theirs) if ours is not theirs else None
        return (ours, theirs) if differs_from_zero(ours - theirs) else None
    except Unsupported:
        return None


def named(point: Mapping[Expr, Expr] | None) -> dict[str, str] | None:
    """A point with plain names and exact numbers as text."""
    if point is None:
        return None
    return {str(s).lstrip("_"): str(v) for s, v in point.items()}

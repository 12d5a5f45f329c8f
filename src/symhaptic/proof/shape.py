"""Forms as tuples of expressions, and whether two of them have the same shape."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import sympy as sp
from sympy import Expr

Form: TypeAlias = Expr | Sequence[Expr]


def parts(form: Form) -> tuple[Expr, ...]:
    """A form as a tuple of expressions or relations: vectors and lists of equations unfold.

    >>> parts(sp.Matrix([1, 2]))
    (1, 2)
    """
    if isinstance(form, sp.MatrixBase):
        return tuple(form)
    if _listed(form):
        return tuple(p for part in form for p in parts(part))
    return (sp.sympify(form, strict=True),)


def _listed(form: Form) -> bool:
    return isinstance(form, (Sequence, sp.Tuple)) and not isinstance(form, (str, bytes))


def misfit(left: Form, right: Form) -> str:
    """What of two shapes is not the same, or nothing.

    Matrices have rows and columns; a list is taken for a row or a column, a list of one for the
    one.

    >>> misfit(sp.Matrix([1, 2]), sp.Matrix([[1, 2]])), misfit(sp.Matrix([1, 2]), [1, 2])
    ('2x1 components against 1x2', '')
    """
    if isinstance(left, sp.MatrixBase) and isinstance(right, sp.MatrixBase):
        if left.shape != right.shape:
            return f"{_size(left)} components against {_size(right)}"
        return ""
    ours, theirs = len(parts(left)), len(parts(right))
    if ours != theirs:
        return f"{ours} components against {theirs}"
    for one, other in ((left, right), (right, left)):
        if isinstance(one, sp.MatrixBase):
            return _unlike(one, other)
    if _listed(left) and _listed(right) and len(left) == len(right):
        pairs = zip(left, right, strict=True)
        return next(filter(None, (misfit(one, other) for one, other in pairs)), "")
    if ours == 1:
        return ""
    return "lists of different depth"


def _unlike(matrix: sp.MatrixBase, form: Form) -> str:
    """What tells a matrix from a list of as many components."""
    deep = _listed(form) and any(_listed(row) for row in form)
    rows = [len(row) if _listed(row) else 1 for row in form] if deep else []
    if (deep and rows == [matrix.cols] * matrix.rows) or (not deep and 1 in matrix.shape):
        return ""
    return f"{_size(matrix)} components against a list"


def _size(matrix: sp.MatrixBase) -> str:
    return f"{matrix.rows}x{matrix.cols}"

r"""A condition in LaTeX, such as ``d\in\mathbb{N}_0,\ K\ge0``, read as far as it is a formula.

A counterexample without the condition must lie where the condition does not hold.
"""

from __future__ import annotations

import re

import sympy as sp
from sympy import Expr

from symhaptic.paper.reading import Unreadable, read
from symhaptic.proof.points import Point
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.values import value_at

_WHOLE = re.compile(r"(.+?)\\in\\mathbb\{N\}(_0)?$")
_SHORT = (
    (r"\\le(?![a-z])", r"\\leq "),
    (r"\\ge(?![a-z])", r"\\geq "),
    (r"\\hat\\omega", r"\\hat{\\omega}"),
    (r"\\tfrac(\w)(\w)", r"\\tfrac{\1}{\2}"),
)


def holds(condition: str, at: Point) -> bool | None:
    r"""Whether a condition holds at a point; None where a part of it cannot be read or decided.

    >>> from symhaptic.notation import K, d
    >>> holds(r"d\in\mathbb{N}_0,\ K\ge0", {d: sp.S.Half, K: sp.S.One})
    False
    >>> holds(r"K\ge0", {d: sp.S.Half, K: sp.S.One}), holds(r"\text{or else}", {}) is None
    (True, True)
    """
    if r"\text{or}" in condition:
        return None
    answers = [_part(part, at) for part in re.split(r",\\ |\\ \\text\{and\}\\ ", condition)]
    if False in answers:
        return False
    return None if None in answers else True


def _part(text: str, at: Point) -> bool | None:
    whole = _WHOLE.match(text)
    try:
        if whole:
            number, least = _value(read(whole.group(1))[0], at), 0 if whole.group(2) else 1
            return bool(number.is_integer and number >= least) if isinstance(number, Expr) else None
        for short, long in _SHORT:
            text = re.sub(short, long, text)
        left, unequal, right = text.partition(r"\ne")
        if unequal:
            relations: tuple[Expr, ...] = (sp.Ne(read(left)[0], read(right)[0], evaluate=False),)
        else:
            relations = read(left)
        values = [_value(relation, at) for relation in relations]
    except (Unreadable, Unsupported):
        return None
    if False in values:
        return False
    return True if all(value is True for value in values) else None


def _value(expr: Expr, at: Point) -> Expr | bool | None:
    return value_at(expr, at) if expr.free_symbols <= set(at) else None

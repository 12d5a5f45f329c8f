"""What an expression is made of, where each different part is looked at once.

The same part may stand in very many places of an expression, as in a derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from sympy import Basic


def parts(exprs: Iterable[Basic]) -> set[Basic]:
    """All different parts of expressions, these among them."""
    left = list(exprs)
    found: set[Basic] = set()
    while left:
        expr = left.pop()
        if expr not in found:
            found.add(expr)
            left += expr.args
    return found


def rewritten(expr: Basic, told: Callable[[Basic], Basic]) -> Basic:
    """The expression with what is told in place of each part, inner ones first."""
    known: dict[Basic, Basic] = {}

    def done(part: Basic) -> Basic:
        if part not in known:
            inner = tuple(map(done, part.args))
            known[part] = told(part if inner == part.args else part.func(*inner))
        return known[part]

    return done(expr)

"""How many operations a function takes at most, whatever its arguments."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

import sympy as sp
from sympy import Expr

from symhaptic.export.blocks import Block, Choice, Join, expressions
from symhaptic.export.branches import guarded
from symhaptic.export.module import Library
from symhaptic.export.routine import Repeat

KINDS = "additions", "products", "quotients", "roots", "comparisons", "functions"
"""Differences are additions; Max and Min are comparisons; functions are those of a library."""

_FREE = sp.Abs, sp.Symbol, sp.Number, sp.NumberSymbol, sp.logic.boolalg.BooleanAtom
"""A sign costs nothing."""


def most(library: Library) -> dict[str, Counter[str]]:
    """Of each public function: of each kind, as many as no branch exceeds.

    >>> from symhaptic.export import request
    >>> forms = request.chosen(["linear_limit"])
    >>> made, _ = request.built(request.target("c"), forms, vectors=False)
    >>> sorted(most(made)["linear_limit"].items())
    [('additions', 2), ('comparisons', 5), ('quotients', 1)]
    """
    known: dict[str, Counter[str]] = {}
    for helper in library.helpers:
        known[helper.name] = _block(guarded(helper), known)
    return {r.name: _block(guarded(r), known) for r in library.public}


def _block(block: Block, known: dict[str, Counter[str]]) -> Counter[str]:
    total: Counter[str] = Counter(dict.fromkeys(KINDS, 0))
    for statement in block:
        for expr in expressions(statement):
            total += _of(expr, known)
        if isinstance(statement, (Choice, Join)):
            total += _larger([_block(side, known) for side in (statement.yes, statement.no)])
        if isinstance(statement, Repeat):
            total += _of(statement.brief, known)
            inner = _of(statement.done, known)
            for _, expr in statement.steps:
                inner += _of(expr, known)
            total += Counter({kind: count * statement.most for kind, count in inner.items()})
    return total


def _larger(sides: Iterable[Counter[str]]) -> Counter[str]:
    total: Counter[str] = Counter()
    for side in sides:
        total |= side
    return total


def _of(expr: sp.Basic, known: dict[str, Counter[str]]) -> Counter[str]:
    """Of an expression as it is written: a power is a product, a choice takes one of its sides."""
    if isinstance(expr, sp.Piecewise):
        asked = sum((_of(c, known) for _, c in expr.args), Counter())
        return asked + _larger(_of(value, known) for value, _ in expr.args)
    total: Counter[str] = sum((_of(arg, known) for arg in expr.args), Counter())
    if isinstance(expr, sp.Add):
        total["additions"] += len(expr.args) - 1
    elif isinstance(expr, sp.Mul):
        below = sum(map(_below, expr.args))
        above = sum(arg != -1 for arg in expr.args) - below
        again = max(below - 1, 0)  # divisors are multiplied first
        total["quotients"] -= again
        total["products"] += max(above - 1, 0) + again
    elif isinstance(expr, sp.Pow):
        power = sp.Rational(expr.args[1])
        total["quotients"] += bool(power < 0)
        total["roots"] += bool(abs(power) == sp.S.Half)
        total["products"] += 0 if abs(power) == sp.S.Half else int(abs(power)) - 1
    elif isinstance(expr, (sp.Max, sp.Min)):
        total["comparisons"] += len(expr.args) - 1
    elif isinstance(expr, sp.core.relational.Relational):
        total["comparisons"] += 1
    elif isinstance(expr, (sp.And, sp.Or, sp.Not, *_FREE)):
        pass
    elif (name := expr.func.__name__) in known:
        total += known[name]
    elif isinstance(expr, sp.Function):
        total["functions"] += 1
    return total


def _below(arg: Expr) -> bool:
    return bool(arg.is_Pow and arg.args[1] < 0)

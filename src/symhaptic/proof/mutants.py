"""Wrong variants of a formula: each changes one thing somewhere in its expression tree.

A checker that still accepts a mutant checks too little.  Mutants that are provably equivalent to
the original are discarded before they count.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp
from sympy import Expr
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanAtom

from symhaptic.paper.reading import Printed
from symhaptic.proof.decide import compare

_SWAPPED = {sp.sin: sp.cos, sp.cos: sp.sin, sp.Abs: lambda x: x, sp.re: sp.im}
_TURNED = {
    sp.StrictLessThan: (sp.StrictGreaterThan, sp.LessThan),
    sp.StrictGreaterThan: (sp.StrictLessThan, sp.GreaterThan),
    sp.LessThan: (sp.GreaterThan, sp.StrictLessThan),
    sp.GreaterThan: (sp.LessThan, sp.StrictGreaterThan),
}
_EXCHANGED = {
    "K": "B",
    "B": "K",
    "c_2": "c_3",
    "c_3": "c_2",
    "gamma": "delta",
    "delta": "gamma",
    "alpha": "beta",
    "beta": "alpha",
    "m": "b",
    "b": "m",
    "k": "b",
}


@dataclass(frozen=True)
class Mutant:
    """A changed form, and what was changed."""

    form: Printed
    change: str


def mutants(printed: Printed) -> Iterator[Mutant]:
    """All variants that differ from ``printed`` in one place, without duplicates.

    >>> from sympy.abc import x
    >>> [str(m.form[0]) for m in mutants((sp.sin(x) < 1,))][:3]
    ['sin(x) > 1', 'sin(x) <= 1', 'sin(x) < 2']
    """
    seen = {printed}
    for form, change in (*_changed_lines(printed), *_exchanged_lines(printed)):
        if form not in seen and not any(isinstance(p, BooleanAtom) for p in form):
            seen.add(form)
            yield Mutant(form, change)


def _changed_lines(printed: Printed) -> Iterator[tuple[Printed, str]]:
    for i, part in enumerate(printed):
        for changed, change in (*_variants(part), *_outermost(part)):
            yield (*printed[:i], changed, *printed[i + 1 :]), change


def _exchanged_lines(printed: Printed) -> Iterator[tuple[Printed, str]]:
    """Right-hand sides of two equations exchanged."""
    for i, j in itertools.combinations(range(len(printed)), 2):
        one, other = printed[i], printed[j]
        if isinstance(one, sp.Eq) and isinstance(other, sp.Eq):
            lines = list(printed)
            lines[i] = sp.Eq(one.lhs, other.rhs, evaluate=False)
            lines[j] = sp.Eq(other.lhs, one.rhs, evaluate=False)
            yield tuple(lines), f"lines {i + 1} and {j + 1} exchanged"


def _outermost(relation: Expr) -> Iterator[tuple[Expr, str]]:
    """The whole right-hand side, or one of its terms, halved, squared, inverted or shifted."""
    if not isinstance(relation, Relational):
        return
    whole = relation.rhs
    for part in dict.fromkeys([whole, *(whole.args if whole.is_Add else ())]):
        changes = [(part / 2, "halved"), (part**2, "squared"), (part + 1, "plus 1")]
        if part != 0:
            changes.append((1 / part, "inverted"))
        for changed, how in changes:
            new = whole - part + changed if part != whole else changed
            yield relation.func(relation.lhs, new, evaluate=False), f"{part} {how}"


def wrong(printed: Printed) -> Iterator[Mutant]:
    """The mutants that are not provably the same as the original."""
    return (m for m in mutants(printed) if not compare(printed, m.form).equal)


def _variants(expr: Expr) -> Iterator[tuple[Expr, str]]:
    if isinstance(expr, Relational):
        for kind in _TURNED.get(expr.func, ()):
            yield kind(expr.lhs, expr.rhs, evaluate=False), f"{expr.rel_op} turned"
        for changed, change in _variants(expr.rhs):
            yield expr.func(expr.lhs, changed, evaluate=False), change
        if not isinstance(expr, sp.Eq):  # the left side of an equation is what it is about
            for changed, change in _variants(expr.lhs):
                yield expr.func(changed, expr.rhs, evaluate=False), change
        return
    yield from _here(expr)
    for i, arg in enumerate(expr.args):
        for changed, change in _variants(arg):
            yield expr.func(*expr.args[:i], changed, *expr.args[i + 1 :]), change


def _here(expr: Expr) -> Iterator[tuple[Expr, str]]:
    """Changes at the root of an expression."""
    if expr.is_Add:
        for i, term in enumerate(expr.args):
            rest = expr.args[:i] + expr.args[i + 1 :]
            yield sp.Add(*rest, -term), f"sign of {term}"
            yield sp.Add(*rest), f"{term} dropped"
    elif expr.is_Mul:
        for i, factor in enumerate(expr.args):
            rest = expr.args[:i] + expr.args[i + 1 :]
            yield sp.Mul(*rest), f"{factor} dropped"
            if not factor.is_number:
                yield sp.Mul(*rest, 1 / factor), f"{factor} inverted"
    elif expr.is_Integer or expr.is_Rational:
        yield expr + 1, f"{expr} plus 1"
        yield -expr, f"{expr} negated"
    elif expr.is_Symbol:
        if expr.name == "d":
            yield expr + 1, "d to d+1"
        if expr.name in _EXCHANGED:
            yield sp.Symbol(_EXCHANGED[expr.name]), f"{expr} for {_EXCHANGED[expr.name]}"
        yield 2 * expr, f"{expr} doubled"
        yield -expr, f"{expr} negated"
    elif expr.is_Pow and expr.args[1].is_Integer:
        yield expr.args[0] ** (expr.args[1] + 1), f"exponent of {expr.args[0]}"
    for kind, other in _SWAPPED.items():
        if isinstance(expr, kind):
            yield other(expr.args[0]), f"{kind.__name__} swapped"

"""Wrong variants of a formula: each changes one thing somewhere in its expression tree.

A checker that still accepts a mutant checks too little.  Mutants that are provably equivalent to
the original are discarded before they count.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeAlias, TypeVar

import sympy as sp
from sympy import Expr
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanAtom

from symhaptic.paper.reading import Printed
from symhaptic.proof.decide import compare

_T = TypeVar("_T")

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
    ['sin(x) > 1', 'sin(x) <= 1', 'cos(x) < 1']
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


def misprints(latex: str) -> Iterator[tuple[str, str]]:
    """Print with one digit a unit more or less, or one sign turned, and what was changed.

    >>> [changed for changed, _ in misprints("x + 19")]
    ['x - 19', 'x + 29', 'x + 09', 'x + 18']
    """
    for i, letter in enumerate(latex):
        others = {"+": "-", "-": "+"}.get(letter, "")
        if letter.isdigit():
            others = {"0": "1", "9": "8"}.get(letter, f"{ord(letter) - 47}{ord(letter) - 49}")
        for other in others:
            yield f"{latex[:i]}{other}{latex[i + 1 :]}", f"{letter} to {other} at character {i + 1}"


def _variants(expr: Expr) -> Iterator[tuple[Expr, str]]:
    for part, put in _places(expr):
        for changed, change in _here(part):
            yield put(changed), change


_Put: TypeAlias = Callable[[Expr], Expr]


def _places(expr: Expr, put: _Put = lambda whole: whole) -> Iterator[tuple[Expr, _Put]]:
    """Every part of an expression, with what puts another one in its place."""
    yield expr, put
    kept = isinstance(expr, sp.Eq)  # the left side of an equation is what it is about
    for i, arg in enumerate(expr.args):
        if not (kept and i == 0):
            yield from _places(arg, partial(_replaced, expr, i, put))


def _replaced(whole: Expr, place: int, put: _Put, part: Expr) -> Expr:
    args = (*whole.args[:place], part, *whole.args[place + 1 :])
    if isinstance(whole, Relational):
        return put(whole.func(*args, evaluate=False))
    return put(whole.func(*args))


def few(printed: Printed, count: int) -> Iterator[Mutant]:
    """So many variants, from places all over the formula; only those are made.

    >>> from sympy.abc import x, y
    >>> [m.form[0] for m in few((x + sp.sin(2*y),), 2)]
    [-x + sin(2*y), x - sin(2*y)]
    """
    places = [
        (part, put, i)
        for i, whole in enumerate(printed)
        for part, put in _places(whole)
        if _changeable(part)
    ]
    for k, (part, put, i) in enumerate(spread(places, count)):
        variants = list(_here(part))
        changed, change = variants[k % len(variants)]
        form = (*printed[:i], put(changed), *printed[i + 1 :])
        if form != printed and not any(isinstance(p, BooleanAtom) for p in form):
            yield Mutant(form, change)


def spread(things: Sequence[_T], count: int) -> list[_T]:
    """So many of them, evenly from the first to the last.

    >>> spread(range(10), 4)
    [0, 3, 6, 9]
    """
    if len(things) <= count:
        return list(things)
    return [things[round(i * (len(things) - 1) / (count - 1))] for i in range(count)]


def _changeable(part: Expr) -> bool:
    """Whether something can be changed at the root of a part."""
    return (
        next(_here(part), None) is not None
        if part.is_Function
        else bool(
            part.is_Add
            or part.is_Mul
            or part.is_Rational
            or part.is_Symbol
            or part.func in _TURNED
            or (part.is_Pow and part.args[1].is_Integer)
        )
    )


def _here(expr: Expr) -> Iterator[tuple[Expr, str]]:
    """Changes at the root of an expression."""
    for kind in _TURNED.get(expr.func, ()):
        yield kind(expr.lhs, expr.rhs, evaluate=False), f"{expr.rel_op} turned"
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

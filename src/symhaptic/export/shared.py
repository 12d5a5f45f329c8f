"""A stable form as a routine, with its common subexpressions shared."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cache

import sympy as sp
from sympy import Basic, Expr, Piecewise, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.export.once import parts, rewritten
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, Step, choose
from symhaptic.forms.form import Form
from symhaptic.forms.implicit import ImplicitFunction


@cache
def routine(form: Form, precision: Precision = DOUBLE) -> Routine:
    """A form with its common subexpressions shared, and what its arguments have to be."""
    taken = {s.name for e in form.expressions for s in e.free_symbols}
    fresh = (Symbol(n) for n in (f"t{i}" for i in range(10**6)) if n not in taken)
    numbers = _searched_numbers(form.expressions, fresh)
    given, together = _apart(tuple(e.xreplace(numbers) for e in form.expressions))
    steps, results = sp.cse(given, symbols=fresh, order="canonical")
    done: list[Step] = [(name, call) for call, name in numbers.items()]
    inverse: dict[Expr, Expr] = {}
    for name, expr in steps:
        if isinstance(expr, Boolean):  # what is chosen by is asked where it is
            inverse[name] = expr
            continue
        if expr.is_Pow and expr.exp == -1 and (expr.base.is_Function or _is_count(expr.base)):
            # a product with what is rounded already would be rounded twice
            inverse[name], expr = 1 / name, expr.base
        done.append((name, _with_named_bases(expr.xreplace(inverse), done, fresh)))
    found = together([_with_named_bases(e.xreplace(inverse), done, fresh) for e in results])
    names = [name for name, _ in form.results]
    results = tuple(zip(names, found, strict=True))
    within = tuple(map(precision.at, form.within))
    return Routine(
        form.name, form.title, form.arguments, tuple(done), results, within, form.outside
    )


def _searched_numbers(exprs: tuple[Expr, ...], fresh: Iterator[Symbol]) -> dict[Expr, Symbol]:
    """Names of what is searched for and hangs on nothing: SymPy would look for its value."""
    calls = {p for p in parts(exprs) if isinstance(p, ImplicitFunction) and not p.free_symbols}
    return {call: next(fresh) for call in sorted(calls, key=sp.default_sort_key)}


def _is_count(expr: Expr) -> bool:
    """Whether it is a symbol and a number, added."""
    return bool(expr.is_Add) and {a.is_Symbol or a.is_Number for a in expr.args} == {True}


def _apart(exprs: tuple[Expr, ...]) -> tuple[list[Expr], Callable[[list[Expr]], list[Expr]]]:
    """Expressions without choices, and what makes choices of them again.

    So that what a choice shares with others is not computed where it does not count.
    """
    chosen = [expr for expr in exprs if isinstance(expr, Piecewise)]
    if not chosen:
        return list(exprs), lambda found: found
    first = chosen[0].args[0][1]
    count = len(exprs)
    other = [expr for expr in chosen if expr.args[0][1] != first or len(expr.args) > 2]
    if not isinstance(first, sp.Eq) or other:
        raise ValueError(f"{first}: is not the one condition of all results")

    def together(found: list[Expr]) -> list[Expr]:
        pairs = zip(found[:count], found[count:-1], strict=True)
        return [choose(sp.Eq(found[-1], first.rhs), *pair) for pair in pairs]

    def side(expr: Expr, k: int) -> Expr:
        def told(part: Basic) -> Basic:
            decided = isinstance(part, Piecewise) and part.args[0][1] == first
            return part.args[k][0] if decided else part

        return rewritten(expr, told)

    sides = [side(e, k) for k in (0, 1) for e in exprs]
    return [*sides, first.lhs], together


def _by_size(expr: Expr) -> tuple[int, object]:
    return sp.count_ops(expr), sp.default_sort_key(expr)


def _with_named_bases(expr: Expr, done: list[Step], fresh: Iterable[Symbol]) -> Expr:
    """Powers of symbols only, so that a product does not compute its factor twice."""
    for power in sorted(expr.atoms(sp.Pow), key=_by_size):
        base, exponent = power.args
        if exponent.is_Integer and abs(exponent) > 1 and not base.is_Symbol:
            name = next(iter(fresh))
            done.append((name, base))
            expr = expr.xreplace({power: name**exponent})
    return expr

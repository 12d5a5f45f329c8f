"""From stable forms to an ordered list of routines: what a target writes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy import Expr, Piecewise, Symbol

from symhaptic.export import counting, device, elementary, late_counting, passive, stiffest
from symhaptic.export.routine import Routine, Step, choose
from symhaptic.export.target import Refused, Target, calls, operations
from symhaptic.model.stable import Form


@dataclass(frozen=True)
class Library:
    """Forms with the routines that they need, each after those that it calls."""

    name: str
    title: str
    forms: tuple[Form, ...]
    helpers: tuple[Routine, ...]
    public: tuple[Routine, ...]


@cache
def known() -> dict[str, Routine]:
    """All routines by name."""
    modules = elementary, device, counting, late_counting, passive, stiffest
    made = [make() for module in modules for make in module.ROUTINES]
    return {r.name: r for r in made}


def routine(form: Form) -> Routine:
    """A form with its common subexpressions shared."""
    taken = {s.name for e in form.expressions for s in e.free_symbols}
    fresh = (Symbol(n) for n in (f"t{i}" for i in range(10**6)) if n not in taken)
    given, together = _apart(form.expressions)
    steps, results = sp.cse(given, symbols=fresh, order="none")
    done: list[Step] = []
    for name, expr in steps:
        done.append((name, _with_named_bases(expr, done, fresh)))
    found = together([_with_named_bases(expr, done, fresh) for expr in results])
    names = [name for name, _ in form.results]
    return Routine(
        form.name, form.title, form.arguments, tuple(done), tuple(zip(names, found, strict=True))
    )


def _apart(exprs: tuple[Expr, ...]) -> tuple[list[Expr], Callable[[list[Expr]], list[Expr]]]:
    """Expressions without choices, and what makes choices of them again.

    So that what a choice shares with others is not computed where it does not count.
    """
    if not all(isinstance(expr, Piecewise) for expr in exprs):
        return list(exprs), lambda found: found
    first = exprs[0].args[0][1]
    count = len(exprs)
    if not isinstance(first, sp.Eq) or any(e.args[0][1] != first or len(e.args) > 2 for e in exprs):
        raise ValueError(f"{first}: is not the one condition of all results")

    def together(found: list[Expr]) -> list[Expr]:
        pairs = zip(found[:count], found[count:-1], strict=True)
        return [choose(sp.Eq(found[-1], first.rhs), *pair) for pair in pairs]

    return [e.args[k][0] for k in (0, 1) for e in exprs] + [first.lhs], together


def _with_named_bases(expr: Expr, done: list[Step], fresh: Iterable[Symbol]) -> Expr:
    """Powers of symbols only, so that a product does not compute its factor twice."""
    for power in sorted(expr.atoms(sp.Pow), key=sp.count_ops):
        base, exponent = power.args
        if exponent.is_Integer and abs(exponent) > 1 and not base.is_Symbol:
            name = next(iter(fresh))
            done.append((name, base))
            expr = expr.xreplace({power: name**exponent})
    return expr


def library(name: str, title: str, forms: Iterable[Form], target: Target) -> Library:
    """Everything that a target writes for these forms.

    Raises :class:`Refused` for an operation that the target does not have.
    """
    forms = tuple(forms)
    public = tuple(routine(form) for form in forms)
    routines = known()
    if target.operations["ProductError"].startswith("product_error("):
        routines = routines | {"ProductError": elementary.product_error()}
    ordered: dict[str, Routine] = {}

    def add(wanted: Routine) -> None:
        needed = calls(wanted) | (operations(wanted) & set(routines))
        for other in sorted(needed):
            if other not in ordered:
                add(routines[other])
                ordered[other] = routines[other]

    for one in public:
        add(one)
    for one in (*ordered.values(), *public):
        for missing in sorted(operations(one) - set(target.operations)):
            raise Refused(f"{target.name}: has no operation {missing!r}, which {one.name} needs")
    return Library(name, title, forms, tuple(ordered.values()), public)

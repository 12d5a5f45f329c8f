"""Arguments that are 0 in every call, or idle then: those of a spring that a scene has not."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import sympy as sp
from sympy import Expr

from symhaptic.export.routine import Routine, Step, mapped


def without_zeros(
    helpers: Mapping[str, Routine], public: Iterable[Routine]
) -> tuple[dict[str, Routine], tuple[Routine, ...]]:
    """The routines with such arguments of the helpers left out, there and in all calls.

    Nothing is rounded otherwise: a sum with 0 and a product with it are exact.
    """
    helpers, public = dict(helpers), tuple(public)
    while gone := {name: at for name, at in _zeros(helpers, public).items() if at}:
        helpers = {name: _called(_left(r, gone.get(name, ())), gone) for name, r in helpers.items()}
        public = tuple(_called(routine, gone) for routine in public)
    return helpers, public


def _calls(routines: Iterable[Routine], names: Iterable[str]) -> Iterable[Expr]:
    known = set(names)
    for routine in routines:
        for expr in routine.expressions:
            yield from (c for c in expr.atoms(sp.Function) if type(c).__name__ in known)


def _zeros(helpers: Mapping[str, Routine], public: Iterable[Routine]) -> dict[str, tuple[int, ...]]:
    """The places of these arguments, and of those that nobody asks, by the names of the helpers."""
    found: dict[str, set[int]] = {}
    for call in _calls((*helpers.values(), *public), helpers):
        zero = {i for i, arg in enumerate(call.args) if arg == 0}
        name = type(call).__name__
        found[name] = found.get(name, zero) & zero
    for name in found:
        asked = set().union(*(e.free_symbols for e in helpers[name].expressions))
        found[name] |= {i for i, s in enumerate(helpers[name].arguments) if s not in asked}
    return {name: tuple(sorted(at)) for name, at in found.items()}


def _left(routine: Routine, gone: tuple[int, ...]) -> Routine:
    """A helper with 0 for some of its arguments."""
    if not gone:
        return routine
    zero = {routine.arguments[i]: sp.S.Zero for i in gone}
    known: dict[Expr, Expr] = dict(zero)
    steps: list[Step] = []
    for step in routine.steps:
        if not isinstance(step, tuple):
            steps.append(mapped(step, lambda expr: expr.xreplace(known)))
        elif (value := step[1].xreplace(known)) == 0:
            known[step[0]] = value
        else:
            steps.append((step[0], value))
    results = tuple((name, expr.xreplace(known)) for name, expr in routine.results)
    arguments = tuple(s for s in routine.arguments if s not in zero)
    return replace(routine, arguments=arguments, steps=tuple(steps), results=results)


def _called(routine: Routine, gone: Mapping[str, tuple[int, ...]]) -> Routine:
    """A routine that calls helpers without these arguments."""

    def without(expr: Expr) -> Expr:
        return expr.replace(
            lambda part: isinstance(part, sp.Function) and type(part).__name__ in gone,
            lambda part: sp.Function(type(part).__name__)(
                *(a for i, a in enumerate(part.args) if i not in gone[type(part).__name__])
            ),
        )

    if not any(True for _ in _calls((routine,), gone)):
        return routine
    steps = tuple(mapped(step, without) for step in routine.steps)
    results = tuple((name, without(expr)) for name, expr in routine.results)
    return replace(routine, steps=steps, results=results)

"""Numbers of the plant alone, which are found once for many walls, angles or delays."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.export.code_names import code_name
from symhaptic.export.printing import OPERATIONS
from symhaptic.export.routine import Routine, Step, computed, fresh, names
from symhaptic.notation import delta, gamma

_PLANT = {gamma, delta}


def hoisted(routine: Routine) -> tuple[Routine | None, Routine]:
    """The numbers of the plant as a routine of its own, where there is more to do, and the rest."""
    given = tuple(s for s in routine.arguments if s in _PLANT)
    if given == routine.arguments:
        return None, routine
    plant: list[Step] = []
    rest: list[Step] = []
    known = set(given)
    calls: dict[Expr, Symbol] = {}
    taken = {s.name for step in routine.steps for s in names(step)}

    def of_plant(expr: Expr) -> bool:
        return _is_call(expr) and expr.free_symbols <= known

    def named(call: Expr) -> Symbol:
        if call not in calls:
            calls[call] = fresh(code_name(call.func.__name__), taken)
            plant.append((calls[call], call))
            known.add(calls[call])
        return calls[call]

    for step in routine.steps:
        if all(expr.free_symbols <= known for expr in computed(step)):
            plant.append(step)
            known |= set(names(step))
        elif isinstance(step, tuple):
            rest.append((step[0], step[1].replace(of_plant, named)))
        else:
            rest.append(step)
    results = tuple((name, expr.replace(of_plant, named)) for name, expr in routine.results)
    if not any(_is_call(part) for step in plant for expr in computed(step)
               for part in sp.preorder_traversal(expr)):  # fmt: skip
        return None, routine
    after = replace(routine, steps=tuple(rest), results=results)
    used = set().union(*(e.free_symbols for e in after.expressions))
    found = tuple(s for step in plant for s in names(step) if s in used)
    before = replace(
        routine, arguments=given, steps=tuple(plant), results=tuple((s.name, s) for s in found)
    )
    own = tuple(s for s in routine.arguments if s in used or s not in _PLANT)
    return before, replace(after, arguments=own + found)


def _is_call(expr: Expr) -> bool:
    name = type(expr).__name__
    return isinstance(expr, sp.Function) and name not in OPERATIONS and name != "Piecewise"

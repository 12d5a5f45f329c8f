"""What of a routine is done once: steps shared with others, and numbers of the plant alone."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.export.routine import Routine
from symhaptic.export.target import OPERATIONS, code_name
from symhaptic.notation import delta, gamma

_PLANT = {gamma, delta}


@dataclass
class Begun:
    """The first steps of several routines as a routine of their own."""

    routine: Routine
    first: str
    """The first routine that begins so."""
    used: dict[str, tuple[Symbol, ...]] = field(default_factory=dict)
    """For each routine, what it uses of them."""

    @property
    def kept(self) -> tuple[Symbol, ...]:
        """What the shared routine gives."""
        return tuple(Symbol(name) for name, _ in self.routine.results)

    def rest(self, routine: Routine) -> Routine:
        """The routine that is given these steps."""
        assert routine.shared is not None
        own = routine.assignments[routine.shared.count :]
        return replace(routine, arguments=routine.arguments + self.used[routine.name], steps=own)


def begun(routines: Iterable[Routine]) -> dict[str, Begun]:
    """For each routine with shared steps, the routine that does them."""
    found: dict[str, Begun] = {}
    starts: dict[str, Begun] = {}
    for routine in routines:
        if routine.shared is None:
            continue
        shared = routine.assignments[: routine.shared.count]
        rest = [e for _, e in routine.assignments[routine.shared.count :]]
        rest += [e for _, e in routine.results]
        free = set().union(*(e.free_symbols for e in rest))
        used = tuple(name for name, _ in shared if name in free)
        name = routine.shared.name
        if name not in starts:
            made = Routine(name, routine.shared.about, routine.arguments, shared, ())
            starts[name] = Begun(made, routine.name)
        start = starts[name]
        if start.routine.steps != shared:
            raise ValueError(f"{routine.name}: begins otherwise than {start.first}")
        start.used[routine.name] = used
        kept = {*start.kept, *used}
        results = tuple((s.name, s) for s, _ in shared if s in kept)
        start.routine = replace(start.routine, results=results)
        found[routine.name] = start
    return found


def staged(routine: Routine) -> tuple[Routine | None, Routine]:
    """The numbers of the plant as a routine of its own, where there is more to do, and the rest.

    Many walls, angles or delays often have one plant.
    """
    if set(routine.arguments) <= _PLANT:
        return None, routine
    taken = {s.name for s, _ in routine.assignments}
    plant: dict[Symbol, Expr] = {}
    names: dict[Expr, Symbol] = {}

    def named(call: Expr) -> Symbol:
        if call not in names:
            base = fresh = code_name(call.func.__name__)
            while fresh in taken:
                fresh = f"{base}{len(names)}"
            taken.add(fresh)
            names[call] = Symbol(fresh)
            plant[names[call]] = call
        return names[call]

    steps = []
    for name, expr in routine.assignments:
        if _calls(expr) and expr.free_symbols <= _PLANT:
            plant[name] = expr
        else:
            steps.append((name, expr.replace(_of_plant, named)))
    results = tuple((name, expr.replace(_of_plant, named)) for name, expr in routine.results)
    if not plant:
        return None, routine
    arguments = tuple(s for s in routine.arguments if s in _PLANT)
    before = replace(
        routine, arguments=arguments, steps=(), results=tuple((s.name, e) for s, e in plant.items())
    )
    after = replace(routine, steps=tuple(steps), results=results)
    used = set().union(*(e.free_symbols for e in after.expressions))
    own = tuple(s for s in routine.arguments if s in used or s not in _PLANT)
    return before, replace(after, arguments=own + tuple(plant))


def _of_plant(expr: Expr) -> bool:
    return _is_call(expr) and expr.free_symbols <= _PLANT


def _is_call(expr: Expr) -> bool:
    name = type(expr).__name__
    return isinstance(expr, sp.Function) and name not in OPERATIONS and name != "Piecewise"


def _calls(expr: Expr) -> bool:
    return any(_is_call(part) for part in sp.preorder_traversal(expr))

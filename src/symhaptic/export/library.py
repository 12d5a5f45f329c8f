"""From stable forms to an ordered list of routines: what a target writes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp
from sympy import Expr, Piecewise, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.export import (
    angle_slopes,
    counting,
    device,
    device_series,
    elementary,
    late_counting,
    pairs,
    passive,
    response,
    slopes,
    stiffest,
)
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, Several, Step, choose, expm1, fresh
from symhaptic.export.target import Refused, Target, calls, code_name, operations, routine_name
from symhaptic.model.entire import CosNext, Entire, SinNext
from symhaptic.model.entire_device import Apart, Fall, Nyquist, Rise, Swing, Together
from symhaptic.model.response import Ahead, Careful, InPhase, KickLow
from symhaptic.model.slopes import ApartDrop, Coast, Ebb, Echo, FallDrop, Kick, RiseDrop
from symhaptic.model.stable import Form


@dataclass(frozen=True)
class Library:
    """Forms with the routines that they need, each after those that it calls."""

    name: str
    title: str
    forms: tuple[Form, ...]
    helpers: tuple[Routine, ...]
    public: tuple[Routine, ...]

    def needed(self, routine: Routine) -> Iterator[Routine]:
        """The helpers that a routine calls, or one of these does, in their order."""
        wanted = _called(routine)
        for helper in reversed(self.helpers):
            if helper.name in wanted:
                wanted |= _called(helper)
        return (helper for helper in self.helpers if helper.name in wanted)


class Known(Mapping[str, Routine]):
    """All routines by name, each made when it is first asked for."""

    def __init__(self, precision: Precision) -> None:
        self.precision = precision
        self.made: dict[str, Routine] = {}

    def __getitem__(self, name: str) -> Routine:
        """The routine of that name: its maker has the name that it has in source code."""
        if name not in self.made:
            try:
                make, precise = _makers()[code_name(name)]
            except KeyError:
                raise KeyError(name) from None
            self.made[name] = make(self.precision) if precise else make()
        return self.made[name]

    def __iter__(self) -> Iterator[str]:
        """Their names, in the order of their files."""
        return map(routine_name, _makers())

    def __len__(self) -> int:
        """How many there are."""
        return len(_makers())


@cache
def known(precision: Precision = DOUBLE) -> Mapping[str, Routine]:
    """All routines by name."""
    return Known(precision)


@cache
def _makers() -> dict[str, tuple[Callable[..., Routine], bool]]:
    """What makes each routine, and whether that depends on the precision."""
    made = {f.__name__: (f, False) for module in _MODULES for f in module.ROUTINES}
    return made | {f.__name__: (f, True) for module in _MODULES for f in module.PRECISE}


_MODULES = (
    elementary, pairs, device, device_series, slopes, angle_slopes, counting, late_counting,
    passive, response, stiffest,
)  # fmt: skip


def routine(form: Form) -> Routine:
    """A form with its common subexpressions shared."""
    taken = {s.name for e in form.expressions for s in e.free_symbols}
    fresh = (Symbol(n) for n in (f"t{i}" for i in range(10**6)) if n not in taken)
    given, together = _apart(form.expressions)
    steps, results = sp.cse(given, symbols=fresh, order="canonical")
    done: list[Step] = []
    inverse: dict[Expr, Expr] = {}
    for name, expr in steps:
        if expr.is_Pow and expr.exp == -1 and expr.base.is_Function:
            # a product with what is rounded already would be rounded twice
            inverse[name], expr = 1 / name, expr.base
        done.append((name, _with_named_bases(expr.xreplace(inverse), done, fresh)))
    found = together([_with_named_bases(e.xreplace(inverse), done, fresh) for e in results])
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


def merged(user: Routine) -> Routine:
    """The routine with one call for all that several of MERGED find from the same arguments."""
    taken = {s.name for s in (*user.arguments, *(s for s, _ in user.assignments))}
    calls: dict[Expr, Symbol] = {}
    steps: list[tuple[Symbol, Expr]] = []

    def named(expr: Expr) -> Expr:
        """Every such call is a step of its own, those inside it first."""
        while inner := [
            c for c in expr.atoms(*MERGED) if not any(a.atoms(*MERGED) for a in c.args)
        ]:
            for call in sorted(inner, key=sp.default_sort_key):
                if call not in calls:
                    calls[call] = fresh(f"{code_name(type(call).__name__)}_of", taken)
                    steps.append((calls[call], call))
            expr = expr.xreplace(calls)
        return expr

    same: dict[Symbol, Expr] = {}
    for symbol, expr in user.assignments:
        value = named(expr.xreplace(same))
        if value.is_Symbol:
            same[symbol] = value
        else:
            steps.append((symbol, value))
    results = tuple((name, named(expr.xreplace(same))) for name, expr in user.results)
    found: dict[tuple[Expr, ...], dict[str, Symbol]] = {}
    for call, symbol in calls.items():
        found.setdefault(call.args, {})[type(call).__name__] = symbol
    done: list[Step] = []
    for symbol, expr in steps:
        together = found.get(expr.args, {}) if isinstance(expr, MERGED) else {}
        if len(together) < 2:
            done.append((symbol, expr))
        elif symbol == next(iter(together.values())):
            several = sorted(together)
            joint = sp.Function("_".join(several))(*expr.args)
            done.append(Several(tuple(together[name] for name in several), joint))
    return replace(user, steps=tuple(done), results=results)


def named(name: str, routines: Mapping[str, Routine]) -> Routine:
    """The routine of that name, or the joint one of several names."""
    parts = name.split("_")
    return joint(parts, routines) if len(parts) > 1 else routines[name]


def precise(name: str) -> bool:
    """Whether the routine, or one of those that it joins, depends on the precision."""
    return any(_makers()[code_name(part)][1] for part in name.split("_"))


def joint(parts: Sequence[str], routines: Mapping[str, Routine]) -> Routine:
    """Routines of the same arguments as one; a step that two of them have is done once."""
    arguments = routines[parts[0]].arguments
    taken = {s.name for s in arguments}
    done: dict[Expr, Symbol] = {}
    found: dict[str, Symbol] = {}

    def step(name: str, expr: Expr) -> Symbol:
        if expr.is_Symbol:
            return expr
        if expr not in done:
            done[expr] = fresh(name, taken)
        return done[expr]

    def named(expr: Expr) -> Expr:
        """Every call is a step of its own."""
        while inner := [c for c in expr.atoms(*_CALLS) if c != expr and not _calls(c)]:
            call = min(inner, key=sp.default_sort_key)
            expr = expr.xreplace({call: value(call)})
        return value(expr) if isinstance(expr, MERGED) else expr

    def value(call: Expr) -> Symbol:
        own = type(call).__name__
        if isinstance(call, MERGED) and call.args == arguments:
            return result(own)
        return step(f"{code_name(own)}_of", call)

    def result(own: str) -> Symbol:
        if own not in found:
            names: dict[Symbol, Expr] = {}
            for symbol, expr in routines[own].assignments:
                names[symbol] = step(symbol.name, named(expr.xreplace(names)))
            last = routines[own].results[0][1].xreplace(names)
            found[own] = step(f"{code_name(own)}_of", named(last))
        return found[own]

    results = tuple((code_name(part), result(part)) for part in parts)
    about = "; ".join(routines[part].about for part in parts)
    return Routine(
        "_".join(parts), about, arguments, tuple((s, e) for e, s in done.items()), results
    )


def _calls(call: Expr) -> bool:
    return any(arg.atoms(*_CALLS) for arg in call.args)


MERGED = (
    Apart, Fall, Nyquist, Rise, Swing, Together,
    Kick, KickLow, Coast, Echo, Ebb, RiseDrop, FallDrop, ApartDrop,
    CosNext, SinNext, Ahead, InPhase,
)  # fmt: skip
"""Functions that have steps in common with others of the same arguments."""

_CALLS = (Entire, Careful, AppliedUndef, sp.exp, expm1, sp.sin, sp.cos, sp.tan)


def _called(routine: Routine) -> set[str]:
    """The routines that it calls, and operations that may have to be written out."""
    return calls(routine) | operations(routine)


def library(
    name: str, title: str, forms: Iterable[Form], target: Target, merges: bool = True
) -> Library:
    """Everything that a target writes for these forms, each routine alone if none are merged.

    Raises :class:`Refused` for an operation that the target does not have.
    """
    forms = tuple(forms)
    public = tuple(routine(form) for form in forms)
    routines = known(target.precision)
    if merges:
        public = tuple(map(merged, public))
    own = {}
    if target.operations["ProductError"].startswith("product_error("):
        own["ProductError"] = elementary.product_error(target.precision)
    ordered: dict[str, Routine] = {}

    def add(wanted: Routine) -> None:
        for other in sorted(calls(wanted) | (operations(wanted) & set(own))):
            if other not in ordered:
                found = own.get(other) or named(other, routines)
                add(found)
                ordered[other] = found

    for one in public:
        add(one)
    for one in (*ordered.values(), *public):
        for missing in sorted(operations(one) - set(target.operations)):
            raise Refused(f"{target.name}: has no operation {missing!r}, which {one.name} needs")
    return Library(name, title, forms, tuple(ordered.values()), public)

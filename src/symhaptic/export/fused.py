"""Routines that begin alike, as one: what they find from the same arguments is found together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.export.code_names import brief, code_name
from symhaptic.export.routine import Routine, Several, Step, choose, computed, expm1, fresh, names
from symhaptic.forms.entire import CosNext, Entire, SinNext
from symhaptic.forms.entire_device import (
    DenominatorAtMinusOne,
    NumeratorAtOne,
    NumeratorGap,
    PlantN0,
    PlantN1,
    PlantTrace,
)
from symhaptic.forms.implicit import FractionalPart, SomePart, WholePart
from symhaptic.forms.response import Ahead, Compensated, InPhase, KickLow
from symhaptic.forms.slopes import (
    Coast,
    Ebb,
    Echo,
    Kick,
    NumeratorGapDrop,
    PlantN0Drop,
    PlantN1Drop,
)
from symhaptic.notation import delta, gamma


class LateFirst(sp.Function):  # type: ignore[misc]
    """m2 of a device behind a fraction of a period."""

    nargs = 3


class LateKick(sp.Function):  # type: ignore[misc]
    """What an impulse moves it in the rest of the period."""

    nargs = 3


class LateLast(sp.Function):  # type: ignore[misc]
    """m0 of it."""

    nargs = 3


class LateApart(sp.Function):  # type: ignore[misc]
    """m2 - m1 + m0 of it."""

    nargs = 3


MERGED = (
    NumeratorGap, PlantN0, DenominatorAtMinusOne, PlantN1, PlantTrace, NumeratorAtOne,
    Kick, KickLow, Coast, Echo, Ebb, PlantN1Drop, PlantN0Drop, NumeratorGapDrop,
    CosNext, SinNext, Ahead, InPhase, LateFirst, LateKick, LateLast, LateApart,
)  # fmt: skip
"""Functions that have steps in common with others of the same arguments."""

_PLANT = {gamma, delta}
"""What a device is made of, which is asked for first."""

_TOGETHER: dict[tuple[str, ...], str] = {
    ("CosNext", "SinNext"): "NextWave",
    ("LateApart", "LateFirst", "LateKick", "LateLast"): "LateDevice",
}
"""Routines that find several results of their own; not all of them are asked for everywhere."""

_CALLS = (Entire, Compensated, AppliedUndef, sp.exp, expm1, sp.sin, sp.cos, sp.tan)


def _with_parts(user: Routine) -> Routine:
    """The routine with whole periods and fraction of the delay as steps of its own.

    Beside a whole delay the fraction is 1/2 where another branch counts.
    """
    kinds = WholePart, FractionalPart, SomePart
    asked = set().union(*(e.atoms(*kinds) for e in user.expressions))
    if not asked:
        return user
    taken = {s.name for s in (*user.arguments, *(s for s, _ in user.assignments))}
    ((delay,),) = {call.args for call in asked}
    whole, part = fresh("whole", taken), fresh("part", taken)
    known = {WholePart(delay): whole, FractionalPart(delay): part}
    known[SomePart(delay)] = choose(sp.Eq(part, 0), sp.S.Half, part)
    steps = [(whole, sp.floor(delay)), (part, delay - whole)]
    steps += [(name, expr.xreplace(known)) for name, expr in user.assignments]
    results = tuple((name, expr.xreplace(known)) for name, expr in user.results)
    return replace(user, steps=tuple(steps), results=results)


def merged(user: Routine) -> Routine:
    """The routine with one call for all that several of MERGED find from the same arguments."""
    user = _with_parts(user)
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
            own = next((own for own in _TOGETHER if together.keys() <= set(own)), None)
            several = own or tuple(sorted(together))
            joint = sp.Function(_TOGETHER[own] if own else "_".join(several))(*expr.args)
            made = (together.get(n) or fresh(f"{code_name(n)}_of", taken) for n in several)
            done.append(Several(tuple(made), joint))
    done.sort(key=lambda step: not isinstance(step, Several) or not step.free_symbols <= _PLANT)
    return replace(user, steps=tuple(done), results=results)


def fused(parts: Sequence[str], routines: Mapping[str, Routine]) -> Routine:
    """Routines of the same arguments as one; a step that two of them have is done once."""
    arguments = routines[parts[0]].arguments
    taken = {s.name for s in arguments}
    done: dict[Expr, Symbol] = {}
    calls: dict[Expr, Several] = {}
    order: list[Step] = []
    found: dict[str, Symbol] = {}

    def step(name: str, expr: Expr) -> Symbol:
        if expr.is_Symbol:
            return expr
        if expr not in done:
            done[expr] = fresh(name, taken)
            order.append((done[expr], expr))
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

    def several(made: Several, known: dict[Symbol, Expr]) -> None:
        call = made.call.func(*(named(arg.xreplace(known)) for arg in made.call.args))
        if call not in calls:
            calls[call] = Several(tuple(fresh(s.name, taken) for s in made.names), call)
            order.append(calls[call])
        known |= dict(zip(made.names, calls[call].names, strict=True))

    def result(own: str) -> Symbol:
        if own not in found:
            known: dict[Symbol, Expr] = {}
            for made in routines[own].steps:
                if isinstance(made, Several):
                    several(made, known)
                elif isinstance(made, tuple):
                    known[made[0]] = step(made[0].name, named(made[1].xreplace(known)))
            last = _of_many(routines[own].results[0][1]).xreplace(known)
            found[own] = step(f"{code_name(own)}_of", named(last))
        return found[own]

    results = tuple((brief(code_name(part)), result(part)) for part in parts)
    used = Counter(s for made in order for e in computed(made) for s in e.free_symbols)
    last = {s: e for e, s in done.items() if isinstance(e, sp.Piecewise) and not used[s]}
    results = tuple((name, last.get(s, s)) for name, s in results)
    asked = used.keys() | {s for _, value in results for s in value.free_symbols}
    order = [_rounded(made, asked) for made in order if last.keys().isdisjoint(names(made))]
    about = _together([routines[part].about for part in parts])
    if set(arguments) == _PLANT:
        *some, last_ = (name for name, _ in results)
        about = f"{', '.join(some)} and {last_} of the device"
    record = "Response" if "Ahead" in parts else ""
    return Routine("_".join(parts), about, arguments, tuple(order), results, record=record)


def _rounded(step: Step, asked: Collection[Symbol]) -> Step:
    """The float of a sum alone, where nobody asks what it misses."""
    if isinstance(step, Several) and step.call.func.__name__ == "FastTwoSum":
        total, low = step.names
        if low not in asked:
            return total, sp.Function("Rounded")(*step.call.args)
    return step


def _of_many(result: Expr) -> Expr:
    """What is left of a choice between a series and a function that asks for it itself.

    Several functions find more than their series in any case.
    """
    if not isinstance(result, sp.Piecewise):
        return result
    (_, condition), (other, _), *_ = result.args
    series = isinstance(condition, sp.StrictLessThan) and condition.lhs == sp.Symbol("reach")
    return other if series else result


def _calls(call: Expr) -> bool:
    return any(arg.atoms(*_CALLS) for arg in call.args)


def _together(told: list[str]) -> str:
    """What several routines are, with the words at the end that all share said once.

    >>> _together(["the sine of x", "the cosine of x"])
    'the sine and the cosine of x'
    """
    words = [text.split() for text in told]
    least, shared = min(map(len, words)), 0
    while shared < least - 1 and len({one[-shared - 1] for one in words}) == 1:
        shared += 1
    heads = [" ".join(one[: len(one) - shared]) for one in words]
    return " ".join([" and ".join(heads), *words[0][len(words[0]) - shared :]])

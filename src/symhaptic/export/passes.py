"""From a stable form to a routine, and what is done with routines before they are written."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache

import sympy as sp
from sympy import Basic, Expr, Piecewise, Symbol
from sympy.codegen.cfunctions import expm1
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import (
    OPERATIONS,
    Routine,
    Several,
    Step,
    brief,
    choose,
    code_name,
    computed,
    fresh,
    mapped,
    names,
    parts,
    propagated,
    replaced,
    rewritten,
    with_named_bases,
)
from symhaptic.forms import fractional_delay
from symhaptic.forms.entire import DEVICE, CosNext, Entire, Kick, PlantN0, PlantN1, SinNext
from symhaptic.forms.form import Form
from symhaptic.forms.implicit import FractionalPart, ImplicitFunction, SomePart, WholePart
from symhaptic.forms.response import Ahead, Compensated, HalfTurned, InPhase, KickLow
from symhaptic.forms.root_count import Stable, WholeRoots
from symhaptic.model.parts import FULL
from symhaptic.notation import delta, epsilon, gamma


@cache
def of_form(form: Form, precision: Precision = DOUBLE) -> Routine:
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
        done.append((name, with_named_bases(expr.xreplace(inverse), done, fresh)))
    found = together([with_named_bases(e.xreplace(inverse), done, fresh) for e in results])
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


# -- Routines that begin alike, as one: what they find from the same arguments is found together -


class LateFirst(sp.Function):  # type: ignore[misc]
    """m2 of a device behind a fraction of a period."""


class LateKick(sp.Function):  # type: ignore[misc]
    """What an impulse moves it in the rest of the period."""


class LateLast(sp.Function):  # type: ignore[misc]
    """m0 of it."""


class LateApart(sp.Function):  # type: ignore[misc]
    """m2 - m1 + m0 of it."""


MERGED = (
    *DEVICE, KickLow, CosNext, SinNext, Ahead, InPhase, LateFirst, LateKick, LateLast, LateApart,
)  # fmt: skip
"""Functions that have steps in common with others of the same arguments."""

_PLANT = {gamma, delta}
"""What a device is made of, which is asked for first."""

_TOGETHER: dict[tuple[str, ...], str] = {
    ("CosNext", "SinNext"): "NextWave",
    ("LateApart", "LateFirst", "LateKick", "LateLast"): "LateDevice",
}
"""Routines that find several results of their own; not all of them are asked for everywhere."""

_RESPONSE = "part of A/(z M), M over A being the device, at z = exp(2 j psi)"

_CALLS = (Entire, Compensated, AppliedUndef, sp.exp, expm1, sp.sin, sp.cos, sp.tan)


def _with_parts(user: Routine) -> Routine:
    """The routine with whole periods and fraction of the delay as steps of its own.

    Beside a integer delay the fraction is 1/2 where another branch counts.
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
    found: Routine = replaced(user, known)
    first = (whole, sp.floor(delay)), (part, delay - whole)
    return replace(found, steps=(*first, *found.steps))


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
    about, record = " and ".join(routines[part].about for part in parts), ""
    if set(arguments) == _PLANT:
        *some, last_ = (name for name, _ in results)
        about = f"{', '.join(some)} and {last_} of the device"
    elif tuple(parts) == ("Ahead", "InPhase"):
        about, record = f"the imaginary and the real {_RESPONSE}", "Response"
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


# -- Arguments that are 0 in every call, or idle then: those of a spring that a scene has not ----


def without_zeros(
    helpers: Mapping[str, Routine], public: Iterable[Routine]
) -> tuple[dict[str, Routine], tuple[Routine, ...]]:
    """The routines with such arguments of the helpers left out, there and in all calls.

    Nothing is rounded otherwise: a sum with 0 and a product with it are exact.
    """
    helpers, public = dict(helpers), tuple(public)
    while gone := {name: at for name, at in _zeros(helpers, public).items() if at}:
        helpers = {
            name: _without(_with_zeros(r, gone.get(name, ())), gone) for name, r in helpers.items()
        }
        public = tuple(_without(routine, gone) for routine in public)
    return helpers, public


def _calls_of(routines: Iterable[Routine], names: Iterable[str]) -> Iterable[Expr]:
    known = set(names)
    for routine in routines:
        for expr in routine.expressions:
            yield from (c for c in expr.atoms(sp.Function) if type(c).__name__ in known)


def _zeros(helpers: Mapping[str, Routine], public: Iterable[Routine]) -> dict[str, tuple[int, ...]]:
    """The places of such arguments, and of unused ones, by the names of the helpers."""
    found: dict[str, set[int]] = {}
    for call in _calls_of((*helpers.values(), *public), helpers):
        zero = {i for i, arg in enumerate(call.args) if arg == 0}
        name = type(call).__name__
        found[name] = found.get(name, zero) & zero
    for name in found:
        asked = set().union(*(e.free_symbols for e in helpers[name].expressions))
        found[name] |= {i for i, s in enumerate(helpers[name].arguments) if s not in asked}
    return {name: tuple(sorted(at)) for name, at in found.items()}


def _with_zeros(routine: Routine, gone: tuple[int, ...]) -> Routine:
    """A helper with 0 for some of its arguments."""
    zero = {routine.arguments[i]: sp.S.Zero for i in gone}
    found = propagated(routine, zero, lambda value: value == 0) if gone else routine
    return replace(found, arguments=tuple(s for s in routine.arguments if s not in zero))


def _without(routine: Routine, gone: Mapping[str, tuple[int, ...]]) -> Routine:
    """A routine that calls helpers without these arguments."""

    def without(expr: Expr) -> Expr:
        return expr.replace(
            lambda part: isinstance(part, sp.Function) and type(part).__name__ in gone,
            lambda part: sp.Function(type(part).__name__)(
                *(a for i, a in enumerate(part.args) if i not in gone[type(part).__name__])
            ),
        )

    if not any(True for _ in _calls_of((routine,), gone)):
        return routine
    found: Routine = mapped(routine, without)
    return found


# -- Numbers of the plant alone, which are found once for many walls, angles or delays -----------


def hoisted(
    routine: Routine, of: Collection[Symbol] = (gamma, delta)
) -> tuple[Routine | None, Routine]:
    """The numbers of the plant as a routine of its own, where there is more to do, and the rest."""
    given = tuple(s for s in routine.arguments if s in of)
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
    own = tuple(s for s in routine.arguments if s in used or s not in of)
    return before, replace(after, arguments=own + found)


def _is_call(expr: Expr) -> bool:
    name = type(expr).__name__
    return isinstance(expr, sp.Function) and name not in OPERATIONS and name != "Piecewise"


# -- A device behind a fraction of a period, with one call for all of its numbers ----------------


def late_numbers(part: Expr) -> tuple[Expr, ...]:
    """m2 - m1 + m0, m2, what an impulse moves in the rest of the period, and m0."""
    rest, begun = (fractional_delay.brief(FULL, time) for time in (1 - epsilon, epsilon))
    first, last = fractional_delay.ends(FULL)
    found = fractional_delay.at_minus_one(FULL, rest, begun), first, rest.kick, last
    return tuple(number.xreplace({epsilon: part}) for number in found)


def with_late_device(form: Form) -> Form:
    """The form with one call for these numbers, where it asks the parts of a period for no more."""
    gaps = {p for p in parts(form.expressions) if isinstance(p, HalfTurned)}
    fractions = {gap.args[-1] for gap in gaps}
    if len(fractions) != 1:
        return form
    (part,) = fractions
    apart, first, kick, last = late_numbers(part)
    if apart not in gaps:
        return form
    ends = {
        frozenset(first.args): LateFirst(gamma, delta, part),
        frozenset(kick.args): LateKick(gamma, delta, part),
        frozenset(last.args): LateLast(gamma, delta, part),
    }

    def told(product: Basic) -> Basic:
        if not product.is_Mul:
            return product
        for factors, number in ends.items():
            if factors <= set(product.args):
                return sp.Mul(*set(product.args) - factors, number)
        return product

    called = {apart: LateApart(gamma, delta, part)}
    found = [rewritten(e.xreplace(called), told) for e in form.expressions]
    left = (call for call in parts(found) if isinstance(call, Kick | PlantN0 | PlantN1))
    if any(call.args != (gamma, delta) for call in left):
        return form
    names = (name for name, _ in form.results)
    return replace(form, results=tuple(zip(names, found, strict=True)))


# -- A loop without a spring behind a integer delay, with one call for the verdict -----------------


def with_free_verdict(form: Form) -> Form:
    """The form with one call for the verdict on such a loop."""

    def told(verdict: Basic) -> Basic:
        if not isinstance(verdict, Stable):
            return verdict
        roots, *_, spring, _ = verdict.args
        if spring != 0 or not isinstance(roots, WholeRoots):
            return verdict
        given = (s for i, s in enumerate(roots.args) if i != 5)  # there is no spring
        return sp.Function("FreeStable")(*given)

    return replace(
        form,
        results=tuple((name, rewritten(expr, told)) for name, expr in form.results),
    )

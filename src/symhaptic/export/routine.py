"""A small function of real numbers as steps that are done in order, whatever the language.

What is rounded, and in which order, is part of a routine: each sum whose order matters is a step
of its own.  Every branch of a choice is defined for all arguments, so that a target may evaluate
all of them or only the one that counts.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import cache
from typing import Any

import sympy as sp
from sympy import Basic, Expr, Function, Piecewise, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.forms.stable import Form


class TwoProdError(Function):  # type: ignore[misc]
    """a b minus the float nearest to it; 0 in exact arithmetic, and if one is 0 or 1."""

    nargs = 2

    @classmethod
    def eval(cls, one: Expr, two: Expr) -> Expr | None:
        """Nothing is missed by a product with 0 or 1."""
        return sp.S.Zero if {abs(one), abs(two)} & {sp.S.Zero, sp.S.One} else None


class Divisor(Function):  # type: ignore[misc]
    """The number itself, which is 0 only where another branch counts."""

    nargs = 1

    @classmethod
    def eval(cls, value: Expr) -> Expr | None:
        """1 stands for 0."""
        return (value or sp.S.One) if value.is_number else None

    @property
    def anywhere(self) -> Expr:
        """1 in place of 0, for who computes all branches."""
        (value,) = self.args
        return choose(sp.Eq(value, 0), sp.S.One, value)


@dataclass(frozen=True)
class Repeat:
    """``start`` put into ``states``, then ``steps`` and ``next`` until ``done``, or so many times.

    Whether it is done is asked of the states, before each time.  Elements of an array that are
    done keep their states while others go on.
    """

    states: tuple[Symbol, ...]
    start: tuple[Expr, ...]
    steps: tuple[tuple[Symbol, Expr], ...]
    """Done in this order, each time."""
    next: tuple[Symbol, ...]
    """Of these steps, or of the states before, the ones that become the states."""
    most: int
    done: Boolean
    number: Symbol | None = None
    """Of the sum of a series: 1/n! for each n of ``factorials``."""
    factorials: range = range(0)
    brief: Boolean = sp.false
    """Where the sum may begin with ``few``, since the terms before are too small to count."""
    few: int = 0

    @property
    def numbers(self) -> tuple[Expr, ...]:
        """What ``number`` is, one each time, until there is none."""
        return tuple(1 / sp.factorial(n) for n in self.factorials)

    @property
    def turned(self) -> tuple[tuple[Symbol, Symbol], ...]:
        """Each state that changes with what it becomes, none before it has been read."""
        pairs = zip(self.states[::-1], self.next[::-1], strict=True)
        return tuple((state, after) for state, after in pairs if state != after)

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All of its right-hand sides, and its condition."""
        return (*self.start, *(e for _, e in self.steps), self.done, self.brief)

    @property
    def free_symbols(self) -> set[Symbol]:
        """What has to be known before."""
        own = {*self.states, *(name for name, _ in self.steps), self.number}
        inner = {s for e in self.expressions[len(self.start) :] for s in e.free_symbols} - own
        return inner | {s for e in self.start for s in e.free_symbols}


@dataclass(frozen=True)
class Several:
    """``names = call`` of a routine that has so many results."""

    names: tuple[Symbol, ...]
    call: Expr

    @property
    def free_symbols(self) -> set[Symbol]:
        """What has to be known before."""
        return set(self.call.free_symbols)


@dataclass(frozen=True)
class Search:
    """``name`` is where ``value`` of ``at`` changes from positive to negative, between two ends.

    An end stands for it where it does not change.  A target that has no way of its own to search
    does ``steps``, after which ``found`` is the same.
    """

    name: Symbol
    at: Symbol
    value: Expr
    low: Expr
    high: Expr
    close: Expr
    """How near it has to be, relatively."""
    steps: tuple[Step, ...]
    found: Expr

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """What it computes in either way."""
        inner = tuple(e for step in self.steps for e in computed(step))
        return (self.low, self.high, self.value, *inner, self.found)

    @property
    def free_symbols(self) -> set[Symbol]:
        """What has to be known before."""
        inner = self.value.free_symbols - {self.at}
        return set(inner | self.low.free_symbols | self.high.free_symbols)


Step = tuple[Symbol, Expr] | Repeat | Several | Search
"""``name = expr``, or what makes more than one name known."""


def names(step: Step) -> tuple[Symbol, ...]:
    """What a step makes known."""
    if isinstance(step, tuple):
        return step[:1]
    if isinstance(step, Search):
        return (step.name,)
    return step.states if isinstance(step, Repeat) else step.names


def computed(step: Step) -> tuple[Expr, ...]:
    """What a step computes."""
    if isinstance(step, tuple):
        return step[1:]
    return (step.call,) if isinstance(step, Several) else step.expressions


def mapped(node: Any, change: Callable[[Expr], Basic]) -> Any:
    """A routine, a step or a statement with all of its expressions changed."""
    if isinstance(node, Basic):
        return change(node)
    if isinstance(node, tuple):
        return tuple(mapped(part, change) for part in node)
    if not is_dataclass(node) or isinstance(node, type):
        return node
    return replace(
        node, **{own.name: mapped(getattr(node, own.name), change) for own in fields(node)}
    )


def replaced(node: Any, known: Mapping[Any, Any]) -> Any:
    """The same with symbols, or parts of expressions, replaced."""
    return mapped(node, lambda expr: expr.xreplace(known))


@dataclass(frozen=True)
class Routine:
    """A function with one result or several."""

    name: str
    about: str
    """One line: what it computes."""
    arguments: tuple[Symbol, ...]
    steps: tuple[Step, ...]
    results: tuple[tuple[str, Expr], ...]
    within: tuple[Boolean, ...] = ()
    """What is true of each argument inside the domain alone, NaN included, if that is asked."""
    outside: sp.Basic = sp.nan
    """What every result is where one of these is not true; of a truth value, false."""
    record: str = ""
    """What all its results are together, where a language has a type for that."""
    takes: tuple[str, ...] = ()
    """Such records that have arguments of it, by their names."""

    @property
    def truth(self) -> bool:
        """Whether the only result is 1 or 0 for yes or no."""
        return self.outside is sp.false

    @property
    def assignments(self) -> tuple[tuple[Symbol, Expr], ...]:
        """The steps of a routine that repeats nothing."""
        found = tuple(step for step in self.steps if isinstance(step, tuple))
        if len(found) < len(self.steps):
            raise ValueError(f"{self.name}: repeats something")
        return found

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All right-hand sides, those of the results last."""
        found: tuple[Expr, ...] = ()
        for step in self.steps:
            found += computed(step)
        return found + tuple(e for _, e in self.results)


def with_divisors(routine: Routine, divided: Callable[[Divisor], Expr]) -> Routine:
    """The routine with what is divided by made of each divisor."""
    if not any(e.has(Divisor) for e in routine.expressions):
        return routine

    def change(expr: Expr) -> Expr:
        return expr.replace(lambda e: isinstance(e, Divisor), divided)

    found: Routine = mapped(routine, change)
    return found


def propagated(routine: Routine, known: Mapping[Expr, Expr], so: Callable[[Expr], bool]) -> Routine:
    """The routine with what is known replaced; a step whose value is ``so`` is known, too."""
    known, steps = dict(known), []
    for step in (replaced(step, known) for step in routine.steps):
        if isinstance(step, tuple) and so(step[1]):
            known[step[0]] = step[1]
        else:
            steps.append(step)
    return replace(routine, steps=tuple(steps), results=replaced(routine.results, known))


def plain(routine: Routine) -> Routine:
    """The routine with its searches written out."""
    if not any(isinstance(step, Search) for step in routine.steps):
        return routine
    steps: list[Step] = []
    known: dict[Symbol, Expr] = {}
    for step in routine.steps:
        if isinstance(step, Search):
            steps += step.steps
            known[step.name] = step.found
        else:
            steps.append(replaced(step, known))
    results = tuple((name, _chosen(expr.xreplace(known))) for name, expr in routine.results)
    return replace(routine, steps=tuple(steps), results=results)


def _chosen(expr: Expr) -> Expr:
    """A number times a choice as a choice of products."""
    factor, choice = expr.as_coeff_Mul()
    if factor == 1 or not isinstance(choice, Piecewise):
        return expr
    return Piecewise(*((_chosen(factor * value), condition) for value, condition in choice.args))


def fresh(name: str, taken: set[str]) -> Symbol:
    """A name that is not taken before; one that is gets a number."""
    number, free = 1, name
    while free in taken:
        number, free = number + 1, f"{name}{number + 1}"
    taken.add(free)
    return Symbol(free)


def choose(condition: Boolean, yes: Expr, no: Expr) -> Expr:
    """One of two values; of a guard the second is the ordinary one."""
    return Piecewise((sp.sympify(yes), condition), (sp.sympify(no), True))


def with_named_bases(expr: Expr, done: list[Step], fresh: Iterator[Symbol]) -> Expr:
    """Powers of symbols only, as the base of a power is written more than once."""
    for power in sorted(expr.atoms(sp.Pow), key=_by_size):
        base, exponent = power.args
        if exponent.is_Integer and abs(exponent) > 1 and not base.is_Symbol:
            name = next(fresh)
            done.append((name, base))
            expr = expr.xreplace({power: name**exponent})
    return expr


def _by_size(expr: Expr) -> tuple[int, object]:
    return sp.count_ops(expr), sp.default_sort_key(expr)


# -- What an expression is made of, where each different part is looked at once ------------------


def parts(exprs: Iterable[Basic]) -> set[Basic]:
    """All different parts of expressions, these among them."""
    left = list(exprs)
    found: set[Basic] = set()
    while left:
        expr = left.pop()
        if expr not in found:
            found.add(expr)
            left += expr.args
    return found


def rewritten(expr: Basic, told: Callable[[Basic], Basic]) -> Basic:
    """The expression with what is told in place of each part, inner ones first."""
    known: dict[Basic, Basic] = {}

    def done(part: Basic) -> Basic:
        if part not in known:
            inner = tuple(map(done, part.args))
            known[part] = told(part if inner == part.args else part.func(*inner))
        return known[part]

    return done(expr)


# -- What a routine calls, and all routines of an export -----------------------------------------


OPERATIONS = (
    "Abs", "Infinity", "Max", "Min", "NaN", "TwoProdError", "atan2", "cos", "exp", "expm1", "floor",
    "sin", "sqrt", "tan",
)  # fmt: skip
"""Beside sums, products, quotients, comparisons and choices, what formulas are written with."""


@cache
def calls(routine: Routine) -> frozenset[str]:
    """Names of the routines that a routine calls."""
    functions = (f for f in parts(routine.expressions) if isinstance(f, sp.Function))
    found = {f.func.__name__ for f in functions}
    return frozenset(found - {*OPERATIONS, "Piecewise", "Divisor"})


@cache
def operations(routine: Routine) -> frozenset[str]:
    """The shared operations that a routine needs."""
    atoms = parts(routine.expressions)
    names = {type(a).__name__ for a in atoms}
    roots = any(a.is_Pow and abs(a.args[1]) == sp.S.Half for a in atoms if isinstance(a, Expr))
    return frozenset(names & set(OPERATIONS)) | ({"sqrt"} if roots else set())


def needs(routine: Routine) -> frozenset[str]:
    """The routines that it calls, and operations that may have to be written out."""
    return calls(routine) | operations(routine)


@dataclass(frozen=True)
class Library:
    """Forms with the routines that they need, each after those that it calls."""

    name: str
    title: str
    forms: tuple[Form, ...]
    helpers: tuple[Routine, ...]
    public: tuple[Routine, ...]
    sampled: tuple[Routine, ...] = ()
    """What finds the numbers of a device, and each function that judges a wall with them."""

    @property
    def factorials(self) -> int:
        """How many inverse factorials its series take, from 1/0! on."""
        loops = (s for helper in self.helpers for s in helper.steps if isinstance(s, Repeat))
        return max((n + 1 for loop in loops for n in loop.factorials), default=0)

    def needed(self, routine: Routine) -> Iterator[Routine]:
        """The helpers that a routine calls, or one of these does, in their order."""
        wanted = needs(routine)
        for helper in reversed(self.helpers):
            if helper.name in wanted:
                wanted |= needs(helper)
        return (helper for helper in self.helpers if helper.name in wanted)


# -- What routines and their results are called in source code ------------------------------------

_CODE_NAMES = {"C": "cosh_root", "S": "sinhc_root"}

_BRIEF = {
    "denominator_at_minus_one": "at_minus_one", "numerator_at_one": "together",
    "numerator_gap": "n_gap", "plant_n0": "n0", "plant_n1": "n1", "plant_trace": "trace",
    "cos_next": "cosine", "sin_next": "sine", "late_first": "m2", "late_last": "m0",
    "late_apart": "apart", "late_kick": "kicked",
}  # fmt: skip
"""What a result of a routine is called where it is used."""


def code_name(name: str) -> str:
    """The name of a routine in source code.

    >>> code_name("PlantN0Series"), code_name("C")
    ('plant_n0_series', 'cosh_root')
    """
    return _CODE_NAMES.get(name, re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower())


def brief(name: str) -> str:
    """The name of a variable that has the result of a routine, or its part of a joint name.

    >>> brief("plant_n1_of"), brief("plant_n1_of2"), brief("plant_n1"), brief("kick_of")
    ('n1', 'n1_2', 'n1', 'kick_of')
    """
    base, of, number = name.partition("_of")
    if base not in _BRIEF or (of and number and not number.isdigit()):
        return name
    return f"{_BRIEF[base]}_{number}" if number else _BRIEF[base]


def routine_name(name: str) -> str:
    """The name of a routine, from that in source code.

    >>> routine_name("plant_n0_series"), routine_name("cosh_root")
    ('PlantN0Series', 'C')
    """
    special = {code: own for own, code in _CODE_NAMES.items()}
    return special.get(name) or "".join(part.capitalize() for part in name.split("_"))

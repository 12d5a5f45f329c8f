"""The notation of routines: Python functions of symbols, in which each call of ``do`` is a step.

>>> @routine("total total_low", listed=False)
... def fast_two_sum(x, y):
...     \"\"\"x + y and what it misses, for |x| >= |y|\"\"\"
...     total = do("total", x + y)
...     back = do("back", total - x)
...     return total, y - back
>>> made = fast_two_sum.make()
>>> made.steps
((total, x + y), (back, total - x))
>>> made.results
(('total', total), ('total_low', -back + y))

A routine can call another one.  If that one has several results, the call is a step; otherwise it
is part of an expression.  A pair is a float and its rounding error: the name of the second is the
name of the first with ``_low`` appended.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import count
from typing import Any

import sympy as sp
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import (
    Divisor,
    Repeat,
    Routine,
    Several,
    Step,
    choose,
    fresh,
    names,
    routine_name,
    with_named_bases,
)

Pair = tuple[Expr, Expr]
"""A float and what it misses."""


@dataclass
class Steps:
    """Collects the steps of a routine; each call adds one and gives its name."""

    done: list[Step] = field(default_factory=list)
    taken: set[str] = field(default_factory=set)

    def __enter__(self) -> Steps:
        _WRITTEN.append(self)
        return self

    def __exit__(self, *error: object) -> None:
        _WRITTEN.pop()

    def fresh(self, name: str) -> Symbol:
        """A name that is not taken."""
        return fresh(name, self.taken)

    def __call__(self, name: str, expr: Expr) -> Symbol:
        """The step ``name = expr``."""
        symbol = self.fresh(name)
        self.done.append((symbol, self._named(expr)))
        return symbol

    def _named(self, expr: Expr) -> Expr:
        bases = (self.fresh("base") for _ in count())
        return with_named_bases(sp.sympify(expr), self.done, bases)

    def repeat(
        self,
        start: dict[str, Expr],
        step: Callable[..., Iterable[Expr]],
        done: Callable[..., Boolean],
        most: int,
    ) -> tuple[Symbol, ...]:
        """A repetition: ``step`` makes the next states out of the states; gives the last ones."""
        states = tuple(self.fresh(name) for name in start)
        with Steps(taken=self.taken) as inner:
            made = list(step(*states))
        known = [s for step in inner.done for s in names(step)]
        after = tuple(
            expr if expr in known or expr in states[:at] else inner(f"next_{name}", expr)
            for at, (name, expr) in enumerate(zip(start, made, strict=True))
        )
        steps = tuple(s for s in inner.done if isinstance(s, tuple))
        if len(steps) < len(inner.done):
            raise ValueError("a repetition inside another one has to be a routine of its own")
        first = tuple(sp.sympify(e) for e in start.values())
        self.done.append(Repeat(states, first, steps, after, most, done(*states)))
        return states

    def sum(
        self,
        names: str,
        step: Callable[..., Iterable[Expr]],
        factorials: range,
        brief: Boolean = sp.false,
        few: int = 0,
    ) -> tuple[Symbol, ...]:
        """The same for a series, from 0 on: ``step`` gets the states and 1/n!, for each n.

        From ``few`` on where it is brief.
        """
        number, start = self.fresh("number"), dict.fromkeys(names.split(), sp.S.Zero)
        states = self.repeat(
            start, lambda *states: step(*states, number), lambda *_: sp.false, len(factorials)
        )
        loop = self.done[-1]
        assert isinstance(loop, Repeat)
        loop = replace(loop, number=number, factorials=factorials, brief=brief, few=few)
        self.done[-1] = loop
        return states

    def several(self, names: Iterable[str], routine: str, *arguments: Expr) -> tuple[Symbol, ...]:
        """All results of another routine."""
        found = tuple(self.fresh(name) for name in names)
        self.done.append(Several(found, sp.Function(routine)(*arguments)))
        return found

    def common(self, *exprs: Expr) -> list[Expr]:
        """The expressions made of steps for what they have in common."""
        fresh = (self.fresh("t") for _ in count())
        steps, results = sp.cse(exprs, symbols=fresh, order="canonical")
        for name, expr in steps:
            self.done.append((name, self._named(expr)))
        return list(results)

    def nonzero(self, value: Expr) -> Symbol:
        """The value, or 1 in its place where it is 0."""
        return self("whole", choose(sp.Eq(value, 0), sp.S.One, value))

    def divisor(self, value: Expr) -> Symbol:
        """The value, which is 0 only where another branch counts."""
        return self("whole", Divisor(value))

    def routine(
        self,
        name: str,
        about: str,
        arguments: tuple[Symbol, ...],
        result: Expr | dict[str, Expr],
        record: str = "",
        takes: tuple[str, ...] = (),
    ) -> Routine:
        """The routine of these steps, of one result or of several with their names."""
        results = result if isinstance(result, dict) else {name: result}
        found = tuple((own, self._named(expr)) for own, expr in results.items())
        steps = tuple(self.done)
        return Routine(name, about, arguments, steps, found, record=record, takes=takes)


_WRITTEN: list[Steps] = []
"""What is written now, the innermost last: a routine, or the inside of a repetition."""


class _Do:
    """Whatever :class:`Steps` has, of the routine that is written now."""

    def __call__(self, name: str, expr: Expr) -> Symbol:
        return _WRITTEN[-1](name, expr)

    def __getattr__(self, name: str) -> Any:
        if not _WRITTEN:
            raise AttributeError(f"{name}: no routine is written now")
        return getattr(_WRITTEN[-1], name)


do = _Do()


@dataclass(frozen=True)
class Written:
    """A routine in this notation.  Calling it in another routine writes the call there."""

    write: Callable[..., Any]
    name: str
    gives: tuple[str, ...]
    called: tuple[str, ...]
    record: str
    takes: tuple[str, ...]
    groups: dict[str, tuple[Symbol, ...]]

    @cached_property
    def given(self) -> dict[str, Any]:
        """For each parameter its symbol, its pair of symbols, or its group of symbols."""
        found: dict[str, Any] = {}
        for own, parameter in inspect.signature(self.write).parameters.items():
            one = Symbol(own)
            pair = (one, Symbol(f"{own}_low")) if parameter.annotation in (Pair, "Pair") else one
            found[own] = self.groups.get(own, pair)
        return {own: symbols for own, symbols in found.items() if own != "precision"}

    @property
    def precise(self) -> bool:
        """Whether it depends on the precision."""
        return "precision" in inspect.signature(self.write).parameters

    @property
    def arguments(self) -> tuple[Symbol, ...]:
        """The symbols of all parameters."""
        return tuple(flat(tuple(self.given.values())))

    def __call__(self, *given: Any) -> Any:
        """The results, with pairs as tuples; arguments are numbers, pairs or groups."""
        flat = self._flat(given)
        if not self.gives:
            return sp.Function(self.name)(*flat)
        return shaped(self.called, do.several(self.called, self.name, *flat))

    def by_name(self, *given: Any) -> dict[str, Expr]:
        """The results by name, with the parts of a pair apart."""
        found = do.several(self.called, self.name, *self._flat(given))
        return dict(zip(self.gives, found, strict=True))

    def of(self, known: dict[str, Expr]) -> Expr:
        """The only result, for arguments that are looked up by name."""
        return sp.Function(self.name)(*(known[s.name] for s in self.arguments))

    def _flat(self, given: Sequence[Any]) -> list[Expr]:
        found: list[Expr] = []
        for (own, symbols), value in zip(self.given.items(), given, strict=True):
            one, count = flat(value), len(flat(symbols))
            if count == 2 and own not in self.groups and len(one) == 1:
                one.append(sp.S.Zero)  # an exact number as a pair
            if len(one) != count:
                raise ValueError(f"{self.name}: {own} has {count} numbers, {len(one)} are given")
            found += one
        return found

    def make(self, precision: Precision = DOUBLE) -> Routine:
        """The routine for floats of a precision."""
        known = {"precision": precision} if self.precise else {}
        about = " ".join((self.write.__doc__ or "").split())
        with Steps(taken={s.name for s in self.arguments}) as steps:
            found = self.write(*self.given.values(), **known)
        if isinstance(found, Routine):
            return replace(found, name=self.name, about=about, arguments=self.arguments,
                           within=(), record=self.record)  # fmt: skip
        result = dict(zip(self.gives, flat(found), strict=True)) if self.gives else found
        return steps.routine(self.name, about, self.arguments, result, self.record, self.takes)


def shaped(names: Sequence[str], found: Sequence[Expr]) -> Any:
    """Group the parts of each pair; a single pair or number is returned as it is."""
    parts: list[Any] = []
    for name, expr in zip(names, found, strict=True):
        if parts and name.endswith("_low"):
            parts[-1] = parts[-1], expr
        else:
            parts.append(expr)
    return parts[0] if len(parts) == 1 else tuple(parts)


def flat(found: Any) -> list[Expr]:
    """Flatten nested tuples of numbers."""
    return [n for part in found for n in flat(part)] if isinstance(found, tuple) else [found]


ROUTINES: dict[str, Written] = {}
"""All routines by name."""


def routine(
    gives: str = "", called: str = "", record: str = "", takes: str = "", name: str = "",
    listed: bool = True, **groups: tuple[Symbol, ...],
) -> Callable[[Callable[..., Any]], Written]:  # fmt: skip
    """Turn a function into a routine.  Its docstring becomes the comment in exported source.

    A parameter of the function stands for a symbol of the same name, or for a pair if its
    annotation is ``Pair``.  A parameter ``precision`` is not an argument of the routine: it gets
    the :class:`~symhaptic.export.precision.Precision` that the routine is made for.

    Parameters
    ----------
    gives : names of the results, if there are several
    called : names of the results in the steps of a caller; default is ``gives``
    record : name of the struct of all results, for languages that have structs
    takes : names of the structs that contain arguments of this routine
    name : name of the routine; default is the name of the function
    listed : whether the routine is added to :data:`ROUTINES`
    groups : for parameters that stand for several symbols, these symbols
    """

    def made(write: Callable[..., Any]) -> Written:
        own, names, others = name or routine_name(write.__name__), gives.split(), called.split()
        found = Written(write, own, tuple(names), tuple(others or names), record,
                        tuple(takes.split()), groups)  # fmt: skip
        if listed:
            ROUTINES[own] = found
        return found

    return made


def pick(condition: Boolean, yes: Any, no: Any) -> Any:
    """Choose between two numbers, or element by element between two tuples of numbers."""
    if not isinstance(yes, tuple):
        return choose(condition, yes, no)
    others = no if isinstance(no, tuple) else (no,) * len(yes)
    return tuple(pick(condition, *both) for both in zip(yes, others, strict=True))

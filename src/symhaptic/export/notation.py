"""The notation of routines: functions of symbols, in which each call of ``do`` is a step.

A routine that calls another one has a call among its steps, for all results of that one, or in an
expression, for its only result.  Where arguments or results are a pair, a float and what it
misses, the name of the second is that of the first with ``_low`` behind it.
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
        self.done.append((symbol, sp.sympify(expr)))
        return symbol

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
        self.done += steps
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
        found = tuple((own, sp.sympify(expr)) for own, expr in results.items())
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
    """A routine in this notation; a call of it is a step, or a part of one."""

    write: Callable[..., Any]
    name: str
    gives: tuple[str, ...]
    called: tuple[str, ...]
    record: str
    takes: tuple[str, ...]
    groups: dict[str, tuple[Symbol, ...]]

    @cached_property
    def given(self) -> dict[str, Any]:
        """The symbols of each parameter, which is one of them, a pair or a group."""
        found: dict[str, Any] = {}
        for own, parameter in inspect.signature(self.write).parameters.items():
            one = Symbol(own)
            pair = (one, Symbol(f"{own}_low")) if parameter.annotation == "Pair" else one
            found[own] = self.groups.get(own, pair)
        return {own: symbols for own, symbols in found.items() if own != "precision"}

    @property
    def precise(self) -> bool:
        """Whether it depends on the precision."""
        return "precision" in inspect.signature(self.write).parameters

    @property
    def arguments(self) -> tuple[Symbol, ...]:
        """All of them, one by one."""
        return tuple(flat(tuple(self.given.values())))

    def __call__(self, *given: Any) -> Any:
        """Its results, for arguments that are numbers or pairs."""
        flat = self._flat(given)
        if not self.gives:
            return sp.Function(self.name)(*flat)
        return shaped(self.called, do.several(self.called, self.name, *flat))

    def by_name(self, *given: Any) -> dict[str, Expr]:
        """The same, each number by its name."""
        found = do.several(self.called, self.name, *self._flat(given))
        return dict(zip(self.gives, found, strict=True))

    def of(self, known: dict[str, Expr]) -> Expr:
        """Its only result, for arguments that are known by their names."""
        return sp.Function(self.name)(*(known[s.name] for s in self.arguments))

    def _flat(self, given: Sequence[Any]) -> list[Expr]:
        found: list[Expr] = []
        for symbols, value in zip(self.given.values(), given, strict=True):
            one = flat(value)
            if isinstance(symbols, tuple) and len(one) < len(symbols):
                one.append(sp.S.Zero)  # what is no pair misses nothing
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
    """Results with each pair together; what is a pair alone is that pair."""
    parts: list[Any] = []
    for name, expr in zip(names, found, strict=True):
        if parts and name.endswith("_low"):
            parts[-1] = parts[-1], expr
        else:
            parts.append(expr)
    return parts[0] if len(parts) == 1 else tuple(parts)


def flat(found: Any) -> list[Expr]:
    """Numbers and pairs as numbers."""
    return [n for part in found for n in flat(part)] if isinstance(found, tuple) else [found]


ROUTINES: dict[str, Written] = {}
"""All routines by name."""


def routine(
    gives: str = "", called: str = "", record: str = "", takes: str = "", name: str = "",
    listed: bool = True, **groups: tuple[Symbol, ...],
) -> Callable[[Callable[..., Any]], Written]:  # fmt: skip
    """A function as a routine: its parameters are symbols, its docstring says what it computes.

    Parameters
    ----------
    gives : names of the results, where there is more than one
    called : the names that these get in another routine, where they are others there
    record : what all results are together, where a language has a type for that
    takes : such records that have arguments of it
    name : that of the routine, if it is not the function's
    listed : whether it is a routine of every library

    groups : by the names of parameters, symbols that are given together

    Any other parameter is one symbol, or a pair where its annotation is ``Pair``.  ``precision`` is
    no argument, but what the routine depends on.
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
    """One of two numbers, or of each of two groups of them."""
    if not isinstance(yes, tuple):
        return choose(condition, yes, no)
    others = no if isinstance(no, tuple) else (no,) * len(yes)
    return tuple(pick(condition, *both) for both in zip(yes, others, strict=True))

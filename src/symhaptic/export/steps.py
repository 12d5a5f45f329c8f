"""A routine while it is written: each call adds a step and gives its name."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from itertools import count

import sympy as sp
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.export.routine import (
    Divisor,
    Repeat,
    Routine,
    Several,
    Step,
    choose,
    fresh,
    names,
)


@dataclass
class Steps:
    """Collects the steps of a routine; each call adds one and gives its name."""

    done: list[Step] = field(default_factory=list)
    taken: set[str] = field(default_factory=set)

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
        step: Callable[[Steps, tuple[Symbol, ...]], Iterable[Expr]],
        done: Callable[[tuple[Symbol, ...]], Boolean],
        most: int,
    ) -> tuple[Symbol, ...]:
        """A repetition: ``step`` makes the next states out of the states; gives the last ones."""
        states = tuple(self.fresh(name) for name in start)
        inner = Steps(taken=self.taken)
        made = list(step(inner, states))
        known = [s for step in inner.done for s in names(step)]
        after = tuple(
            expr if expr in known or expr in states[:at] else inner(f"next_{name}", expr)
            for at, (name, expr) in enumerate(zip(start, made, strict=True))
        )
        steps = tuple(s for s in inner.done if isinstance(s, tuple))
        if len(steps) < len(inner.done):
            raise ValueError("a repetition inside another one has to be a routine of its own")
        first = tuple(sp.sympify(e) for e in start.values())
        self.done.append(Repeat(states, first, steps, after, most, done(states)))
        return states

    def sum(
        self,
        start: dict[str, Expr],
        step: Callable[[Steps, tuple[Symbol, ...], Symbol], Iterable[Expr]],
        factorials: range,
        brief: Boolean = sp.false,
        few: int = 0,
    ) -> tuple[Symbol, ...]:
        """The same for a series: a step with 1/n! for each n, from ``few`` on where it is brief."""
        number = self.fresh("number")
        states = self.repeat(start, lambda do, states: step(do, states, number),
                             lambda _: sp.false, len(factorials))  # fmt: skip
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

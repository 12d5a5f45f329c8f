"""A small function of real numbers as steps that are done in order, whatever the language.

What is rounded, and in which order, is part of a routine: each sum whose order matters is a step
of its own.  Every branch of a choice is defined for all arguments, so that a target may evaluate
all of them or only the one that counts.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import sympy as sp
from sympy import Expr, Function, Piecewise, Symbol
from sympy.codegen.cfunctions import expm1
from sympy.logic.boolalg import Boolean


class ProductError(Function):  # type: ignore[misc]
    """a b minus the float nearest to it; 0 in exact arithmetic."""

    nargs = 2


@dataclass(frozen=True)
class Shared:
    """The first ``count`` steps of several routines, under a name."""

    name: str
    about: str
    count: int


@dataclass(frozen=True)
class Routine:
    """A function with one result or several."""

    name: str
    about: str
    """One line: what it computes."""
    arguments: tuple[Symbol, ...]
    steps: tuple[tuple[Symbol, Expr], ...]
    results: tuple[tuple[str, Expr], ...]
    shared: Shared | None = None
    """Its first steps, where other routines of the same arguments begin with them too."""

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All right-hand sides, those of the results last."""
        return tuple(e for _, e in self.steps) + tuple(e for _, e in self.results)


@dataclass
class Steps:
    """Collects the steps of a routine; each call adds one and gives its name."""

    done: list[tuple[Symbol, Expr]] = field(default_factory=list)
    shared: Shared | None = None

    def __call__(self, name: str, expr: Expr) -> Symbol:
        """The step ``name = expr``; a name that is taken gets a number."""
        taken = {symbol.name for symbol, _ in self.done}
        count, fresh = 1, name
        while fresh in taken:
            count, fresh = count + 1, f"{name}{count + 1}"
        symbol = Symbol(fresh)
        self.done.append((symbol, sp.sympify(expr)))
        return symbol

    def share(self, name: str, about: str) -> None:
        """What is done so far is common to several routines: a target may do it once for all."""
        self.shared = Shared(name, about, len(self.done))

    def nonzero(self, value: Expr) -> Symbol:
        """The value, or 1 in its place where it is 0."""
        return self("whole", choose(sp.Eq(value, 0), sp.S.One, value))

    def routine(
        self, name: str, about: str, arguments: tuple[Symbol, ...], result: Expr
    ) -> Routine:
        """The routine of these steps."""
        results = ((name, sp.sympify(result)),)
        return Routine(name, about, arguments, tuple(self.done), results, self.shared)


def choose(condition: Boolean, yes: Expr, no: Expr) -> Expr:
    """One of two values; of a guard the second is the ordinary one."""
    return Piecewise((sp.sympify(yes), condition), (sp.sympify(no), True))


def fast_sum(do: Steps, large: Expr, small: Expr) -> tuple[Symbol, Symbol]:
    """Sum and its rounding error, where the first is not the smaller one."""
    total = do("total", large + small)
    back = do("back", total - large)
    return total, do("lost", small - back)


def difference(do: Steps, left: Expr, right: Expr) -> tuple[Symbol, Symbol]:
    """Difference and its rounding error, whichever is larger."""
    total = do("total", left - right)
    back = do("back", total - left)
    rest = do("rest", total - back)
    one, two = do("one", left - rest), do("two", -right - back)
    return total, do("lost", one + two)


def product(do: Steps, one: Expr, two: Expr, low: Expr = sp.S.Zero) -> tuple[Symbol, Symbol]:
    """one (two + low) and what the float misses."""
    total = do("total", one * two)
    return total, do("lost", ProductError(one, two) + one * low)


def quotient(
    do: Steps, top: Expr, bottom: Expr, top_low: Expr = sp.S.Zero, bottom_low: Expr = sp.S.Zero
) -> tuple[Symbol, Symbol]:
    """(top + top_low)/(bottom + bottom_low) and what the float misses."""
    total = do("total", top / bottom)
    left = do("left", top - total * bottom)
    left = do("left", left - ProductError(total, bottom))
    left = do("left", left + (top_low - total * bottom_low))
    return total, do("lost", left / bottom)


# -- order of work ------------------------------------------------------------------------


@dataclass(frozen=True)
class Assign:
    """``name = expr``."""

    name: Symbol
    expr: Expr


@dataclass(frozen=True)
class Choice:
    """One block where a condition holds, another one where it does not."""

    condition: Boolean
    yes: Block
    no: Block


@dataclass(frozen=True)
class Return:
    """The results, which end the routine."""

    results: tuple[Expr, ...]


Block = tuple[Assign | Choice | Return, ...]


def lazy(routine: Routine) -> Block:
    """The routine with each step done only where its value is used."""
    known = dict(routine.steps)
    order = {name: i for i, (name, _) in enumerate(routine.steps)}

    def needed(exprs: Iterable[Expr], done: set[Symbol]) -> list[Symbol]:
        found: set[Symbol] = set()
        left = [s for e in exprs for s in e.free_symbols]
        while left:
            symbol = left.pop()
            if symbol in known and symbol not in found and symbol not in done:
                found.add(symbol)
                left += known[symbol].free_symbols
        return sorted(found, key=order.__getitem__)

    def block(results: tuple[Expr, ...], done: set[Symbol]) -> Block:
        only = results[0]
        choice = len(results) == 1 and isinstance(only, Piecewise)
        first = needed([only.args[0][1]] if choice else results, done)
        steps: Block = tuple(Assign(name, known[name]) for name in first)
        done = done | set(first)
        if not choice:
            return (*steps, Return(results))
        (yes, condition), *others = only.args
        no = Piecewise(*others) if len(others) > 1 else others[0][0]
        return (*steps, Choice(condition, block((yes,), done), block((no,), done)))

    return block(tuple(e for _, e in routine.results), set())


__all__ = [
    "ProductError",
    "Routine",
    "Shared",
    "Steps",
    "choose",
    "difference",
    "expm1",
    "fast_sum",
    "product",
    "quotient",
]

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
class Routine:
    """A function with one result or several."""

    name: str
    about: str
    """One line: what it computes."""
    arguments: tuple[Symbol, ...]
    steps: tuple[tuple[Symbol, Expr], ...]
    results: tuple[tuple[str, Expr], ...]

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All right-hand sides, those of the results last."""
        return tuple(e for _, e in self.steps) + tuple(e for _, e in self.results)


@dataclass
class Steps:
    """Collects the steps of a routine; each call adds one and gives its name."""

    done: list[tuple[Symbol, Expr]] = field(default_factory=list)

    def __call__(self, name: str, expr: Expr) -> Symbol:
        """The step ``name = expr``; a name that is taken gets a number."""
        taken = {symbol.name for symbol, _ in self.done}
        count, fresh = 1, name
        while fresh in taken:
            count, fresh = count + 1, f"{name}{count + 1}"
        symbol = Symbol(fresh)
        self.done.append((symbol, sp.sympify(expr)))
        return symbol

    def nonzero(self, value: Expr) -> Symbol:
        """The value, or 1 in its place where it is 0."""
        return self("whole", choose(sp.Eq(value, 0), sp.S.One, value))

    def routine(
        self, name: str, about: str, arguments: tuple[Symbol, ...], result: Expr
    ) -> Routine:
        """The routine of these steps."""
        return Routine(name, about, arguments, tuple(self.done), ((name, sp.sympify(result)),))


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
class Join:
    """The same, after which the names have values and the work goes on."""

    names: tuple[Symbol, ...]
    condition: Boolean
    yes: Block
    no: Block


@dataclass(frozen=True)
class Set:
    """A name of the join around it gets its value."""

    name: Symbol
    expr: Expr


@dataclass(frozen=True)
class Return:
    """The results, which end the routine."""

    results: tuple[Expr, ...]


Block = tuple[Assign | Choice | Join | Set | Return, ...]


def lazy(routine: Routine) -> Block:
    """The routine with each step done only where its value is used.

    Steps that choose by the same condition share one branch, and guards that the condition has
    decided are left out.
    """
    return _Lazy(routine).returned(tuple(e for _, e in routine.results), set(), {})


Facts = dict[Expr, Boolean]


class _Lazy:
    """Puts steps into the branches that need them."""

    def __init__(self, routine: Routine) -> None:
        self.known = dict(routine.steps)
        self.order = {name: i for i, (name, _) in enumerate(routine.steps)}

    def returned(self, results: tuple[Expr, ...], done: set[Symbol], facts: Facts) -> Block:
        """What leads to the results and returns them."""
        results = tuple(e.xreplace(facts) for e in results)
        (only, *others) = results
        if others or not isinstance(only, Piecewise):
            steps, _ = self._steps(results, done, facts)
            return (*steps, Return(results))
        condition, yes, no = parted(only)
        steps, done = self._steps((condition,), done, facts)
        return (*steps, Choice(
            condition,
            self.returned((yes,), done, facts | _decided(condition, sp.true)),
            self.returned((no,), done, facts | _decided(condition, sp.false)),
        ))  # fmt: skip

    def _steps(
        self, wanted: Iterable[Expr], done: set[Symbol], facts: Facts
    ) -> tuple[Block, set[Symbol]]:
        """All steps that the expressions always need, and what is done then."""
        exprs = {s: self.known[s].xreplace(facts) for s in self._closure(wanted, done)}
        always = self._always(wanted, exprs, done)
        left = sorted(always, key=self.order.__getitem__)
        written: list[Assign | Choice | Join | Set | Return] = []
        done = set(done)
        while left:
            plain = [s for s in left if not self._branches(exprs[s], exprs, always | done)
                     and not (exprs[s].free_symbols & set(left))]  # fmt: skip
            if plain:
                written.append(Assign(plain[0], exprs[plain[0]]))
                left.remove(plain[0])
                done.add(plain[0])
                continue
            ready = [s for s in left if not (self._closure((exprs[s],), done) & set(left))]
            condition = parted(exprs[ready[0]])[0]
            names = tuple(s for s in ready if parted(exprs[s])[0] == condition)
            yes, no = (
                self._arm([(s, parted(exprs[s])[side]) for s in names], done,
                          facts | _decided(condition, value))
                for side, value in ((1, sp.true), (2, sp.false))
            )  # fmt: skip
            written.append(Join(names, condition, yes, no))
            left = [s for s in left if s not in names]
            done |= set(names)
        return tuple(written), done

    def _arm(self, values: list[tuple[Symbol, Expr]], done: set[Symbol], facts: Facts) -> Block:
        """One side of a join; values that choose again by one condition share that branch."""
        values = [(s, e.xreplace(facts)) for s, e in values]
        chosen = [e for _, e in values if isinstance(e, Piecewise) and self._heavy(e, done)]
        plain = [(s, e) for s, e in values if e not in chosen]
        steps, done = self._steps([e for _, e in plain], done, facts)
        written = [*steps, *(Set(s, e) for s, e in plain)]
        while chosen:
            condition = parted(chosen[0])[0]
            group = [(s, e) for s, e in values if e in chosen and parted(e)[0] == condition]
            more, done = self._steps((condition,), done, facts)
            sides = [
                self._arm(
                    [(s, parted(e)[side]) for s, e in group],
                    done,
                    facts | _decided(condition, value),
                )
                for side, value in ((1, sp.true), (2, sp.false))
            ]
            written += [*more, Join((), condition, *sides)]
            chosen = [e for e in chosen if parted(e)[0] != condition]
        return tuple(written)

    def _closure(self, wanted: Iterable[Expr], done: set[Symbol]) -> set[Symbol]:
        """Steps that the expressions may need."""
        found: set[Symbol] = set()
        left = [s for e in wanted for s in e.free_symbols]
        while left:
            symbol = left.pop()
            if symbol in self.known and symbol not in found and symbol not in done:
                found.add(symbol)
                left += self.known[symbol].free_symbols
        return found

    def _always(
        self, wanted: Iterable[Expr], exprs: dict[Symbol, Expr], done: set[Symbol]
    ) -> set[Symbol]:
        """Steps that the expressions need whichever branch is taken inside them."""
        found: set[Symbol] = set()
        left = [s for e in wanted for s in e.free_symbols]
        while left:
            symbol = left.pop()
            if symbol not in exprs or symbol in found or symbol in done:
                continue
            found.add(symbol)
            expr = exprs[symbol]
            heavy = isinstance(expr, Piecewise) and self._heavy(expr, done)
            left += (parted(expr)[0] if heavy else expr).free_symbols
        return found

    def _heavy(self, expr: Piecewise, done: set[Symbol]) -> bool:
        """Whether a choice has work in it: steps of its own, or calls."""
        _, yes, no = parted(expr)
        return any(side.atoms(Function) - side.atoms(Piecewise, sp.Abs) for side in (yes, no)) or (
            self._closure((yes,), done) != self._closure((no,), done)
        )

    def _branches(self, expr: Expr, exprs: dict[Symbol, Expr], there: set[Symbol]) -> bool:
        """Whether a choice that is worth a branch has steps that are not done anyway."""
        if not isinstance(expr, Piecewise):
            return False
        _, yes, no = parted(expr)
        own = self._closure((yes, no), there)
        calls = any(side.atoms(Function) - side.atoms(Piecewise, sp.Abs) for side in (yes, no))
        return bool(own) or calls


def _decided(condition: Boolean, value: Boolean) -> Facts:
    return {condition: value, sp.Not(condition): sp.Not(value)}


def parted(expr: Piecewise) -> tuple[Boolean, Expr, Expr]:
    """The first condition of a choice, the value there, and what holds else."""
    (yes, condition), *others = expr.args
    return condition, yes, (Piecewise(*others) if len(others) > 1 else others[0][0])


__all__ = [
    "ProductError",
    "Routine",
    "Steps",
    "choose",
    "difference",
    "expm1",
    "fast_sum",
    "product",
    "quotient",
]

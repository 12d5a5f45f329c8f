"""A small function of real numbers as steps that are done in order, whatever the language.

What is rounded, and in which order, is part of a routine: each sum whose order matters is a step
of its own.  Every branch of a choice is defined for all arguments, so that a target may evaluate
all of them or only the one that counts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import count

import sympy as sp
from sympy import Expr, Function, Piecewise, Symbol
from sympy.codegen.cfunctions import expm1
from sympy.logic.boolalg import Boolean


class ProductError(Function):  # type: ignore[misc]
    """a b minus the float nearest to it; 0 in exact arithmetic, and if one is 0 or 1."""

    nargs = 2

    @classmethod
    def eval(cls, one: Expr, two: Expr) -> Expr | None:
        """Nothing is missed by a product with 0 or 1."""
        return sp.S.Zero if {abs(one), abs(two)} & {sp.S.Zero, sp.S.One} else None


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
    """Of these steps, the ones that become the states."""
    most: int
    done: Boolean

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All of its right-hand sides, and its condition."""
        return (*self.start, *(e for _, e in self.steps), self.done)

    def xreplace(self, known: Mapping[Symbol, Expr]) -> Repeat:
        """The same with symbols replaced that are known before."""
        return replace(
            self,
            start=tuple(e.xreplace(known) for e in self.start),
            steps=tuple((s, e.xreplace(known)) for s, e in self.steps),
            done=self.done.xreplace(known),
        )

    @property
    def free_symbols(self) -> set[Symbol]:
        """What has to be known before."""
        own = {*self.states, *(name for name, _ in self.steps)}
        inner = {s for e in self.expressions[len(self.start) :] for s in e.free_symbols} - own
        return inner | {s for e in self.start for s in e.free_symbols}


Step = tuple[Symbol, Expr] | Repeat
"""``name = expr``, or a repetition."""


def names(step: Step) -> tuple[Symbol, ...]:
    """What a step makes known."""
    return step.states if isinstance(step, Repeat) else step[:1]


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
    steps: tuple[Step, ...]
    results: tuple[tuple[str, Expr], ...]
    shared: Shared | None = None
    """Its first steps, where other routines of the same arguments begin with them too."""

    @property
    def assignments(self) -> tuple[tuple[Symbol, Expr], ...]:
        """The steps of a routine that repeats nothing."""
        found = tuple(step for step in self.steps if not isinstance(step, Repeat))
        if len(found) < len(self.steps):
            raise ValueError(f"{self.name}: repeats something")
        return found

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All right-hand sides, those of the results last."""
        found: tuple[Expr, ...] = ()
        for step in self.steps:
            found += step.expressions if isinstance(step, Repeat) else step[1:]
        return found + tuple(e for _, e in self.results)


@dataclass
class Steps:
    """Collects the steps of a routine; each call adds one and gives its name."""

    done: list[Step] = field(default_factory=list)
    taken: set[str] = field(default_factory=set)

    def fresh(self, name: str) -> Symbol:
        """A name; one that is taken gets a number."""
        number, free = 1, name
        while free in self.taken:
            number, free = number + 1, f"{name}{number + 1}"
        self.taken.add(free)
        return Symbol(free)

    shared: Shared | None = None

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
        after = tuple(inner(f"next_{name}", expr) for name, expr in zip(start, made, strict=True))
        steps = tuple(s for s in inner.done if not isinstance(s, Repeat))
        if len(steps) < len(inner.done):
            raise ValueError("a repetition inside another one has to be a routine of its own")
        first = tuple(sp.sympify(e) for e in start.values())
        self.done.append(Repeat(states, first, steps, after, most, done(states)))
        return states

    def common(self, *exprs: Expr) -> list[Expr]:
        """The expressions made of steps for what they have in common."""
        fresh = (self.fresh("t") for _ in count())
        steps, results = sp.cse(exprs, symbols=fresh, order="canonical")
        self.done += steps
        return list(results)

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


Block = tuple[Assign | Repeat | Choice | Join | Set | Return, ...]


@cache
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
        self.known = dict(step for step in routine.steps if not isinstance(step, Repeat))
        self.loops = {s: r for r in routine.steps if isinstance(r, Repeat) for s in r.states}
        self.order = {name: i for i, step in enumerate(routine.steps) for name in names(step)}

    def returned(self, results: tuple[Expr, ...], done: set[Symbol], facts: Facts) -> Block:
        """What leads to the results and returns them."""
        results = tuple(e.xreplace(facts) for e in results)
        if not _chosen_alike(results):
            steps, _ = self._steps(results, done, facts)
            return (*steps, Return(results))
        condition = parted(results[0])[0]
        steps, done = self._steps((condition,), done, facts)
        yes, no = (
            self.returned(tuple(parted(r)[side] for r in results), done,
                          facts | _decided(condition, value))
            for side, value in ((1, sp.true), (2, sp.false))
        )  # fmt: skip
        return (*steps, Choice(condition, yes, no))

    def _steps(
        self, wanted: Iterable[Expr], done: set[Symbol], facts: Facts
    ) -> tuple[Block, set[Symbol]]:
        """All steps that the expressions always need, and what is done then."""
        needed = self._closure(wanted, done)
        exprs = {s: self.known[s].xreplace(facts) for s in needed if s in self.known}
        always = self._always(wanted, exprs, done)
        left = sorted(always, key=self.order.__getitem__)
        written: list[Assign | Repeat | Choice | Join | Set | Return] = []
        done = set(done)
        while left:
            loops = [self.loops[s] for s in left if s in self.loops]
            ready = [r for r in loops if not r.free_symbols & set(left)]
            if ready:
                written.append(ready[0])
                left = [s for s in left if s not in ready[0].states]
                done |= set(ready[0].states)
                continue
            waiting = set(left)
            idle = (s for s in left if s in exprs and waiting.isdisjoint(_free(exprs[s])))
            plain = next((s for s in idle if not self._branches(exprs[s], always | done)), None)
            if plain is not None:
                written.append(Assign(plain, exprs[plain]))
                left.remove(plain)
                done.add(plain)
                continue
            split = [s for s in left if s in exprs
                     and waiting.isdisjoint(self._closure((exprs[s],), done))]  # fmt: skip
            condition = parted(exprs[split[0]])[0]
            together = tuple(s for s in split if parted(exprs[s])[0] == condition)
            yes, no = (
                self._arm([(s, parted(exprs[s])[side]) for s in together], done,
                          facts | _decided(condition, value))
                for side, value in ((1, sp.true), (2, sp.false))
            )  # fmt: skip
            written.append(Join(together, condition, yes, no))
            left = [s for s in left if s not in together]
            done |= set(together)
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
        left = [s for e in wanted for s in _free(e)]
        while left:
            symbol = left.pop()
            if symbol in found or symbol in done:
                continue
            if symbol in self.known:
                found.add(symbol)
                left += _free(self.known[symbol])
            elif symbol in self.loops:
                found |= set(self.loops[symbol].states)
                left += self.loops[symbol].free_symbols
        return found

    def _always(
        self, wanted: Iterable[Expr], exprs: dict[Symbol, Expr], done: set[Symbol]
    ) -> set[Symbol]:
        """Steps that the expressions need whichever branch is taken inside them."""
        found: set[Symbol] = set()
        left = [s for e in wanted for s in _free(e)]
        while left:
            symbol = left.pop()
            if symbol in found or symbol in done:
                continue
            if symbol in self.loops:
                found |= set(self.loops[symbol].states)
                left += self.loops[symbol].free_symbols
                continue
            if symbol not in exprs:
                continue
            found.add(symbol)
            expr = exprs[symbol]
            heavy = isinstance(expr, Piecewise) and self._heavy(expr, done)
            left += _free(parted(expr)[0] if heavy else expr)
        return found

    def _heavy(self, expr: Piecewise, done: set[Symbol]) -> bool:
        """Whether a choice has work in it: steps of its own, or calls."""
        _, yes, no = parted(expr)
        return any(map(_calls, (yes, no))) or (
            self._closure((yes,), done) != self._closure((no,), done)
        )

    def _branches(self, expr: Expr, there: set[Symbol]) -> bool:
        """Whether a choice that is worth a branch has steps that are not done anyway."""
        if not isinstance(expr, Piecewise):
            return False
        _, yes, no = parted(expr)
        own = self._closure((yes, no), there)
        calls = any(map(_calls, (yes, no)))
        return bool(own) or calls


@cache
def _free(expr: Expr) -> frozenset[Symbol]:
    """Its symbols, looked for once."""
    return frozenset(expr.free_symbols)


@cache
def _calls(expr: Expr) -> bool:
    """Whether a function of ours or of the library is in it."""
    return bool(expr.atoms(Function) - expr.atoms(Piecewise, sp.Abs))


def _chosen_alike(results: tuple[Expr, ...]) -> bool:
    """Whether all results choose by the same condition first."""
    return all(isinstance(r, Piecewise) for r in results) and (
        len({parted(r)[0] for r in results}) == 1
    )


def _decided(condition: Boolean, value: Boolean) -> Facts:
    return {condition: value, sp.Not(condition): sp.Not(value)}


def parted(expr: Piecewise) -> tuple[Boolean, Expr, Expr]:
    """The first condition of a choice, the value there, and what holds else."""
    (yes, condition), *others = expr.args
    return condition, yes, (Piecewise(*others) if len(others) > 1 else others[0][0])


__all__ = [
    "ProductError",
    "Repeat",
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

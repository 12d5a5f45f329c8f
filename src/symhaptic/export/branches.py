"""The order of work: a routine as blocks of statements, some with blocks inside.

Each step is done only where its value is used, so that what a condition rules out costs nothing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from types import MappingProxyType

import sympy as sp
from sympy import Expr, Function, Piecewise, Symbol
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from symhaptic.export.routine import (
    Repeat,
    Routine,
    Search,
    Several,
    names,
    plain,
    replaced,
    with_divisors,
)


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

    results: tuple[sp.Basic, ...]


Statement = Assign | Repeat | Several | Search | Choice | Join | Set | Return
Block = tuple[Statement, ...]


def expressions(statement: Statement) -> tuple[Expr, ...]:
    """What a statement computes itself, the conditions of a choice included."""
    if isinstance(statement, (Assign, Set)):
        return (statement.expr,)
    if isinstance(statement, Repeat):
        return statement.start
    if isinstance(statement, Several):
        return (statement.call,)
    if isinstance(statement, Search):
        return statement.low, statement.high
    return statement.results if isinstance(statement, Return) else (statement.condition,)


def direct(block: Block) -> Block:
    """The same without second names: of what has one, and of what is only set or returned."""
    found: list[Statement] = []
    same: dict[Symbol, Expr] = {}
    for statement in (_replaced(s, same) for s in block):
        if isinstance(statement, Assign) and statement.expr.is_Symbol:
            same[statement.name] = statement.expr
        else:
            found.append(statement)
    last = {s.expr for s in found if isinstance(s, Set)}
    if found and isinstance(found[-1], Return):
        last |= set(found[-1].results)
    uses = _uses(found)
    once = {s.name: s.expr for s in found if isinstance(s, Assign) and s.name in last
            and uses[s.name] == 1}  # fmt: skip
    found = [
        _replaced(s, once) if isinstance(s, (Set, Return)) else s
        for s in found
        if not isinstance(s, Assign) or s.name not in once
    ]
    given = _given(found)
    return tuple(
        _replaced(s, given) if isinstance(s, (Assign, Set, Return, Several)) else s
        for s in found
        if not isinstance(s, Assign) or s.name not in given
    )


_SHORT = 4
"""Operations of what needs no name, where it is only given to a routine."""


def _given(block: list[Statement]) -> dict[Symbol, Expr]:
    """What is short and nothing but an argument of one call, once."""
    own = {s.name: s.expr for s in block if isinstance(s, Assign)}
    count, alone = Counter[Symbol](), Counter[Symbol]()
    for statement in block:
        plain = isinstance(statement, (Assign, Set, Return, Several))
        exprs = expressions(statement) if plain else ()
        if not plain:
            count.update(dict.fromkeys(inputs((statement,)), 2))
        for part in (p for expr in exprs for p in sp.preorder_traversal(expr)):
            if part.is_Symbol:
                count[part] += 1
            elif isinstance(part, AppliedUndef):
                alone.update(a for a in part.args if a.is_Symbol)
    found: dict[Symbol, Expr] = {}
    for name, expr in own.items():
        brief = not expr.has(sp.Piecewise) and sp.count_ops(expr) <= _SHORT
        if brief and count[name] == alone[name] == 1:
            found[name] = expr.xreplace(found)
    return found


def _uses(block: Iterable[Statement]) -> Counter[Symbol]:
    """How often each name is read, at least; more than once where that is inside of something."""
    count: Counter[Symbol] = Counter()
    for statement in block:
        if isinstance(statement, (Set, Return)):
            for expr in expressions(statement):
                for name in expr.free_symbols:
                    count[name] += 1 if expr == name else 2
        else:
            for name in inputs((statement,)):
                count[name] += 2
    return count


def _replaced(statement: Statement, known: Mapping[Symbol, Expr]) -> Statement:
    """With other names, and as direct inside."""
    found: Statement = replaced(statement, known)
    if isinstance(found, (Choice, Join)):
        return replace(found, yes=direct(found.yes), no=direct(found.no))
    return found


def functional(block: Block, known: Mapping[Symbol, Expr] = MappingProxyType({})) -> Block:
    """The same with sides that return the values of the names that are set in them.

    A name of a mere number is replaced by it: what it is given to takes arrays; and one that is
    only set, as nothing comes behind that but the end.
    """
    known = dict(known)
    found: list[Statement] = []
    for statement in block:
        if isinstance(statement, (Assign, Set)):
            value = statement.expr.xreplace(known)
            if value.is_number or isinstance(statement, Set):
                known[statement.name] = value
            else:
                found.append(Assign(statement.name, value))
        elif isinstance(statement, Join):
            names = statement.names or _set_in(statement.yes)
            yes, no = (
                functional((*side, Return(names)), known) for side in (statement.yes, statement.no)
            )
            found.append(Join(names, statement.condition.xreplace(known), yes, no))
        elif isinstance(statement, Choice):
            sides = (functional(side, known) for side in (statement.yes, statement.no))
            found.append(Choice(statement.condition.xreplace(known), *sides))
        else:
            found.append(replaced(statement, known))
    return tuple(found)


def _set_in(block: Block) -> tuple[Symbol, ...]:
    names: list[Symbol] = []
    for statement in block:
        if isinstance(statement, Set):
            names.append(statement.name)
        elif isinstance(statement, Join) and not statement.names:
            names += _set_in(statement.yes)
    return tuple(names)


def inputs(block: Block) -> list[Symbol]:
    """What a block needs to be given, by name."""
    needed: set[Symbol] = set()
    done: set[Symbol] = set()
    for statement in block:
        for expr in expressions(statement):
            needed |= expr.free_symbols - done
        if isinstance(statement, (Choice, Join)):
            needed |= {s for b in (statement.yes, statement.no) for s in inputs(b)} - done
        elif isinstance(statement, (Repeat, Search)):
            needed |= statement.free_symbols - done
        done |= set(made(statement))
    return sorted(needed, key=str)


def made(statement: Statement) -> tuple[Symbol, ...]:
    """The names that a statement makes known."""
    if isinstance(statement, Repeat):
        return statement.states
    if isinstance(statement, (Join, Several)):
        return statement.names
    return (statement.name,) if isinstance(statement, (Assign, Set, Search)) else ()


# -- The order of work: which steps of a routine are done in which branch ------------------------


@cache
def lazy(routine: Routine) -> Block:
    """The routine with each step done only where its value is used.

    Steps that choose by the same condition share one branch, and guards that the condition has
    decided are left out.  What is chosen again inside a branch has its own branches there, the
    cheapest question first; what all of them need is done before them.
    """
    routine = with_divisors(routine, lambda divisor: divisor.anywhere)
    return direct(_Lazy(routine).returned(tuple(e for _, e in routine.results), set(), {}))


def guarded(routine: Routine) -> Block:
    """The same; before it, what the results are where an argument is outside the domain.

    NaN makes every comparison false: what is asked is what is true inside, and never its opposite.
    """
    block = lazy(with_divisors(plain(routine), lambda divisor: divisor.args[0]))
    block = told(block) if routine.truth else block
    if not routine.within:
        return block
    outside = sp.Not(sp.And(*routine.within), evaluate=False)
    return (Choice(outside, (Return((routine.outside,) * len(routine.results)),), block),)


def told(block: Block) -> Block:
    """A block with a truth value in place of its result: true where that is positive."""
    *before, last = block
    if isinstance(last, Choice):
        return (*before, Choice(last.condition, told(last.yes), told(last.no)))
    return (*before, Return(tuple(sp.Gt(r, 0) for r in expressions(last))))


Facts = dict[Expr, Boolean]

_FEW = 12
"""Operations that cost no more than a branch."""


class _Lazy:
    """Puts steps into the branches that need them."""

    def __init__(self, routine: Routine) -> None:
        self.known = dict(step for step in routine.steps if isinstance(step, tuple))
        self.several = {s: r for r in routine.steps if not isinstance(r, tuple) for s in names(r)}
        conditions = (c for e in routine.expressions for c in e.atoms(sp.StrictLessThan))
        self.limits = {c for c in conditions if c.rhs.is_number}
        self.order = {name: i for i, step in enumerate(routine.steps) for name in names(step)}
        self.cheap: dict[Expr, bool] = {}
        # what each step needs directly: of several results, the others too
        self.below = {s: _free(e) & self.order.keys() for s, e in self.known.items()}
        self.below |= {
            s: (r.free_symbols | set(names(r))) & self.order.keys() for s, r in self.several.items()
        }

    def returned(self, results: tuple[Expr, ...], done: set[Symbol], facts: Facts) -> Block:
        """What leads to the results and returns them."""
        results = tuple(e.xreplace(facts) for e in results)
        if not _chosen_alike(results):
            steps, _ = self._steps([s for e in results for s in _free(e)], done, facts)
            return (*steps, Return(results))
        condition = next(parted(r)[0] for r in results if isinstance(r, Piecewise))
        sides = [[_side(r, condition, side) for r in results] for side in (1, 2)]
        common = self._common(condition, sides, done, facts)
        steps, done = self._steps((condition, *common), done, facts)
        yes, no = (
            self.returned(tuple(side), done, facts | self._decided(condition, value))
            for side, value in zip(sides, (sp.true, sp.false), strict=True)
        )
        return (*steps, Choice(condition, yes, no))

    def _common(
        self, condition: Boolean, sides: Iterable[list[Expr]], done: set[Symbol], facts: Facts
    ) -> set[Symbol]:
        """Steps that both sides of a choice need whatever they choose in their turn.

        No call for several results is put before one that stays behind the choice.
        """
        needs: list[set[Symbol]] = []
        for side in sides:
            closure = self._closure(side, done)
            exprs = {s: self.known[s].xreplace(facts) for s in closure if s in self.known}
            needs.append(self._always(side, exprs, done))
        both = set.intersection(*needs)
        both -= self._asking(both, condition, done)
        left = set.union(*needs) - both
        first = min((self.order[s] for s in left if s in self.several), default=len(self.order))
        late = {s for s in both if s in self.several and self.order[s] > first}
        return {s for s in both if not self._closure((s,), done) & late}

    def _works(self, step: Symbol) -> bool:
        """Whether it is more than a few operations."""
        return step in self.several or _calls(self.known[step])

    def _steps(
        self, wanted: Iterable[Expr], done: set[Symbol], facts: Facts
    ) -> tuple[Block, set[Symbol]]:
        """All steps that the expressions always need, and what is done then."""
        needed = self._closure(wanted, done)
        exprs = {s: self.known[s].xreplace(facts) for s in needed if s in self.known}
        always = self._always(wanted, exprs, done)
        left = sorted(always, key=self.order.__getitem__)
        written: list[Statement] = []
        done = set(done)
        while left:
            several = [self.several[s] for s in left if s in self.several]
            ready = [r for r in several if not r.free_symbols & set(left)]
            if ready:
                written.append(replaced(ready[0], facts))
                left = [s for s in left if s not in names(ready[0])]
                done |= set(names(ready[0]))
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
                          facts | self._decided(condition, value))
                for side, value in ((1, sp.true), (2, sp.false))
            )  # fmt: skip
            written.append(Join(together, condition, yes, no))
            left = [s for s in left if s not in together]
            done |= set(together)
        return tuple(written), done

    def _arm(self, values: list[tuple[Symbol, Expr]], done: set[Symbol], facts: Facts) -> Block:
        """One side of a join; values that choose again have their own sides in it."""
        values = [(s, e.xreplace(facts)) for s, e in values]
        conditions = [parted(e)[0] for _, e in values
                      if isinstance(e, Piecewise) and self._heavy(e, done)]  # fmt: skip
        cheap = (c for c in conditions if not self._costs(c, done))
        condition = next(cheap, None)
        wanted = [e for _, e in values] if condition is None else [condition]
        steps, done = self._steps(wanted, done, facts)
        if not conditions:
            return (*steps, *(Set(s, e) for s, e in values))
        if condition is None:
            condition = conditions[0]
        sides = (
            self._arm([(s, _side(e, condition, side)) for s, e in values], done,
                      facts | self._decided(condition, value))
            for side, value in ((1, sp.true), (2, sp.false))
        )  # fmt: skip
        return (*steps, Join((), condition, *sides))

    def _costs(self, condition: Boolean, done: set[Symbol]) -> bool:
        """Whether it takes a call to find out."""
        steps = self._closure((condition,), done)
        return any(map(self._works, steps))

    def _closure(self, wanted: Iterable[Expr], done: set[Symbol]) -> set[Symbol]:
        """Steps that the expressions may need."""
        found: set[Symbol] = set()
        left = set().union(*map(_free, wanted)) & self.order.keys()
        while left := left - found - done:
            found |= left
            left = set().union(*(self.below[s] for s in left))
        return found

    def _always(
        self, wanted: Iterable[Expr], exprs: dict[Symbol, Expr], done: set[Symbol]
    ) -> set[Symbol]:
        """Steps that the expressions need whichever branch is taken inside them."""
        sides: dict[Expr, set[Symbol]] = {}

        def both(choice: Piecewise) -> set[Symbol]:
            """What both sides of a choice need, but for what the choice itself decides."""
            if choice not in sides:
                condition, *arms = parted(choice)
                yes, no = (needs([arm]) for arm in arms)
                sides[choice] = (yes & no) - self._asking(yes & no, condition, done)
            return sides[choice]

        def needs(left: list[Expr]) -> set[Symbol]:
            found: set[Symbol] = set()
            while left:
                expr = left.pop()
                if isinstance(expr, Piecewise) and (expr in sides or self._heavy(expr, done)):
                    left.append(parted(expr)[0])
                    left += both(expr) - found
                    continue
                for symbol in _free(expr) - done - found:
                    if symbol in self.several:
                        found |= set(names(self.several[symbol]))
                        left += self.several[symbol].free_symbols
                    elif symbol in exprs:
                        found.add(symbol)
                        left.append(exprs[symbol])
            return found

        return needs(list(wanted))

    def _asking(self, steps: set[Symbol], condition: Boolean, done: set[Symbol]) -> set[Symbol]:
        """Those of the steps that are others where the condition is decided."""
        asking: set[Symbol] = set()
        for s in sorted(self._closure(steps, done), key=self.order.__getitem__):
            expr = self.known.get(s)
            if expr is not None and (
                (isinstance(expr, Piecewise) and parted(expr)[0] == condition)
                or not asking.isdisjoint(_free(expr))
            ):
                asking.add(s)
        return asking

    def _decided(self, condition: Boolean, value: Boolean) -> Facts:
        """What a condition decides: its opposite, and lower or higher limits of the same number."""
        facts = {condition: value, sp.Not(condition): sp.Not(value)}
        for other in self.limits if isinstance(condition, sp.StrictLessThan) else ():
            if other.lhs == condition.lhs and (other.rhs >= condition.rhs) == value:
                facts |= {other: value, sp.Not(other): sp.Not(value)}
        if value == sp.false and condition in self.limits and condition.rhs > 0:
            (size,) = condition.lhs.args if isinstance(condition.lhs, sp.Abs) else [condition.lhs]
            facts[sp.Eq(size, 0)] = sp.false
        return facts

    def _heavy(self, expr: Piecewise, done: set[Symbol]) -> bool:
        """Whether a choice has work in it: steps of its own, or calls."""
        _, yes, no = parted(expr)
        return any(map(_calls, (yes, no))) or (
            self._closure((yes,), done) != self._closure((no,), done) and not self._cheap(expr)
        )

    def _branches(self, expr: Expr, there: set[Symbol]) -> bool:
        """Whether a choice that is worth a branch has steps that are not done anyway."""
        if not isinstance(expr, Piecewise):
            return False
        _, yes, no = parted(expr)
        own = self._closure((yes, no), there)
        return any(map(_calls, (yes, no))) or (bool(own) and not self._cheap(expr))

    def _cheap(self, expr: Piecewise) -> bool:
        """Whether the steps that one side alone needs cost no more than a branch."""
        if expr not in self.cheap:
            _, yes, no = parted(expr)
            own = self._closure((yes,), set()) ^ self._closure((no,), set())
            self.cheap[expr] = not any(map(self._works, own)) and (
                sum(_operations(self.known[s]) for s in own) <= _FEW
            )
        return self.cheap[expr]


@cache
def _operations(expr: Expr) -> int:
    """How many a step takes."""
    return int(sp.count_ops(expr))


@cache
def _free(expr: Expr) -> frozenset[Symbol]:
    """Its symbols, looked for once."""
    return frozenset(expr.free_symbols)


@cache
def _calls(expr: Expr) -> bool:
    """Whether a function of ours or of the library is in it."""
    return bool(expr.atoms(Function) - expr.atoms(Piecewise, sp.Abs))


def _chosen_alike(results: tuple[Expr, ...]) -> bool:
    """Whether all results but mere numbers choose by the same condition first."""
    return all(isinstance(r, Piecewise) or r.is_number for r in results) and (
        len({parted(r)[0] for r in results if isinstance(r, Piecewise)}) == 1
    )


def _side(expr: Expr, condition: Boolean, side: int) -> Expr:
    """A choice by this condition on one side of it; anything else as it is."""
    asks = isinstance(expr, Piecewise) and parted(expr)[0] == condition
    return parted(expr)[side] if asks else expr


@cache
def parted(expr: Piecewise) -> tuple[Boolean, Expr, Expr]:
    """The first condition of a choice, the value there, and what holds else."""
    (yes, condition), *others = expr.args
    return condition, yes, (Piecewise(*others) if len(others) > 1 else others[0][0])

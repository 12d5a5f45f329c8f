"""What a routine's order of work is made of: blocks of statements, some with blocks inside."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from symhaptic.export.routine import Repeat, Search, Several


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
    if isinstance(statement, Assign):
        return Assign(statement.name, statement.expr.xreplace(known))
    if isinstance(statement, Set):
        return Set(statement.name, statement.expr.xreplace(known))
    if isinstance(statement, Return):
        return Return(tuple(r.xreplace(known) for r in statement.results))
    if isinstance(statement, (Repeat, Several, Search)):
        return statement.xreplace(known)
    yes, no = (direct(tuple(_replaced(s, known) for s in b)) for b in (statement.yes, statement.no))
    return replace(statement, condition=statement.condition.xreplace(known), yes=yes, no=no)


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
        elif isinstance(statement, Return):
            found.append(Return(tuple(r.xreplace(known) for r in statement.results)))
        else:
            found.append(statement.xreplace(known))
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

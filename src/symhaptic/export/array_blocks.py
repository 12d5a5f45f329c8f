"""What a block of statements is looked through for before functions of arrays are written."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import sympy as sp
from sympy import Expr, Piecewise, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.export.blocks import Assign, Block, Return, expressions, inputs
from symhaptic.export.printing import calls
from symhaptic.export.routine import Routine, Search, Several, TwoProdError

Products = dict[object, Symbol]
"""The names of products and squares, by their factors."""


def products(block: Block) -> Products:
    """Those that have a name in a block."""
    return {
        frozenset(s.expr.args) if s.expr.is_Mul else s.expr: s.name
        for s in block
        if isinstance(s, Assign) and (s.expr.is_Mul or s.expr.is_Pow)
    }


def product(known: Products, one: Expr, two: Expr) -> Symbol | None:
    """The name of a product, if it has one."""
    return known.get(one**2 if one == two else frozenset((one, two)))


def base(symbol: Symbol) -> str:
    """Its name without a number at the end."""
    return str(symbol.name).rstrip("0123456789")


def alone_of_their_kind(block: Block) -> list[Symbol]:
    """Variables that are numbered, but not to tell them from others of the block."""
    own = {s.name for s in block if isinstance(s, Assign)}
    own |= {name for s in block if isinstance(s, Several) for name in s.names}
    kinds = Counter(map(base, own | set(inputs(block))))
    return [s for s in own if s.name[len(base(s)) :] not in ("", "0", "1") and kinds[base(s)] == 1]


def factors(block: Block) -> Counter[Expr]:
    """How often each is a factor of a product of which something is missed."""
    shown = (expr for statement in block for expr in expressions(statement))
    return Counter(
        factor
        for expr in shown
        for part in sp.preorder_traversal(expr)
        if isinstance(part, TwoProdError)
        for factor in part.args
    )


def last_uses(block: Block, known: Products, handed: Mapping[int, int]) -> dict[int, list[Symbol]]:
    """For each statement, the variables of the block that are used there for the last time.

    Their names are free for the next ones of the same kind, and so is their memory.
    """
    own = {s.name for s in block if isinstance(s, Assign)}
    own |= {name for s in block if isinstance(s, Several) for name in s.names}
    last: dict[Symbol, int] = {}
    for i, statement in enumerate(block):
        used = set(inputs((statement,)))
        for expr in expressions(statement):
            for error in expr.atoms(TwoProdError):
                if name := product(known, *error.args):
                    used.add(name)
        last |= dict.fromkeys(sorted(used & own, key=str), _place(i, handed))
    found: dict[int, list[Symbol]] = {}
    for symbol, i in last.items():
        found.setdefault(i, []).append(symbol)
    return found


def _place(i: int, handed: Mapping[int, int]) -> int:
    """The statement that a statement is written in."""
    while i in handed:
        i = handed[i]
    return i


def handed_on(block: Block) -> dict[int, int]:
    """Calls whose two results are arguments side by side of one other call, and nothing else.

    By their places in the block, and that of the statement with the other call.
    """
    uses: Counter[Symbol] = Counter()
    users: dict[tuple[Expr, ...], int] = {}
    for i, statement in enumerate(block):
        shown = expressions(statement)
        for symbol in inputs((statement,)):
            uses[symbol] += not any(e.has(symbol) for e in shown)
        for part in (p for expr in shown for p in sp.preorder_traversal(expr)):
            if part.is_Symbol:
                uses[part] += 1
            elif isinstance(part, AppliedUndef):
                users |= dict.fromkeys(zip(part.args, part.args[1:], strict=False), i)
    return {
        i: users[s.names]
        for i, s in enumerate(block)
        if isinstance(s, Several) and s.names in users and all(uses[n] == 1 for n in s.names)
    }


def variables(expr: Expr, block: Block, handed: Mapping[int, int]) -> set[Symbol]:
    """Those of a call, and of calls whose results it is handed."""
    found: set[Symbol] = set()
    inner = {
        name: s.call
        for i, s in enumerate(block)
        if isinstance(s, Several) and i in handed
        for name in s.names
    }
    for symbol in expr.free_symbols:
        found |= variables(inner[symbol], block, handed) if symbol in inner else {symbol}
    return found


def repeated_conditions(block: Block) -> set[Expr]:
    """Conditions that occur more than once."""
    count: dict[Expr, int] = {}
    for statement in block:
        for expr in expressions(statement):
            for part in sp.preorder_traversal(expr):
                if isinstance(part, Piecewise):
                    for _, condition in part.args[:-1]:
                        count[condition] = count.get(condition, 0) + 1
    return {condition for condition, times in count.items() if times > 1}


def mere_call(block: Block) -> Expr | None:
    """The call that a block returns, if it does nothing else and all arguments are variables."""
    first = block[0]
    if not isinstance(first, Return) or len(first.results) > 1:
        return None
    (call,) = first.results
    alone = isinstance(call, AppliedUndef) or type(call).__module__.startswith("symhaptic.forms")
    return call if alone and all(a.is_Symbol for a in call.args) else None


def lone_expression(block: Block) -> Expr | None:
    """The one expression of a block that is nothing else, calls nothing and is defined always."""
    first = block[0]
    if not isinstance(first, Return) or len(first.results) > 1:
        return None
    (only,) = first.results
    if any(not power.exp.is_Integer or power.exp < 0 for power in only.atoms(sp.Pow)):
        return None
    return None if calls(Routine("", "", (), (), (("", only),))) else only


def ends_with_search(block: Block) -> bool:
    """Whether all that is left is what a search finds."""
    *before, last = block
    searched = before and isinstance(before[-1], Search) and before[-1].name
    return isinstance(last, Return) and last.results == (searched,)

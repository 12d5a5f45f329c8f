"""What may stand in a proposition: inert trees, which nothing evaluates.

An author writes a term as a SymPy expression.  The kernel reads it once, as a :class:`Term`: a head
and arguments, sums and products without order and without brackets.  Symbols are replaced in the
tree, so that nothing cancels.  SymPy sees a term only where a decider is asked about it, and where
it is printed.

A symbol stands for a real number, unless :mod:`symhaptic.notation` says that it is complex.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from math import gcd
from numbers import Number
from operator import attrgetter
from typing import Any, TypeAlias

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef, UndefinedFunction

from symhaptic.notation import SYMBOLS

FUNCTIONS = (
    *(sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.atan),
    *(sp.Abs, sp.re, sp.im, sp.conjugate),
)
"""The functions that a term may be made of, beside sums, products, powers and unknown ones."""

Head: TypeAlias = Any
"""A class of SymPy's for a sum, a product, a power or a function; the name of an unknown function;
or, of what has no arguments, the number, the constant or the symbol itself."""


class NoTerm(TypeError):
    """Something that is no term of the language, or no proposition; the message is one line."""


class Term:
    """An immutable tree; two that have the same parts are one object."""

    __slots__ = ("__dict__", "args", "free", "head", "number")

    head: Head
    args: tuple[Term, ...]
    free: frozenset[Symbol]
    number: int
    """How many trees were made before it; the order of a sum's and a product's arguments."""

    def __new__(cls, head: Head, args: tuple[Term, ...] = ()) -> Term:
        """Find the tree with this head and these arguments, or make it."""
        if head is sp.Add or head is sp.Mul:
            flat = (p for a in args for p in (a.args if a.head is head else (a,)))
            args = tuple(sorted(flat, key=_number))
        found = _MADE.get((head, args))
        if found is None:
            found = _MADE[head, args] = object.__new__(cls)
            found.head, found.args, found.number = head, args, len(_MADE)
            own = frozenset((head,)) if isinstance(head, Symbol) else frozenset[Symbol]()
            found.free = own.union(*(a.free for a in args))
        return found

    def inst(self, values: Mapping[Symbol, Term]) -> Term:
        """The tree with others in place of symbols; nothing else changes."""
        return self._inst(values, frozenset(values), {})

    def _inst(
        self, values: Mapping[Symbol, Term], symbols: frozenset[Symbol], done: dict[Term, Term]
    ) -> Term:
        if symbols.isdisjoint(self.free):
            return self
        if not self.args:
            return values[self.head]
        if self not in done:
            done[self] = Term(self.head, tuple(a._inst(values, symbols, done) for a in self.args))
        return done[self]

    @cached_property
    def sympy(self) -> Expr:
        """The term as SymPy writes it, evaluated; it has its value wherever the term has one."""
        if not self.args:
            return self.head
        args = [a.sympy for a in self.args]
        if isinstance(self.head, str):
            return sp.Function(self.head)(*args)
        return self.head(*args)

    @cached_property
    def evaluated(self) -> Term | None:
        """The tree of what SymPy writes; None if that is no term, as of 1/0."""
        try:
            return tree(self.sympy)
        except NoTerm:
            return None

    @cached_property
    def shown(self) -> Expr:
        """An expression that reads as just this tree, for people and printers."""
        if not self.args or self.evaluated is self:
            return self.sympy
        args = [a.shown for a in self.args]
        if isinstance(self.head, str):
            return sp.Function(self.head)(*args)
        if self.head is sp.Add or self.head is sp.Mul:
            args.sort(key=sp.default_sort_key)
        return self.head(*args, evaluate=False)

    def walk(self) -> Iterator[Term]:
        """All parts of the tree, itself first; a part that stands twice is met once."""
        seen, left = {self}, [self]
        while left:
            part = left.pop()
            yield part
            new = [a for a in part.args if a not in seen]
            seen.update(new)
            left += new

    def __repr__(self) -> str:
        return f"Term({self.shown})"

    def __reduce__(self) -> Any:
        return tree, (self.shown,)


_number = attrgetter("number")


def _branch_by_decimals(base: Expr, exponent: Expr) -> bool:
    """Whether SymPy would find by decimals on which side of a cut a power of a number lies."""
    if exponent.is_Integer or base.is_extended_real:
        return False
    return any(isinstance(f, (sp.Pow, sp.exp)) for f in sp.Mul.make_args(base))


_MADE: dict[tuple[Head, tuple[Term, ...]], Term] = {}
_READ: dict[Expr, tuple[Expr, Term]] = {}
"""What was read last of all expressions that are equal, and its tree."""

_NODES = frozenset({sp.Add, sp.Mul, sp.Pow, *FUNCTIONS})
_RATIONALS = frozenset({sp.Rational, sp.Integer, *map(type, (sp.S.Half, *map(sp.S, (-1, 0, 1))))})
_CONSTANTS = frozenset({sp.I, sp.pi})
_PLAIN = Symbol("x").assumptions0


def tree(of: Expr) -> Term:
    """Read an expression as a tree; raise :class:`NoTerm` for what is no term.

    An object that only says that it is equal to one that was read is read itself.
    """
    found = _READ.get(of)
    if found is None or found[0] is not of:
        found = _READ[of] = of, _read(of)
    return found[1]


def _read(of: Expr) -> Term:
    kind = type(of)
    if kind in _NODES:
        if kind in FUNCTIONS and len(of.args) != 1:
            raise NoTerm(f"{of} is a function of {len(of.args)} arguments, not of one")
        args = tuple(map(tree, of.args))
        if kind is sp.Pow and not args[0].free and _branch_by_decimals(args[0].sympy, of.args[1]):
            raise NoTerm(f"SymPy may find the branch of {of} by decimals, and take the wrong one")
        return Term(kind, args)
    if kind in _RATIONALS:
        if gcd(of.p, of.q) != 1 or of.q < 1:
            raise NoTerm(f"{of} is not in lowest terms")
        return Term(of)
    if of is sp.E:
        return Term(sp.exp, (Term(sp.S.One),))
    if of in _CONSTANTS:
        return Term(of)
    if isinstance(of, Symbol):
        # an assumption would change what SymPy makes of an expression without saying so
        if kind not in (Symbol, sp.Dummy) or of.assumptions0 != _PLAIN:
            raise NoTerm(f"the symbol {of} carries assumptions; hypotheses say them here")
        return Term(of)
    if isinstance(kind, UndefinedFunction) and kind.__bases__ == (AppliedUndef,):
        if set(kind._kwargs) - set(_PLAIN):
            raise NoTerm(f"the function {of.func} carries assumptions; hypotheses say them here")
        return Term(of.func.__name__, tuple(map(tree, of.args)))
    raise NoTerm(f"{of} ({kind.__name__}) is no part of a term")


def term(of: Any) -> Expr:
    """An exact expression that can be read as a term; text and floats are refused."""
    if isinstance(of, Expr):
        expr = of
    elif isinstance(of, Number) and not isinstance(of, (float, complex, bool)):
        expr = sp.sympify(of, strict=True)
    else:
        raise NoTerm(f"{of!r} is no term; an exact SymPy expression is")
    if not isinstance(expr, Expr):
        raise NoTerm(f"{expr!r} is no term; a SymPy expression is")
    tree(expr)
    return expr


def symbols_in(expr: Expr) -> frozenset[Symbol]:
    """The free symbols of an expression."""
    found = _READ.get(expr)
    return frozenset(expr.free_symbols) if found is None else found[1].free


def without_value(number: Expr) -> bool:
    """Whether SymPy met a division by zero; to be asked of numbers, since 0^x may have a value."""
    return bool(number.has(sp.zoo, sp.nan, sp.oo, -sp.oo))


def is_complex(symbol: Expr) -> bool:
    """Whether a symbol stands for a complex number."""
    known = SYMBOLS.get(symbol.name)
    return known is not None and known.domain == "complex"

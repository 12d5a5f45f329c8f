"""The language of propositions: relations of terms, logic, quantifiers and a few named predicates.

A term is an inert tree (:mod:`symhaptic.notation.terms`), typed as a SymPy expression.  A symbol
stands for a real number, unless :mod:`symhaptic.notation` says that it is complex.  A relation is
true where both sides are defined and it holds between their values; an order relation also says
that both are real.  So ``Not(a < b)`` is true where a side has no value, and ``b <= a`` is not.  A
predicate, too, is true only where its terms have values.

Propositions that differ in the names of bound symbols only are equal.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from functools import cache, cached_property
from typing import Any, ClassVar, TypeAlias

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.fresh import fresh
from symhaptic.notation.predicates import MEANINGS
from symhaptic.notation.terms import NoTerm, Term, is_complex, term, tree, without_value

Terms: TypeAlias = Mapping[Symbol, Expr]

SIGNS = ("=", "!=", "<", "<=")


def _bindable(symbols: Iterable[Symbol]) -> None:
    """Raise :class:`NoTerm` of what is no plain symbol, and cannot be bound."""
    for symbol in symbols:
        if not term(symbol).is_Symbol:
            raise NoTerm(f"{symbol} is no symbol that could be bound")


class Proposition:
    """Something that is true or false once its free symbols have values."""

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Proposition) and self._key == other._key)

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash(self._key)

    @cached_property
    def _key(self) -> tuple[Any, ...]:
        """What equal propositions share: their trees, with bound symbols by the place where they
        are bound."""
        return self._keyed({}, 0)

    def _keyed(self, bound: Mapping[Symbol, Term], depth: int) -> tuple[Any, ...]:
        own = tuple(getattr(self, name) for name in _own(type(self)))  # type: ignore[arg-type]
        kinds = tuple(map(is_complex, self.bound))
        if self.bound:
            places = {s: _place(depth + i) for i, s in enumerate(self.bound)}
            bound, depth = {**bound, **places}, depth + len(places)
        trees = tuple(t.inst(bound) for t in self.trees) if bound else self.trees
        # a part of its own counts its places from 0, and is marked lest they be taken for others
        parts = (p._keyed(bound, depth) if bound.keys() & p.free else (p._key,) for p in self.parts)
        return (type(self).__name__, own, kinds, trees, *parts)

    def __reduce__(self) -> tuple[type[Proposition], tuple[Any, ...]]:
        """Made anew where it arrives, of its fields alone."""
        kind: Any = type(self)
        return kind, tuple(getattr(self, name) for name in field_names(kind))

    @property
    def bound(self) -> tuple[Symbol, ...]:
        """Symbols that the proposition binds."""
        return ()

    @property
    def terms(self) -> tuple[Expr, ...]:
        """Terms that stand in it directly, as SymPy writes them."""
        return ()

    @cached_property
    def trees(self) -> tuple[Term, ...]:
        """The same as trees."""
        return tuple(map(tree, self.terms))

    @property
    def parts(self) -> tuple[Proposition, ...]:
        """Propositions that it is made of."""
        return ()

    def made(self, bound: tuple[Symbol, ...], terms: tuple[Expr, ...], parts: Any) -> Proposition:
        """The same with other symbols, terms and parts."""
        raise NotImplementedError

    @cached_property
    def free(self) -> frozenset[Symbol]:
        """Its free symbols."""
        below = (p.free for p in self.parts)
        inner = frozenset[Symbol]().union(*(t.free for t in self.trees), *below)
        return inner - frozenset(self.bound)

    def inst(self, values: Mapping[Symbol, Term]) -> Proposition:
        """With trees in place of free symbols; bound symbols give way, and nothing is evaluated."""
        values = {s: t for s, t in values.items() if s in self.free and t.head is not s}
        if not values:
            return self
        inner, bound = dict(values), self.bound
        if bound:
            met = frozenset[Symbol]().union(*(t.free for t in values.values()))
            apart = met.union(self.free, bound)
            inner |= {s: Term(fresh(apart, s.name)) for s in bound if s in met}
            bound = tuple(inner[s].head if s in inner else s for s in bound)
        terms = tuple(t.inst(inner).shown for t in self.trees)
        return self.made(bound, terms, tuple(p.inst(inner) for p in self.parts))

    def evaluated(self) -> Proposition:
        """With its terms as SymPy writes them; a relation between numbers of which one has no value
        is false."""
        kept = all(t.evaluated is t for t in self.trees)
        parts = tuple(p.evaluated() for p in self.parts)
        if kept and all(p is q for p, q in zip(parts, self.parts, strict=True)):
            return self
        return self.made(self.bound, self._written(), parts)

    def _written(self) -> tuple[Expr, ...]:
        """Its terms as SymPy writes them, as far as these are terms."""
        return tuple((t if t.evaluated is None else t.evaluated).shown for t in self.trees)

    def at(self, values: Terms) -> Proposition:
        """With terms in place of free symbols, as SymPy writes what comes out."""
        return self.inst({s: tree(term(v)) for s, v in values.items()}).evaluated()


@cache
def _place(depth: int) -> Term:
    """What stands for a symbol that is bound at this depth; no term of anybody has it."""
    return Term(("bound", depth))


@cache
def field_names(kind: type[Any]) -> tuple[str, ...]:
    """What a kind of proposition is made of."""
    return tuple(field.name for field in fields(kind))


@cache
def _own(kind: type[Any]) -> tuple[str, ...]:
    """The fields of a proposition that are text: its sign or its name."""
    return tuple(f.name for f in fields(kind) if f.type == "str")


@dataclass(frozen=True, eq=False)
class Relation(Proposition):
    """``left sign right``, with one of the four signs."""

    left: Expr
    sign: str
    right: Expr

    def __post_init__(self) -> None:
        if self.sign not in SIGNS:
            raise NoTerm(f"{self.sign!r} is no sign; one of {', '.join(SIGNS)} is")
        object.__setattr__(self, "left", term(self.left))
        object.__setattr__(self, "right", term(self.right))

    @property
    def terms(self) -> tuple[Expr, ...]:
        """Its two sides."""
        return self.left, self.right

    def made(self, bound: Any, terms: tuple[Expr, ...], parts: Any) -> Relation:
        """The same sign between other terms."""
        return Relation(terms[0], self.sign, terms[1])

    def evaluated(self) -> Proposition:
        """With its terms as SymPy writes them; false if one has no value, whatever the symbols."""
        if any(without_value(t.sympy) and not t.sympy.free_symbols for t in self.trees):
            return FALSE
        return super().evaluated()


@dataclass(frozen=True, eq=False)
class Predicate(Proposition):
    """A named predicate of terms; ``over`` are symbols bound in those terms.

    What each name means stands in :data:`symhaptic.notation.predicates.MEANINGS`.
    """

    name: str
    over: tuple[Symbol, ...]
    of: tuple[Expr, ...]

    def __post_init__(self) -> None:
        if self.name not in MEANINGS:
            raise NoTerm(f"{self.name!r} is no predicate; one of {', '.join(MEANINGS)} is")
        symbols, terms = MEANINGS[self.name][:2]
        if (len(self.over), len(self.of)) != (symbols, terms):
            raise NoTerm(f"{self.name} has {symbols} bound symbols and {terms} terms")
        object.__setattr__(self, "of", tuple(term(t) for t in self.of))
        object.__setattr__(self, "over", tuple(self.over))
        _bindable(self.over)
        for bounded in self.of[1:] if self.over else ():
            if not tree(bounded).free.isdisjoint(self.over):
                raise NoTerm(f"{self.name}: {bounded} holds a symbol that is bound")

    @property
    def bound(self) -> tuple[Symbol, ...]:
        """Symbols bound in its terms."""
        return self.over

    @property
    def terms(self) -> tuple[Expr, ...]:
        """What it is said of."""
        return self.of

    def made(self, bound: Any, terms: Any, parts: Any) -> Predicate:
        """The same predicate of other terms."""
        return Predicate(self.name, bound, terms)


@dataclass(frozen=True, eq=False)
class _Joined(Proposition):
    of: tuple[Proposition, ...]
    count: ClassVar[int | None] = None
    """How many parts it has; any number, without."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "of", tuple(self.of))
        if not all(type(part) in KINDS for part in self.of):
            raise NoTerm(f"{self.of} are no propositions that could be joined")
        if self.count not in (None, len(self.of)):
            raise NoTerm(f"{type(self).__name__} of {len(self.of)} parts; {self.count} are wanted")

    @property
    def parts(self) -> tuple[Proposition, ...]:
        return self.of

    def made(self, bound: Any, terms: Any, parts: Any) -> Proposition:
        return type(self)(parts)


class Not(_Joined):
    """The negation of its one part."""

    count = 1


class And(_Joined):
    """All its parts; without any, the truth."""


class Or(_Joined):
    """One of its parts at least; without any, falsehood."""


class Implies(_Joined):
    """The first of its two parts implies the second."""

    count = 2


class Iff(_Joined):
    """Its two parts hold together or not at all."""

    count = 2


@dataclass(frozen=True, eq=False)
class _Quantified(Proposition):
    over: tuple[Symbol, ...]
    body: Proposition

    def __post_init__(self) -> None:
        object.__setattr__(self, "over", tuple(self.over))
        if type(self.body) not in KINDS:
            raise NoTerm(f"{self.body!r} is no proposition that could be quantified")
        if not self.over or len(set(self.over)) < len(self.over):
            raise NoTerm(f"{self.over} are no symbols to quantify over")
        _bindable(self.over)

    @property
    def bound(self) -> tuple[Symbol, ...]:
        return self.over

    @property
    def parts(self) -> tuple[Proposition, ...]:
        return (self.body,)

    def made(self, bound: Any, terms: Any, parts: Any) -> Proposition:
        return type(self)(bound, parts[0])


class ForAll(_Quantified):
    """For all values of the symbols."""


class Exists(_Quantified):
    """For some values of the symbols."""


KINDS = frozenset({Relation, Predicate, Not, And, Or, Implies, Iff, ForAll, Exists})
"""All that there are; a class of one's own could say of itself that it is equal to anything."""

TRUE, FALSE = And(()), Or(())


def proposition(of: Any) -> Proposition:
    """A proposition from a SymPy relation, or one as it is.

    >>> x = sp.Symbol("x")
    >>> proposition(x > 0) == Relation(sp.S.Zero, "<", x)
    True
    """
    if isinstance(of, Proposition) and type(of) in KINDS:
        return of
    for kind, sign, turned in (
        (sp.Eq, "=", False),
        (sp.Ne, "!=", False),
        (sp.StrictLessThan, "<", False),
        (sp.LessThan, "<=", False),
        (sp.StrictGreaterThan, "<", True),
        (sp.GreaterThan, "<=", True),
    ):
        if isinstance(of, kind):
            left, right = (of.rhs, of.lhs) if turned else (of.lhs, of.rhs)
            return Relation(left, sign, right)
    raise NoTerm(f"{of!r} is no proposition; a relation is (one that SymPy has not decided)")


def conjuncts(of: Proposition) -> tuple[Proposition, ...]:
    """The parts of a conjunction, through all its levels; a proposition itself where it is none."""
    if not isinstance(of, And):
        return (of,)
    return tuple(c for part in of.parts for c in conjuncts(part))


def both(parts: Iterable[Any]) -> Proposition:
    """The conjunction of propositions; of one, that one."""
    found = tuple(proposition(p) for p in parts)
    return found[0] if len(found) == 1 else And(found)


def implied(given: Iterable[Any], then: Any) -> Proposition:
    """``then`` under the hypotheses ``given``; without any, itself."""
    found = tuple(proposition(p) for p in given)
    return Implies((both(found), proposition(then))) if found else proposition(then)


def negated(relation: Relation) -> Relation:
    """The relation that holds where both sides are defined (and real) and this one does not."""
    left, sign, right = relation.left, relation.sign, relation.right
    return {
        "=": Relation(left, "!=", right),
        "!=": Relation(left, "=", right),
        "<": Relation(right, "<=", left),
        "<=": Relation(right, "<", left),
    }[sign]


def whole(value: Any) -> Predicate:
    """``value`` is a whole number, zero included."""
    return Predicate("whole", (), (term(value),))

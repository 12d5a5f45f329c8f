"""The language of propositions: relations of terms, logic, quantifiers and a few named predicates.

A term is a SymPy expression.  A symbol stands for a real number, unless :mod:`symhaptic.notation`
says that it is complex.  A relation is true where both sides are defined and it holds between their
values; an order relation also says that both are real.  So ``Not(a < b)`` is true where a side has
no value, and ``b <= a`` is not.  A predicate, too, is true only where its terms have values.

Propositions that differ in the names of bound symbols only are equal.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from functools import cache, cached_property, lru_cache
from typing import Any, ClassVar, NoReturn, TypeAlias

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.predicates import MEANINGS
from symhaptic.notation.terms import PLACES, NoTerm, is_complex, symbols_in, term, without_value

Terms: TypeAlias = Mapping[Symbol, Expr]
Places: TypeAlias = Mapping[Symbol, Symbol]

SIGNS = ("=", "!=", "<", "<=")


def _bindable(symbols: Iterable[Symbol]) -> None:
    """Raise :class:`NoTerm` of what is no plain symbol, and cannot be bound."""
    for symbol in symbols:
        if not term(symbol).is_Symbol:
            raise NoTerm(f"{symbol} is no symbol that could be bound")


class Proposition:
    """Something that is true or false once its free symbols have values."""

    _closed: ClassVar[bool] = False

    def __init_subclass__(cls) -> None:
        if Proposition._closed:
            raise NoTerm(f"{cls.__name__} is no kind of proposition; those are known")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Proposition) and _alike(self, other, {}, {})

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash(_shared(self, frozenset()))

    def __reduce__(self) -> tuple[type[Proposition], tuple[Any, ...]]:
        """Made anew where it arrives, of its fields alone."""
        kind: Any = type(self)
        return kind, tuple(getattr(self, name) for name in field_names(kind))

    def __setstate__(self, state: object) -> NoReturn:
        raise NoTerm("a proposition does not change; it is made of its fields")

    @property
    def bound(self) -> tuple[Symbol, ...]:
        """Symbols that the proposition binds."""
        return ()

    @property
    def terms(self) -> tuple[Expr, ...]:
        """Terms that stand in it directly."""
        return ()

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
        inner = frozenset[Symbol]().union(*map(symbols_in, self.terms), *below)
        return inner - frozenset(self.bound)

    def at(self, values: Terms) -> Proposition:
        """With terms in place of free symbols; bound symbols give way."""
        values = {s: v for s, v in values.items() if s in self.free and s != v}
        if not values:
            return self
        inner, bound = dict(values), self.bound
        if bound:
            inner |= _renamed(bound, values)
            bound = tuple(inner.get(s, s) for s in bound)
        terms = replaced(self.terms, inner) if self.terms else ()
        return self.made(bound, terms, tuple(p.at(inner) for p in self.parts))

    def apart(self, values: Terms) -> Proposition:
        """The same, with other symbols for bound ones that stand in these terms."""
        if not (self.bound or self.parts):
            return self
        there = _renamed(self.bound, values)
        bound = tuple(there.get(s, s) for s in self.bound)
        parts = tuple(p.at(there).apart(values) for p in self.parts)
        return self.made(bound, replaced(self.terms, there), parts)


def _renamed(bound: Iterable[Symbol], values: Terms) -> dict[Symbol, Symbol]:
    """Other symbols for bound ones that stand in the terms to be put in."""
    met = frozenset[Symbol]().union(*(symbols_in(sp.sympify(v)) for v in values.values()))
    return {s: sp.Dummy(s.name) for s in bound if s in met}


def replaced(terms: tuple[Expr, ...], values: Terms) -> tuple[Expr, ...]:
    """The terms with others in place of symbols."""
    return _replaced(terms, frozenset((s, sp.sympify(v)) for s, v in values.items()))


@lru_cache(maxsize=1 << 15)
def _replaced(terms: tuple[Expr, ...], values: frozenset[tuple[Symbol, Expr]]) -> tuple[Expr, ...]:
    known, symbols = dict(values), frozenset(s for s, _ in values)
    return tuple(_put_in(t, known, symbols) for t in terms)


def _put_in(term: Expr, known: dict[Any, Expr], symbols: frozenset[Symbol]) -> Expr:
    """As ``xreplace``, which looks through parts without the symbols and twice through others."""
    if symbols.isdisjoint(symbols_in(term)):
        return term
    if term not in known:
        known[term] = term.func(*(_put_in(part, known, symbols) for part in term.args))
    return known[term]


_DEPTHS = {place: i for i, place in enumerate(PLACES)}


def _alike(one: Proposition, other: Proposition, here: Places, there: Places) -> bool:
    """Whether two propositions have the same parts, with bound symbols by their place."""
    if (
        type(one) is not type(other)
        or (len(one.bound), len(one.terms), len(one.parts))
        != (len(other.bound), len(other.terms), len(other.parts))
        or any(getattr(one, name) != getattr(other, name) for name in _own(type(one)))  # type: ignore[arg-type]
        or any(is_complex(s) != is_complex(r) for s, r in zip(one.bound, other.bound, strict=True))
    ):
        return False
    if one.bound:
        here, there = _placed(one, here), _placed(other, there)
    return all(_alike(p, q, here, there) for p, q in zip(one.parts, other.parts, strict=True)) and (
        all(_equal(t, u, here, there) for t, u in zip(one.terms, other.terms, strict=True))
    )


def _placed(of: Proposition, places: Places) -> Places:
    """Each bound symbol by the depth at which it is bound, which no other one inside shares."""
    depth = max((_DEPTHS[p] for p in places.values()), default=-1) + 1
    return {**places, **{s: PLACES[depth + i] for i, s in enumerate(of.bound)}}


def _equal(one: Expr, other: Expr, here: Places, there: Places) -> bool:
    if not here:
        return bool(one == other)
    if one == other and all(here.get(s) is there.get(s) for s in symbols_in(one)):
        return True
    return bool(one.xreplace(here) == other.xreplace(there))


def _shared(of: Proposition, bound: frozenset[Symbol]) -> tuple[Any, ...]:
    """What equal propositions share, whatever the names of their bound symbols."""
    bound = bound.union(of.bound)
    return (
        type(of).__name__,
        tuple(getattr(of, name) for name in _own(type(of))),  # type: ignore[arg-type]
        tuple(is_complex(s) for s in of.bound),
        tuple(None if symbols_in(t) & bound else t for t in of.terms),
        tuple(_shared(p, bound) for p in of.parts),
    )


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

    def made(self, bound: Any, terms: tuple[Expr, ...], parts: Any) -> Proposition:
        """The same sign between other terms; false between numbers of which one has no value."""
        if not any(map(symbols_in, terms)) and any(without_value(t) for t in terms):
            return FALSE
        return Relation(terms[0], self.sign, terms[1])


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
            if set(self.over) & bounded.free_symbols:
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
        if not all(isinstance(part, Proposition) for part in self.of):
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
        if not isinstance(self.body, Proposition):
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


Proposition._closed = True
TRUE, FALSE = And(()), Or(())


def proposition(of: Any) -> Proposition:
    """A proposition from a SymPy relation, or one as it is.

    >>> x = sp.Symbol("x")
    >>> proposition(x > 0) == Relation(sp.S.Zero, "<", x)
    True
    """
    if isinstance(of, Proposition):
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

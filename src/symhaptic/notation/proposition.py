"""The language of propositions: relations of terms, logic, quantifiers and a few named predicates.

A term is a SymPy expression.  A symbol stands for a real number, unless :mod:`symhaptic.notation`
says that it is complex.  A relation is true where both sides are defined and it holds between their
values; an order relation also says that both are real.  So ``Not(a < b)`` is true where a side has
no value, and ``b <= a`` is not.  A predicate, too, is true only where its terms have values.

Propositions that differ in the names of bound symbols only are equal.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, fields
from functools import cache, cached_property, lru_cache
from math import gcd
from numbers import Number
from typing import Any, NoReturn, TypeAlias

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef, UndefinedFunction

from symhaptic.notation import SYMBOLS
from symhaptic.notation.fresh import made_before, mark
from symhaptic.notation.predicates import MEANINGS

Terms: TypeAlias = Mapping[Symbol, Expr]
Places: TypeAlias = Mapping[Symbol, Symbol]

SIGNS = ("=", "!=", "<", "<=")

FUNCTIONS = (
    *(sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.atan),
    *(sp.Abs, sp.re, sp.im, sp.conjugate),
)
"""The functions that a term may be made of, beside sums, products, powers and unknown ones."""


class NoTerm(TypeError):
    """Something that is no term of the language, or no proposition; the message is one line."""


def term(of: Any) -> Expr:
    """A term: an exact, commutative expression in plain symbols.  Text is refused."""
    number = isinstance(of, Number) and not isinstance(of, (float, complex, bool))
    if not (number or isinstance(of, Expr)):
        raise NoTerm(f"{of!r} is no term; an exact SymPy expression is")
    expr = of if isinstance(of, Expr) else sp.sympify(of, strict=True)
    if not isinstance(expr, Expr):
        raise NoTerm(f"{expr!r} is no term; a SymPy expression is")
    _looked_through(expr)
    return expr


@lru_cache(maxsize=1 << 15)
def _looked_through(expr: Expr) -> None:
    """Raise :class:`NoTerm` of an expression that is none; of one that is, nothing."""
    left = [expr]
    while left:
        part = left.pop()
        if type(part) is sp.Rational:
            _check_lowest(part)
        elif type(part) not in _ATOMS:
            if type(part) not in _MADE:
                _check(part)
            elif type(part) in FUNCTIONS and len(part.args) != 1:
                raise NoTerm(f"{part} is a function of {len(part.args)} arguments, not of one")
            left += part.args[::-1]
    if not _lasting(expr):
        raise NoTerm(f"{expr} loses a divisor when SymPy writes it anew; write it without")


def _lasting(expr: Expr) -> bool:
    """Whether all that limits where a term has a value outlives its being written anew."""
    if not _limited(expr) or _as_it_stands(expr):
        return True
    limits = set(_limits(expr))
    there = {s: _other(s) for s in expr.free_symbols}
    if {limit.xreplace(there) for limit in limits} <= set(_limits(expr.xreplace(there))):
        return True
    back = {d: s for s, d in there.items()}

    def anew(part: Expr) -> Expr:
        return part.xreplace(there).xreplace(back)

    # other names may turn signs; in these names a divisor may have become several
    kept = set(_limits(anew(expr)))
    factors = (f for limit in limits for f in sp.Mul.make_args(anew(limit)))
    return all(
        f in kept or f.as_base_exp()[0] in kept or (f.is_Rational and f != 0) for f in factors
    )


@lru_cache(maxsize=1 << 16)
def _limited(part: Expr) -> bool:
    """Whether something in a term need not have a value."""
    return _may_have_none(part) or any(map(_limited, part.args))


@lru_cache(maxsize=1 << 16)
def _as_it_stands(part: Expr) -> bool:
    """Whether SymPy writes a term, and each part of it, as it stands: then under any names."""
    return not part.args or (all(map(_as_it_stands, part.args)) and part.func(*part.args) == part)


@lru_cache(maxsize=1 << 10)
def _other(symbol: Symbol) -> Symbol:
    """A symbol that stands for another one, always the same, of which SymPy then knows."""
    return sp.Dummy(symbol.name)


@lru_cache(maxsize=1 << 16)
def symbols_in(expr: Expr) -> frozenset[Symbol]:
    """The free symbols of a term."""
    if type(expr) in _MADE:
        return frozenset[Symbol]().union(*map(symbols_in, expr.args))
    return frozenset(expr.free_symbols)


def _limits(expr: Expr) -> Iterator[Expr]:
    """Bases of powers that need not have a value, and functions that need not."""
    for part in sp.preorder_traversal(expr):
        if _may_have_none(part):
            yield part.base if part.is_Pow else part


def _may_have_none(part: Expr) -> bool:
    """Whether a power or a function need not have a value where its arguments have."""
    if part.is_Pow:
        exponent = part.exp
        return not (exponent.is_Rational and exponent.p >= 0)
    return part.func in _PARTIAL


_PARTIAL = (sp.log, sp.tan, sp.cot, sp.tanh, sp.atan)
_ATOMS = frozenset(map(type, (sp.I, sp.pi, sp.E, *map(sp.Rational, (0, 1, -1, "1/2", "2/3", 2)))))
_MADE = frozenset({sp.Add, sp.Mul, sp.Pow, *FUNCTIONS})
_OF_UNKNOWN = frozenset(vars(sp.Function("f", commutative=True)))


def _check_lowest(number: sp.Rational) -> None:
    """Raise :class:`NoTerm` of a fraction that can be shortened: it is not equal to its value."""
    if number.q < 2 or gcd(number.p, number.q) != 1:
        raise NoTerm(f"{number} is not in lowest terms")


def _check(part: Expr) -> None:
    """Raise :class:`NoTerm` of what stands in no term."""
    if part.is_Symbol:
        if type(part) not in (Symbol, sp.Dummy):
            raise NoTerm(f"the symbol {part} carries assumptions; hypotheses say them here")
        _check_symbol(part)
    elif isinstance(part, AppliedUndef) and set(getattr(part.func, "_kwargs", {})) - set(_PLAIN):
        raise NoTerm(f"the function {part.func} carries assumptions; hypotheses say them here")
    elif not _is_unknown(type(part)):
        raise NoTerm(f"{part} ({type(part).__name__}) is no part of a term")


@lru_cache(maxsize=1 << 12)
def _check_symbol(symbol: Symbol) -> None:
    """The same of a symbol; one that was made before stays so."""
    # an assumption would change what SymPy makes of an expression without saying so
    if symbol.assumptions0 != _PLAIN:
        raise NoTerm(f"the symbol {symbol} carries assumptions; hypotheses say them here")
    if symbol in _RESERVED:
        raise NoTerm(f"the symbol {symbol} stands for bound ones where propositions are compared")
    if not made_before(symbol, mark()):
        raise NoTerm(f"the symbol {symbol} has a number by hand; another one may get it yet")


def _is_unknown(function: type[Expr]) -> bool:
    """Whether a function is what SymPy makes of a name, and no class with ways of its own."""
    plain = type(function) is UndefinedFunction and function.__bases__ == (AppliedUndef,)
    return plain and vars(function).keys() <= _OF_UNKNOWN


def without_value(number: Expr) -> bool:
    """Whether SymPy met a division by zero; to be asked of numbers, since 0^x may have a value."""
    return bool(number.has(sp.zoo, sp.nan, sp.oo, -sp.oo))


def is_complex(symbol: Expr) -> bool:
    """Whether a symbol stands for a complex number."""
    known = SYMBOLS.get(symbol.name)
    return known is not None and known.domain == "complex"


def _bindable(symbols: Iterable[Symbol]) -> None:
    """Raise :class:`NoTerm` of what is no plain symbol, and cannot be bound."""
    for symbol in symbols:
        if not term(symbol).is_Symbol:
            raise NoTerm(f"{symbol} is no symbol that could be bound")


class Proposition:
    """Something that is true or false once its free symbols have values."""

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
            met = frozenset[Symbol]().union(*map(symbols_in, values.values()))
            inner |= {s: sp.Dummy(s.name) for s in bound if s in met}
            bound = tuple(inner.get(s, s) for s in bound)
        terms = replaced(self.terms, inner) if self.terms else ()
        return self.made(bound, terms, tuple(p.at(inner) for p in self.parts))


def replaced(terms: tuple[Expr, ...], values: Terms) -> tuple[Expr, ...]:
    """The terms with others in place of symbols."""
    return _replaced(terms, frozenset((s, sp.sympify(v)) for s, v in values.items()))


@lru_cache(maxsize=1 << 10)
def _replaced(terms: tuple[Expr, ...], values: frozenset[tuple[Symbol, Expr]]) -> tuple[Expr, ...]:
    known = dict(values)
    return tuple(t.xreplace(known) for t in terms)


_PLACES = tuple(sp.Dummy(f"bound_{i}") for i in range(64))
_DEPTHS = {place: i for i, place in enumerate(_PLACES)}
_RESERVED = frozenset(_PLACES)
_PLAIN = Symbol("x").assumptions0


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
    return {**places, **{s: _PLACES[depth + i] for i, s in enumerate(of.bound)}}


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

    @property
    def parts(self) -> tuple[Proposition, ...]:
        return self.of

    def made(self, bound: Any, terms: Any, parts: Any) -> Proposition:
        return type(self)(parts)


class Not(_Joined):
    """The negation of its one part."""


class And(_Joined):
    """All its parts; without any, the truth."""


class Or(_Joined):
    """One of its parts at least; without any, falsehood."""


class Implies(_Joined):
    """The first of its two parts implies the second."""


class Iff(_Joined):
    """Its two parts hold together or not at all."""


@dataclass(frozen=True, eq=False)
class _Quantified(Proposition):
    over: tuple[Symbol, ...]
    body: Proposition

    def __post_init__(self) -> None:
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


def of_print(claim: Proposition, printed: Iterable[Any]) -> Proposition:
    """A claim that is made of what is printed: each printed relation stands in it.

    Raises :class:`ValueError` where one does not.
    """
    inside = [claim]
    for part in inside:
        inside += part.parts
    for relation in printed:
        if proposition(relation) not in inside:
            raise ValueError(f"the print {relation} is not in the claim")
    return claim


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

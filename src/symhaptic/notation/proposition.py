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
from typing import Any, NoReturn, TypeAlias

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.notation import SYMBOLS

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
    if isinstance(of, (str, float, complex, bool)):
        raise NoTerm(f"{of!r} is no term; an exact SymPy expression is")
    expr = sp.sympify(of)
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
        if type(part) not in _ATOMS:
            if type(part) not in _MADE:
                _check(part)
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


@lru_cache(maxsize=1 << 15)
def symbols_in(expr: Expr) -> frozenset[Symbol]:
    """The free symbols of a term."""
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
        return not (exponent.is_Rational and exponent >= 0)
    return part.func in _PARTIAL


_PARTIAL = (sp.log, sp.tan, sp.cot, sp.tanh, sp.atan)
_ATOMS = frozenset(map(type, (sp.I, sp.pi, sp.E, *map(sp.Rational, (0, 1, -1, "1/2", "2/3", 2)))))
_MADE = frozenset({sp.Add, sp.Mul, sp.Pow, *FUNCTIONS})


def _check(part: Expr) -> None:
    """Raise :class:`NoTerm` of what stands in no term."""
    if part.is_Symbol:
        # an assumption would change what SymPy makes of an expression without saying so
        if type(part) not in (Symbol, sp.Dummy) or part.assumptions0 != _PLAIN:
            raise NoTerm(f"the symbol {part} carries assumptions; hypotheses say them here")
        if part in _RESERVED:
            raise NoTerm(f"the symbol {part} stands for bound ones where propositions are compared")
    elif not isinstance(part, AppliedUndef):
        raise NoTerm(f"{part} ({type(part).__name__}) is no part of a term")
    elif set(getattr(part.func, "_kwargs", {})) - set(_PLAIN):
        raise NoTerm(f"the function {part.func} carries assumptions; hypotheses say them here")


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
        met = frozenset[Symbol]().union(*map(symbols_in, values.values()))
        fresh = {s: sp.Dummy(s.name) for s in self.bound if s in met}
        inner = {**values, **fresh}
        return self.made(
            tuple(fresh.get(s, s) for s in self.bound),
            replaced(self.terms, inner),
            tuple(p.at(inner) for p in self.parts),
        )


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
    if one == other and all(here.get(s) is there.get(s) for s in symbols_in(one)):
        return True
    return bool(here) and one.xreplace(here) == other.xreplace(there)


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

    What each name means stands in :data:`MEANINGS`.
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


MEANINGS: dict[str, tuple[int, int, str, str]] = {
    # name: bound symbols, terms, LaTeX, meaning of the LaTeX with the terms of TERMS
    "whole": (0, 1, r"{0}\in\mathbb{{N}}_0", "$n$ is a whole number, zero included"),
    "increasing": (
        *(1, 3),
        r"{0}\ \text{{increases with}}\ {s}\ \text{{on}}\ ({1},{2})",
        "$f$ is defined, real and strictly increasing on the open interval",
    ),
    "limit": (
        *(1, 3),
        r"\lim_{{{s}\to {1}}} {0}={2}",
        "$f$ has this limit from both sides",
    ),
    "stable": (
        *(1, 1),
        r"\text{{all zeros of}}\ {0}\ \text{{in}}\ {s}\ \text{{lie in}}\ |{s}|<1",
        "every zero of the polynomial $p$ lies inside the unit circle",
    ),
    "hurwitz": (
        *(1, 1),
        r"\text{{all zeros of}}\ {0}\ \text{{in}}\ {s}\ \text{{lie in}}\ \Re {s}<0",
        "every zero of the polynomial $p$ has a negative real part",
    ),
    "passive": (
        *(1, 2),
        r"\text{{no motion gains energy from}}\allowbreak\ H({s})={0}"
        r"\allowbreak\ \text{{beside a loss of}}\ {1}\allowbreak\ "
        r"\text{{per squared displacement}}",
        "$\\sum_k(cp_k^2+p_k(Hx)_k)\\ge0$ for any finite sequence of displacements "
        "$p_k=x_{k+1}-x_k$ from rest at $x=0$, of which a damper burns $cp_k^2$ and which work "
        "against the force $(Hx)_k=h_0x_k+h_1x_{k-1}+\\ldots$",
    ),
    "passive_wall": (
        *(0, 5),
        r"\mathrm{{passive}}({0},{1},{2},{3},{4})",
        "no motion of a device with damping $b$ gains energy from the wall $K+B(z-1)/(Tz)$, "
        "sampled every $T$, its force held for $T$ and $d$ periods late",
    ),
    "passive_device": (
        *(1, 6),
        r"\mathrm{{passive}}({1},{2},{3},{4},{5};\ E({s})={0})",
        "the hand that moves a device from rest, $v=0$, does no negative work against its store "
        "$E$ of the speed $v$ at the end, here that of a mass, its damping $b$ and the same wall",
    ),
    "stable_loop": (
        *(0, 5),
        r"\mathrm{{stable}}({0},{1},{2},{3},{4})",
        "the loop of wall $(\\alpha,\\beta)$, spring $\\gamma$, damper $\\delta$ and a delay of "
        "$d$ periods, all in units of mass and period, comes to rest from every state",
    ),
    "stable_substituted": (
        *(0, 5),
        r"\mathrm{{stable}}_{{(18)}}({0},{1},{2},{3},{4})",
        "as the paper has it: every zero of the characteristic polynomial (18), that is of "
        "$z^{d+1}(z^2-az+e)+(n_1z+n_0)((\\alpha+\\beta)z-\\beta)$ with the numbers of the device "
        "$(\\gamma,\\delta)$, lies inside the unit circle; for a delay of $d=p/q$ periods every "
        "zero of the polynomial in $w$ that $z=w^q$ makes of it",
    ),
    "stable_principal": (
        *(0, 5),
        r"\mathrm{{stable}}_{{\text{{principal}}}}({0},{1},{2},{3},{4})",
        "no zero $z$ of the same with $|z|\\ge1$, where $z^d$ is the principal value, "
        "$\\exp(d\\ln|z|+jd\\arg z)$ with $-\\pi<\\arg z<\\pi$",
    ),
    "pole": (
        *(0, 6),
        r"{5}\ \text{{is a pole of}}\ p_{{(18)}}({0},{1},{2},{3},{4})",
        "as the paper has it: $z$ is a zero of the characteristic polynomial, for a delay of "
        "$d=p/q$ periods $z=w^q$ with a zero $w$ of the polynomial in $w$ that $z=w^q$ makes",
    ),
    "swings": (
        *(0, 4),
        r"{0}\ddot x+{1}\dot x+{2}x=0\ \text{{swings with}}\ {3}",
        "there is a motion $x=e^{\\sigma t}\\sin\\omega t$ with a real $\\sigma$",
    ),
    "degree": (
        *(1, 2),
        r"{0}\ \text{{has degree }}{1}\text{{ in }}{s}",
        "of the powers in the polynomial $p$ whose coefficient is not zero, $n$ is the highest",
    ),
    "answers": (
        *(1, 4),
        r"{0}\ \text{{answers }}{1}^k\text{{, held every }}{3}\text{{, by }}{2}\,{1}^k",
        "a force $z^k$ that is held during period $k$, of length $T$, acts through a device with "
        "the transfer function $P$; of the motions that turn by $z$ from period to period there is "
        "just one, and its position at sample $k$ is $Xz^k$, for all $k$, negative ones included "
        "($P$, $z$, $X$ and $T$ have values)",
    ),
    "device": (
        *(0, 6),
        r"\frac{{{2}z+{3}}}{{z^2-{4}z+{5}}}\ \text{{samples the device}}\ ({0},{1})",
        "$a=\\mathrm{tr}\\,\\Phi$, $e=\\det\\Phi$, $n_1=\\Gamma_1$ and "
        "$n_0=\\Phi_{12}\\Gamma_2-\\Phi_{22}\\Gamma_1$, where $\\Phi$ and $\\Gamma$ take the state "
        "$(x,v)$ and a held force to the state one period later, of "
        "$\\ddot x+\\delta\\dot x+\\gamma x=F$, in units of mass and period",
    ),
    "late_device": (
        *(0, 8),
        r"\frac{{{3}z^2+{4}z+{5}}}{{z\,(z^2-{6}z+{7})}}\ \text{{samples the device}}\ ({0},{1})"
        r"\ \text{{late by}}\ {2}",
        "the same device with the same $a$ and $e$, each held force beginning and ending $u$ "
        "periods late, $0\\le u\\le1$: with $G=\\Gamma(1-u)$ and $H=\\Phi(1-u)\\,\\Gamma(u)$, "
        "$m_2=G_1$, $m_1=\\Phi_{12}G_2-\\Phi_{22}G_1+H_1$ and $m_0=\\Phi_{12}H_2-\\Phi_{22}H_1$",
    ),
}
"""Each predicate: how many symbols it binds, how many terms it has, its LaTeX and its meaning."""

TERMS: dict[str, tuple[str, ...]] = {
    "whole": ("n",),
    "increasing": ("f(x)", "u", "v"),
    "limit": ("f(x)", "u", "y"),
    "stable": ("p(z)",),
    "hurwitz": ("p(s)",),
    "passive": (r"h_0+h_1/z+\ldots", "c"),
    "passive_wall": ("K", "B", "b", "T", "d"),
    "passive_device": ("mv^2/2", "K", "B", "b", "T", "d"),
    "stable_loop": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d"),
    "stable_substituted": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d"),
    "stable_principal": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d"),
    "pole": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d", "z"),
    "swings": ("m", "b", "k", r"\omega"),
    "degree": ("p(z)", "n"),
    "answers": ("P(s)", "z", "X", "T"),
    "device": (r"\gamma", r"\delta", "n_1", "n_0", "a", "e"),
    "late_device": (r"\gamma", r"\delta", "u", "m_2", "m_1", "m_0", "a", "e"),
}
"""LaTeX of the terms with which the meaning of a predicate is told."""


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

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
from functools import cached_property, lru_cache
from typing import Any, TypeAlias

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.notation import SYMBOLS

Terms: TypeAlias = Mapping[Symbol, Expr]

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
    _asked(expr)
    return expr


@lru_cache(maxsize=2**15)
def _asked(expr: Expr) -> None:
    """Nothing, for a term; expressions are asked again and again as theorems are made."""
    for part in sp.preorder_traversal(expr):
        if part.is_Rational or part in (sp.I, sp.pi, sp.E):
            continue
        if part.is_Symbol:
            # an assumption would change what SymPy makes of an expression without saying so
            if part != (part if isinstance(part, sp.Dummy) else Symbol(part.name)):
                raise NoTerm(f"the symbol {part} carries assumptions; hypotheses say them here")
            continue
        if (
            part.is_Add
            or part.is_Mul
            or part.is_Pow
            or isinstance(part, (*FUNCTIONS, AppliedUndef))
        ):
            continue
        raise NoTerm(f"{part} ({type(part).__name__}) is no part of a term")


def without_value(number: Expr) -> bool:
    """Whether SymPy met a division by zero; to be asked of numbers, since 0^x may have a value."""
    return bool(number.has(sp.zoo, sp.nan, sp.oo, -sp.oo))


def is_complex(symbol: Expr) -> bool:
    """Whether a symbol stands for a complex number."""
    known = SYMBOLS.get(symbol.name)
    return known is not None and known.domain == "complex"


class Proposition:
    """Something that is true or false once its free symbols have values."""

    @cached_property
    def key(self) -> tuple[Any, ...]:
        """What two equal propositions share: their parts, with bound symbols by their place."""
        return _key(self, {}, 0)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Proposition) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

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
        inner = frozenset(s for t in self.terms for s in t.free_symbols)
        return (inner.union(*(p.free for p in self.parts))) - frozenset(self.bound)

    def at(self, values: Terms) -> Proposition:
        """With terms in place of free symbols; bound symbols give way."""
        values = {s: v for s, v in values.items() if s in self.free and s != v}
        if not values:
            return self
        met = frozenset(s for v in values.values() for s in v.free_symbols)
        fresh = {s: sp.Dummy(s.name) for s in self.bound if s in met}
        inner = {**values, **fresh}
        return self.made(
            tuple(fresh.get(s, s) for s in self.bound),
            tuple(t.xreplace(inner) for t in self.terms),
            tuple(p.at(inner) for p in self.parts),
        )


_PLACES = [sp.Dummy(f"bound_{i}") for i in range(64)]


def _key(of: Proposition, places: dict[Symbol, Symbol], depth: int) -> tuple[Any, ...]:
    places = places | {s: _PLACES[depth + i] for i, s in enumerate(of.bound)}
    depth += len(of.bound)
    own = tuple(getattr(of, f.name) for f in fields(of) if f.type == "str")  # type: ignore[arg-type]
    return (
        type(of).__name__,
        own,
        tuple(is_complex(s) for s in of.bound),
        tuple(t.xreplace(places) for t in of.terms),
        tuple(_key(p, places, depth) for p in of.parts),
    )


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
        if not any(t.free_symbols for t in terms) and any(without_value(t) for t in terms):
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
    # name: bound symbols, terms, LaTeX, meaning
    "whole": (0, 1, r"{0}\in\mathbb{{N}}_0", "a whole number, zero included"),
    "increasing": (
        *(1, 3),
        r"{0}\ \text{{increases with}}\ {s}\ \text{{on}}\ ({1},{2})",
        "defined, real and strictly increasing on an open interval",
    ),
    "limit": (1, 3, r"\lim_{{{s}\to {1}}} {0}={2}", "the limit from both sides"),
    "stable": (
        *(1, 1),
        r"\text{{all zeros of}}\ {0}\ \text{{in}}\ {s}\ \text{{lie in}}\ |{s}|<1",
        "a polynomial in z, every zero of which lies inside the unit circle",
    ),
    "hurwitz": (
        *(1, 1),
        r"\text{{all zeros of}}\ {0}\ \text{{in}}\ {s}\ \text{{lie in}}\ \Re {s}<0",
        "a polynomial in s, every zero of which has a negative real part",
    ),
    "passive": (
        *(1, 2),
        r"\text{{no motion }}x=p/({s}-1)\text{{ gains energy from }}{0}\,x"
        r"\text{{ beside a loss of }}{1}\,p^2",
        "the sum over k of c p_k^2 + p_k (H x)_k is not negative for any finite sequence p_k = "
        "x_(k+1) - x_k of displacements from rest at 0, of which a damper burns c p_k^2",
    ),
    "passive_wall": (
        *(0, 5),
        r"\mathrm{{passive}}({0},{1},{2},{3},{4})",
        "no motion of a device with damping b gains energy from the wall K + B (z-1)/(Tz), sampled "
        "every T, its force held for T and d periods late",
    ),
    "passive_device": (
        *(1, 6),
        r"\mathrm{{passive}}_{{E=}}{{}}_{{{0}}}({1},{2},{3},{4},{5})",
        "the hand that moves a device from rest, v = 0, does no negative work against its store "
        "E(v) of the speed v at the end, its damping b and the wall of passive_wall",
    ),
    "stable_loop": (
        *(0, 5),
        r"\mathrm{{stable}}({0},{1},{2},{3},{4})",
        "the loop of wall (alpha, beta), spring gamma, damper delta and a delay of d periods, all "
        "in units of mass and period, comes to rest from every state",
    ),
    "stable_substituted": (
        *(0, 5),
        r"\mathrm{{stable}}_{{(18)}}({0},{1},{2},{3},{4})",
        "as the paper has it: every zero of the characteristic polynomial lies inside the unit "
        "circle, for a delay of d = p/q periods that of the polynomial in w that z = w^q makes",
    ),
    "stable_principal": (
        *(0, 5),
        r"\mathrm{{stable}}_{{\text{{principal}}}}({0},{1},{2},{3},{4})",
        "no zero z of z^(d+1) A + N W with |z| >= 1 where z^d is the principal value, "
        "exp(d ln |z| + j d arg z) with -pi < arg z < pi",
    ),
    "pole": (
        *(0, 6),
        r"{5}\ \text{{is a pole of}}_{{(18)}}({0},{1},{2},{3},{4})",
        "as the paper has it: a zero of the characteristic polynomial, for a delay of d = p/q "
        "periods w^q for a zero w of the polynomial in w that z = w^q makes",
    ),
    "swings": (
        *(0, 4),
        r"{0}\ddot x+{1}\dot x+{2}x=0\ \text{{swings with}}\ {3}",
        "m x'' + b x' + k x = 0 has a motion x = exp(sigma t) sin(omega t) with a real sigma",
    ),
    "degree": (
        *(1, 2),
        r"{0}\ \text{{has degree }}{1}\text{{ in }}{s}",
        "a polynomial in z whose highest power, with a coefficient that is not zero, is this one",
    ),
    "answers": (
        *(1, 4),
        r"{0}\ \text{{answers }}{1}^k\text{{, held every }}{3}\text{{, by }}{2}\,{1}^k",
        "a force z^k that is held during period k, of length T, acts through a device with this "
        "transfer function of s; of the motions that turn by z from period to period there is just "
        "one, and its position at sample k is X z^k, for all k, negative ones included (terms: "
        "transfer function, z, X, T, all of which have a value)",
    ),
    "device": (
        *(0, 6),
        r"\frac{{{2}z+{3}}}{{z^2-{4}z+{5}}}\ \text{{samples the device}}\ ({0},{1})",
        "a = tr Phi, e = det Phi, n1 = Gamma_1 and n0 = Phi_12 Gamma_2 - Phi_22 Gamma_1, where Phi "
        "and Gamma take the state (x, v) and a held force to the state one period later, of "
        "x'' + delta x' + gamma x = F, in units of mass and period",
    ),
    "late_device": (
        *(0, 8),
        r"\frac{{{3}z^2+{4}z+{5}}}{{z\,(z^2-{6}z+{7})}}\ \text{{samples the device}}\ ({0},{1})"
        r"\ \text{{late by}}\ {2}",
        "the same device with the same a and e, each held force beginning and ending u periods "
        "late, 0 <= u <= 1: with G = Gamma(1-u) and H = Phi(1-u) Gamma(u), m2 = G_1, "
        "m1 = Phi_12 G_2 - Phi_22 G_1 + H_1 and m0 = Phi_12 H_2 - Phi_22 H_1",
    ),
}
"""Each predicate: how many symbols it binds, how many terms it has, its LaTeX and its meaning."""


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
    inside: set[Proposition] = set()
    stack = [claim]
    while stack:
        part = stack.pop()
        inside.add(part)
        stack += part.parts
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

"""Tactics that find proofs of relations: ``nlinarith``, ``positivity`` and what is made of both.

A certificate is a sum of products of known signs (Handelman), found by a linear program at random
points.  Nothing here has to be believed: a kernel rule decides about whatever was found or read.
"""

from __future__ import annotations

import hashlib
import itertools
import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from copy import copy
from fractions import Fraction
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from sympy import Expr, S, Symbol

from symhaptic.notation.proposition import And, Predicate, Proposition, Relation, proposition
from symhaptic.proof.theorems.definedness import conditions
from symhaptic.proof.theorems.familiar import divided, not_negative, sign_of, square
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    assume,
    conj,
    inst,
    prove_hyp,
    relation,
)
from symhaptic.proof.theorems.leaves import combined, is_whole, number

Lemma: TypeAlias = Callable[[], Theorem]

CERTIFICATES: dict[str, str | None] = {}
"""What was found before, by the hash of a claim and facts: a share and the numbers of the facts of
each product; None where no sum was found."""
USED: dict[str, str | None] = {}
"""Those of them that a proof used in this process, and None of searches after which none was found.
"""


def load_certificates(file: Path) -> None:
    """Take certificates from a file; it is only written by :mod:`symhaptic.book.certificates`."""
    if file.is_file():
        CERTIFICATES.update(json.loads(file.read_text(encoding="utf-8")))


def difference(theorem: Theorem) -> Expr:
    """Return b - a of a < b, a <= b or a = b."""
    claim = relation(theorem)
    return claim.right - claim.left


written = cache(str)
"""How a proposition or a term is written."""


def nlinarith(claim: Any, *known: Any, degree: int = 2, search: bool = True) -> Theorem:
    """Show a relation as a sum of products of up to ``degree`` of the known ones.

    An equation may come with a multiplier, as a pair; it is used with any rational factor.
    Without ``search`` only a certificate that was found before counts.

    >>> x, y = sp.symbols("x y")
    >>> nlinarith(y * x > x, x > 0, y > 1).conclusion == proposition(y * x > x)
    True
    """
    claim = proposition(claim)
    if not isinstance(claim, Relation):
        raise NotShown(f"{claim} is no relation")
    pairs = [k if isinstance(k, tuple) else (k, S.One) for k in known]
    facts = {_theorem(k).conclusion: (_theorem(k), sp.sympify(m)) for k, m in pairs}
    multiplied = (f"{written(p)}, {written(m)}" for p, (_, m) in facts.items())
    text = [str(degree), written(claim), *multiplied]
    key = hashlib.sha256("\n".join(text).encode()).hexdigest()[:16]
    some = list(facts.values())
    if key in CERTIFICATES:
        if search or CERTIFICATES[key] is not None:
            USED[key] = CERTIFICATES[key]
        try:
            return combined(claim, *_products(CERTIFICATES[key], some))
        except (NotShown, ValueError, LookupError, TypeError, AttributeError, ZeroDivisionError):
            if CERTIFICATES[key] is None:
                raise
    if not search:
        raise NotShown(f"{written(claim)} has no certificate")
    CERTIFICATES[key] = USED[key] = None
    for found in _search(claim, some, degree):
        with suppress(NotShown):
            theorem = combined(claim, *_products(found, some))
            CERTIFICATES[key] = USED[key] = found
            return theorem
    raise NotShown(f"{claim} is no sum of products of what is known")


def _theorem(fact: Any) -> Theorem:
    return fact if isinstance(fact, Theorem) else assume(fact)


def _products(certificate: str | None, facts: Sequence[tuple[Theorem, Expr]]) -> list[list[Any]]:
    """The products that a certificate names."""
    if certificate is None:
        raise NotShown("it is no sum of products of what is known")
    rows: list[list[Any]] = []
    for product in filter(None, certificate.split("+")):
        share, *places = product.split()
        some = [facts[int(place)] for place in places]
        rows.append([sp.Rational(share) * sp.Mul(*(m for _, m in some)), *(t for t, _ in some)])
    return rows


MOST = 1500
"""Products among which a linear program may choose, within seconds."""


def _search(claim: Relation, facts: Sequence[tuple[Theorem, Expr]], degree: int) -> Iterator[str]:
    """Certificates, by linear programs: few products, then those of the least shares."""
    from scipy.optimize import linprog

    signs = [i for i, (t, _) in enumerate(facts) if relation(t).sign in ("<", "<=")]
    equal = [i for i, (t, _) in enumerate(facts) if relation(t).sign == "="]
    places: list[tuple[int, ...]] = [(i,) for i in equal for _ in (1, -1)]
    if claim.sign != "=":
        more = (itertools.combinations_with_replacement(signs, n) for n in range(degree + 1))
        places += itertools.chain(*more)
    if not 0 < len(places) <= MOST:
        raise NotShown(f"{len(places)} products to choose from")
    exprs = [difference(t) * m for t, m in facts]
    table = _values([claim.right - claim.left, *exprs], 2 * len(places) + 8)
    goal = table[0]
    rows = np.array([table[1:][list(p)].prod(axis=0) for p in places])
    rows[1 : 2 * len(equal) : 2] *= -1
    rows = np.concatenate([rows.real, rows.imag], axis=1)
    goal = np.concatenate([goal.real, goal.imag])
    some_ = np.abs(np.vstack([rows, goal])).max(axis=0) > 1e-9  # else it is round-off
    rows, goal = rows[:, some_], goal[some_]
    sizes = np.abs(rows).mean(axis=1) + 1e-12
    scale = np.abs(np.vstack([rows / sizes[:, None], goal])).max(axis=0) + 1e-9
    table = (rows / sizes[:, None] / scale).T
    strict = [all(relation(facts[i][0]).sign == "<" for i in p) for p in places]
    extra = (
        (-np.array([strict], dtype=float) / sizes, [-1e-4]) if claim.sign == "<" else (None, None)
    )
    few = np.array([1 + len(p) for p in places])
    for cost in (few, few / sizes, few * sizes):
        answer = linprog(cost, *extra, table, goal / scale)
        if answer.status != 0:
            return
        used = np.flatnonzero(answer.x > 1e-9)
        shares = np.linalg.lstsq(table[:, used], goal / scale, rcond=None)[0]
        shares = (shares if (shares > 0).all() else answer.x[used]) / sizes[used]
        yield " + ".join(
            " ".join(map(str, (-s if i < 2 * len(equal) and i % 2 else s, *places[i])))
            for i, s in zip(used, map(_rational, shares), strict=True)
        )


def _rational(value: float) -> Fraction:
    """The simplest fraction nearby."""
    for limit, near in ((12, 1e-7), (720, 1e-7), (10_000, 1e-8), (10_000_000, 1e-11)):
        found = Fraction(value).limit_denominator(limit)
        if abs(found - value) < near * max(1, abs(value)):
            break
    return found


def _values(exprs: Sequence[Expr], points: int) -> NDArray[Any]:
    """Expressions at random points, a row each; pi is one more unknown outside of functions."""
    exprs = [_loose(e) for e in exprs]
    symbols = sorted(set().union(*(e.free_symbols for e in exprs)), key=str)
    dice = np.random.default_rng(0)
    at = [dice.uniform(0.3, 2.5, points) + 0j for _ in symbols]
    found = sp.lambdify(symbols, exprs, "numpy", cse=True)(*at)
    return np.array([np.broadcast_to(row, points) for row in found], dtype=complex)


_PI = Symbol("pi_")


def _loose(expr: Expr) -> Expr:
    if expr is sp.pi:
        return _PI
    if expr.is_Atom or expr.is_Function:
        return expr
    return expr.func(*map(_loose, expr.args))


class Given:
    """What is known in some place, by what is assumed there; with it claims are shown.

    A claim is shown from its parts (``positivity``), from what is known of a sine, a cosine or an
    exponential, as a sum of products (:func:`nlinarith`), or as a quotient.
    """

    def __init__(self, *assumed: Any) -> None:
        self.allowed: frozenset[Proposition] = frozenset()
        self.known: dict[Proposition, Theorem] = {}
        self._signs: list[tuple[Theorem, Any]] = []
        self._failed: set[Proposition] = set()
        self._equations: list[Theorem] = []
        self._bare: list[tuple[list[Theorem], Given]] | None = None
        self._degree, self._closes, self._searches = 2, bool(assumed), False
        for claim in assumed:
            self._know(_theorem(claim))

    def _know(self, theorem: Theorem, multiplier: Any = S.One) -> Theorem:
        assumed = theorem.hypotheses == {theorem.conclusion}
        theorem = self._all_closed(theorem) if self._closes and not assumed else theorem
        self.allowed |= theorem.hypotheses
        self.known[theorem.conclusion] = theorem
        sign = not_negative(theorem) if _whole(theorem.conclusion) else theorem
        if isinstance(sign.conclusion, Relation) and sign.conclusion.sign != "!=":
            self._signs.append((sign, multiplier))
            if sign.conclusion.sign == "=" and multiplier == 1:
                self._equations.append(sign)
        self._bare = None
        return theorem

    def and_(self, *more: Any) -> Given:
        """With more known: assumptions, theorems, and equations with multipliers."""
        there = copy(self)
        there.known, there._failed = dict(self.known), set()
        there._signs, there._equations = list(self._signs), list(self._equations)
        for fact in more:
            of, multiplier = fact if isinstance(fact, tuple) else (fact, S.One)
            there._know(_theorem(of), multiplier)
        return there

    def have(self, claim: Any, *also: Any, degree: int = 2) -> Theorem:
        """Show a claim, and know it from here on."""
        self._failed.clear()
        return self._know(self.show(claim, *also, degree=degree))

    def show(self, claim: Any, *also: Any, degree: int = 2) -> Theorem:
        """Show a claim from what is known here, and also."""
        there = self.and_(*also)
        there._degree, goal = degree, proposition(claim)
        found = there._find(goal) or there._searched(partial(there._find, goal))
        if found is None:
            raise NotShown(f"{claim} is not shown by what is known")
        return found

    def closed(self, theorem: Theorem, *also: Any, degree: int = 2) -> Theorem:
        """Return a theorem without the hypotheses that can be shown; those assumed here stay."""
        there = self.and_(*also)
        there._degree = degree
        return there._all_closed(theorem)

    def defined(self, expr: Expr, *also: Any) -> list[Theorem]:
        """Show that no divisor of an expression vanishes."""
        return [self.show(c, *also) for c in sorted(conditions(expr), key=written)]

    def lemma(self, claim: Any, *uses: Callable[[], Theorem], degree: int = 2) -> Lemma:
        """Return a theorem that is shown, from what it uses, when it is asked for first."""
        return cache(lambda: self.show(claim, *(use() for use in uses), degree=degree))

    def about(self, symbol: Symbol) -> Callable[..., Callable[..., Theorem]]:
        """Return the same for theorems about a symbol, which can be had at any term."""

        def lemma(claim: Any, *uses: Callable[[], Theorem], degree: int = 2) -> Any:
            made = self.lemma(claim, *uses, degree=degree)
            return cache(lambda at=symbol: made() if at == symbol else inst(made(), {symbol: at}))

        return lemma

    def _searched(self, find: Callable[[], Theorem | None]) -> Theorem | None:
        """The same, with searches for certificates; those that fail count where all do."""
        before = set(USED)
        self._failed.clear()
        self._bare, self._searches = None, True
        found = find()
        self._failed.clear()
        self._bare, self._searches = None, False
        if found is not None:
            for key in [k for k, shares in USED.items() if shares is None and k not in before]:
                del USED[key]
        return found

    def _all_closed(self, theorem: Theorem) -> Theorem:
        """Without the hypotheses that can be shown, by what was found before or by a search."""
        theorem = self._closed(theorem)
        for claim in sorted(theorem.hypotheses - self.allowed, key=written):
            found = self._searched(partial(self._find, claim))
            theorem = theorem if found is None else prove_hyp(theorem, found)
        return theorem

    def _closed(self, theorem: Theorem) -> Theorem:
        left = sorted(theorem.hypotheses - self.allowed, key=written)
        shown = [t for t in map(self._find, left) if t is not None]
        return prove_hyp(theorem, *shown) if shown else theorem

    def _find(self, claim: Proposition) -> Theorem | None:
        if claim not in self.known and claim not in self._failed:
            self._failed.add(claim)  # while it is looked for: no circles
            for way in self._ways(claim):
                with suppress(NotShown):
                    found = way(claim)
                    if found is not None:
                        found = self._closed(found)
                        if all(map(_apart, found.hypotheses - self.allowed)):
                            self.known[claim] = found
                            break
        return self.known.get(claim)

    def _ways(self, claim: Proposition) -> Sequence[Callable[[Any], Theorem | None]]:
        if isinstance(claim, And):
            return [lambda claim: _all(conj, map(self._find, claim.parts))]
        if _whole(claim):
            known = (t for p, t in self.known.items() if _whole(p))
            return [lambda claim: is_whole(claim.of[0], *known)]
        if not isinstance(claim, Relation):
            return []
        if not claim.free:
            return [number]
        if claim.sign == "!=":
            return [self._other, self._differs]
        if claim.sign == "=":
            return [self._rewritten, self._sum]
        return [self._rewritten, self._parts, self._function, self._sum, self._quotient]

    def _sign(self, of: Expr, *signs: str) -> Theorem | None:
        """The first of some signs of an expression, or of what it is the negative of."""
        claims = (Relation(S.Zero, sign, e) for e in (of, -of) for sign in signs)
        return next(filter(None, map(self._find, claims)), None)

    def _differs(self, claim: Relation) -> Theorem | None:
        return _all(lambda t: combined(claim, [t]), [self._sign(claim.left - claim.right, "<")])

    def _other(self, claim: Relation) -> Theorem | None:
        """The same of a known multiple."""
        of = claim.left - claim.right
        same = (
            t for p, t in self.known.items() if _apart(p) and of in (difference(t), -difference(t))
        )
        return _all(lambda t: combined(claim, [t]), [next(same, None)])

    def _rewritten(self, claim: Relation) -> Theorem | None:
        """By equations, the right side for the left one, or for a symbol on the right."""
        for use, there in self._plain:
            goal, rows = _reduced(claim.right - claim.left, use)
            with suppress(NotShown):
                if claim.sign == "=":
                    return combined(claim, *rows)
                known = there._find(Relation(S.Zero, claim.sign, goal))
                if known is not None:
                    return combined(claim, [known], *rows)
        return None

    @property
    def _plain(self) -> list[tuple[list[Theorem], Given]]:
        """Without equations: by all of them, and by those of symbols alone."""
        if self._bare is None and self._equations:
            self._bare = []
            named = [t for t in self._equations if any(s.is_Symbol for s in relation(t).terms)]
            for use in (self._equations, named):
                there = self.and_()
                there._equations, there._signs, there._closes = [], [], False
                for theorem, _ in self._signs:
                    sign = relation(theorem).sign
                    of, rows = _reduced(difference(theorem), use)
                    if sign != "=":
                        back = [[t, -share] for t, share in rows]
                        there._know(combined(Relation(S.Zero, sign, of), [theorem], *back))
                self._bare.append((use, there))
        return self._bare or []

    def _parts(self, claim: Relation) -> Theorem | None:
        """A sum of positive terms, a product of factors with a sign, a power."""
        of, sign = claim.right - claim.left, claim.sign
        if of.is_Add and all(term.as_coeff_Mul()[0] > 0 for term in of.args):
            rows = (self._sign(term, "<", "<=") for term in of.args)
            return _all(lambda *known: combined(claim, *([t] for t in known)), rows)
        if of.is_Pow and of.exp.is_Integer and of.exp > 1:
            if of.exp % 2 == 0 and sign == "<=":
                return combined(claim, [square(of.base ** (of.exp / 2))])
            known = self._sign(of.base, sign)
            return _all(lambda t: combined(claim, [t] * int(of.exp)), [known])
        if not of.is_Mul or sp.fraction(of)[1].free_symbols:
            return None
        share, rest = of.as_coeff_Mul()
        signs = ("<", "<=") if sign == "<=" else ("<",)
        factors = (self._sign(factor, *signs) for factor in sp.Mul.make_args(rest))
        return _all(lambda *known: combined(claim, [abs(share), *known]), factors)

    def _function(self, claim: Relation) -> Theorem | None:
        """That of a sine, a cosine or an exponential."""
        of = claim.right - claim.left
        if of.func not in (sp.sin, sp.cos, sp.exp):
            return None
        return combined(claim, [sign_of(of.func, of.args[0])])

    def _sum(self, claim: Relation) -> Theorem | None:
        """A sum of products of what is known, which is about some of its symbols."""
        about = frozenset[Symbol]().union(*(t.conclusion.free for t, _ in self._signs))
        if self._signs and claim.free.isdisjoint(about):
            return None
        round_ = any(term.has(sp.pi) for term in claim.terms)
        size = [number(Relation(S.Zero, "<", sp.pi))] if round_ else []
        known = (*self._signs, *size)
        return nlinarith(claim, *known, degree=self._degree, search=self._searches)

    def _quotient(self, claim: Relation) -> Theorem | None:
        """That of a quotient, from those of both its parts; of a sum, by its factors."""
        top, bottom = _fraction(claim.right - claim.left)
        if bottom is None:
            known = self._find(Relation(S.Zero, claim.sign, top)) if top.is_Mul else None
            return _all(lambda t: combined(claim, [t]), [known])
        below = self._sign(bottom, "<")
        if below is None:
            return None
        way = 1 if difference(below) == bottom else -1
        above = self._find(Relation(S.Zero, claim.sign, way * top))
        return _all(lambda t: divided(claim, t, below), [above])


def show(claim: Any, *known: Any, degree: int = 2) -> Theorem:
    """Show a claim from theorems and assumptions alone."""
    return Given().show(claim, *known, degree=degree)


def _reduced(of: Expr, equations: Sequence[Theorem]) -> tuple[Expr, list[list[Any]]]:
    """An expression after all equations, and their multiples that are the difference."""
    rows: list[list[Any]] = []
    for theorem in (*equations, *equations):  # one may bring in another
        left, right = relation(theorem).terms
        way = -1 if left.is_Symbol or not right.is_Symbol else 1
        old, new = (left, right) if way < 0 else (right, left)
        place = sp.Dummy()
        there = of.xreplace({old: place})
        if place in there.free_symbols:
            share = sp.diff(there, place)
            if place in share.free_symbols:
                share = sp.cancel((there - there.xreplace({place: new})) / (place - new))
            rows.append([theorem, way * share.xreplace({place: old})])
            of = there.xreplace({place: new})
    return of, rows


@cache
def _fraction(of: Expr) -> tuple[Expr, Expr | None]:
    """Numerator and denominator, if it has one, as products."""
    other = sp.factor(of) if of.is_rational_function(*of.free_symbols) else sp.together(of)
    top, bottom = sp.fraction(other)
    return (top, bottom) if bottom.free_symbols else (of if other == of else other, None)


def _all(made: Callable[..., Theorem], parts: Iterable[Theorem | None]) -> Theorem | None:
    """What is made of theorems, if none is missing."""
    found: list[Theorem] = []
    for part in parts:
        if part is None:
            return None
        found.append(part)
    return made(*found)


def _apart(claim: Proposition) -> bool:
    return isinstance(claim, Relation) and claim.sign == "!="


def _whole(claim: Proposition) -> bool:
    return isinstance(claim, Predicate) and claim.name == "whole"

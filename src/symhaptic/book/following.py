"""What follows from the definitions of a page: a theorem made of a print and of what names mean.

Each definition that is used is a hypothesis ``name = meaning`` of the claim, so that a verdict
shows from which definitions it follows.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, k, m, t_d
from symhaptic.notation.latex import latex
from symhaptic.notation.proposition import (
    ForAll,
    Proposition,
    Relation,
    both,
    implied,
    proposition,
)
from symhaptic.notation.terms import NoTerm
from symhaptic.proof.points import Point, outside, points
from symhaptic.proof.theorems.definedness import conditions
from symhaptic.proof.theorems.judge import Case, Judged
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    add_assum,
    assume,
    conj,
    subst,
)
from symhaptic.proof.theorems.leaves import combined, identity
from symhaptic.proof.theorems.tactics import counterexample, example, for_all

Definition: TypeAlias = tuple[Expr, Expr]
"""A name (a symbol, or an unknown function of something) and what it stands for."""

GIVEN = frozenset({K, B, alpha, beta, m, b, k, gamma, delta, T, t_d, d})
"""Numbers of the wall, the device and the loop, which the model takes as they come: a formula that
defines one of them says nothing about which walls are stable or passive."""

_TRIED = 40
"""Points that are tried as an example and as a counterexample."""

_SMALL = 100
"""Each point is also tried divided by this: some meanings need small values to be in a domain."""


class Undefinable(ValueError):
    """A name that stands for itself or for two things, or a print that is no equation."""


@dataclass(frozen=True)
class Print:
    """Printed equations, and the definitions of the page that they need."""

    printed: tuple[Relation, ...]
    used: tuple[Definition, ...]
    """Each name stands before those that its meaning needs."""

    @property
    def is_definition(self) -> bool:
        """Whether a printed equation says no more than one of the definitions, or a number of the
        model is defined.

        Neither is a result: the first is what the chapter assumes, the second restricts the model.
        """
        open_ = (r for r in self.printed if not _same(*r.terms))
        pairs = itertools.product(open_, self.used)
        restated = any(_same(*_put(r, {name: means}).terms) for r, (name, means) in pairs)
        return restated or not GIVEN.isdisjoint(name for name, _ in self.used)

    @cached_property
    def stages(self) -> list[tuple[Relation, ...]]:
        """The print, and what it becomes as one definition after the other is put in."""
        found = [self.printed]
        for name, meaning in self.used:
            found.append(tuple(_put(r, {name: meaning}) for r in found[-1]))
        return found

    @cached_property
    def given(self) -> tuple[Proposition, ...]:
        """Hypotheses: everything has a value, and the names have their meanings."""
        terms = [side for stage in self.stages for r in stage for side in r.terms]
        defined = sorted(conditions(*terms, *(m for _, m in self.used)), key=str)
        return (*defined, *(Relation(*_equation(one)) for one in self.used))

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """All symbols; the claim is about all of their values."""
        parts = (*self.given, *self.printed)
        return tuple(sorted(frozenset[Symbol]().union(*(p.free for p in parts)), key=str))

    @property
    def claim(self) -> Proposition:
        """The equations, for all values that satisfy the hypotheses."""
        body = implied(self.given, both(self.printed))
        return ForAll(self.symbols, body) if self.symbols else body

    def theorem(self) -> Theorem:
        """The claim as a theorem; raises :class:`NotShown` if it is no identity."""
        shown = conj(*map(self._shown, range(len(self.printed))))
        shown = shown if len(self.printed) > 1 else self._shown(0)
        if not shown.hypotheses <= set(self.given):
            raise NotShown("it holds only where more is defined than the print")
        if not self.symbols:
            return shown
        return for_all(self.symbols, self.given, add_assum(shown, *self.given))

    def _shown(self, number: int) -> Theorem:
        last = self.stages[-1][number]
        found = identity(last.left, last.right)
        place = sp.Dummy("z")  # a complex one: a root need not be real by its form
        for (name, meaning), before in zip(self.used[::-1], self.stages[-2::-1], strict=True):
            known = assume(Relation(name, "=", meaning))
            equation = combined(Relation(meaning, "=", name), [known, sp.S.NegativeOne])
            found = subst(_put(before[number], {name: place}), place, found, equation)
        return found

    def example(self) -> Case | None:
        """A point at which the hypotheses hold."""
        if not self.given:
            return None
        for point in self._points():
            try:
                return example(point, self.given)
            except (NotShown, NoTerm):
                continue
        raise Undefinable(
            "no point is found at which the definitions have a value and all symbols are in their "
            "domains"
        )

    def counterexample(self, at: Point | None = None) -> Case | None:
        """A point at which the hypotheses hold and the print fails; ``at`` is tried alone."""
        for point in self._points() if at is None else self._inside([at]):
            try:
                case = counterexample(self.claim, point)
            except (NotShown, NoTerm):
                continue
            if case.refutes(self.claim):
                return case
        return None

    def _points(self) -> Iterator[Point]:
        names = {name for name, _ in self.used}
        free = [s for s in self.symbols if s not in names]
        some = list(itertools.islice(points(*free), _TRIED))
        small = ({symbol: value / _SMALL for symbol, value in point.items()} for point in some)
        return self._inside(itertools.chain(some, small))

    def _inside(self, some: Iterable[Point]) -> Iterator[Point]:
        """Points with the values of names, of which none is outside of its domain."""
        for point in map(self._whole, some):
            if not any(outside(*pair) for pair in point.items()):
                yield point

    def _whole(self, point: Point) -> Point:
        """A point with the values of names."""
        found = {symbol: sp.sympify(value) for symbol, value in point.items()}
        for name, meaning in self.used[::-1]:
            found[name] = meaning.xreplace(found)
        return found


def of_print(printed: Iterable[Expr], definitions: Sequence[Definition]) -> Print:
    """Printed equations with the definitions that they need."""
    functions: dict[Expr, Symbol] = {}

    def plain(expr: Expr) -> Expr:
        for part in expr.atoms(AppliedUndef):
            functions.setdefault(part, Symbol(str(part)))
        return expr.xreplace(functions)

    equations = []
    for form in printed:
        if not isinstance(form, sp.Eq):
            raise Undefinable(f"{form} is no equation; settle it with a theorem")
        claim = proposition(form.func(*map(plain, form.args), evaluate=False))
        assert isinstance(claim, Relation)
        equations.append(claim)
    known = [(plain(name), plain(meaning)) for name, meaning in definitions]
    symbols = [s for r in equations for s in r.free]
    return Print(tuple(equations), tuple(_needed(symbols, known, ())))


def _needed(
    symbols: Iterable[Expr], known: Sequence[Definition], above: tuple[Expr, ...]
) -> list[Definition]:
    """The definitions of these symbols, each before those that it needs itself."""
    found: list[Definition] = []
    for symbol in sorted(set(symbols), key=str):
        meanings = [meaning for name, meaning in known if name == symbol]
        if not meanings:
            continue
        if symbol in above:
            raise Undefinable(f"{symbol} is defined by itself")
        if not all(_same(meanings[0], other) for other in meanings[1:]):
            raise Undefinable(f"{symbol} stands for more than one thing on the page")
        below = _needed(meanings[0].free_symbols, known, (*above, symbol))
        # a definition that several need stands behind all of them
        found = [one for one in found if one not in below]
        found += [(symbol, meanings[0]), *below] if (symbol, meanings[0]) not in found else []
    return found


def settled(
    printed: Iterable[Expr],
    derived: Sequence[Expr],
    definitions: Sequence[Definition],
    at: Point | None = None,
) -> tuple[Judged, Print]:
    """The theorem of a print, or of the derived form beside a print that is wrong.

    Raises :class:`NotShown` if neither follows from the definitions.
    """
    claimed = of_print(printed, definitions)
    try:
        found = Judged(claimed.theorem(), example=claimed.example())
    except NotShown as wrong:
        if not derived:
            raise
        right = of_print(derived, definitions)
        _check_correction(claimed, right)
        case = claimed.counterexample(at)
        if case is None:
            raise NotShown(f"{wrong}; and no point is found at which the print fails") from None
        shown = tuple(f"{latex(r.left)} = {latex(r.right)}" for r in right.printed)
        found = Judged(right.theorem(), right.example(), (case,), shown, instead=right.claim)
    else:
        if at is not None:
            raise Undefinable("a counterexample stands against what follows from the definitions")
    return found, claimed


def _check_correction(claimed: Print, right: Print) -> None:
    """Refuse a correction of something else, and of a print that has a name of no known meaning."""
    ours, theirs = len(right.printed), len(claimed.printed)
    if ours != theirs:
        raise Undefinable(f"{ours} equations are derived, and {theirs} printed; derive as many")
    for printed, last, other in zip(
        claimed.printed, claimed.stages[-1], right.printed, strict=True
    ):
        if not any(itertools.starmap(_same, itertools.product(printed.terms, other.terms))):
            sides = f"{other.left} = {other.right}", f"{printed.left} = {printed.right}"
            raise Undefinable("{} is derived, and keeps no side of the print {}".format(*sides))
        for one, side in (last.terms, last.terms[::-1]):
            if isinstance(one, Symbol) and one not in side.free_symbols:
                raise NotShown(f"the page does not define {one}; define it or give a theorem")
        if _same(*other.terms):
            raise Undefinable(f"{other.left} = {other.right} holds whatever a name means")


def _same(one: Expr, other: Expr) -> bool:
    try:
        identity(one, other)
    except (NotShown, NoTerm):
        return False
    return True


def _put(relation: Relation, values: dict[Expr, Expr]) -> Relation:
    return Relation(relation.left.xreplace(values), "=", relation.right.xreplace(values))


def _equation(definition: Definition) -> tuple[Expr, str, Expr]:
    name, meaning = definition
    return name, "=", meaning

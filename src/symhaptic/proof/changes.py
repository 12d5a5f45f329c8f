"""What a chapter asked, asked again with one thing changed: the one place for a kind of change.

Each kind of check is registered here with its changes.  A change makes another question, which the
checker must not confirm; where it does, ``excuse`` says why that is right, or finds nothing to say.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import singledispatch
from typing import Any, TypeAlias

import sympy as sp
from flint import acb
from sympy import Expr

from symhaptic.notation import T, d, z
from symhaptic.proof import second
from symhaptic.proof.ball import ball
from symhaptic.proof.certificate import Box, Given
from symhaptic.proof.checks import (
    Check,
    Decimals,
    Different,
    Free,
    Limit,
    Minimal,
    Roots,
    Same,
    Sign,
    Units,
)
from symhaptic.proof.mutants import few, misprints
from symhaptic.proof.series import limit
from symhaptic.proof.sign import Fact, Interval, NotShown

FEW = 4
"""Variants of each side of a step; of a printed formula all are tried."""

WIDER = (1, 4, 32, 1024)
"""So many times is an interval or a value enlarged in search of one where the claim is wrong."""

_BUSY = 100
"""Pieces after which a wider box counts as not confirmed."""

AGAIN = "says the same in other words"


def inexcusable() -> str | None:
    """Nothing speaks for a confirmation."""
    return None


def because(reason: str) -> Callable[[], str | None]:
    """A reason that is known beforehand."""
    return lambda: reason


@dataclass(frozen=True)
class Change:
    """A question with one thing changed; without a ``check`` the excuse says why none is wrong."""

    kind: str
    what: str
    check: Check | None
    excuse: Callable[[], str | None] = inexcusable


@singledispatch
def changes(check: Any) -> Iterator[Change]:
    """All changes of a check, always in the same order."""
    raise TypeError(f"no changes are known of {type(check).__name__}")


def _negated(check: Check) -> Iterator[Change]:
    other = opposite(check)
    if other is not None:
        yield Change("negated", "the contrary", other)


def _forms(
    form: tuple[Expr, ...], made: Callable[[tuple[Expr, ...]], Check], side: str
) -> Iterator[Change]:
    def again(other: tuple[Expr, ...]) -> Callable[[], str | None]:
        return lambda: AGAIN if second.alike(form, other) else None

    for mutant in few(form, FEW):
        yield Change("formula", f"{side}: {mutant.change}", made(mutant.form), again(mutant.form))


@changes.register
def _same(check: Same) -> Iterator[Change]:
    yield from _negated(check)
    yield from _forms(check.left, lambda form: Same(form, check.right), "left")
    yield from _forms(check.right, lambda form: Same(check.left, form), "right")


@changes.register
def _limit(check: Limit) -> Iterator[Change]:
    found = (limit(check.expr, check.variable, check.at),)
    yield Change("negated", "the contrary", Different(found, (check.value,)))
    yield from _forms((check.value,), lambda form: Same(found, form), "value")
    yield Change("formula", "plus 1", replace(check, expr=check.expr + 1))
    if check.value != 0:
        yield Change("formula", "twice as large", replace(check, expr=2 * check.expr))


@changes.register
def _free(check: Free) -> Iterator[Change]:
    yield from _negated(check)
    for expr, what in ((check.expr * check.symbol, "times"), (check.expr + check.symbol, "plus")):
        yield Change("formula", f"{what} {check.symbol}", replace(check, expr=expr))


@changes.register
def _roots(check: Roots) -> Iterator[Change]:
    yield from _negated(check)

    def wrong(other: Roots) -> bool:
        size = second.largest_root(other.polynomial, other.at, other.given, other.half)
        return size > 1 if other.inside else size < 1

    whole = check.polynomial.subs({s: v for s, v in check.at.items() if v.is_Integer})
    turned = sp.expand(z ** sp.degree(whole, z) * whole.subs(z, 1 / z))
    if wrong(replace(check, polynomial=turned)):
        yield Change("formula", "1/z for z", replace(check, polynomial=turned))
    kind = "domain" if check.inside else "counterexample"
    for symbol, value in check.at.items():
        if symbol == d:
            moved = [value + k for k in (1, 2, 3, 5, 10, 20)]
        else:
            sizes = [sp.Integer(1 + k) ** (1 if check.inside else -1) for k in WIDER]
            moved = [(value or sp.S.One) * size * sign for size in sizes for sign in (1, -1)]
        for other in (replace(check, at={**check.at, symbol: v}) for v in moved):
            if wrong(other):
                yield Change(kind, f"{symbol} = {other.at[symbol]} for {value}", other)
                break
        else:
            what = f"{symbol} = {', '.join(map(str, moved))} for {value}"
            side = "all roots inside" if check.inside else "a root outside"
            yield Change(kind, what, None, because(f"{side} there, too"))


@changes.register
def _decimals(check: Decimals) -> Iterator[Change]:
    for text, what in misprints(check.text):
        yield Change("digit", what, replace(check, text=text))


@changes.register
def _minimal(check: Minimal) -> Iterator[Change]:
    polynomial = check.number.minimal
    for variable in polynomial.free_symbols:
        for (power,), _ in sp.Poly(polynomial, variable).terms():
            for more in (1, -1):
                other = replace(check.number, minimal=polynomial + more * variable**power)
                what = f"coefficient of power {power} {'plus' if more > 0 else 'minus'} 1"
                yield Change("digit", what, Minimal(other))


@changes.register
def _units(check: Units) -> Iterator[Change]:
    yield Change("formula", "a term of other units", Units(check.meaning + T * check.meaning))
    yield Change("formula", "the exponential of a time", Units(check.meaning * sp.exp(T)))


# -- signs ---------------------------------------------------------------------------------


@changes.register
def _sign(check: Sign) -> Iterator[Change]:
    yield from _negated(check)
    fact, made = check.fact, check.fact.made
    if made is None:
        return
    arguments = (*made.args, *made.named.values())
    exact = any(isinstance(arg, (Fact, Interval, Sequence)) for arg in arguments)
    for i, arg in enumerate(made.args):
        if isinstance(arg, Mapping):
            yield from _boxes(fact, arg, arguments[2] if len(arguments) > 2 else None)
        elif i == 0 and arg == fact.expr:
            if exact:  # else the claim is an inequality, and another one may be true as well
                yield from _forms((arg,), lambda form: _remade(fact, 0, form[0], expr=form[0]), "")
        else:
            for part in _parts(arg):
                rests = fact.rests
                if part.weakened is not None:
                    rests = rests - {part.weakened[0]} | {part.weakened[1]}
                other = _remade(fact, i, part.new, rests=rests)
                yield Change(part.kind, part.what, other, part.excuse)


def _remade(fact: Fact, place: int, new: Any, **otherwise: Any) -> Sign:
    """A fact made again with one argument changed."""
    assert fact.made is not None
    args = (*fact.made.args[:place], new, *fact.made.args[place + 1 :])
    return Sign(replace(fact, made=replace(fact.made, args=args), **otherwise))


_Assumption: TypeAlias = tuple[Expr, bool]


@dataclass(frozen=True)
class _Part:
    """An argument of a rule with one thing changed, and the assumption that this weakens."""

    kind: str
    what: str
    new: Any
    weakened: tuple[_Assumption, _Assumption] | None = None
    excuse: Callable[[], str | None] = inexcusable


def _parts(arg: Any, alone: bool = True) -> Iterator[_Part]:
    """Changes of what a fact is made from, ``alone`` or as one factor of many."""
    if isinstance(arg, Fact):
        yield from _weaker(arg, alone)
    elif isinstance(arg, Interval):
        try:
            longer = Interval(arg.variable, arg.lower - 1, *arg.held)
        except NotShown:
            return
        [old], [new] = arg.above.rests, longer.above.rests
        yield _Part("domain", f"{arg.variable} from {longer.lower} on", longer, (old, new))
    elif isinstance(arg, Sequence):
        for i, factor in enumerate(arg):
            before, after = arg[:i], arg[i + 1 :]
            if factor != 1:
                named = factor.expr if isinstance(factor, Fact) else factor
                yield _Part("formula", f"{named} dropped", [*before, *after])
            for part in _parts(factor, alone=False):
                yield replace(part, new=[*before, part.new, *after])
    elif isinstance(arg, (int, Expr)) and arg != 0:
        yield _Part("formula", f"{arg} plus 1", arg + 1)
        yield _Part("formula", f"{arg} negated", -arg)


def _weaker(fact: Fact, alone: bool) -> Iterator[_Part]:
    """A fact that says less: x > -1 for x > 0, or x >= 0 where that matters."""
    assumed = fact.made is None and fact.rests == {(fact.expr, fact.strict)}
    others = [(replace(fact, expr=fact.expr + 1), f"{fact.expr} > -1 for > 0", inexcusable)]
    if fact.strict and (alone or assumed):
        what = f"{fact.expr} >= 0 for > 0"
        others.append(
            (replace(fact, strict=False), what, because("holds there, too: another term is strict"))
        )
    for other, what, excuse in others:
        if assumed:
            old, new = (fact.expr, fact.strict), (other.expr, other.strict)
            weaker = replace(other, rests=frozenset({new}))
            yield _Part("domain", what, weaker, (old, new), excuse)
        else:
            yield _Part("formula", what, other, None, excuse)


def _boxes(fact: Fact, box: Box, given: Given | None) -> Iterator[Change]:
    """Each interval made longer at each end, up to a point where the fact is seen to be wrong.

    The other symbols are put there, too, so that the checker need not cut the whole box to see it.
    """
    for symbol, (low, high) in box.items():
        step = high - low or sp.S.One
        for end, outwards in ((low, -step), (high, step)):
            for times in WIDER:
                new = end + outwards * times
                wrong = _seen_wrong(fact.expr, {**box, symbol: (new, new)}, given)
                if wrong is not None:
                    longer = (new, high) if end + outwards < end else (low, new)
                    wider = {s: (v, v) for s, v in wrong.items()} | {symbol: longer}
                    yield Change("domain", f"{symbol} to {new}", _tried(fact, wider, given))
                    break
            else:
                way = "below" if end + outwards < end else "above"
                what = f"{symbol} {way} {end}, to {new}"
                yield Change("domain", what, None, because("seen to hold there, too"))


def _tried(fact: Fact, box: Box, given: Given | None) -> Sign:
    """The same inequality on another box, given up after so many pieces."""
    left = itertools.count(_BUSY, -1)

    def busy(at: Mapping[sp.Symbol, acb]) -> Mapping[sp.Symbol, acb]:
        if next(left) < 0:
            raise NotShown("too many pieces")
        return given(at) if given else {}

    assert fact.made is not None
    ends = [end for s, (low, high) in box.items() for end in (s - low, high - s)]
    rests = frozenset((sp.sympify(end), False) for end in ends)
    made = replace(fact.made, args=(fact.expr, box, busy), named={})
    return Sign(replace(fact, made=made, rests=rests))


def _seen_wrong(expr: Expr, box: Box, given: Given | None) -> dict[sp.Symbol, Expr] | None:
    """A point of a box where a ball shows a value that is not positive."""
    dice = random.Random(0)
    for _ in range(8):
        shares = {s: sp.Rational(dice.randint(0, 4), 4) for s in box}
        point = {s: low + (high - low) * shares[s] for s, (low, high) in box.items()}
        balls = {s: ball(value) for s, value in point.items()}
        found = ball(expr, {**balls, **(given(balls) if given else {})}, 96)
        if found.is_finite() and found.real <= 0:
            return point
    return None


@singledispatch
def opposite(check: Any) -> Check | None:
    """The contrary of what a check asks, where there is one."""
    return None


@opposite.register
def _unlike(check: Same) -> Check:
    return Different(check.left, check.right)


@opposite.register
def _elsewhere(check: Limit) -> Check:
    return Different((limit(check.expr, check.variable, check.at),), (check.value,))


@opposite.register
def _varying(check: Free) -> Check:
    return replace(check, free=not check.free)


@opposite.register
def _other_side(check: Roots) -> Check:
    return replace(check, inside=not check.inside)


@opposite.register
def _negative(check: Sign) -> Check | None:
    fact = check.fact
    if fact.made is None or not fact.made.args or fact.made.args[0] != fact.expr:
        return None
    return _remade(fact, 0, -fact.expr, expr=-fact.expr)

"""What a chapter asked, asked again with one thing changed: the one place for a kind of change.

Each kind of check is registered here with its changes.  A change makes another question, which the
checker must not confirm; where it does, ``excuse`` says why that is right, or finds nothing to say.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import singledispatch
from typing import Any

import sympy as sp
from sympy import Expr

from symhaptic.notation import T, d, z
from symhaptic.proof import second_opinion
from symhaptic.proof.change import WIDER, Change, because
from symhaptic.proof.checks import (
    AllZeros,
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
from symhaptic.proof.sign import Fact, Interval
from symhaptic.proof.weaker import remade, weaker_parts, wider_boxes

FEW = 4
"""Variants of each side of a step; of a printed formula all are tried."""

AGAIN = "says the same in other words"


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
        return lambda: AGAIN if second_opinion.alike(form, other) else None

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
        size = second_opinion.largest_root(other.polynomial, other.at, other.given, other.half)
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
def _all_zeros(check: AllZeros) -> Iterator[Change]:
    for i in range(len(check.zeros)):
        fewer = (*check.zeros[:i], *check.zeros[i + 1 :])
        yield Change("grounds", f"without zero {i + 1}", replace(check, zeros=fewer))
    more = (*check.zeros, check.between[1])
    yield Change("grounds", "one more zero", replace(check, zeros=more))


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
            yield from wider_boxes(fact, arg, arguments[2] if len(arguments) > 2 else None)
        elif i == 0 and arg == fact.expr:
            if exact:  # else the claim is an inequality, and another one may be true as well
                yield from _forms((arg,), lambda form: remade(fact, 0, form[0], expr=form[0]), "")
        else:
            for part in weaker_parts(arg):
                rests = fact.rests
                if part.weakened is not None:
                    rests = rests - {part.weakened[0]} | {part.weakened[1]}
                other = remade(fact, i, part.new, rests=rests)
                yield Change(part.kind, part.what, other, part.excuse)


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
    return remade(fact, 0, -fact.expr, expr=-fact.expr)

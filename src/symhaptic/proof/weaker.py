"""Signs made from less: a weaker assumption, a dropped factor, a larger box."""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import sympy as sp
from flint import acb
from sympy import Expr

from symhaptic.proof.ball import ball
from symhaptic.proof.certificate import Box, Given
from symhaptic.proof.change import WIDER, Change, because, inexcusable
from symhaptic.proof.checks import Sign
from symhaptic.proof.seal import KEY
from symhaptic.proof.sign import Fact, Interval, NotShown

_BUSY = 100
"""Pieces after which a wider box counts as not confirmed."""

_Assumption: TypeAlias = tuple[Expr, bool]


def remade(fact: Fact, place: int, new: Any, **otherwise: Any) -> Sign:
    """A fact made again with one argument changed."""
    assert fact.made is not None
    args = (*fact.made.args[:place], new, *fact.made.args[place + 1 :])
    return Sign(replace(fact, made=replace(fact.made, args=args), key=KEY, **otherwise))


@dataclass(frozen=True)
class Part:
    """An argument of a rule with one thing changed, and the assumption that this weakens."""

    kind: str
    what: str
    new: Any
    weakened: tuple[_Assumption, _Assumption] | None = None
    excuse: Callable[[], str | None] = inexcusable


def weaker_parts(arg: Any, alone: bool = True) -> Iterator[Part]:
    """Changes of what a fact is made from, ``alone`` or as one factor of many."""
    if isinstance(arg, Fact):
        yield from _weaker(arg, alone)
    elif isinstance(arg, Interval):
        try:
            longer = Interval(arg.variable, arg.lower - 1, *arg.held)
        except NotShown:
            return
        [old], [new] = arg.above.rests, longer.above.rests
        yield Part("domain", f"{arg.variable} from {longer.lower} on", longer, (old, new))
    elif isinstance(arg, Sequence):
        for i, factor in enumerate(arg):
            before, after = arg[:i], arg[i + 1 :]
            if factor != 1:
                named = factor.expr if isinstance(factor, Fact) else factor
                yield Part("formula", f"{named} dropped", [*before, *after])
            for part in weaker_parts(factor, alone=False):
                yield replace(part, new=[*before, part.new, *after])
    elif isinstance(arg, (int, Expr)) and arg != 0:
        yield Part("formula", f"{arg} plus 1", arg + 1)
        yield Part("formula", f"{arg} negated", -arg)


def _weaker(fact: Fact, alone: bool) -> Iterator[Part]:
    """A fact that says less: x > -1 for x > 0, or x >= 0 where that matters."""
    assumed = fact.made is None and fact.rests == {(fact.expr, fact.strict)}
    others = [
        (replace(fact, expr=fact.expr + 1, key=KEY), f"{fact.expr} > -1 for > 0", inexcusable)
    ]
    if fact.strict and (alone or assumed):
        what = f"{fact.expr} >= 0 for > 0"
        others.append(
            (
                replace(fact, strict=False, key=KEY),
                what,
                because("holds there, too: another term is strict"),
            )
        )
    for other, what, excuse in others:
        if assumed:
            old, new = (fact.expr, fact.strict), (other.expr, other.strict)
            weaker = replace(other, rests=frozenset({new}), key=KEY)
            yield Part("domain", what, weaker, (old, new), excuse)
        else:
            yield Part("formula", what, other, None, excuse)


def wider_boxes(fact: Fact, box: Box, given: Given | None) -> Iterator[Change]:
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
    return Sign(replace(fact, made=made, rests=rests, key=KEY))


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

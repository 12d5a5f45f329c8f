"""A spring is passive just where the damper bears hold and delay."""

from __future__ import annotations

from symhaptic.book.lemmas.linear_part import passive_below
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import limits
from symhaptic.rules.other_loops import UNDAMPED

HERE = Given(T > 0, b > 0, d >= 0, K >= 0, whole(d))


@cache
def behind_a_delay(rule: Any) -> Theorem:
    """passive <=> the rule, for B = 0 and integer delays."""
    rule, still = proposition(rule), {B: S.Zero}
    room = show(b + B - K * T * (d + HALF) >= 0, assume(b - K * T * (d + HALF) >= 0), Eq(B, 0))
    enough = inst(passive_below(room), still)
    enough = HERE.closed(enough, HERE.show(b - K * T * (d + HALF) >= 0, rule))
    needed = show(rule, inst(limits()[1], still))
    return HERE.closed(either_way(enough, needed, rule, UNDAMPED))


@cache
def without_delay(rule: Any) -> Theorem:
    """passive <=> K T/(2 b) <= 1, without delay."""
    place, zero = Symbol("q"), show(Eq(S.Zero, d), Eq(d, 0))
    exact = behind_a_delay(b >= K * T / 2 + K * d * T)
    here = HERE.and_(Eq(d, 0))
    here.have(1 / b > 0)
    plain = exact.conclusion.of[0]  # type: ignore[attr-defined]
    rule = proposition(rule)
    there = mp(exact, here.show(plain, rule))
    back = here.show(rule, mp(exact, assume(UNDAMPED)))
    found = either_way(there, back, rule, UNDAMPED)
    at_once = subst(whole(place), place, fact(whole(0)), zero)
    return closed(here.closed(found), at_once)


def differs(rule: Any, point: Mapping[Any, Any]) -> Theorem:
    """That a rule and passivity differ at a wall in numbers, with an integer delay."""
    exact = inst(behind_a_delay(b >= K * T / 2 + K * d * T), point)
    exact = closed(exact, *map(fact, exact.hypotheses))
    bound, passive = exact.conclusion.of  # type: ignore[attr-defined]
    denial = not_intro(mp(exact, assume(passive)), number(negated(bound)), passive)
    met = number(proposition(rule).at(point))
    same = Iff((met.conclusion, passive))
    return not_intro(mp(assume(same), met), denial, same)

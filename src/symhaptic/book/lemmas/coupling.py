"""A coupling by spring and damper, a virtual mass beside a spring, and a step of backward Euler."""

from __future__ import annotations

from symhaptic.book.lemmas.decided import SI
from symhaptic.book.lemmas.filtered_wall import decides
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import by_sign_of_damping
from symhaptic.book.lemmas.virtual_mass import free
from symhaptic.notation import f_v, k, v, x
from symhaptic.rules.coupling import AFTER, BEFORE, NEXT_V, NEXT_X, SPRUNG, STEP


@cache
def _exact() -> Theorem:
    """passive <=> K T/2 + B <= b and K T/2 - B <= b, for K >= 0: no filter."""
    found = inst(decides(), {f_v: S.Zero})
    return closed(found, fact(Relation(S.Zero, "<=", S.Zero)), fact(Relation(S.Zero, "<", S.One)))


def passive_by_device(bound: Any) -> Theorem:
    """A coupling is passive if the damping of the device is enough."""
    fast, slow = _exact().conclusion.of[0].parts  # type: ignore[attr-defined]
    up, down = magnitude(B), magnitude(B, negative=True)
    push, brake = assume(B >= 0), positive(-B >= 0, B < 0)
    damped = conj(positive(fast, [bound], [up, -1]), positive(slow, [bound], [up, -1], [2, push]))
    driven = conj(
        positive(fast, [bound], [down, -1], [2, brake]), positive(slow, [bound], [down, -1])
    )
    return mp(_exact(), by_sign_of_damping(damped, closed(driven, positive(B <= 0, B < 0))))


def drives(point: Mapping[Any, Any]) -> Theorem:
    """That a coupling in numbers is not passive."""
    exact = inst(_exact(), point)
    exact = closed(exact, *map(fact, exact.hypotheses))
    bounds, passive = exact.conclusion.of  # type: ignore[attr-defined]
    denial = not_all(bounds, number(negated(bounds.parts[0])))
    return not_intro(mp(exact, assume(passive)), denial, passive)


def fades_alone() -> Theorem:
    """What is stable beside a spring is stable alone: m_v/(2m) is the product of the zeros."""
    last = last_coefficient(assume(SPRUNG))
    below = conjunct(last, last.conclusion.parts[1])
    at_once = inst(free(), {d: S.Zero})
    at_once = closed(at_once, identity(S.Zero, S.Zero))
    bound = at_once.conclusion.of[0]  # type: ignore[attr-defined]
    return mp(at_once, SI.closed(positive(bound, [2, m > 0, below])))


def loses_energy() -> Theorem:
    """After a step there is not more energy than before."""
    moved, sped = (assume(proposition(e)) for e in STEP)
    lost = [S.Half, m > 0, square(v - NEXT_V)], [S.Half, k > 0, square(x - NEXT_X)]
    return positive(AFTER <= BEFORE, *lost, [moved, k * NEXT_X], [sped, m * NEXT_V])

"""Which virtual masses are passive, alone and beside a spring and a damper."""

from __future__ import annotations

from symhaptic.book.lemmas.decided import decided_by
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import PI, cosine_bounds
from symhaptic.notation import m_v
from symhaptic.proof.theorems.energy import toeplitz
from symhaptic.rules.other_loops import FREELY, HEAVY

BOUND: Any = proposition(b >= K * T / 2 + B + 2 * m_v / T)
LIGHT = proposition(b * T / 2 >= m_v)
MARGIN: Any = proposition(
    b - K * T / 2 + B * cos(theta) + m_v * (cos(theta) - cos(2 * theta)) / T >= 0
)
HERE = Given(T > 0, B >= 0, m_v >= 0)
HERE.have(1 / T > 0)


@cache
def by_angle() -> Theorem:
    """passive <=> H(1) >= 0 and the margin of the rule at every angle."""
    taps = map(fact, map(whole, range(3)))
    return HERE.closed(toeplitz(HEAVY.of[0], z, HEAVY.of[1], theta), *taps)


@cache
def decides() -> Theorem:
    """passive <=> the bound, for K, B, m_v >= 0."""
    static, always = by_angle().conclusion.of[1].of  # type: ignore[attr-defined]
    above, below = cosine_bounds(theta)
    there = HERE.and_(*INSIDE, sine_of_half(theta), above, below)
    inside = [assume(p) for p in INSIDE]
    known = at(conjunct(mp(by_angle(), assume(HEAVY)), always), {theta: theta}, *inside)
    margin = there.closed(positive(MARGIN, [T > 0, known]))
    limit = tends(MARGIN.right, theta, pi, BOUND.right - BOUND.left)
    weak = prove_hyp(in_the_limit(margin, theta, S.Zero, pi, HERE.closed(limit)), PI)
    needed = HERE.closed(combined(BOUND, [weak]))
    share = HERE.show(1 / T > 0)
    turn = square(sin(theta))
    rows = (
        [share, BOUND],
        [share, B >= 0, above],
        [share, share, m_v >= 0, above],
        [2, share, share, m_v >= 0, turn],
    )
    raw = there.closed(positive(always.body.of[1], *rows))
    at_rest = HERE.closed(positive(static, [K >= 0]))
    enough = mp(by_angle(), conj(at_rest, for_all([theta], INSIDE, raw)))
    return HERE.closed(either_way(enough, needed, BOUND, HEAVY))


@cache
def alone() -> Theorem:
    """The same of a virtual mass without spring and damper: m_v <= bT/2."""
    none = Eq(K, 0), Eq(B, 0)
    here = HERE.and_(*none)
    there = mp(decides(), here.show(BOUND, LIGHT))
    back = here.show(LIGHT, mp(decides(), assume(HEAVY)))
    return here.closed(either_way(there, back, LIGHT, HEAVY))


@cache
def free() -> Theorem:
    """Without delay a virtual mass of a free mass is stable <=> m_v < 2m, for m_v >= 0."""
    place = Symbol("q")
    found = decided_by(FREELY.at({d: S.Zero}), 2 * m > m_v, given=(m_v >= 0,))
    zero = show(Eq(S.Zero, d), Eq(d, 0))
    bound = found.conclusion.of[0]  # type: ignore[attr-defined]
    return subst(Iff((bound, FREELY.at({d: place}))), place, found, zero)


def gives_energy(point: Mapping[Any, Any]) -> Theorem:
    """That a wall in numbers, which meets the bound of a virtual mass alone, is not passive."""
    found = inst(decides(), point)
    found = closed(found, *map(fact, found.hypotheses))
    bound, passive = found.conclusion.of  # type: ignore[attr-defined]
    denial = not_intro(mp(found, assume(passive)), number(negated(bound)), passive)
    same = Iff((LIGHT.at(point), passive))
    return not_intro(mp(assume(same), number(LIGHT.at(point))), denial, same)


def swings_up(point: Mapping[Any, Any]) -> Theorem:
    """That m_v < 2m does not decide about a delayed virtual mass in numbers."""
    bound, stable = proposition(2 * m > m_v).at(point), FREELY.at(point)
    same = Iff((bound, stable))
    outside = root_outside(stable.terms[0], z)
    return not_intro(mp(assume(same), number(bound)), outside, same)

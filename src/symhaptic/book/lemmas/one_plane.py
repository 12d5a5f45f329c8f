"""Figs. 11 and 13: what the curves of passive and of stable walls are, and which lies inside."""

from __future__ import annotations

from functools import cache
from typing import Any

from sympy import Expr, S, cos

from symhaptic.book.lemmas.boundary import at_rest, zero_on_circle_is_explicit
from symhaptic.book.lemmas.normalised_boundary import ON_CURVE, above_in_units, in_units
from symhaptic.book.lemmas.passive_is_stable import LOOP, NUMBERS, passive_is_stable
from symhaptic.book.lemmas.walls import HALF, LITTLE, margins, met, unstable
from symhaptic.notation import (
    B,
    K,
    T,
    alpha,
    b,
    beta,
    d,
    delta,
    gamma,
    m,
    omega,
    omega_hat,
    theta,
    z,
)
from symhaptic.notation.proposition import ForAll, Proposition, Relation, whole
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import STABLE, passive
from symhaptic.paper.propositions.passivity import BORDER
from symhaptic.paper.propositions.plots import solid
from symhaptic.paper.propositions.stability import at_angle
from symhaptic.paper.ranges import DAMPED, STIFF
from symhaptic.proof.theorems.familiar import (
    bounded,
    device_exists,
    loop_of_device,
    not_negative,
    ordered,
    square,
)
from symhaptic.proof.theorems.judge import Case, taken_apart
from symhaptic.proof.theorems.kernel import (
    Theorem,
    absurd,
    anything,
    applied,
    assume,
    by_cases,
    chosen,
    conjoined,
    discharged,
    part,
    placed,
    weakened,
    widened,
)
from symhaptic.proof.theorems.leaves import combined, identity, is_whole, number
from symhaptic.proof.theorems.roots import zero_on_circle
from symhaptic.proof.theorems.tactics import (
    at,
    closed,
    counterexample,
    denied_by,
    example,
    fact,
    for_all,
    positive,
    zero_beyond,
)

UNIT = {m: S.One, T: S.One, K: alpha, B: beta, b: DAMPED, delta: DAMPED}
"""Mass, period and damper of Fig. 11."""


def passive_curve(claim: Any) -> Theorem:
    """The walls of (27) for delta = 0.02, and no others, are on the boundary; d is whole."""
    found = []
    for implication, made in zip(claim.of, (in_units(), above_in_units(ON_CURVE)), strict=True):
        given, there = implication.of[0], placed(made, UNIT)
        known = [fact(h) for h in there.hypotheses if not h.free]
        there = closed(there, *known, *_same(there))
        if implication is claim.of[1]:
            there = closed(there, part(assume(given), BORDER.at(UNIT)))
        found.append(discharged(there, given))
    return conjoined(*found)


def _same(theorem: Theorem) -> list[Theorem]:
    """alpha = alpha and so on."""
    equal = [h for h in theorem.hypotheses if isinstance(h, Relation) and h.left == h.right]
    return [identity(h.left, h.right) for h in equal]


@cache
def stable_curve() -> Theorem:
    """What is said of the curve of stable walls, for a whole delay and every plant."""
    exact, never = solid().of  # type: ignore[attr-defined]
    walls, inside, _ = taken_apart(exact)
    on_it = for_all(walls, inside, weakened(zero_on_circle_is_explicit(), *inside))
    readings = loop_of_device(NUMBERS, LOOP)
    loop = part(readings, readings.conclusion.parts[1])
    zeros = loop.conclusion.parts[1].terms[0]
    steps = [is_whole(d + n, assume(whole(d))) for n in (1, 2, 3)]
    none = denied_by(loop, closed(zero_on_circle(zeros, z, theta, assume(at_angle())), *steps))
    walls, inside, _ = taken_apart(never)
    return conjoined(on_it, for_all(walls, inside, weakened(closed(none, *steps), *inside)))


@cache
def right_of_the_line() -> Theorem:
    """-gamma < alpha of a stable wall beside a damped device, behind a whole delay."""
    static, pushed = at_rest()
    readings = loop_of_device(NUMBERS, LOOP)
    loop = part(readings, readings.conclusion.parts[1])
    zeros = loop.conclusion.parts[1].terms[0]
    left = assume(Relation(alpha, "<=", -gamma))
    away = positive(-gamma - alpha >= 0, [left])
    value = combined(Relation(zeros.subs(z, 1), "<=", S.Zero), [pushed, away], [static, 1])
    steps = [is_whole(d + n, assume(whole(d))) for n in (1, 2, 3)]
    denial = denied_by(loop, zero_beyond(zeros, z, value))
    never = chosen(device_exists(gamma, delta, NUMBERS), closed(denial, *steps))
    wanted = Relation(-gamma, "<", alpha)
    outside = anything(absurd(assume(STABLE), never), wanted)
    return by_cases(ordered(-gamma, alpha), assume(wanted), outside)


@cache
def inside(spring: Expr = gamma) -> Theorem:
    """A wall of (5) for delta = 0.02 with 0 < alpha is stable beside a spring; d is whole."""
    found = closed(part(passive_is_stable(), STABLE), margins(passive()))
    found = closed(found, positive(alpha + gamma > 0, alpha > 0, gamma >= 0))
    found = placed(found, {delta: DAMPED, gamma: spring})
    return closed(found, *(fact(h) for h in found.hypotheses if not h.free))


@cache
def in_one_plane() -> Theorem:
    """Fig. 11, for whole delays."""
    symbols, given, then = taken_apart(CLAIMED["fig11"](()))
    arm = {gamma: STIFF, delta: DAMPED}
    curve, *_, left, region = then.of  # type: ignore[attr-defined]
    passive_ = passive_curve(curve)
    solid_ = placed(stable_curve(), arm)
    line = placed(right_of_the_line(), arm)
    line = closed(line, *(fact(h) for h in line.hypotheses if not h.free))
    line = for_all(left.over, [left.body.of[0]], line)
    within = discharged(inside(STIFF), *region.of[0].of)
    low = closed(conjoined(passive_, solid_, line, within), not_negative(assume(whole(d))))
    more = [*given, whole(d)]
    return for_all(symbols, more, weakened(low, *more))


@cache
def up_to_nyquist() -> Theorem:
    """Fig. 13, for whole delays."""
    symbols, given, then = taken_apart(CLAIMED["fig13"](()))
    *curves, region = then.of  # type: ignore[attr-defined]
    found = []
    for claim, damper in zip(curves, (DAMPED, S.Zero), strict=True):
        springs = claim.body.of[0].of
        found.append(
            for_all([gamma], springs, weakened(placed(stable_curve(), {delta: damper}), *springs))
        )
    springs = region.of[1].body.of[0].of
    robust = for_all([gamma], springs, weakened(inside(), *springs))
    found.append(discharged(robust, *region.of[0].of))
    low = closed(conjoined(*found), not_negative(assume(whole(d))))
    more = [*given, whole(d)]
    return for_all(symbols, more, weakened(low, *more))


HALF_LATE = {alpha: LITTLE, beta: LITTLE / 2, delta: DAMPED, d: S.Half}
"""A wall that meets (5) half a period late, and is not stable by (18): in the root of z."""


@cache
def meets_the_condition() -> Theorem:
    """(5), which wants alpha cos(omega/2) - beta cos(3 omega/2) of the damper."""
    slow, fast = omega / 2, 3 * omega / 2
    turns = [[HALF * LITTLE, t] for t in (square(1 - cos(slow)), bounded(cos, slow))]
    turns += [[HALF * LITTLE / 2, t] for t in (square(1 + cos(fast)), bounded(cos, fast))]
    return met(HALF_LATE, *turns, [DAMPED - 3 * LITTLE / 2])


def half_late(id: str, but: Proposition) -> Case:
    """What Figs. 11 and 13 show of d = 0.5 is not so of this wall."""
    claim = CLAIMED[id](())
    _, [delays], then = taken_apart(claim)
    case = {**HALF_LATE, omega_hat: S.One}
    there = then.at(case)
    region = there.of[-1]  # type: ignore[attr-defined]
    right = number(Relation(S.Zero, "<", LITTLE))
    held = applied(part(assume(there), region), conjoined(right, meets_the_condition()))
    spring = STIFF
    if isinstance(held.conclusion, ForAll):
        spring = S.Zero
        ends = [fact(p.at({gamma: spring})) for p in held.conclusion.body.of[0].of]  # type: ignore[attr-defined]
        held = at(held, {gamma: spring}, *ends)
    denied = absurd(held, unstable({**HALF_LATE, gamma: spring}), there)
    some = widened(identity(S.Half, S.Half), delays.at(case))
    symbols = {s: v for s, v in case.items() if s in claim.over}  # type: ignore[attr-defined]
    return counterexample(claim, symbols, some, denied, but=but)


def drawn_at(id: str) -> Case:
    """A point of the figure, without delay."""
    claim = CLAIMED[id](())
    symbols, [delays], _ = taken_apart(claim)
    point = dict.fromkeys(symbols, S.One) | {d: S.Zero}
    some = widened(identity(S.Zero, S.Zero), delays.at(point))
    return example(point, [delays, whole(d)], some)

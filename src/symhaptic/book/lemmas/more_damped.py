"""Without delay a wall that is stable with an arm of (23) is stable with a more damped one.

The largest of Jury's minors is positive on one side of the curve that bounds the stable walls, and
it rises with the damper.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp
from sympy import Eq, Rational, S

from symhaptic.book.lemmas.figure9 import valued
from symhaptic.book.lemmas.marginal import LIMIT, NEAR
from symhaptic.book.lemmas.passive_is_stable import DEVICE, NUMBERS
from symhaptic.book.lemmas.stiffest_stable import (
    WIDEST,
    damping_between,
    inequalities,
    no_stiffer,
    of_every_plant,
    on_box,
    towards,
)
from symhaptic.book.lemmas.undelayed_curve import apart_of, between, needed, plants
from symhaptic.notation import alpha, beta, d, delta, gamma, n_0, n_1
from symhaptic.notation.proposition import And, Implies, Or, Relation, negated, proposition
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.plots import CURVE
from symhaptic.paper.propositions.stability import HEAVIER
from symhaptic.paper.ranges import DAMPED, RANGES, STIFF
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, SLOPES, named
from symhaptic.proof.plants import NUMBERS as SAMPLED
from symhaptic.proof.theorems.familiar import device_exists, of_device, ordered
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
)
from symhaptic.proof.theorems.leaves import combined, more_damped, number
from symhaptic.proof.theorems.tactics import closed, none_of, not_all, over, positive

OTHERS = sp.symbols("n_1'' n_0'' a'' e''")
UNDELAYED_ARM = Or(
    (And((proposition(Eq(d, 0)), proposition(gamma <= STIFF), proposition(HEAVIER <= DAMPED))),)
)
"""No delay, and both arms of (23)."""
SIDES = {**RANGES, alpha: (-STIFF, 1), beta: (-1, Rational(21, 10))}


@cache
def minor_rises() -> Theorem:
    """The minor of a wall rises with the damper, on a box of arms and walls."""
    minor: Any = inequalities(0)[-1].conclusion.right  # type: ignore[attr-defined]
    by_balls = minor.subs(BALLS)
    slope = sp.diff(by_balls, delta) + sum(
        sp.diff(by_balls, x) * dx for x, dx in zip(SAMPLED, SLOPES, strict=True)
    )
    names = {s: s for s in (*SAMPLED, *SLOPES)}
    found = box.positive(sp.expand(slope), SIDES, named(names))
    certificate: Any = found.certificates[0]
    return more_damped(certificate, minor, HEAVIER, OTHERS)


@cache
def above_minus_one() -> Theorem:
    """-1 < beta of a stable wall."""
    *planes, minor = inequalities(0)
    low, high, inside = damping_between(0, RANGES)
    wide = {**RANGES, beta: (-WIDEST, WIDEST)}
    toward = towards(planes, minor, inside, wide)
    first, late = planes[0], on_box(n_0, RANGES)
    total = on_box(n_0 + n_1, RANGES)
    static = of_device("device at rest", assume(DEVICE))
    pushed = combined((alpha + gamma) * (n_0 + n_1) > 0, [first], [static])
    near = over(alpha + gamma > 0, pushed, total)
    value: Any = minor.conclusion.right  # type: ignore[attr-defined]
    weight = n_0 * (1 + n_1 * beta)
    rest = sp.expand(value + (alpha + gamma) * weight)
    below = on_box(-rest, {**RANGES, beta: (-WIDEST, -1)})
    product = combined(Relation(value, "<=", S.Zero), [below], [late, toward, near])
    wanted = Relation(-S.One, "<", beta)
    no = anything(absurd(minor, product), wanted)
    found = by_cases(ordered(-S.One, beta), assume(wanted), no)
    return of_every_plant(closed(found, low, high, apart_of(total)))


@cache
def more_damped_is_stable() -> Theorem:
    """stable with delta gives stable with delta' > delta, for arms of (23) without delay."""
    minor = inequalities(0)[-1]
    low, high, _ = damping_between(0, RANGES)
    known = plants()
    bound = over(CURVE - alpha > 0, assume(minor.conclusion), known["weight"])
    apart = [apart_of(known[n]) for n in ("weight", "late", "toward", "total")]
    left = closed(combined(alpha < CURVE, [bound]), *apart)
    right = part(needed(), alpha > -gamma)
    rise = minor_rises()
    after = rise.conclusion.right  # type: ignore[attr-defined]
    other = {delta: HEAVIER, **dict(zip(NUMBERS, OTHERS, strict=True))}
    there = closed(placed(left, other), positive(after > 0, [minor], [rise]))
    same = placed(between(), other)
    found = applied(same, conjoined(right, there))
    above = above_minus_one()
    softer = no_stiffer(0, (LIMIT, NEAR), RANGES)
    steep = LIMIT.coeff(delta)
    ends = [
        positive(beta >= -1, [above]),
        positive(alpha >= -STIFF, [right], gamma <= STIFF),
        positive(alpha <= 1, [softer], [steep, delta <= DAMPED], [1 - LIMIT.subs(delta, DAMPED)]),
    ]
    found = closed(closed(found, low, high, *ends), above, *ends)
    found = of_every_plant(chosen(device_exists(gamma, HEAVIER, OTHERS), found))
    less = positive(delta <= DAMPED, delta < HEAVIER, HEAVIER <= DAMPED)
    return closed(found, less, positive(HEAVIER >= 0, delta >= 0, delta < HEAVIER))


@cache
def grown() -> Theorem:
    """The same under UNDELAYED_ARM, with d in its place."""
    here = Implies((STABLE.at({d: S.Zero}), STABLE.at({d: S.Zero, delta: HEAVIER})))
    bare = discharged(more_damped_is_stable(), here.of[0])
    with_delay = Implies((STABLE, STABLE.at({delta: HEAVIER})))
    found = applied(valued(with_delay, d, S.Zero, bare), assume(STABLE))
    return by_cases(assume(UNDELAYED_ARM), found)


STIFF_ONE = {
    alpha: S(-4),
    beta: Rational(59, 10),
    gamma: S(5),
    delta: Rational(6, 5),
    HEAVIER: Rational(3, 2),
    d: S.Zero,
}
"""A wall that more damping makes unstable, beside a stiff spring."""


@cache
def excluded() -> Theorem:
    """It is not of (23)."""
    claim: Any = UNDELAYED_ARM.at(STIFF_ONE)
    return none_of(claim, *(not_all(p, number(negated(p.of[1]))) for p in claim.of))

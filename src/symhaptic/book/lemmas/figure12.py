"""Fig. 12: the largest stable stiffness of five delays, and how the ratio runs with the delay."""

import itertools

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.figure9 import each_value
from symhaptic.book.lemmas.near_tip import Arm, none_above, rounded, tip, wall_below
from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import at_arm, at_peak, least, of_delay
from symhaptic.book.lemmas.stiffest_stable import numbers_known
from symhaptic.paper.propositions.ratio import (
    FALLEN,
    FINE,
    NEAR,
    OTHER,
    PEAKS,
    RATE,
    SHOWN,
    WALL,
    below,
    grows,
)
from symhaptic.paper.propositions.stability import SQUARE, damping, stiffness


def rightmost(claim: Any, arm: Arm, delay: int) -> Theorem:
    """A wall of the boundary is as stiff as all stable ones, and one of these nearly as it."""
    symbols, given, then = taken_apart(claim)
    tip_: Any = then
    angle, (limit, bounded), (wall, stable) = (
        tip(arm, delay)[2],
        none_above(arm, delay),
        wall_below(arm, delay),
    )
    here = dict(zip((gamma, delta), arm, strict=True))
    ranges = {s: (v, v) for s, v in here.items()}

    def on_curve(expr: Expr) -> Theorem:
        found = inst(at_point(expr, ranges), here)
        return numbers_known(found)

    size, half = SQUARE.xreplace({theta: angle}), cos(angle / 2)
    height = stiffness(S(delay)).xreplace({theta: angle})
    curve = {
        theta: angle,
        tip_.over[1]: height / (half * size),
        tip_.over[2]: damping(S(delay)).xreplace({theta: angle}) / (sin(angle) * size),
    }
    apart = [not_zero(on_curve(size))]
    there = tip_.body.at(curve)
    parts: list[Theorem] = []
    for part_ in there.of[:2]:
        parts.append(fact(part_))
    parts.append(conj(*(identity(p.left, p.right) for p in there.of[2].of)))
    most, near = there.of[3:]
    bottom = on_curve(half * size)
    more = over(
        Relation(S.Zero, "<", (1 + FINE) * curve[tip_.over[1]] - limit),
        on_curve((1 + FINE) * height - limit * half * size),
        bottom,
    )
    wanted = most.body.of[1]
    parts.append(for_all(WALL, [most.body.of[0]], positive(wanted, [bounded], [more])))
    less = over(
        Relation(S.Zero, "<", wall[0] - (1 - FINE) * curve[tip_.over[1]]),
        on_curve(wall[0] * half * size - (1 - FINE) * height),
        bottom,
    )
    values = dict(zip(OTHER, wall, strict=True))
    close = near.body.at(values).of[1]
    parts.append(exists(conj(stable, positive(close, [less])), near, values))
    found = exists(conj(*parts), tip_, curve)
    found = closed(found, *apart, not_zero(bottom), *apart)
    return for_all(symbols, given, add_assum(found, *given))


def rises(arm: Arm, delay: int, later: int) -> Theorem:
    """eta(d) < rho < eta(d'), with rho between what two bounds say."""
    low = least(delay, arm[1]).conclusion.right / wall_below(arm, delay)[0][0]  # type: ignore[attr-defined]
    high = least(later, arm[1]).conclusion.right / none_above(arm, later)[0]  # type: ignore[attr-defined]
    share = rounded(float(low + high) / 2)
    some: Any = at_arm(grows(delay, later), arm)
    under = some.body.at({RATE: share}).of[0]
    found = conj(of_delay(under, delay, arm), at_peak(later, share, arm))
    return exists(found, some, {RATE: share})


@cache
def drawn() -> Theorem:
    """All of Fig. 12."""
    tips = CLAIMED["fig12"](()).of[0]  # type: ignore[attr-defined]
    symbols, given, then = taken_apart(tips)

    def build(known: dict[Any, Expr]) -> Theorem:
        arm: Arm = (known[gamma], DAMPED)
        return rightmost(then.at(known), arm, int(known[symbols[1]]))

    found = each_value(then, dict(zip(symbols, given, strict=True)), build)
    shown = [for_all(symbols, given, found)]
    for spring, later in PEAKS.items():
        arm: Arm = (spring, DAMPED)
        delays = (*SHOWN, *later)
        shown += [rises(arm, *pair) for pair in itertools.pairwise(delays)]
        shown.append(at_peak(later[-1], NEAR, arm))
        shown.append(of_delay(at_arm(below(FALLEN[spring], 1000), arm), 1000, arm))
    return conj(*shown)

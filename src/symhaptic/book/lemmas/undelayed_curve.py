"""Without delay the stable walls of an arm of (23) lie between a line and a curve."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import (
    WIDEST,
    damping_between,
    inequalities,
    on_box,
    towards,
)
from symhaptic.paper.propositions.plots import CURVE, undelayed

BETWEEN = both([alpha > -gamma, alpha < CURVE])
WALLS = both([beta > -1, *BETWEEN.parts])
NEAR, ROOM = alpha + gamma, 1 - n_0 * beta
TOTAL, WEIGHT = n_0 + n_1, n_0 * (1 + n_1 * beta)
WIDE = {**RANGES, beta: (-1, WIDEST)}
MOST = Integer(10)


@cache
def plants() -> dict[str, Theorem]:
    """What is known of the numbers of a device of (23)."""
    toward = show(1 + n_1 * beta > 0, on_box(1 - n_1, RANGES), on_box(n_1, RANGES), beta > -1)
    late = on_box(n_0, RANGES)
    return {
        "static": of_device("device at rest", assume(DEVICE)),
        "late": late,
        "total": on_box(TOTAL, RANGES),
        "weight": positive(WEIGHT > 0, [late, toward]),
        "toward": toward,
    }


@cache
def needed() -> Theorem:
    """A stable wall lies between them."""
    first, _, _, minor = inequalities(0)
    known = plants()
    right = by_multiple(alpha > -gamma, known["total"], [first], [known["static"]])
    left = by_multiple(alpha < CURVE, known["weight"], [minor])
    return closed(
        conj(right, left), *(not_zero(known[n]) for n in ("total", "weight", "late", "toward"))
    )


@cache
def enough() -> Theorem:
    """A wall between them is stable, for -1 < beta."""
    loop = by_inequalities(0)
    first, second, third, minor = loop.conclusion.of[1].of  # type: ignore[attr-defined]
    left = assume(BETWEEN.parts[1])
    known = plants()
    static = known["static"]
    apart = [not_zero(known[n]) for n in ("weight", "late", "toward")]
    inner = closed(combined(minor, [left, known["weight"]]), *apart)
    room = _room(inner, minor.right)
    below = by_multiple(beta < WIDEST, known["late"], [room], [on_box(n_0 * WIDEST - 1, RANGES)])
    push = on_box(2 * WEIGHT + (n_1 - n_0) * ROOM, WIDE)
    share = _share(second.right * ROOM - 2 * minor.right)
    plane = by_multiple(second, room, [2, inner], [alpha > -gamma, push], [static, share])
    rest = on_box(expand(WEIGHT * (MOST - NEAR) - minor.right), WIDE)
    reach = by_multiple(NEAR < MOST, known["weight"], [inner], [rest])
    flat = on_box(third.right, {**WIDE, alpha: (-STIFF, MOST)})
    at_one = positive(first, [known["total"], alpha > -gamma], [static, -S.One])
    found = mp(loop, conj(at_one, plane, flat, inner))
    here = Given(alpha > -gamma, gamma >= 0, gamma <= STIFF, beta > -1)
    return here.closed(closed(found, *apart), closed(below, *apart), closed(reach, *apart))


def _share(expr: Expr) -> Expr:
    """How often 1 - a + e = gamma (n_1 + n_0) is in it."""
    return derivative(sp.expand(expr), a)


def _room(inner: Theorem, minor: Expr) -> Theorem:
    """0 < 1 - n_0 beta: otherwise the minor is not positive."""
    known = plants()
    no = assume(ROOM <= 0)
    late = by_multiple(beta > 1, known["late"], [no], [on_box(1 - n_0, RANGES)])
    heavy = positive(
        1 - e + gamma * n_0 + beta * TOTAL > 0,
        [known["total"], late],
        [on_box(TOTAL + 1 - e + gamma * n_0, RANGES)],
    )
    share = [known["static"], -_share(minor)]
    less = positive(minor <= 0, [heavy, no], [alpha > -gamma, known["weight"]], share)
    return by_contradiction(ROOM > 0, inner, less)


@cache
def away() -> tuple[Expr, Theorem]:
    """The minor, negative for -2.1 <= beta <= -1 but for what alpha > -gamma takes from it."""
    value: Any = inequalities(0)[-1].conclusion.right  # type: ignore[attr-defined]
    rest = sp.expand(value + (alpha + gamma) * n_0 * (1 + n_1 * beta))
    return value, on_box(-rest, {**RANGES, beta: (-WIDEST, -1)})


@cache
def above_minus_one() -> Theorem:
    """-1 < beta of a stable wall."""
    *planes, minor = inequalities(0)
    low, high, inside = damping_between(0, RANGES)
    toward = towards(planes, minor, inside, {**RANGES, beta: (-WIDEST, WIDEST)})
    total = on_box(TOTAL, RANGES)
    static = of_device("device at rest", assume(DEVICE))
    near = by_multiple(alpha + gamma > 0, total, [planes[0]], [static])
    return of_every_plant(closed(above_one(minor, toward, near), low, high))


def above_one(minor: Theorem, toward: Theorem, near: Theorem) -> Theorem:
    """-1 < beta, from 0 <= minor, 0 < 1 + n_1 beta and 0 < alpha + gamma."""
    value, below = away()
    negative = positive(value < 0, [below], [on_box(n_0, RANGES), toward, near])
    return by_contradiction(beta > -1, minor, negative)


@cache
def between() -> Theorem:
    """stable <=> above beta = -1 and between them."""
    above, sides = above_minus_one(), needed()
    known = conj(above, *(conjunct(sides, p) for p in BETWEEN.parts))
    return either_way(closed(known, above), enough(), undelayed(), WALLS)

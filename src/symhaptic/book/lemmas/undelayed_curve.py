"""Without delay the stable walls of an arm of (23) lie between a line and a curve."""

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import (
    WIDEST,
    damping_between,
    inequalities,
    of_every_plant,
    on_box,
    towards,
)
from symhaptic.paper.propositions.plots import CURVE, undelayed

BETWEEN = both([alpha > -gamma, alpha < CURVE])
WALLS = both([beta > -1, *BETWEEN.parts])
NEAR, ROOM = alpha + gamma, 1 - n_0 * beta
TOTAL, WEIGHT = n_0 + n_1, n_0 * (1 + n_1 * beta)
WIDE = {**RANGES, beta: (-1, sp.Rational(21, 10))}
MOST = sp.Integer(10)


@cache
def plants() -> dict[str, Theorem]:
    """What is known of the numbers of a device of (23)."""
    toward = positive(
        1 + n_1 * beta > 0, [on_box(1 - n_1, RANGES)], [on_box(n_1, RANGES), beta > -1]
    )
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
    right = over(NEAR > 0, combined(NEAR * TOTAL > 0, [first], [known["static"]]), known["total"])
    left = over(CURVE - alpha > 0, combined(minor.conclusion, [minor]), known["weight"])
    found = conj(positive(alpha > -gamma, [right]), combined(alpha < CURVE, [left]))
    return closed(found, *(not_zero(known[n]) for n in ("total", "weight", "late", "toward")))


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
    near = positive(NEAR > 0, alpha > -gamma)
    room = _room(inner, near, minor.right)
    below = over(
        sp.Rational(21, 10) - beta > 0,
        positive(
            n_0 * (sp.Rational(21, 10) - beta) > 0,
            [room],
            [on_box(n_0 * sp.Rational(21, 10) - 1, RANGES)],
        ),
        known["late"],
    )
    sides = positive(beta >= -1, beta > -1), positive(beta <= sp.Rational(21, 10), [below])
    push = on_box(2 * WEIGHT + (n_1 - n_0) * ROOM, WIDE)
    product = combined(
        second.right * ROOM > 0,
        [2, inner],
        [near, push],
        [static, _share(second.right * ROOM - 2 * minor.right)],
    )
    plane = over(second, product, room)
    reach = over(
        MOST - NEAR > 0,
        combined(
            WEIGHT * (MOST - NEAR) > 0,
            [inner],
            [
                on_box(
                    WEIGHT * (MOST + alpha)
                    - WEIGHT * alpha
                    - WEIGHT * gamma
                    - sp.expand(minor.right + alpha * WEIGHT),
                    WIDE,
                )
            ],
        ),
        known["weight"],
    )
    far = {**WIDE, alpha: (-STIFF, MOST)}
    flat = closed(
        on_box(third.right, far),
        positive(alpha >= -STIFF, alpha > -gamma, gamma <= STIFF),
        closed(positive(alpha <= MOST, [reach], gamma >= 0), *apart),
    )
    at_one = combined(first, [known["total"], near], [static, -S.One])
    found = mp(loop, conj(at_one, plane, flat, inner))
    return closed(found, *sides, *apart, not_zero(room), *sides, *apart)


def _share(expr: Expr) -> Expr:
    """How often 1 - a + e = gamma (n_1 + n_0) is in it."""
    return derivative(sp.expand(expr), a)


def _room(inner: Theorem, near: Theorem, minor: Expr) -> Theorem:
    """0 < 1 - n_0 beta: otherwise the minor is not positive."""
    known = plants()
    claim, no = Relation(S.Zero, "<", ROOM), assume(Relation(ROOM, "<=", S.Zero))
    late = over(
        beta - 1 > 0, positive(n_0 * (beta - 1) > 0, [no], [on_box(1 - n_0, RANGES)]), known["late"]
    )
    heavy = positive(
        1 - e + gamma * n_0 + beta * TOTAL > 0,
        [known["total"], late],
        [on_box(TOTAL + 1 - e + gamma * n_0, RANGES)],
    )
    less = combined(
        Relation(minor, "<=", S.Zero),
        [heavy, no],
        [near, known["weight"]],
        [known["static"], -_share(minor)],
    )
    return disj_cases(ordered(S.Zero, ROOM), assume(claim), contr(not_intro(inner, less), claim))


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
    pushed = combined((alpha + gamma) * TOTAL > 0, [planes[0]], [static])
    near = over(alpha + gamma > 0, pushed, total)
    found = above_one(minor, toward, near)
    return of_every_plant(closed(found, low, high, not_zero(total)))


def above_one(minor: Theorem, toward: Theorem, near: Theorem) -> Theorem:
    """-1 < beta, from 0 <= minor, 0 < 1 + n_1 beta and 0 < alpha + gamma."""
    value, below = away()
    negative = combined(Relation(value, "<", S.Zero), [below], [on_box(n_0, RANGES), toward, near])
    wanted = Relation(-S.One, "<", beta)
    no = contr(not_intro(minor, negative), wanted)
    return disj_cases(ordered(-S.One, beta), assume(wanted), no)


@cache
def between() -> Theorem:
    """stable <=> above beta = -1 and between them."""
    above, sides = above_minus_one(), needed()
    known = conj(above, *(conjunct(sides, p) for p in BETWEEN.parts))
    return either_way(closed(known, above), enough(), undelayed(), WALLS)

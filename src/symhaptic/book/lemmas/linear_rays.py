"""Each ray from the start of the line meets the boundary once, for d = 0 and d = 1.

Walls are counted from the start of the line, A = alpha + gamma and b = beta + delta + (d + 1/2)
gamma. On a ray Jury's largest minor is not negative at the start and concave.
"""

from symhaptic.book.lemmas.line_crossing import AT_REST, ROOM, divided, room
from symhaptic.book.lemmas.linear_boundary import LOW, TOP, level, minor, turn
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.model.circle import powers, quotient

A, b, A_1, b_1, y = symbols("A b A_1 b_1 y")
"""Two walls in these coordinates, and a share of the way along a ray."""


def share(delay: int) -> Expr:
    """d + 1/2."""
    return delay + HALF


def coordinates(delay: int) -> dict[Symbol, Expr]:
    """A and b by the wall."""
    return {A: alpha + gamma, b: beta + delta + share(delay) * gamma}


@cache
def minor_at(delay: int) -> Expr:
    """The minor as a function of A and b, without a."""
    wall = {alpha: A - gamma, beta: b - delta - share(delay) * gamma}
    return expanded(minor(delay).xreplace({a: AT_REST}).xreplace(wall))


def box(delay: int) -> dict[Symbol, tuple[Any, Any]]:
    """Arms, and walls by their A and b, for beta <= 0."""
    wide, high = (0, TOP[delay] + STIFF), (LOW, DAMPED + share(delay) * STIFF)
    return {**RANGES, A: wide, A_1: wide, b: high, b_1: high}


def slope(delay: int, by: Symbol, to: Symbol) -> Expr:
    """The minor's divided difference."""
    return divided(minor_at(delay), by, to)


def on(delay: int, expr: Expr) -> Theorem:
    """0 < expr for all arms and walls."""
    ranges = box(delay)
    return on_box(expr, {s: ranges[s] for s in ranges if s in RANGES or s in expr.free_symbols})


@cache
def zero(delay: int) -> Theorem:
    """The minor is zero at a wall of the boundary with beta <= 0.1, by its A and b."""
    value = minor_at(delay).xreplace(coordinates(delay))
    return combined(Relation(value, "=", S.Zero), [level(delay)], turn(minor(delay)))


@cache
def stiffer(delay: int) -> Theorem:
    """A < A_1 for b < b_1, of two walls with a minor of zero."""
    value = minor_at(delay)
    there = value.xreplace({A: A_1, b: b_1})
    up = on(delay, slope(delay, b, b_1))
    down = on(delay, -slope(delay, A, A_1))
    later = inst(up, {A: A_1})
    back = assume(A_1 <= A)
    gain = positive(Relation(S.Zero, "<", there - value), [b < b_1, later], [back, down])
    none = combined(Relation(there - value, "=", S.Zero), [zero_of(there)], [zero_of(value), -1])
    return by_contradiction(A < A_1, gain, none)


def zero_of(value: Expr) -> Theorem:
    """The value is zero, as assumed."""
    return assume(Relation(value, "=", S.Zero))


def bent(delay: int) -> Expr:
    """-f[0, y, 1] of the minor f along the ray to (A_1, b_1)."""
    way = minor_at(delay).xreplace({A: y * A_1, b: y * b_1})
    rising = powers(way, y)
    return expanded(-Add(*(c * y**i for k, c in rising.items() for i in range(k - 1))))


@cache
def bent_downwards(delay: int) -> Theorem:
    """0 < -f[0, y, 1], for 0 < A_1 and 0 < b_1."""
    value = bent(delay)
    wide, high, along = assume(A_1 > 0), assume(b_1 > 0), assume(y >= 0)
    rows: list[list[Any]] = []
    small = Rational(1, 100) if delay else S.Zero
    if small:
        rows.append([small / 2, square(A_1 - b_1)])
    parts = {
        (i, j, k): part_
        for k, of_y in powers(value, y).items()
        for i, of_both in powers(of_y, A_1).items()
        for j, part_ in powers(of_both, b_1).items()
    }
    added = {(1, 1, 0): small, (2, 0, 0): -small / 2, (0, 2, 0): -small / 2}
    for i, j, k in {(i, j, k) for i in range(3) for j in range(4) for k in range(2)}:
        part_ = parts.get((i, j, k), S.Zero) + added.get((i, j, k), 0)
        if part_ != 0:
            rows.append([*[wide] * i, *[high] * j, *[along] * k, on(delay, part_)])
    return combined(Relation(S.Zero, "<", value), *rows)


@cache
def wedge(delay: int) -> Theorem:
    """b A_1 < b_1 A for b < b_1, of two walls with 0 < A, 0 < A_1 and a minor of zero."""
    wanted = b * A_1 < b_1 * A
    less = stiffer(delay)
    low = positive(wanted, [b < b_1, A_1 > 0], [b_1 <= 0, less])
    outer = contr(_above_the_ray(delay), wanted)
    high = disj_cases(ordered(b * A_1, b_1 * A), assume(wanted), outer)
    return closed(disj_cases(ordered(S.Zero, b_1), high, low), less)


def _above_the_ray(delay: int) -> Theorem:
    """Falsehood, from b_1 A <= b A_1: the wall would lie above the ray to the other one."""
    value = minor_at(delay)
    there = value.xreplace({A: A_1, b: b_1})
    lift = inst(on(delay, slope(delay, b, b_1)), {A: y * A_1, b: y * b_1, b_1: b})
    here = value.xreplace({A: y * A_1})
    gain = positive(
        here > 0,
        [y * b_1 <= b, lift],
        [y < 1, at_start(delay)],
        [zero_of(there), -y],
        [y > 0, y < 1, bent_downwards(delay)],
    )
    found = inst(not_intro(gain, zero_of(here)), {y: A / A_1})
    top, high = box(delay)[A][1], box(delay)[b][1]
    small = top >= A_1, b_1 <= high
    return Given(A > 0, A_1 > 0, b_1 > 0, A < A_1, b_1 * A <= b * A_1, *small).closed(found)


@cache
def start_by_gap(delay: int) -> Expr:
    """How often the gap is in the minor at the start of the line."""
    return quotient(minor_at(delay).xreplace({A: S.Zero, b: S.Zero}), ROOM)


@cache
def at_start(delay: int) -> Theorem:
    """The minor is not negative at the start of the line."""
    first = minor_at(delay).xreplace({A: S.Zero, b: S.Zero})
    return combined(Relation(S.Zero, "<=", first), [room(), on_box(start_by_gap(delay), RANGES)])

"""How stiff a stable wall can be without delay and with one period of delay, for all plants of a
box.

By Jury's inequalities: a wall that is given by the plant's gamma and delta is stable if they hold
on the box.  The last of them, of the largest minor, falls with the stiffness: where it fails at
one stiffness for every damping, no stiffer wall is stable.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.model import circle
from symhaptic.proof import box
from symhaptic.proof.plants import AT_ONE, BALLS, LATE, LOSS, TOGETHER, named

Ranges = Mapping[Symbol, tuple[Any, Any]]

WIDEST = Rational(21, 10)
"""No stable wall has a larger virtual damping, of either sign, as 1 < 2.1 n_0."""

PART = Rational(2, 5)
"""So much of the minor's curvature in beta is enough."""

P, M = sp.symbols("P M")
SMALL = {LOSS: LOSS, P: 1 - TOGETHER, M: S.Half - LATE, AT_ONE: AT_ONE}
"""The plant's numbers as what they differ by from those of a free mass, so that balls are small."""
FREE = {TOGETHER: 1 - P, LATE: S.Half - M}
NEAR_FREE = {name: value.xreplace(FREE) for name, value in {**BALLS, n_0: LATE}.items()}


def on_box(expr: Expr, ranges: Ranges) -> Theorem:
    """0 < f of the plant's numbers on a box, by balls."""
    return _on_box(sp.sympify(expr), tuple(ranges.items()))


@cache
def _on_box(expr: Expr, sides: tuple[tuple[Symbol, tuple[Any, Any]], ...]) -> Theorem:
    ranges = dict(sides)
    small = circle.expanded(expr.xreplace(NEAR_FREE))
    certificate = box.positive(small, ranges, named(SMALL))
    return combined(Relation(S.Zero, "<", expr), [on_plants(certificate)])


def stable_wall(delay: int, wall: tuple[Expr, Expr], ranges: Ranges) -> Theorem:
    """The wall, given by gamma and delta, is stable for all plants of the box."""
    loop = inst(by_inequalities(delay), dict(zip((alpha, beta), wall, strict=True)))
    known = [
        combined(wanted, [on_box(wanted.right, ranges)])  # type: ignore[attr-defined]
        for wanted in conjuncts(loop.conclusion.of[1])  # type: ignore[attr-defined]
    ]
    return of_every_plant(mp(loop, conj(*known)))


@cache
def inequalities(delay: int) -> tuple[Theorem, ...]:
    """What Jury's inequalities say of a stable wall; the last is that of the minor."""
    loop = by_inequalities(delay)
    found = mp(loop, assume(loop.conclusion.of[0]))  # type: ignore[attr-defined]
    return tuple(conjunct(found, p) for p in conjuncts(found.conclusion))


def damping_between(delay: int, ranges: Ranges, widest: Expr = WIDEST) -> tuple[Theorem, ...]:
    """-2.1 <= beta <= 2.1 and n_0 beta < 1 of a stable wall: n_0 beta is a product of zeros."""
    late = S(delay)
    zeros = zeros_of_stable(alpha, beta, gamma, delta, late)
    last = closed(last_coefficient(zeros), fact(whole(late)))
    low, high = (conjunct(last, p) for p in conjuncts(last.conclusion))
    weight, room = (on_box(f, ranges) for f in (n_0, widest * n_0 - 1))
    least = by_multiple(widest + beta > 0, weight, [room], [high])
    most = by_multiple(widest - beta > 0, weight, [room], [low])
    ends = positive(beta >= -widest, [least]), positive(beta <= widest, [most])
    return (*ends, positive(1 - n_0 * beta > 0, [low]))


def no_stiffer(delay: int, wall: tuple[Expr, Expr], ranges: Ranges) -> Theorem:
    """alpha < that of ``wall`` for every stable wall and all plants of the box; d is 0 or 1.

    The minor is largest near the damping of ``wall``.
    """
    low, high, inside = damping_between(delay, ranges)
    *planes, minor = inequalities(delay)
    wide = {**ranges, beta: (-WIDEST, WIDEST)}
    value = minor.conclusion.right  # type: ignore[attr-defined]
    limit, _ = wall
    stiff, weight = assume(alpha >= limit), on_box(n_0, ranges)
    if delay == 0:
        falls = [[stiff, weight, towards(planes, minor, inside, wide)]]
    else:
        slope = -derivative(value, alpha).xreplace({alpha: limit})
        falls = [[stiff, on_box(slope, wide)], [stiff, stiff, weight, weight]]
    falling = combined(Relation(value, "<=", S.Zero), [fails(value, wall, wide)], *falls)
    found = by_contradiction(Relation(alpha, "<", limit), minor, falling)
    return of_every_plant(closed(found, low, high))


def fails(minor: Expr, wall: tuple[Expr, Expr], wide: Ranges) -> Theorem:
    """0 < -minor at the stiffness of the wall, for every beta: by its square in beta."""
    stiffness, near = wall
    off = sp.Symbol("u")
    there = circle.powers(minor.xreplace({alpha: stiffness, beta: near + off}), off)
    height, tilt, bend, *more = (there.get(n, S.Zero) for n in range(max(there) + 1))
    rest = -(bend + PART) - sum(more) * (beta - near)
    least = on_box(-4 * PART * height - tilt**2, {s: wide[s] for s in (gamma, delta)})
    bent = [square(beta - near), on_box(rest, wide)]
    middle = square(2 * PART * (beta - near) - tilt)
    share = 1 / (4 * PART)
    below = -minor.xreplace({alpha: stiffness})
    return combined(Relation(S.Zero, "<", below), [share, middle], [share, least], bent)


def towards(planes: Any, minor: Theorem, inside: Theorem, wide: Ranges) -> Theorem:
    """0 < 1 + n_1 beta of a wall that is stable without delay."""
    at_one, second, third = planes
    one, two, three = (t.conclusion.right for t in planes)
    between = circle.expanded(8 - one - two - three)
    middle = by_multiple(between > 0, second, [at_one, third], [8, minor])
    value: Expr = minor.conclusion.right  # type: ignore[attr-defined]
    toward = 1 + n_1 * beta
    rest = circle.quotient(n_0 * toward * between - (n_1 + n_0) * value, 1 - n_0 * beta)
    height = value * (n_1 + n_0)
    products = [on_box(n_0, wide), toward <= 0, middle], [inside, on_box(rest, wide)]
    up = positive(height > 0, [minor, on_box(n_1 + n_0, wide)])
    return by_contradiction(toward > 0, up, positive(height <= 0, *products))

"""The walls that put a zero of the loop at exp(j theta), and where that curve begins."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.stability import SQUARE, at_angle, damping, on_boundary, stiffness


@cache
def apart() -> tuple[Theorem, ...]:
    """sin(theta) != 0 and cos(theta/2) != 0 for 0 < theta < pi."""
    quarter = number(Relation(S.Zero, "<", sp.pi / 2))
    low = positive(theta / 2 > -sp.pi / 2, [HALF, theta > 0], [quarter])
    high = positive(theta / 2 < sp.pi / 2, [HALF, theta < sp.pi])
    wide = closed(sign_of(cos, theta / 2), low, high)
    return (
        positive(Ne(sin(theta), 0), [sign_of(sin, theta)]),
        positive(Ne(cos(theta / 2), 0), [wide]),
    )


@cache
def zero_on_circle_is_explicit() -> Theorem:
    """p(exp(j theta)) = 0 <=> alpha = alpha(theta) and beta = beta(theta), where N is not zero."""
    return explicit_wall(at_angle(), on_boundary(), n_1 * exp(I * theta) + n_0, SQUARE)


def explicit_wall(root: Proposition, wall: Proposition, top: Expr, square_: Expr) -> Theorem:
    """That, of a zero ... + top ((alpha + beta) z - beta) = 0 and the size of its factor."""
    turn = exp(I * theta)
    back = mirror(top) / (turn * square_)
    height = back / (2 * I * sin(theta))
    across = back / 2 - tan(theta / 2) * back / (2 * I)
    zero = assume(root)
    other = mirrored(zero)
    stiff, damped = (assume(p) for p in wall.parts)
    there = conj(
        combined(stiff.conclusion, [zero, across], [other, mirror(across)]),
        combined(damped.conclusion, [zero, height], [other, mirror(height)]),
    )
    here = combined(root, [stiff, top * turn], [damped, top * (turn - 1)])
    return closed(either_way(there, here, root, wall), *apart())


@cache
def numerator_on_circle() -> Theorem:
    """|N|^2 != 0 at exp(j theta), 0 < theta < pi, for a device with a damper.

    A held force that turns does work, so that it moves the device.
    """
    energy = held_steady_state(assume(DEVICE), theta)
    turn = exp(I * theta)
    way = (turn - 1) * (n_1 * turn + n_0)
    work = energy.conclusion.terms[1]
    along, across = (way + mirror(way)) / 2, (way - mirror(way)) / (2 * I)
    size = combined(way * mirror(way) >= 0, [square(along)], [square(across)])
    moved = positive(work > 0, [energy], [size, delta > 0])
    bottom = turn**2 - a * turn + e
    rest = (turn - 1) * mirror(turn - 1) * bottom * mirror(bottom)
    other = (way * mirror(bottom) - mirror(way) * bottom) / (2 * I)
    product = combined(SQUARE * rest > 0, [moved, moved], [square(other)])
    low = positive(theta <= sp.pi, theta < sp.pi)
    return closed(factor(SQUARE, product, rest), low)


CORNER = -(2 - a - gamma * n_1) / (n_1 + n_0) - gamma * d
"""The damping with which the boundary begins, on alpha = -gamma."""


def begins(delay: Expr = d, corner: Expr = CORNER) -> Proposition:
    """At theta -> 0 the boundary is at (-gamma, corner)."""
    across = stiffness(delay) / (cos(theta / 2) * SQUARE)
    up = damping(delay) / (sin(theta) * SQUARE)
    return And(
        (
            Predicate("limit", (theta,), (across, S.Zero, -gamma)),
            Predicate("limit", (theta,), (up, S.Zero, corner)),
        )
    )


@cache
def begins_there(delay: Expr = d, lower: Expr = S.Zero) -> Theorem:
    """Where the boundary begins, of a damped device with its four numbers."""
    static, pushed = at_rest()
    total = n_1 + n_0
    apart = positive(Ne(total, 0), [pushed]), positive(Ne(sp.expand(total**2), 0), [pushed, pushed])
    wanted = begins(delay, CORNER - lower)
    found = []
    for claim in wanted.parts:
        expr, start, value = claim.terms
        raw = -(1 - a + e) / total
        if value != -gamma:
            raw = -(2 - a + delay * (1 - a + e)) / total + n_1 * (1 - a + e) / total**2
        limit = closed(tends(expr, theta, start, raw), *apart)
        # both values differ by a multiple of what is zero
        share = sp.cancel(derivative(raw - value, gamma) / derivative(static_difference(), gamma))
        equal = closed(combined(Relation(raw, "=", value), [static, -share]), *apart)
        place = Symbol("q")
        pattern = Predicate("limit", (theta,), (expr, start, place))
        found.append(closed(subst(pattern, place, limit, equal), *apart))
    return conj(*found)


def static_difference() -> Expr:
    """gamma (n_1 + n_0) - (1 - a + e), which is zero."""
    return gamma * (n_1 + n_0) - (1 - a + e)


def at_rest() -> tuple[Theorem, Theorem]:
    """1 - a + e = gamma (n_1 + n_0) and 0 < n_1 + n_0, of a damped device."""
    rest = device_at_rest(assume(DEVICE))
    static, pushed, _ = (conjunct(rest, claim) for claim in rest.conclusion.parts)
    return static, pushed

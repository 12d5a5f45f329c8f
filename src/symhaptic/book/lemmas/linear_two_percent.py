"""From which damping on the error exceeds 2 per cent for a wall that pushes, with beta < 0.

On the ray of this error Jury's minor is concave: where it is negative at alpha = 0, so it is for
all stiffer walls.
"""

from symhaptic.book.lemmas.line_crossing import slow
from symhaptic.book.lemmas.linear_boundary import LOW
from symhaptic.book.lemmas.linear_error import small, wall
from symhaptic.book.lemmas.linear_far import beyond, quotient
from symhaptic.book.lemmas.linear_gap import MOST, narrow
from symhaptic.book.lemmas.linear_rays import (
    A_1,
    A,
    at_start,
    b_1,
    bent_downwards,
    box,
    coordinates,
    minor_at,
    share,
    slope,
    start_by_gap,
    zero_of,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.paper.propositions.linear_error import (
    BETWEEN,
    LEVEL,
    PUSHING,
    error,
    on_boundary_at,
    size,
)

STEEP = 1 - LEVEL
"""How steep the ray of an error of -2 per cent is, beside the line."""


@cache
def within(delay: int, most: Expr) -> Theorem:
    """(26) is at most 2 per cent for gamma = 0.001 and delta <= most, alpha >= 0 and beta < 0."""
    place, walls = coordinates(delay), wall(delay)
    weight, value = share(delay), error(delay)
    above = closed(
        inst(_above_the_ray(delay, most), place), *walls, show(place[A] >= gamma, alpha >= 0)
    )
    top = positive((place[b] - STEEP * weight * place[A]) / weight >= 0, [1 / weight, above])
    least = combined(value >= -LEVEL, [quotient(top, walls[1])])
    found = closed(at_most(size(delay), LEVEL, small(delay), least), not_zero(walls[1]))
    return Given(beta < 0, delta <= most).closed(of_every_plant(found), slow())


def at_most(of: Expr, level: Expr, below: Theorem, above: Theorem) -> Theorem:
    """|x| <= c from x <= c, or x < c, and -c <= x."""
    value, wanted = of.args[0], Relation(of, "<=", level)
    up = closed(combined(wanted, [below], [magnitude(value)]), show(value >= 0, value > 0))
    down = combined(wanted, [above], [magnitude(value, True)])
    return disj_cases(ordered(S.Zero, value), up, down)


def _above_the_ray(delay: int, most: Expr) -> Theorem:
    """0.98 (d + 1/2) A <= b of a wall with a minor of zero and gamma <= A."""
    steep, value = STEEP * share(delay), minor_at(delay)
    on_ray = value.xreplace({b: steep * A})
    top, high = (box(delay)[s][1] for s in (A, b))
    wide = {**RANGES, A: (0, top), b: (LOW, high), b_1: (LOW, steep * top)}
    lift = inst(on_box(slope(delay, b, b_1), wide), {b_1: steep * A})
    gain = positive(on_ray > 0, [b < steep * A, lift], [zero_of(value), -S.One])
    way = on_ray.xreplace({A: y * A})
    bent_ = inst(bent_downwards(delay), {A_1: A, b_1: steep * A})
    products = [way < 0], [y <= 1, at_start(delay)], [y > 0, y <= 1, bent_]
    less = positive(y * on_ray <= 0, *products)
    never = not_intro(positive(y * on_ray > 0, [y > 0, gain]), less)
    wanted = Relation(steep * A, "<=", b)
    found = closed(inst(contr(never, wanted), {y: gamma / A}), _below_at_gamma(delay, most))
    found = Given(A > 0, top >= A, gamma >= STIFF, gamma <= A).closed(found)
    return disj_cases(ordered(b, steep * A), found, assume(wanted))


def _below_at_gamma(delay: int, most: Expr) -> Theorem:
    """The minor is negative on the ray at A = gamma: by its rate, and as the gap is narrow."""
    steep, value = STEEP * share(delay), minor_at(delay)
    on_ray = value.xreplace({b: steep * A})
    part_ = start_by_gap(delay)
    rate = expanded((on_ray - on_ray.xreplace({A: S.Zero})) / A).xreplace({A: gamma})
    arms = {gamma: (STIFF, STIFF), delta: (0, most)}
    falls = on_box(expanded(-rate - part_ * MOST / gamma), arms)
    heavy = on_box(part_, RANGES)
    claim = Relation(on_ray.xreplace({A: gamma}), "<", S.Zero)
    return combined(claim, [show(gamma > 0, gamma >= STIFF), falls], [heavy, narrow()])


# -- the claims ------------------------------------------------------------------------


SPRINGS = {0: Rational(983, 1000), 1: Rational(972, 1000)}
"""y/gamma of the wall that is taken."""


@cache
def on_either_side() -> Theorem:
    """What the claim ``threshold`` concludes, under its hypotheses."""
    found = []
    for delay, (low, high) in BETWEEN.items():
        found.append(disch(gen(nowhere_at(delay), alpha, beta), delta <= low))
        ranges = {gamma: (STIFF, STIFF), delta: (high, DAMPED)}
        there = beyond(delay, SPRINGS[delay], S.Zero, ranges)
        found.append(disch(_stiff(there), delta >= high))
    return conj(*found)


def nowhere_at(delay: int) -> Theorem:
    """The implication of the claim ``nowhere``, for gamma = 0.001 and delta up to the threshold."""
    found = within(delay, BETWEEN[delay][0])
    given = [on_boundary_at(delay), *PUSHING]
    return _stiff(disch(found, *given))


def _stiff(theorem: Theorem) -> Theorem:
    """For gamma = 0.001."""
    ends = (Relation(S.Zero, "<=", STIFF), Relation(STIFF, "<=", STIFF))
    return closed(inst(theorem, {gamma: STIFF}), *map(number, ends))

"""From which damping on the error exceeds 2 per cent for a wall that pushes, with beta < 0.

On the ray of this error Jury's minor is bent downwards: where it is negative at alpha = 0, so it is
for all stiffer walls.
"""

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.line_crossing import slow
from symhaptic.book.lemmas.linear_boundary import HIGH, LOW
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
from symhaptic.book.lemmas.stiffest_stable import of_every_plant, on_box
from symhaptic.model.circle import expanded
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
    above = closed(inst(_above_the_ray(delay, most), place), *walls)
    above = closed(above, positive(place[A] >= gamma, alpha >= 0))
    top = positive((place[b] - STEEP * weight * place[A]) / weight >= 0, [1 / weight, above])
    least = combined(value >= -LEVEL, [quotient(top, walls[1])])
    wanted = Relation(size(delay), "<=", LEVEL)
    up = combined(wanted, [small(delay)], [magnitude(value)])
    down = combined(wanted, [least], [magnitude(value, True)])
    up = closed(up, positive(value >= 0, value > 0))
    found = closed(disj_cases(ordered(S.Zero, value), up, down), not_zero(walls[1]))
    ends = (
        positive(beta <= 0, beta < 0),
        positive(beta <= HIGH, beta < 0, [HIGH]),
        positive(delta <= DAMPED, delta <= most, [DAMPED - most]),
    )
    return closed(of_every_plant(found), *ends, slow())


def _above_the_ray(delay: int, most: Expr) -> Theorem:
    """0.98 (d + 1/2) A <= b of a wall with a minor of zero and gamma <= A."""
    steep, value = STEEP * share(delay), minor_at(delay)
    on_ray = value.xreplace({b: steep * A})
    top, high = (box(delay)[s][1] for s in (A, b))
    wide = {**RANGES, A: (0, top), b: (LOW, high), b_1: (LOW, steep * top)}
    lift = inst(on_box(slope(delay, b, b_1), wide), {b_1: steep * A})
    contrary = assume(b < steep * A)
    above = Relation(S.Zero, "<", on_ray)
    gain = combined(above, [contrary, lift], [zero_of(value), -S.One])
    way = on_ray.xreplace({A: y * A})
    along, rest = assume(y > 0), assume(y <= 1)
    bent_ = inst(bent_downwards(delay), {A_1: A, b_1: steep * A})
    less = combined(
        Relation(y * on_ray, "<=", S.Zero),
        [assume(Relation(way, "<", S.Zero))],
        [rest, at_start(delay)],
        [along, rest, bent_],
    )
    never = not_intro(positive(y * on_ray > 0, [along, gain]), less)
    wanted = Relation(steep * A, "<=", b)
    found = inst(contr(never, wanted), {y: gamma / A})
    width = assume(A > 0)
    ends = (
        _below_at_gamma(delay, most),
        over(gamma / A > 0, gamma > 0, width),
        over(gamma / A >= 0, gamma >= 0, width),
        combined(
            gamma / A <= 1,
            [over((A - gamma) / A >= 0, positive(A - gamma >= 0, gamma <= A), width)],
        ),
        positive(gamma > 0, gamma >= STIFF, [STIFF]),
        positive(steep * A > 0, [steep, width]),
        positive(steep * A >= LOW, [steep, width], [-LOW]),
        positive(steep * A <= steep * top, [steep, top >= A]),
        positive(A >= 0, width),
        not_zero(width),
    )
    found = closed(found, *ends)
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
    return combined(claim, [positive(gamma > 0, gamma >= STIFF, [STIFF]), falls], [heavy, narrow()])


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

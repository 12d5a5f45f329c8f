"""The error of the linear condition along the boundary, for d = 0 and d = 1.

From the start of the line a wall is seen under the slope b/A = (d + 1/2) (1 + error).
"""

from symhaptic.book.lemmas.linear_boundary import LOW, on_it
from symhaptic.book.lemmas.linear_rays import (
    A_1,
    A,
    at_start,
    b_1,
    box,
    coordinates,
    minor_at,
    on,
    share,
    slope,
    wedge,
    zero,
    zero_of,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.paper.propositions.linear import LATE
from symhaptic.paper.propositions.linear_error import LATER, LEVEL, beside, error, on_boundary_at


@cache
def wall(delay: int) -> tuple[Theorem, ...]:
    """What the lemmas ask of the wall (alpha, beta) of the boundary, by its A and b."""
    inside = on_it(delay)
    stiff, low = (conjunct(inside, claim) for claim in conjuncts(inside.conclusion))
    left = conjunct(assume(on_boundary_at(delay)), -gamma < alpha)
    right, up = (coordinates(delay)[s] for s in (A, b))
    top, high = box(delay)[A][1], box(delay)[b][1]
    arm = gamma >= 0, gamma <= STIFF, delta >= 0, delta <= DAMPED
    here = Given(beta <= 0, *arm).and_(left, stiff, low)
    claims = right > 0, right >= 0, right <= top, up >= LOW, up <= high
    return zero(delay), *map(here.show, claims)


def later(theorem: Theorem) -> Theorem:
    """The same of the other wall."""
    return inst(theorem, dict(zip((alpha, beta), LATER, strict=True)))


@cache
def rises(delay: int) -> Theorem:
    """The error rises along the boundary, and is less than 2 per cent, while beta <= 0."""
    first, second = coordinates(delay), {s: beside(v) for s, v in coordinates(delay).items()}
    both_ = first | dict(zip((A_1, b_1), second.values(), strict=True))
    walls = wall(delay)
    others = [later(t) for t in walls]
    here = Given(beta < LATER[1], LATER[1] <= 0)
    turned = here.closed(closed(inst(wedge(delay), both_), *walls, *others))
    one, other = error(delay), beside(error(delay))
    width = [walls[1], others[1]]
    size = positive(share(delay) * first[A] * second[A] > 0, [share(delay), *width])
    gap = over(other - one > 0, show(second[b] * first[A] - first[b] * second[A] > 0, turned), size)
    rise = closed(combined(one < other, [gap]), *map(not_zero, (*width, size)))
    return here.closed(of_every_plant(conj(rise, later(small(delay)))))


@cache
def small(delay: int) -> Theorem:
    """The error is less than 2 per cent, for beta <= 0."""
    place, walls = coordinates(delay), wall(delay)
    steep = (1 + LEVEL) * share(delay)
    below = Given(beta <= 0).closed(closed(inst(below_the_ray(delay), place), *walls))
    gap = (steep * place[A] - place[b]) / share(delay)
    found = over(LEVEL - error(delay) > 0, positive(gap > 0, [1 / share(delay), below]), walls[1])
    return closed(combined(error(delay) < LEVEL, [found]), not_zero(walls[1]))


BEND = {0: Rational(76, 100), 1: Rational(19, 10)}
"""How much the minor of a softer wall exceeds that on the ray, for its damping."""


@cache
def below_the_ray(delay: int) -> Theorem:
    """b < 1.02 (d + 1/2) A of a wall with a minor of zero and beta <= 0."""
    value, steep = minor_at(delay), (1 + LEVEL) * share(delay)
    contrary = steep * A <= b
    lift = inst(on(delay, slope(delay, b, b_1)), {b: steep * A, b_1: b})
    damped = delta + share(delay) * gamma
    on_ray = value.xreplace({b: steep * A})
    along = expanded((on_ray - on_ray.xreplace({A: S.Zero})) / A)
    rate = along - BEND[delay] * (damped - steep * A)
    high = box(delay)[b][1]
    narrow = on_box(rate, {**RANGES, A: (0, high / steep)})
    here = Given(A > 0, contrary, b <= damped, b <= high)
    least = here.show(damped - steep * A >= 0)
    products = [contrary, lift], [at_start(delay)], [A > 0, narrow], [BEND[delay], A > 0, least]
    gain = here.closed(positive(value > 0, *products))
    return by_contradiction(b < steep * A, gain, zero_of(value))


@cache
def risen() -> Theorem:
    """What the claim ``rises`` concludes, under its hypotheses."""
    found = []
    for delay in LATE:
        here = on_boundary_at(delay)
        walls = [here, here.at(dict(zip((alpha, beta), LATER, strict=True)))]
        found.append(disch(Given(beta < LATER[1], LATER[1] <= 0).closed(rises(delay)), *walls))
    return conj(*found)

"""Polygons inside and around the stable regions of one arm, for integer delays."""

from symhaptic.book.lemmas.figure9 import right_of_the_line
from symhaptic.book.lemmas.more_damped import more_damped_is_stable
from symhaptic.book.lemmas.outpaced import at_point, on_this_side
from symhaptic.book.lemmas.polygon import all_stable
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.spring_box import bounds
from symhaptic.paper.propositions import areas
from symhaptic.paper.propositions.ratio import ARM

ANGLES = {
    1: ("0.54798", "0.55486", "0.67669", "0.79081"),
    2: ("0.35447", "0.37002", "0.45349", "0.5318"),
    3: ("0.26331", "0.27911", "0.34295", "0.40249"),
    4: ("0.20967", "0.22495", "0.27668", "0.32497"),
    5: ("0.17434", "0.189", "0.23254", "0.27341"),
    6: ("0.14921", "0.1634", "0.20126", "0.23665"),
    7: ("0.13041", "0.14426", "0.17765", "0.20911"),
    8: ("0.11588", "0.12941", "0.15959", "0.18776"),
}
"""At which angles the boundary touches the sides of the outer polygons but the first two."""

HERE = {s: (v, v) for s, v in ARM.items()}
PLANT: areas.Wall = (ARM[gamma], ARM[delta])


@cache
def lowest(delay: int) -> Theorem:
    """A first minor of Hurwitz' is positive for every stable wall: linear in alpha and beta."""
    found = first_minors(zeros_of_stable(alpha, beta, gamma, delta, S(delay)), 1)
    _, second = conjuncts(found.conclusion)
    return closed(conjunct(found, second), fact(whole(S(delay))))


@cache
def above_the_line(delay: int, side: areas.Side) -> Theorem:
    """p alpha + q beta <= c, q < 0, of every stable wall, from that minor."""
    p, q, c = side
    minor = lowest(delay)
    value: Expr = minor.conclusion.right  # type: ignore[attr-defined]
    weight = value.expand().coeff(beta)
    # weight (c - p alpha - q beta)/(-q) less the minor is linear in alpha
    rest = (weight * (c - p * alpha - q * beta) / -q - value).expand()
    steep = rest.coeff(alpha)
    room = (rest - steep * (alpha + gamma)).expand()
    right = _right(delay)
    heavy = at_point(weight, HERE)
    product = combined(
        weight * (c - p * alpha - q * beta) / -q > 0,
        [minor],
        [at_point(steep, HERE), positive(alpha + gamma > 0, [right])],
        [at_point(room, HERE)],
    )
    return closed(over((c - p * alpha - q * beta) / -q > 0, product, heavy), not_zero(heavy))


@cache
def _right(delay: int) -> Theorem:
    """-gamma < alpha of a stable wall."""
    return closed(inst(right_of_the_line(), {d: S(delay)}), fact(whole(S(delay))))


@cache
def around(delay: int) -> Theorem:
    """All stable walls lie in the outer polygon."""
    left, low, *others = areas.outer(delay)
    known = [combined(areas.within([left])[0], [_right(delay)], [assume(gamma <= ARM[gamma])])]
    shown = [above_the_line(delay, low)]
    for side, angle in zip(others, ANGLES[delay], strict=True):
        shown.append(on_this_side(side, delay, Rational(angle), HERE))
    for side, theorem in zip((low, *others), shown, strict=True):
        share = S.One if side is not low else -low[1]
        known.append(combined(areas.within([side])[0], [share, theorem]))
    there = numbers_known(inst(of_every_plant(conj(*known)), ARM))
    claim: Any = areas.in_polygon(delay, areas.outer(delay)).at(ARM)
    return for_all((alpha, beta), [claim.body.of[0]], there)


@cache
def inside(delay: int) -> Theorem:
    """All walls of the inner polygon are stable."""
    return all_stable(PLANT, delay, areas.inner(delay))


@cache
def delay_takes_area() -> Theorem:
    """Each period takes area from the region of the arm of Figs. 11 and 12."""
    found = []
    for delay in range(areas.LONGEST):
        *_, less = areas.smaller(delay).of  # type: ignore[attr-defined]
        found.append(conj(inside(delay), around(delay + 1), number(less)))
    return conj(*found)


@cache
def damper_adds() -> Theorem:
    """With more damping all stable walls stay stable, without delay."""
    return as_claimed(areas.kept_by_the_damper(), more_damped_is_stable())


@cache
def mass_adds() -> Theorem:
    """Twice the mass: more area of walls (K, B)."""
    _, rectangle, less = areas.grown_with_the_mass().of  # type: ignore[attr-defined]
    heavy = all_stable((areas.HEAVY[gamma], areas.HEAVY[delta]), 0, areas.INSIDE)
    wall = {name: numbers_known(inst(t, ARM)) for name, t in bounds().items()}
    softer = positive(areas.AROUND[2][2] - alpha > 0, [wall["left"]], [ARM[gamma]])
    ways = [wall["right"], wall["up"], softer, wall["down"]]
    given, goals = conjuncts(rectangle.body.of[0]), conjuncts(rectangle.body.of[1])
    known = [combined(goal, [way]) for goal, way in zip(goals, ways, strict=True)]
    return conj(heavy, for_all((alpha, beta), given, conj(*known)), number(less))

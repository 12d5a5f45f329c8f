"""The claims of Sec. IV-D on larger and smaller regions, read as areas.

A region has less area than another one if the first lies in a polygon, and a polygon of larger area
lies in the second. All claims are for integer delays and for arms in numbers.
"""

from __future__ import annotations

import tomllib
from importlib.resources import files
from typing import TypeAlias

from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.ratio import ARM, stable
from symhaptic.paper.propositions.stability import HEAVIER
from symhaptic.paper.ranges import DAMPED

Wall: TypeAlias = tuple[Rational, Rational]
Side: TypeAlias = tuple[Rational, Rational, Rational]
"""p, q and c of the side p alpha + q beta <= c."""

POLYGONS = tomllib.loads(files(__package__).joinpath("polygons.toml").read_text(encoding="utf-8"))
"""The corners and sides of the polygons, as decimals."""

Corners: TypeAlias = Sequence[Wall]


def inner(delay: int) -> tuple[Wall, ...]:
    """Return the corners of a polygon of stable walls, counterclockwise."""
    return tuple((Rational(x), Rational(y)) for x, y in POLYGONS["inner"][str(delay)])


def outer(delay: int) -> tuple[Side, ...]:
    """Return the sides of a polygon that contains all stable walls, the left one first."""
    rest = ((Rational(p), Rational(q), Rational(c)) for p, q, c in POLYGONS["outer"][str(delay)])
    return ((-S.One, S.Zero, STIFF), *rest)


def sides(corners: Corners) -> list[Side]:
    """Return the sides of a convex polygon from its corners, counterclockwise."""
    found = []
    for (x_1, y_1), (x_2, y_2) in zip(corners, (*corners[1:], corners[0]), strict=True):
        p, q = y_2 - y_1, x_1 - x_2
        found.append((p, q, p * x_1 + q * y_1))
    for p, q, c in found:
        if any(p * x + q * y > c for x, y in corners):
            raise ValueError(f"{corners}: these are no corners of a convex polygon in their order")
    return found


def corners(given: Sequence[Side]) -> tuple[Wall, ...]:
    """Return the corners, at which neighbouring sides meet."""
    found = []
    for (p, q, c), (r, s, u) in zip(given, (*given[1:], given[0]), strict=True):
        size = p * s - q * r
        found.append(((c * s - q * u) / size, (p * u - c * r) / size))
    return tuple(found)


def area(polygon: Corners) -> Rational:
    """Return the area of a polygon from its corners."""
    pairs = zip(polygon, (*polygon[1:], polygon[0]), strict=True)
    return sum((x * w - v * u for (x, u), (v, w) in pairs), S.Zero) / 2


def within(given: Sequence[Side]) -> list[Proposition]:
    """The wall (alpha, beta) lies on the inner side of each of the sides."""
    return [proposition(Relation(p * alpha + q * beta, "<=", c)) for p, q, c in given]


def holds_polygon(delay: int, polygon: Corners) -> Proposition:
    """All walls of a polygon are stable."""
    return ForAll((alpha, beta), implied(within(sides(polygon)), stable(delay)))


def in_polygon(delay: int, given: Sequence[Side]) -> Proposition:
    """All stable walls lie in a polygon."""
    return ForAll((alpha, beta), implied([stable(delay)], both(within(given))))


LONGEST = 8


def smaller(delay: int) -> Proposition:
    """The region of the next delay has less area."""
    small, large = area(corners(outer(delay + 1))), area(inner(delay))
    inside = holds_polygon(delay, inner(delay))
    around = in_polygon(delay + 1, outer(delay + 1))
    return both([inside, around, Relation(small, "<", large)])


@claims("s4d-delay-shrinks-area")
def _delay_takes_area(printed: Printed) -> Proposition:
    """Each period of delay reduces the area of the region, from d = 0 to 8, for the arm of Fig. 11.

    The region of the longer delay lies in a polygon, and a polygon of larger area lies in the
    region of the shorter delay.
    """
    return both(map(smaller, range(LONGEST))).at(ARM)


# -- what arm and mass do --------------------------------------------------------------------------


ENDS = (S.Zero, DAMPED)
"""The ends of the range of delta."""


def moved_by_the_spring() -> Proposition:
    """A wall that is stable without a spring is stable with it if alpha is 0.001 less.

    This is without delay. So the region with gamma = 0.001 contains the region without a spring,
    moved to the left. The claim is for both ends of the range of delta.
    """
    free, sprung = stable(0).at({gamma: S.Zero}), stable(0, (alpha - STIFF, beta))
    kept = ForAll((alpha, beta), implied([free], sprung.at({gamma: STIFF})))
    return both(kept.at({delta: damper}) for damper in ENDS)


def kept_by_the_damper() -> Proposition:
    """Without delay a wall that is stable with an arm of (23) is stable with a larger damper."""
    more = stable(0).at({delta: HEAVIER})
    given = [*transcribed("eq23"), delta < HEAVIER, HEAVIER <= DAMPED, stable(0)]
    return ForAll((alpha, beta, gamma, delta, HEAVIER), implied(given, more))


AROUND = (
    (-S.One, S.Zero, STIFF),
    (S.Zero, -S.One, Rational(3, 100)),
    (S.One, S.Zero, Rational(722, 1000)),
    (S.Zero, S.One, Rational(203, 100)),
)
"""A rectangle that contains all stable walls of (23) without delay."""
HEAVY = {gamma: STIFF / 2, delta: DAMPED / 2}
"""The arm of Figs. 11 and 12 with twice the mass."""
INSIDE = (
    (-STIFF / 4, Rational(0)),
    (S.Half, Rational(45, 100)),
    (Rational(65, 100), Rational(8, 10)),
    (-STIFF / 4, Rational(19, 10)),
)
"""The corners of a polygon of walls that are stable with twice the mass."""


def grown_with_the_mass() -> Proposition:
    """Without delay, twice the mass enlarges the area of the walls (K, B), for the arm of Fig. 11.

    For the same wall, alpha and beta are half as large with twice the mass. So an area of the
    (alpha, beta) plane is four times as large in the (K, B) plane.
    """
    inside, around = holds_polygon(0, INSIDE).at(HEAVY), in_polygon(0, AROUND).at(ARM)
    return both([inside, around, Relation(area(corners(AROUND)), "<", 4 * area(INSIDE))])


@claims("s4d-all-stabilising-area")
def _each_part_adds_area(printed: Printed) -> Proposition:
    """Without delay, spring, damper and mass each enlarge the area of the region or keep it.

    Spring: between the ends of the range of gamma. Damper: the region contains the region for less
    damping. Mass: if the mass is doubled.
    """
    return both([moved_by_the_spring(), kept_by_the_damper(), grown_with_the_mass()])

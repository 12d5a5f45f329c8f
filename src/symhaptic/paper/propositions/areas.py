"""The claims of Sec. IV-D on larger and smaller regions, read as areas.

A region has less area than another where it lies in a polygon and a polygon of larger area lies in
the other.  All is said of whole delays and numbers for the arm.
"""

from __future__ import annotations

from typing import TypeAlias

from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.ratio import ARM, stable
from symhaptic.paper.propositions.stability import HEAVIER
from symhaptic.paper.ranges import DAMPED

Wall: TypeAlias = tuple[Rational, Rational]
Side: TypeAlias = tuple[Rational, Rational, Rational]
"""p, q and c of the side p alpha + q beta <= c."""

INNER_ = {
    0: (
        ("-0.0009", "-0.0179"),
        ("0.606", "0.479"),
        ("0.703", "0.823"),
        ("0.566", "1.3"),
        ("-0.0009", "1.99"),
    ),
    1: (
        ("-0.0009", "-0.0188"),
        ("0.133", "0.271"),
        ("0.152", "0.422"),
        ("0.12", "0.616"),
        ("-0.0009", "0.827"),
    ),
    2: (
        ("-0.0009", "-0.0197"),
        ("0.0594", "0.188"),
        ("0.0677", "0.289"),
        ("0.0528", "0.415"),
        ("-0.0009", "0.538"),
    ),
    3: (
        ("-0.0009", "-0.0206"),
        ("0.034", "0.143"),
        ("0.0388", "0.221"),
        ("0.0301", "0.315"),
        ("-0.0009", "0.403"),
    ),
    4: (
        ("-0.0009", "-0.0215"),
        ("0.0222", "0.114"),
        ("0.0253", "0.178"),
        ("0.0196", "0.255"),
        ("-0.0009", "0.323"),
    ),
    5: (
        ("-0.0009", "-0.0224"),
        ("0.0157", "0.0948"),
        ("0.018", "0.149"),
        ("0.0138", "0.214"),
        ("-0.0009", "0.27"),
    ),
    6: (
        ("-0.0009", "-0.0233"),
        ("0.0118", "0.0804"),
        ("0.0135", "0.128"),
        ("0.0103", "0.185"),
        ("-0.0009", "0.233"),
    ),
    7: (
        ("-0.0009", "-0.0242"),
        ("0.00918", "0.0693"),
        ("0.0106", "0.112"),
        ("0.00801", "0.163"),
        ("-0.0009", "0.205"),
    ),
    8: (
        ("-0.0009", "-0.0251"),
        ("0.00738", "0.0604"),
        ("0.00851", "0.0996"),
        ("0.00641", "0.145"),
        ("-0.0009", "0.183"),
    ),
}
"""Corners of polygons of stable walls, for the arm of Figs. 11 and 12, by the delay."""

OUTER_ = {
    1: (
        ("0.498", "-1.0", "0.02102"),
        ("1.0", "-0.0171", "0.1472306"),
        ("1.0", "0", "0.1543617"),
        ("1.0", "0.341", "0.3326467"),
        ("1.0", "0.732", "0.6167551"),
    ),
    2: (
        ("0.998", "-1.0", "0.02152"),
        ("1.0", "-0.0376", "0.0581705"),
        ("1.0", "0", "0.0686323"),
        ("1.0", "0.248", "0.1571415"),
        ("1.0", "0.578", "0.3167449"),
    ),
    3: (
        ("1.498", "-1.0", "0.02202"),
        ("1.0", "-0.0377", "0.0313942"),
        ("1.0", "0", "0.0392841"),
        ("1.0", "0.197", "0.0929272"),
        ("1.0", "0.481", "0.1966732"),
    ),
    4: (
        ("1.998", "-1.0", "0.02252"),
        ("1.0", "-0.0361", "0.0196445"),
        ("1.0", "0", "0.0256789"),
        ("1.0", "0.164", "0.0618223"),
        ("1.0", "0.415", "0.135733"),
    ),
    5: (
        ("2.498", "-1.0", "0.02302"),
        ("1.0", "-0.0344", "0.0134573"),
        ("1.0", "0", "0.0182255"),
        ("1.0", "0.141", "0.0443346"),
        ("1.0", "0.368", "0.1004508"),
    ),
    6: (
        ("2.998", "-1.0", "0.02352"),
        ("1.0", "-0.0331", "0.009781"),
        ("1.0", "0", "0.0136814"),
        ("1.0", "0.125", "0.0336625"),
        ("1.0", "0.333", "0.0780675"),
    ),
    7: (
        ("3.498", "-1.0", "0.02402"),
        ("1.0", "-0.0321", "0.0074225"),
        ("1.0", "0", "0.0106962"),
        ("1.0", "0.112", "0.0264284"),
        ("1.0", "0.306", "0.0628998"),
    ),
    8: (
        ("3.998", "-1.0", "0.02452"),
        ("1.0", "-0.0312", "0.0058318"),
        ("1.0", "0", "0.0086241"),
        ("1.0", "0.103", "0.0215486"),
        ("1.0", "0.285", "0.0521746"),
    ),
}
"""Sides of polygons that hold all stable walls right of alpha = -gamma, counterclockwise."""

Corners: TypeAlias = Sequence[Wall]


def inner(delay: int) -> tuple[Wall, ...]:
    """The corners of a polygon of stable walls, counterclockwise."""
    return tuple((Rational(x), Rational(y)) for x, y in INNER_[delay])


def outer(delay: int) -> tuple[Side, ...]:
    """The sides of a polygon that holds all stable walls, the left one first."""
    rest = ((Rational(p), Rational(q), Rational(c)) for p, q, c in OUTER_[delay])
    return ((-S.One, S.Zero, STIFF), *rest)


def sides(corners: Corners) -> list[Side]:
    """The sides of a convex polygon whose corners are given counterclockwise."""
    found = []
    for (x_1, y_1), (x_2, y_2) in zip(corners, (*corners[1:], corners[0]), strict=True):
        p, q = y_2 - y_1, x_1 - x_2
        found.append((p, q, p * x_1 + q * y_1))
    for p, q, c in found:
        if any(p * x + q * y > c for x, y in corners):
            raise ValueError(f"{corners}: these are no corners of a convex polygon in their order")
    return found


def corners(given: Sequence[Side]) -> tuple[Wall, ...]:
    """Where neighbouring sides meet."""
    found = []
    for (p, q, c), (r, s, u) in zip(given, (*given[1:], given[0]), strict=True):
        size = p * s - q * r
        found.append(((c * s - q * u) / size, (p * u - c * r) / size))
    return tuple(found)


def area(polygon: Corners) -> Rational:
    """The area of a polygon, by its corners."""
    pairs = zip(polygon, (*polygon[1:], polygon[0]), strict=True)
    return sum((x * w - v * u for (x, u), (v, w) in pairs), S.Zero) / 2


def within(given: Sequence[Side]) -> list[Proposition]:
    """That (alpha, beta) lies on the inner side of each."""
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
    """Each period of delay takes area from the region, from d = 0 to 8, for the arm of Fig. 11.

    The region of the longer delay lies in a polygon, and a polygon of larger area in that of the
    shorter delay.
    """
    return both(map(smaller, range(LONGEST))).at(ARM)


# -- what arm and mass do --------------------------------------------------------------------------


ENDS = (S.Zero, DAMPED)
"""The ends of the range of delta."""


def moved_by_the_spring() -> Proposition:
    """Without delay a wall that is stable without a spring, less 0.001 of stiffness, is so with it.

    The walls with gamma = 0.001 so fill at least a copy of the region without a spring, moved to
    the left.  For both ends of the range of delta.
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
"""A rectangle that holds all stable walls of (23) without delay."""
HEAVY = {gamma: STIFF / 2, delta: DAMPED / 2}
"""The arm of Figs. 11 and 12 with twice the mass."""
INSIDE = (
    (-STIFF / 4, Rational(0)),
    (S.Half, Rational(45, 100)),
    (Rational(65, 100), Rational(8, 10)),
    (-STIFF / 4, Rational(19, 10)),
)
"""Corners of a polygon of walls that are stable with that arm."""


def grown_with_the_mass() -> Proposition:
    """With twice the mass the walls (K, B) fill more area, for the arm of Figs. 11 and 12.

    Without delay.  Of the same wall alpha and beta are half as large with twice the mass, so that
    the area counts four times.
    """
    inside, around = holds_polygon(0, INSIDE).at(HEAVY), in_polygon(0, AROUND).at(ARM)
    return both([inside, around, Relation(area(corners(AROUND)), "<", 4 * area(INSIDE))])


@claims("s4d-all-stabilising-area")
def _each_part_adds_area(printed: Printed) -> Proposition:
    """Spring, damper and mass each add area to the region without delay.

    The spring: between the ends of the range of gamma.  The damper: the region holds all walls of
    the one with less damping.  The mass: where it is doubled.
    """
    return both([moved_by_the_spring(), kept_by_the_damper(), grown_with_the_mass()])

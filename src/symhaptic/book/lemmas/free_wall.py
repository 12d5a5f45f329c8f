"""A wall beside a device without a spring: where one of them is stronger on the circle."""

from symhaptic.book.lemmas.prelude import *

y = symbols("y")
WALL = alpha, beta, n_1, n_0, e
GIVEN = tuple(map(proposition, (n_1 > 0, n_0 > 0, e > 0)))


def surplus(at: Expr = y) -> Expr:
    """|A|^2 - |N|^2 |W|^2 at y = 4 sin^2(theta/2), for a - e = 1."""
    device = (1 - e) ** 2 * at + e * at**2
    moved = (n_1 + n_0) ** 2 - n_1 * n_0 * at
    return device - moved * (alpha**2 + (alpha + beta) * beta * at)


STRONG = proposition(surplus(4) <= 0)
"""The wall is as strong as the device at z = -1."""


def stronger() -> Proposition:
    """A wall that is as strong as the device at z = -1 is stronger before, but at z = 1."""
    inside = (y > 0, y < 4)
    return ForAll(WALL, implied(GIVEN, ForAll((y,), implied([STRONG, *inside], surplus() < 0))))


@cache
def stronger_everywhere() -> Theorem:
    """The surplus lies below its chord, and what it lies above that is outweighed at z = 1."""
    left = positive(4 - y > 0, y < 4)
    there = square((n_1 + n_0) * alpha)
    apart, far = square((n_1 - n_0) * alpha), square(alpha + 2 * beta)
    sixteenth = Rational(1, 16)
    found = positive(
        surplus() < 0,
        [Rational(1, 4), y > 0, STRONG],
        [sixteenth, left, left, there],
        [sixteenth, y > 0, left, apart],
        [4 * sixteenth, y > 0, left, n_1 > 0, n_0 > 0, far],
        [y > 0, left, e > 0],
    )
    inner = for_all([y], [STRONG, y > 0, y < 4], found)
    return for_all(WALL, GIVEN, inner)

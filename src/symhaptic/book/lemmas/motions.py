"""Motions, (time in periods, way) piece by piece, that gain energy."""

from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *

Motion: TypeAlias = Sequence[tuple[Any, Any]]

STEPS = 4 * [(1, 1)]
"""Four equal steps, against which a spring that pulls gives way."""

TO_AND_FRO = 4 * [(1, 1), (1, -1)]
"""A step forwards and one back, four times: Nyquist's frequency."""


def half_late(first: Rational, periods: int = 30) -> Motion:
    """Half a period with a longer way than the other, then all of it back."""
    pieces = periods * [(S.Half, first), (S.Half, S.One)]
    return pieces + [(time, -way) for time, way in pieces]


HALF_LATE = half_late(Rational(3, 2))


def not_passive(then: Proposition, point: Terms, motion: Motion = HALF_LATE) -> Theorem:
    """That what a claim concludes is false of a wall, since a motion gains from it."""
    there, passive = then.at(point), PASSIVE.at(point)
    found = gains(list(passive.of), motion)  # type: ignore[attr-defined]
    return not_intro(conjunct(assume(there), passive), found, there)


def not_on_boundary(then: Proposition, point: Terms, motion: Motion) -> Theorem:
    """That the walls of a curve are on the boundary is false of a wall: a motion gains from it."""
    there, passive = then.at(point), PASSIVE.at(point)
    curve = conjunct(assume(there), there.parts[0])
    given = conj(*map(number, conjuncts(there.parts[0].parts[0])))
    found = gains(list(passive.of), motion)  # type: ignore[attr-defined]
    return not_intro(conjunct(mp(curve, given), passive), found, there)

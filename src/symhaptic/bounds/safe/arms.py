"""m = m_D + h, b = b_D + r or b_D + r h, k = k_D + s or k_D + s h: a device in a range of hands.

Numbers are in SI units and exact; a piece of the range is a box of h, r and s.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, TypeAlias

from flint import arb

from symhaptic.bounds.balls import exact

Ends: TypeAlias = tuple[Fraction, Fraction]
"""The lowest and the highest."""

Hands: TypeAlias = tuple[Ends, Ends, Ends]
"""Mass of the arm in kg, its damping and its stiffness, or these by its mass."""


class Loops(NamedTuple):
    """All loops of a device, sampled, behind a delay, held by any arm of a range."""

    mass: Fraction
    """m_D in kg, > 0."""
    damping: Fraction
    """b_D in Ns/m, >= 0."""
    stiffness: Fraction
    """k_D in N/m, >= 0."""
    period: Fraction
    """T in s, > 0."""
    periods: Ends
    """The delay in sampling periods: one, or a range between two whole numbers."""
    hands: Hands
    by_mass: tuple[bool, bool]
    """Whether damping and stiffness of the arm are those by its mass, in 1/s and 1/s^2."""

    @property
    def steps(self) -> int:
        """l: so many whole periods of delay."""
        return int(self.periods[0])

    @property
    def part(self) -> Ends:
        """What is left of the delay, in periods, between 0 and 1."""
        return self.periods[0] - self.steps, self.periods[1] - self.steps


def midway(loops: Loops) -> Loops:
    """The same at the middle of their delays."""
    middle = (loops.periods[0] + loops.periods[1]) / 2
    return loops._replace(periods=(middle, middle))


class Moved(NamedTuple):
    """The least and the most mass, damping and stiffness of what moves, in balls."""

    mass: tuple[arb, arb]
    damping: tuple[arb, arb]
    stiffness: tuple[arb, arb]


def span(ends: Ends) -> arb:
    """A ball around all numbers between two."""
    low, high = ends
    return exact(low) if low == high else exact(low).union(exact(high))


def moved(loops: Loops, hands: Hands) -> Moved:
    """What moves, for all arms of a box."""
    masses, dampings, stiffnesses = hands
    ends = []
    for i in (0, 1):
        by_b, by_k = (masses[i] if by else Fraction(1) for by in loops.by_mass)
        ends.append(
            (
                exact(loops.mass + masses[i]),
                exact(loops.damping + dampings[i] * by_b),
                exact(loops.stiffness + stiffnesses[i] * by_k),
            )
        )
    return Moved(*zip(*ends, strict=True))


def ratios(loops: Loops, hands: Hands) -> tuple[arb, arb]:
    """gamma and delta; they rise and fall with the mass of the arm, and its ends tell all.

    k/m = (k_D + s h)/(m_D + h) and b/m are monotonous in h.
    """
    found = []
    period = exact(loops.period)
    for own, at, by, unit in (
        (loops.stiffness, 2, loops.by_mass[1], period * period),
        (loops.damping, 1, loops.by_mass[0], period),
    ):
        values = [
            (exact(own) + span(hands[at]) * (exact(h) if by else 1)) / exact(loops.mass + h)
            for h in hands[0]
        ]
        found.append(values[0].union(values[1]) * unit)
    return found[0], found[1]


def halved(angles: Ends, hands: Hands, across: int) -> list[tuple[Ends, Hands]]:
    """Both halves of a piece of the circle and of the arms, the lower one first."""
    box = (angles, *hands)
    low, high = box[across]
    middle = (low + high) / 2
    found = []
    for half in ((low, middle), (middle, high)):
        arc, h, r, s = (half if i == across else ends for i, ends in enumerate(box))
        found.append((arc, (h, r, s)))
    return found

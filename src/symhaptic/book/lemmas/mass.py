"""The mass of a device does not matter to its passivity."""

from symhaptic.book.lemmas.passivity import WALL
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.energy import stored


def of_mass(mass: Expr) -> Theorem:
    """passive with the store m v^2/2 <=> passive, for m > 0."""
    some = positive(mass * v**2 / 2 >= 0, [S.Half, mass > 0, square(v)])
    return stored(WALL, v, some, identity(S.Zero, S.Zero))


def no_mass_differs(one: Expr, other: Expr) -> Theorem:
    """passive with one mass <=> passive with the other."""
    light, heavy = of_mass(one), of_mass(other)
    first, second = (t.conclusion.of[0] for t in (light, heavy))  # type: ignore[attr-defined]
    there = mp(heavy, mp(light, assume(first)))
    return either_way(there, mp(light, mp(heavy, assume(second))), first, second)

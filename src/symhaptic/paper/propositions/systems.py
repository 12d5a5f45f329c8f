"""The claim of Sec. III about systems that are connected."""

from __future__ import annotations

from sympy import Eq, Ne, symbols

from symhaptic.paper.propositions.comparison import COMES_TO_REST, LOOP, PASSIVE_WALL
from symhaptic.paper.propositions.prelude import *

R_1, X_1, R_2, X_2 = FREQUENCY = symbols("R_1 X_1 R_2 X_2")
"""Real and imaginary part of what two systems answer to a sine, Z = R + j X; passive is 0 <= R."""

KIND = symbols("n")
PARALLEL, FED_BACK, CHAIN = range(1, 4)
"""Of the same motion; fed back to each other; one after the other."""

PRODUCT = R_1 * R_2 - X_1 * X_2, R_1 * X_2 + R_2 * X_1
"""Z_1 Z_2."""
SIZE = (1 + PRODUCT[0]) ** 2 + PRODUCT[1] ** 2
"""|1 + Z_1 Z_2|^2."""
REAL = {PARALLEL: R_1 + R_2, FED_BACK: (R_1 + (R_1**2 + X_1**2) * R_2) / SIZE, CHAIN: PRODUCT[0]}
"""The real part of Z_1 + Z_2, of Z_1/(1 + Z_1 Z_2) and of Z_1 Z_2."""


def connected(kind: int) -> Proposition:
    """What is connected in this way is passive."""
    given = [Eq(KIND, kind), Ne(SIZE, 0)] if kind == FED_BACK else [Eq(KIND, kind)]
    return implied(given, proposition(REAL[kind] >= 0))


@claims("s3-interconnection")
def _what_is_connected_is_passive_and_stable(printed: Printed) -> Proposition:
    """In parallel, n = 1, fed back, n = 2, and in a chain, n = 3, passive systems are passive.

    Said of linear systems, at each frequency of a sine. Stable is said of what the paper connects,
    an arm and a device with the wall: a loop comes to rest, with every delay, if no motion gains
    energy from its wall and its damper.
    """
    given = [R_1 >= 0, R_2 >= 0, gamma >= 0, delta >= 0, d >= 0, PASSIVE_WALL]
    every = both([*map(connected, REAL), COMES_TO_REST])
    return ForAll((*FREQUENCY, KIND, *LOOP), implied(given, every))

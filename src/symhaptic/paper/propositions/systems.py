"""The claim of Sec. III about connected systems."""

from __future__ import annotations

from sympy import Eq, Ne, symbols

from symhaptic.paper.propositions.comparison import COMES_TO_REST, LOOP, PASSIVE_WALL
from symhaptic.paper.propositions.prelude import *

R_1, X_1, R_2, X_2 = FREQUENCY = symbols("R_1 X_1 R_2 X_2")
"""Real and imaginary part of two frequency responses Z = R + j X; passive means 0 <= R."""

KIND = symbols("n")
PARALLEL, FED_BACK, CHAIN = range(1, 4)
"""Parallel connection, feedback, and a chain."""

PRODUCT = R_1 * R_2 - X_1 * X_2, R_1 * X_2 + R_2 * X_1
"""Z_1 Z_2."""
SIZE = (1 + PRODUCT[0]) ** 2 + PRODUCT[1] ** 2
"""The square of the absolute value of 1 + Z_1 Z_2."""
REAL = {PARALLEL: R_1 + R_2, FED_BACK: (R_1 + (R_1**2 + X_1**2) * R_2) / SIZE, CHAIN: PRODUCT[0]}
"""The real parts of Z_1 + Z_2, Z_1/(1 + Z_1 Z_2) and Z_1 Z_2."""


def connected(kind: int) -> Proposition:
    """The connection of two passive systems is passive."""
    given = [Eq(KIND, kind), Ne(SIZE, 0)] if kind == FED_BACK else [Eq(KIND, kind)]
    return implied(given, proposition(REAL[kind] >= 0))


@claims("s3-interconnection")
def _what_is_connected_is_passive_and_stable(printed: Printed) -> Proposition:
    """Passive systems are passive in parallel, n = 1, in feedback, n = 2, and in a chain, n = 3.

    The claim is for linear systems, at each frequency. Stability is claimed for the paper's
    connection of arm, device and wall: with every delay, the loop is stable if no motion gains
    energy from its wall and its damper.
    """
    given = [R_1 >= 0, R_2 >= 0, gamma >= 0, delta >= 0, d >= 0, PASSIVE_WALL]
    every = both([*map(connected, REAL), COMES_TO_REST])
    return ForAll((*FREQUENCY, KIND, *LOOP), implied(given, every))

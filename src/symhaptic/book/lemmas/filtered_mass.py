"""A free mass at a wall whose damper takes a filtered velocity: which stiffness is stable."""

from __future__ import annotations

from symhaptic.book.lemmas.decided import SI
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import f, tau_f
from symhaptic.rules.claims import UNITS
from symhaptic.rules.other_loops import AVERAGING, LOW_PASS, POLE

LEFT = f * (1 + f) * alpha**2 + (1 - f) * (2 * (1 - f) + (1 + 3 * f) * beta) * alpha
QUADRATIC = proposition(2 * (1 - f) ** 2 * beta * (2 - beta) - LEFT > 0)
HERE = Given(*POLE)
HERE.have(1 - f > 0)


@cache
def in_units() -> Theorem:
    """stable <=> alpha > 0, beta > 0 and the quadratic inequality, for a pole 0 <= f < 1."""
    criterion = HERE.closed(jury(AVERAGING.of[0], z))
    wanted = criterion.conclusion.of[1]
    print(wanted)

"""The force that moves the sampled device, as routines: in twice the precision of a float.

Its numerators and M are sums that may cancel; rounded once, what the boundary of stability is made
of is off by the last places of the device's own numbers and by little else.
"""

from __future__ import annotations

import sympy as sp
from sympy import tan

from symhaptic.export.routine import Routine, Steps
from symhaptic.export.twice import Twice
from symhaptic.notation import psi

_DEVICE = sp.symbols("at_one at_minus_one loss together apart across")


def _force(do: Steps) -> tuple[Twice, ...]:
    """A/z and M, real and imaginary part, over cos(psi)^2, and the squared size of M."""
    at_one, at_minus_one, loss, together, apart, across = (Twice(do, x) for x in _DEVICE)
    t = Twice(do, do("t", tan(psi)))
    square = t * t
    above, below = at_one - at_minus_one * square, together - apart * square
    above_j, below_j = Twice(do, do("twice", 2 * t.high)) * loss, t * across
    size = below * below + below_j * below_j
    do.share("Force", "A/z and M at z = exp(2 j psi) to twice the precision of a float")
    return above, above_j, below, below_j, size


def in_phase() -> Routine:
    """The real part."""
    do = Steps()
    above, above_j, below, below_j, size = _force(do)
    found = ((above * below + above_j * below_j) / size).rounded("found")
    return do.routine("InPhase", "the real part of A/(z M) at z = exp(2 j psi)",
                      (psi, *_DEVICE), found)  # fmt: skip


def ahead() -> Routine:
    """The imaginary part."""
    do = Steps()
    above, above_j, below, below_j, size = _force(do)
    found = ((above_j * below - above * below_j) / size).rounded("found")
    return do.routine("Ahead", "the imaginary part of A/(z M) at z = exp(2 j psi)",
                      (psi, *_DEVICE), found)  # fmt: skip


ROUTINES = (in_phase, ahead)
PRECISE = ()

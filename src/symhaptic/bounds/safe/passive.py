r"""b^2 - b n - e (1 - e) T^2 |H|^2/4 > 0 at every angle, and K >= 0: the walls that are passive.

Here n = (1 - e) n_l + e n_{l+1} for a delay of l + e periods, with
n_d = K T sin((d + 1/2) theta)/(2 sin(theta/2)) - B cos((d + 1) theta).  An arm that is passive
itself, and every arm here is, takes no part in it, by (3) of the paper.  A sum of a linear and a
concave function of K and B: between walls that are passive all are.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from flint import arb, ctx

from symhaptic.bounds.balls import exact, sinc
from symhaptic.bounds.safe.arms import Loops
from symhaptic.numeric.passivity import passivity_boundary

_BITS = 64
_PIECES = 4000

Wall = tuple[float, float]


def is_passive(loops: Loops, wall: Wall) -> bool:
    """Whether it is shown that no motion of the device alone extracts energy from a wall."""
    K, B = wall
    if not (K >= 0 and loops.damping > 0):
        return False
    with ctx.workprec(_BITS):
        pieces, looked = [(arb(0), arb.pi().upper())], 0
        while pieces:
            low, high = pieces.pop()
            looked += 1
            if _spare(loops, arb(K), arb(B), low, high) > 0:
                continue
            if looked > _PIECES:
                return False
            middle = ((low + high) / 2).mid()
            if not _spare(loops, arb(K), arb(B), middle, middle) > 0:
                return False
            pieces += [(low, middle), (middle, high)]
    return True


def _spare(loops: Loops, K: arb, B: arb, low: arb, high: arb) -> arb:
    """What is left of b^2 on a piece of the circle."""
    theta, T, b = low.union(high), exact(loops.period), exact(loops.damping)
    part = exact(loops.part[0])
    spread = (low / 2).sinc().union((high / 2).sinc())
    needs = []
    for d in (loops.steps, loops.steps + 1):
        turns = arb(2 * d + 1) / 2
        wave = turns * sinc(low * turns, high * turns) / spread
        needs.append(K * T * wave - B * ((d + 1) * theta).cos())
    need = needs[0] + part * (needs[1] - needs[0])
    chord = (low / 2).sin().union((high / 2).sin())
    size = (K * T) ** 2 + 4 * B * (K * T + B) * chord**2
    return b * b - b * need - part * (1 - part) * size / 4


def passive(loops: Loops, share: Fraction = Fraction(995, 1000)) -> tuple[Wall, ...]:
    """Corners of a convex set of passive walls that is all of them but for little, in N/m, Ns/m."""
    b, T = float(loops.damping), float(loops.period)
    if b == 0:
        return ()
    delay = float(loops.periods[0])
    omega = np.linspace(1e-4, np.pi * (1 - 1e-6), 4000)
    alpha, beta = passivity_boundary(omega, 1.0, delay)
    known = np.nonzero(np.isfinite(alpha) & (alpha >= 0))[0]
    kept = known[np.unique(np.linspace(0, len(known) - 1, 40).astype(int))] if len(known) else []
    near = float(share)
    corners = [
        (0.0, -near * b),
        *((near * float(alpha[i]) * b / T, near * float(beta[i]) * b) for i in kept),
        (0.0, near * b),
    ]
    return tuple(wall for wall in corners if math.isfinite(wall[0]) and is_passive(loops, wall))

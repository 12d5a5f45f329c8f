"""Devices in ranges of hands, and the loops that they make, from matrix exponentials."""

from fractions import Fraction

import numpy as np
from scipy.linalg import expm

from symhaptic.bounds.safe.arms import Loops

OF_THE_PAPER = ((0, 23), (0, 20), (0, 1000))
"""(23) of the paper: k <= 1000 m/s^2 and b <= 20 m/s, for arms up to the heaviest of Table II."""


def loops(mass, damping, periods, hands=OF_THE_PAPER, by_mass=(True, True), T="0.001"):
    exact = tuple(tuple(map(Fraction, ends)) for ends in hands)
    delay = Fraction(periods)
    return Loops(*map(Fraction, (mass, damping, "0", T)), (delay, delay), exact, by_mass)


def moved(case, rng, at=None):
    """Mass, damping and stiffness of what moves, for a random arm or a corner."""
    share = rng.uniform(size=3) ** 2 if at is None else np.array(at, float)
    box = zip(case.hands, share, strict=True)
    h, r, s = (float(low) + u * float(high - low) for (low, high), u in box)
    by_r, by_s = (h if by else 1.0 for by in case.by_mass)
    return float(case.mass) + h, float(case.damping) + r * by_r, s * by_s


def growth(K, B, m, b, k, T, delay):
    """Largest modulus of the loop's roots: the held force changes inside a period."""
    steps = int(delay)
    part = delay - steps
    state = np.array([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]])
    old, new = expm(state * part * T), expm(state * (1 - part) * T)
    size = 4 + steps  # x, v, the last x, and the forces under way, the newest first
    loop = np.zeros((size, size))
    force = np.zeros(size)
    force[0], force[2] = -(K + B / T), B / T
    loop[:2, :2] = new[:2, :2] @ old[:2, :2]
    loop[2, 0] = 1
    before, now = new[:2, :2] @ old[:2, 2], new[:2, 2]
    loop[3] = force
    for i in range(1, steps + 1):
        loop[3 + i, 2 + i] = 1
    loop[:2, 3 + steps] += before
    if steps:
        loop[:2, 2 + steps] += now
    else:
        loop[:2] += np.outer(now, force)
    return np.abs(np.linalg.eigvals(loop)).max()

"""Borders and largest values found by trying: halving and a search, with eigenvalues as judge."""

from functools import cache

import mpmath
import numpy as np
import oracle
from scipy.optimize import minimize_scalar


def edge(inside, outside, holds, steps=48):
    """Where ``holds`` changes between two numbers, by halving: the last digits of a float."""
    for _ in range(steps):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if holds(middle) else (inside, middle)
    return inside


def first_edge(inside, outside, hold, rounds=12):
    """Where ``hold``, of many numbers at once, is first false: by sixteenths, as many digits."""
    for _ in range(rounds):
        tried = np.linspace(inside, outside, 17)
        lost = int(np.argmin(np.append(hold(tried[1:-1]), False)))
        inside, outside = tried[lost : lost + 2]
    return float(inside)


@cache
def stiffest(gamma, delta, delay, low, high, top=4.0):
    """(alpha, beta) of the largest stable alpha, for low < beta < high.

    For each beta the walls are stable from just above -gamma on; the best beta is found to about
    1e-7, and alpha to its square.
    """

    def most(beta):
        def hold(alphas):
            return oracle.moduli(alphas, beta, gamma, delta, delay).max(axis=-1) < 1

        return first_edge(1e-7 - gamma, top, hold)

    found = minimize_scalar(
        lambda beta: -most(beta), bounds=(low, high), method="bounded", options={"xatol": 1e-7}
    )
    return -found.fun, found.x


def first_arc(gamma, delta, d):
    """Largest alpha of the explicit boundary for (d+1) theta < 2.1, by a fine search."""
    n1, n0, a, e = oracle.numbers(gamma, delta)

    def alpha(theta):
        z = mpmath.expj(theta)
        q = -mpmath.expj(d * theta) * (z * z - a * z + e) / (n1 * z + n0)
        return q.real - q.imag / mpmath.sin(theta) * (1 - mpmath.cos(theta))

    step = mpmath.mpf("1e-20")
    start = max(np.linspace(0.8, 2.1, 27), key=lambda phi: alpha(mpmath.mpf(phi) / (d + 1)))
    best = mpmath.findroot(
        lambda theta: (alpha(theta + step) - alpha(theta - step)) / step,
        mpmath.mpf(start) / (d + 1),
    )
    return alpha(best)

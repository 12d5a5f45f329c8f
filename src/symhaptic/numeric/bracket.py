"""A root between two ends, by Chandrupatla's method: interpolation where it is safe, else halves.

T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a
nonlinear function without using derivatives, Adv. Eng. Softw. 28 (1997) 145-149.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from symhaptic.numeric.arguments import Array

_STEPS = 120
"""At most so many; some ten are usual, and halving alone would need sixty."""

_CLOSE = 2.0**-51
"""Relative distance of two ends that are as good as one."""


def rising_root(
    f: Callable[[Array], Array], low: Array, high: Array, close: float = _CLOSE
) -> Array:
    """Where ``f`` changes from negative to positive between two ends, element by element.

    An end stands for the root where ``f`` does not change: ``low`` where it is not negative there
    already, ``high`` where it is not positive even there.  The root is found to the relative
    distance ``close``.

    >>> round(float(rising_root(lambda x: x**2 - 2, np.array(1.0), np.array(2.0))), 12)
    1.414213562373
    """
    b, a = np.broadcast_arrays(low, high)
    fb, fa = f(b), f(a)
    settled = np.where(fb >= 0, b, a)
    done = (fb >= 0) | ~(fa > 0)
    c, fc = a, fa
    share = np.full(a.shape, 0.5)
    for _ in range(_STEPS):
        if np.all(done):
            break
        new = a + share * (b - a)
        value = f(new)
        same = np.sign(value) == np.sign(fa)
        b, fb, c, fc = (
            np.where(same, b, a),
            np.where(same, fb, fa),
            np.where(same, a, b),
            np.where(same, fa, fb),
        )
        a, fa = new, value
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        least = close * np.abs(best)
        reached = (np.abs(b - a) <= least) | (np.minimum(np.abs(fa), np.abs(fb)) == 0)
        settled = np.where(~done & reached, best, settled)
        done = done | reached
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            place, height = (a - b) / (c - b), (fa - fb) / (fc - fb)
            smooth = (height**2 < place) & ((1 - height) ** 2 < 1 - place)
            guess = fa / (fb - fa) * (fc / (fb - fc)) + (c - a) / (b - a) * (fa / (fc - fa)) * (
                fb / (fc - fb)
            )
            edge = np.minimum(least / np.abs(b - a), 0.5)
        share = np.where(smooth & ~done, np.clip(guess, edge, 1 - edge), 0.5)
    return settled

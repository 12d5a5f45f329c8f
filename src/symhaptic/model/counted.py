"""Functions of the loop that count: named here, and computed where numbers are."""

from __future__ import annotations

import mpmath
import sympy as sp
from mpmath import mpf
from sympy import Function

_NEAR = mpf(10) ** -9
"""Roots closer to the circle are on neither side."""


class UnstableRoots(Function):  # type: ignore[misc]
    """Roots outside the unit circle, of arguments that :data:`ARGUMENTS` names."""

    nargs = 10
    meaning = (
        "roots outside the unit circle of a loop with wall (alpha, beta) and whole delay d, "
        "counted from where device and wall are equally strong on the circle"
    )


class Stable(Function):  # type: ignore[misc]
    """1 where no root is outside or on the circle, else 0: (roots, alpha, beta, gamma, delta)."""

    nargs = 5
    meaning = "1 if there are none, alpha > -gamma, and the device is not left swinging, else 0"


ARGUMENTS = sp.symbols("alpha beta d n1 n0 at_one at_minus_one loss together apart")
"""Of UnstableRoots: the wall, the whole delay, and the device with its values at 1 and -1."""


def outside(*numbers: mpf) -> mpf:
    """The count by the roots of the polynomial, in many digits.

    Raises :class:`ArithmeticError` for long delays and for roots on the circle.
    """
    alpha, beta, delay, n1, n0, at_one, _, loss, *_ = numbers
    if delay > 12 or delay != int(delay):
        raise ArithmeticError("too many roots")
    coefficients = [mpf(0)] * (int(delay) + 4)
    coefficients[:3] = [mpf(1), loss + at_one - 2, 1 - loss]
    coefficients[-3] += n1 * (alpha + beta)
    coefficients[-2] += n0 * (alpha + beta) - n1 * beta
    coefficients[-1] -= n0 * beta
    while coefficients[-1] == 0:
        coefficients.pop()
    try:
        roots = mpmath.polyroots(coefficients, maxsteps=200, extraprec=200)
    except mpmath.libmp.NoConvergence:
        raise ArithmeticError("no roots found") from None
    sizes = [abs(root) for root in roots]
    if any(abs(size - 1) < _NEAR for size in sizes):
        raise ArithmeticError("a root on the circle")
    return mpf(sum(size > 1 for size in sizes))

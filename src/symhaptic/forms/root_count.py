"""Functions of the loop that count: named here, and computed where numbers are."""

from __future__ import annotations

import mpmath
import sympy as sp
from mpmath import mpf

from symhaptic.forms.entire import Meant

NEAR = sp.Symbol("NEAR")
"""How close to the circle a root is on neither side, where exact counts are asked for."""

_NEAR = mpf(10) ** -9
"""The same where nothing else is said."""


class WholeRoots(Meant, nargs=10):
    """number of roots outside the unit circle, with the wall (alpha, beta) and an integer delay d,
    counted at the angles at which the terms of device and wall have the same magnitude

    Of :data:`ARGUMENTS`.
    """


class FractionalRoots(Meant, nargs=12):
    """number of roots outside the unit circle, with a delay of l periods and a fraction; the device
    is (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e))

    Of :data:`FRACTIONAL_ARGUMENTS`.
    """


class Stable(Meant, nargs=5):
    """1 if roots is 0, alpha > -gamma, and no oscillation of the device persists, 0 if this is
    certainly false, otherwise -1

    Of (roots, alpha, beta, gamma, delta).
    """


ARGUMENTS = sp.symbols("alpha beta d n1 n0 gamma at_minus_one loss together apart")
"""Of WholeRoots: the wall, the whole delay, and the device with its values at 1 and -1.

At 1 they are gamma (n1 + n0) and n1 + n0.
"""


FRACTIONAL_ARGUMENTS = sp.symbols(
    "alpha beta d m2 m0 gamma at_minus_one loss together apart across delta"
)
"""Of FractionalRoots: the wall, the whole periods, and the device behind the fraction.

``apart`` is m2 - m1 + m0, and ``across`` m2 - m0.
"""


def outside(*numbers: mpf, near: mpf = _NEAR) -> mpf:
    """The count by the roots of the polynomial, in many digits.

    Raises :class:`ArithmeticError` for long delays and for roots on the circle.
    """
    alpha, beta, delay, n1, n0, gamma, _, loss, together, _ = numbers
    return _larger(_sizes((n1, n0), alpha, beta, delay + 1, gamma * together, loss), near)


def fractional_outside(*numbers: mpf, near: mpf = _NEAR) -> mpf:
    """The same behind a fractional delay."""
    return _larger(fractional_sizes(*numbers), near)


def fractional_sizes(*numbers: mpf) -> list[mpf]:
    """The sizes of the roots behind a fractional delay."""
    alpha, beta, delay, m2, m0, gamma, _, loss, together, *_ = numbers
    top = m2, together - m2 - m0, m0
    return _sizes(top, alpha, beta, delay + 2, gamma * together, loss)


def _larger(sizes: list[mpf], near: mpf) -> mpf:
    if any(abs(size - 1) < near for size in sizes):
        raise ArithmeticError("a root on the circle")
    return mpf(sum(size > 1 for size in sizes))


def _sizes(
    top: tuple[mpf, ...], alpha: mpf, beta: mpf, power: mpf, at_one: mpf, loss: mpf
) -> list[mpf]:
    """Of z^power A(z) + M(z) ((alpha + beta) z - beta), with the coefficients of M on top."""
    if power > 14 or power != int(power):
        raise ArithmeticError("too many roots")
    coefficients = [mpf(0)] * (int(power) + 3)
    coefficients[:3] = [mpf(1), loss + at_one - 2, 1 - loss]
    for i, factor in enumerate(top):
        coefficients[-len(top) - 1 + i] += factor * (alpha + beta)
        coefficients[-len(top) + i] -= factor * beta
    while coefficients[-1] == 0:
        coefficients.pop()
    try:
        with mpmath.workdps(30):
            roots = mpmath.polyroots(coefficients, maxsteps=200, extraprec=100)
    except mpmath.libmp.NoConvergence:
        raise ArithmeticError("no roots found") from None
    return [abs(root) for root in roots]

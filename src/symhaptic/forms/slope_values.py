"""Values of the derivatives of the device's functions in many digits: from matrix exponentials.

Each is the answer of devices in series, so nothing is divided and no case is special.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import flint
import mpmath
from flint import arb
from mpmath import mpf

from symhaptic.forms.slopes import (
    Coast,
    Ebb,
    Echo,
    Kick,
    NumeratorGapDrop,
    PlantN0Drop,
    PlantN1Drop,
)

_TRIES = 8
"""Precisions tried, each twice the one before, until the ball is small enough."""


def _chain(devices: int, gamma: Any, delta: Any, *rates: Any) -> Any:
    """exp of devices in series, each moved by the next, behind them decays of these rates."""
    size = 2 * devices + len(rates)
    matrix = [[arb(0)] * size for _ in range(size)]
    for i in range(0, 2 * devices, 2):
        matrix[i][i + 1] = arb(1)
        matrix[i + 1][i], matrix[i + 1][i + 1] = -gamma, -delta
    for i, rate in enumerate(rates, 2 * devices):
        matrix[i][i] = -rate
    for i in range(1, size - 1):
        if i % 2 or i >= 2 * devices:
            matrix[i][i + 1] = arb(1)
    return flint.arb_mat(matrix).exp()


def _ebb(gamma: Any, delta: Any) -> Any:
    """exp[-p, -p, -q, -q] - exp[-p - q, -p, -q]."""
    return _chain(2, gamma, delta)[0, 3] - _chain(1, gamma, delta, delta)[0, 2]


def _exact(number: mpf) -> Any:
    _, mantissa, power, _ = mpmath.mpmathify(number)._mpf_
    return arb(flint.fmpz(int(mantissa))) * arb(2) ** power * (-1 if number < 0 else 1)


def _numbers(found: Callable[[Any, Any], Any]) -> Callable[[mpf, mpf], mpf]:
    """To the digits that mpmath works with."""

    def at(gamma: mpf, delta: mpf) -> mpf:
        wanted = mpmath.mp.prec
        bits = 2 * wanted + int(2 * min(delta, 10**4))
        for _ in range(_TRIES):
            with flint.ctx.workprec(bits):
                ball = found(_exact(gamma), _exact(delta))
                if ball.rel_accuracy_bits() > wanted:
                    mantissa, power = ball.mid().man_exp()
                    return +mpf((int(mantissa), int(power)))
                if ball.contains(0) and ball < arb(2) ** (-2 * wanted - 2000):
                    return mpf(0)
            bits *= 2
        raise ArithmeticError(f"no {wanted} bits found at {gamma}, {delta}")

    return at


BY_MATRIX: dict[Any, Callable[[mpf, mpf], mpf]] = {
    Kick: _numbers(lambda g, d: _chain(1, g, d)[0, 1]),
    Coast: _numbers(lambda g, d: _chain(1, g, d)[1, 1]),
    Echo: _numbers(lambda g, d: _chain(2, g, d)[0, 3]),
    Ebb: _numbers(_ebb),
    PlantN1Drop: _numbers(lambda g, d: _chain(2, g, d, arb(0))[0, 4]),
    PlantN0Drop: _numbers(lambda g, d: _chain(2, g, d, d)[0, 4]),
    NumeratorGapDrop: _numbers(lambda g, d: _chain(2, g, d, arb(0), d)[0, 5]),
}

r"""The sampled plant in numbers, from forms without singularities.

Everything is made of entire functions of :math:`w=\delta^2/4-\gamma`, scaled by
:math:`e^{-\delta/2}` so that nothing overflows; nothing happens at :math:`\gamma=0`, at
:math:`\delta=0` or at critical damping.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import haptic
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.containers import kept
from symhaptic.numeric.given import Given

_NEAR = 4.0
"""Up to here in w and in delta^2/4 the power series of sinh(sqrt w)/sqrt w is used."""

_TERMS = 18
"""Its terms: the next one is below 4^19/39! = 1e-35."""


class Device(NamedTuple):
    """The numerator m2 z^2 + m1 z + m0 and the denominator z (z^2 - a z + e), at z = 1 and -1.

    Values at 1 and -1 and the loss 1 - e are kept beside the coefficients: near the ends of the
    upper half circle they are what a difference of coefficients would lose.
    """

    m2: Array
    m1: Array
    m0: Array
    numerator_at_one: Array
    numerator_at_minus_one: Array
    """m2 - m1 + m0."""
    a: Array
    e: Array
    at_one: Array
    """1 - a + e."""
    at_minus_one: Array
    """1 + a + e."""
    loss: Array
    """1 - e."""


def _exprel(x: Array) -> Array:
    """(exp(x) - 1)/x."""
    zero = x == 0
    return np.where(zero, 1.0, np.expm1(x) / np.where(zero, 1.0, x))


def _quotient(top: Array, bottom: Array) -> Array:
    """top/bottom, and 0 where the bottom is 0."""
    return np.where(bottom == 0, 0.0, top / np.where(bottom == 0, 1.0, bottom))


class _Motion(NamedTuple):
    """What the entire functions share: w and the two real exponents of a creeping plant."""

    gamma: Array
    delta: Array
    w: Array
    root: Array
    swings: NDArray[np.bool_]
    plus: Array
    """(delta + c)/4 where c is real."""
    minus: Array
    """(delta - c)/4 = gamma/(delta + c), without the difference."""


def _motion(gamma: Array, delta: Array) -> _Motion:
    w = (delta / 2) ** 2 - gamma
    root = np.sqrt(np.abs(w))
    plus = (delta / 2 + root) / 2
    return _Motion(gamma, delta, w, root, w < 0, plus, _quotient(gamma, 4 * plus))


def _at_rest(x: _Motion) -> Array:
    """n1 + n0 = exp(-delta/2) sinhc((delta + c)/4) sinhc((delta - c)/4)."""
    quarter = np.where(x.swings, x.delta / 4, 0.0)
    # |sinhc((delta + j y)/4)|^2 with y = 2 root, scaled by exp(-delta/2) = exp(-2 quarter)
    grown = quarter * _exprel(-2 * quarter)
    size = quarter**2 + x.root**2 / 4
    still = size < 1e-200  # the squares have no digits left
    swing = (grown**2 + np.exp(-2 * quarter) * np.sin(x.root / 2) ** 2) / np.where(still, 1.0, size)
    creep = _exprel(-2 * x.plus) * _exprel(-2 * x.minus)  # plus + minus is delta/2
    return np.where(x.swings, np.where(still, 1.0, swing), creep)


def _at_nyquist(x: _Motion) -> Array:
    """1 + a + e = 4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4)."""
    quarter = np.where(x.swings, x.delta / 4, 0.0)
    grown = quarter * _exprel(-2 * quarter)
    swing = grown**2 + np.exp(-2 * quarter) * np.cos(x.root / 2) ** 2
    creep = (1 + np.exp(-2 * x.plus)) * (1 + np.exp(-2 * x.minus))
    return np.asarray(np.where(x.swings, 4 * swing, creep))


def _sinhc_series(w: Array) -> Array:
    """sinh(sqrt w)/sqrt w for |w| <= 4, by Horner's rule."""
    total = np.ones_like(w)
    for k in range(_TERMS, 0, -1):
        total = 1 + w * total / (2 * k * (2 * k + 1))
    return total


def _difference_series(x: Array, w: Array) -> Array:
    """Divided difference of sinh(sqrt)/sqrt at x and w, both at most 4 in size."""
    total, mixed, power, factor = np.zeros_like(x), np.ones_like(x), np.ones_like(x), 6.0
    for k in range(1, _TERMS + 1):  # mixed is the sum of x^i w^(k-1-i)
        total = total + mixed / factor
        power = power * x
        mixed = mixed * w + power
        factor *= (2 * k + 2) * (2 * k + 3)
    return total


def _slope(x: _Motion) -> Array:
    """exp(-delta/2) times the divided difference of sinh(sqrt w)/sqrt w at delta^2/4 and w."""
    square = (x.delta / 2) ** 2
    near = (square <= _NEAR) & (np.abs(x.w) <= _NEAR)
    if np.all(near):
        return np.exp(-x.delta / 2) * _difference_series(square, x.w)
    series = _difference_series(np.where(near, square, 0.0), np.where(near, x.w, 0.0))
    # creeping, far from critical damping: no difference of nearly equal numbers
    creeps = x.w > 1
    whole = np.where(creeps, x.root + x.delta / 2, 1.0)
    rho = np.where(creeps, x.gamma, 0.0) / whole
    d = np.where(creeps, x.delta, 1.0)
    bracket = d * _exprel(-rho) * (1 + np.exp(rho - d)) + 2 * np.expm1(-d)
    creep = bracket / (2 * d * np.where(creeps, x.root, 1.0) * whole)
    # else the two points of the difference are gamma >= 1 apart
    odd = np.where(
        np.abs(x.w) <= _NEAR,
        _sinhc_series(np.where(np.abs(x.w) <= _NEAR, x.w, 0.0)),
        _quotient(np.sin(x.root), x.root),
    )
    apart = (_exprel(-x.delta) - np.exp(-x.delta / 2) * odd) / np.maximum(x.gamma, 1.0)
    far = np.where(creeps, creep, apart)
    return np.where(near, np.exp(-x.delta / 2) * series, far)


def _held(x: _Motion) -> tuple[Array, Array, Array, Array]:
    """n1, n0, their sum and their difference."""
    together, apart = _at_rest(x), x.delta * _slope(x)
    return (together + apart) / 2, (together - apart) / 2, together, apart


def impulse(gamma: Array, delta: Array, time: Array) -> Array:
    """The device's displacement ``time`` periods after a unit impulse."""
    x = _motion(gamma * time**2, delta * time)
    with np.errstate(invalid="ignore"):
        creep = np.exp(-2 * x.minus) * _exprel(-2 * x.root)
    swing = np.exp(-x.delta / 2) * np.sinc(np.where(x.swings, x.root, 0.0) / np.pi)
    return np.asarray(time * np.where(x.swings, swing, creep))


def device(gamma: Array, delta: Array, part: Array | None = None) -> Device:
    """The plant behind a delay of ``part`` periods, 0 <= part < 1, which lets the hold act late.

    m2 = (1 - part)^2 n1 of a plant sampled after 1 - part, m0 = part^2 exp(-delta (1 - part)) n0
    of one sampled after ``part``; the three add up to n1 + n0.
    """
    x = _motion(gamma, delta)
    n1, n0, together, apart = _held(x)
    at_one, at_minus_one = gamma * together, _at_nyquist(x)
    e, loss = np.exp(-delta), 0.0 - np.expm1(-delta)  # never -0.0: an angle of it is taken
    a = at_minus_one - (1 + e)
    if part is None or not np.any(part):
        zero = np.zeros_like(n1)
        return Device(n1, n0, zero, together, apart, a, e, at_one, at_minus_one, loss)
    rest = 1 - part
    m2 = rest**2 * _held(_motion(gamma * rest**2, delta * rest))[0]
    m0 = part**2 * np.exp(-delta * rest) * _held(_motion(gamma * part**2, delta * part))[1]
    m1 = together - (m2 + m0)
    late = m2 + m0 - m1
    whole = part == 0
    m2, m1, m0 = np.where(whole, n1, m2), np.where(whole, n0, m1), np.where(whole, 0.0, m0)
    late = np.where(whole, apart, late)
    return Device(m2, m1, m0, together, late, a, e, at_one, at_minus_one, loss)


def stuck(gamma: Array, delta: Array) -> NDArray[np.bool_]:
    """Whether an undamped device makes whole half swings in a period, to within rounding.

    Sampled, it returns to its place or to the mirror image of it, and a root stays at 1 or -1
    whatever the wall: nothing makes the loop stable.
    """
    free = (delta < 1e-15) & (gamma > 1)
    if not np.any(free):
        return np.asarray(free)
    swing = np.sqrt(np.where(free, gamma, 1.0))
    return np.asarray(free & (np.abs(np.sin(swing)) <= 4e-16 * swing))


@kept(n1=float, n0=float, a=float, e=float)
def discretize(gamma: ArrayLike, delta: ArrayLike) -> tuple[Array, Array, Array, Array]:
    """Exact discrete equivalent of the device behind a zero-order hold: n1, n0, a, e.

    P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m, for the physical stiffness
    ``gamma`` = k T^2/m >= 0 and the damping ``delta`` = b T/m >= 0; arrays broadcast.  Derived in
    chapter s4b_normalisation; the paper's (14), which is 0/0 where this is not.

    n1, which is never negative, is right to 2 last places for ``gamma`` up to 2^52, also where the
    device has just swung k turns and it nearly vanishes, ``gamma`` = (2 pi k)^2.  n0 changes its
    sign there, at ``delta`` near (sqrt(gamma) - 2 pi k)^2, and is right to 2 last places and
    ``delta`` times that of n1 + n0.  A last place of ``gamma`` itself moves both by far more.

    Raises :class:`ValueError` for a negative or infinite argument; NaN gives NaN.

    >>> [float(x) for x in discretize(0, 0)]
    [0.5, 0.5, 2.0, 1.0]
    """
    n1, n0, a, e = Given(gamma=gamma, delta=delta)(haptic.discretize)
    return n1, n0, a, e

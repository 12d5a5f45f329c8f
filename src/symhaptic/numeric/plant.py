r"""The sampled plant in numbers, from the generated kernels.

Their forms are entire functions of :math:`\gamma` and :math:`\delta`: nothing happens at
:math:`\gamma=0`, at :math:`\delta=0` or at critical damping, and nothing overflows.
"""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import haptic
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import MODULE, at_once
from symhaptic.numeric.containers import kept
from symhaptic.numeric.digits import in_digits
from symhaptic.numeric.given import Given


class Device(NamedTuple):
    """The numerator m2 z^2 + m1 z + m0 and the denominator z (z^2 - a z + e), at z = 1 and -1.

    Values at 1 and -1, m2 - m0 and the loss 1 - e are kept beside the coefficients: near the ends
    of the upper half circle they are what a difference of coefficients would lose.
    """

    m2: Array
    m1: Array
    m0: Array
    numerator_at_one: Array
    numerator_at_minus_one: Array
    """m2 - m1 + m0."""
    gap: Array
    """m2 - m0."""
    a: Array
    e: Array
    at_one: Array
    """1 - a + e."""
    at_minus_one: Array
    """1 + a + e."""
    loss: Array
    """1 - e."""


def _by_kernel(kernel: Any, *values: Array) -> Any:
    """What a kernel makes of NumPy arrays, element by element."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
        return haptic.elementwise(np, partial(kernel, np), *values)


_late_device = getattr(MODULE, "late_device", partial(_by_kernel, haptic.late_device))


def impulse(gamma: Array, delta: Array, time: Array) -> Array:
    r"""The device's displacement ``time`` periods t after a unit impulse.

    t exp(-delta t/2) sinh(r)/r with r = t sqrt(delta^2/4 - gamma); a creeping device's is
    t exp(r - delta t/2) (1 - exp(-2 r))/(2 r), whose first exponent is -gamma t^2/(delta t/2 + r).
    """
    stiffness, half = gamma * time**2, delta * time / 2
    square = half**2 - stiffness
    root = np.sqrt(np.abs(square))
    swing = np.exp(-half) * np.sinc(np.where(square < 0, root, 0.0) / np.pi)
    above = np.where(square > 0, root, 1.0)
    creep = np.exp(-stiffness / (half + above)) * -np.expm1(-2 * above) / (2 * above)
    return np.asarray(time * np.where(square > 0, creep, swing))


def device(gamma: Array, delta: Array, part: Array | None = None) -> Device:
    """The plant behind a delay of ``part`` periods, 0 <= part < 1, which lets the hold act late.

    m2 = (1 - part)^2 n1 of a plant sampled after 1 - part, m0 = part^2 exp(-delta (1 - part)) n0
    of one sampled after ``part``; the three add up to n1 + n0.
    """
    ends = haptic.device_at_minus_one_kick_together_n_gap
    at_minus_one, _, together, apart = _by_kernel(ends, gamma, delta)
    n1 = _by_kernel(haptic.plant_n1, gamma, delta)
    n0 = _by_kernel(haptic.plant_n0, gamma, delta)
    e, loss = np.exp(-delta), 0.0 - np.expm1(-delta)  # never -0.0: an angle of it is taken
    undelayed = Device(
        n1,
        n0,
        np.zeros_like(n1),
        numerator_at_one=together,
        numerator_at_minus_one=delta * apart,
        gap=n1,
        a=at_minus_one - (1 + e),
        e=e,
        at_one=gamma * together,
        at_minus_one=at_minus_one,
        loss=loss,
    )
    return undelayed if part is None else behind(undelayed, gamma, delta, np.asarray(part))


def behind(undelayed: Device, gamma: Array, delta: Array, part: Array) -> Device:
    """The same plant behind a delay of ``part`` periods: what M = m2 z^2 + m1 z + m0 has is other.

    M(-1) is no difference of the three, which has no digits where a lightly damped device makes
    whole half swings in a period.
    """
    apart, m2, _, m0 = _late_device(gamma, delta, part)
    x, whole = undelayed, part == 0
    gap = _gap(gamma, delta, part, m2, m0)
    return x._replace(
        m2=np.where(whole, x.m2, m2),
        m1=np.where(whole, x.m1, x.numerator_at_one - (m2 + m0)),
        m0=np.where(whole, 0.0, m0),
        numerator_at_minus_one=np.where(whole, x.numerator_at_minus_one, apart),
        gap=np.where(whole, x.gap, gap),
    )


class Swing(NamedTuple):
    r"""A device that swings with w, about the middle of a period: u = 1/2 - part.

    With h = delta/2 a sum or difference of what happens in both parts of the period is made of
    F = 1 - exp(-h) and sin(w/2), or of F and cos(w/2): nothing as large as the parts is in it, of
    which little is left next to whole and to half swings in a period.
    """

    there: NDArray[np.bool_]
    """Whether it swings; the rest is of no use otherwise."""
    w: Array
    lost: Array
    """F."""
    kept: Array
    """2 - F."""
    sine: Array
    """sin(w/2), of w to twice the digits."""
    cosine: Array
    turned: Array
    """w u."""
    fade: Array
    """exp(-h (1 - part))."""

    def slopes(self) -> tuple[Array, Array]:
        """m2' + m0' and m2' - m0'."""
        early, even = np.sin(self.turned), np.cos(self.turned)
        sine, cosine = self.sine * even, self.cosine * early
        share = -self.fade / self.w
        sums, gaps = self.lost * sine + self.kept * cosine, self.kept * sine + self.lost * cosine
        return share * sums, share * gaps


def swing(gamma: Array, delta: Array, part: Array) -> Swing:
    """The device behind ``part`` periods of delay."""
    half, square, square_low, root, _ = _by_kernel(haptic.device_motion, gamma, delta)
    there = square < 0
    w = np.where(there, root, 1.0)
    low = np.where(there, _by_kernel(haptic.root_miss, square, square_low, root), 0.0) / 2
    sine, cosine = np.sin(w / 2), np.cos(w / 2)
    return Swing(there, w, -np.expm1(-half), 1 + np.exp(-half), sine + low * cosine,
                 cosine - low * sine, w * (0.5 - part), np.exp(-half * (1 - part)))  # fmt: skip


def _gap(gamma: Array, delta: Array, part: Array, m2: Array, m0: Array) -> Array:
    """m2 - m0, the difference or (F (2 - F) - along - across)/gamma, whichever rounds less."""
    v = swing(gamma, delta, part)
    half, turned = delta / (2 * v.w), np.abs(v.turned)
    early, even = np.sin(v.turned), np.cos(v.turned)
    along = v.fade * v.lost * v.cosine * (even + half * early)
    across = v.fade * v.kept * v.sine * (half * even - early)
    terms = v.lost * (1 + half) * (1 + turned) + np.abs(v.sine) * (half + turned)
    better = v.there & (8 * terms < gamma * (m2 + m0))
    found = (v.lost * v.kept - along - across) / np.where(better, gamma, 1.0)
    return np.asarray(np.where(better, found, m2 - m0))


def stuck(gamma: Array, delta: Array) -> NDArray[np.bool_]:
    """Whether an undamped device makes whole half swings in a period, to within rounding.

    Sampled, it returns to its place or to the mirror image of it, and a root stays at 1 or -1
    whatever the wall: nothing makes the loop stable.
    """
    one = np.ones_like(gamma)
    return np.asarray(haptic.stable(np, 0 * one, one, 0 * one, gamma, delta) < 1)


@at_once("discretize")
@kept(n1=float, n0=float, a=float, e=float)
def discretize(
    gamma: ArrayLike, delta: ArrayLike, *, digits: int | None = None
) -> tuple[Array, Array, Array, Array]:
    """Exact discrete equivalent of the device behind a zero-order hold.

    Parameters
    ----------
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0; they broadcast.
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits.

    Returns
    -------
    n1, n0, a, e : float or ndarray
        P(z) = (n1 z + n0)/(z^2 - a z + e), in units of T^2/m.

    Raises
    ------
    ValueError
        If an argument is negative or infinite; NaN gives NaN.

    See Also
    --------
    discretize_fractional : The same with a fractional delay.

    Notes
    -----
    This is (14) of the paper without its cases of 0/0; derived in chapter s4b_normalisation.

    n1 is never negative.  Its error is at most 2 units in the last place, also near
    gamma = (2 pi k)^2, where n1 nearly vanishes.  n0 changes its sign there, at delta near
    (sqrt(gamma) - 2 pi k)^2.  Its error is at most 2 units in its last place plus delta times those
    of n1 + n0.  Changing gamma by one unit in the last place moves both by far more.

    Examples
    --------
    >>> [float(x) for x in discretize(0, 0)]
    [0.5, 0.5, 2.0, 1.0]
    """
    if digits is not None:
        return in_digits(  # type: ignore[no-any-return]
            "discretize", digits, gamma=gamma, delta=delta
        )
    n1, n0, a, e = Given(gamma=gamma, delta=delta)(haptic.discretize)
    return n1, n0, a, e


@at_once("discretize_fractional")
@kept(m2=float, m1=float, m0=float, a=float, e=float)
def discretize_fractional(
    gamma: ArrayLike, delta: ArrayLike, epsilon: ArrayLike, *, digits: int | None = None
) -> tuple[Array, Array, Array, Array, Array]:
    """Exact discrete equivalent of the device with a fractional delay.

    Parameters
    ----------
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    epsilon : array_like
        Delay in sampling periods, 0 <= epsilon < 1.  All arguments broadcast.
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits.

    Returns
    -------
    m2, m1, m0, a, e : float or ndarray
        P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e)), in units of T^2/m.

    Raises
    ------
    ValueError
        If ``gamma`` or ``delta`` is negative or infinite, or ``epsilon`` is outside [0, 1); NaN
        gives NaN.

    Notes
    -----
    This is the modified z-transform: the previous value of the hold acts for a part of each period.
    Derived in chapter s6a_fractional_plant.  An integer part of the delay multiplies P by a power
    of 1/z.

    Examples
    --------
    >>> [float(x) for x in discretize_fractional(0, 0, 0.5)]
    [0.125, 0.75, 0.125, 2.0, 1.0]
    """
    if digits is not None:
        return in_digits(  # type: ignore[no-any-return]
            "discretize_fractional", digits, gamma=gamma, delta=delta, epsilon=epsilon
        )
    given = Given(gamma=gamma, delta=delta, epsilon=epsilon)
    m2, m1, m0, a, e = given(haptic.discretize_fractional)
    return m2, m1, m0, a, e

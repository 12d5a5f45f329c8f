r"""The explicit stability boundary in numbers: one angle, one point.

With :math:`Q=-z^{l+1}A/M` on the unit circle, :math:`\beta=\Im Q/\sin\theta` and
:math:`\alpha=\Re Q-\beta(1-\cos\theta)`; chapter s4d_explicit_boundary.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symhaptic.kernels import haptic
from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import at_once, finite
from symhaptic.numeric.containers import kept
from symhaptic.numeric.digits import in_digits
from symhaptic.numeric.given import Given
from symhaptic.numeric.plant import Device

_SPLIT = 2.0**27 + 1
"""Veltkamp's factor: halves of a float64 whose products are exact."""


def _halves(number: Array) -> tuple[Array, Array]:
    big = _SPLIT * number
    high = big - (big - number)
    return high, number - high


def _turn(steps: Array, theta: Array) -> tuple[Array, Array]:
    """cos and sin of (steps + 1) theta, with the rounding of sum and product put back."""
    count = steps + 1
    product = count * theta
    high, low = _halves(theta)
    most, least = _halves(count)
    error = ((most * high - product) + most * low + least * high) + least * low
    error = error + (steps - (count - 1)) * theta
    half = np.tan(product / 2)  # one tangent instead of cosine and sine
    square = half * half
    whole = 1 / (1 + square)
    cosine, sine = (1 - square) * whole, 2 * half * whole
    return cosine - error * sine, sine + error * cosine


class _Circle(NamedTuple):
    """A/z and M/z at z = exp(j theta), both times 1 + t^2 with t = tan(theta/2), by parts.

    Polynomials in t whose coefficients are the values at z = 1 and -1: no difference of cosines.
    """

    t: Array
    grown: Array
    """1 + t^2."""
    above: Array
    above_j: Array
    below: Array
    below_j: Array


def _on_circle(x: Device, theta: Array) -> _Circle:
    t = np.tan(theta / 2)
    square, twice = t * t, t + t
    return _Circle(
        t,
        1 + square,
        x.at_one - x.at_minus_one * square,
        x.loss * twice,
        x.numerator_at_one - x.numerator_at_minus_one * square,
        x.gap * twice,
    )


def point(x: Device, theta: Array, steps: Array) -> tuple[Array, Array]:
    """The wall with a root at exp(j theta), behind a whole delay (or a real one, principal)."""
    c = _on_circle(x, theta)
    cosine, sine = _turn(steps, theta)
    size = c.below * c.below + c.below_j * c.below_j
    size = np.where(size == 0, np.nan, size)  # no force reaches the device at this frequency
    ratio = (c.above * c.below + c.above_j * c.below_j) / size
    ratio_j = (c.above_j * c.below - c.above * c.below_j) / size
    real, imaginary = ratio_j * sine - ratio * cosine, -ratio_j * cosine - ratio * sine
    # Im Q / sin theta, and Re Q - beta (1 - cos theta) = Re Q - Im Q t
    return real - imaginary * c.t, imaginary * c.grown / (c.t + c.t)


def tangent(x: Device, theta: Array, steps: Array) -> tuple[Array, Array]:
    """Derivatives of the boundary's alpha and beta with respect to theta."""
    c = _on_circle(x, theta)
    below = c.below + 1j * c.below_j
    ratio = (c.above + 1j * c.above_j) / below
    # by t first: dt = (1 + t^2)/2 dtheta
    above_slope = 2 * (1j * x.loss - x.at_minus_one * c.t)
    below_slope = 2 * (1j * x.gap - x.numerator_at_minus_one * c.t)
    real, imaginary = _turn(steps, theta)
    turn = -(real + 1j * imaginary)
    q = turn * ratio
    by_t = (above_slope - ratio * below_slope) / below * (c.grown / 2)
    slope = turn * (1j * (steps + 1) * ratio + by_t)
    sine, cosine = 2 * c.t / c.grown, (1 - c.t) * (1 + c.t) / c.grown
    stiffness = slope.real - slope.imag * c.t - q.imag * c.grown / 2
    return stiffness, (slope.imag - q.imag * cosine / sine) / sine


def begin(x: Device, gamma: Array, steps: Array) -> tuple[Array, Array]:
    """Limit of the boundary at theta = 0, where two roots meet at 1."""
    turned = (2 * x.m2 + x.m1) / x.numerator_at_one - (steps + 2)
    return -gamma, gamma * turned - x.loss / x.numerator_at_one


def end(x: Device, steps: Array) -> tuple[Array, Array]:
    """Limit at theta = pi for whole ``steps``, where two roots meet at -1; may be infinite."""
    sign = np.where(steps % 2 == 0, 1.0, -1.0)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        line = sign * x.at_minus_one / x.numerator_at_minus_one  # alpha + 2 beta
        lead = sign * ((steps + 2) * x.at_minus_one + 2 + x.a)
        both = (lead + (x.m1 - 2 * x.m2) * line) / x.numerator_at_minus_one  # alpha + beta
        return 2 * both - line, line - both


@at_once("stability_boundary", sure=finite)
@kept(alpha=float, beta=float)
def stability_boundary(
    theta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    digits: int | None = None,
) -> tuple[Array, Array]:
    r"""The wall (alpha, beta) that puts a characteristic root at exp(j theta).

    Parameters
    ----------
    theta : array_like
        Angle omega T of the root, 0 < theta < pi.
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits.

    Returns
    -------
    alpha, beta : float or ndarray
        K T^2/m and B T/m, of the shape to which the arguments broadcast.  NaN at an angle at which
        no force reaches the device.

    Raises
    ------
    ValueError
        If ``theta`` is outside (0, pi), or ``gamma``, ``delta`` or ``delay`` is negative or too
        large; NaN gives NaN.

    See Also
    --------
    stable_region : The region; not every point of the boundary lies on its border.

    Notes
    -----
    The boundary is explicit.  With the plant P(z) of :func:`symhaptic.discretize`, the wall solves

    .. math:: 1+z^{-(d+1)}((\alpha+\beta)z-\beta)P(z)=0,\quad z=e^{j\theta},

    two linear equations for alpha and beta.  Derived in chapter s4d_explicit_boundary; the paper
    finds these points by a grid.

    Examples
    --------
    >>> alpha, beta = stability_boundary(1.0, 0.0, 0.0, 1)
    >>> round(float(alpha), 12), round(float(beta), 12)  # 4 tan(1/2)^2 cos 2, ...
    (-0.496790118283, 1.241897955708)
    """
    arguments.check_sheet(sheet)
    if digits is not None:
        return in_digits(  # type: ignore[no-any-return]
            "stability_boundary", digits, sheet, theta=theta, gamma=gamma, delta=delta, delay=delay
        )
    given = Given(theta=theta, gamma=gamma, delta=delta, delay=delay)
    found = given(haptic.stability_boundary) if sheet == "exact" else given.each(_principal)
    alpha, beta = (given.xp.where(given.xp.isfinite(found[0]), x, given.xp.nan) for x in found)
    return alpha, beta


def _principal(xp: Any, theta: Any, gamma: Any, delta: Any, delay: Any) -> tuple[Any, Any]:
    """The curve of a device without delay, turned by z^-delay."""
    at_minus_one, _, together, gap = haptic.device_at_minus_one_kick_together_n_gap(
        xp, gamma, delta
    )
    apart = delta * gap
    loss, half = delta * haptic.decay(xp, delta), theta / 2
    device = gamma * together, at_minus_one, loss, together, apart, together + apart
    ahead, in_phase = haptic.ahead_in_phase(xp, half, *device)
    cosine, sine = haptic.next_wave(xp, delay, theta)
    pull = ahead * cosine + in_phase * sine
    return ahead * sine - in_phase * cosine + pull * xp.tan(half), -pull / xp.sin(theta)

r"""The explicit stability boundary in numbers: one angle, one point.

With :math:`Q=-z^{l+1}A/M` on the unit circle, :math:`\beta=\Im Q/\sin\theta` and
:math:`\alpha=\Re Q-\beta(1-\cos\theta)`; chapter s4d_explicit_boundary.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import arguments
from symhaptic.kernels.arguments import Array
from symhaptic.kernels.plant import Device, device
from symhaptic.kernels.stability import SHEETS

Complex = NDArray[np.complex128]

_SPLIT = 2.0**27 + 1
"""Veltkamp's factor: halves of a float64 whose products are exact."""


def _turned(steps: Array, theta: Array) -> tuple[Array, Array]:
    """cos and sin of steps * theta, with the product's rounding error put back."""
    product = steps * theta
    big = _SPLIT * theta
    high = big - (big - theta)
    wide = _SPLIT * steps
    most = wide - (wide - steps)
    low, least = theta - high, steps - most
    error = ((most * high - product) + most * low + least * high) + least * low
    return np.cos(product) - error * np.sin(product), np.sin(product) + error * np.cos(product)


def _quotient(x: Device, theta: Array, steps: Array) -> tuple[Complex, Complex]:
    """Q on the unit circle, and its derivative with respect to theta."""
    half_sine, half_cosine = np.sin(theta / 2), np.cos(theta / 2)
    sine, cosine = 2 * half_sine * half_cosine, (half_cosine - half_sine) * (
        half_cosine + half_sine
    )
    small = theta < np.pi / 2
    y, rest = -2 * half_sine**2, 2 * half_cosine**2

    def on_circle(at_one: Array, at_minus_one: Array, slope: Array, height: Array) -> Complex:
        real = np.where(small, at_one + slope * y, slope * rest - at_minus_one)
        return real + 1j * (height * sine)

    above = on_circle(x.at_one, x.at_minus_one, 1 + x.e, x.loss)  # A/z
    below = on_circle(x.numerator_at_one, x.numerator_at_minus_one, x.m2 + x.m0, x.m2 - x.m0)
    grows_above = -(1 + x.e) * sine + 1j * (x.loss * cosine)
    grows_below = -(x.m2 + x.m0) * sine + 1j * ((x.m2 - x.m0) * cosine)
    real, imaginary = _turned(steps + 1, theta)
    turn = -(real + 1j * imaginary)
    ratio = above / below
    slope = 1j * (steps + 1) * ratio + (grows_above - ratio * grows_below) / below
    return turn * ratio, turn * slope


def point(x: Device, theta: Array, steps: Array) -> tuple[Array, Array]:
    """The wall with a root at exp(j theta), behind a whole delay (or a real one, principal)."""
    q, _ = _quotient(x, theta, steps)
    # Re Q - beta (1 - cos theta) = Re Q - Im Q tan(theta/2)
    return q.real - q.imag * np.tan(theta / 2), q.imag / np.sin(theta)


def tangent(x: Device, theta: Array, steps: Array) -> tuple[Array, Array]:
    """Derivatives of the boundary's alpha and beta with respect to theta."""
    q, slope = _quotient(x, theta, steps)
    half, sine = np.tan(theta / 2), np.sin(theta)
    stiffness = slope.real - slope.imag * half - q.imag * (1 + half**2) / 2
    return stiffness, (slope.imag - q.imag * np.cos(theta) / sine) / sine


def stability_boundary(
    theta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
) -> tuple[Array, Array]:
    """The wall (alpha, beta) that puts a characteristic root at exp(j theta), 0 < theta < pi.

    For the plant ``gamma`` = k T^2/m >= 0, ``delta`` = b T/m >= 0 and a delay of ``delay`` >= 0
    periods; exact for fractions (modified z-transform), or with ``sheet="principal"`` the paper's
    z^-d = exp(-j d theta).  Arrays broadcast.  Not every point borders the stable region: see
    :func:`symhaptic.stable_region`.  Derived in chapter s4d_explicit_boundary; the paper finds
    these points by a grid.

    Raises :class:`ValueError` for theta outside (0, pi) and an impossible plant or delay; NaN
    gives NaN.

    >>> alpha, beta = stability_boundary(1.0, 0.0, 0.0, 1)
    >>> round(float(alpha), 12), round(float(beta), 12)  # 4 tan(1/2)^2 cos 2, ...
    (-0.49679194797, 1.241901466117)
    """
    arguments.one_of("sheet", sheet, SHEETS)
    th = arguments.real("theta", theta)
    arguments.refuse("theta", th, (th <= 0) | (th >= np.pi), "numbers 0 < theta < pi are")
    g, dl = arguments.nonnegative("gamma", gamma), arguments.nonnegative("delta", delta)
    dy = arguments.nonnegative("delay", delay)
    alpha, beta = arguments.in_blocks(lambda *a: _pair(*a, sheet), th, g, dl, dy)
    return alpha, beta


def _pair(theta: Array, gamma: Array, delta: Array, delay: Array, sheet: str) -> Array:
    steps = delay if sheet == "principal" else np.floor(delay)
    x = device(gamma, delta, None if sheet == "principal" else delay - steps)
    return np.stack(np.broadcast_arrays(*point(x, theta, steps)))

r"""The explicit stability boundary in numbers: one angle, one point.

With :math:`Q=-z^{l+1}A/M` on the unit circle, :math:`\beta=\Im Q/\sin\theta` and
:math:`\alpha=\Re Q-\beta(1-\cos\theta)`; chapter s4d_explicit_boundary.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symhaptic.kernels import arguments
from symhaptic.kernels.arguments import Array
from symhaptic.kernels.plant import Device, device
from symhaptic.kernels.stability import SHEETS

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


class _Circle(NamedTuple):
    """A/z and M/z at z = exp(j theta), by real and imaginary part, and the angle's functions."""

    half_sine: Array
    half_cosine: Array
    sine: Array
    above: Array
    above_j: Array
    below: Array
    below_j: Array


def _on_circle(x: Device, theta: Array) -> _Circle:
    half_sine, half_cosine = np.sin(theta / 2), np.cos(theta / 2)
    sine = 2 * half_sine * half_cosine
    small = theta < np.pi / 2
    part = np.where(small, -(half_sine**2), half_cosine**2) * 2

    def real(at_one: Array, at_minus_one: Array, slope: Array) -> Array:
        return np.asarray(np.where(small, at_one, -at_minus_one) + slope * part)

    return _Circle(
        half_sine,
        half_cosine,
        sine,
        real(x.at_one, x.at_minus_one, 1 + x.e),
        x.loss * sine,
        real(x.numerator_at_one, x.numerator_at_minus_one, x.m2 + x.m0),
        (x.m2 - x.m0) * sine,
    )


def point(x: Device, theta: Array, steps: Array) -> tuple[Array, Array]:
    """The wall with a root at exp(j theta), behind a whole delay (or a real one, principal)."""
    c = _on_circle(x, theta)
    cosine, turn = _turned(steps + 1, theta)
    size = c.below**2 + c.below_j**2
    ratio = (c.above * c.below + c.above_j * c.below_j) / size
    ratio_j = (c.above_j * c.below - c.above * c.below_j) / size
    real, imaginary = ratio_j * turn - ratio * cosine, -ratio_j * cosine - ratio * turn
    # Re Q - beta (1 - cos theta) = Re Q - Im Q tan(theta/2)
    return real - imaginary * (c.half_sine / c.half_cosine), imaginary / c.sine


def tangent(x: Device, theta: Array, steps: Array) -> tuple[Array, Array]:
    """Derivatives of the boundary's alpha and beta with respect to theta."""
    c = _on_circle(x, theta)
    cosine = (c.half_cosine - c.half_sine) * (c.half_cosine + c.half_sine)
    below = c.below + 1j * c.below_j
    ratio = (c.above + 1j * c.above_j) / below
    above_slope = 1j * (x.loss * cosine) - (1 + x.e) * c.sine
    below_slope = 1j * ((x.m2 - x.m0) * cosine) - (x.m2 + x.m0) * c.sine
    real, imaginary = _turned(steps + 1, theta)
    turn = -(real + 1j * imaginary)
    q = turn * ratio
    slope = turn * (1j * (steps + 1) * ratio + (above_slope - ratio * below_slope) / below)
    half = c.half_sine / c.half_cosine
    stiffness = slope.real - slope.imag * half - q.imag * (1 + half**2) / 2
    return stiffness, (slope.imag - q.imag * cosine / c.sine) / c.sine


def begin(x: Device, gamma: Array, steps: Array) -> tuple[Array, Array]:
    """Limit of the boundary at theta = 0, where two roots meet at 1."""
    turned = (2 * x.m2 + x.m1) / x.numerator_at_one - (steps + 2)
    return -gamma, gamma * turned - x.loss / x.numerator_at_one


def end(x: Device, steps: Array) -> tuple[Array, Array]:
    """Limit at theta = pi for whole ``steps``, where two roots meet at -1; may be infinite."""
    sign = np.where(steps % 2 == 0, 1.0, -1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        line = sign * x.at_minus_one / x.numerator_at_minus_one  # alpha + 2 beta
        lead = sign * ((steps + 2) * x.at_minus_one + 2 + x.a)
        both = (lead + (x.m1 - 2 * x.m2) * line) / x.numerator_at_minus_one  # alpha + beta
        return 2 * both - line, line - both


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
    (-0.496790118283, 1.241897955708)
    """
    arguments.one_of("sheet", sheet, SHEETS)
    th = arguments.real("theta", theta)
    arguments.refuse("theta", th, (th <= 0) | (th >= np.pi), "numbers 0 < theta < pi are")
    g, dl = arguments.nonnegative("gamma", gamma), arguments.nonnegative("delta", delta)
    dy = arguments.nonnegative("delay", delay)
    alpha, beta = arguments.in_blocks(partial(_pair, sheet=sheet), th, g, dl, dy)
    return alpha, beta


def _pair(theta: Array, gamma: Array, delta: Array, delay: Array, sheet: str) -> Array:
    steps = delay if sheet == "principal" else np.floor(delay)
    x = device(gamma, delta, None if sheet == "principal" else delay - steps)
    return np.stack(np.broadcast_arrays(*point(x, theta, steps)))

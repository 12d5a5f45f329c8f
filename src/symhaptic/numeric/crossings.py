r"""Where the plant and the wall are equally strong on the unit circle: :math:`|f|=|g|`.

With :math:`y=4\sin^2(\theta/2)` the surplus :math:`|f|^2-|g|^2` is a polynomial of degree two,
three for a fractional delay, that does not contain the delay.  It is expanded about three points,
and each root taken from the nearest: about the ends 0 and 4 of the half circle, where walls next
to a root at 1 or -1 would lose their digits, and about the plant's own frequency, where a plant of
little damping is as weak as a weak wall.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric import cubic
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.cubic import Terms
from symhaptic.numeric.plant import Device


class Wall(NamedTuple):
    """The wall's part W = (alpha + beta) z - beta by what is needed of it."""

    alpha: Array
    beta: Array
    slope: Array
    """alpha + beta."""
    at_minus_one: Array
    """-(alpha + 2 beta) is its value at -1."""


def wall(alpha: Array, beta: Array) -> Wall:
    """The wall, with no negative zeros."""
    return Wall(alpha + 0.0, beta + 0.0, alpha + beta + 0.0, alpha + 2 * beta)


class Surplus(NamedTuple):
    """The coefficients of |f|^2 - |g|^2, constant term first, about three points."""

    near: Terms
    """In y."""
    own: Terms
    """In y - center."""
    far: Terms
    """In 4 - y."""
    center: Array
    """y at the plant's own frequency, where the real part of A/z is 0."""
    beyond: Array
    """4 - center."""


class Crossing(NamedTuple):
    """A solution of |f| = |g| on the upper half circle, if it is one."""

    y: Array
    """4 sin(theta/2)^2."""
    rest: Array
    """4 - y, kept beside it for angles near pi."""
    off: Array
    """y - center, kept beside it for angles near the plant's own frequency."""
    rises: NDArray[np.bool_]
    """Whether |f|^2 - |g|^2 grows with y, that is whether g stops to lead."""
    there: NDArray[np.bool_]


def surplus(x: Device, v: Wall) -> Surplus:
    """|f|^2 - |g|^2 of |A|^2 - |M|^2 |W|^2 about y = 0, the plant's own frequency, and y = 4."""
    force = v.slope * v.beta  # |W|^2 = alpha^2 + force y
    near = _about_end(x, x.at_one, x.numerator_at_one, v.alpha, force)
    far = _about_end(x, x.at_minus_one, x.numerator_at_minus_one, v.at_minus_one, -force)
    total = 1 + x.e
    center, beyond = 2 * x.at_one / total, 2 * x.at_minus_one / total
    # |A|^2 = (1 + e)^2/4 (y - center)^2 + loss^2 y (4 - y)/4, likewise |M|^2 and |W|^2
    sine, tilt = center * beyond / 4, (beyond - center) / 4
    m_real = (x.numerator_at_one * beyond - x.numerator_at_minus_one * center) / 4
    across, along = x.gap**2, x.m2 + x.m0
    m = m_real**2 + across * sine, across * tilt - along * m_real, x.m2 * x.m0
    w_real = (v.alpha * beyond - v.at_minus_one * center) / 4
    w = w_real**2 + v.slope**2 * sine
    loss = x.loss**2
    own = (
        loss * sine - m[0] * w,
        loss * tilt - m[1] * w - m[0] * force,
        x.e - m[2] * w - m[1] * force,
        -m[2] * force,
    )
    return Surplus(near, own, far, center, beyond)


def _about_end(x: Device, at: Array, top: Array, force: Array, slope: Array) -> Terms:
    """The coefficients from the values of A, M and W at an end of the half circle.

    |A|^2 = at^2 + (loss^2 - at (1 + e)) y + e y^2, likewise |M|^2, and |W|^2 = force^2 + slope y.
    """
    m_linear, m_square = x.gap**2 - top * (x.m2 + x.m0), x.m2 * x.m0
    scaled = top * force
    constant = (at - scaled) * (at + scaled)
    linear = x.loss**2 - at * (1 + x.e) - m_linear * force**2 - top**2 * slope
    square = x.e - m_square * force**2 - m_linear * slope
    return constant, linear, square, -m_square * slope


def crossings(s: Surplus, whole: bool) -> list[Crossing]:
    """Where |f| = |g| on the open upper half circle."""
    if not whole:
        return [Crossing(*found) for found in cubic.roots(*s)]
    # the discriminant is the same about each point; where its terms are small it rounds least
    parts = [(k[1] * k[1], 4 * k[0] * k[2]) for k in (s.near, s.own, s.far)]
    sizes = [square + np.abs(product) for square, product in parts]
    near, own, far = (square - product for square, product in parts)
    disc = np.where(sizes[1] <= np.minimum(sizes[0], sizes[2]), own, near)
    disc = np.where(sizes[2] < np.minimum(sizes[0], sizes[1]), far, disc)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        root = np.sqrt(disc)
        falling, rising = _quadratic(s.near, root)
        falling_own, rising_own = _quadratic(s.own, root)
        rising_far, falling_far = _quadratic(s.far, root)
    return [
        _nearest(s, falling, falling_own, falling_far, np.False_),
        _nearest(s, rising, rising_own, rising_far, np.True_),
    ]


def _quadratic(k: Terms, root: Array) -> tuple[Array, Array]:
    """Roots (-b - root)/(2 a) and (-b + root)/(2 a) without cancellation."""
    c, b, a, _ = k
    upper = b >= 0
    q = -(b + np.where(upper, root, -root)) / 2
    one, two = q / a, c / q
    return np.where(upper, one, two), np.where(upper, two, one)


def _nearest(s: Surplus, y: Array, off: Array, rest: Array, rises: np.bool_) -> Crossing:
    """The same root about the three points, from the one that is nearest."""
    small = y < rest  # their sum is 4 but for rounding, and where both are far off the circle
    edge = np.where(small, y, rest)
    there = (y > 0) & (rest > 0) & (edge < 4)
    own = (np.abs(off) < edge) & (s.center + off > 0) & (s.beyond - off > 0)
    y = np.where(own, s.center + off, np.where(small, y, 4 - rest))
    rest = np.where(own, s.beyond - off, np.where(small, 4 - y, rest))
    off = np.where(own, off, np.where(small, y - s.center, s.beyond - rest))
    return Crossing(
        np.where(there, y, 2.0),
        np.where(there, rest, 2.0),
        np.where(there, off, 0.0),
        np.asarray(rises),
        there,
    )

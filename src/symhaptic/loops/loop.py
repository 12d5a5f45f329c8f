"""p = z^M A + K X + B Y + E: the characteristic polynomial of a loop, affine in the wall.

K and B are in units of the mass and the period, as alpha and beta of the paper.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, reduce

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops.circle import Array, point, roots, terms, value
from symhaptic.loops.number import Polynomial, product, scaled, total
from symhaptic.loops.plant import Sampled, transfer
from symhaptic.loops.velocity import Measured, Velocity


@dataclass(frozen=True)
class Loop:
    """Loops, one or an array of them; coefficients on the last axis, the lowest power first.

    The powers are those of w = z - 1.  For differences over many samples X, Y and E are in powers
    of z, because the coefficients of (1 + w)^50 have more digits than a float.
    """

    A: Array
    """Of the device and the filter; of the highest degree, so that p has M + its degree."""
    X: Array
    Y: Array
    E: Array
    """Of the wall's virtual mass."""
    M: NDArray[np.int64]
    in_z: bool = False
    ahead: tuple[Array, ...] = ()
    """What K and B are the factors of beside A, with a coupling: z^M (A + K ahead[0] + ...)."""

    @property
    def degree(self) -> NDArray[np.int64]:
        """How many roots the loop has."""
        return np.asarray(self.M + (self.A.shape[-1] - 1))

    def device(self, K: Array, B: Array) -> Array:
        """Coefficients of A with what the wall adds to it."""
        return sum((x[..., None] * q for x, q in zip((K, B), self.ahead, strict=False)), self.A)

    @cached_property
    def doubtful(self) -> Array:
        """Angles next to roots of A at which little is left of its terms.

        There rounded coefficients may have a root on the other side of the circle.
        """
        theta = np.abs(np.angle(roots(self.A) + 1)).ravel()
        left = np.abs(value(self.A[..., None, :], point(theta, False)))
        return theta[(left < _LITTLE * terms(self.A, theta, False)).reshape(-1, len(theta)).any(0)]

    def wall(self, K: Array, B: Array) -> Array:
        """Coefficients of K X + B Y + E."""
        return K[..., None] * self.X + B[..., None] * self.Y + self.E


_LITTLE = 1e-6
"""The part of all terms below which their rounding is looked at."""

SHORT = 4
"""Up to so many samples a mean is written in powers of w."""


def closed(
    sampled: Sampled,
    whole: NDArray[np.int64],
    velocity: Velocity,
    period: float,
    virtual_mass: float = 0.0,
    coupling: tuple[float, float] | None = None,
) -> Loop:
    """The loop of a sampled device, ``whole`` periods of delay beside its part of one, and a wall.

    ``virtual_mass`` is M/m of a wall that adds M (1 - 1/z)^2/T^2 to its force.  With a coupling C
    the wall W becomes C W/(C + W), and p = z^M A (C + W) + P C W, which is affine in K and B, too.
    """
    long = velocity.over > SHORT
    z: Polynomial = (0, 1) if long else (1, 1)
    w: Polynomial = (-1, 1) if long else (0, 1)

    def own(polynomial: Polynomial) -> Polynomial:
        """A polynomial in w, in the powers of this loop."""
        *others, last = polynomial
        return reduce(lambda sum_, each: total(product(sum_, w), (each,)), others[::-1], (last,))

    def seen(row: Array) -> Polynomial:
        early, _ = transfer(sampled, row, sampled.early)
        if not sampled.late.any():
            return own(_split(early))
        late, _ = transfer(sampled, row, sampled.late)
        return total(product(own(_split(early)), z), own(_split(late)))

    def to_the(power: int) -> Polynomial:
        return reduce(product, [z] * power, (1,))

    _, device = transfer(sampled, sampled.position, sampled.early)
    place = seen(sampled.position)
    rest: Polynomial = (1,)
    above: Polynomial = ()
    n = velocity.over if long else 0
    if long:
        above = (-1 / n, *[0] * (n - 1), 1 / n)
    elif not isinstance(velocity, Measured):
        above, rest, n = velocity.ratio(period)
    late = max(n, 2 if virtual_mass else 0)
    stiff, damped = product(rest, to_the(late)), product(above, to_the(late - n)) if above else ()
    heavy: Polynomial = (0,)
    if virtual_mass:
        heavy = scaled(virtual_mass, product(product(rest, product(w, w)), to_the(late - 2)))
    X, E = product(place, stiff), product(place, heavy) if virtual_mass else heavy
    if not above:  # at rest under a constant force the velocity is 0, and so is its value at w = 0
        place, damped = (0, *seen(sampled.velocity)[1:]), to_the(late)
    Y = product(place, damped)
    A = product(_split(device), rest)
    M = np.asarray(whole) + late + bool(sampled.late.any())
    if coupling is None:
        return Loop(_joined(A), _joined(X), _joined(Y), _joined(E), M, long)
    between = total(scaled(coupling[0], stiff), scaled(coupling[1], damped))
    X, Y, E = product(between, X), product(between, Y), product(between, E) if virtual_mass else E
    ahead = tuple(_joined(product(A, q)) for q in (stiff, damped))
    A = product(A, total(between, heavy))
    return Loop(_joined(A), _joined(X), _joined(Y), _joined(E), M, ahead=ahead)


def _split(coefficients: Array) -> Polynomial:
    return tuple(np.moveaxis(coefficients, -1, 0))


def _joined(coefficients: Polynomial) -> Array:
    return np.stack(np.broadcast_arrays(*(np.asarray(c, dtype=float) for c in coefficients)), -1)

r"""The pieces of the explicit boundary that border the stable region.

A point of the boundary curve has a pair of roots on the unit circle; it borders the stable region
where all other roots lie inside, which the root count tells for every point on its own.  The
pieces end in corners: where another root reaches the circle, or where the curve ends.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric import arguments, stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.boundary import begin, end, point, tangent
from symhaptic.numeric.crossings import crossings, surplus, wall
from symhaptic.numeric.plant import Device, device, stuck

_PER_TURN = 96
"""Samples per half turn of z^(d+1)."""

_LONGEST = 1e5
"""Periods of delay whose pieces are traced."""

_CLOSEST = 1e-6, 1e-9
"""Samples crowd at 0, at pi and at the plant's own frequency down to the first distance; where the
latter two are next to each other down to a hundredth of theirs, but not below the second."""

_REMOTE = 1e20
"""Walls that move the device so far in a period are too large to be stable: see
:meth:`Loop._possible`."""

_ROUNDS = 6
"""Searches for short pieces next to the ends of those found before."""

_SECTIONS = 32
"""Parts into which an interval is cut at each step of the search for its corner."""

_TOUCHING = 1e-7
"""Ends closer than this over d + 1 are one: where a root touches the circle and stays inside,
rounding decides on either side within the square root of the unit roundoff."""


@dataclass(frozen=True)
class Loop:
    """A plant and a delay: everything but the wall; ``steps`` is whole, or real (principal)."""

    gamma: float
    delta: float
    delay: float
    sheet: str = "exact"

    def __post_init__(self) -> None:
        if self.delay > _LONGEST:
            raise ValueError(
                f"delay: {self.delay!r} is not allowed; give at most {_LONGEST:g} periods: the "
                "boundary has one piece for each period"
            )

    @cached_property
    def steps(self) -> float:
        """Whole periods of the delay, all of it on the principal sheet."""
        return self.delay if self.sheet == "principal" else float(np.floor(self.delay))

    @cached_property
    def device(self) -> Device:
        """The sampled plant, behind the fraction of the delay."""
        part = np.asarray(self.delay - self.steps)
        return device(np.asarray(self.gamma), np.asarray(self.delta), part)

    @property
    def whole(self) -> bool:
        """Whether no fraction of a period is left."""
        return self.delay == self.steps

    def curve(self, theta: Array) -> Array:
        """(alpha, beta) of the boundary, one row per angle."""
        walls = arguments.in_blocks(
            lambda angle: point(self.device, angle, np.asarray(self.steps)), theta
        )
        return np.moveaxis(walls, 0, -1)

    def tangent(self, theta: Array) -> Array:
        """Derivative of :meth:`curve` with respect to the angle."""
        return np.stack(tangent(self.device, theta, np.asarray(self.steps)), axis=-1)

    def others(self, theta: Array) -> Array:
        """How many roots are outside besides the pair at exp(+-j theta)."""
        return np.asarray(arguments.in_blocks(self._others, theta)[0])

    def _others(self, theta: Array) -> list[Array]:
        alpha, beta = point(self.device, theta, np.asarray(self.steps))
        found = stability.count(
            self.device,
            wall(alpha, beta),
            np.asarray(self.steps),
            self.whole,
            on_circle=theta,
        )
        return [found]

    def borders(self, theta: Array) -> NDArray[np.bool_]:
        """Whether the boundary's point borders the stable region."""
        alpha, beta = np.moveaxis(self.curve(theta), -1, 0)
        inside = (self.others(theta) == 0) & (alpha > -self.gamma)
        return np.asarray(inside & self._possible(alpha, beta))

    def _possible(self, alpha: Array, beta: Array) -> NDArray[np.bool_]:
        """Whether the wall is not too large, by the coefficients of its polynomial.

        Where all roots are in the unit circle, those of the last four powers are at most 1, n,
        n (n-1)/2 and n (n-1) (n-2)/6 for the degree n, and the device's are at most 1, 2 and 1.
        """
        if self.sheet == "principal":
            return np.ones(alpha.shape, dtype=bool)
        x, both = self.device, alpha + beta
        parts = x.m2 * both, x.m1 * both - x.m2 * beta, x.m0 * both - x.m1 * beta, x.m0 * beta
        largest = np.max(np.abs(parts), axis=0)
        return np.asarray(largest <= math.comb(int(self.steps) + 4, 3) + 2)

    @property
    def bent(self) -> float:
        """How far from pi a curve goes to infinity instead of ending, on the principal sheet.

        It follows the line of a root at -1 where pi - theta is less than pi times what the delay
        differs from a whole one.
        """
        return float(np.abs(self.steps - np.rint(self.steps)))

    # -- ends of the curve and the two lines ---------------------------------------------

    @cached_property
    def begin(self) -> Array:
        """Limit of the curve at theta = 0: a double root at 1."""
        return np.stack(begin(self.device, np.asarray(self.gamma), np.asarray(self.steps)))

    @cached_property
    def line(self) -> float | None:
        """alpha + 2 beta of the walls with a root at -1; None where none is of any account."""
        x = self.device
        if self.steps != np.floor(self.steps) or x.numerator_at_minus_one == 0:
            return None
        if np.abs(x.numerator_at_minus_one) * _REMOTE < x.at_minus_one * x.numerator_at_one:
            return None
        sign = -1.0 if self.steps % 2 else 1.0
        return sign * float(x.at_minus_one / x.numerator_at_minus_one)

    @cached_property
    def end(self) -> Array | None:
        """Limit of the curve at theta = pi: a double root at -1; None where it is at infinity."""
        return None if self.line is None else np.stack(end(self.device, np.asarray(self.steps)))

    def samples(self) -> Array:
        """Angles that meet every piece of the boundary worth drawing."""
        count = int(_PER_TURN * (self.delay + 2))
        own = abs(math.remainder(math.sqrt(max(self.gamma - self.delta**2 / 4, 0.0)), math.tau))
        closest, least = _CLOSEST
        away = np.geomspace(np.clip((math.pi - own) / 100, least, closest), np.pi, 256)
        angles = [np.linspace(0, np.pi, count + 1), away, np.pi - away, own + away, own - away]
        if self.bent:
            angles.append(np.pi - np.geomspace(self.bent / 100, np.pi, 256))
        every = np.unique(np.concatenate(angles))
        return every[(every > 0) & (every < np.pi)]

    @cached_property
    def arcs(self) -> list[tuple[float, float]]:
        """Intervals of theta on which the curve borders the stable region, rising; 0 and pi count.

        Where one ends, another begins, at the angle of the root that reached the circle or where
        the curve meets the line of a real root: short ones are looked for there.
        """
        if stuck(np.asarray(self.gamma), np.asarray(self.delta)):
            return []
        angles, ends = self.samples(), np.zeros(0)
        corners = np.concatenate([self.at_left, self.at_right])
        for _ in range(_ROUNDS):
            bordering = self.borders(angles)
            if np.count_nonzero(bordering[1:] != bordering[:-1]) == ends.size:
                break
            ends = flips(self.borders, angles, bordering)
            ends = _crossed(ends, _TOUCHING / (self.delay + 1))
            angles = _around(angles, np.concatenate([corners, self.partners(ends)]))
        inside = bool(bordering[0])
        marks = [0.0, *(float(end) for end in ends), float(np.pi)]
        return [
            (low, high)
            for i, (low, high) in enumerate(itertools.pairwise(marks))
            if (i % 2 == 0) == inside
        ]

    def partners(self, theta: Array) -> Array:
        """The other angles at which |f| = |g| for the boundary's walls: those of their corners."""
        v = wall(*point(self.device, theta, np.asarray(self.steps)))
        found = crossings(surplus(self.device, v), self.whole)
        angles = [2 * np.arctan2(np.sqrt(c.y), np.sqrt(c.rest))[c.there] for c in found]
        return np.concatenate([np.zeros(0), *angles])

    @cached_property
    def at_left(self) -> Array:
        """Angles at which the curve crosses the line of a root at 1."""
        return self.meets(lambda alpha, beta: alpha + self.gamma)

    @cached_property
    def at_right(self) -> Array:
        """Angles at which it crosses the line of a root at -1."""
        line = self.line
        if line is None:
            return np.zeros(0)
        return self.meets(lambda alpha, beta: alpha + 2 * beta - line)

    def meets(self, line: Callable[[Array, Array], Array]) -> Array:
        """Angles at which the curve crosses the line where ``line(alpha, beta)`` vanishes.

        Of a line that the curve begins on, those beside its begin.
        """

        def beyond(theta: Array) -> NDArray[np.bool_]:
            first = theta == 0
            walls = self.curve(np.where(first, 1.0, theta))
            walls = np.where(first[..., None], self.begin, walls)
            return line(walls[..., 0], walls[..., 1]) > 0

        angles = self.samples()
        if np.all(line(*self.begin) != 0):
            angles = np.concatenate([[0.0], angles])
        return flips(beyond, angles, beyond(angles))


def _crossed(ends: Array, near: float) -> Array:
    """One end of each odd number of close ones; an even number is a touch and no end."""
    groups = np.split(ends, np.flatnonzero(np.diff(ends) > near) + 1)
    return np.array([group[group.size // 2] for group in groups if group.size % 2])


def _around(angles: Array, corners: Array) -> Array:
    """The angles and many more next to some of them."""
    away = np.geomspace(1e-10, 0.1, 48)
    more = corners[:, None] + np.concatenate([away, -away])
    every = np.unique(np.concatenate([angles, more.ravel()]))
    return every[(every > 0) & (every < np.pi)]


def flips(
    test: Callable[[Array], NDArray[np.bool_]], angles: Array, found: NDArray[np.bool_]
) -> Array:
    """Where the test, ``found`` at the angles, changes between neighbours, to the last digit."""
    at = np.flatnonzero(found[1:] != found[:-1])
    low, high, first = angles[at], angles[at + 1], found[at]
    while at.size:
        parts = np.linspace(low, high, _SECTIONS + 1)  # one column per interval
        if np.all((parts[1:-1] == low) | (parts[1:-1] == high)):
            break
        changed = test(parts.ravel()).reshape(parts.shape) != first
        changed[-1] = True
        step = np.maximum(np.argmax(changed, axis=0), 1)
        columns = np.arange(at.size)
        low, high = parts[step - 1, columns], parts[step, columns]
    return np.asarray(high)

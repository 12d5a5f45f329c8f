"""Passive walls of a loop with any velocity: condition (4) of the paper, for integer delays.

A wall with the transfer function H is passive iff H(1) >= 0 and

    b > T/(2 (1 - cos theta)) Re{(1 - exp(-j theta)) exp(-j d theta) H(exp(j theta))}

at each angle; with H = K + B V(z)/T + M (1 - 1/z)^2/T^2 the right side is K p + B q + r.
"""

from __future__ import annotations

import numpy as np

from symhaptic.loops.circle import Array, Complex, grid, point, roots, value
from symhaptic.loops.loop import SHORT
from symhaptic.loops.velocity import Velocity


class Needs:
    """What walls need of a device's damping, in units of the mass and the period.

    The worst angle is searched on a grid that sees each turn of the delay and each resonance of the
    filter, and refined.  That is accurate, but no proof.  ``delay`` counts whole periods;
    ``virtual_mass`` is M/m.
    """

    def __init__(
        self, velocity: Velocity, delay: int, period: float, virtual_mass: float = 0.0
    ) -> None:
        self.velocity, self.delay, self.period = velocity, delay, period
        self.virtual_mass = virtual_mass
        poles: Complex = np.empty(0, dtype=complex)
        if velocity.over > SHORT:
            turns, bends = delay + velocity.over, np.ones(1)
        else:
            above, below, late = velocity.ratio(period)
            turns = delay + late + len(above) + len(below)
            bends = np.array(below, dtype=float)
            poles = roots(bends) if len(bends) > 1 else poles
            if (np.abs(poles + 1) > 1 + _ROUNDED).any():
                raise ValueError(
                    f"velocity: {velocity.words} is unstable with this sampling period; passivity "
                    "is not computed, give a stable filter"
                )
        uniform = np.linspace(0, np.pi, 32 * turns + 256)
        slowest = np.abs(poles).min(initial=1.0)
        angles = grid(uniform, 1e-9 * slowest / turns, bends)
        self.theta = np.concatenate([[0.0], angles])
        self.of_K, self.of_B, self.rest = self.at(self.theta)

    def at(self, theta: Array) -> tuple[Array, Array, Array]:
        """p, q and r at angles, 0 <= theta <= pi; at 0 their limits.

        With w^2/|w|^2 = -z nothing is divided that vanishes at 0, but for two sines.
        """
        half = theta / 2
        p = _sines(2 * self.delay + 1, half) / 2
        q = -(np.exp(-1j * self.delay * theta) * self._slope(theta)).real
        heavy = np.exp(-1j * (self.delay + 2) * theta) * point(theta, False)
        return p, q, -self.virtual_mass * heavy.real

    def _slope(self, theta: Array) -> Complex:
        """V(z)/(z - 1)."""
        n = self.velocity.over
        if n > SHORT:
            mean = _sines(n, theta / 2) / n
            return np.asarray(mean * np.exp(-1j * (n + 1) * theta / 2))
        above, below, late = self.velocity.ratio(self.period)
        w = point(theta, False)
        top, bottom = (value(np.array(x, dtype=float), w) for x in (above[1:], below))
        return np.asarray(top / bottom * np.exp(-1j * late * theta))

    def required(self, K: Array, B: Array) -> tuple[Array, Array]:
        """The largest damping that each wall needs at any angle, and that angle.

        The angle is NaN if ever slower motions need the most.  The damping is infinite for K < 0:
        such a wall pulls away.
        """
        K, B = np.broadcast_arrays(np.atleast_1d(K), np.atleast_1d(B))
        needs = K[:, None] * self.of_K + B[:, None] * self.of_B + self.rest
        edges = np.full((len(K), 1), -np.inf)
        beside = np.concatenate([edges, needs, edges], axis=1)
        peaks = np.where((needs >= beside[:, :-2]) & (needs >= beside[:, 2:]), needs, -np.inf)
        spread = needs.max(axis=1) - needs.min(axis=1)
        high_enough = peaks >= (needs.max(axis=1) - _CLOSE * spread)[:, None]
        tops = np.argsort(peaks, axis=1)[:, -max(1, int(high_enough.sum(axis=1).max(initial=0))) :]
        low = self.theta[np.maximum(tops - 1, 0)]
        high = self.theta[np.minimum(tops + 1, len(self.theta) - 1)]
        part = (np.sqrt(5) - 1) / 2
        for _ in range(50):
            one, two = high - part * (high - low), low + part * (high - low)
            left = self._need(K, B, one) > self._need(K, B, two)
            low, high = np.where(left, low, one), np.where(left, two, high)
        angles = np.concatenate([(low + high) / 2, self.theta[tops]], axis=1)
        found = self._need(K, B, angles)
        worst = np.argmax(found, axis=1)[:, None]
        need, theta = (np.take_along_axis(x, worst, axis=1)[:, 0] for x in (found, angles))
        theta = np.where(theta > 2 * self.theta[1], theta, np.nan)
        return np.where(K < 0, np.inf, need), theta

    def _need(self, K: Array, B: Array, theta: Array) -> Array:
        p, q, r = self.at(theta)
        return K[:, None] * p + B[:, None] * q + r

    def limits(self, B: Array, damping: float) -> tuple[Array, Array]:
        """The largest stiffness of a passive wall for each damping, and its worst angle.

        NaN where no wall of this damping is passive.  Each angle allows K up to a line; the worst
        angle of a wall at the least of those found so far gives the next line.
        """
        B = np.atleast_1d(np.asarray(B, dtype=float))
        with np.errstate(divide="ignore", invalid="ignore"):
            lines = (damping - B[:, None] * self.of_B - self.rest) / self.of_K
        K = np.maximum(np.where(self.of_K > 0, lines, np.inf).min(axis=1), 0.0)
        need, theta = self.required(K, B)
        for _ in range(60):
            p, q, r = self.at(np.where(np.isnan(theta), 0.0, theta))
            over = (need > damping) & (K > 0)
            if not over.any():
                break
            with np.errstate(divide="ignore", invalid="ignore"):
                lower = (damping - B * q - r) / p
            K = np.where(over, np.where(p > 0, np.clip(lower, 0.0, K * _LESS), 0.0), K)
            need, theta = self.required(K, B)
        return np.where(need <= damping, K, np.nan), theta

    def without_stiffness(self, damping: float) -> tuple[float, float]:
        """The least and the largest B of a passive wall with K = 0; NaN if there is none."""
        free = damping - self.rest
        if free.min() < 0:
            return (np.nan, np.nan)
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = free / self.of_B
        low, high = ends[self.of_B < 0].max(), ends[self.of_B > 0].min()
        inside = 1 - 1e-6  # the grid may lie beside the worst angle
        return float(low * inside), float(high * inside)

    def stiffest(self, damping: float) -> tuple[float, float, float]:
        """The largest stiffness of a passive wall, its damping and its worst angle.

        K over B is concave, because passive walls are an intersection of half planes.
        """
        low, high = self.without_stiffness(damping)
        if np.isnan(low):
            return (np.nan, np.nan, np.nan)
        for _ in range(16):
            B = np.linspace(low, high, 17)
            K, theta = self.limits(B, damping)
            top = int(np.nanargmax(K))
            low, high = B[max(top - 1, 0)], B[min(top + 1, 16)]
        if low <= 0 <= high:  # often the stiffest passive wall has no damping at all
            at_none, angle = self.limits(np.zeros(1), damping)
            if at_none[0] >= K[top] * (1 - 1e-12):
                return float(at_none[0]), 0.0, float(angle[0])
        return float(K[top]), float(B[top]), float(theta[top])


def _sines(times: int, angle: Array) -> Array:
    """sin(n x)/sin(x), n at 0."""
    with np.errstate(invalid="ignore"):
        return np.where(angle == 0, times, np.sin(times * angle) / np.sin(angle))


_ROUNDED = 1e-9
"""By so much a root on the unit circle is told wrongly."""

_CLOSE = 0.01
"""Peaks of the grid that are lower by less than this part of the spread are refined: with 32 angles
a turn, a peak between two of them is higher by half of a per cent at most."""

_LESS = 1 - 2.0**-52
"""By the last place at least K comes down, until its wall is passive."""

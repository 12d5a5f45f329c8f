"""The questions that may be asked of any loop, without units: alpha, beta and periods."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops import count
from symhaptic.loops.circle import Array, point, value, zeros
from symhaptic.loops.loop import Loop, closed
from symhaptic.loops.oversampled import Oversampled
from symhaptic.loops.passive import Needs
from symhaptic.loops.plant import (
    Plant,
    Sampled,
    explicit_euler,
    held,
    moving_mass,
    semi_implicit_euler,
)
from symhaptic.loops.structure import Coupling
from symhaptic.loops.trace import LONGEST, Trace, boundary
from symhaptic.loops.velocity import Measured, Velocity

STEPS = {
    "hold": held,
    "semi-implicit Euler": semi_implicit_euler,
    "explicit Euler": explicit_euler,
}
"""How the device moves from one sample to the next."""

SMALL, LARGE = 1e-9, 1e7
"""Sizes of parts in units of the mass and the period.  Outside this range, digits are lost."""

_BLOCK = 4096
"""So many walls are counted at a time: their arrays stay in the processor's cache."""

_TABLE = 2_000_000
"""So many numbers has a table of walls and angles: 16 MB."""


_Told = Callable[[Loop, Array, Array], NDArray[Any]]


class Part(Protocol):
    """What changes the device: an actuator before it, a mass behind it."""

    def before(self, plant: Plant, mass: float, period: float) -> Plant:
        """The plant with this part."""


@dataclass(frozen=True)
class Engine:
    """One loop of a device, its parts and its delay."""

    gamma: float
    delta: float
    delay: float
    """In sampling periods."""
    mass: float
    """In kg; parts have theirs in SI units."""
    period: float
    velocity: Velocity
    parts: tuple[Part, ...] = ()
    integrator: str = "hold"
    virtual_mass: float = 0.0
    """Of the wall, in kg."""
    coupling: Coupling | None = None

    @property
    def plant(self) -> Plant:
        """The device with its parts."""
        found = moving_mass(self.gamma, self.delta)
        for part in self.parts:
            found = part.before(found, self.mass, self.period)
        return found

    def at_delay(self, delay: Array | float) -> Loop:
        """The loop at one delay, or at each of an array of them."""
        for name, size in self.velocity.sizes(self.period).items():
            if size and not SMALL <= size <= LARGE:
                raise ValueError(
                    f"velocity: {self.velocity.words} with sampling_period={self.period!r} is not "
                    f"allowed for stability; give {name} from {SMALL:g} to {LARGE:g}"
                )
        whole = np.floor(delay)
        if isinstance(self.velocity, Oversampled):
            sampled: Sampled = self.velocity.sampled(self.plant, delay - whole, self.period)
        elif self.integrator == "hold":
            sampled = held(self.plant, delay - whole)
        elif np.any(delay != whole):
            raise ValueError(
                f"delay: {delay!r} periods do not fit integrator={self.integrator!r}; "
                "give a whole number of periods, because a simulator knows its steps only"
            )
        else:
            sampled = STEPS[self.integrator](self.plant)
        return closed(
            sampled,
            np.asarray(whole, dtype=np.int64),
            self.velocity,
            self.period,
            self.virtual_mass / self.mass,
            None if self.coupling is None else self.coupling.without_units(self.mass, self.period),
        )

    @cached_property
    def loop(self) -> Loop:
        """At the delay of the scene."""
        return self.at_delay(self.delay)

    @cached_property
    def trace(self) -> Trace:
        """The boundary of the stable walls, whose stiffness has a limit."""
        if self.unlimited:
            raise ValueError(
                f"coupling: {self.unlimited}, but a softer wall may be unstable; "
                "use is_stable or delay_margin"
            )
        return Trace(self.loop)

    @cached_property
    def unlimited(self) -> str:
        """The reason for no upper limit, if any: with a rigid wall the coupling is the wall."""
        if self.coupling is None:
            return ""
        rigid = replace(self, coupling=None, virtual_mass=0.0).loop
        K, B = map(np.asarray, self.coupling.without_units(self.mass, self.period))
        if not count.is_stable(rigid, K, B):
            return ""
        return "it is stable with a rigid wall, so the stiffness has no upper limit"

    @property
    def no_passivity(self) -> str:
        """Why condition (4) does not apply to this loop, or nothing."""
        simulated = self.integrator != "hold"
        for given, why in (
            (simulated, f"integrator={self.integrator!r}: a simulator is no device"),
            (bool(self.parts), "condition (4) needs a force that acts on the mass without a lag"),
            (
                isinstance(self.velocity, Oversampled),
                "velocity=Oversampled(): condition (4) needs one rate",
            ),
            (
                isinstance(self.velocity, Measured),
                "velocity=Measured(): condition (4) needs positions",
            ),
            (self.coupling is not None, "coupling: condition (4) needs a wall without a coupling"),
            (self.delay % 1, "delay: with a filter condition (4) needs an integer delay"),
        ):
            if given:
                return why
        return ""

    @cached_property
    def needs(self) -> Needs:
        """What walls need of the device's damping, where (4) tells it."""
        if self.no_passivity:
            raise ValueError(f"{self.no_passivity}; passivity is not computed, ask for stability")
        if self.delay > LONGEST:
            raise ValueError(
                f"delay: {self.delay!r} periods are too long for passivity with a filter or a "
                f"virtual mass; give at most {LONGEST} periods"
            )
        return Needs(
            self.velocity, math.floor(self.delay), self.period, self.virtual_mass / self.mass
        )

    def is_stable(self, alpha: Array, beta: Array) -> NDArray[np.bool_]:
        """Whether walls are stable; NaN is not."""
        return np.asarray(self._each(count.is_stable, alpha, beta, bool))

    def unstable_roots(self, alpha: Array, beta: Array) -> Array:
        """Roots outside the unit circle; NaN on the boundary."""
        return np.asarray(self._each(count.unstable_roots, alpha, beta, float))

    def _each(self, function: _Told, alpha: Array, beta: Array, kind: type) -> Array:
        alpha, beta = np.broadcast_arrays(np.asarray(alpha, float), np.asarray(beta, float))
        found: Array = np.zeros(alpha.size, dtype=kind)
        if kind is float:
            found[:] = np.nan
        known = np.flatnonzero(np.isfinite(alpha.ravel()) & np.isfinite(beta.ravel()))
        for start in range(0, len(known), _BLOCK):
            here = known[start : start + _BLOCK]
            found[here] = function(self.loop, alpha.ravel()[here], beta.ravel()[here])
        return found.reshape(alpha.shape)

    def passivity_margin(self, alpha: Array, beta: Array) -> Array:
        """The damping delta less what walls need; -inf for alpha < 0, NaN for NaN."""
        alpha, beta = np.broadcast_arrays(np.asarray(alpha, float), np.asarray(beta, float))
        K, B = alpha.ravel(), beta.ravel()
        found = np.full(K.shape, np.nan)
        known = np.flatnonzero(~np.isnan(K) & ~np.isnan(B))
        size = max(1, _TABLE // len(self.needs.theta))
        for start in range(0, len(known), size):
            here = known[start : start + size]
            found[here] = self.delta - self.needs.required(K[here], B[here])[0]
        return found.reshape(alpha.shape)

    def is_passive(self, alpha: Array, beta: Array) -> NDArray[np.bool_]:
        """Whether no motion of the device extracts energy."""
        return np.asarray(self.passivity_margin(alpha, beta) >= 0)

    def stable_delays(
        self, alpha: float, beta: float, first: float, last: float
    ) -> list[tuple[float, float]]:
        """The windows of the delay, in periods, in which a wall is stable.

        A root is on the circle where the phase between the two parts passes 0 at an angle of
        |A| = |W|.  In a cell of the delay that phase turns by less than half a radian.  Verdicts in
        the middle of all pieces tell which are stable; where two of them differ and no phase passes
        0, the end is between their middles.  Cells next to a small phase are divided, because
        the phase may pass 0 and return within one cell.
        """
        fastest = self._fastest(alpha, beta)
        cells = math.ceil((last - first) * min(8.0, 2 * fastest + 1.0))
        grid = self._with_births(alpha, beta, np.linspace(first, last, cells + 2))
        grid = self._with_small_phases(alpha, beta, grid)
        phase = self._phases(alpha, beta, grid)
        one, two = phase[:-1], phase[1:]
        with np.errstate(invalid="ignore"):
            there = (one * two <= 0) & (np.abs(one - two) < 2.0)
        rows, slots = np.nonzero(there)

        def at_slots(delays: Array) -> Array:
            phases = self._phases(alpha, beta, delays)
            more = max(0, phase.shape[-1] - phases.shape[-1])
            padded = np.pad(phases, ((0, 0), (0, more)), constant_values=np.nan)
            return np.asarray(padded[np.arange(len(slots)), slots])

        crossed = zeros(at_slots, grid[rows], grid[rows + 1])
        if crossed.size:  # next to a birth an angle may change its slot, and no zero is found
            crossed = crossed[np.abs(at_slots(crossed)) < _ZERO]
        ends = np.unique(np.concatenate([grid, crossed]))
        middles = (ends[1:] + ends[:-1]) / 2
        told = self._stable_at(alpha, beta, middles)
        untold = np.flatnonzero((told[1:] != told[:-1]) & ~np.isin(ends[1:-1], crossed))
        low, high = middles[untold], middles[untold + 1]
        for _ in range(_HALVES if len(untold) else 0):
            middle = (low + high) / 2
            same = self._stable_at(alpha, beta, middle) == told[untold]
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        ends[1:-1][untold] = (low + high) / 2
        found: list[tuple[float, float]] = []
        for start, end, stable in zip(ends[:-1], ends[1:], told, strict=True):
            if stable and found and found[-1][1] == start:
                found[-1] = (found[-1][0], float(end))
            elif stable:
                found.append((float(start), float(end)))
        return found

    def _with_births(self, alpha: float, beta: float, grid: Array) -> Array:
        """A grid of delays with those next to which angles of |A| = |W| come and go, by halving."""
        low, high, added = grid[:-1], grid[1:], [grid]
        count = np.isfinite(self._equal(alpha, beta, grid)[0]).sum(axis=1)
        at_low, at_high = count[:-1], count[1:]
        for _ in range(_HALVES // 2):
            there = at_low != at_high
            if not there.any():
                break
            low, high, at_low, at_high = low[there], high[there], at_low[there], at_high[there]
            middle = (low + high) / 2
            at = np.isfinite(self._equal(alpha, beta, middle)[0]).sum(axis=1)
            added.append(middle)
            low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
            at_low, at_high = np.concatenate([at_low, at]), np.concatenate([at, at_high])
        return np.unique(np.concatenate(added))

    def _with_small_phases(self, alpha: float, beta: float, grid: Array) -> Array:
        """Add delays to a grid in the cells in which a phase may pass 0."""
        phase = np.abs(self._phases(alpha, beta, grid))
        small = np.asarray((phase < _SMALL).any(axis=1))
        cells = np.flatnonzero(small[:-1] | small[1:])
        inner = grid[cells, None] + np.diff(grid)[cells, None] * _PARTS[3::4]
        return np.unique(np.concatenate([grid, inner.ravel()]))

    def _stable_at(self, alpha: float, beta: float, delays: Array) -> NDArray[np.bool_]:
        found = [
            count.is_stable(self.at_delay(part), np.array(alpha), np.array(beta))
            for part in np.array_split(delays, len(delays) // _BLOCK + 1)
        ]
        return np.concatenate(found)

    def _fastest(self, alpha: float, beta: float) -> float:
        """The largest angle of |A| = |W| at any part of a period; 0 if there is none."""
        angles = self._equal(alpha, beta, np.linspace(0, 1, 32, endpoint=False))[0]
        return float(np.nanmax(angles, initial=0.0))

    def _phases(self, alpha: float, beta: float, delays: Array) -> Array:
        """At each delay, the phase between both parts at each angle where they are equal."""
        return self._equal(alpha, beta, delays)[1]

    def _equal(
        self, alpha: Array | float, beta: Array | float, delays: Array
    ) -> tuple[Array, Array]:
        """The angles of |A| = |W| at each delay, and the phase between z^M A and -W there."""
        loop = self.at_delay(delays)
        alpha, beta, M = np.broadcast_arrays(alpha, beta, loop.M)
        A = loop.device(np.asarray(alpha), np.asarray(beta))
        A = np.broadcast_to(A, (*M.shape, A.shape[-1]))
        W = loop.wall(alpha, beta)
        theta = count.equal(A, W, loop.in_z)
        late = np.exp(1j * M[..., None] * theta) * value(A[..., None, :], point(theta, False))
        with np.errstate(invalid="ignore", divide="ignore"):
            return theta, np.angle(-late / value(W[..., None, :], point(theta, loop.in_z)))

    def stability_boundary(self, theta: Array) -> tuple[Array, Array]:
        """alpha and beta of the walls with which the loop swings at these angles."""
        return boundary(self.loop, np.asarray(theta, dtype=float))

    def max_delay(self, alpha: Array, beta: Array) -> Array:
        """The delays in periods up to which walls are stable; 0 for those that never are."""
        return self._until(alpha, beta, 0.0, 0.0)

    def delay_margin(self, alpha: Array, beta: Array) -> Array:
        """The delays in periods that may be added until walls are unstable."""
        return self._until(alpha, beta, self.delay, self.delay)

    def _until(self, alpha: Array, beta: Array, first: float, less: float) -> Array:
        alpha, beta = np.broadcast_arrays(np.asarray(alpha, float), np.asarray(beta, float))
        if self.integrator != "hold":
            raise ValueError(
                f"integrator: {self.integrator!r} has no delay margin, because a simulator knows "
                "its steps only; give integrator='hold'"
            )
        found = np.full(alpha.shape, np.nan)
        for place in np.argwhere(np.isfinite(alpha) & np.isfinite(beta)):
            at = tuple(place)
            found[at] = self._stable_until(float(alpha[at]), float(beta[at]), first) - less
        return found

    def most_delay(self, alpha: Array, beta: Array) -> Array:
        """Delay margins of many walls in periods, or more than these.

        Verdicts at some delays miss that a wall is unstable between two of them only.
        """
        K, B = alpha.ravel(), beta.ravel()
        found = np.where(self.is_stable(K, B), np.nan, 0.0)
        start, width = 0.0, 4.0
        while start < LONGEST and np.isnan(found).any():
            left = np.flatnonzero(np.isnan(found))
            for some in np.array_split(left, left.size * len(_PARTS) // _BLOCK + 1):
                found[some] = self._first_unstable(K[some, None], B[some, None], start, width)
            left = np.flatnonzero(np.isnan(found))
            if start == 0 and left.size:
                angles = self._equal(K[left, None], B[left, None], _PARTS)[0]
                found[left[np.isnan(angles).all(axis=(1, 2))]] = np.inf
            start, width = start + width, 2 * width
        return found.reshape(alpha.shape)

    def _first_unstable(self, K: Array, B: Array, start: float, width: float) -> Array:
        """Where the first of sixteen parts ends at which each wall is unstable, refined; or NaN."""
        low = np.full(len(K), start)
        for turn in range(_TURNS):
            loop = self.at_delay(self.delay + low[:, None] + width * _PARTS)
            stable = count.is_stable(loop, K, B)
            if turn == 0:
                never = stable.all(axis=1)
            width /= len(_PARTS)
            low += width * np.argmin(stable, axis=1)
        return np.where(never, np.nan, low)

    def _stable_until(self, alpha: float, beta: float, first: float) -> float:
        """The end of the window of delays that begins at ``first``, which is there if it is empty.

        Infinite if no angle has |A| = |W| at any part of a period, because nothing can change.
        """
        if not self._stable_at(alpha, beta, np.array([first]))[0]:
            return first
        if self._fastest(alpha, beta) == 0:
            return math.inf
        width, start = 4.0, first
        while start < LONGEST:
            windows = self.stable_delays(alpha, beta, start, start + width)
            if not windows or windows[0][0] > start:
                return start
            if windows[0][1] < start + width:
                return windows[0][1]
            start, width = start + width, 2 * width
        return math.nan


_SMALL = 0.5
"""A phase turns by less than this in a cell, in rad."""

_ZERO = 1e-6
"""A phase below this, in rad, counts as a zero."""

_PARTS = np.arange(1, 17) / 16
"""Ends of sixteen parts of a window of delays."""

_TURNS = 9
"""Times that a window is parted: to 6e-11 of 4 periods."""

_HALVES = 45
"""Halvings of a cell of the delay: to 1e-14 of a period."""

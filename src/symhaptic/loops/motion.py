"""The motion of a device under held forces, exact at any time, with Coulomb friction.

z = (state, force of the wall, force from outside, friction) follows d/dt z = A z as long as the
forces are held.  Friction is held, too, while the device slides one way; it changes where the
velocity passes 0, which is the first root of a power series.  Powers are quadratic forms of z, and
so are their integrals.  Time is in sampling periods, and the mass of the device is 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from math import comb
from typing import NamedTuple

import numpy as np

from symhaptic.loops.circle import Array
from symhaptic.loops.plant import Plant, arrays, grown

POWERS = "wall", "outside", "damper", "friction"
"""Powers of the forces of the wall and from outside, and losses of damper and friction."""

_DEGREE = 18
"""Of the power series of a velocity; for |A^2| t^2 <= 1/4 its remainder is below 6e-22."""


class Handle(NamedTuple):
    """The second mass with its spring and its damper, in units of the first and the period."""

    mass: float
    stiffness: float
    damping: float


class Forms:
    """Quadratic forms of z: the energy of a device, and the powers that change it."""

    def __init__(
        self, plant: Plant, gamma: float, delta: float, handle: Handle | None, lagging: bool
    ) -> None:
        """``lagging`` is whether the force of the wall is a state, the last one."""
        size = len(plant.state)
        one = np.eye(size + 3)
        x, v = one[0], one[1]
        force = one[size - 1 if lagging else size]
        outside, friction = one[size + 1], one[size + 2]
        pushed = v if handle is None else one[3]
        damper = delta * np.outer(v, v)
        self.energy = np.outer(v, v) / 2 + gamma * np.outer(x, x) / 2
        if handle is not None:
            between, sliding = x - one[2], v - one[3]
            damper += handle.damping * np.outer(sliding, sliding)
            self.energy += handle.stiffness * np.outer(between, between) / 2
            self.energy += handle.mass * np.outer(pushed, pushed) / 2
        self.powers = np.stack(
            [_symmetric(force, v), _symmetric(outside, pushed), damper, -_symmetric(friction, v)]
        )
        self.force = force


def _symmetric(one: Array, other: Array) -> Array:
    return (np.outer(one, other) + np.outer(other, one)) / 2


class Leg(NamedTuple):
    """An interval of held forces: z+ = step z, and the energies z' work z."""

    step: Array
    work: Array


class Motion:
    """How z moves; ``stuck`` where friction holds the motor."""

    def __init__(self, plant: Plant, forms: Forms, outside: Array) -> None:
        """``outside`` is how a force from outside enters the first states."""
        state, force, _, _ = arrays(plant)
        size = len(state)
        self.free = np.zeros((size + 3, size + 3))
        self.free[:size, :size] = state
        self.free[:size, size] = force[:, 0]
        self.free[: len(outside), size + 1] = outside
        self.free[1, size + 2] = 1.0
        self.stuck = self.free.copy()
        self.stuck[:2] = 0.0
        self.forms = forms
        self.pull = self.free[1].copy()
        """The force on the motor without friction."""
        self.pull[1] = self.pull[size + 2] = 0.0
        self.legs = cache(self.leg)

    def leg(self, time: float, stuck: bool) -> Leg:
        """An interval of held forces, in which the motor moves or is stuck."""
        matrix = self.stuck if stuck else self.free
        return Leg(np.eye(len(matrix)) + grown(matrix * time)[0], self._work(matrix, time))

    def _work(self, matrix: Array, time: float) -> Array:
        """The integrals of exp(A t)' Q exp(A t) for each power Q.

        The power series of Lyapunov's operator for a short time, doubled.
        """
        size = np.abs(matrix).sum(axis=-1).max() * time
        halvings = max(0, int(np.ceil(np.log2(size))) + 2) if size > 0 else 0
        short = time / 2.0**halvings
        term = found = self.forms.powers * short
        for n in range(2, _DEGREE + 2):
            term = (matrix.T @ term + term @ matrix) * (short / n)
            found = found + term
        for doubled in range(halvings):
            step = np.eye(len(matrix)) + grown(matrix * (short * 2.0**doubled))[0]
            found = found + step.T @ found @ step
        return found

    @property
    def longest(self) -> float:
        """The longest interval for which the power series are exact to rounding error."""
        states = (A[:-3, :-3] for A in (self.free, self.stuck))
        size = max(np.abs(A @ A).sum(axis=-1).max() for A in states)
        return float(0.5 / np.sqrt(size)) if size > 0 else np.inf


class Friction:
    """Stick and slip of the motor under Coulomb friction."""

    def __init__(self, motion: Motion, friction: float) -> None:
        self.motion, self.friction = motion, friction
        self.last = len(motion.free) - 1
        speed = _series(motion.free, np.eye(len(motion.free))[1])
        self.series = {
            _SLIDING: speed[:-1],
            _STARTING: speed[1:],  # over the time: the root at the start is not the next one
            _STUCK: _series(motion.stuck, motion.pull)[:-1],
        }
        self.on_legs = cache(self.on_leg)

    def on_leg(self, kind: str, time: float) -> Array:
        """Bernstein's coefficients of a speed or a pull over a time, as a matrix times z."""
        return np.asarray(_TO_BERNSTEIN @ (self.series[kind] * time ** _POWERS[:, None]))

    def advance(self, z: Array, time: float) -> tuple[Array, bool, Array | None, Array]:
        """Move through an interval of held forces.

        Returns z at its start, whether the motor is stuck there, the energies if the motor stops or
        breaks away within the interval, else nothing, and z at its end.
        """
        start, stuck = z, self._begin(z, 0.0)
        at, ahead = self._event(z, self.on_legs, time, stuck)
        if at == time:
            return start, stuck, None, self.motion.legs(time, stuck).step @ z
        work, left = np.zeros(len(POWERS)), time
        z = z.copy()
        while True:
            leg = self.motion.leg(at, stuck)
            work += z @ leg.work @ z
            z = leg.step @ z
            left -= at
            if left <= 0:
                return start, stuck, work, z
            if not stuck:
                z[1] = 0.0
            stuck = self._begin(z, ahead)
            at, ahead = self._event(z, self.on_leg, left, stuck)

    def _begin(self, z: Array, ahead: float) -> bool:
        """Set the friction in z, and return whether it holds the motor.

        ``ahead`` is the direction in which the motor breaks away, or 0.
        """
        sense = float(z[1]) or ahead
        if not sense:
            sense = float(self.motion.pull @ z)
            if abs(sense) <= self.friction * (1 + _SLACK):
                z[self.last] = 0.0
                return True
        z[self.last] = -math.copysign(self.friction, sense)
        return False

    def _event(
        self, z: Array, on: Callable[[str, float], Array], left: float, stuck: bool
    ) -> tuple[float, float]:
        """The time until the motor stops or breaks away, at most ``left``, and its direction."""
        if not stuck:
            return _first_root(on(_SLIDING if z[1] else _STARTING, left) @ z, left), 0.0
        pull, most = on(_STUCK, left) @ z, self.friction * (1 + _SLACK)
        if np.abs(pull).max() < most:
            return left, 0.0
        found = [(_first_root(most - sense * pull, left), sense) for sense in (1.0, -1.0)]
        at, ahead = min(found)
        return (at, ahead) if at < left else (left, 0.0)


_SLIDING, _STARTING, _STUCK = "sliding", "starting", "stuck"

_SLACK = 1e-12
"""Relative excess over the friction at which the motor breaks away: rounding is smaller."""

_SHORTEST = 1e-12
"""Least time between two events, in sampling periods."""


def _series(matrix: Array, row: Array) -> Array:
    """row exp(A t) z as a power series: its coefficients are this matrix times z."""
    rows = [row]
    for n in range(1, _DEGREE + 2):
        rows.append(rows[-1] @ matrix / n)
    return np.array(rows)


_TO_BERNSTEIN = np.array(
    [
        [comb(i, k) / comb(_DEGREE, k) if k <= i else 0.0 for k in range(_DEGREE + 1)]
        for i in range(_DEGREE + 1)
    ]
)
_LEFT = np.array([[comb(i, j) / 2.0**i for j in range(_DEGREE + 1)] for i in range(_DEGREE + 1)])
_RIGHT = _LEFT[::-1, ::-1]
"""De Casteljau's halves."""
_POWERS = np.arange(_DEGREE + 1)


def _first_root(coefficients: Array, left: float) -> float:
    """The first root in (0, left] of a polynomial by its coefficients of Bernstein's, or ``left``.

    Where all of them have one sign there is none.
    """
    parts = [(0.0, 1.0, coefficients)]
    while parts:
        start, width, b = parts.pop()
        if not b.min() <= 0 <= b.max():  # nor of NaN
            continue
        if width <= 2.0**-52:
            at = max(left * (start + width / 2), _SHORTEST)
            return at if at < left else left
        half = width / 2
        parts += [(start + half, half, _RIGHT @ b), (start, half, _LEFT @ b)]
    return left


def cuts(times: set[float], longest: float) -> list[tuple[float, float]]:
    """The legs of a period as starts and lengths: cut at ``times`` and none longer than allowed."""
    found = []
    for start, end in pairwise(sorted({0.0, 1.0, *times})):
        pieces = max(1, int(np.ceil((end - start) / longest)))
        ends = np.linspace(start, end, pieces + 1)
        found += [(float(one), float(two - one)) for one, two in pairwise(ends)]
    return found

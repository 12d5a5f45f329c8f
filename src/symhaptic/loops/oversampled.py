"""Two rates: the position is read and filtered several times a period, the wall computed once.

The filter becomes a part of the device: its memory stands beside the state, and the velocity is
read from it.  For the wall this is a measured velocity.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symhaptic.loops.circle import Array
from symhaptic.loops.controller import recursion
from symhaptic.loops.plant import Plant, Sampled, held
from symhaptic.loops.velocity import Measured, Velocity
from symhaptic.notation.quantities import shown

_MEMORY = 8
"""Numbers that a filter may keep: with more the roots of the loop lose their digits."""

_MOST = 64
"""Readings a period."""


@dataclass(frozen=True)
class Oversampled(Measured):
    """Velocity from a sensor that is sampled at an integer multiple of the rate of the wall.

    Parameters
    ----------
    velocity : Velocity
        What is computed at each reading; ``LowPass``, ``Average``, ``Window``, ``Filter`` or
        ``Difference``.  Its sampling period is that of the readings.
    times : int
        Readings a sampling period of the wall, from 2 to 64.

    Raises
    ------
    ValueError
        If a value is out of its range, or the filter keeps more than 8 numbers.

    Examples
    --------
    >>> from symhaptic.loops.velocity import LowPass
    >>> Oversampled(LowPass(cutoff=200), times=4).words
    'difference filtered by a low-pass of first order, 200 Hz, backward Euler, 4 readings a period'
    """

    velocity: Velocity
    times: int

    def __post_init__(self) -> None:
        if not isinstance(self.velocity, Velocity) or isinstance(self.velocity, Measured):
            raise ValueError(
                f"velocity: {shown(self.velocity)} is not allowed; give a filter or Difference()"
            )
        whole = isinstance(self.times, int) and not isinstance(self.times, bool)
        if not whole or not 2 <= self.times <= _MOST:
            raise ValueError(
                f"times: {shown(self.times)} is not allowed; give a whole number from 2 to {_MOST}"
            )
        above, below = recursion(self.velocity, 1.0)
        if len(above) + len(below) > _MEMORY:
            raise ValueError(
                f"velocity: {self.velocity!r} keeps too many numbers for times; give a filter that "
                f"keeps at most {_MEMORY}"
            )

    def sizes(self, period: float) -> dict[str, float]:
        """Those of the filter, for the period of the readings."""
        return self.velocity.sizes(period / self.times)

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"{self.velocity.words}, {self.times} readings a period"

    def sampled(self, plant: Plant, fraction: Array | float, period: float) -> Sampled:
        """The device with the filter's memory, once a period of the wall.

        Each force is delayed by ``fraction`` of a period, from 0 up to 1.
        """
        late = np.asarray(fraction, dtype=float) * self.times
        first = np.floor(late)
        scaled = ([x / self.times for x in row] for row in (*plant.state, plant.force))
        *state, force = map(tuple, scaled)
        faster = Plant(tuple(state), force, plant.position, plant.velocity, plant.free)
        part, full = held(faster, late - first), held(faster)
        above, below = recursion(self.velocity, period / self.times)

        def beside(motion: Array) -> Array:
            """Rows of the memory under rows of the device: new differences, new velocities."""
            new = full.position @ motion
            zero = np.zeros_like(new)
            rows = [new if n == 0 else zero for n in range(len(above) - 1)]
            rows += [above[0] * new if n == 0 else zero for n in range(max(len(below), 1))]
            return np.concatenate([motion, np.stack(rows, axis=-2)], axis=-2)

        size, kept, past = len(plant.state), len(above) - 1, max(len(below), 1)
        step = np.zeros((size + kept + past,) * 2)
        step[:, :size] = beside(full.step)
        speed = step[size + kept]
        speed[size : size + kept] = above[1:]
        speed[size + kept : size + kept + len(below)] = [-c for c in below]
        for start, length in ((size, kept), (size + kept, past)):
            step[range(start + 1, start + length), range(start, start + length - 1)] = 1.0
        step[size:, size:] -= np.eye(kept + past)
        whole, early, rest = (beside(c) for c in (full.early, part.early, part.late))
        new = old = np.zeros_like(early + rest)
        total = np.zeros_like(step)
        for n in range(self.times):
            at = (n - first)[..., None, None]
            new = new + step @ new + np.where(at > 0, whole, np.where(at < 0, 0.0, early))
            old = old + step @ old + np.where(at > 0, 0.0, np.where(at < 0, whole, rest))
            total = total + step + step @ total
        place, reading = np.zeros(len(step)), np.zeros(len(step))
        place[:size] = plant.position
        reading[size + kept] = self.times
        return Sampled(total, new, old, place, reading, plant.free)

"""The law of a wall as a controller computes it: from one sample to the command for the next."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise
from operator import mul

from symhaptic.loops.number import Polynomial, product, total
from symhaptic.loops.velocity import Measured, Velocity


@dataclass(frozen=True)
class Wall:
    """A wall at 0 without units; its force is -(alpha x + beta v + M (1 - 1/z)^2 x)."""

    alpha: float
    beta: float
    virtual_mass: float = 0.0
    unilateral: bool = False
    """Whether it is at x > 0 alone and only pushes."""
    saturation: float | None = None
    """The largest command."""
    resolution: float | None = None
    """One step of the encoder, to whose multiples the position is rounded."""

    def measured(self, position: float) -> float:
        """What the encoder reports."""
        if self.resolution is None:
            return position
        return self.resolution * round(position / self.resolution)

    def answer(self, position: float, velocity: float, change: float) -> float:
        """The command at a sample; ``change`` is that of the velocity, for the virtual mass."""
        force = -(self.alpha * position + self.beta * velocity + self.virtual_mass * change)
        if self.unilateral:
            force = min(force, 0.0) if position > 0 else 0.0
        if self.saturation is not None:
            force = min(max(force, -self.saturation), self.saturation)
        return force


def controller(
    wall: Wall, velocity: Velocity, period: float, start: tuple[float, float]
) -> Callable[[float, float], tuple[float, float]]:
    """From position and velocity at a sample to the measured position and the command.

    Before the first sample the device moved from afar with the position and the velocity of
    ``start``, so that the filter of the velocity is in steady state.
    """
    above, below = recursion(velocity, period)
    place, speed = start
    before = [wall.measured(place - n * speed) for n in range(1, len(above) + 2)]
    differences = deque((new - old for new, old in pairwise(before)), len(above))
    velocities = deque([speed] * len(below), len(below))
    last = before[0]
    direct = isinstance(velocity, Measured)

    def sampled(position: float, moving: float) -> tuple[float, float]:
        nonlocal last
        seen = wall.measured(position)
        new = seen - last
        change, last = new - differences[0], seen
        differences.appendleft(new)
        if direct:
            return seen, wall.answer(seen, moving, change)
        filtered = sum(map(mul, above, differences)) - sum(map(mul, below, velocities))
        velocities.appendleft(filtered)
        return seen, wall.answer(seen, filtered, change)

    return sampled


def recursion(velocity: Velocity, period: float) -> tuple[list[float], list[float]]:
    """Coefficients a, b of v_k = sum a_j d_(k-j) - sum b_j v_(k-1-j), d the differences.

    >>> from symhaptic.loops.velocity import Average, LowPass
    >>> recursion(LowPass(weight=0.25), 0.001), recursion(Average(2), 0.001)
    (([0.25], [-0.75]), ([0.5, 0.5], []))
    """
    if isinstance(velocity, Measured):
        return [1.0], []
    if velocity.over:  # a mean of many has no digits left in powers of w
        return [1 / velocity.over] * velocity.over, []
    numerator, denominator, late = velocity.ratio(period)
    # V = (1 - 1/z) F, and 1 - 1/z = w/z
    above, below = (_in_z(q)[::-1] for q in (numerator[1:], denominator))
    waits = late + len(below) - 1 - len(above)
    lead = below[0]
    return [0.0] * waits + [c / lead for c in above], [c / lead for c in below[1:]]


def _in_z(polynomial: Polynomial) -> Polynomial:
    """A polynomial in w = z - 1, in powers of z."""
    *others, last = polynomial
    return reduce(
        lambda found, each: total(product(found, (-1, 1)), (each,)), others[::-1], (last,)
    )

"""Loops behind any delay: root counts behind it, and with which whole periods roots leave."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.notation import sizes
from symhaptic.numeric import stability
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.crossings import Wall, crossings, surplus
from symhaptic.numeric.plant import Device, behind
from symhaptic.numeric.tracing.periods import Window


class Loops(NamedTuple):
    """Walls and plants."""

    v: Wall
    gamma: Array
    delta: Array
    x: Device
    """The plant without delay."""

    def take(self, at: NDArray[np.intp]) -> Loops:
        """Some of them."""
        wall, plant = Wall(*(a[at] for a in self.v)), Device(*(a[at] for a in self.x))
        return Loops(wall, self.gamma[at], self.delta[at], plant)

    def behind(self, part: Array) -> Device:
        """The plant behind a fraction of a period."""
        return behind(self.x, self.gamma, self.delta, part)

    def stable(self, steps: Array, part: Array) -> NDArray[np.bool_]:
        """Whether no root is outside behind ``steps`` and a fraction of a period.

        By the kernel of all delays where the sum is one float64, as it is where parts are cut, and
        the kernel is certain; else by the count that rounds to one of both sides.
        """
        late = steps + part
        one = (late - steps == part) & (late <= sizes.LONGEST)
        roots = np.array(
            stability.unstable_roots(
                self.v.alpha, self.v.beta, self.gamma, self.delta, np.where(one, late, 0.0)
            )
        )
        left = np.flatnonzero(~one | (roots < 0))
        if left.size:
            some, over = self.take(left), part[left] == 1
            x = some.behind(np.where(over, 0.0, part[left]))
            roots[left] = stability.count(x, some.v, steps[left] + over, False)
        return np.asarray(roots == 0)

    def can_leave(self, part: Array) -> NDArray[np.bool_]:
        """Whether roots can leave at all behind a fraction 0 < part <= 1."""
        x = self.behind(part)
        leave = leads_at_minus_one(x, self.v)
        for c in crossings(surplus(x, self.v), False):
            leave |= c.there & c.rises
        return leave

    def many(self, steps: Array, part: Array) -> NDArray[np.bool_]:
        """Whether no root is outside, each loop behind a fraction 0 < part <= 1 of a period.

        ``steps`` has the whole periods before it, many of each loop in a row of its own.
        """
        x, v, whole = self._in_rows(part)
        return np.asarray(stability.count(x, v, steps + whole, False) == 0)

    def leaving(self, steps: Array, part: Array, count: int) -> tuple[Array, Array]:
        """The next whole periods with which a root may have left behind a fraction 0 <= part <= 1.

        In rows, infinite at the end; and those up to which these are all.  Between them roots come
        back only.
        """
        x, v, whole = self._in_rows(part)
        late = steps[:, None] + whole
        later = np.arange(float(count))
        ahead = [np.floor(change) + 1 for change in next_changes(x, v, late, later)]
        leads = leads_at_minus_one(x, v)
        ahead.append(np.where(leads, late + later + 1, np.inf))
        last = np.minimum.reduce([a[:, -1:] for a in ahead])
        together = np.sort(np.concatenate(ahead, axis=1), axis=1)
        return np.where(together <= last, together, np.inf) - whole, (last - whole)[:, 0]

    def window(self) -> tuple[NDArray[np.bool_], Window]:
        """Where the wall leads between two angles alone, and those with their phases.

        Behind whole periods roots are outside as often as a half turn is between the phases.
        """
        fall, rise = crossings(surplus(self.x, self.v), True)
        known = fall.there & rise.there & ~leads_at_minus_one(self.x, self.v)
        angles = (stability.theta(fall), stability.theta(rise))
        bare = (stability.phase(self.x, self.v, c) for c in (rise, fall))
        return known, Window(*(a.halves * np.pi + a.rest for a in (*angles, *bare)))

    def _in_rows(self, part: Array) -> tuple[Device, Wall, Array]:
        """The plants behind a fraction 0 < part <= 1 of a period, and the walls; and the whole
        periods more that are in it."""
        whole = part == 1
        x = self.behind(np.where(whole, 0.0, part))
        columns = Device(*(a[:, None] for a in x)), Wall(*(a[:, None] for a in self.v))
        return *columns, np.where(whole, 1.0, 0.0)[:, None]


def next_changes(x: Device, v: Wall, steps: Array, later: Array) -> list[Array]:
    """Of each crossing, the real number of periods at which its pair of roots leaves the circle.

    For whole delays: the next time, or so many times ``later``; infinite where none leaves.
    """
    found = []
    for crossing in crossings(surplus(x, v), True):
        bare, late = stability.phase(x, v, crossing), stability.theta(crossing)
        odd = 2 * (stability.turns(bare, late, steps) - later) - 1
        theta = late.halves * np.pi + late.rest
        at = ((bare.halves - odd) * np.pi + bare.rest) / theta - 2
        found.append(np.where(crossing.there & crossing.rises, at, np.inf))
    return found


def leads_at_minus_one(x: Device, v: Wall) -> NDArray[np.bool_]:
    """Whether the wall is stronger than the plant there: a root is outside every other period."""
    return np.asarray(np.abs(x.numerator_at_minus_one * v.at_minus_one) > x.at_minus_one)

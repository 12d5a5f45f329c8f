"""Which way the roots in a band of angles cross the unit circle while the delay grows."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric.arguments import Array
from symhaptic.numeric.tracing.bands import ROUNDING, Bands


def one_way(b: Bands, steps: Array) -> tuple[Array, Array]:
    """1 or -1 where every root of the band crosses outward or inward with the delay, else 0.

    And the number of periods up to which that holds.  A root z moves with the fraction by
    d ln z = -h/Z, where h is the logarithmic derivative of M by the fraction and Z that of g/f by
    ln z; boxes around both decide the sign of the real part.  A period more takes 1 from Z: it
    adds Re h to what decides, and the error of Re h to what it has to exceed.
    """
    p, x, v = b.part, b.part.x, b.v
    sine, cosine = np.sqrt(b.y * b.rest) / 2, (b.rest - b.y) / 4
    sums, gaps, reach, away = x.m2 + x.m0, x.gap, b.reach, b.away
    late = (x.numerator_at_one * b.rest - x.numerator_at_minus_one * b.y) / 4
    push = (v.alpha * b.rest - v.at_minus_one * b.y) / 4
    total = 1 + x.e
    plant = _box(-total * b.off / 2, x.loss * sine, total * away, x.loss * reach)
    turned = _box(x.loss * cosine, total * sine, x.loss * away, total * reach)
    wall = _box(push, v.slope * sine, v.slope * away, v.slope * reach)
    round_ = _box(v.slope * cosine, v.slope * sine, v.slope * away, v.slope * reach)
    low, high = b.top / 2, b.sine
    force = _box(late, gaps * sine, np.abs(sums) * away + low * p.sum_change,
                 np.abs(gaps) * reach + high * p.gap_change)  # fmt: skip
    shape = _box(gaps * cosine, sums * sine, np.abs(gaps) * away + p.gap_change,
                 np.abs(sums) * reach + high * p.sum_change)  # fmt: skip
    rise = _box(-p.sum_slope * b.y / 2, p.gap_slope * sine,
                np.abs(p.sum_slope) * away + low * p.sum_turn,
                np.abs(p.gap_slope) * reach + high * p.gap_turn)  # fmt: skip
    parts = shape / force, round_ / wall, turned / plant
    moved = parts[0].center + parts[1].center - parts[2].center - (steps + 2)
    along, across = (sum(errors) for errors in zip(*(part[1:] for part in parts), strict=True))
    h = rise / force
    real = -(h.center * np.conj(moved)).real
    with np.errstate(invalid="ignore"):  # a box without end decides nothing: NaN
        off = np.abs(h.center.real) * along + np.abs(h.center.imag) * across
        off += h.along * (np.abs(moved.real) + along) + h.across * (np.abs(moved.imag) + across)
        off *= 1 + ROUNDING
    way = np.where(np.abs(real) > off, np.sign(real), 0.0)
    lost = h.along * (1 + ROUNDING) - way * h.center.real
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        more = np.where(lost > 0, (np.abs(real) - off) / lost, np.inf)
    return way, np.where(way == 0, steps, steps + np.floor(more))


class _Box(NamedTuple):
    """Complex numbers that differ from ``center`` by at most so much."""

    center: NDArray[Any]
    along: Array
    """In the real part."""
    across: Array
    """In the imaginary part."""

    def __truediv__(self, other: _Box) -> _Box:
        size = np.abs(other.center)
        off = np.hypot(other.along, other.across)
        sure = size > off
        unit, size = np.where(sure, other.center / np.where(sure, size, 1.0), 1.0), size - off
        quotient = self.center / np.where(sure, other.center, 1.0)
        real, up = np.abs(quotient.real), np.abs(quotient.imag)
        # (a + da)/(b + db) - a/b = (da - a/b db)/b (1 - db/(b + db))
        x = self.along + real * other.along + up * other.across
        y = self.across + real * other.across + up * other.along
        turned = np.abs(unit.real), np.abs(unit.imag)
        more, room = np.hypot(x, y) * off, np.where(sure, size, 1.0)
        whole = size + off
        errors = (
            np.where(sure, (part + more / room) / np.where(sure, whole, 1.0), np.inf)
            for part in (x * turned[0] + y * turned[1], y * turned[0] + x * turned[1])
        )
        return _Box(quotient, *errors)


def _box(real: Array, up: Array, along: Array, across: Array) -> _Box:
    return _Box(real + 1j * up, np.abs(along), np.abs(across))

"""A limit of stiffness, with all that it needs: a number, or arrays for many dampings."""

from __future__ import annotations

from typing import Any, NamedTuple


class Limit(NamedTuple):
    """A wall on the border of stability, in SI units; numbers, or arrays of them."""

    K: Any
    """Virtual stiffness in N/m, or N m/rad of a rotary device."""
    B: Any
    """Virtual damping in Ns/m, or N m s/rad."""
    frequency_hz: Any
    """The frequency in Hz at which the loop begins to swing there."""


class Stiffness(float):
    """A stiffness with the damping that it needs: ``K``, ``B`` and ``frequency_hz``."""

    B: float
    """Virtual damping in Ns/m, or N m s/rad of a rotary device."""
    frequency_hz: float
    """The frequency in Hz at which this wall is just at its limit."""

    def __new__(cls, K: float, B: float, frequency_hz: float) -> Stiffness:
        """A number with two more beside it."""
        self = super().__new__(cls, K)
        self.B, self.frequency_hz = B, frequency_hz
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return Stiffness, (self.K, self.B, self.frequency_hz)

    @property
    def K(self) -> float:
        """The stiffness in N/m or N m/rad."""
        return float(self)


def one_or_many(limit: Limit) -> Stiffness | Limit:
    """One limit as a number; many as they are."""
    return Stiffness(*limit) if isinstance(limit.K, float) else limit

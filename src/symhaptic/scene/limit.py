"""A limit of stiffness, with all that it needs."""

from __future__ import annotations

from typing import Any, NamedTuple


class Limit(NamedTuple):
    """A wall on the border of stability, in SI units; numbers, or arrays of them."""

    K: Any
    """Virtual stiffness in N/m."""
    B: Any
    """Virtual damping in Ns/m."""
    frequency_hz: Any
    """The frequency in Hz at which the loop begins to swing there."""

"""What can be checked: arguments in their order and ranges, exact values, and where to look."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Exact = Callable[..., tuple[Any, ...]]
Range = tuple[float, float, tuple[float, ...]]
"""The least and the largest value of an argument, and hard values."""


FLAT = 1e8
"""A number of this size has a unit in the last place of half of the digits of one of size 1."""


@dataclass(frozen=True)
class Checked:
    """A function with one ball for each result, or truth values, or None where it is not told.

    ``near`` gives nearly the same on arrays, fast: it tells where to look, and decides nothing.
    ``scale`` is the size that an error is measured by where a result is smaller, as by
    cancellation; it takes numbers and arrays.
    """

    id: str
    ranges: dict[str, Range]
    results: tuple[str, ...]
    exact: Exact
    near: Exact | None
    scale: Exact | None = None
    whole: tuple[str, ...] = ()
    """Arguments that are whole numbers."""
    balls: int = 2000
    """Points at which exact values are asked for."""
    printed: str = ""
    """The statement of the paper that prints it."""
    flat: tuple[str, ...] = ()
    """Results that count as numbers of ``FLAT``: where a maximum is, its height hardly tells."""


B: Range = (0.0, 50.0, (1e-300, 1e-8))
PERIOD: Range = (1e-4, 1e-2, (1e-3,))
DELAY: Range = (0.0, 8.0, (1.0,))
FEW: Range = (0.0, 3.0, (1.0,))
"""A delay for what takes a polynomial."""

FRACTION: Range = (0.0, 0.99, (0.5,))
"""A part of a period."""

GAMMA: Range = (0.0, 9.8, (1e-300, 1e-16, 1e-8, 1.0, 2.25))
DELTA: Range = (0.0, 4.0, (1e-300, 1e-16, 1e-8, 2.0, 3.0))
"""With critical damping at (1, 2) and (2.25, 3)."""

SPRING: Range = (0.0, 1.0, (1e-8, 0.0625))
DAMPER: Range = (0.0, 1.0, (1e-8, 0.5))
STIFFNESS: Range = (-0.5, 3.0, (0.0, 1e-8))
DAMPING: Range = (-0.5, 2.0, (0.0, 1e-8))
ANGLE: Range = (1e-6, 3.14, (1.0,))
FREQUENCY: Range = (1.0, 300.0, ())
"""Below the Nyquist frequency of the longest period."""

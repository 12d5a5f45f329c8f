"""What can be checked: ranges of arguments, exact values, and the unit of an error."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import flint
import numpy as np
from flint import arb

Exact = Callable[..., tuple[Any, ...]]
Point = tuple[float, ...]


@dataclass(frozen=True)
class Argument:
    """The range of an argument."""

    low: float
    high: float
    """Of ordinary values."""
    least: float
    most: float
    """Sizes on a logarithmic scale."""
    special: tuple[float, ...] = (0.0,)
    signed: bool = False
    whole: bool = False
    top: float = math.inf
    """The largest value that there is."""

    def allows(self, value: float) -> bool:
        """Whether the argument may have this value."""
        whole = not self.whole or value == math.floor(value)
        positive = value > 0 or (value == 0 and self.low == 0)
        return (self.signed or positive) and value <= self.top and whole


@dataclass(frozen=True, eq=False)
class Checked:
    """A function with exact values of its results: balls, truth values or whole numbers.

    A result that is None or NaN has no exact value, and the point is not used for it.
    """

    id: str
    arguments: Mapping[str, Argument]
    results: tuple[str, ...]
    exact: Exact
    near: Exact | None
    """A fast approximation on arrays: it selects points, and decides nothing."""
    scale: Exact | None = None
    """The size of the terms that cancel in each result, by which an error is measured."""
    balls: int = 1000
    """Points at which exact values are computed."""
    precisions: int = 5
    """Working precisions that are tried for an exact value."""
    printed: str = ""
    """The statement of the paper that prints it."""
    flat: tuple[str, ...] = ()
    """Results that count as numbers of ``FLAT``: a maximum hardly depends on where it is."""
    border: Callable[..., list[Point]] | None = None
    """Points on both sides of a boundary: arguments, a relative distance and a random generator."""
    derived: Callable[[dict[str, Any]], dict[str, Any]] = dict
    """Arguments of what is drawn, such as a frequency of an angle."""
    refused: Callable[..., bool] = lambda *point: False
    """Points at which NaN is no error."""
    refutes: Callable[[Point, Sequence[float]], str] | None = None
    """What refutes results at a point without exact values; empty where nothing does."""
    no_answer: float | None = None
    """The result that stands for "not known".  It is accepted at hard points."""
    hard: Callable[..., bool] = lambda *point: True
    """Which points are hard; ordinary ones never are."""
    open: tuple[str, ...] = ()
    """What no point covers, as text."""
    nearest: float = 0.0
    """The smallest relative distance from a boundary at which there are exact values."""
    variants: tuple[tuple[str, Exact], ...] = ()
    """Simpler models whose values somebody may have computed, with what they leave out."""


FLAT = 1e8
"""A number of this size has a unit in the last place of half of the digits of one of size 1."""

_BITS = (192, 384, 768, 1536, 3072)
_KNOWN, _ROUGH = 2.0**-80, 1e-5
"""Radius of an exact value as a share of its size: that is sought, and that is used at all."""


@lru_cache(maxsize=100_000)
def exact(checked: Checked, point: Point) -> tuple[tuple[Any, ...], tuple[float, ...]]:
    """Exact results, as precise as it takes, and the sizes that their errors are measured by."""
    with np.errstate(all="ignore"):
        scale = checked.scale(*point) if checked.scale else (0.0,) * len(checked.results)
    sizes = tuple(map(float, scale))
    found: tuple[Any, ...] = ()
    for bits in _BITS[: checked.precisions]:
        with flint.ctx.workprec(bits):
            try:
                found = checked.exact(*point)
            except ArithmeticError:
                found = (None,) * len(checked.results)
                continue
            if all(_is_known(v, size, _KNOWN) for v, size in zip(found, sizes, strict=True)):
                break
    pairs = zip(found, sizes, strict=True)
    return tuple(v if _is_known(v, size, _ROUGH) else None for v, size in pairs), sizes


def _is_known(value: Any, size: float, share: float) -> bool:
    """Whether the radius of a ball is at most a share of its size."""
    if not isinstance(value, arb) or not value.is_finite():
        return True
    return bool(value.rad() <= share * max(abs(float(value.mid())), size, 1e-300))


def shown(right: Any) -> str:
    """An exact value in 25 digits; ``None`` where there is none."""
    return str(right) if isinstance(right, int | None) else str(right.str(25, radius=False))

"""Where a boundary reaches farthest."""

from __future__ import annotations

from typing import NamedTuple

from symhaptic.numeric.arguments import Array


class Extremum(NamedTuple):
    """The wall that reaches farthest, and the angle theta = omega T at which it does so."""

    alpha: Array
    beta: Array
    theta: Array

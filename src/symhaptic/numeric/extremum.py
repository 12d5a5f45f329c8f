"""Where a boundary reaches farthest."""

from __future__ import annotations

from typing import NamedTuple

from symhaptic.numeric.arguments import Array


class Extremum(NamedTuple):
    """An extreme wall (alpha, beta) of a boundary, and its angle theta = omega T."""

    alpha: Array
    beta: Array
    theta: Array

    def __repr__(self) -> str:
        """Numbers as numbers, ``alpha=0.098``, not as arrays without axes."""
        shown = (
            f"{name}={value}" if getattr(value, "ndim", None) == 0 else f"{name}={value!r}"
            for name, value in self._asdict().items()
        )
        return f"Extremum({', '.join(shown)})"

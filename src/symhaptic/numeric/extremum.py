"""Where a boundary reaches farthest."""

from __future__ import annotations

from typing import NamedTuple

from symhaptic.numeric.arguments import Array


class Extremum(NamedTuple):
    """An extreme wall of a boundary, which unpacks into three numbers or arrays.

    ``alpha`` is the stiffness K T^2/m, ``beta`` the damping B T/m, and ``theta`` the angle omega T:
    that of the critical roots on the unit circle, or of the worst motion.
    """

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

"""What is in the loop, and so which symbols exist at all.

A part that a scene leaves out is not set to zero: the model is derived without it.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from itertools import product


@dataclass(frozen=True)
class Parts:
    """The parts of the loop beside the mass and the virtual spring, which are always there.

    >>> Parts(delay=False).name
    'stiffness, damping, virtual damping'
    """

    stiffness: bool = True
    """Physical stiffness k (dimensionless gamma)."""
    damping: bool = True
    """Physical damping b (dimensionless delta)."""
    virtual_damping: bool = True
    """Damping B of the wall (dimensionless beta)."""
    delay: bool = True
    """A delay of d sampling periods."""

    @property
    def name(self) -> str:
        """The parts that are there, in words."""
        present = [f.name.replace("_", " ") for f in fields(self) if getattr(self, f.name)]
        return ", ".join(present) or "mass and virtual spring only"

    def without(self, part: str) -> Parts:
        """The same loop with one part left out."""
        kept = {f.name: getattr(self, f.name) for f in fields(self)} | {part: False}
        return Parts(**kept)

    def present(self) -> list[str]:
        """Names of the parts that are there and could be left out."""
        return [f.name for f in fields(self) if getattr(self, f.name)]


FULL = Parts()

ALL = tuple(Parts(*choice) for choice in product((True, False), repeat=4))
"""All sixteen scenes, the full one first."""

"""The parts of a loop: which of them a scene has, and so which symbols exist at all.

A part that a scene leaves out is not set to zero: the model is derived without it.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from itertools import product

from symhaptic.notation.suggest import suggested


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


def left(words: str) -> Parts:
    """The loop that is left without what words say, such as ``"no-stiffness,no-delay"``.

    Raises :class:`ValueError` for a word that names no part.

    >>> left("no-stiffness,no-delay").name
    'damping, virtual damping'
    """
    parts = FULL
    allowed = [f"no-{part.replace('_', '-')}" for part in FULL.present()]
    for word in filter(None, (w.strip() for w in words.split(","))):
        if word == "no-mass":
            raise ValueError("no-mass: a loop without a mass has no motion to sample")
        if word not in allowed:
            raise ValueError(f"{word}: is not known; {suggested(word, allowed)}")
        parts = parts.without(word.removeprefix("no-").replace("-", "_"))
    return parts


ALL = tuple(Parts(*choice) for choice in product((True, False), repeat=4))
"""All sixteen scenes, the full one first."""

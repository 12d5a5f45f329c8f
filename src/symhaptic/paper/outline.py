"""How the paper is built, as far as its text refers to itself: sections and panels."""

from __future__ import annotations

from dataclasses import dataclass

SECTIONS = (
    "Introduction",
    "System Description",
    "Passivity",
    "Stability",
    "Comparison between Passivity and Stability",
    "Conclusion",
)
"""Titles of Sections I to VI."""


@dataclass(frozen=True)
class Panel:
    """One plot of Fig. 12: what its caption names, and what the text says of its delays."""

    name: str
    quantity: str
    springs: tuple[str, ...]
    """Values of gamma, where the caption names them."""
    delays_named: bool
    """Whether the caption says for which delays it is drawn."""
    scale: int = 1
    """Which scale of the delay it has: the text says that (b) and (c) have two."""


FIGURE_12 = (
    Panel("a", "stiffness", (), False),
    Panel("b", "ratio", ("0", "0.001"), False),
    Panel("c", "ratio", ("0", "0.001"), False, scale=2),
)
"""The text calls (b) and (c) plots of the ratio for two different scales of the delay."""

CAPTION = ("quantity", "springs", "delays_named")
"""What the caption of a panel of Fig. 12 names."""

CONCLUSION_NAMED = 4
"""The section that Sec. I names for the conclusions."""

RATIO_NAMED = ("a", "c")
"""The panels of Fig. 12 of which Sec. V-B says that they show the ratio."""

NAME_OF_B = "virtual stiffness"
"""What Sec. IV-D calls B."""

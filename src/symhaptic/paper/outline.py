"""How the paper is built, as far as its text refers to itself: sections and panels."""

from __future__ import annotations

import re
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

SENTENCES = {
    "s1-conclusion": "Finally, Section IV summarizes the main results and draws important "
    "conclusions for designing stable haptic systems.",
    "s5b-ratio-panels": "The lower two plots [Fig. 12(a) and (c)] illustrate the relation eta of "
    "the maximum passive to the maximum stable virtual stiffness for two different scales of the "
    "delay factor d.",
    "s4d-bound-of-b": "This bound for the virtual stiffness B (as non-normalized parameter) "
    "depends linearly on the mass m and the sampling rate 1/T.",
}
"""The sentences in which the paper names a section, panels and B; letters for its symbols."""

ROMAN = ("I", "II", "III", "IV", "V", "VI")
"""How the sections are numbered."""


def conclusion_named() -> int:
    """The section that Sec. I names for the conclusions.

    >>> conclusion_named()
    4
    """
    return ROMAN.index(_found("s1-conclusion", r"Section ([IVX]+) ")[0]) + 1


def ratio_named() -> tuple[str, ...]:
    """The panels of Fig. 12 of which Sec. V-B says that they show the ratio.

    >>> ratio_named()
    ('a', 'c')
    """
    return tuple(re.findall(r"\((.)\)", _found("s5b-ratio-panels", r"\[Fig\. 12(.*?)\]")[0]))


def name_of_b() -> str:
    """What Sec. IV-D calls B.

    >>> name_of_b()
    'virtual stiffness'
    """
    return _found("s4d-bound-of-b", r"bound for the (.*?) B ")[0]


def _found(id: str, pattern: str) -> list[str]:
    """What stands in a sentence in the place of the group."""
    return re.findall(pattern, SENTENCES[id])

"""Numbers as published: those of Table II, of Sec. IV-C beside it, and of the figures."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Arm:
    """One row of Table II; the numbers are the printed decimals."""

    authors: str
    """As the table writes them."""
    reference: int
    """Number of the article in the paper's list."""
    mass: str
    """m_H in kg."""
    stiffness: str
    """k_H in N/m."""
    damping: str
    """b_H in Ns/m."""
    with_device: bool = False
    """Footnote: the article considers arm and device together."""


TABLE_II = (
    Arm("Daniel et al.", 21, "1", "39.5", "12.6", with_device=True),
    Arm("Hogan", 17, "0.8", "568", "5.5"),
    Arm("Kazerooni et al.", 22, "4.54", "12.5", "6.83"),
    Arm("Kosuge et al.", 23, "1.95", "55", "2.46"),
    Arm("Kuchenbecker et al.", 24, "0.15", "1000", "7.5"),
    Arm("Lakatos et al.", 25, "2.79", "345", "33.8"),
    Arm("Lawrence", 26, "17.51", "175.1", "175.1"),
    Arm("Lawrence and Chapel", 27, "0.5", "40", "6"),
    Arm("Lee et al.", 28, "0.15", "7", "0.5"),
    Arm("Tsuji et al.", 29, "1.8", "199.1", "26.2"),
    Arm("Yokokohji et al.", 30, "2.0", "10.0", "2.0"),
)

EXCLUDED = "Kuchenbecker et al."
"""The row that (21) leaves out: the arm was strapped down, only the hand measured."""

DEVICE_RATIO = "0.625"
"""Bound of b_D/m_D in 1/s for the devices of the paper's reference [8]."""

DELAYS = ("0", "0.25", "0.5", "1", "2", "4", "8")
"""Delay factors of Figs. 4 and 11."""

"""The sources of statements, the paper first; the one place to add another."""

from __future__ import annotations

from symhaptic import paper, rules
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.statement import Source, Statement
from symhaptic.rules import claims as _claims  # noqa: F401  registered in CLAIMED

PAPER = Source(
    "",
    "Passivity and Stability Boundaries for Haptic Systems with Time Delay",
    "T. Hulin, A. Albu-Schäffer, G. Hirzinger",
    "2014",
    "IEEE Transactions on Control Systems Technology",
)
SOURCES = (PAPER, rules.SOURCE)

STATEMENTS: dict[str, Statement] = {**paper.STATEMENTS, **rules.STATEMENTS}
"""Of all sources, in their order."""


def source_of(id: str) -> Source | None:
    """The source of a statement; None of one that a chapter states itself."""
    if id not in STATEMENTS:
        return None
    key = id.partition(":")[0] if ":" in id else ""
    return next(source for source in SOURCES if source.key == key)


__all__ = ["CLAIMED", "PAPER", "SOURCES", "STATEMENTS", "source_of"]

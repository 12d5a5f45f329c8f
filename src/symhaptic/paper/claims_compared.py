"""What the abstract, Sec. V and Sec. VI state on passivity beside stability."""

from __future__ import annotations

from symhaptic.paper.statement import Statement

CLAIMS_COMPARED = (
    Statement(
        "one-delta",
        "Sec. V-A",
        r"the passive walls of a held device are those of (5) with the same $\delta$ as its "
        "stable walls",
        quote=r"For given $\delta$ and $d$, these boundaries can be plotted in the same $(\alpha, "
        r"\beta)$-plane as the stability boundaries.",
    ),
)

"""The plots: which curves each one shows, for which parameters."""

from __future__ import annotations

from symhaptic.paper.statement import Statement

DELAYS = ("0", "0.25", "0.5", "1", "2", "4", "8")
"""Delay factors of Figs. 4 and 11, as printed."""

FIGURES = (
    Statement(
        "fig4", "Fig. 4", "passivity boundaries in the plane of $TK/b$ and $B/b$, seven delays"
    ),
    Statement("fig5", "Fig. 5", "largest passive stiffness over the delay factor"),
    Statement("fig6", "Fig. 6", "arm parameters of Table II, normalised by the mass"),
    Statement("fig7", "Fig. 7", r"stability boundary for $d=0$ at the limits of the range"),
    Statement("fig8", "Fig. 8", "close-up of Fig. 7 around the origin"),
    Statement("fig9", "Fig. 9", r"stability boundaries for $d=1$ and $d=2$"),
    Statement("fig10", "Fig. 10", "exact and linear stability condition with error marks"),
    Statement("fig11", "Fig. 11", "passivity and stability boundaries in one plane"),
    Statement("fig12", "Fig. 12", "largest passive and stable stiffness and their ratio"),
    Statement("fig13", "Fig. 13", "stability boundaries up to the Nyquist frequency"),
)

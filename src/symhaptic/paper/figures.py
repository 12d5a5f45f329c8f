"""The plots: which curves each one shows, for which parameters."""

from __future__ import annotations

from symhaptic.paper.statement import Statement

DELAYS = ("0", "0.25", "0.5", "1", "2", "4", "8")
"""Delay factors of Figs. 4 and 11, as published."""

FIGURES = (
    Statement(
        "fig4",
        "Fig. 4",
        "passivity boundaries in the plane of $TK/b$ and $B/b$, seven delays",
        quote="Passivity boundaries of a haptic device rendering a virtual wall for different "
        r"delay factors $d \in \{0, 0.25, 0.5, 1, 2, 4, 8\}$.",
    ),
    Statement(
        "fig5",
        "Fig. 5",
        "largest passive stiffness over the delay factor",
        quote=r"Influence of the delay factor $d$ on the maximum passive stiffness $K_{\max}$ in "
        "the normalized representation of Fig. 4.",
    ),
    Statement(
        "fig6",
        "Fig. 6",
        "the ten arms of Table II that (21) counts lie in the range (23) at 1 ms, the excluded one "
        "outside, with 6.6 times the stiffness and 2.5 times the damping of its ends",
        quote="Parameter values of the human arm of Table II normalized by the mass $m_H$. The "
        "parameter range considered in this paper for the stability analysis is extended by"
        r" 30\%.",
    ),
    Statement(
        "fig7",
        "Fig. 7",
        r"stability boundary for $d=0$ at the limits of the range",
        quote=r"Exact stability boundary in the $(\alpha, \beta)$-plane for $d = 0$ and for the "
        r"limits of the parameter range $\gamma \in [0, 0.001]$ and $\delta \in [0, 0.02]$. "
        r"The effect of $\gamma$ on the stability boundary is not visible in this scale.",
    ),
    Statement(
        "fig8",
        "Fig. 8",
        "close-up of Fig. 7 around the origin",
        quote=r"Physical stiffness $\gamma$ is shifting the left boundary to $\alpha = -\gamma$ "
        "and not visibly influencing the bottom boundary.",
    ),
    Statement(
        "fig9",
        "Fig. 9",
        r"stability boundaries for $d=1$ and $d=2$",
        quote=r"Stability boundary in the $(\alpha, \beta)$-plane for (left) $d = 1$ and (right) "
        r"$d = 2$ for the limits of the parameter range $\gamma \in [0, 0.001]$ and $\delta "
        r"\in [0, 0.02]$.",
    ),
    Statement(
        "fig10",
        "Fig. 10",
        "exact and linear stability condition with error marks",
        quote="Comparison of the linear stability condition (dashed lines) to the exact stability"
        r" boundaries (solid lines), for $\gamma = 0.001$, $\delta \in \{0, 0.005, 0.01, "
        r"0.015, 0.02\}$, and $d = 0$ (top), respectively $d = 1$ (bottom). The relative "
        r"error of the linear condition is marked in three levels, 0\% (circles), 2\% "
        r"(triangles), and 5\% (squares).",
    ),
    Statement(
        "fig11",
        "Fig. 11",
        "passivity and stability boundaries in one plane",
        quote="Passivity boundaries (dashed green curves) and the stability boundaries (solid red"
        r" curves) for $\gamma = 0.001$ and $\delta = 0.02$ in the same $(\alpha, "
        r"\beta)$-plane for different delay factors $d \in \{0, 0.25, 0.5, 1, 2, 4, 8\}$. "
        "The passive regions are inside the stable regions for a given delay.",
    ),
    Statement(
        "fig12",
        "Fig. 12",
        "largest passive and stable stiffness and their ratio",
        quote=r"Maximum virtual stiffness $\alpha$ for passivity and stability, and their ratio "
        r"$\eta$.",
    ),
    Statement(
        "fig13",
        "Fig. 13",
        "stability boundaries up to the Nyquist frequency",
        quote=r"Stability boundaries $\delta = 0.02$ and for parameter values of $\gamma$ such "
        r"that the system is reaching Nyquist frequency (left plots; $0 \leq \gamma \leq "
        r"\pi^2 + \delta^2/4$). Close-up views are shown in the center and right plots for "
        r"$\delta = 0.02$ and $\delta = 0$, respectively. The passive region is part of the "
        "robust stable region.",
    ),
)

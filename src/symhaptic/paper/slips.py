"""Slips of the text: a wrong word, reference or sign, where the rest shows what is meant."""

from __future__ import annotations

from symhaptic.paper.statement import Statement

SLIPS = (
    Statement(
        "s1-conclusion",
        "Sec. I",
        "Section IV draws the conclusions",
        quote="Finally, Section IV summarizes the main results and draws important conclusions "
        "for designing stable haptic systems.",
    ),
    Statement(
        "s1-et-al",
        "Sec. I",
        "an article by two authors is given as by one author and others",
        quote="Therefore, Hannaford, et al. [3] introduced a more accurate approach with their "
        "time-domain passivity",
    ),
    Statement(
        "s4c-et-al",
        "Table II",
        "three articles by two authors are given as by one author and others",
        quote="Daniel et al. [21] [...] Lee et al. [28] [...] Yokokohji et al. [30]",
    ),
    Statement(
        "s4d-bound-of-b",
        "Sec. IV-D",
        "$B$ is called the virtual stiffness",
        quote="This bound for the virtual stiffness $B$ (as non-normalized parameter) depends "
        "linearly on the mass $m$ and the sampling rate $1/T$.",
    ),
    Statement(
        "s5b-ratio-panels",
        "Sec. V-B",
        r"Fig. 12(a) and (c) show the ratio $\eta$",
        quote=r"The lower two plots [Fig. 12(a) and (c)] illustrate the relation $\eta$ of the "
        "maximum passive to the maximum stable virtual stiffness for two different scales "
        "of the delay factor $d$.",
    ),
    Statement(
        "s5b-captions-alike",
        "Fig. 12",
        "(b) and (c) have the same caption; the delays that tell them apart are not named",
        quote=r"(b) Relation of maximum virtual stiffness for passivity and stability for $\gamma "
        r"= 0$ (solid lines) and $\gamma = 0.001$ (dashed lines). (c) Relation of maximum "
        r"virtual stiffness for passivity and stability for $\gamma = 0$ (solid lines) and "
        r"$\gamma = 0.001$ (dashed lines).",
    ),
    Statement(
        "s5c-interval",
        "Sec. V-C",
        r"$\gamma\le[\pi^2,\pi^2+0.0001]$",
        quote=r"results $\gamma \leq [\pi^2, \pi^2 + 0.0001]$ as limit for the physical stiffness",
    ),
)

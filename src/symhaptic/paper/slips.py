"""Slips of the text: a wrong word, reference or sign, where the rest shows what is meant."""

from __future__ import annotations

from symhaptic.paper.statement import Statement

SLIPS = (
    Statement("s1-conclusion", "Sec. I", "Section IV draws the conclusions"),
    Statement("s2c-positive-delay", "Sec. II-C", r"the delay is positive, $t_d\ge0$"),
    Statement(
        "s4c-et-al",
        "Table II",
        "three articles by two authors are given as by one author and others",
    ),
    Statement("s4d-bound-of-b", "Sec. IV-D", "$B$ is called the virtual stiffness"),
    Statement("s5b-ratio-panels", "Sec. V-B", r"Fig. 12(a) and (c) show the ratio $\eta$"),
    Statement(
        "s5b-captions-alike",
        "Fig. 12",
        "(b) and (c) have the same caption; the delays that tell them apart are not named",
    ),
    Statement("s5c-interval", "Sec. V-C", r"$\gamma\le[\pi^2,\pi^2+0.0001]$"),
    Statement("s5c-nyquist-spring", "Sec. V-C", r"the Nyquist frequency is $\gamma=\pi^2$"),
)

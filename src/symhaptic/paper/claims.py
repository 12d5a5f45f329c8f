"""What the text states between the equations, with the formula where it prints one."""

from __future__ import annotations

from symhaptic.paper.quoted import Quoted
from symhaptic.paper.statement import Statement

_II_C, _III_A, _III_B, _III_C = "Sec. II-C", "Sec. III-A", "Sec. III-B", "Sec. III-C"
_IV_A, _IV_B, _IV_C, _IV_D, _IV_E = (f"Sec. IV-{part}" for part in "ABCDE")
_V_A, _V_B, _V_C, _VI = "Sec. V-A", "Sec. V-B", "Sec. V-C", "Sec. VI"

CLAIMS = (
    Statement(
        "s2c-delays-lump",
        _II_C,
        "delays in the loop add up without changing the characteristic polynomial",
    ),
    Statement(
        "s2c-rational-delay",
        _II_C,
        "a rational delay reduces to a whole one by substituting $z$",
    ),
    Statement(
        "s2d-arm-in-force",
        "Sec. II-D",
        "without a model of the arm, its mass, damper and spring are part of $F_E$",
    ),
    Statement(
        "s3-interconnection",
        "Sec. III",
        "any interconnection of passive systems is passive and therefore stable",
    ),
    Statement(
        "s3-unilateral", "Sec. III", "condition (4) also holds for walls that only push, not pull"
    ),
    Statement("s3a-mass-free", _III_A, "condition (5) does not depend on the mass"),
    Statement(
        "s3a-undelayed",
        _III_A,
        "the form for $d=0$, and (6) as its summary",
        (r"b > KT/2 - B \cos(\omega T)",),
        r"d = 0",
    ),
    Statement(
        "s3b-linear-in-T",
        _III_B,
        "by (7) the boundary is linear in $b$, and its stiffness also in the sampling period $T$",
    ),
    Statement(
        "s3c-limit-points",
        _III_C,
        "the boundaries end at $(0,b)$ and $(0,-b)$ for every delay",
        (
            r"\begin{pmatrix} K \\ B \end{pmatrix} = \begin{pmatrix} 0 \\ b \end{pmatrix}",
            r"\begin{pmatrix} K \\ B \end{pmatrix} = \begin{pmatrix} 0 \\ -b \end{pmatrix}",
        ),
    ),
    Statement(
        "s3c-bmax-frequency",
        _III_C,
        "frequency of the largest passive damping, and (5) there",
        (r"\omega = \pi/T(d+1)", r"b > KT/2 + B"),
    ),
    Statement(
        "s3c-lower-part",
        _III_C,
        r"the lower part of the boundary is linear, and is the limit of (7) for $\omega\to0$",
    ),
    Statement(
        "s3c-kmax-frequency",
        _III_C,
        "at the largest stiffness the coefficient of $B$ in (5) vanishes, at this frequency",
        (r"\omega = \pi/2T(d+1)",),
    ),
    Statement(
        "s3c-kmax-41",
        _III_C,
        r"at $d=1$ the largest passive stiffness is about 41\% of that at $d=0$",
        quoted=(Quoted("about", "0.41"),),
    ),
    Statement(
        "s3c-kmax-27",
        _III_C,
        r"at $d=2$ the largest passive stiffness is below 27\% of that at $d=0$",
        quoted=(Quoted("below", "0.27"),),
    ),
    Statement(
        "s4a-delay-equivalent",
        _IV_A,
        "discrete equivalent of the delay",
        (r"e^{-dT_s} \hat{=} z^{-d}",),
    ),
    Statement(
        "s4a-exact-instants",
        _IV_A,
        "with (12) and $z^{-d}$ the system behaves exactly as before at the sampling instants",
    ),
    Statement(
        "s4b-five-parameters",
        _IV_B,
        r"$p(z)$ depends on $\alpha,\beta,\gamma,\delta,d$ only",
    ),
    Statement(
        "s4b-seven-to-five",
        _IV_B,
        "the substitution turns seven parameters into five",
    ),
    Statement(
        "s4c-independent-limits",
        _IV_C,
        r"limits for arm and device, each on its own, limit $\gamma$ and $\delta$",
    ),
    Statement("s4c-outlier", _IV_C, "the ratios of Kuchenbecker et al. are far above all others"),
    Statement(
        "s4c-series", _IV_C, "joints in series make the arm softer than each joint is on its own"
    ),
    Statement(
        "s4c-device-damping",
        _IV_C,
        r"for the devices listed in [8], $b_D/m_D$ is below $0.625\,\mathrm{s}^{-1}$",
    ),
    Statement(
        "s4c-extension-30",
        _IV_C,
        r"the ranges (23) extend (22) by roughly 30\%, in the caption of Fig. 6 by 30\%",
    ),
    Statement(
        "s4c-wider-delta",
        _IV_C,
        r"the range of $\delta$ is wider than in [10], mainly by the values of Tsuji et al.",
    ),
    Statement("s4d-degree", _IV_D, "$p(z)$ has degree $d+3$"),
    Statement(
        "s4d-explicit-only-undelayed",
        _IV_D,
        r"an explicit boundary exists for $d=0$, $\gamma=0$ only",
    ),
    Statement(
        "s4d-left-bound",
        _IV_D,
        r"the stable region has the vertical left bound $\alpha=-\gamma$",
        (r"\alpha = -\gamma",),
    ),
    Statement(
        "s4d-quadratic-in-period",
        _IV_D,
        "twice the sampling frequency gives four times the stable stiffness",
    ),
    Statement(
        "s4d-damping-bound",
        _IV_D,
        "the upper bound of $B$ is linear in $m$ and $1/T$",
    ),
    Statement(
        "s4d-delta-grows",
        _IV_D,
        r"$\delta$ enlarges the stable region in every direction but the left",
    ),
    Statement(
        "s4d-gamma-invisible", _IV_D, r"within its range $\gamma$ hardly moves the curve at $d=0$"
    ),
    Statement(
        "s4d-all-stabilising",
        _IV_D,
        "mass, spring and damper of the operator all stabilise",
    ),
    Statement(
        "s4d-too-much-damping",
        _IV_D,
        r"$\beta$ has an upper bound: too much virtual damping can itself destabilise",
    ),
    Statement("s4d-delay-shrinks", _IV_D, "a larger delay gives a smaller stable region"),
    Statement(
        "s4e-alpha-003", _IV_E, r"$\alpha=0.03$ is not exceeded by the devices that [8] lists"
    ),
    Statement(
        "s4e-linearised",
        _IV_E,
        r"for such small $\alpha$ the boundary can be linearised around the origin",
    ),
    Statement("s4e-same-as-passive", _IV_E, "(24) is the linear part (9)"),
    Statement("s4e-stiffness-free", _IV_E, "$k$ does not influence (24)"),
    Statement("s4e-unstable-side", _IV_E, "above the crossing the line lies on the unstable side"),
    Statement(
        "s4e-two-percent",
        _IV_E,
        r"for $\delta>0.015$ the error exceeds 2\% also for negative $\beta$",
    ),
    Statement(
        "s4e-passive-range",
        _IV_E,
        r"for $\beta\in[-1,d/(2d+3)]\delta$ the line gives passive walls",
    ),
    Statement("s5a-subset", _V_A, r"the passive region lies inside the stable one for all $d\ge0$"),
    Statement(
        "s5a-smaller-delta",
        _V_A,
        r"for $\delta<0.02$ the relative difference in size of the regions is even larger",
    ),
    Statement("s5a-proportional", _V_A, r"the passive region is proportional to $\delta$"),
    Statement(
        "s5b-soft-contacts",
        _V_B,
        "the virtual stiffness can be lowered down to zero without loss of stability",
    ),
    Statement(
        "s5b-eta-d0",
        _V_B,
        r"at $d=0$ more than 17.8 times, $\eta<0.0562$",
        quoted=(Quoted("above", "17.8"), Quoted("below", "0.0562")),
    ),
    Statement(
        "s5b-eta-d1",
        _V_B,
        r"at $d=1$ more than 9.3 times, $\eta<0.1074$",
        quoted=(Quoted("above", "9.3"), Quoted("below", "0.1074")),
    ),
    Statement("s5b-eta-grows", _V_B, r"$\eta$ grows with $d$ until it is 1"),
    Statement(
        "s5c-human-10000",
        _V_C,
        "the limit is nearly 10000 times the stiffness of a human arm in (23)",
        quoted=(Quoted("about", "1e4"),),
    ),
    Statement(
        "s5c-shape",
        _V_C,
        "such stiff springs change shape and size of the stable region completely",
    ),
    Statement(
        "s5c-marginal-b",
        _V_C,
        r"the stiffness (31) is only marginally influenced by the damping $b$",
    ),
    Statement("s5c-robust-subset", _V_C, "the passive region lies inside the robustly stable one"),
    Statement(
        "s5c-robust-vanishes",
        _V_C,
        r"for $\delta=0$ the robustly stable region shrinks to the origin",
    ),
    Statement(
        "s5c-undamped-limit",
        _V_C,
        r"for $\delta=0$ and $\gamma=\pi^2$ the whole region is limit stable",
    ),
    Statement(
        "s5c-pole-inside",
        _V_C,
        r"for $\delta>0$ the pole that lay at $z=-1$ is inside the unit circle",
    ),
    Statement(
        "s6-stable-22",
        _VI,
        r"at $d=1$ the largest stable stiffness is below 22\% of that at $d=0$",
        quoted=(Quoted("below", "0.22"),),
    ),
    Statement(
        "s6-human-10000",
        _VI,
        "springs that swing at the Nyquist frequency are about 10000 times as stiff as an arm can "
        "be",
    ),
    Statement(
        "s6-sampling", _VI, "passive stiffness is linear, stable stiffness quadratic in $1/T$"
    ),
    Statement("s6-damping-marginal", _VI, "damping contributes only marginally to stability"),
    Statement(
        "s6-linear-dissipation",
        _VI,
        "where the linear approximation holds, virtual damping dissipates like physical damping",
    ),
    Statement(
        "s6-stiffness-marginal",
        _VI,
        "physical stiffness within its range hardly affects stability",
    ),
    Statement("s6-mass", _VI, "the mass scales the stable region, not the passive one"),
    Statement(
        "s6-performance",
        _VI,
        "stiffness does not improve the performance if the mass grows equally",
    ),
    Statement(
        "s6-faster-sampling",
        _VI,
        "much faster sampling does not improve much where the time delay outweighs the sampling",
    ),
)

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
        quote="Time delays in a closed control loop can be summarized without affecting the "
        "characteristic polynomial of a linear system.",
    ),
    Statement(
        "s2c-rational-delay",
        _II_C,
        "with $z=w^q$ the loop of a rational delay $d=p/q$ has whole powers of $w$ only, which is "
        "an approximation",
        quote="any discrete-time transfer function with rational delay factor can be transferred "
        "into a transfer function with a whole number for the delay factor by appropriately"
        " substituting the discrete-time variable $z$. Note that this approximation [...] "
        "considers discrete-time systems with multiples of the original sampling rate.",
    ),
    Statement(
        "s2c-positive-delay",
        _II_C,
        r"no delay is less than zero: $t_d\ge0$, and so $d\ge0$",
        quote=r"This delay is assumed to be constant and positive $t_d \geq 0$.",
    ),
    Statement(
        "s2d-arm-in-force",
        "Sec. II-D",
        "without a model of the arm, its mass, damper and spring are part of $F_E$",
        quote="the physical parameters of the human arm are implicitly taken into account in $F_E$",
    ),
    Statement(
        "s3-interconnection",
        "Sec. III",
        "any interconnection of passive systems is passive and therefore stable",
        quote="any interconnection of passive systems results in a passive and therefore stable "
        "overall system",
    ),
    Statement(
        "s3-unilateral",
        "Sec. III",
        "condition (4) also holds for walls that only push, not pull",
        quote="This condition also holds for virtual walls with a unilateral constraint.",
    ),
    Statement(
        "s3a-mass-free",
        _III_A,
        "condition (5) does not depend on the mass",
        quote="Note that this condition is independent of mass $m$.",
    ),
    Statement(
        "s3a-undelayed",
        _III_A,
        "the form for $d=0$, and (6) as its summary",
        (r"b > KT/2 - B \cos(\omega T)",),
        r"d = 0",
        quote=r"For $d = 0$, it results $b > KT/2 - B \cos(\omega T)$, which can be easily "
        "summarized as",
    ),
    Statement(
        "s3b-linear-in-T",
        _III_B,
        "by (7) the boundary is linear in $b$, and its stiffness also in the sampling period $T$",
        quote="This equation reveals a linear dependency between the virtual wall parameters and "
        "the physical damping $b$, and additionally the sampling period $T$ for $K$.",
    ),
    Statement(
        "s3c-limit-points",
        _III_C,
        "the boundaries end at $(0,b)$ and $(0,-b)$ for every delay",
        (
            r"\begin{pmatrix} K \\ B \end{pmatrix} = \begin{pmatrix} 0 \\ b \end{pmatrix}",
            r"\begin{pmatrix} K \\ B \end{pmatrix} = \begin{pmatrix} 0 \\ -b \end{pmatrix}",
        ),
        quote="The two limiting points of the passivity boundaries are $(K, B) = (0, b)$ and $(K,"
        " B) = (0, -b)$, independent of time delay $d$.",
    ),
    Statement(
        "s3c-bmax-frequency",
        _III_C,
        "frequency of the largest passive damping, and (5) there",
        (r"\omega = \pi/T(d+1)", r"b > KT/2 + B"),
        quote="At that frequency passivity condition (5) converges to the linear condition $b > "
        "KT/2 + B$, also independent of delay $d$.",
    ),
    Statement(
        "s3c-upper-part",
        _III_C,
        r"for $B\ge0$ condition (6) says $b>\frac{KT}2+B$",
        quote="This condition corresponds to the upper part of the passivity boundary (6) for "
        "$d = 0$.",
    ),
    Statement(
        "s3c-lower-part",
        _III_C,
        r"the lower part of the boundary is linear, and is the limit of (7) for $\omega\to0$",
        quote="The lower parts of the passivity boundaries in Fig. 4 are linear. They can be "
        r"derived as limits of the explicit passivity condition (7) at $\omega \rightarrow "
        "0$",
    ),
    Statement(
        "s3c-kmax-frequency",
        _III_C,
        "at the largest stiffness the coefficient of $B$ in (5) vanishes, at this frequency",
        (r"\omega = \pi/2T(d+1)",),
        quote="In this point, the coefficient of the virtual damping $B$ vanishes in passivity "
        r"condition (5), which holds true for the frequency $\omega|_{K_{\max}} = "
        r"\pi/2T(d+1)$.",
    ),
    Statement(
        "s3c-kmax-41",
        _III_C,
        r"at $d=1$ the largest passive stiffness is about 41\% of that at $d=0$",
        quoted=(Quoted("about", "0.41"),),
        quote="Already for a delay of only one sampling step, i.e., $d = 1$, the maximum "
        r"stiffness reduces to approximately 41\% of its undelayed value",
    ),
    Statement(
        "s3c-kmax-27",
        _III_C,
        r"at $d=2$ the largest passive stiffness is below 27\% of that at $d=0$",
        quoted=(Quoted("below", "0.27"),),
        quote=r"for $d = 2$ less than 27\% of the stiffness of the undelayed case can be reached",
    ),
    Statement(
        "s4a-delay-equivalent",
        _IV_A,
        "discrete equivalent of the delay",
        (r"e^{-dT_s} \hat{=} z^{-d}",),
        quote=r"The discrete-time equivalent of the delay is well known being $e^{-dT_s} \hat{=} "
        "z^{-d}$.",
    ),
    Statement(
        "s4a-exact-instants",
        _IV_A,
        "with (12) and $z^{-d}$ the system behaves exactly as before at the sampling instants",
        quote="A system with these two equivalents has the exact same behavior at the sampling "
        "instants as the original system in Fig. 3.",
    ),
    Statement(
        "s4b-five-parameters",
        _IV_B,
        r"$p(z)$ depends on $\alpha,\beta,\gamma,\delta,d$ only",
        quote="the normalized characteristic polynomial $p(z)$ depends only on the five "
        r"dimensionless parameters $\alpha$, $\beta$, $\gamma$, $\delta$, and $d$",
    ),
    Statement(
        "s4b-seven-to-five",
        _IV_B,
        "the substitution turns seven parameters into five",
        quote="the trick with substituting the physical parameters transforms the original seven "
        "parameters system into a system with only five explicit parameters",
    ),
    Statement(
        "s4c-independent-limits",
        _IV_C,
        r"limits for arm and device, each on its own, limit $\gamma$ and $\delta$",
        quote="it is sufficient to determine independent upper limits for the human and the "
        r"haptic device, to obtain conservative upper limits for $\gamma$ and $\delta$",
    ),
    Statement(
        "s4c-outlier",
        _IV_C,
        "the ratios of Kuchenbecker et al. are far above all others",
        quote="the fractions of Kuchenbecker et al. [24] are much higher compared to all the "
        "others",
    ),
    Statement(
        "s4c-series",
        _IV_C,
        "joints in series make the arm softer than each joint is on its own",
        quote="the human arm stiffness results as series connection of many joint stiffnesses, "
        "and is therefore much smaller",
    ),
    Statement(
        "s4c-device-damping",
        _IV_C,
        r"for the devices listed in [8], $b_D/m_D$ is below $0.625\,\mathrm{s}^{-1}$",
        quote="For all of them, the ratio of physical damping to mass $b_D/m_D$ is smaller than "
        r"$0.625 \text{ s}^{-1}$.",
    ),
    Statement(
        "s4c-extension-30",
        _IV_C,
        r"the ranges (23) extend (22) by roughly 30\%, in the caption of Fig. 6 by 30\%",
        quote=r"parameter ranges extended by roughly 30\% will be considered, see Fig. 6",
    ),
    Statement(
        "s4c-wider-delta",
        _IV_C,
        r"the range of $\delta$ is wider than in [10], mainly by the values of Tsuji et al.",
        quote=r"compared to [10], a wider range for $\delta$ is used, mainly because the values of"
        " Tsuji et al. [29] are added to Table II",
    ),
    Statement(
        "s4d-degree",
        _IV_D,
        "$p(z)$ has degree $d+3$",
        quote="the characteristic polynomial (18) is of degree $d + 3$",
    ),
    Statement(
        "s4d-explicit-only-undelayed",
        _IV_D,
        r"in the literature the boundary is explicit for $d=0$, $\gamma=0$ and implicit for $d=1$",
        quote=r"An explicit solution for the case $d = 0$ and $\gamma = 0$, i.e., without time "
        "delay and physical stiffness, was derived by Gil et al. [15]. Already for a delay "
        "of $d = 1$, only an implicit solution could be determined [12].",
    ),
    Statement(
        "s4d-left-bound",
        _IV_D,
        r"for the arms of (23) no stable wall has $\alpha\le-\gamma$, and without delay the region "
        r"ends on this line",
        (r"\alpha = -\gamma",),
        quote=r"The stable regions have a vertical straight bound at $\alpha = -\gamma$.",
    ),
    Statement(
        "s4d-quadratic-in-period",
        _IV_D,
        "twice the sampling frequency gives the same device four times the stable stiffness",
        quote="a double sampling frequency with constant delay factor $d$ (i.e., half time delay "
        r"$t_d = d \cdot T$) enables a four times higher virtual stiffness $K$",
    ),
    Statement(
        "s4d-damping-bound",
        _IV_D,
        "with the same damper and spring the upper bound of $B$ is linear in $m$ and $1/T$",
        quote="This bound for the virtual stiffness $B$ (as non-normalized parameter) depends "
        "linearly on the mass $m$ and the sampling rate $1/T$.",
    ),
    Statement(
        "s4d-delta-grows",
        _IV_D,
        r"without delay and inside (23) $\delta$ enlarges the stable region in every direction but "
        "the left",
        quote=r"physical damping $\delta$ increases the stable region toward each direction. "
        r"Except the left vertical bound of the stable region is uninfluenced by $\delta$.",
    ),
    Statement(
        "s4d-gamma-invisible",
        _IV_D,
        r"within its range $\gamma$ hardly moves the curve at $d=0$",
        quote=r"The influence of $\gamma$ on the parabola-like part of the boundaries is rather "
        "marginal.",
    ),
    Statement(
        "s4d-all-stabilising",
        _IV_D,
        "every wall that is stable stays so with more mass, a stiffer spring or a stronger damper "
        "of the operator",
        quote="if modeled as linear mass-spring-damper system, all three elements (the mass, the "
        "spring and the damper) of a human operator are stabilizing an impedance type "
        "haptic system",
    ),
    Statement(
        "s4d-too-much-damping",
        _IV_D,
        r"$\beta$ has an upper bound: too much virtual damping can itself destabilise",
        quote=r"as there is an upper bound for $\beta$, a too high virtual damping itself can "
        "destabilize the system",
    ),
    Statement(
        "s4d-delay-shrinks",
        _IV_D,
        "every wall that is stable with one more period of delay is stable without it",
        quote="For larger delays, the stable region becomes smaller",
    ),
    Statement(
        "s4e-alpha-003",
        _IV_E,
        r"$\alpha=0.03$ is not exceeded by the devices that [8] lists",
        quote=r"For all devices listed by Diolaiti et al. [8], a value of $\alpha = 0.03$ is not "
        "exceeded.",
    ),
    Statement(
        "s4e-linearised",
        _IV_E,
        r"for such small $\alpha$ the boundary can be linearised around the origin",
        quote="For such small values, the stability boundary can be linearized around the origin.",
    ),
    Statement(
        "s4e-same-as-passive",
        _IV_E,
        "(24) is the linear part (9)",
        quote="This condition corresponds precisely to the linear part of the passivity condition"
        " (9), but with physical damping being $b = b_D + b_H$.",
    ),
    Statement(
        "s4e-stiffness-free",
        _IV_E,
        "$k$ does not influence (24)",
        quote="Note that the physical stiffness $k$ does not influence condition (24), but shift "
        "the lower limit of the virtual stiffness to $K > -k$.",
    ),
    Statement(
        "s4e-unstable-side",
        _IV_E,
        "above the crossing the line lies on the unstable side",
        quote="Above these crossing points, the linear condition is located on the unstable side "
        "of the stability boundary.",
    ),
    Statement(
        "s4e-two-percent",
        _IV_E,
        r"for $\gamma=0.001$ and each $\delta>0.015$ of (23) the error exceeds 2\% for some wall "
        r"of the boundary with $\beta<0$",
        quote=r"for damping values larger than $\delta > 0.015$, there are cases in which the "
        r"relative error is larger than 2\% also for negative $\beta$",
    ),
    Statement(
        "s4e-passive-range",
        _IV_E,
        r"for $\beta\in[-1,d/(2d+3)]\delta$ the line gives passive walls",
        quote=r"for small values of the virtual damping $\beta \in [-1, d/(2d+3)]\delta$, the "
        "linear condition represents the linear part of the passivity boundary (9), such "
        "that in this parameter range the condition can be used to obtain even passive "
        "behavior",
    ),
    Statement(
        "s5a-subset",
        _V_A,
        r"for $\gamma=0.001$, $\delta=0.02$ and every delay a passive wall is stable",
        quote="the passive region is a subset of the corresponding stable region for the given "
        r"set of parameters, $\gamma = 0.001$, $\delta = 0.02$, and for time delays $d \geq "
        "0$",
    ),
    Statement(
        "s5a-smaller-delta",
        _V_A,
        r"for $\delta<0.02$ the relative difference in size of the regions is even larger",
        quote=r"for smaller values of $\delta$, the relative difference in size between the "
        "passive and the stable region becomes even larger",
    ),
    Statement(
        "s5a-proportional",
        _V_A,
        r"the passive region is proportional to $\delta$",
        quote="The size of the passive regions is directly proportional to physical damping "
        r"$\delta$",
    ),
    Statement(
        "s5b-soft-contacts",
        _V_B,
        "the virtual stiffness can be lowered down to zero without loss of stability",
        quote="For soft contacts, the virtual stiffness can be decreased down to zero without "
        "causing stability problems.",
    ),
    Statement(
        "s5b-eta-d0",
        _V_B,
        r"at $d=0$ more than 17.8 times, $\eta<0.0562$",
        quoted=(Quoted("above", "17.8"), Quoted("below", "0.0562")),
        quote="For $d = 0$, the maximum stable virtual stiffness is more than 17.8 times higher "
        r"than achievable by passivity ($\eta_{d=0} < 0.0562$).",
    ),
    Statement(
        "s5b-eta-d1",
        _V_B,
        r"at $d=1$ more than 9.3 times, $\eta<0.1074$",
        quoted=(Quoted("above", "9.3"), Quoted("below", "0.1074")),
        quote="If the delay increases to $d = 1$, this ratio decreases to values greater than 9.3"
        r" ($\eta_{d=1} < 0.1074$).",
    ),
    Statement(
        "s5b-eta-grows",
        _V_B,
        r"$\eta$ grows with $d$ until it is 1",
        quote=r"for increasing delay, the relation $\eta$ becomes larger until the maximum passive"
        r" and stable stiffnesses are the same at $\eta = 1$",
    ),
    Statement(
        "s5c-human-10000",
        _V_C,
        "the limit is nearly 10000 times the stiffness of a human arm in (23)",
        quoted=(Quoted("about", "1e4"),),
        quote="this limit is nearly 10000 times larger than the maximum stiffness of a human arm "
        "defined in (23)",
    ),
    Statement(
        "s5c-shape",
        _V_C,
        "without delay the stable walls lie below an arc with a spring of (23); with that of the "
        "Nyquist frequency they fill a triangle, and one is 13 times as stiff as all of those",
        quote="Such high stiffness causes the stability boundaries to change completely their "
        "shape and size.",
    ),
    Statement(
        "s5c-marginal-b",
        _V_C,
        r"the stiffness (31) is only marginally influenced by the damping $b$",
        quote="this stiffness value is only marginally influenced by the physical damping $b$",
    ),
    Statement(
        "s5c-robust-subset",
        _V_C,
        "for every damper and every delay a passive wall is stable with every spring",
        quote="The passive region is located completely inside the robustly stable region "
        "independent of time delay and physical damping.",
    ),
    Statement(
        "s5c-robust-vanishes",
        _V_C,
        r"for $\delta=0$ the robustly stable region shrinks to the origin",
        quote=r"there is an intersecting stable region for $\delta > 0$, which vanishes for "
        r"$\delta = 0$ in the point of origin",
    ),
    Statement(
        "s5c-undamped-limit",
        _V_C,
        r"for $\delta=0$ and $\gamma=\pi^2$ a pole stays at $-1$ for every wall and delay; without "
        r"delay it is simple and all others lie inside for $\alpha>-\pi^2$, "
        r"$\beta>-\frac{\pi^2}2$, $\alpha+2\beta<0$, and only there",
        quote=r"For $\delta = 0$, the whole stable region is limit stable at the Nyquist frequency"
        r" $\gamma = \pi^2$, as the system has a pole at $z = -1$ independent of time delay "
        "$d$.",
    ),
    Statement(
        "s5c-nyquist-spring",
        _V_C,
        r"without damping, $\gamma=\pi^2$ is the spring of the Nyquist frequency, by (29)",
        quote="the whole stable region is limit stable at the Nyquist frequency "
        r"$\gamma = \pi^2$",
    ),
    Statement(
        "s5c-pole-inside",
        _V_C,
        r"for $\delta>0$ the pole that lay at $z=-1$ is inside the unit circle",
        quote=r"For positive physical damping, $\delta > 0$ this pole moves inside the unit "
        "circle.",
    ),
    Statement(
        "s6-subset",
        _VI,
        "for every arm and every delay a passive wall is stable",
        quote="For any time delay, the passive regions are completely contained in the stable "
        "regions.",
    ),
    Statement(
        "s6-stable-22",
        _VI,
        r"at $d=1$ the largest stable stiffness is below 22\% of that at $d=0$",
        quoted=(Quoted("below", "0.22"),),
        quote="a delay of one sampling period causes the maximum stable stiffness to decrease to "
        r"less than 22\% of the undelayed counterpart",
    ),
    Statement(
        "s6-human-10000",
        _VI,
        "springs that swing at the Nyquist frequency are about 10000 times as stiff as an arm can "
        "be",
        quote="Such high stiffness values are about 10000 times larger than the maximally "
        "reachable stiffness of human arms.",
    ),
    Statement(
        "s6-sampling",
        _VI,
        "of one device, passive stiffness is linear and stable stiffness quadratic in $1/T$",
        quote="While the dependency of the passive stiffness is linear, the stable stiffness is "
        "quadratically depending on the sampling rate.",
    ),
    Statement(
        "s6-damping-marginal",
        _VI,
        r"by how much $\delta=0.02$ raises the largest stable stiffness, for $d=0$ to 7",
        quote="an increase of damping is only marginally contributing to stability",
    ),
    Statement(
        "s6-linear-dissipation",
        _VI,
        "where the linear approximation holds, virtual damping dissipates like physical damping",
        quote="In the range in which this linear approximation holds, discrete-time damping has "
        "the same dissipative behavior as its continuous-time counterpart.",
    ),
    Statement(
        "s6-stiffness-marginal",
        _VI,
        r"by how much $\gamma=0.001$ lowers the largest stable stiffness, for $d=0$ to 7",
        quote="the effect of physical stiffness within the possible range is hardly affecting "
        "stability",
    ),
    Statement(
        "s6-mass",
        _VI,
        "with the same damper and spring the mass scales the stable region, not the passive one",
        quote="The moving mass [...] is proportionally scaling the stable region, while it has no"
        " influence on passivity. For stability, a doubling of mass enables a doubling of "
        "virtual stiffness and damping.",
    ),
    Statement(
        "s6-performance",
        _VI,
        "stiffness does not improve the performance if the mass grows equally",
        quote="as the performance of haptic systems is related to the fraction of stiffness to "
        "mass, higher stiffness does not lead to better performance, if mass increases "
        "equally",
    ),
    Statement(
        "s6-faster-sampling",
        _VI,
        "much faster sampling does not improve much where the time delay outweighs the sampling",
        quote="A much faster sampling does not significantly improve performance, if time delay "
        "outweighs the effect of discrete-time sampling.",
    ),
)

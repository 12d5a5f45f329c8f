"""What the abstract and Secs. IV to VI state on sizes: regions, stiffnesses, errors, masses."""

from __future__ import annotations

from symhaptic.paper.statement import Statement

CLAIMS_COMPARED = (
    Statement(
        "s4d-delay-shrinks-area",
        "Sec. IV-D",
        "a larger delay leaves less area, for the arm of Figs. 11 and 12 and up to eight periods",
        quote="For larger delays, the stable region becomes smaller",
    ),
    Statement(
        "s4d-all-stabilising-area",
        "Sec. IV-D",
        "mass, spring and damper each give the stable region more area, or no less, without delay",
        quote="all three elements (the mass, the spring and the damper) of a human operator are "
        "stabilizing an impedance type haptic system",
    ),
    Statement(
        "one-delta",
        "Sec. V-A",
        r"the passive walls of a held device are those of (5) with the same $\delta$ as its "
        "stable walls",
        quote=r"For given $\delta$ and $d$, these boundaries can be plotted in the same $(\alpha, "
        r"\beta)$-plane as the stability boundaries.",
    ),
    Statement(
        "s0-far-higher",
        "Abstract",
        "some stable wall is at least as stiff as all passive walls, and how many times as stiff",
        quote="the maximum stable stiffness of virtual walls is far higher than admitted by "
        "passivity",
    ),
    Statement(
        "s5a-much-smaller",
        "Sec. V-A",
        "stable walls can be many times as stiff and as damped as passive ones, for the arm and "
        "the integer delays of Fig. 11",
        quote="The dimensions of the passive regions are much smaller than those of the stable "
        "ones.",
    ),
    Statement(
        "s5b-clearly-larger",
        "Sec. V-B",
        "some stable wall is at least as stiff as all passive walls, and how many times as stiff",
        quote="The maximum stable stiffness is clearly larger than the passive stiffness.",
    ),
    Statement(
        "s6-damping-any-delay",
        "Sec. VI",
        "some factor bounds what the damper adds to the largest stable stiffness, for every arm "
        "of (23) and every integer delay",
        quote="an increase of damping is only marginally contributing to stability",
    ),
    Statement(
        "s6-stiffness-any-delay",
        "Sec. VI",
        "some factor bounds what the spring changes of the largest stable stiffness, for every "
        "arm of (23) and every integer delay",
        quote="the effect of physical stiffness within the possible range is hardly affecting "
        "stability",
    ),
    Statement(
        "s6-light-device",
        "Sec. VI",
        "a hand that is lighter takes the larger share of the stable walls the lighter the device "
        "is, without dampers and springs",
        quote="As a haptic device with very low mass is highly affected by the human mass, do not "
        "try to minimize the haptic device mass.",
    ),
    Statement(
        "s6-linear-small-error",
        "Sec. VI",
        r"the error (26) is at most 5\,\% on the boundary with $0\le\alpha\le0.09$ for $d=0$ and "
        r"$0\le\alpha\le0.026$ for $d=1$, for all arms of (23)",
        quote="this linear approximation has a small relative error over a wide range compared to "
        "the precise stability boundaries",
    ),
    Statement(
        "s5c-delta-hardly-visible",
        "Sec. V-C",
        r"for $d=0$ and the Nyquist frequency the three sides of the stable region move by less "
        r"than 0.05 as $\delta$ goes from 0 to 0.02; the region is more than 19 wide",
        quote=r"the influence of the physical damping in its valid parameter range $\delta \in [0, "
        "0.02]$ is hardly visible in this scale",
    ),
    Statement(
        "s5c-every-spring",
        "Sec. V-C",
        "a wall that is stable with every spring up to the Nyquist frequency is stable with every "
        "spring",
        quote="a physical spring can never destabilize a haptic system, which is rendering a "
        "virtual wall with parameter values inside this intersection, independent of the spring "
        "stiffness",
    ),
    Statement(
        "s5c-robust-shrinks",
        "Sec. V-C",
        "the largest robustly stable stiffness falls with each period of delay",
        quote="also the robustly stable region shrinks with increasing delay",
    ),
    Statement(
        "s5c-robust-shrinks-sets",
        "Sec. V-C",
        "the robustly stable walls of a larger delay are among those of a smaller one",
        quote="also the robustly stable region shrinks with increasing delay",
    ),
    Statement(
        "s5c-robust-grows",
        "Sec. V-C",
        "the largest robustly stable stiffness rises with the damping",
        quote="also the robustly stable region [...] grows with increasing physical damping",
    ),
    Statement(
        "s5c-robust-grows-sets",
        "Sec. V-C",
        "the robustly stable walls of a damping are among those of a larger one",
        quote="also the robustly stable region [...] grows with increasing physical damping",
    ),
    Statement(
        "s6-why-conservative",
        "Sec. VI",
        "with stiff springs admitted, stable walls are hardly stiffer than passive ones: by how "
        "much",
        quote="it is illustrated why passivity is conservative for haptic systems in terms of "
        "stability. Passivity considers a wide range of physical stiffness values, up to a "
        "stiffness that causes the system oscillating in frequencies close to the Nyquist "
        "frequency.",
    ),
)

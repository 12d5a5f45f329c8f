"""What an error of the paper means for somebody who built a device on it, the gravest first.

The errata have this order.  Words only: what is wrong, and what shows it, is in the ledger.
Formulas between dollar signs.
"""

from __future__ import annotations

UNSAFE: dict[str, str] = {
    "one-delta": "For passivity use the damping of the device alone, $b_D$, and for stability "
    r"that of device and arm together, $b_D+b_H$. With one $\delta$ for both, the passive walls of "
    r"Figs. 11 "
    "to 13 are far too stiff for a device with an arm: for an arm and a device of equal mass "
    "at the limits of (21) and (22), 24 times.",
    "s4d-all-stabilising": "A firmer grip or a heavier handle can destabilise a wall that was "
    "stable. Test the whole range of grips, not only the loosest one.",
    "s4d-delay-shrinks": "A wall that is stable with some delay can be unstable with a smaller "
    "one. Check the smallest delay as well as the largest.",
    "eq4": r"Check $K\ge0$ as well. A wall that pulls (negative stiffness, as in a detent) can "
    "satisfy (4) and still deliver energy to the hand.",
    "eq5": "With a delay that is not an integer number of periods, round it up before using (5); "
    r"with $K\ge0$ that is safe. As published, it allows some walls that deliver energy. Walls "
    "that satisfy it with equality are passive as well.",
    "eq11": "For a fractional delay this wall can deliver energy, and it is not the passive wall "
    r"of maximum stiffness. With a delay of half a period that wall is 1.8\,\% stiffer and has "
    "another damping.",
    "eq8": "For half a period of delay no wall with $K>0$ on this line is passive. Round the "
    "delay up.",
    "eq9": "The same line as (8): round a fractional delay up, and keep to the published range "
    "of damping.",
    "eq10": "As for (9). Do not use it for more virtual damping than $B=bd/(2d+3)$: without "
    "delay every $B>0$ reduces the passive stiffness, by (6).",
    "eq7": r"Plot it up to $\omega T=\pi/(d+1)$ only; beyond, the curve is no boundary. Without "
    "delay use (6).",
    "eq27": "As (7).",
    "fig4": "The curves for 0.25 and 0.5 periods show (5), which is not the limit of passivity "
    "there. Use the curve for the next integer delay.",
    "fig5": "Between integer delays the curve is above or below the exact limit. Read it at the "
    "next integer delay, which is safe.",
    "eq24": "This is a rule of thumb. Inside (23) it is safe up to a virtual damping of about "
    "$b/6$ without delay and $b/4$ with one period of delay; above, it allows unstable walls. "
    "Use (9) or the exact boundary.",
    "eq25": "As for (24): above the crossing with the exact boundary it allows unstable walls.",
    "s4e-passive-range": "Count the damping of the device only. If $b$ includes the damping of "
    "the arm, walls on the line can deliver energy when the user lets go.",
    "s6-linear-dissipation": "Near the limit, a loop can become unstable if its damper is "
    "replaced by the same amount of virtual damping. The damper is worth more, especially with a "
    "delay.",
    "s3b-linear-in-T": "Halving the period, and the delay with it, doubles the passive "
    "stiffness. Taken literally, the text would recommend a slower loop for a stiffer wall.",
    "eq12": "For a damped device the published transfer function (12) is wrong unless $m=T$ in "
    "the units used. With the factor $m/T$ it is exact.",
    "s4d-quadratic-in-period": "Twice the sampling rate and half the delay do not allow quite "
    "four times the stiffness with the same device. A wall that was tuned to the limit can "
    "become unstable.",
    "s6-sampling": "As for four times the stiffness: the claim is true for a free mass.",
    "s4d-damping-bound": "The same holds for the damping: twice the rate does not allow quite "
    "twice the damping.",
    "s6-mass": "Doubling the mass doubles the limit only if damping and grip are doubled too.",
    "s5b-soft-contacts": "If the arm has a spring, reducing $K$ alone can destabilise a wall: "
    "with a long delay, or with a short delay and a stiff spring. Reduce $B$ with $K$: a passive "
    r"wall with $K\ge0$ then stays passive.",
    "s6-damping-any-delay": "With a delay the damper matters. A $\\delta$ of 0.02 adds 7\\,\\% "
    "to the stable stiffness at one period of delay and a third at eight periods. At forty "
    "periods, with a spring, the stable stiffness at $\\delta=0.02$ is eleven times that at "
    "0.001.",
    "s6-stiffness-any-delay": "With long delays the grip is decisive: between a free device and "
    r"the largest $\gamma$ of (23) the limit changes by a large factor.",
    "s6-subset": "Passive walls are stable if the device is damped and $K+k>0$. For a fractional "
    "delay the exact condition of passivity is needed, not (5).",
    "s5c-robust-subset": "Without damping only the wall $K=B=0$ is passive, and no wall is "
    "stable with every spring of the arm. Do not rely on a device without damping.",
    "s3c-limit-points": r"As for (5): round a fractional delay up, and keep $K\ge0$.",
    "s4a-exact-instants": "With a fractional delay, a loop that was tuned with $z^{-d}$ can be "
    "unstable. Use the modified z-transform (\\texttt{is\\_stable} with that delay).",
    "s3-interconnection": "A passive wall does not make a chain of filters safe. Couple devices "
    "and walls by force and velocity, in parallel or by feedback, and keep some damping.",
}

MISLEADING: dict[str, str] = {
    "s5b-eta-grows": "No delay makes the passive wall the stiffest stable one. For long delays "
    "and an arm with a spring the stable limit is far above (11) again.",
    "s5a-smaller-delta": "For ordinary delays, the less damping a device has, the further the "
    "passive stiffness is below the stable one. For very long delays the opposite can hold.",
    "s6-faster-sampling": "Faster sampling is useful until the delay is about ten periods. "
    "Beyond, a tenfold rate increases the stiffness by less than a quarter.",
    "eq18": "As for (14): for $k=0$ the polynomial vanishes, and a root finder returns nothing "
    r"or meaningless values. Use \texttt{characteristic\_polynomial}.",
    "eq14": "Code that follows (14) divides zero by zero for a device without an arm and at "
    "critical damping, and loses digits close to both cases. Use the entire forms "
    r"(\texttt{discretize}).",
    "eq16": "As (14).",
    "eq17": "As for (14): for $k=0$ every coefficient is zero.",
    "s4d-degree": "For $k=0$ the published polynomial is zero; the correct one has degree $d+3$.",
    "s4c-extension-30": r"The range of $\gamma$ is extended by more than the text says, and that "
    r"of $\delta$ by the 30\,\%. At $T=1$ ms a stiffness per mass a third above the "
    r"$710\,\mathrm{s}^{-2}$ of (21) is still inside; the arm that the paper leaves out is not.",
    "s6-human-10000": "Compare stiffness per mass. Against the arm alone the spring of Example "
    "5.1 is 1740 times as stiff.",
    "s4e-stiffness-free": "In the model that gives (24) the spring of a damped arm would allow "
    "slightly more stiffness; leaving it out is safe in that model.",
    "s3c-lower-part": "None for a device: the lower part is a straight line. The limit of (7) "
    "gives only the upper end of (8).",
}

HARMLESS: dict[str, str] = {
    "eq6": r"None in practice: walls with equality are passive, so that $\ge$ is sufficient for "
    r"$K\ge0$.",
    "s3a-undelayed": "None in practice; see (6).",
    "s3c-bmax-frequency": "Without delay the frequency is the Nyquist frequency, which (5) "
    r"excludes; the bound $b\ge KT/2+B$ still holds.",
    "eq20": "None: for an arm without a spring both sides are zero.",
    "s4a-delay-equivalent": "None once $s$ is read as a factor. For a fractional delay $z^{-d}$ "
    "is no discrete system.",
    "s5c-interval": r"None: for a device $\gamma=\pi^2$ is accurate enough as the limit.",
}

SLIPS: dict[str, str] = {
    "s4d-bound-of-b": "None if $B$ is read as the virtual damping.",
    "s1-conclusion": "None.",
    "s5b-ratio-panels": "None: read (b) and (c).",
    "s5b-captions-alike": "None.",
    "s1-et-al": "None.",
    "s4c-et-al": "None.",
}

RULES: dict[str, str] = {
    "rules:twice-damping": r"It is safe without delay only. With one period of delay use 41\,\% "
    "of this stiffness.",
    "rules:damping-over-delay": "Count virtual damping up to $bd/(2d+3)$ only; more of it "
    "reduces the stiffness.",
    "rules:four-masses": "A small stiffness is not safe by itself: damping decides.",
    "rules:two-masses": "As for four masses: without damping every stiffness is unstable.",
    "rules:damped-contact": "Use $2B(2m-BT)/(T(2m+BT))$, which allows no stiffness from $BT=2m$ "
    "on; the rule still allows some up to $BT=4m$.",
    "rules:euler-for-devices": "The stiffness limit of a simulator is at least twice that of a "
    "device; with little damping the ratio has no bound.",
    "rules:two-dampings": "For a wall that computes the velocity use $2B(2m-BT)/(T(2m+BT))$.",
    "rules:plain-damping": "The rule is safe with a filter, but not with a delay: use (9) or (11).",
    "rules:virtual-mass": r"With a spring and a damper keep to $b\ge KT/2+B+2m_v/T$.",
    "rules:virtual-mass-stable": "With a delay of one period keep to 62 per cent of this limit.",
    "rules:both-below-two": "Check the bound of your integrator: $K<4m/T^2-2B/T$ for semi-implicit "
    "Euler, and for explicit Euler $K<B/T$.",
    "rules:one-mass": r"For semi-implicit Euler with $B\le3m/(2T)$ only; it is no statement "
    "about a device.",
    "rules:filter-as-delay": "Count a filter of the velocity as a delay only up to "
    "$B=2m\\tau_f/(T(T+4\\tau_f))$; beyond, use the bound of \\chapter{s10f_filtered_mass}.",
    "rules:lag-below-delay": "Compute the limit with the actuator's lag. A device with a spring "
    "can be unstable with a lag although it is stable with an equal delay.",
    "rules:energy-leak": "With a delay of $d$ periods the damper must dissipate $2d+1$ times as "
    "much energy.",
    "rules:delay-damping": "Round a fractional delay up to an integer.",
    "coupling:damper": "The damping of the device must exceed $KT/2+|B|$; reduce $K$ if it does "
    "not.",
    "coupling:implicit": "None for passivity; the integration step damps the oscillations of the "
    "simulation.",
    "coupling:stable-mass": "With a delay of one period keep to 62 per cent of this limit.",
    "coupling:ratio": "None: 2.4 kg is too heavy either way.",
}
"""The same of the other sources, which are no errata of the paper."""

IMPORTANCE: tuple[tuple[str, dict[str, str]], ...] = (
    ("What can make a device unstable or active", UNSAFE),
    ("What misleads a designer or breaks a program", MISLEADING),
    ("What has no consequence for a device", HARMLESS),
    ("Slips of the text", SLIPS),
)
"""The parts of the errata, each with its title, the gravest first."""

CONSEQUENCES = {id: what for _, part in IMPORTANCE for id, what in part.items()} | RULES
"""All of them, by the id of the statement."""

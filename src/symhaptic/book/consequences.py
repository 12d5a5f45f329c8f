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
    "stable. Test the range of grips, not the loosest one.",
    "s4d-delay-shrinks": "A wall that is stable with some delay is not for that reason stable "
    "with less. Check the smallest delay too, not only the largest.",
    "eq4": "Check $K\\ge0$ as well. A wall that pulls (negative stiffness, as in a detent) can "
    "pass (4) and push the hand.",
    "eq5": "With a delay that is not an integer number of periods, round it up before using (5); "
    r"with $K\ge0$ that is safe. Used as published, it can let a wall through that delivers "
    "energy. Walls that just meet it are passive, too.",
    "eq11": "For a fractional delay this wall can deliver energy, and it is not the stiffest "
    r"passive one: at half a period that is 1.8\,\% stiffer, with another damping.",
    "eq8": "For half a period of delay no wall with $K>0$ on this line is passive. Round the "
    "delay up.",
    "eq9": "The same line as (8): round a fractional delay up, and keep inside the range of "
    "damping that is printed.",
    "eq10": "As (9). Do not use it for more virtual damping than $B=bd/(2d+3)$: without delay "
    "every $B>0$ costs stiffness, by (6).",
    "eq7": "Plot it up to $\\omega T=\\pi/(d+1)$ only; what the curve does beyond is no "
    "boundary. Without delay use (6).",
    "eq27": "As (7).",
    "fig4": "Read the curves for 0.25 and 0.5 periods as (5), not as a limit; use the one for the "
    "next integer delay.",
    "fig5": "Between integer delays the curve is on either side of the truth. Read it at the next "
    "integer delay, which is safe.",
    "eq24": "A rule of thumb. Inside (23), for no delay or one period, it is safe up to a "
    "virtual damping of about $b/6$ and $b/4$; above, it allows unstable walls. Use (9) or the "
    "boundary.",
    "eq25": "As (24): above the crossing with the exact boundary it lets unstable walls through.",
    "s4e-passive-range": "Count the damping of the device only. With that of the arm in $b$, "
    "walls on the line deliver energy when the hand lets go.",
    "s6-linear-dissipation": "A device that trades its damper for virtual damping one to one can "
    "end up unstable near the limit. The damper is worth more, the more so with delay.",
    "s3b-linear-in-T": "Halving the period, and the delay with it, doubles the passive "
    "stiffness. Taken literally, one would slow the loop down to stiffen the wall.",
    "eq12": "For a damped device a transfer function typed in from (12) is wrong unless $m=T$ in "
    "the units used. With the factor $m/T$ it is exact.",
    "s4d-quadratic-in-period": "Somebody who doubles the sampling rate of the same device, "
    "halves the delay with it and asks for four times the stiffness can get an unstable wall if "
    "it was tuned to the limit.",
    "s6-sampling": "As for four times the stiffness: true for a free mass.",
    "s4d-damping-bound": "The same for the damping: twice the rate does not give quite twice.",
    "s6-mass": "Doubling the mass doubles the limit only if damping and grip are doubled too.",
    "s5b-soft-contacts": "With a spring in the hand and a long delay, or a stiff one and a short "
    "delay, softening the wall alone can destabilise it. Lower $B$ with $K$: a passive wall "
    "with $K\\ge0$ stays passive that way.",
    "s6-damping-any-delay": "With a delay the damper matters. A $\\delta$ of 0.02 adds 7\\,\\% "
    "to the stable stiffness at one period of delay and a third at eight periods. At forty "
    "periods, with a spring, the stable stiffness at $\\delta=0.02$ is eleven times that at "
    "0.001.",
    "s6-stiffness-any-delay": "With long delays the grip decides: between a free device and the "
    "largest $\\gamma$ of (23) the limit changes many times over.",
    "s6-subset": "Passive walls are stable if the device is damped and $K+k>0$. For a fractional "
    "delay the exact condition of passivity is needed, not (5).",
    "s5c-robust-subset": "Without damping no wall but $K=B=0$ is passive, and for none is every "
    "spring of the hand harmless. Do not rely on a device without damping.",
    "s3c-limit-points": "As (5): round a fractional delay up, and keep $K\\ge0$.",
    "s4a-exact-instants": "With a fractional delay, a loop that was tuned with $z^{-d}$ can be "
    "unstable. Use the modified z-transform (\\texttt{is\\_stable} with that delay).",
    "s3-interconnection": "A passive wall does not make a chain of filters safe. Couple devices "
    "and walls by force and velocity, side by side or in a loop, and leave some damping in.",
}

MISLEADING: dict[str, str] = {
    "s5b-eta-grows": "No delay makes the passive wall the stiffest stable one. For long delays "
    "with a spring in the hand the stable limit is far above (11) again.",
    "s5a-smaller-delta": "With little damping passivity gives away more and more stiffness, for "
    "ordinary delays. For very long ones it can be the other way round.",
    "s6-faster-sampling": "Sampling faster still pays until the delay is some ten periods long; "
    "then ten times the rate gives less than a quarter more stiffness.",
    "eq18": "As (14): for $k=0$ the polynomial vanishes, and a root finder returns nothing or "
    "noise. Use \\texttt{characteristic\\_polynomial}.",
    "eq14": "Code typed in from (14) divides zero by zero for a device without an arm and at "
    "critical damping, and loses digits near both. Use the entire forms "
    r"(\texttt{discretize}).",
    "eq16": "As (14).",
    "eq17": "As (14): for $k=0$ every coefficient is zero.",
    "s4d-degree": "For $k=0$ the printed polynomial is zero; the right one has degree $d+3$.",
    "s4c-extension-30": "The range of $\\gamma$ has more reserve than the text says, that of "
    "$\\delta$ just the 30\\,\\%. At $T=1$ ms a stiffness per mass a third above the "
    "$710\\,\\mathrm{s}^{-2}$ of (21) is still inside; the arm that the paper leaves out is not.",
    "s6-human-10000": "Compare stiffness per mass. Against the arm alone the spring of Example "
    "5.1 is 1740 times as stiff.",
    "s4e-stiffness-free": "In the model that gives (24) a spring in a damped hand would allow a "
    "little more stiffness; leaving it out is on the safe side of that model.",
    "s3c-lower-part": "None for a device: the lower part is a straight line. Who re-derives (8) "
    "as a limit finds its upper end only.",
}

HARMLESS: dict[str, str] = {
    "eq6": "None in practice: walls on the border are passive, so $\\ge$ will do for $K\\ge0$.",
    "s3a-undelayed": "None in practice; see (6).",
    "s3c-bmax-frequency": "Without delay the frequency is the Nyquist frequency, which (5) "
    "leaves out; the bound $b\\ge KT/2+B$ holds all the same.",
    "eq20": "None: for an arm without a spring both sides are zero.",
    "s4a-delay-equivalent": "None once $s$ is read as a factor. For a fractional delay $z^{-d}$ "
    "is no discrete system.",
    "s5c-interval": "None: $\\gamma=\\pi^2$ will do as the limit for a device.",
}

SLIPS: dict[str, str] = {
    "s4d-bound-of-b": "None once $B$ is read as the damping that it is.",
    "s1-conclusion": "None.",
    "s5b-ratio-panels": "None: read (b) and (c).",
    "s5b-captions-alike": "None.",
    "s1-et-al": "None.",
    "s4c-et-al": "None.",
}

RULES: dict[str, str] = {
    "rules:twice-damping": "Safe without delay only. With one period of delay use 41\\,\\% of it.",
    "rules:damping-over-delay": "Count virtual damping up to $bd/(2d+3)$ only; more of it takes "
    "stiffness away.",
    "rules:four-masses": "A stiffness is not safe because it is small: what counts is damping.",
    "rules:two-masses": "As for four masses: without damping every stiffness swings up.",
    "rules:damped-contact": "Use $2B(2m-BT)/(T(2m+BT))$, which allows nothing from $BT=2m$ on; "
    "the rule still does there, up to $BT=4m$.",
    "rules:euler-for-devices": "What a simulator bears is at least twice what a device bears; "
    "with little damping, any number of times.",
    "rules:two-dampings": "For a wall that computes the velocity use $2B(2m-BT)/(T(2m+BT))$.",
    "rules:plain-damping": "With a filter this is safe, and with a delay it is not: use (9) or "
    "(11).",
    "rules:virtual-mass": "Beside a spring and a damper keep to $b\\ge KT/2+B+2M/T$.",
    "rules:virtual-mass-stable": "With a delay of one period keep to 62 per cent of it.",
    "rules:both-below-two": "Check the bound of your integrator: $K<4m/T^2-2B/T$ for semi-implicit "
    "Euler, and for explicit Euler $K<B/T$.",
    "rules:one-mass": "For semi-implicit Euler with $B\\le3m/(2T)$ only; it says nothing of a "
    "device.",
    "rules:filter-as-delay": "Count a filter of the velocity as a delay only up to "
    "$B=2m\\tau_f/(T(T+4\\tau_f))$; beyond, use the bound of \\chapter{s10f_filtered_mass}.",
    "rules:energy-leak": "With a delay of $d$ periods the damper needs $2d+1$ times as much.",
    "rules:delay-damping": "Round a fractional delay up to whole periods.",
    "coupling:damper": "Let the damping of the device outweigh $KT/2+|B|$, and lower $K$ where it "
    "does not.",
    "coupling:implicit": "None for passivity; what swings in the simulation is damped by the step.",
    "coupling:stable-mass": "With a delay of one period keep to 62 per cent of it.",
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

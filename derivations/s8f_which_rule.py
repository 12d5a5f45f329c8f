"""Which rule should one use, and when?

The table lists the rules of this part and the exact limits, ordered by the parameters that they
require. All rules are for $K>0$, and each rule is safe in the stated range.
"""

from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "If only the damping of the device is known, use a passive wall, which is stable with "
        "every arm. If the mass is also known, a stiffer wall is possible, but its limit depends "
        "on the delay."
    )
    page.table(
        "Rules for the stiffness, from the simplest rule to the largest limit; $b$ is the damping "
        "of the device, and $d=t_d/T$ is an integer.",
        ["known", "delay", "virtual damping", "limit of the stiffness"],
        [
            ["$b$, $T$", "none", "$B=0$", "$K\\le2b/T$"],
            ["$b$, $T$, $t_d$", "$dT$", "$B\\le bd/(2d+3)$", "$K<(b+B)/(t_d+T/2)$"],
            ["$b$, $T$, $t_d$", "$dT$", "that of (11)", "$K$ of (11)"],
            ["$m$, $T$", "none", "$B>0$", "$K<2B(2m-BT)/(T(2m+BT))$"],
            ["$m$, $b$, $k$, $T$, $t_d$", "any", "any", "the exact boundary"],
        ],
    )
    undelayed = {d: S.Zero, B: S.Zero}
    page.step(
        "Without delay and virtual damping the second row equals the first row",
        ((b + B) / (T * (d + Rational(1, 2)))).subs(undelayed),
        2 * b / T,
        name=K,
    )
    page.step(
        "Without delay the third row equals the first row",
        (2 * b / T * tan(pi / (4 * (d + 1)))).subs(undelayed),
        2 * b / T,
        name=K,
        because="without delay the first rule is the largest passive stiffness",
    )
    page.say(
        "A multiple of $m/T^2$ is never a limit by itself: without damping no stiffness is "
        "stable. The functions of this package compute the exact boundary."
    )

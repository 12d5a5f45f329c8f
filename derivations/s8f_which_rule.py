r"""Which rule should one use, and when?

The rules of this part, beside the exact limits of this book, by what one has to know. All of them
are for a wall that pushes, $K>0$, and every one in the table is safe as it stands there.
"""

from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "Who knows the damping of the device, and nothing of mass, spring and hand, stays passive. "
        "What is passive is stable with every hand. Who knows the mass as well may go further, "
        "and then has to know the delay, too: every limit falls with it."
    )
    page.table(
        "From the plainest to the largest; $b$ is the damping of the device, and $d=t_d/T$ whole.",
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
        "Without delay and virtual damping the second row is the first",
        ((b + B) / (T * (d + Rational(1, 2)))).subs(undelayed),
        2 * b / T,
        name=K,
    )
    page.step(
        "Without delay the third row is the first",
        (2 * b / T * tan(pi / (4 * (d + 1)))).subs(undelayed),
        2 * b / T,
        name=K,
        because="there the rule is the largest that a passive wall can have",
    )
    page.say(
        "A multiple of $m/T^2$ is never a limit by itself: without damping no stiffness is stable. "
        "The exact boundary is drawn and searched by the functions of this package."
    )

"""Does the error of the linear condition rise along the boundary?

At the start of the boundary the error is negative or unbounded below. It is zero where the
boundary crosses the line. We show that the error rises and is below 2 per cent as long as the
virtual damping is not positive.
"""

from symhaptic.book.lemmas.linear_boundary import AT_REST, TOTAL, minor
from symhaptic.book.lemmas.linear_error import risen
from symhaptic.book.lemmas.linear_rays import A_1, b_1, bent
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.paper.propositions.linear_error import LATER, rises


def derive(page):
    page.say(
        "The error compares stiffnesses at the same damping. A wall on the boundary is not stable, "
        r"but all walls with less stiffness, down to $\alpha=-\gamma$, are stable. We use "
        r"coordinates whose origin is the start of the line at $\alpha=-\gamma$: $A=\alpha+\gamma$ "
        r"and $b=\beta+\delta+(d+\frac12)\gamma$."
    )
    far, high = alpha + gamma, beta + delta + (d + HALF) * gamma
    page.step(
        "The slope $b/A$ of the ray from this origin gives the error",
        (lag.line(beta, delta) - alpha) / far,
        high / ((d + HALF) * far) - 1,
        name=r"\varepsilon",
        because="therefore the error rises with $b/A$",
    )
    damped = 1 - TOTAL * s_1 + gamma * n_0
    page.step(
        "Without delay, Jury's largest minor falls with the stiffness",
        minor(0).subs(a, AT_REST).subs(e, damped),
        TOTAL * (1 - n_0 * beta) * (beta + s_1) - n_0 * (1 + n_1 * beta) * far,
        name=r"\Delta_2",
        because="because the minor falls with the stiffness, it is zero on the boundary",
    )
    page.say(
        "At the start of the line the minor is not negative, since the gap $g$ is not negative. "
        r"The minor falls with $A$ and rises with $b$, for $\beta\le0$, $b\ge-0.03$ and "
        r"stiffnesses up to $\alpha=0.72$ without delay and $\alpha=0.16$ with one period of "
        "delay. So of two walls on the boundary the one with more damping is stiffer. On a ray "
        "with $b>0$ the minor is concave, so it is positive between the start and a wall on "
        "the boundary. Therefore the ray meets the boundary once. Ball arithmetic proves the "
        "concavity with one period of delay. Without delay, a formula shows the concavity:"
    )
    page.step(
        "Without delay the minor is concave on a ray",
        -bent(0),
        -n_0 * b_1 * (TOTAL * b_1 + n_1 * A_1),
        name=r"\tfrac12\,\Delta_2''",
    )
    settle(page)


def settle(page):
    """Settle that the error rises."""
    claim = rises()
    page.state(
        "linear-error-rises",
        "inside (23), for $d=0$ and $d=1$, the error $\\varepsilon$ rises along the boundary as "
        "long as $\\beta\\le0$, and is less than 2\\,\\% there",
        claim=claim,
    )
    page.settle(
        "linear-error-rises",
        risen(),
        example={gamma: 0, delta: 0, beta: -1, LATER[1]: 0},
    )

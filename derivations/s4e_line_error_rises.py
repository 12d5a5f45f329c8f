r"""Does the error of the linear condition rise along the boundary?

It starts with a negative value, or without bound, and is zero where the boundary crosses the line.
We show that it rises as long as the virtual damping is not positive, and is below 2 per cent there.
"""

from symhaptic.book.lemmas.linear_boundary import AT_REST, TOTAL, minor
from symhaptic.book.lemmas.linear_error import risen
from symhaptic.book.lemmas.linear_rays import A_1, b_1, bent
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.paper.propositions.linear_error import LATER, rises


def derive(page):
    page.say(
        "The error compares stiffnesses at the same damping: a wall on the boundary is not "
        r"stable, while all walls of less stiffness, down to $\alpha=-\gamma$, are. We use "
        r"coordinates from the start of the line at $\alpha=-\gamma$: $A=\alpha+\gamma$ and "
        r"$b=\beta+\delta+(d+\frac12)\gamma$."
    )
    far, high = alpha + gamma, beta + delta + (d + HALF) * gamma
    page.step(
        "The error is given by the slope of the ray from there",
        (lag.line(beta, delta) - alpha) / far,
        high / ((d + HALF) * far) - 1,
        name=r"\varepsilon",
        because="it rises with $b/A$",
    )
    damped = 1 - TOTAL * s_1 + gamma * n_0
    page.step(
        "Without delay Jury's largest minor falls with the stiffness",
        minor(0).subs(a, AT_REST).subs(e, damped),
        TOTAL * (1 - n_0 * beta) * (beta + s_1) - n_0 * (1 + n_1 * beta) * far,
        name=r"\Delta_2",
        because="it falls with the stiffness, so that it is zero on the boundary",
    )
    page.say(
        r"At the start of the line the minor is not negative; that is the gap $g\ge0$ again. Up "
        r"to $\alpha=0.72$, and $\alpha=0.16$ with one period of delay, it falls with $A$ and "
        r"rises with $b\ge-0.03$, for $\beta\le0$: of two walls on the boundary the one with more "
        "damping is stiffer. On a ray with $b>0$ it is concave, so that it is positive between "
        "the start and a wall of the boundary: the ray has no other wall of the boundary. With "
        "one period of delay this is proved by ball arithmetic; without delay directly:"
    )
    page.step(
        "The minor is concave on a ray, $d=0$",
        -bent(0),
        -n_0 * b_1 * (TOTAL * b_1 + n_1 * A_1),
        name=r"\tfrac12\,\Delta_2''",
    )
    settle(page)


def settle(page):
    """The error rises."""
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

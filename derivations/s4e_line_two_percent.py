r"""From which damping on does the error exceed 2 per cent for negative $\beta$?

The paper reads such cases from its Fig. 10 for $\delta>0.015$. Near the start of the boundary they
exist for every damping, since the error is unbounded there. This chapter finds the damping from
which on there are such walls with $\alpha\ge0$.
"""

from symhaptic.book.lemmas.linear_corner import in_the_corner
from symhaptic.book.lemmas.linear_gap import narrow
from symhaptic.book.lemmas.linear_two_percent import on_either_side
from symhaptic.book.lemmas.prelude import *
from symhaptic.bounds.linear_points import error_without_stiffness
from symhaptic.paper.propositions.linear_error import THRESHOLD, error, threshold
from symhaptic.proof.ball import ball
from symhaptic.proof.enclosed import sign_change
from symhaptic.proof.roots import BITS

HALF, LEVEL = Rational(1, 2), Rational(2, 100)


def derive(page):
    page.say(
        r"While $\beta\le0$ the error rises along the boundary, and is less than $2\,\%$ "
        r"(\chapter{s4e_line_error_rises}). Some wall with $\alpha\ge0$ has an error below "
        r"$-2\,\%$ if and only if the wall at $\alpha=0$ has. There the wall of this error has"
    )
    page.step(
        "At $\\alpha=0$ an error of $-2\\,\\%$ is reached at one damping",
        (error() + LEVEL).subs(alpha, 0) * gamma * (d + HALF),
        beta + delta + LEVEL * (d + HALF) * gamma,
        name=r"(d+\tfrac12)\,\gamma\,(\varepsilon\big|_{\alpha=0}+0.02)",
        because=r"it is zero for $\beta=-\delta-0.02\,(d+\frac12)\gamma$",
    )
    page.say(
        r"In the coordinates of \chapter{s4e_line_error_rises} it lies on the ray "
        r"$b=0.98\,(d+\frac12)A$, at $A=\gamma$. On a ray Jury's minor is concave. At its start "
        "it is not negative, and hardly larger than the gap. If the minor is negative at "
        r"$A=\gamma$, it is negative for all stiffer walls of the ray, and the error of the "
        r"boundary is smaller. If it is positive, a wall of the boundary with $\alpha$ just above "
        "zero has a larger error."
    )
    page.lemma(
        "The gap $G$ is at most $\\frac1{32}\\gamma^2\\delta$",
        narrow(),
        because="$g\\,(n_1+n_0)$, for all arms up to (30)",
    )
    found = [
        (rf"\delta\big|_{{d={delay},\ \gamma={name}}}", edge(spring, delay))
        for delay in (0, 1)
        for spring, name in ((S.Zero, "0"), (STIFF, "0.001"))
    ]
    page.enclosed("The error at $\\alpha=0$ is $-2\\,\\%$ at these dampings", found, places=22)
    own(page)
    papers(page)


def own(page):
    """The thresholds for the spring of Fig. 10."""
    claim = threshold()
    theorem = on_either_side()
    page.state(
        "linear-two-percent",
        "for $\\gamma=0.001$ the error exceeds 2\\,\\% for a wall of the boundary with "
        "$\\alpha\\ge0$, $\\beta<0$ at all $\\delta\\ge0.01744$ and at no $\\delta\\le0.01743$ for "
        "$d=0$, at all $\\delta\\ge0.01481$ and at no $\\delta\\le0.01480$ for $d=1$",
        claim=claim,
    )
    page.settle(
        "linear-two-percent",
        theorem,
        example={delta: DAMPED},
        note="without a spring the damping is slightly larger",
    )


def papers(page):
    """Beside the spring of Fig. 10, for each damping beyond 0.015."""
    found = inst(in_the_corner(), {gamma: STIFF})
    known = [fact(h) for h in found.hypotheses if not h.free]
    damped = positive(delta > 0, delta > THRESHOLD, [THRESHOLD])
    every = closed(found, *known, damped, positive(delta >= 0, [damped]))
    page.settle(
        "s4e-two-percent",
        every,
        example={delta: DAMPED},
        note=r"0.015 is not a threshold: inside (23) such walls exist for every $\gamma\delta>0$ "
        r"(linear-error-corner), next to the corner at $\alpha=-\gamma$; with $\alpha\ge0$ "
        r"they exist from $\delta=0.01481$ on for $d=1$ and from $0.01744$ on for $d=0$ "
        "(linear-two-percent)",
    )


def edge(spring, delay):
    """The damping at which the error at alpha = 0 is -2 per cent."""
    level = ball(LEVEL, None, BITS).real
    return sign_change(
        lambda damping: error_without_stiffness(spring, damping, delay) + level,
        Rational(14, 1000),
        Rational(18, 1000),
    )

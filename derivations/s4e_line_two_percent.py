r"""Above which damping does the error exceed 2 per cent for negative $\beta$?

The paper concludes from its Fig. 10 that the error exceeds 2 per cent for $\delta>0.015$. Near the
start of the boundary, walls with a larger error exist for every damping, since the error is
unbounded there. This chapter finds the damping above which walls with $\alpha\ge0$ have such an
error.
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
        r"As long as $\beta\le0$, the error rises along the boundary and is less than $2\,\%$ "
        r"(\chapter{s4e_line_error_rises}). So some wall with $\alpha\ge0$ has an error below "
        r"$-2\,\%$ if and only if the wall on the boundary with $\alpha=0$ has one. We compute "
        r"the damping of a wall with $\alpha=0$ and an error of $-2\,\%$:"
    )
    page.step(
        r"At $\alpha=0$ one virtual damping gives an error of $-2\,\%$",
        (error() + LEVEL).subs(alpha, 0) * gamma * (d + HALF),
        beta + delta + LEVEL * (d + HALF) * gamma,
        name=r"(d+\tfrac12)\,\gamma\,(\varepsilon\big|_{\alpha=0}+0.02)",
        because=r"the sum is zero for $\beta=-\delta-0.02\,(d+\frac12)\gamma$",
    )
    page.say(
        r"In the coordinates $A$, $b$ of \chapter{s4e_line_error_rises} this wall lies on the ray "
        r"$b=0.98\,(d+\frac12)A$, at $A=\gamma$. On a ray Jury's minor is concave. At the start "
        "of the ray the minor is not negative, and hardly larger than the gap. If the minor is "
        r"negative at $A=\gamma$, it is negative for all stiffer walls on the ray, and the error "
        "on the boundary is smaller than on the ray. If the minor is positive, a wall on the "
        r"boundary with $\alpha$ just above zero has a larger error."
    )
    page.lemma(
        "The gap $G$ is at most $\\frac1{32}\\gamma^2\\delta$",
        narrow(),
        because=r"here $G=g\,(n_1+n_0)$, and the bound holds for all arms that satisfy (30)",
    )
    found = [
        (rf"\delta\big|_{{d={delay},\ \gamma={name}}}", edge(spring, delay))
        for delay in (0, 1)
        for spring, name in ((S.Zero, "0"), (STIFF, "0.001"))
    ]
    page.enclosed(
        r"Intervals contain the dampings $\delta$ at which the error at $\alpha=0$ is "
        r"$-2\,\%$",
        found,
        places=22,
    )
    own(page)
    papers(page)


def own(page):
    """The thresholds for the spring of Fig. 10."""
    claim = threshold()
    theorem = on_either_side()
    page.state(
        "linear-two-percent",
        r"for $\gamma=0.001$ some wall on the boundary with $\alpha\ge0$ and $\beta<0$ has an "
        r"error of more than 2\,\%: for $d=0$ at all $\delta\ge0.01744$ and at no "
        r"$\delta\le0.01743$, and for $d=1$ at all $\delta\ge0.01481$ and at no $\delta\le0.01480$",
        claim=claim,
    )
    page.settle(
        "linear-two-percent",
        theorem,
        example={delta: DAMPED},
        note="without a spring this damping is slightly larger",
    )


def papers(page):
    """With the spring of Fig. 10, walls with such an error exist for each damping above 0.015."""
    found = inst(in_the_corner(), {gamma: STIFF})
    known = [fact(h) for h in found.hypotheses if not h.free]
    damped = positive(delta > 0, delta > THRESHOLD, [THRESHOLD])
    every = closed(found, *known, damped, positive(delta >= 0, [damped]))
    page.settle(
        "s4e-two-percent",
        every,
        example={delta: DAMPED},
        note=r"the damping 0.015 is not a threshold. For every arm of (23) with $\gamma\delta>0$, "
        r"walls with such an error exist next to the corner at $\alpha=-\gamma$ "
        r"(\texttt{linear-error-corner}). With $\alpha\ge0$ they exist for $\delta\ge0.01481$ if "
        r"$d=1$ and for $\delta\ge0.01744$ if $d=0$ (\texttt{linear-two-percent})",
    )


def edge(spring, delay):
    """The damping at which the error at alpha = 0 is -2 per cent."""
    level = ball(LEVEL, None, BITS).real
    return sign_change(
        lambda damping: error_without_stiffness(spring, damping, delay) + level,
        Rational(14, 1000),
        Rational(18, 1000),
    )

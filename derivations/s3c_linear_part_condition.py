"""For which walls is the stiffness limited by damping over delay?

On the straight lower part of the boundary, the stiffness is the total damping divided by the total
delay. The total delay includes half a period for the hold. We ask for which damping this bound of
the stiffness is exact.
"""

from symhaptic.book.lemmas.linear_part import LOW, at_corner, decides
from symhaptic.book.lemmas.motions import HALF_LATE, STEPS
from symhaptic.book.lemmas.prelude import *


def derive(page):
    line = b + B - K * T * (d + Rational(1, 2))
    page.say(
        r"By \chapter{s3c_linear_part} the margin $b-b_{\min}(\theta)$ of a wall tends to "
        r"$F=b+B-(d+\frac12)KT$ for $\theta\to0$. The line is $F=0$."
    )
    limit_of_k = page.step(
        "Solved for the stiffness, the equation of the line is the total damping divided by the "
        "total delay",
        (b + B) / (T * (d + Rational(1, 2))),
        2 * (b + B) / (T * (2 * d + 1)),
        name=r"\frac{b+B}{(d+\frac12)T}",
        paper="9",
    )
    page.step(
        "On the line, (9) and (10) hold with equality",
        line.subs(K, limit_of_k),
        S.Zero,
        name=r"F\big|_{K=(b+B)/((d+1/2)T)}",
    )
    page.say(
        "For damping in the range of (9), the condition is strictest at low frequencies, and "
        "(9) is exact except for equality. The condition (9) does not apply to negative $K$, "
        "because (5) can then fail at higher frequencies."
    )
    _condition(page, limit_of_k > K)


def _condition(page, nine):
    """In its range of damping (9), and (10) in words, is equivalent to passivity."""
    enough, needed = decides()
    page.lemma(
        "The condition is sufficient for damping in the range of (9)",
        enough,
        because=r"the wall on the line with the damping $B$ is passive by "
        r"\chapter{s3c_linear_part}, and so is the wall with $K=0$. The margin is linear in $K$, "
        "so no wall between them has a negative margin",
    )
    page.lemma(
        "The condition is necessary for any damping",
        needed,
        because="a passive wall has no negative margin at any angle, so its limit $F$ is not "
        "negative either",
    )
    border = Ne(K, LOW)
    late = {K: S.One, B: S.Zero, b: Rational(101, 100), T: S.One, d: S.Half}
    pulled = {K: -S(3), B: S.Zero, b: S.One, T: S.One, d: S.One}
    edge = {K: S(2), B: S.Zero, b: S.One, T: S.One, d: S.Zero}
    easy = {K: S.One, B: S.Zero, b: S.One, T: S.One, d: S.Zero}
    cases = [(late, HALF_LATE, whole(d)), (pulled, STEPS, K >= 0), (edge, None, border)]
    for id in ("eq9", "eq10"):
        then = taken_apart(page.claim(id))[2]
        page.settle(
            id,
            either_way(enough, needed, *then.of),
            nine,
            example=easy,
            unless={but: (at, not_alike(then, at, motion)) for at, motion, but in cases},
            shows=r"with a delay of half a period, $K=b/(1.01\,T)$ meets the condition and "
            "delivers energy",
            note=NOTES[id],
        )


NOTES = {
    "eq9": r"walls with equality in (9) satisfy (5), too, because (5) excludes $\omega=0$; the "
    "only exception is $d=0$, $B=0$",
    "eq10": "we read (10) with the range of damping of (9); for more damping (10) is only "
    r"necessary (\texttt{rules:damping-over-delay})",
}


def not_alike(same, point, motion):
    """At this point (9) and passivity disagree."""
    there = same.at(point)
    nine, passive = there.of
    if motion is None:
        held = mp(assume(there), at_corner(STATEMENTS["eq8"].printed, point))
        return not_intro(held, number(negated(nine)), there)
    met = number(nine)
    return not_intro(mp(assume(there), met), gains(list(passive.of), motion), there)

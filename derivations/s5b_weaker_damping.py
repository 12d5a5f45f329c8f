r"""Is the difference between passive and stable walls larger for smaller damping?

The paper says that the passive region shrinks in proportion to $\delta$, and that the stable region
hardly changes. In terms of the largest stiffness the question is whether the ratio $\eta$ of the
passive to the stable stiffness grows with $\delta$.
"""

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.weaker_damping import (
    DAMPERS,
    FAR,
    SHORT,
    further,
    nearer,
    not_short,
    step_by_step,
    steps,
)
from symhaptic.paper.propositions.stability import HEAVIER


def derive(page):
    page.say(
        r"The largest passive stiffness is proportional to $\delta$. For $d=0$ and $d=1$ two "
        "linear functions of the damping bound the largest stable stiffness on all of (23), one "
        "from each side. The two functions are so close that they decide the question for "
        r"dampings that differ by 2\,\%:"
    )
    page.lemma(
        r"For $d=0$ and $d=1$ the ratio $\eta$ is larger for a damping that is 2\,\% larger",
        further(),
        because=r"some number $\varrho$ lies between the two ratios",
    )
    page.say(
        "For the other integer delays of Fig. 11 walls next to the tips compare each of the "
        "dampings " + ", ".join(f"${float(v):g}$" for v in DAMPERS) + " with the next one:"
    )
    page.state(
        "weaker-damping",
        r"for $d\in\{2,4,8\}$, $\gamma=0$ and $\gamma=0.001$ the ratio $\eta$ grows from each of "
        r"the dampings 0.005, 0.01, 0.015, 0.02 to the next",
        claim=steps(),
    )
    page.settle("weaker-damping", step_by_step())
    page.say("For long delays the opposite is true. An example is $d=200$ without a spring:")
    page.lemma(
        "At $d=200$, $\\delta=0.01$ the stable walls have $\\alpha<0.00007843$",
        none_above((FAR[gamma], FAR[delta]), 200)[1],
        because="the bound follows from the inequality at one point of the circle "
        r"(\chapter{s5b_stiffest_wall})",
    )
    then = taken_apart(page.claim("s5a-smaller-delta"))[2]
    point = {gamma: S.Zero, delta: Rational(1, 100), HEAVIER: Rational(1, 50), d: S.Zero}
    short = SHORT.at(point)
    undelayed = disj(conj(*(number(p) for p in short.of[0].of)), short)
    page.settle(
        "s5a-smaller-delta",
        further(),
        example=(point, undelayed),
        unless={SHORT: (FAR, nearer(then.at(FAR)), not_short())},
        shows=r"at $d=200$ the two stiffnesses differ by 0.4\% for $\delta=0.01$ and by 1.4\% for "
        r"$0.02$",
        note="the statement is about the largest stiffness and integer delays. For "
        r"$d\in\{2,4,8\}$ four dampings are compared (\texttt{weaker-damping}); smaller "
        "differences are undecided",
    )

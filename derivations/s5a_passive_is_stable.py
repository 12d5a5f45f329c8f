r"""Is a passive wall stable, whatever the delay?

Passivity looks at energy, stability at roots. Both conditions have the delay in them, but at a
root on the unit circle it drops out of the comparison, and the device alone decides.
"""

from sympy import Rational, S, pi

from symhaptic.book.figures.arguments import sides
from symhaptic.book.lemmas.passive_is_stable import (
    DEVICE,
    no_crossing,
    passive_is_stable,
)
from symhaptic.book.lemmas.walls import LATE, fractional_sums, margins, met, unstable
from symhaptic.notation import F, alpha, beta, d, delta, gamma, p_k, theta, v, x
from symhaptic.notation.proposition import whole
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.proof.theorems.familiar import held_steady_state
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import assume, cut, part, weakened
from symhaptic.proof.theorems.tactics import (
    counterexample,
    example,
    for_all,
)


def derive(page):
    page.say(
        "In units of mass and period let $P=N/A$ be the sampled device, $A=z^2-az+e$ and "
        "$N=n_1z+n_0$, and $W(z)=(\\alpha+\\beta(1-1/z))z^{-d}$ the wall with its delay. A root "
        "of the loop has $1+PW=0$, so there the wall is $W=-1/P$, and the margin of passivity, "
        "$\\delta+\\Re\\{W/(z-1)\\}$, becomes $\\delta-\\Re\\{1/((z-1)P)\\}$: delay, $\\alpha$ "
        "and $\\beta$ have dropped out. Let a held force $F$ drive the device in a steady state "
        "that turns by $z=e^{j\\theta}$ per period."
    )
    page.step(
        "Work is stored or burnt",
        v * (F - delta * v - gamma * x) + gamma * x * v,
        F * v - delta * v**2,
        name=r"\tfrac{d}{dt}\,\tfrac12(v^2+\gamma x^2)",
        because="Newton's law is $\\dot v=F-\\delta v-\\gamma x$, and $\\dot x=v$",
    )
    page.step(
        "A given way costs the damper least at constant speed",
        v**2,
        (v - p_k) ** 2 + 2 * v * p_k - p_k**2,
        because="over one period the last two terms integrate to $p_k^2$",
    )
    page.lemma(
        "A held force that turns by $z$ does more work than the way alone would burn",
        held_steady_state(assume(DEVICE), theta),
        because="the stored energy is the same after each period, and the speed is not constant "
        "where $z\\ne1$",
    )
    page.say(
        "Divided by $|(z-1)N|^2$ this is $\\delta<\\Re\\{1/((z-1)P)\\}$. Now take a wall that "
        "meets (5) and turn it up from nothing to $yW$, $0<y\\le1$. A root of the loop at "
        "$e^{j\\theta}$ has $1/P=-yW$, so that $\\delta+y\\Re\\{W/(z-1)\\}<0$. But that is "
        "$(1-y)\\delta$ and $y$ times the margin, and neither is negative."
    )
    page.lemma("No root crosses the circle while the wall is turned up", no_crossing())
    page.figure(
        "sides",
        "Upper half circle: where a root is on it, wall and device meet. The device stays on the "
        "left of $-\\delta$, and a passive wall on its right, however far it is turned up "
        "($\\gamma=0.05$, $\\delta=0.4$, one period of delay).",
        sides,
        height=0.5,
    )
    page.lemma(
        "A wall with a margin at every angle is stable with every spring and damper",
        passive_is_stable(),
        because="zeros are continuous in the coefficients. Without a wall those of a damped and "
        "held device lie inside; without a spring one lies at 1, and the first stiffness moves it "
        "inwards",
        boxed=True,
    )
    _subset(page)


def _subset(page):
    claim = CLAIMED["s5a-subset"](())
    symbols, given, _ = taken_apart(claim)
    extra = [delta > 0, alpha + gamma > 0, whole(d)]
    found = cut(part(passive_is_stable(), STABLE), margins(given[-1]))
    theorem = for_all(symbols, [*given, *extra], weakened(found, *given))

    easy = {alpha: S.One, beta: S.Zero, gamma: S.Zero, delta: S.One, d: S.Zero}
    late = easy | LATE
    pulled = easy | {alpha: -S.Half}
    swing = easy | {alpha: -S.Half, gamma: 4 * pi**2, delta: S.Zero}
    page.say(
        "Each condition is needed. A delay of half a period turns (18) into a polynomial in "
        "$\\sqrt z$ by the paper's substitution, with roots on its second sheet; a wall that "
        "pulls more than the spring holds runs away; and without a damper a spring with "
        "$\\gamma=4\\pi^2$ swings once per period, unseen."
    )
    page.settle(
        "s5a-subset",
        theorem,
        example=example(easy, [*given, *extra], met(easy, [S.Half])),
        unless=[
            counterexample(
                claim,
                pulled,
                *(met(pulled, [Rational(5, 4)]), unstable(pulled)),
                holds=[delta > 0, whole(d)],
                but=alpha + gamma > 0,
            ),
            counterexample(
                claim,
                swing,
                *(met(swing, [Rational(1, 4)]), unstable(swing)),
                holds=[alpha + gamma > 0, whole(d)],
                but=delta > 0,
            ),
            counterexample(
                claim,
                late,
                *(met(late, *fractional_sums()), unstable(late)),
                holds=[delta > 0, alpha + gamma > 0],
                but=whole(d),
            ),
        ],
        shows=r"a pulling wall without a spring satisfies (5), but $p_1(1)<0$",
        note="by the energy of the steady state, for all $\\gamma\\ge0$ together; a pulling wall "
        "is included as long as the spring holds it",
    )

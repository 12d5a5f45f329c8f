"""Is a wall stable if its stiffness is below the damping over the delay?

This bound is the linear condition, the simplest rule for a loop with a delay. In this rule the
hold adds half a period to $t_d$, and virtual damping counts like the damping of the device. We ask
up to which virtual damping the rule is safe.
"""

from symhaptic.book.lemmas.circulation import damping_over_delay, outside
from symhaptic.book.lemmas.prelude import *

RULE = "rules:damping-over-delay"
RANGE = b * d / (2 * d + 3) >= B


def derive(page):
    given = taken_apart(page.claim(RULE))[1]
    found = page.lemma(
        "With little virtual damping a wall that satisfies the rule is stable with every spring",
        damping_over_delay(given[-1]),
        because="with little virtual damping, the passivity condition is strictest at low "
        "frequencies, and the rule gives a margin there",
        boxed=True,
    )
    page.say(
        "More virtual damping raises the bound of the rule, but not the stable stiffness. "
        "Without delay and with $m=T=b=1$ the rule allows $K<8$ for $B=3$, but with this $B$ "
        "not even $K=1$ is stable."
    )
    wall = {K: S.One, T: S.One, m: S.One, b: S.One, k: S.Zero, d: S.Zero}
    braked = {alpha: S.One, beta: S(3), gamma: S.Zero, delta: S.One, d: S.Zero}
    page.lemma(
        "Without delay and with $m=T=b=1$, the wall $K=1$, $B=3$ is not stable", outside(braked)
    )
    page.settle(
        RULE,
        found,
        example=wall | {B: -Rational(1, 10)},
        unless={RANGE: (wall | {B: S(3)}, outside(braked))},
        shows="for $m=T=b=1$ without delay, the rule allows $K<8$ with $B=3$, but $K=1$ is "
        "unstable",
        note="in this range of $B$ the walls are passive, and stable with every mass and every "
        r"arm; without delay the range is $B\le0$",
    )

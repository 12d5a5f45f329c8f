"""Is a wall stable if its stiffness is at most twice the damping over the period?

Colgate and Schenkel derived this passivity limit for a wall without virtual damping and delay.
Some designers also use it as a rule for walls with a delay. We ask for which walls it is safe.
"""

from symhaptic.book.lemmas.circulation import outside, twice_the_damping
from symhaptic.book.lemmas.prelude import *

RULE = "rules:twice-damping"


def derive(page):
    given = taken_apart(page.claim(RULE))[1]
    found = page.lemma(
        r"Without delay a wall with $K\le2b/T$ and $B=0$ is stable with every mass and every "
        "spring",
        twice_the_damping(given[-1]),
        because="the margin of passivity is $b-\\frac12KT$ at every angle, and a passive wall is "
        "stable",
        boxed=True,
    )
    page.say(
        r"With one period of delay the passive limit is 41\,\% of $2b/T$. With $m=T=1$, "
        r"$b=\frac12$ and one period of delay the wall $K=1$ is not even stable."
    )
    still = {B: S.Zero, k: S.Zero, T: S.One, m: S.One, K: S.One, b: S.Half}
    late = {alpha: S.One, beta: S.Zero, gamma: S.Zero, delta: S.Half, d: S.One}
    page.lemma(
        r"With one period of delay, $b=\frac12$ and $m=T=1$, the wall $K=1$ is not stable",
        outside(late),
    )
    page.settle(
        RULE,
        found,
        example=still | {d: S.Zero},
        unless={Eq(d, 0): (still | {d: S.One}, outside(late))},
        shows=r"for $m=T=1$ and $b=\tfrac12$, the wall $K=2b/T$ is unstable with one period of "
        "delay",
        note="without delay the walls of the rule are passive, and stable with every mass and "
        "every arm",
    )

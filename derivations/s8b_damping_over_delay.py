r"""Is a wall stable whose stiffness is below the damping over the delay?

Half a period of hold and the delay $t_d$ cost as much as the dampers of device and wall can pay:
this is the linear condition, and the plainest rule for a loop with a delay. It counts virtual
damping like that of the device. How much of it may be put in?
"""

from symhaptic.book.lemmas.circulation import damping_over_delay, outside
from symhaptic.book.lemmas.prelude import *

RULE = "rules:damping-over-delay"
RANGE = b * d / (2 * d + 3) >= B


def derive(page):
    given = taken_apart(page.claim(RULE))[1]
    found = page.lemma(
        "With little virtual damping a wall below the rule is stable beside every spring",
        damping_over_delay(given[-1]),
        because="low frequencies are then the strictest for a passive wall, and leave a margin",
        boxed=True,
    )
    page.say(
        "More virtual damping raises the bound, but not what is stable: without delay and with "
        "$m=T=b=1$ the rule allows $K<8$ beside $B=3$, where not even $K=1$ is stable."
    )
    wall = {K: S.One, T: S.One, m: S.One, b: S.One, k: S.Zero, d: S.Zero}
    braked = {alpha: S.One, beta: S(3), gamma: S.Zero, delta: S.One, d: S.Zero}
    page.lemma("Without delay the wall $K=1$, $B=3$ of $m=T=b=1$ is not stable", outside(braked))
    page.settle(
        RULE,
        found,
        example=wall | {B: -Rational(1, 10)},
        unless={RANGE: (wall | {B: S(3)}, outside(braked))},
        shows="$m=T=b=1$ without delay: $B=3$ allows $K<8$, and $K=1$ is unstable",
        note="in this range of $B$ the walls are passive, and safe for every mass and every hand; "
        "without delay that is $B\\le0$",
    )

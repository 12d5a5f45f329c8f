r"""Does the ratio of passive to stable stiffness grow with the delay until it is one?

So says the paper of $\eta$ in Fig. 12, for $\delta=0.02$ without a spring and with $\gamma=0.001$.
Every whole delay is asked here, for the arm with the spring.
"""

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.outweighed import stable_behind_every_delay
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import PEAK, SPRUNG, elsewhere, instead, near_one, never_met


def derive(page):
    page.say("One wall is stable behind all delays:")
    page.lemma(
        "The wall $\\alpha=0.00059$, $\\beta=0$ is stable behind every whole delay",
        stable_behind_every_delay(),
        because="all around the circle the plant outweighs it: $|A|^2-\\alpha^2|N|^2$ has no zero "
        "in $y=4\\sin^2\\frac\\theta2$",
    )
    page.say(
        "Behind shorter delays take a wall next to the tip. How near it is says one point of the "
        "circle: of a polynomial $p$ of degree $n$ with its zeros inside, "
        "$n|p|^2<2\\Re\\bar p\\,zp'$ there. At the angle of the tip that is false for all stiffer "
        "walls:"
    )
    page.lemma(
        "Behind 40 periods the stable walls have $\\alpha<0.000766483$", none_above(SPRUNG, PEAK)[1]
    )
    page.lemma(
        "Behind every whole delay but 40 $\\eta$ is less than $0.9998$",
        elsewhere(),
        because="by a wall for each delay up to 67; beyond, passive walls have "
        "$\\alpha(d+1)\\le2\\delta$, by the slow angles",
    )
    _, [springs], then = taken_apart(page.claim("s5b-eta-grows"))
    point = {gamma: STIFF}
    sprung = disj(identity(STIFF, STIFF), springs.at(point))
    page.settle(
        "s5b-eta-grows",
        near_one(),
        instead=instead(),
        corrected=(
            r"\eta(d)<0.9998<\eta(40)<1\ \text{for}\ \gamma=0.001,\ d\ne40",
            r"\eta(1000)<0.91<0.9999<\eta(122)\ \text{for}\ \gamma=0",
        ),
        misprint=False,
        unless=[(point, sprung, never_met(then.at(point)))],
        shows=r"with the spring, and behind every whole delay, some stable wall is stiffer than "
        r"all passive ones; and $\eta$ falls again, without a spring from more than 0.9999 at "
        r"$d=122$ to less than 0.91 at $d=1000$",
        note="of whole delays; read as one in print, which 0.9998 is, it is reached; up to there "
        "$\\eta$ grows between the delays of Fig. 12. With one $\\delta$ for passivity and "
        "stability; for a held device $\\eta\\le b_D/(b_D+b_H)$ (\\texttt{one-delta})",
    )

r"""Does the ratio of passive to stable stiffness grow with the delay until it is one?

The paper says this of $\eta$ in Fig. 12, for $\delta=0.02$ without a spring and with
$\gamma=0.001$. We check every integer delay, for the arm with the spring.
"""

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.outweighed import stable_behind_every_delay
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import PEAK, SPRUNG, elsewhere, instead, near_one, never_met


def derive(page):
    page.say("One wall is stable with every delay:")
    page.lemma(
        r"The wall $\alpha=0.00059$, $\beta=0$ is stable with every integer delay",
        stable_behind_every_delay(),
        because="the plant dominates on the whole circle: as a polynomial in "
        r"$y=4\sin^2\frac\theta2$, $|A|^2-\alpha^2|N|^2$ has no zero for $0\le y\le4$",
    )
    page.say(
        "For shorter delays, take a wall next to the tip. One point $z$ of the circle bounds the "
        "distance of this wall from the tip: a polynomial $p$ of degree $n$ with all zeros "
        r"inside satisfies $n|p|^2<2\Re\bar p\,zp'$ at $z$. At the angle of the tip this "
        "inequality is false for all stiffer walls:"
    )
    page.lemma(
        r"With a delay of 40 periods the stable walls have $\alpha<0.000766483$",
        none_above(SPRUNG, PEAK)[1],
    )
    page.lemma(
        r"The ratio $\eta$ is less than $0.9998$ for every integer delay except 40",
        elsewhere(),
        because="for each delay up to 67, one stable wall shows this; for longer delays, passive "
        r"walls have $\alpha(d+1)\le2\delta$ by the condition at low frequencies",
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
        shows="with the spring, and with every integer delay, some stable wall is stiffer than all "
        r"passive ones; and $\eta$ falls again, without a spring from more than 0.9999 at "
        "$d=122$ to less than 0.91 at $d=1000$",
        note="the statement is proved for integer delays. Rounded to three digits, 0.9998 is 1. "
        r"Up to $d=40$, the ratio $\eta$ grows from each delay of Fig. 12 to the next. The same "
        r"$\delta$ is used for passivity and stability; for a device with an arm $\eta\le "
        r"b_D/(b_D+b_H)$ (\texttt{one-delta})",
    )

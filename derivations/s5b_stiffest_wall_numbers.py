r"""How much stiffer than a passive wall can a stable one be?

The paper gives the ratio of the largest stable to the largest passive stiffness for $d=1$ and
draws its inverse $\eta$ in Fig. 12. With \chapter{s5b_stiffest_wall_bound} each value is the
maximum of an explicit function, and balls enclose it.
"""

from sympy import Rational, S, pi

from symhaptic.book.lemmas.outweighed import LATE as LASTING
from symhaptic.book.lemmas.outweighed import stable_behind_every_delay
from symhaptic.book.lemmas.stiffest_stable import stable_wall
from symhaptic.book.lemmas.stiffness_claims import LATE, of_ratio
from symhaptic.bounds.walls import most, over, passive
from symhaptic.model import passivity
from symhaptic.notation import K, T, alpha, d, delta, gamma, theta
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import DAMPED, RANGES, STIFF
from symhaptic.proof.ball import bound
from symhaptic.proof.roots import decimals
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.tactics import example

PLAIN = (1, 2, 5, 10, 20, 40, 100, 122, 200, 500, 1000)


def derive(page):
    whole = passivity.dirichlet_form().subs({K: alpha, T: S.One}).subs(theta, pi / (2 * (d + 1)))
    page.step(
        "The stiffness (11) needs all of the damping",
        whole.subs(alpha, passive(delta, d)),
        delta,
        name=r"\text{damping needed by}\ \alpha=2\delta\tan\tfrac{\pi}{4(d+1)}",
    )
    page.lemma(
        "Inside (23) and one period late a wall with $\\alpha=0.142+0.614\\delta$ is stable",
        stable_wall(1, LATE, RANGES),
        because="so the stiffest one has more than 9.31 times $2\\delta\\tan\\frac\\pi8$; "
        "$1/0.1074=9.310\\ldots$ is more than 9.3",
    )
    corner, plain = (ratio(stiffness, DAMPED, 1) for stiffness in (STIFF, S.Zero))
    beyond = ratio(S.Zero, Rational(202, 10000), 1)
    page.enclosed(
        "The ratio of both stiffnesses is enclosed",
        [
            (rf"\frac{{\alpha_{{\max}}}}{{2\delta\tan(\pi/8)}}\Big|_{{{arm}}}", value)
            for arm, value in (
                (r"\gamma=0.001,\ \delta=0.02", corner),
                (r"\gamma=0,\ \delta=0.02", plain),
                (r"\gamma=0,\ \delta=0.0202", beyond),
            )
        ],
        because="9.3 is cut from the first, 0.1074 its inverse rounded up; both fail a little "
        "beyond the range",
    )
    claim = CLAIMED["s5b-eta-d1"](())
    page.settle(
        "s5b-eta-d1",
        of_ratio(claim, 1, LATE),
        example=example({gamma: S.Zero, delta: DAMPED}, taken_apart(claim)[1]),
        enclosed=True,
        value=(corner, over(S.One, corner)),
        note=r"both hold on all of (23); the numbers are those of its corner "
        r"$\gamma=0.001$, $\delta=0.02$",
    )
    table(page)


def ratio(stiffness, damping, delay):
    """Largest stable over largest passive stiffness."""
    return over(most(stiffness, damping, delay), passive(damping, delay))


def table(page):
    """Fig. 12 in numbers."""
    page.say(
        "Fig. 12 has $\\delta=0.02$. With the spring the maximum is known up to $d=48$. Beyond we "
        "take a wall that is stable for all delays:"
    )
    page.lemma(
        "For $\\gamma=0.001$, $\\delta=0.02$ the wall $\\alpha=0.00059$, $\\beta=0$ is stable for "
        "every whole delay",
        stable_behind_every_delay(),
        because="so it bounds $\\eta$",
    )
    rows = []
    for delay in (0, *PLAIN):
        cells = [decimals(over(S.One, ratio(S.Zero, DAMPED, delay)).ball, 20)]
        if delay <= 48:
            cells.append(decimals(over(S.One, ratio(STIFF, DAMPED, delay)).ball, 20))
        else:
            high = over(passive(DAMPED, delay), LASTING)
            cells.append(f"$<{bound(high.ball, above=True)}$")
        rows.append([delay, *cells])
    head = ["$d$", r"$\eta$ for $\gamma=0$", r"$\eta$ for $\gamma=0.001$"]
    page.table("Largest passive over largest stable stiffness, decimals cut off.", head, rows)

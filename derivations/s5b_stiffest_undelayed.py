r"""How stiff can the wall be without delay, and how does that compare with passivity?

Without delay the loop is a cubic, with an arm's spring too. Its largest stable stiffness has a
closed form, and the paper's first ratio, 17.8 for $d=0$, is decided on the whole range (23).
"""

from sympy import Rational, S, sqrt

from symhaptic.book.lemmas.stiffest_stable import no_stiffer, stable_wall
from symhaptic.book.lemmas.stiffness_claims import UNDELAYED, of_ratio
from symhaptic.book.lemmas.undelayed_stiffness import (
    LARGEST,
    SOFT,
    all_softer_reach,
    none_reaches,
)
from symhaptic.bounds.walls import most, over, passive
from symhaptic.model import boundary, jury, plant
from symhaptic.notation import a, alpha, beta, delta, e, gamma, n_0, n_1, s_1, w
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import RANGES
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.tactics import example

RISE = n_1 + n_0


def derive(page):
    minor = jury.criterion(jury.coefficients(0)).expressions[-1]
    arm = {a: 1 + e - gamma * RISE}
    page.say(
        "Jury's inequalities for $d=0$ are $p_1(1)>0$, $c_1>0$, $c_3=-p_1(-1)>0$ and $\\Delta_2>0$ "
        "(\\chapter{s4d_jury_counted}). With $1-a+e=\\gamma(n_1+n_0)$ and the damping "
        "$s_1=(1-e+\\gamma n_0)/(n_1+n_0)$ of the arm near $z=1$:"
    )
    loss = RISE * s_1 - gamma * n_0
    split = RISE * (1 - n_0 * beta) * (beta + s_1) - n_0 * (1 + n_1 * beta) * (alpha + gamma)
    page.step(
        "The minor has two products", minor.subs(arm).subs(e, 1 - loss), split, name=r"\Delta_2"
    )
    reached(page, minor.subs(arm))
    ratio(page)


def reached(page, minor):
    """The largest stiffness, which every stiffness below reaches."""
    root = sqrt(n_0 * (n_0 + e * n_1 - gamma * n_0 * n_1))
    page.define("The stiffness below is given by a root of the arm's numbers", w, root)
    page.step(
        "The minor is a margin less a square",
        minor,
        n_0 * (1 + n_1 * beta) * (LARGEST - alpha)
        - RISE * (n_0 * (1 + n_1 * beta) - w) ** 2 / (n_0 * n_1**2),
        name=r"\Delta_2",
        because="a stable wall has $1+n_1\\beta>0$",
    )
    page.lemma(
        "Without delay and with a soft spring no stable wall reaches this stiffness",
        none_reaches(SOFT),
        because="for either root $w$; the positive one bounds more",
    )
    page.lemma(
        "Without delay and with a soft spring every smaller stiffness is stable with one damping",
        all_softer_reach(SOFT),
        because="at $n_0(1+n_1\\beta)=w$ the square vanishes, and the other inequalities hold",
    )
    device = plant.Sampled(n_1, n_0, 1 + e - gamma * RISE, e)
    page.step(
        "The largest stable stiffness without delay has a closed form",
        boundary.largest_undelayed(device),
        LARGEST,
        name=r"\alpha_{\max}(0)",
        because="for every spring up to ten times and every damper up to five times the largest of "
        "the paper's range (23); $\\alpha_{\\max}$ itself is never stable",
        boxed=True,
    )


def ratio(page):
    """The first of the paper's ratios."""
    page.say(
        "The largest passive stiffness without delay is $\\alpha=2\\delta$, by (11). On the range "
        "of the paper:"
    )
    page.lemma(
        "Inside (23) and without delay a wall with $\\alpha=0.68+1.604\\delta$ is stable",
        stable_wall(0, UNDELAYED, RANGES),
        because="so the stiffest one has more than 17.8 times $2\\delta$, $\\eta<1/17.8<0.0562$; "
        "at $\\delta=0$ no stiffness is passive at all",
    )
    page.lemma(
        "Inside (23) and without delay all stable walls have $\\alpha<0.72$",
        no_stiffer(0, (Rational(72, 100), Rational(83, 100)), RANGES),
    )
    end = Rational(1, 50)
    plants = [(Rational(1, 1000), end), (S.Zero, end), (S.Zero, Rational(201, 10000))]
    ratios = [over(most(*arm, 0), passive(arm[1], 0)) for arm in plants]
    names = [
        rf"\frac{{\alpha_{{\max}}}}{{2\delta}}\Big|_{{\gamma={g},\ \delta={v}}}"
        for g, v in (("0.001", 0.02), (0, 0.02), (0, 0.0201))
    ]
    page.enclosed(
        "The ratio is 17.8 and a little more",
        list(zip(names, ratios, strict=True)),
        because="17.8 is cut from these, 0.0562 is the inverse of the first, rounded up (that of "
        "the second is below 0.0561); just beyond the range 17.8 is too much",
    )
    claim = CLAIMED["s5b-eta-d0"](())
    page.settle(
        "s5b-eta-d0",
        of_ratio(claim, 0, UNDELAYED),
        example=example({gamma: S.Zero, delta: end}, taken_apart(claim)[1]),
        enclosed=True,
        value=(ratios[0], over(S.One, ratios[0])),
        note=r"both hold on all of (23); the numbers are those of its corner "
        r"$\gamma=0.001$, $\delta=0.02$",
    )

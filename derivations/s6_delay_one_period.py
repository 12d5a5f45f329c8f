r"""How much stiffness does one period of delay leave?

The conclusion of the paper has less than 22 % for stability, read from two figures. We ask for
which arms that holds.
"""

from sympy import Rational, S

from symhaptic.book.lemmas.stiffest_stable import no_stiffer, stable_wall
from symhaptic.book.lemmas.stiffness_claims import UNDELAYED, one_period
from symhaptic.bounds.walls import most, over
from symhaptic.notation import delta, gamma
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import DAMPED, RANGES, STIFF
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.tactics import example


def derive(page):
    page.lemma(
        "Inside (23) and without delay a wall with $\\alpha=0.68+1.604\\delta$ is stable",
        stable_wall(0, UNDELAYED, RANGES),
    )
    page.lemma(
        "Inside (23) and one period late all stable walls have less than 22 \\% of this stiffness",
        no_stiffer(1, (Rational("0.22") * UNDELAYED[0], Rational("0.424")), RANGES),
    )
    arms = [(STIFF, DAMPED), (S.Zero, DAMPED), (S.Zero, Rational(3, 100))]
    shares = [over(most(*arm, 1), most(*arm, 0)) for arm in arms]
    names = [
        rf"\frac{{\alpha_{{\max}}(1)}}{{\alpha_{{\max}}(0)}}\Big|_{{\gamma={g},\ \delta={v}}}"
        for g, v in (("0.001", 0.02), (0, 0.02), (0, 0.03))
    ]
    page.enclosed(
        "The share that is left is enclosed",
        list(zip(names, shares, strict=True)),
        because="the first is that of Figs. 11 and 12; beyond the range, at $\\delta=0.03$, it is "
        "more than 22 %",
    )
    claim = CLAIMED["s6-stable-22"](())
    page.settle(
        "s6-stable-22",
        one_period(),
        example=example({gamma: S.Zero, delta: S.Zero}, taken_apart(claim)[1]),
        enclosed=True,
        value=shares[0],
        note=r"for all of (23); the number is for $\gamma=0.001$, $\delta=0.02$; a "
        r"free mass has 21.05\%",
    )

r"""How much stiffness does one period of delay leave?

The conclusion of the paper has less than 22 % for stability, read from two figures. We ask for
which arms that holds.
"""

from sympy import Rational, S, symbols, tan

from symhaptic.book.lemmas.stiffness_claims import one_period
from symhaptic.bounds.walls import DEVICE, STIFFNESS, most, over
from symhaptic.model import boundary
from symhaptic.notation import delta, gamma, phi, t
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import DAMPED, IN_23, RANGES, STIFF
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, NUMBERS, named
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.tactics import example

GIVEN = named({s: s for s in NUMBERS})
MOST = boundary.largest_undelayed(DEVICE).subs(BALLS)
FIRST, SECOND = symbols("alpha_1 alpha_2")


def derive(page):
    page.say("With the maximum of the curve for $d=1$, over $\\varphi=2\\theta$, and (23):")
    curve = STIFFNESS.subs(t, tan(phi / 4)).subs(BALLS)
    whole = {**RANGES, phi: (0, Rational(42, 10))}
    page.positive(
        "One period of delay leaves less than 22 %",
        box.positive(Rational(22, 100) * MOST - curve, whole, GIVEN),
        IN_23 + r",\ 0\le\theta\le\tfrac{2\pi}3",
        name=r"0.22\,\alpha_{\max}(0)-\alpha(\theta)|_{d=1}",
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

r"""How close does the ratio of passive to stable stiffness come to one without a spring?

We take $\delta=0.02$, enclose $\eta$ beside its peak, and ask what it tends to for long delays.
"""

from sympy import Rational, S, cos, pi, sin

from symhaptic.book.lemmas.ratio_peak import FREE, RATIOS, at_peak, below, of_delay
from symhaptic.bounds.walls import most, over, passive
from symhaptic.notation import phi
from symhaptic.paper.ranges import DAMPED, STIFF
from symhaptic.proof.enclosed import value
from symhaptic.proof.roots import zero


def derive(page):
    page.enclosed(
        "The ratios beside both peaks are enclosed",
        [
            *((rf"\eta({n})|_{{\gamma=0}}", eta(S.Zero, n)) for n in range(119, 126)),
            (r"\eta(40)|_{\gamma=0.001}", eta(STIFF, 40)),
        ],
        because="by the maximum of the explicit function, as before; without a spring $d=122$ has "
        "the largest of these",
    )
    page.lemma(
        "Without a spring some passive wall has more than 0.9999 of all stable stiffness at "
        "$d=122$",
        at_peak(122, RATIOS[0], FREE),
    )
    page.lemma(
        "Without a spring some stable wall outdoes all passive ones at $d=1000$, $\\eta<0.91$",
        of_delay(below(RATIOS[1], S(1000), FREE), 1000, FREE),
        because="beyond the peak the ratio falls again",
    )
    limit(page)


def eta(stiffness, delay):
    """Largest passive over largest stable stiffness."""
    return over(passive(DAMPED, delay), most(stiffness, DAMPED, delay))


def limit(page):
    """Without a spring the ratio tends to 0.863."""
    angle = zero(sin(phi) + phi * cos(phi), phi, S(2), Rational(21, 10))
    high = value(phi * sin(phi), {phi: angle})
    page.enclosed(
        "Without a spring the ratio tends to this number",
        [
            (r"\varphi_\infty", angle),
            (r"\varphi_\infty\sin\varphi_\infty", high),
            (r"\eta(\infty)", over(pi / 2, high)),
        ],
        because="the largest of $\\varphi\\sin\\varphi$, by the limit of the curve in the first "
        "chapter; with a spring $\\eta$ falls like $1/d$, as the passive stiffness does",
    )

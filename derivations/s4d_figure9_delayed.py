r"""How much does an arm's stiffness change the region with a delay?

Fig. 9 of the paper shows the stable walls for $d=1$ and $d=2$ at the limits of the arm's stiffness
and damping. The stiffness moves the left bound by $\gamma\le0.001$, as it does without delay, but
the region is smaller. We compare the shift of the left bound with the width of the region.
"""

from symhaptic.book.figures.stability import delayed
from symhaptic.book.lemmas.boundary import zero_on_circle_is_explicit
from symhaptic.book.lemmas.enclosed import enclosed_walls_are_stable
from symhaptic.book.lemmas.figure9 import NEAR, drawn, right_of_the_line
from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.paper.propositions.plots import THIN


def derive(page):
    page.say(
        "We multiply numerator and denominator of the explicit boundary by the conjugate of $N$. "
        "Then the boundary is a sum of four terms for every delay, divided by "
        r"$|N|^2=n_1^2+n_0^2+2n_1n_0\cos\theta$ at $z=e^{j\theta}$."
    )
    page.lemma(
        r"With a delay, one wall at each angle gives the loop a pole at $e^{j\theta}$",
        zero_on_circle_is_explicit(),
        because=r"the statement holds for every device whose $N$ does not vanish at $e^{j\theta}$",
    )
    page.say(
        r"The regions are largest with the damping $\delta=0.02$. For this damping we bound the "
        "stiffness:"
    )
    for late in (1, 2):
        for spring in (S.Zero, STIFF):
            page.lemma(
                f"For $d={late}$, $\\gamma={float(spring):g}$ and $\\delta=0.02$ this stiffness "
                "bounds all stable walls",
                none_above((spring, DAMPED), late)[1],
            )
    page.say(
        r"So the shift of $\gamma=0.001$ is more than $1/170$ of the width of the region for "
        "$d=1$ and more than $1/80$ for $d=2$; without delay it is $1/690$. Stable walls lie "
        r"next to the line $\alpha=-\gamma$, so the regions reach this line:"
    )
    beside = {alpha: -STIFF + THIN / 2, gamma: STIFF, delta: DAMPED}
    for late in (1, 2):
        page.lemma(
            f"For $d={late}$ a wall is stable whose stiffness exceeds $-\\gamma$ by $0.0001$",
            stable_at({**beside, beta: NEAR[late], d: S(late)}),
        )
    page.figure(
        "fig9",
        "Fig. 9 of the paper: stable walls for $d=1$ and $d=2$ at the limits of the parameter "
        r"range. The left bounds and the tips for $\gamma=0.001$ are visibly apart from those for "
        r"$\gamma=0$.",
        delayed,
        panels=(1, 2),
        height=0.5,
    )
    page.lemma(
        "Stable walls lie right of $\\alpha=-\\gamma$, for all arms of (23)",
        right_of_the_line(),
        because=r"here $p_1(1)=(\alpha+\gamma)(n_1+n_0)$, and the polynomial of a stable wall is "
        "positive at 1",
    )
    page.say(
        "In each region we compute the roots for two walls, one next to the left bound and one "
        "next to the tip; both walls are stable. One point $z$ of the circle is sufficient to show "
        "that no stable wall is stiffer: a polynomial $p$ of degree $n$ with all zeros inside "
        r"satisfies $n|p|^2<2\Re\bar p\,zp'$ at $z$."
    )
    page.lemma(
        "Walls that no boundary separates from a stable wall are stable",
        enclosed_walls_are_stable(),
        because="along a path between two walls the roots are continuous, and none of them "
        "crosses the circle; this holds for every plant and every integer delay",
    )
    page.settle(
        "fig9", drawn(), note="for $d=2$ the spring changes the width by more than one percent"
    )

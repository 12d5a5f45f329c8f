r"""How much does an arm's stiffness change the region with a delay?

Fig. 9 of the paper shows the stable walls for $d=1$ and $d=2$ at the limits of the arm's stiffness
and damping. The stiffness moves the left bound by $\gamma\le0.001$, as it does without delay, but
the region is smaller. We compare the two.
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
        "Multiplied by the conjugate of the numerator $N$, the explicit boundary has four terms, "
        "for every delay, over $|N|^2=n_1^2+n_0^2+2n_1n_0\\cos\\theta$ at $z=e^{j\\theta}$."
    )
    page.lemma(
        "With a delay one wall at each angle has a zero of the loop at $e^{j\\theta}$",
        zero_on_circle_is_explicit(),
        because="for the numbers of any device whose $N$ does not vanish there",
    )
    page.say(
        "The regions are largest with the damping $\\delta=0.02$. It allows these stiffnesses:"
    )
    for late in (1, 2):
        for spring in (S.Zero, STIFF):
            page.lemma(
                f"For $d={late}$, $\\gamma={float(spring):g}$ and $\\delta=0.02$ this stiffness "
                "bounds all stable walls",
                none_above((spring, DAMPED), late)[1],
            )
    page.say(
        r"So $\gamma=0.001$ is more than $1/170$ of the width for $d=1$ and more than $1/80$ for "
        r"$d=2$; without delay it is $1/690$. The regions reach the line $\alpha=-\gamma$: stable "
        "walls lie next to it."
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
        "range. Left bounds and tips for $\\gamma=0.001$ stand apart from those for $\\gamma=0$.",
        delayed,
        panels=(1, 2),
        height=0.5,
    )
    page.lemma(
        "Stable walls lie right of $\\alpha=-\\gamma$, for all arms of (23)",
        right_of_the_line(),
        because="at 1 the polynomial is $(\\alpha+\\gamma)(n_1+n_0)$",
    )
    page.say(
        "Two walls of each region, one next to the left bound and one next to the tip, are shown "
        "to be stable by their roots. One point of the circle shows that no stable wall is "
        r"stiffer: for a polynomial $p$ of degree $n$ with its zeros inside, $n|p|^2<2\Re\bar "
        r"p\,zp'$ there."
    )
    page.lemma(
        "Walls that no boundary separates from a stable wall are stable",
        enclosed_walls_are_stable(),
        because="along a path between two walls the zeros are continuous, and none crosses the "
        "circle; for every plant and every integer delay",
    )
    page.settle(
        "fig9", drawn(), note="for $d=2$ the spring changes the width by more than one percent"
    )

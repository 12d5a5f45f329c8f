r"""How much does an arm's stiffness change the region without delay?

Fig. 7 of the paper shows the stable walls for $d=0$ at the limits of the arm's stiffness and
damping, $\gamma\le0.001$ and $\delta\le0.02$. The stiffness moves the left bound; we ask how far it
moves the rest of the boundary.
"""

from symhaptic.book.figures.stability import undelayed
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.springs_alike import line_and_curve, springs_alike
from symhaptic.paper.propositions.plots import CURVE, OTHER


def derive(page):
    x = symbols("xi")
    size = n_1**2 + n_0**2 + 2 * n_1 * n_0 * x
    top = (2 * x - 1) * (a * n_0 - n_1) + a * n_1 - e * (n_1 + n_0) - n_0 * (4 * x**2 - 2 * x - 1)
    side = a * n_0 - (1 - e) * n_1 - 2 * n_0 * x
    stiffness, damping = (of.subs(d, 0) for of in boundary.wall(plant.Sampled(n_1, n_0, a, e)))
    page.say(r"For $d=0$ the explicit boundary consists of two rational functions of $\cos\theta$.")
    page.define("The parameter $x$ is the cosine of the angle", x, cos(theta))
    page.step(
        "The boundary without delay has this stiffness",
        stiffness,
        top / size,
        name=r"\alpha(\theta)",
    )
    page.step(
        "The boundary without delay has this damping", damping, side / size, name=r"\beta(\theta)"
    )
    page.same("the curve as a graph", top / size, CURVE.subs(beta, side / size))
    page.say(
        r"Jury's minor is linear in $\alpha$, so it vanishes at one stiffness for each "
        "virtual damping."
    )
    curve = page.lemma(
        "The stable walls are those above $\\beta=-1$ between a line and this curve",
        line_and_curve(),
        because="the other two of Jury's inequalities follow from these two",
    )
    page.say(
        r"Take a wall that is stable with a spring $\gamma$, and let $\gamma'$ be a second spring. "
        r"Move the wall to the right by $\gamma-\gamma'$. Then move it towards $(-\gamma',1)$ by a "
        r"fraction of the distance: by $0.0012$, plus $0.72\,(\gamma-\gamma')$ if "
        r"$\gamma'<\gamma$. The moved wall satisfies Jury's inequalities for the second spring, "
        "and the map is invertible."
    )
    same = page.lemma(
        "The stable walls of two springs differ by a shift of at most 0.002",
        springs_alike(),
        because="the two devices have the same $e$, and their $n_1$ and $n_0$ differ by less than "
        "$0.0004$ and $0.00018$",
        boxed=True,
    )
    page.say(
        "The region is $0.69$ wide and $2$ high, so a shift of $0.002$ is about the thickness of a "
        r"printed line. The left bounds $\alpha=-\gamma$ differ by at most $0.001$."
    )
    page.figure(
        "fig7",
        "Fig. 7 of the paper: stable walls for $d=0$ at the limits of the parameter range. The "
        r"curves for $\gamma=0$ and $\gamma=0.001$ coincide in print.",
        undelayed,
    )
    point = {gamma: STIFF, OTHER: S.Zero, delta: DAMPED}
    arms = example(point, same.conclusion.body.of[0].of)
    page.settle("fig7", conj(curve, same), note="the spring moves the curve by less than 0.002")
    page.settle(
        "s4d-gamma-invisible",
        same,
        example=arms,
        note="the boundary moves by less than $0.002$ in each coordinate; the region is $0.69$ "
        "wide and $2$ high",
    )

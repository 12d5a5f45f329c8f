"""Does a larger delay always make the stable region smaller?

A delay reduces the largest stable stiffness. But with a physical spring, each period of delay
lowers the damping at which the boundary begins, so some walls are stable only with a delay.
"""

from symhaptic.book.lemmas.boundary import CORNER, begins, begins_there
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.paper.propositions.stability import LATER


def derive(page):
    page.say(
        r"For $\theta\to0$ the explicit boundary $\alpha(\theta)$, $\beta(\theta)$ starts on the "
        r"line $\alpha=-\gamma$. We use $1-a+e=\gamma(n_1+n_0)$:"
    )
    page.define(r"The boundary begins at the damping $\beta_0$", r"\beta_0", CORNER)
    here, later = begins_there(), begins_there(d + 1, gamma)
    page.lemma("The boundary begins at $(-\\gamma,\\beta_0)$ with a delay of $d$ periods", here)
    page.lemma(
        r"With one more period of delay the boundary begins at $(-\gamma,\beta_0-\gamma)$",
        later,
        because=r"for every damped device, the start of the boundary moves down by $\gamma$",
        boxed=True,
    )
    wall = {
        alpha: Rational(-9, 10000),
        beta: Rational(-11, 1000),
        gamma: Rational(1, 1000),
        delta: Rational(1, 100),
        d: S.Zero,
    }
    page.say(
        "If the region reaches this point, the point is its lower left corner. A wall just "
        "above the corner for $d=1$ lies below the corner for $d=0$. For an arm in the ranges "
        r"(23), take $\gamma=0.001$, $\delta=0.01$, $\alpha=-0.0009$, $\beta=-0.011$:"
    )
    page.lemma(
        r"With one period of delay the wall $\alpha=-0.0009$, $\beta=-0.011$ is stable",
        stable_at({**wall, d: S.One}),
    )
    page.lemma(
        r"Without delay the wall $\alpha=-0.0009$, $\beta=-0.011$ is not stable", unstable_at(wall)
    )
    page.say(
        r"With longer delays the same happens to walls with $K>0$, such as $\alpha=0.0001$, "
        r"$\beta=-0.022$ at $\gamma=0.001$, $\delta=0.02$."
    )
    stiff = {**wall, alpha: Rational(1, 10000), beta: Rational(-11, 500), delta: Rational(1, 50)}
    page.lemma(
        r"With 22 periods of delay the wall $\alpha=0.0001$, $\beta=-0.022$ is stable",
        stable_at({**stiff, d: S(22)}),
    )
    page.lemma(
        r"With 21 periods of delay the wall $\alpha=0.0001$, $\beta=-0.022$ is not stable",
        unstable_at({**stiff, d: S(21)}),
    )
    page.say(
        "The area of the region does decrease with each period of delay (\\chapter{s4d_areas})."
    )

    corners = every(NUMBERS, [DEVICE], both([begins(), begins(d + 1, CORNER - gamma)]))
    plant, arm = [gamma >= 0, delta > 0], (gamma, delta, d)
    page.settle(
        "s4d-delay-shrinks",
        for_all(arm, plant, for_all(NUMBERS, [DEVICE], conj(here, later))),
        instead=every(arm, plant, corners),
        corrected=[r"\text{the explicit boundary begins}\ \gamma\ \text{lower with every period}"],
        example={gamma: S.Zero, delta: S.One, d: S.Zero},
        misprint=False,
        unless=[({**wall, LATER: S.One}, *(stable_at({**wall, d: S.One}), unstable_at(wall)))],
        shows="with an arm of (23), some wall is stable at $d=1$ and unstable at $d=0$",
        note="the statement is false for the regions as sets of walls, even if only walls with "
        "$K>0$ count. For the areas of the regions it is true for the arm of Figs. 11 and 12 up "
        r"to $d=8$ (\texttt{s4d-delay-shrinks-area})",
    )

r"""What does an arm's spring change around the origin?

Fig. 8 of the paper looks at the stable walls for $d=0$ near the origin, for five springs. The left
bound moves with the spring, as it should. Does the bottom?
"""

from symhaptic.book.figures.stability import origin as close_up
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed_origin import origin


def derive(page):
    page.say(
        "Write Jury's minor around the line $\\beta=\\alpha/2-\\delta$, the linear condition (25), "
        "with $S=n_1+n_0$. The device's law $1-a+e=\\gamma S$ is used for $a$:"
    )
    total = n_1 + n_0
    minor = 1 - e + beta * (n_1 - n_0 + a * n_0) - n_0 * total * beta**2
    minor -= alpha * n_0 * (1 + beta * n_1)
    page.step(
        "Near the origin Jury's minor is nearly the line",
        minor.subs(a, 1 + e - gamma * total),
        total * (1 - n_0 * beta) * (beta + delta - alpha / 2)
        + (1 - e - delta * total) * (1 - n_0 * beta)
        + alpha * (total / 2 * (1 - n_0 * beta) - n_0 * (1 + beta * n_1))
        - gamma * n_0 * beta * total,
        name="M",
        because="the last three terms are small, and only the very last one has the spring in it",
    )
    found = page.lemma(
        "Near the origin walls right of $\\alpha=-\\gamma$ and above the line are the stable ones",
        origin(),
        because="to within $0.0001$ of $\\beta$",
        boxed=True,
    )
    page.say(
        "All bottom boundaries of one $\\delta$ are parts of one line, to within half a per cent "
        "of the height of Fig. 8. The spring makes that line longer: the corner at its left end "
        "moves along it to $\\alpha=-\\gamma$, and so about $\\gamma/2$ down."
    )
    page.figure(
        "fig8",
        "Fig. 8 of the paper: close-up of Fig. 7 with five stiffnesses. Left bounds at "
        "$\\alpha=-\\gamma$, one bottom line for each $\\delta$.",
        close_up,
    )
    _, given, _ = taken_apart(found.conclusion)
    arm = {alpha: S.Zero, beta: S.Zero, gamma: STIFF, delta: DAMPED}
    page.settle("fig8", found, example=example(arm, given), note="the corner moves along the line")

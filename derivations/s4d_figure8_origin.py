"""How does an arm's stiffness change the region near the origin?

Fig. 8 of the paper shows the stable walls for $d=0$ near the origin, for five stiffnesses of the
arm. The left bound moves with the stiffness. Does the lower bound move, too?
"""

from symhaptic.book.figures.stability import origin as close_up
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import inequalities, on_box
from symhaptic.book.lemmas.undelayed_curve import BETWEEN, ROOM, TOTAL, enough, needed, plants
from symhaptic.paper.propositions.plots import CURVE, FINE, FRAME


def derive(page):
    page.say(
        r"The line $\beta=\alpha/2-\delta$ belongs to the linear condition (25). We expand Jury's "
        "minor around this line, with $S=n_1+n_0$, and eliminate $a$ by the device's law "
        r"$1-a+e=\gamma S$:"
    )
    total = n_1 + n_0
    minor = 1 - e + beta * (n_1 - n_0 + a * n_0) - n_0 * total * beta**2
    minor -= alpha * n_0 * (1 + beta * n_1)
    page.step(
        r"Near the origin Jury's minor is nearly a multiple of $\beta+\delta-\alpha/2$",
        minor.subs(a, 1 + e - gamma * total),
        total * (1 - n_0 * beta) * (beta + delta - alpha / 2)
        + (1 - e - delta * total) * (1 - n_0 * beta)
        + alpha * (total / 2 * (1 - n_0 * beta) - n_0 * (1 + beta * n_1))
        - gamma * n_0 * beta * total,
        name="M",
        because=r"the last three terms are small, and only the last one contains $\gamma$",
    )
    found = page.lemma(
        r"Near the origin the stable walls are those right of $\alpha=-\gamma$ and above the line",
        origin(),
        because=r"the statement is exact to within $0.0001$ in $\beta$",
        boxed=True,
    )
    page.say(
        r"All lower boundaries of one $\delta$ are parts of one line, to within half a percent of "
        "the height of Fig. 8. With stiffness the line is longer: its left end is a corner of the "
        r"region and moves along the line to $\alpha=-\gamma$. So the corner moves down by about "
        r"$\gamma/2$."
    )
    page.figure(
        "fig8",
        "Fig. 8 of the paper: close-up of Fig. 7 with five stiffnesses. The left bounds are at "
        r"$\alpha=-\gamma$, and there is one lower line for each $\delta$.",
        close_up,
    )
    arm = {alpha: S.Zero, beta: S.Zero, gamma: STIFF, delta: DAMPED}
    page.settle(
        "fig8", found, example=arm, note="the lower left corner of the region moves along the line"
    )


# Around the origin the stable walls without delay lie above beta = alpha/2 - delta.
#
# Jury's minor is S (1 - n_0 beta) (beta + delta - alpha/2) plus small terms.

ABOVE = beta - alpha / 2 + delta
SEEN = {**RANGES, alpha: (-STIFF, FRAME[0]), beta: (-FRAME[1], FRAME[1])}
LITTLE = Rational(4, 10**5)


@cache
def rest(sign: int) -> tuple[Theorem, Theorem, Theorem]:
    """Bounds of the minor minus S (1 - n_0 beta) (beta + delta - alpha/2), of one sign."""
    lag = TOTAL / 2 * ROOM - n_0 * (1 + beta * n_1)
    most = (FINE * TOTAL - LITTLE) * ROOM + sign * (alpha * lag - gamma * n_0 * beta * TOTAL)
    slow = LITTLE + sign * (1 - e - delta * TOTAL)
    return on_box(most, SEEN), on_box(slow, RANGES), on_box(ROOM, SEEN)


def above() -> Theorem:
    """A stable wall lies above the line, or less than FINE below it."""
    minor, total = inequalities(0)[3], plants()["total"]
    most, slow, room = rest(-1)
    goal = ABOVE + FINE
    product = combined(
        TOTAL * ROOM * goal > 0, [minor], [most], [slow, room], [plants()["static"], _share()]
    )
    weight = positive(TOTAL * ROOM > 0, [total, room])
    found = combined(ABOVE > -FINE, [over(goal > 0, product, weight)])
    return closed(found, not_zero(weight), not_zero(total), not_zero(room))


@cache
def origin() -> Theorem:
    """Near the origin, the stable walls are those above the line, for every arm of (23)."""
    then = taken_apart(CLAIMED["fig8"](()))[2]
    inside, above_ = then.of
    left = combined(alpha >= -STIFF, [assume(alpha > -gamma)], [assume(gamma <= STIFF)])
    right = of_every_plant(conjunct(needed(), BETWEEN.parts[0]))
    down = combined(beta > -1, [assume(-FRAME[1] <= beta)], [1 - FRAME[1]])
    right = closed(right, down)
    below = of_every_plant(closed(above(), closed(left, right)))
    there = disch(conj(right, below), inside.of[0])
    back = disch(of_every_plant(closed(is_filled(), left, down)), above_.of[0])
    return as_claimed(CLAIMED["fig8"](()), conj(there, back))


def _share() -> Expr:
    return -beta * n_0


def is_filled() -> Theorem:
    """A wall above the line and to the right of alpha = -gamma is stable."""
    minor, known = inequalities(0)[3].conclusion, plants()
    most, slow, room = rest(1)
    high = positive(ABOVE - FINE > 0, ABOVE > FINE)
    inner = combined(
        minor, [known["total"], room, high], [most], [slow, room], [known["static"], -_share()]
    )
    curve = combined(alpha < CURVE, [over(CURVE - alpha > 0, inner, known["weight"])])
    apart = [not_zero(known[n]) for n in ("weight", "late", "toward")]
    return closed(enough(), closed(curve, *apart))

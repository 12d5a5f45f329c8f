"""Does more damping enlarge the stable region?

One expects that a stronger damper never destabilises a wall. This is true without delay for arms
inside the ranges (23). For stiffer springs this is false.
"""

from symhaptic.book.lemmas.more_damped import (
    grown,
    grows,
    lost_by_a_damper,
    minor_rises,
    more_damped_is_stable,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.stability import HEAVIER, damping_can_destabilise


def derive(page):
    page.say(
        r"For the arms of (23) and without delay, the stable walls with $\beta>-1$ are those with "
        r"$\alpha>-\gamma$ and a positive largest minor of Jury "
        r"(\chapter{s4d_figure7_undelayed}). It is therefore sufficient to show that this minor "
        "rises with the damping, for each wall:"
    )
    page.lemma(
        "The stronger of two dampers gives the larger minor of a wall",
        minor_rises(),
        because="the coefficients of the two devices are $n_1,n_0,a,e$ and $n_1'',n_0'',a'',e''$; "
        "balls from the exponential of the plant's matrix and from its derivative show that the "
        "slope is positive",
    )
    page.lemma(
        "For the arms of (23) and without delay, a stable wall stays stable with more damping",
        more_damped_is_stable(),
    )
    page.say(
        "On any path from a stable wall the minor is positive as long as the walls are stable. So "
        "the minor is not negative at the end of the path, and with the larger damper it is "
        r"positive. This argument fails only for walls with $\alpha=-\gamma$."
    )
    page.lemma(
        r"For the arms of (23) and without delay, a wall with $\alpha>-\gamma$ on the boundary of "
        "the stable region is stable with more damping",
        grows(),
        because=r"a strict inequality along the path holds with $\ge$ at its end",
    )
    then = taken_apart(page.claim("s4d-delta-grows"))[2]
    point = {alpha: S.One / 100, beta: S.One / 10, gamma: S.Zero}
    point |= {delta: Rational(1, 100), HEAVIER: Rational(1, 50)}
    page.settle(
        "s4d-delta-grows",
        grown(then),
        example=point,
        note="the statement is proved without delay only; with a stiff spring it is false "
        r"(\texttt{damping-destabilises})",
    )
    page.say(
        r"For stiffer springs the statement is false. Take $\gamma=5$, $\alpha=-4$, $\beta=5.9$ "
        r"and no delay. With $\delta=1.2$ this wall is stable, but with $\delta=1.5$ a root lies "
        "outside the unit circle."
    )
    page.state(
        "damping-destabilises",
        "with a stiff spring, $\\gamma=5$, and without delay a wall is stable with a damper and "
        "unstable with a larger one",
        claim=damping_can_destabilise(),
    )
    page.settle(
        "damping-destabilises",
        lost_by_a_damper(),
        note=r"the wall $\alpha=-4$, $\beta=5.9$ is stable for $\delta=1.2$ and unstable for "
        r"$\delta=1.5$",
    )

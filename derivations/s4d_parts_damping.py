r"""Does more damping enlarge the stable region?

With a stronger damper a wall should not lose its stability. For arms inside the paper's ranges (23)
and without delay that is so; for stiffer springs it is false.
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
        "Inside (23) and without delay the stable walls with $\\beta>-1$ are those right of "
        "$\\alpha=-\\gamma$ with a positive largest minor of Jury's "
        "(\\chapter{s4d_figure7_undelayed}). So it is enough that the minor of a wall rises with "
        "the damping:"
    )
    page.lemma(
        "The minor of a wall is larger for the larger damper",
        minor_rises(),
        because="the devices' numbers are $n_1$ to $e$ and $n_1''$ to $e''$; the slope is "
        "positive, in balls from the exponential of the plant's matrix and its derivative",
    )
    page.lemma(
        "Inside (23) and without delay a stable wall stays stable with more damping",
        more_damped_is_stable(),
    )
    page.say(
        "Going from a stable wall in any direction, one keeps a positive minor as long as the "
        "walls are stable, so that at the end of the way it is not negative, and with the larger "
        "damper it is positive again. Only at $\\alpha=-\\gamma$ this does not help."
    )
    page.lemma(
        "Inside (23) and without delay a wall right of $\\alpha=-\\gamma$ at which stable walls "
        "end is stable with more damping",
        grows(),
        because="what holds at all walls on the way holds weakly in the limit",
    )
    then = taken_apart(page.claim("s4d-delta-grows"))[2]
    point = {alpha: S.One / 100, beta: S.One / 10, gamma: S.Zero}
    point |= {delta: Rational(1, 100), HEAVIER: Rational(1, 50)}
    page.settle(
        "s4d-delta-grows",
        grown(then),
        example=point,
        note="with a delay nothing is shown here; a stiff spring makes it false "
        "(damping-destabilises)",
    )
    page.say(
        "For stiffer springs it is false: $\\gamma=5$, $\\alpha=-4$, $\\beta=5.9$ and no delay. "
        "With $\\delta=1.2$ this wall is stable, and with $1.5$ a root lies outside."
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
        note="$\\alpha=-4$, $\\beta=5.9$, $\\delta=1.2$ and $1.5$",
    )

r"""What does a filter of the velocity cost a light device?

A damper whose velocity passes a low-pass filter, $1/(\tau_fs+1)$ by backward Euler, damps late. For
a free mass we find how stiff the wall may be, and ask whether the filter counts as a delay of its
time constant.
"""

from sympy import S

from symhaptic.book.lemmas.decided import escapes, in_z
from symhaptic.book.lemmas.filtered_mass import (
    LITTLE,
    LOOP,
    below_the_tangent,
    counted_as_delay,
    decides,
    in_units,
)
from symhaptic.book.sources import STATEMENTS
from symhaptic.loops.velocity import DIFFERENCE, exponential_average
from symhaptic.model import plant
from symhaptic.model.parts import Parts
from symhaptic.notation import B, K, T, alpha, beta, f_v, m, tau_f, z
from symhaptic.rules.other_loops import LOW_PASS

EXACT, DELAY = "rules:low-pass-mass", "rules:filter-as-delay"


def derive(page):
    mass = plant.sampled(plant.normalised(Parts(False, False)))
    page.step(
        "By backward Euler the low-pass filter is an exponential average",
        1 / (tau_f / T * (1 - 1 / z) + 1),
        ((1 - f_v) * z / (z - f_v)).subs(f_v, tau_f / (T + tau_f)),
        because="with $s=(1-1/z)/T$; the pole is $f_v=\\tau_f/(T+\\tau_f)$",
    )
    wall = alpha + beta * in_z(DIFFERENCE.times(exponential_average(f_v)))
    page.step(
        "A free mass with a filtered velocity has this polynomial",
        (z - 1) ** 2 * (z - f_v) * (1 + mass.numerator / mass.denominator * wall),
        LOOP.of[0].subs({K: alpha, B: beta}),
        name=r"p_f(z)",
        because="the filter takes the place of the sample before",
    )
    page.lemma(
        "For $m=T=1$ a free mass with a filtered velocity is stable just within these bounds",
        in_units(),
        because="the last of Jury's inequalities is the quadratic one, and no negative damping "
        "meets it together with the others",
    )
    printed = STATEMENTS[EXACT].printed
    found = page.lemma(
        "A free mass with a filtered velocity is stable just within these bounds",
        decides(*printed),
        boxed=True,
    )
    soft = {K: S.One / 4, B: S.One / 4, T: S.One, m: S.One, tau_f: S.One}
    page.settle(
        EXACT,
        found,
        example=soft,
        note="exact without delay; for $\\tau_f=0$ it is the limit of a wall without filter",
    )
    _tangent(page, printed)
    _delay(page, printed, soft)


def _tangent(page, printed):
    """At the origin the filter does not count; it bends the boundary."""
    left, right = printed[-1].args
    page.step(
        "On the line $K=2B/T$ the last bound is missed by the square of the damping",
        (left - right).subs(K, 2 * B / T),
        4 * B**2 * (T + tau_f) * (T + 2 * tau_f) / T**2,
        because="so that this line is the tangent at the origin with every filter, and the filter "
        "bends the boundary away from it",
    )
    page.lemma(
        "With every filter a stable wall of a free mass lies below the line $K=2B/T$",
        below_the_tangent(*printed),
    )
    page.say(
        "This is the tangent of a wall without filter. Slow motions are driven by the delay of the "
        "spring, and the spring is not filtered. The delay of the damper has an effect of second "
        "order. A delay of the whole wall is different: its tangent is $K=B/(\\frac12T+t_d)$."
    )


def _delay(page, printed, soft):
    [rule] = STATEMENTS[DELAY].printed
    found = page.lemma(
        "With little damping a filter takes less stiffness than the same delay of the wall",
        counted_as_delay(rule, *printed),
        boxed=True,
    )
    strong = soft | {K: S.Half, B: S.One}
    page.lemma("With $m=T=\\tau_f=B=1$ the stiffness $\\frac12$ grows", escapes(LOW_PASS, strong))
    page.settle(
        DELAY,
        found,
        example=soft | {K: S.One / 8},
        unless={LITTLE: (strong, escapes(LOW_PASS, strong))},
        shows="$m=T=\\tau_f=B=1$: $K<\\tfrac23$ is allowed, and $K=\\tfrac12$ grows",
        note="at the origin the rule is too careful by the factor $1+2\\tau_f/T$; from "
        "$B=2m\\tau_f/(T(T+4\\tau_f))$ on it allows too much, and for $\\tau_f=0$ everywhere",
    )

"""Does the search for the stable wall of maximum stiffness use the derived slope?

On the explicit boundary the stiffness rises from the origin to a maximum. The search uses the sign
of the derivative, which is computed as a sum of products.
"""

from symhaptic.book.lemmas import stable_slope
from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_slope import EARLY, SEARCHED, UNDELAYED

DEVICE = Sampled(n_1, n_0, a, e)
UNDEFINED = "if neither form divides by zero"


def derive(page):
    page.say(
        r"The search looks for the angle at which $\alpha$ stops increasing along the boundary. "
        r"Let $t=\tan(\theta/2)$, and let $Q'$ be the derivative of $Q$ with respect to the angle. "
        r"Since $\alpha=\Re Q-t\,\Im Q$, the slope is $\Re Q'-t\,\Im Q'-(1+t^2)\,\Im Q/2$."
    )
    names, slope = stable_slope.derived(n_1 * z + n_0, d, 0)
    meaning = dict(names)
    for _ in range(2):
        slope = slope.xreplace(meaning)
    derived = boundary.wall(DEVICE)[0].diff(theta)
    page.same("slope", derived, slope.xreplace({t: tan(theta / 2)}))
    page.say(
        "The search computes the slope times a positive number as a sum of products. The sum "
        "contains the values $A_1$, $A_2$, $M_1$ and $M_2$ of $A$ and $M$ at 1 and $-1$, and "
        "$L=1-e$. A quotient would be 0/0 at the start of the boundary. A search with "
        "differences of two stiffnesses would lose half of the digits at the maximum, since the "
        "two stiffnesses are nearly equal there. For delays of less than one period the slope "
        "is a polynomial in $t^2$, and its coefficients contain no sines. Tests with whole "
        "regions show that the first zero of the slope is the point of maximum stiffness of the "
        r"stable region. For some devices \chapter{s5b_stiffest_wall} proves this."
    )
    c, tangent, bottom = cos(theta / 2), tan(theta / 2), on_circle(z**2 - a * z + e)
    page.step(
        "The factor of the slope is positive where $A$ and $M$ do not vanish",
        bottom * bottom.xreplace({I: -I}),
        c**4 * ((1 - a + e - (1 + a + e) * tangent**2) ** 2 + 4 * tangent**2 * (1 - e) ** 2),
        name="|A|^2",
        because="here $|M|^2$ is a positive expression in $M_1$, $M_2$ and $m_2-m_0$",
    )
    settle(
        page,
        "max_stable_stiffness",
        (SEARCHED, EARLY, UNDELAYED),
        "the search for the largest stable stiffness uses the slope of the derived stiffness, for "
        f"any delay, for delays of less than one period and without delay, {UNDEFINED}",
    )

r"""For which arm is the line of the linear condition the tangent of the boundary?

We look at the start of the boundary, $\theta\to0$, where $\alpha=-\gamma$: does it lie on the line
of (25), and does the boundary leave along the line?
"""

from symhaptic.book.lemmas.linear_tangent import free_mass_only, tangent
from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "The surplus $\\Delta$ over the line tends to $-g$. Where the gap is zero, "
        "$\\Delta/\\theta^2$ tends to a number that is negative for every spring and damper."
    )
    page.lemma(
        "The boundary starts on the line and along it for a free mass only", free_mass_only()
    )
    page.state(
        "linear-tangent",
        "for $\\gamma-\\frac14\\delta^2<\\pi^2$ the boundary is tangent to (25), where it starts, "
        "for $\\gamma=\\delta=0$ only",
        claim=tangent(),
    )
    page.settle(
        "linear-tangent",
        free_mass_only(),
        example={gamma: S.One, delta: S.One, d: S.Zero},
    )

r"""For which arm is the line of the linear condition the tangent of the boundary?

We look at the start of the boundary, $\theta\to0$, where $\alpha=-\gamma$: does it lie on the line
of (25), and is the line tangent there?
"""

from symhaptic.book.lemmas.linear_tangent import free_mass_only, tangent
from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "The surplus $\\Delta$ over the line tends to $-g$. Where the gap is zero, "
        "$\\Delta/\\theta^2$ tends to a number that is negative for every spring and damper."
    )
    page.lemma(
        "The line is tangent to the boundary at its start for a free mass only", free_mass_only()
    )
    symbols, given, _ = taken_apart(tangent())
    page.state(
        "linear-tangent",
        "for $\\gamma-\\frac14\\delta^2<\\pi^2$ the boundary is tangent to (25), where it starts, "
        "for $\\gamma=\\delta=0$ only",
        claim=tangent(),
    )
    page.settle(
        "linear-tangent",
        for_all(symbols, given, add_assum(free_mass_only(), *given)),
        example=example({gamma: S.One, delta: S.One, d: S.Zero}, given),
    )

r"""Which frequencies bound the passive walls?

The envelope is drawn by frequencies up to Nyquist, but a region is bounded only by the lines
that no other line cuts off. We show, for every real $d\ge0$ and $K\ge0$, that frequencies above
$\pi/(T(d+1))$ cut off nothing.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import at_every_angle


def derive(page):
    page.say(
        "Let $\\psi=\\theta/2$, $N=2(d+1)\\ge2$ and measure the wall by $u=KT/(2b)\\ge0$ and "
        "$w=(B+KT/2)/b$. The condition becomes shorter:"
    )
    wall = {K: 2 * b * u / T, B: b * (w - u), d: N / 2 - 1, theta: 2 * psi}
    margin = page.step(
        "The margin over $b$ is linear in $u$ and $w$",
        passivity.margin().subs(wall) / b,
        1 - u * cot(psi) * sin(N * psi) + w * cos(N * psi),
        name=r"1-b_{\min}/b",
    )
    page.step(
        "At $N\\psi=\\pi$ only the damping counts",
        margin.subs(psi, pi / N),
        1 - w,
        name=r"1-b_{\min}/b",
        because="so $w\\le1$",
    )
    page.limit(
        "At the lower end the margin is a line",
        margin,
        psi,
        S.Zero,
        1 + w - N * u,
        name=r"\bigl(1-b_{\min}/b\bigr)",
        because="so $w\\ge Nu-1\\ge-1$",
    )
    page.step(
        "Between angles that differ by a full turn of $N\\psi$ only a cotangent changes",
        cot(psi) - cot(phi),
        sin(phi - psi) / (sin(psi) * sin(phi)),
        because="positive for $\\psi<\\varphi<\\pi/2$: the cotangent falls",
    )
    page.say(
        "Beyond $N\\psi=\\pi$: where $\\sin N\\psi\\ge0$, the angle a full turn lower has the same "
        "sine and cosine but a larger cotangent, and is stricter since $u\\ge0$. Where "
        "$\\sin N\\psi<0$, the margin is at least $1-|w|\\ge0$ by the two ends. Nothing new is cut "
        "off: only $0<N\\psi\\le\\pi$ counts, that is $0<\\omega T\\le\\pi/(d+1)$."
    )
    page.lemma(
        "A margin on the first half turn is one at every angle",
        at_every_angle(),
        because="of $N\\psi$ full turns are taken away, as often as they go into it",
        boxed=True,
    )

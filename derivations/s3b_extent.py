r"""Which frequencies bound the passive walls?

The envelope is drawn by frequencies up to Nyquist, but only some of the lines bound the region. We
show, for every real $d\ge0$ and $K\ge0$, that the conditions at frequencies above $\pi/(T(d+1))$
are redundant.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import at_every_angle
from symhaptic.model import passivity


def derive(page):
    page.say(
        r"Let $\psi=\theta/2$, $N=2(d+1)\ge2$ and write the wall with $u=KT/(2b)\ge0$ and "
        "$w=(B+KT/2)/b$. The condition is then linear in $u$ and $w$:"
    )
    wall = {K: 2 * b * u / T, B: b * (w - u), d: N / 2 - 1, theta: 2 * psi}
    margin = page.step(
        "The margin over $b$ is linear in $u$ and $w$",
        passivity.margin().subs(wall) / b,
        1 - u * cot(psi) * sin(N * psi) + w * cos(N * psi),
        name=r"1-b_{\min}/b",
    )
    page.step(
        r"At $N\psi=\pi$ the condition depends on $w$ only",
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
        r"Angles with $N\psi$ differing by $2\pi$ differ only in a cotangent",
        cot(psi) - cot(phi),
        sin(phi - psi) / (sin(psi) * sin(phi)),
        because="positive for $\\psi<\\varphi<\\pi/2$: the cotangent falls",
    )
    page.say(
        r"Beyond $N\psi=\pi$: where $\sin N\psi\ge0$, the angle with $N\psi$ smaller by $2\pi$ "
        r"has the same sine and cosine but a larger cotangent, and is stricter since $u\ge0$. "
        r"Where $\sin N\psi<0$, the margin is at least $1-|w|\ge0$ by the two limits above. So "
        r"only $0<N\psi\le\pi$ matters, that is $0<\omega T\le\pi/(d+1)$."
    )
    page.lemma(
        r"A margin for $0<N\psi\le\pi$ implies a margin at every angle",
        at_every_angle(),
        because=r"multiples of $2\pi$ are subtracted from $N\psi$",
        boxed=True,
    )

r"""Is the lower part of the passivity boundary a straight line?

Where small stiffness meets negative damping the boundary in the $(K,B)$ plane looks straight.
It is the line of vanishing frequency; we ask how far it reaches, and for which walls the simple
condition that comes from it is enough.
"""

from sympy import Eq, Rational, S, pi

from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, theta, y


def derive(page):
    line = page.limit(
        "Low frequencies",
        passivity.margin(),
        theta,
        S.Zero,
        b + B - K * T * (d + Rational(1, 2)),
        name="F",
    )
    stiffness, damping = passivity.envelope()
    end_stiffness = page.limit(
        "The envelope ends there, stiffness",
        stiffness,
        theta,
        S.Zero,
        6 * b * (d + 1) / (T * (2 * d + 1) * (2 * d + 3)),
        name=K,
    )
    end_damping = page.limit(
        "The envelope ends there, damping",
        damping,
        theta,
        S.Zero,
        b * d / (2 * d + 3),
        name=B,
    )
    page.say(
        "By the previous chapters no other frequency cuts into the line between $(0,-b)$ and this "
        "end: it bounds the passive walls for every real $d\\ge0$, with $y$ from 0 to 1 along it."
    )
    on_line = {K: end_stiffness * y, B: (end_damping + b) * y - b}
    page.step(
        "Every point of it", line.subs(on_line), S.Zero, name=r"F\big|_{\text{(8)}}", paper="8"
    )
    late = passivity.half_late_energy(Rational(3, 2), S.One, 30)
    page.settle(
        "eq8",
        Eq(K, on_line[K]),
        Eq(B, on_line[B]),
        provided=r"d\in\mathbb{N}_0",
        unless={d: S.Half, y: Rational(8, 9), T: S.One, b: S.One, K: S.One, B: S.Zero},
        truth=late >= 0,
        shows=r"half a period late, the wall $K=b/T$, $B=0$ on this line gives energy away",
        note="bounds the walls that satisfy (5) for every real $d$",
    )
    page.say(
        "Only the end $y=1$ is the limit of the envelope (7). The points before it belong to the "
        "line itself, the limit of (5)."
    )
    page.settle(
        "s3c-lower-part",
        page.same("on the line", line.subs(on_line), S.Zero),
        provided=r"y=1",
        unless={d: S.One, T: S.One, b: S.One, y: S.Zero},
        truth=Eq(end_stiffness, end_stiffness * y),
        shows=r"(7) tends to $K=\tfrac45b/T$, not to the point $(0,-b)$ of (8)",
        note="that the lower part is linear holds for every real $d\\ge0$",
    )
    page.say(
        "Solved for the stiffness this is the ratio of all damping to all delay, half a period of "
        "hold included:"
    )
    limit_of_k = page.step(
        "Damping over delay",
        (b + B) / (T * (d + Rational(1, 2))),
        2 * (b + B) / (T * (2 * d + 1)),
        name=r"\frac{b+B}{(d+\frac12)T}",
        paper="9",
    )
    page.step("On the line", line.subs(K, limit_of_k), S.Zero, name=r"F\big|_{K=(b+B)/((d+1/2)T)}")
    page.say(
        "For damping in the stated range the low frequencies are the strictest, and the condition "
        "is exact but for its border. For negative $K$ it says nothing: higher frequencies can "
        "fail."
    )
    low = {d: S.One, T: S.One, b: S.One, B: S.Zero, K: -S(3)}
    page.settle(
        "eq9",
        limit_of_k > K,
        provided=r"d\in\mathbb{N}_0,\ K\ge0,\ K\ne(b+B)/((d+\tfrac12)T)",
        unless=low,
        truth=passivity.margin(5 * pi / 6).subs(d, 1) > 0,
        shows=r"(9) holds, yet (5) fails at $\omega T=\tfrac56\pi$",
        note="equality satisfies (5) too, but for $d=0$, $B=0$: $\\omega=0$ is left out",
    )
    steep = {d: S.Zero, T: S.One, b: S.One, B: Rational(1, 2), K: S(2)}
    page.settle(
        "eq10",
        limit_of_k > K,
        provided=r"d\in\mathbb{N}_0,\ K\ge0,\ -b\le B\le bd/(2d+3),\ K\ne(b+B)/((d+\tfrac12)T)",
        unless=steep,
        truth=passivity.margin(5 * pi / 6).subs(d, 0) > 0,
        shows=r"$d=0$, $B=\tfrac12b$: (10) allows $K=2$, (5) fails at $\omega T=\tfrac56\pi$",
        note="with $\\le$ it is necessary for every $B$; sufficient in the range of (9) only",
    )

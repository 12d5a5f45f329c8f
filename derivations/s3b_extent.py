r"""Which part of the envelope bounds the passive walls?

The envelope is drawn by frequencies up to Nyquist, but a region is bounded only by the lines
that no other line cuts off. We show, for every real $d\ge0$ and $K\ge0$, that frequencies above
$\pi/(T(d+1))$ cut off nothing, and that below it the envelope is the boundary.
"""

from sympy import Eq, Rational, S, cos, cot, diff, pi, sin

from symhaptic.model import passivity
from symhaptic.notation import B, K, N, T, b, d, omega, phi, psi, theta, u, w
from symhaptic.proof.sign import (
    Interval,
    assume,
    combined,
    either,
    integrated,
    number,
    quotient,
    sine,
)


def derive(page):
    page.say(
        "Let $\\psi=\\theta/2$, $N=2(d+1)\\ge2$ and measure the wall by $u=KT/(2b)\\ge0$ and "
        "$w=(B+KT/2)/b$. The condition becomes shorter:"
    )
    wall = {K: 2 * b * u / T, B: b * (w - u), d: N / 2 - 1, theta: 2 * psi}
    margin = page.step(
        "The margin over $b$",
        passivity.margin().subs(wall) / b,
        1 - u * cot(psi) * sin(N * psi) + w * cos(N * psi),
        name=r"F/b",
    )
    page.step(
        "At $N\\psi=\\pi$", margin.subs(psi, pi / N), 1 - w, name="F/b", because="so $w\\le1$"
    )
    page.limit(
        "At the lower end",
        margin,
        psi,
        S.Zero,
        1 + w - N * u,
        name="F/b",
        because="so $w\\ge Nu-1\\ge-1$",
    )
    page.step(
        "Angles that differ by a full turn of $N\\psi$",
        cot(psi) - cot(phi),
        sin(phi - psi) / (sin(psi) * sin(phi)),
        because="positive for $\\psi<\\varphi<\\pi/2$: the cotangent falls",
    )
    page.say(
        "Beyond $N\\psi=\\pi$: where $\\sin N\\psi\\ge0$, the angle a full turn lower has the same "
        "sine and cosine but a larger cotangent, and is stricter since $u\\ge0$. Where "
        "$\\sin N\\psi<0$, the margin is at least $1-|w|\\ge0$ by the two ends. Nothing new is cut "
        "off."
    )

    # signs on 0 < N psi < pi, N > 2
    up = assume(pi - N * psi)
    more = assume(N - 2)
    angles = Interval(psi, S.Zero, (up, combined(N, [more], [2])))
    y = angles.above
    half = Rational(1, 2)
    side = combined(pi / 2 - psi, [half, up], [half, more, y])
    size = combined(N, [more], [2])
    sin_y = sine(y, combined(pi - psi, [side], [side], [y]))
    sin_n = sine(combined(N * psi, [size, y]), up)
    below = combined((N - 1) * psi, [more, y], [y])
    sin_below = sine(below, combined(pi - (N - 1) * psi, [up], [y]))
    lower = integrated(
        sin(N * psi) - N * sin(psi) * cos((N - 1) * psi),
        angles,
        combined(
            diff(sin(N * psi) - N * sin(psi) * cos((N - 1) * psi), psi),
            [size, more, sin_y, sin_below],
        ),
    )
    room = assume(pi - (N + 1) * psi)
    near = Interval(psi, S.Zero, (room, combined(N + 1, [more], [3])), (up, size))
    sin_above = sine(combined((N + 1) * psi, [size, y], [y]), room)
    expr = sin(N * psi) - N * sin(psi) * cos((N + 1) * psi)
    early = integrated(
        expr,
        near,
        combined(diff(expr, psi), [size, combined(N + 2, [more], [4]), sin_y, sin_above]),
    )
    past = assume((N + 1) * psi - pi, strict=False)
    falls = sine(
        combined((N + 1) * psi - pi / 2, [past], [half, number(pi)]),
        combined(3 * pi / 2 - (N + 1) * psi, [up], [side]),
    )
    late = combined(expr, [sin_n], [size, sin_y, falls])
    upper = either(early, late, room.expr)
    page.positive("First chord", lower, r"0<N\psi<\pi,\ N>2")
    page.positive("Second chord", upper, r"0<N\psi<\pi,\ N>2")

    shape = N * sin(2 * psi) + sin(2 * N * psi) - 4 * sin(N * psi) ** 2 * cot(psi) / N
    slope = quotient(
        diff(shape, psi),
        combined(4 * lower.expr * upper.expr, [4, lower, upper]),
        combined(N * sin(psi) ** 2, [size, sin_y, sin_y]),
    )
    page.step(
        "A slope that factors",
        diff(shape, psi),
        4 * lower.expr * upper.expr / (N * sin(psi) ** 2),
        name=rf"\frac{{\partial}}{{\partial\psi}}\Bigl({_latex(shape)}\Bigr)",
    )
    bent = page.positive("Bending", integrated(shape, angles, slope), r"0<N\psi<\pi,\ N>2")

    curve = page.step(
        "The envelope's stiffness",
        passivity.envelope()[0].subs(wall) * T / (2 * b),
        2 * N * sin(psi) ** 2 * sin(N * psi) / (N * sin(2 * psi) - sin(2 * N * psi)),
        name="U",
    )
    page.step(
        "It rises to $N\\psi=\\pi/2$ and falls after",
        diff(curve, psi),
        2
        * N**2
        * sin(psi) ** 2
        * cos(N * psi)
        * bent.expr
        / (N * sin(2 * psi) - sin(2 * N * psi)) ** 2,
        name=r"\partial U/\partial\psi",
        because="its sign is that of $\\cos N\\psi$",
    )
    limit_of_w = (u * cot(psi) * sin(N * psi) - 1) / cos(N * psi)
    page.step(
        "For a given stiffness the border moves with",
        diff(limit_of_w, psi),
        (N * sin(2 * psi) - sin(2 * N * psi))
        / (2 * sin(psi) ** 2 * cos(N * psi) ** 2)
        * (u - curve),
        name=r"\partial w/\partial\psi",
        because="its sign is that of $u-U$, so the strictest angle is the one with $U=u$, or "
        "$\\theta\\to0$ where $u$ lies below every $U$",
    )
    page.say(
        "For $N>2$, that is $d>0$, the envelope from $\\theta\\to0$ to $\\pi/(d+1)$ is therefore "
        "the boundary, closed by the line of $\\theta\\to0$ below and by $K=0$. For $d=0$ the "
        "slope of $U$ vanishes: the envelope shrinks to one point and the boundary is (6)."
    )
    page.step("Without delay", curve.subs(N, 2), S.One, name=r"U|_{d=0}")
    stiffness, damping = (e.subs(theta, omega * T) for e in passivity.envelope())
    page.settle(
        "eq7",
        Eq(K, stiffness),
        Eq(B, damping),
        provided=r"d>0,\ K\ge0,\ 0<\omega T\le\pi/(d+1)",
        unless={d: S.Zero, T: S.One, b: S.One, omega: S.One, K: S.One, B: Rational(1, 2)},
        truth=Eq(b, K * T / 2 + B),
        shows=r"for $d=0$ (7) is the single point $(2b/T,0)$; $(1,\tfrac12)$ lies on (6)",
        note=r"beyond $\pi/(T(d+1))$ the curve has $K<0$ and bounds nothing",
    )


def _latex(expr):
    from symhaptic.latex import latex

    return latex(expr)

r"""Is the envelope the boundary of the passive walls?

Of the frequencies up to $\pi/(T(d+1))$ each draws one point of the envelope. The envelope bounds
the passive walls if, for a given stiffness, one of these frequencies is stricter than all others.
With $\psi=\omega T/2$, $N=2(d+1)$, $u=KT/(2b)$ and $w=(B+KT/2)/b$ as before, that is a question of
signs on $0<N\psi<\pi$ for $N>2$; each is certified.
"""

from sympy import Eq, Rational, S, cos, cot, diff, pi, sin

from symhaptic.latex import latex
from symhaptic.model import passivity
from symhaptic.notation import B, K, N, T, b, d, omega, psi, theta, u
from symhaptic.proof import sign

DOMAIN = r"0<N\psi<\pi,\ N>2"


def derive(page):
    width, bend = signs(page)
    wall = {d: N / 2 - 1, theta: 2 * psi}
    curve = page.step(
        "The envelope's stiffness",
        passivity.envelope()[0].subs(wall) * T / (2 * b),
        2 * N * sin(psi) ** 2 * sin(N * psi) / width.expr,
        name="U",
    )
    page.step(
        "It rises to $N\\psi=\\pi/2$ and falls after",
        diff(curve, psi),
        2 * N**2 * sin(psi) ** 2 * cos(N * psi) * bend.expr / width.expr**2,
        name=r"\partial U/\partial\psi",
        because="its sign is that of $\\cos N\\psi$",
    )
    page.step(
        "For a given stiffness the border moves with",
        diff((u * cot(psi) * sin(N * psi) - 1) / cos(N * psi), psi),
        width.expr / (2 * sin(psi) ** 2 * cos(N * psi) ** 2) * (u - curve),
        name=r"\partial w/\partial\psi",
        because="its sign is that of $u-U$. On each side of $N\\psi=\\pi/2$ the strictest angle is "
        "the one with $U=u$: the lower one bounds $w$ from below, the upper one from above. Where "
        "$u$ is less than $U$ at $\\theta\\to0$, the lower bound is the line of $\\theta\\to0$",
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
        provided=r"d\in\mathbb{N},\ K\ge0,\ 0<\omega T\le\pi/(d+1)",
        unless={d: S.Zero, T: S.One, b: S.One, omega: S.One, K: S.One, B: Rational(1, 2)},
        truth=Eq(b, K * T / 2 + B),
        shows=r"for $d=0$ (7) is the single point $(2b/T,0)$; $(1,\tfrac12)$ lies on (6)",
        note=r"for other $d>0$ it bounds the walls of (5); higher frequencies bound nothing",
    )


def signs(page):
    """Two expressions that are positive on the domain, with the steps that show it."""
    half = Rational(1, 2)
    more, up, room = sign.assume(N - 2), sign.assume(pi - N * psi), sign.assume(pi - (N + 1) * psi)
    size, above = sign.combined(N, [more], [2]), sign.combined(N + 1, [more], [3])
    angles = sign.Interval(psi, S.Zero, (up, size))
    near = sign.Interval(psi, S.Zero, (up, size), (room, above))
    y = angles.above
    side = sign.combined(pi / 2 - psi, [half, up], [half, more, y])
    sin_y = sign.sine(y, sign.combined(pi - psi, [side], [side], [y]))
    cos_y = sign.cosine(y, side)
    sin_n = sign.sine(sign.combined(N * psi, [size, y]), up)
    less = sign.combined((N - 1) * psi, [more, y], [y])
    sin_less = sign.sine(less, sign.combined(pi - less.expr, [up], [y]))
    first = sign.sine(
        sign.combined(less.expr / 2, [half, less]),
        sign.combined(pi - less.expr / 2, [half, up], [half, y], [half, sign.number(pi)]),
    )
    second = sign.sine(
        sign.combined((N + 1) * psi / 2, [half, above, y]),
        sign.combined(pi - (N + 1) * psi / 2, [half, up], [half, side], [sign.number(pi / 4)]),
    )

    falls = sign.combined(cos(psi) - cos(N * psi), [2, first, second])
    flatter = N * sin(psi) - sin(N * psi)
    flatter = sign.integrated(flatter, angles, sign.combined(diff(flatter, psi), [size, falls]))
    width = N * sin(2 * psi) - sin(2 * N * psi)
    width = sign.combined(width, [2, flatter, cos_y], [2, sin_n, falls])
    page.positive("The sine of the larger angle is flatter", flatter, DOMAIN)
    page.positive("So is that of twice the angles", width, DOMAIN)

    lower = sin(N * psi) - N * sin(psi) * cos((N - 1) * psi)
    rise = sign.combined(diff(lower, psi), [size, more, sin_y, sin_less])
    lower = sign.integrated(lower, angles, rise)
    upper = sin(N * psi) - N * sin(psi) * cos((N + 1) * psi)
    sin_above = sign.sine(sign.combined((N + 1) * psi, [above, y]), room)
    rise = sign.combined(
        diff(upper, psi), [size, sin_y, sin_above], [size, above, sin_y, sin_above]
    )
    past = sign.assume((N + 1) * psi - pi, strict=False)
    turned = sign.sine(
        sign.combined((N + 1) * psi - pi / 2, [past], [sign.number(pi / 2)]),
        sign.combined(3 * pi / 2 - (N + 1) * psi, [up], [side]),
    )
    late = sign.combined(upper, [sin_n], [size, sin_y, turned])
    upper = sign.either(sign.integrated(upper, near, rise), late, room.expr)
    page.positive("A chord before", lower, DOMAIN)
    page.positive("A chord after", upper, DOMAIN)

    bend = N * sin(2 * psi) + sin(2 * N * psi) - 4 * sin(N * psi) ** 2 * cot(psi) / N
    product = 4 * lower.expr * upper.expr
    slope = page.step(
        "A slope that factors",
        diff(bend, psi),
        product / (N * sin(psi) ** 2),
        name=rf"\frac{{\partial}}{{\partial\psi}}\Bigl({latex(bend)}\Bigr)",
    )
    top = sign.combined(product, [4, lower, upper])
    slope = sign.quotient(slope, top, sign.combined(N * sin(psi) ** 2, [size, sin_y, sin_y]))
    bend = sign.integrated(bend, angles, slope)
    return width, page.positive("It rises from zero", bend, DOMAIN)

r"""What do the plots of the passive walls show?

Fig. 4 of the paper draws the boundary for seven delays, two of them fractions of a period, and
Fig. 5 the largest stiffness over the delay. The chapters before tell what both look like. For
which delays are they the passive walls?
"""

from sympy import Rational, S, cos, pi, sin, symbols, tan

from symhaptic.model import fractional, passivity
from symhaptic.notation import B, K, T, b, d, epsilon, h, l, theta, x
from symhaptic.paper.figures import DELAYS
from symhaptic.proof import box
from symhaptic.proof.ball import ball
from symhaptic.proof.roots import decimals
from symhaptic.proof.series import limit
from symhaptic.report.figures import largest_stiffness, passive_regions

UNIT = {b: 1, T: 1}


def derive(page):
    stiffness, damping = (e.subs(UNIT) for e in passivity.envelope())
    corner = [limit(e, theta, S.Zero) for e in (stiffness, damping)]
    angle = pi / (2 * (d + 1))
    tip = [e.subs(theta, angle) for e in (stiffness, damping)]
    page.say(
        "In units of $b$ and $T$ a curve of Fig. 4 runs straight from $(0,-1)$ to a corner, bends "
        "to its tip, the point of largest stiffness, and ends at $(0,1)$."
    )
    y = symbols("y")
    delay = 3 * y / (1 - 2 * y)
    dashed = page.step(
        "The dashed curve of the corners, with $y=B/b$",
        corner[0].subs(d, delay),
        2 * (1 + y) * (1 - 2 * y) / (1 + 4 * y),
        name=r"\frac{KT}{b}",
        because="an arc of a hyperbola from $(2,0)$ to $(0,\\tfrac12)$",
    )
    corners = page.same("the corner's damping", corner[1].subs(d, delay), y)
    tips = page.step(
        "The dash-dotted curve of the tips",
        tip[0],
        2 * tan(angle / 2),
        name=r"\frac{KT}{b}",
        because="this is Fig. 5; it falls with every delay",
    )
    low = (cos(angle) - d / (d + 1)) / sin(angle)
    page.step("Their damping", tip[1], low, name=r"\frac Bb")
    page.table(
        "Corner and tip of the seven curves (7) of Fig. 4; decimals cut off.",
        ["$d$", "corner $KT/b$", "corner $B/b$", "tip $KT/b$", "tip $B/b$"],
        [row(text, *corner, tips, low) for text in DELAYS],
    )
    far = {d: 1 / h - 1}
    page.limit("For long delays", tips.subs(far) / h, h, S.Zero, pi / 2, name=r"\frac{KT}{bh}")
    page.limit(
        "The damping that belongs to it",
        low.subs(far),
        h,
        S.Zero,
        2 / pi,
        name=r"\frac Bb",
        because="with $h=1/(d+1)$; the corners run into $(0,\\tfrac12)$",
    )
    fractions(page)
    half = {d: S.Half, T: S.One, b: S.One}
    wall = half | {K: tip[0].subs(d, S.Half), B: tip[1].subs(d, S.Half)}
    page.figure(
        "fig4",
        "Fig. 4 of the paper: boundaries (7) for seven delays, tips (dash-dotted) and corners "
        "(dashed). For $d=0.25$ and $0.5$ the walls inside satisfy (5) but are not all passive.",
        passive_regions,
    )
    page.settle(
        "fig4",
        page.same("dashed", dashed, corner[0].subs(d, delay)),
        corners,
        page.same("dash-dotted", tip[0], tips),
        provided=r"d\in\mathbb{N}_0",
        unless=wall,
        truth=passivity.half_late_energy(Rational(17, 10), S.One, 30) >= 0,
        shows=r"half a period late, the tip of the curve for $d=0.5$ gives energy away",
        note="five of the seven curves are what the caption says, the other two are (5)",
    )
    passive = larger(page)
    page.figure(
        "fig5",
        "Fig. 5 of the paper: the largest stiffness that satisfies (5).",
        largest_stiffness,
    )
    page.settle(
        "fig5",
        page.same("the tip", tip[0], tips),
        passive,
        provided=r"d\in\mathbb{N}_0",
        unless=half,
        truth=tips.subs(d, S.Half) >= Rational("1.17"),
        shows=r"half a period late $KT/b=1.17$ can be passive, and the curve is at 1.1547",
        note="with the delay rounded up the curve is always safe",
    )


def row(text, *values):
    """Decimals of the four coordinates for one delay."""
    cells = [v.subs(d, Rational(text)) for v in values]
    known = [v if v.is_Rational else decimals(ball(v, None, 128).real, 4) for v in cells]
    return [f"${text}$", *(f"${v}$" for v in known)]


def fractions(page):
    """On the straight part, a fractional delay leaves the passive walls."""
    page.say(
        "For whole delays the walls inside are the passive ones. A fraction of a period, "
        "$d=\\ell+\\varepsilon$, has another condition, $D\\ge0$ (chapters on fractional delays)."
    )
    line = {B: K * T * (l + epsilon + Rational(1, 2)) - b}
    page.limit(
        "Low frequencies on the straight part of (7)",
        fractional.margin().subs(line),
        theta,
        S.Zero,
        -epsilon * (1 - epsilon) * (K * T) ** 2 / 4,
        name="D",
        because="negative: no wall with $K>0$ on it is passive",
    )


def larger(page):
    """A passive wall half a period late that is stiffer than the curve."""
    exact = fractional.margin().subs({epsilon: S.Half, l: 0, b: 1, T: 1})
    wall = {K: Rational("1.17"), B: Rational("0.32")}
    square = 32 * x**2 / 25 - 5027 * x / 2500 + Rational(127239, 160000)
    page.show(
        "The wall $KT/b=1.17$, $B/b=0.32$, half a period late",
        "D/b^2",
        square,
        page.same("in x", exact.subs(wall), square.subs(x, cos(theta / 2) ** 2)),
        because="with $x=\\cos^2\\frac\\theta2$",
    )
    return page.positive(
        "It is passive",
        box.positive(square, {x: (0, 1)}),
        on=r"0\le x\le1",
        name="D/b^2",
        because="though the curve of Fig. 5 ends at $2\\tan\\frac\\pi6=1.1547$",
    )

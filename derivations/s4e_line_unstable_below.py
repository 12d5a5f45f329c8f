r"""For which walls is the linear condition safe?

Above its crossing with the boundary the line of (25) is unstable. Below, the line itself is stable.
We ask whether all walls are stable that satisfy (25) and have no more damping than the crossing,
inside the ranges (23).
"""

from sympy import Rational, S, diff

from symhaptic.bounds.linear_points import SHAPE
from symhaptic.model import linear, loop
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.paper.ranges import RANGES
from symhaptic.proof.box import positive

INSIDE = r"\text{inside (23)}"
Y = linear.CHORD


def derive(page):
    flat, rise = 6 * (d + 1) ** 2 + 1, (d + 1) * (2 * d + 1) * (2 * d + 3)
    page.step(
        "The damping of the crossing, for short periods",
        (d + Rational(1, 2)) * flat * delta / rise - delta,
        (2 * d**2 + 2 * d + 1) * delta / (2 * (d + 1) * (2 * d + 3)),
        name=r"\beta_\times",
        because="from $\\alpha_\\times$ found before: a sixth of $\\delta$ for $d=0$, a quarter "
        "for $d=1$, nearly half for long delays",
    )
    facts = []
    for delay, end in ((0, Rational(203, 100)), (1, Rational(61, 100))):
        arc = linear.arc(delay)
        rise = diff(arc.up, Y) * arc.size - arc.up * diff(arc.size, Y)
        facts += [
            page.positive(
                f"Rising damping, $d={delay}$",
                positive(rise, {**RANGES, Y: (0, end)}, SHAPE),
                rf"0\le y\le{float(end):g},\ {INSIDE}",
                name=r"|M|^4\,\frac{d\beta}{dy}",
            ),
            page.positive(
                f"The end of the arc, $d={delay}$",
                positive(-arc.right.subs(Y, end), RANGES, SHAPE),
                rf"y={float(end):g},\ {INSIDE}",
                name=r"-|M|^2(\alpha+\gamma)",
            ),
        ]
    page.say(
        "The walls with (25), $\\alpha>-\\gamma$ and $\\beta\\le\\beta_\\times$ are a triangle "
        "that the boundary does not enter: before the crossing it has $\\Delta<0$, after it "
        "$\\beta>\\beta_\\times$, behind its end $\\alpha<-\\gamma$ and, for $d=1$ and $y>3.36$, "
        "$\\Delta<0$ again. So all of it is stable if one wall of it is, for all of (23) at once, "
        "and for each delay one is:"
    )
    for delay, stiffness in ((0, Rational(4, 100)), (1, Rational(1, 100))):
        at = {alpha: stiffness, beta: S.Zero if delay == 0 else -Rational(5, 1000), d: S(delay)}
        at |= {gamma: Rational(1, 1000), delta: Rational(1, 50)}
        where = f"$d={delay}$, $\\gamma=0.001$, $\\delta=0.02$"
        title = f"{where}: the wall $({float(stiffness):g},{float(at[beta]):g})$"
        facts.append(page.inside(title, loop.named(), at, loop.numbers()))
    page.state(
        "linear-safe",
        "inside (23), for $d=0$ and $d=1$, every wall with (25), $\\alpha>-\\gamma$ and a damping "
        "not above that of the crossing is stable",
    )
    page.settle("linear-safe", *facts, note="with $\\beta_\\times$ that of the only crossing")

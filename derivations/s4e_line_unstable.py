r"""On which side of the exact boundary does the line of the linear condition lie?

The paper says that above its crossing with the boundary the line runs through unstable walls. We
ask whether there is one crossing only, for every spring and damping of the ranges (23).
"""

from sympy import Rational, S

from symhaptic.bounds.linear_points import SHAPE
from symhaptic.model import linear, loop
from symhaptic.notation import alpha, beta, d, delta, gamma, nu, s_1, s_2
from symhaptic.paper.ranges import RANGES
from symhaptic.proof import sign
from symhaptic.proof.box import positive
from symhaptic.proof.plants import AT_ONE, LATE, LOSS, NUMBERS, TOGETHER, named

INSIDE = r"\text{inside (23)}"
SAMPLED = named({number: number for number in NUMBERS})
Y = linear.CHORD
ZERO, ONE = linear.arc(0), linear.arc(1)


def derive(page):
    page.say(
        "The line meets the boundary at the zeros of $|M|^2\\Delta$. By the signs of the arm's "
        "numbers, $g\\ge0$, $s_2>0$ and $0<\\nu\\le\\frac12$, its coefficients from the lowest on "
        "have the signs $-,-,+$ for $d=0$ and $-,-,+,-$ for $d=1$:"
    )
    signs = descartes(page)
    once = once_more(page)
    page.say(
        "By the rule of Descartes there is one positive zero $y_\\times$ for $d=0$, for every arm "
        "up to (30) but the free mass, which meets the line at its start only. For $d=1$ there "
        "are two at most, one of them far left of $\\alpha=-\\gamma$. So for $\\alpha>-\\gamma$ "
        "the line crosses the boundary once. A root at 1 needs $\\alpha=-\\gamma$. A root at $-1$ "
        "needs $1+a+e=(-1)^d(n_1-n_0)(\\alpha+2\\beta)$: not up to the crossing, where "
        "$\\alpha+2\\beta<20$, and beyond such a point the sign of $p_1(-1)$ is that of an "
        "unstable loop. Before it, the number of roots outside is the same for the whole line "
        "above the crossing, for all of (23), and likewise below the crossing. One wall of each:"
    )
    minus = far(page)
    above = witnesses(page)
    page.settle(
        "s4e-unstable-side",
        *signs,
        *once,
        *minus,
        *above,
        note="for $d=0$, $d=1$ and all of (23); without damping the crossing is the origin, and "
        "all of the line with $\\alpha>0$ is unstable",
    )


def descartes(page):
    """Coefficients of the surplus, by sums of positive terms."""
    g, mu = sign.assume(linear.GAP, strict=False), sign.assume(Rational(1, 2) - nu, strict=False)
    spring, damper = sign.assume(gamma, strict=False), sign.assume(delta, strict=False)
    share, mass = sign.assume(nu), sign.assume(s_2)
    quarter, half = Rational(1, 4), Rational(1, 2)
    first = sign.combined(s_1, [g], [damper], [half, spring])
    rest = sign.combined(1 - nu, [half], [mu])
    kappa = sign.combined(nu * (s_2 + (1 - nu) * s_1), [share, mass], [share, rest, first])
    sigma = sign.combined(s_1 + s_2 + nu * (1 - nu) * gamma, [first], [mass], [share, rest, spring])
    small, large = (arc.coefficients(arc.above) for arc in (ZERO, ONE))
    bent = [mu, mass], [quarter, g], [g, mu, mu]
    rows = [
        (0, 1, sign.combined(-small[1], *bent, [half, damper], [quarter, spring])),
        (0, 2, sign.combined(small[2], [half, kappa])),
        (1, 1, sign.combined(-large[1], *bent, [3 * half, g], [2, damper], [5 * half, spring])),
        (1, 2, sign.combined(large[2], [3 * half, sigma], [2, kappa])),
        (1, 3, sign.combined(-large[3], [3 * half, kappa])),
    ]
    for delay, power, fact in rows:
        minus = "" if power == 2 else "-"
        title = f"The coefficient $f_{power}$ of $y^{power}$, $d={delay}$"
        page.positive(title, fact, r"g\ge0", name=f"{minus}f_{power}")
    return [fact for *_, fact in rows]


def once_more(page):
    """The second zero for d = 1 lies where alpha < -gamma."""
    low, high = Rational(332, 100), Rational(336, 100)
    rows = [
        ("At $y=3.32$", positive(ONE.above.subs(Y, low), RANGES, SHAPE), r"|M|^2\Delta", INSIDE),
        ("At $y=3.36$", positive(-ONE.above.subs(Y, high), RANGES, SHAPE), r"-|M|^2\Delta", INSIDE),
        (
            "Between the two, $d=1$",
            positive(-ONE.right, {**RANGES, Y: (low, high)}, SHAPE),
            r"-|M|^2(\alpha+\gamma)",
            rf"3.32\le y\le3.36,\ {INSIDE}",
        ),
    ]
    return [page.positive(title, fact, on, name=name) for title, fact, name, on in rows]


def far(page):
    """A root at -1 is far from the crossing."""
    facts = []
    for delay, arc in ((0, ZERO), (1, ONE)):
        near = positive(5 * arc.size - arc.right, {**RANGES, Y: (0, 1)}, SHAPE)
        facts += [
            page.positive(
                f"The crossing, $d={delay}$",
                positive(arc.above.subs(Y, 1), RANGES, SHAPE),
                rf"y=1,\ {INSIDE}",
                name=r"|M|^2\Delta",
                because="so that $y_\\times<1$",
            ),
            page.positive(
                "Before it",
                near,
                rf"0\le y\le1,\ {INSIDE}",
                name=r"|M|^2(5-\alpha-\gamma)",
                because="on the line $\\alpha+2\\beta=(2d+2)\\alpha-2\\delta<20$",
            ),
        ]
    minus = positive(2 * (2 - LOSS) - AT_ONE - 20 * (TOGETHER - 2 * LATE), RANGES, SAMPLED)
    return [*facts, page.positive("No root at $-1$", minus, INSIDE, name="1+a+e-20(n_1-n_0)")]


def witnesses(page):
    """One wall of the line above and one below the crossing, for each delay."""
    arm = {gamma: Rational(1, 1000), delta: Rational(1, 50)}
    found = []
    for delay, low, high in ((0, Rational(4, 100), Rational(6, 100)), (1, S(1) / 100, S(2) / 100)):
        for kind, stiffness in ((page.inside, low), (page.outside, high)):
            damping = stiffness * (delay + Rational(1, 2)) - arm[delta]
            at = {alpha: stiffness, beta: damping, d: S(delay), **arm}
            where = f"$d={delay}$, $\\gamma=0.001$, $\\delta=0.02$"
            title = f"{where}: the wall $({float(stiffness):g},{float(damping):g})$"
            found.append(kind(title, loop.named(), at, loop.numbers()))
    return found

r"""From which damping on does the error exceed 2 per cent for negative $\beta$?

The paper sees such cases in its Fig. 10 for $\delta>0.015$. Next to the start of the boundary there
are some for every damping, as the error has no bound there. We leave these aside and look at walls
that push, $\alpha\ge0$.
"""

from sympy import Rational, S, diff, tanh

from symhaptic.bounds.linear_points import SHAPE, by_damping, error_without_stiffness
from symhaptic.model import linear
from symhaptic.notation import d, delta, gamma, nu
from symhaptic.paper.ranges import RANGES, STIFF
from symhaptic.proof.ball import ball
from symhaptic.proof.box import positive
from symhaptic.proof.enclosed import sign_change
from symhaptic.proof.roots import BITS

HALF, LEVEL = Rational(1, 2), Rational(2, 100)
Y = linear.CHORD


def derive(page):
    page.say(
        "On all of the arc with $\\beta<0$ the error rises, and is less than $2\\,\\%$ (chapter "
        "s4e_line_error_rises). Among the walls with $\\alpha\\ge0$ there it is therefore beyond "
        "$-2\\,\\%$ for some if and only if it is so at $\\alpha=0$. That error falls with "
        "$\\delta$ at $-2\\,\\%$: without a spring, where it is the limit at the start, by "
        "$h=(d+1)^2\\delta+1-2\\nu-0.02\\,(2d+1)(1+(d+1)\\delta)$; with $\\gamma=0.001$ by the two "
        "conditions $f_1=|M|^2\\alpha=0$ and "
        "$f_2=|M|^2(\\Delta+0.02\\,(d+\\frac12)(\\alpha+\\gamma))=0$, of which the second gives "
        "$\\beta<-\\delta$ on the first."
    )
    falling = [fact for delay in (0, 1) for fact in falls(page, delay)]
    page.say("There is one threshold for each, between two neighbouring decimals:")
    found = [
        (rf"\delta\quad(d={delay},\ \gamma={name})", threshold(spring, delay))
        for delay in (0, 1)
        for spring, name in ((S.Zero, "0"), (STIFF, "0.001"))
    ]
    page.enclosed("The error reaches 2\\,\\% at these dampings", found, places=22)
    case = witnesses(page)
    late = d + 1
    largest = late**2 * delta + 1 / tanh(delta / 2) - 2 / delta
    largest /= (2 * d + 1) * (1 + late * delta)
    page.state(
        "linear-two-percent",
        "for $\\gamma=0.001$ and $\\delta\\le0.02$ the error exceeds 2\\,\\% for a wall of the "
        "boundary with $\\alpha\\ge0$, $\\beta<0$ exactly for $\\delta>0.01743\\ldots$ at $d=0$ "
        "and for $\\delta>0.01480\\ldots$ at $d=1$",
    )
    page.settle("linear-two-percent", *falling, note="and for slightly more without a spring")
    page.settle(
        "s4e-two-percent",
        *case,
        provided=r"\gamma=0.001,\ \text{and}\ d=1\ \text{or}\ \delta>0.01744",
        unless={d: S.Zero, gamma: S.Zero, delta: Rational(16, 1000)},
        truth=largest > LEVEL,
        shows=r"$d=\gamma=0$, $\delta=0.016$: the error is below 1.84\,\% for all $\beta<0$",
        note="such walls with $\\alpha\\ge0$ exist from $\\delta=0.01480$ on for $d=1$, from "
        "$0.01743$ on for $d=0$; with a spring, others next to the start for every $\\delta>0$",
    )


def falls(page, delay):
    """The error at alpha = 0 falls with delta where it is -2 per cent."""
    arc, late = linear.arc(delay), delay + 1
    start = late**2 * delta + 1 - 2 * nu - LEVEL * (2 * delay + 1) * (1 + late * delta)
    one = arc.right - gamma * arc.size
    two = arc.above + LEVEL * (delay + HALF) * arc.right
    low, high = Rational(95, 10**5), Rational(101, 10**5)
    arm = {gamma: (STIFF, STIFF), delta: RANGES[delta]}
    turn = by_damping(one) * diff(two, Y) - by_damping(two) * diff(one, Y)
    soft = positive(by_damping(start), {gamma: (0, 0), delta: RANGES[delta]}, SHAPE)
    narrow = rf"0.00095\le y\le0.00101,\ d={delay}"
    there = rf"\gamma=0.001,\ \delta\le0.02,\ d={delay}"
    rows = [
        ("Without a spring", r"\partial h/\partial\delta", soft, rf"\delta\le0.02,\ d={delay}"),
        ("Before", r"-f_1|_{y=0.00095}", positive(-one.subs(Y, low), arm, SHAPE), there),
        ("Behind", r"f_1|_{y=0.00101}", positive(one.subs(Y, high), arm, SHAPE), there),
        (
            "From the start on",
            r"f_{1,y}",
            positive(diff(one, Y), {**arm, Y: (0, high)}, SHAPE),
            rf"y\le0.00101,\ {there}",
        ),
        (
            "Along $\\alpha=0$",
            r"f_{1,\delta}f_{2,y}-f_{2,\delta}f_{1,y}",
            positive(turn, {**arm, Y: (low, high)}, SHAPE),
            narrow,
        ),
    ]
    return [page.positive(title, fact, on, name=name) for title, name, fact, on in rows]


def threshold(spring, delay):
    """The damping at which the error at alpha = 0 is -2 per cent."""
    level = ball(LEVEL, None, BITS).real
    return sign_change(
        lambda damping: error_without_stiffness(spring, damping, delay) + level,
        Rational(14, 1000),
        Rational(18, 1000),
    )


def witnesses(page):
    """For d = 1 and all dampings from 0.015 on, a wall with alpha > 0 > beta and more than 2 %."""
    arc = linear.arc(1)
    least, later = Rational(15, 1000), r"\in[0.015,0.02]"
    first = {gamma: (STIFF, STIFF), delta: (least, least)}
    arm = {**first, delta: (least, Rational(20, 1000))}
    error = arc.above + LEVEL * (1 + HALF) * arc.right
    rows = [
        ("A wall that pushes", r"|M|^2\alpha", arc.right - gamma * arc.size, arm, later),
        ("Its damping", r"-|M|^2\beta", -arc.up, arm, later),
        ("Beyond $-2\\,\\%$ at first", "-f_2", -error, first, "=0.015"),
        ("And then", r"-f_{2,\delta}", -by_damping(error), arm, later),
    ]
    return [
        page.positive(
            title,
            positive(expr.subs(Y, Rational(105, 10**5)), box, SHAPE),
            r"y=0.00105,\ d=1,\ \gamma=0.001,\ \delta" + on,
            name=name,
        )
        for title, name, expr, box, on in rows
    ]

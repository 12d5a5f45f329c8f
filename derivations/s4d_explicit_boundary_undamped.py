r"""What is the boundary of an arm without damping?

A mass with a spring swings for ever, and its boundary is as short as that of a free mass. It shows
where the boundary goes when $n_1=n_0$ and the line of a root at $-1$ is gone.
"""

from symhaptic.book.lemmas.prelude import *

ANGLE = (d + 1) * theta
SPRING = Symbol("g")


def derive(page):
    swinging = plant.sampled(plant.normalised(Parts(damping=False)), split=2 * I * Omega)
    arm = plant.Sampled(swinging.n1, swinging.n0, swinging.a, S.One)
    stiffness, damping = (side.xreplace({gamma: Omega**2}) for side in boundary.wall(arm))
    page.define("The device swings by this angle in a period", gamma, Omega**2)
    page.define(
        "One function of the spring decides",
        SPRING,
        gamma * (cos(Omega) - cos(theta)) / (1 - cos(Omega)),
    )
    first, second = cos(ANGLE) / cos(theta / 2) ** 2, 2 * sin(ANGLE) / sin(theta)
    page.step(
        "The boundary of an undamped device has one stiffness at each angle",
        stiffness,
        SPRING * first,
        name=r"\alpha(\theta)",
        boxed=True,
        because="for every real $d$ on the principal sheet, and $\\cos\\Omega\\ne1$",
    )
    page.step(
        "The boundary's damping is given by a sine",
        stiffness + 2 * damping,
        SPRING * second,
        name=r"\alpha(\theta)+2\beta(\theta)",
        boxed=True,
    )
    per_gamma = (x - cos(theta)) / (1 - x)
    begin(page, per_gamma * first, per_gamma * (second - first) / 2)
    end(page)


def begin(page, stiffness, damping):
    """The end at theta -> 0, in units of gamma, with x = cos Omega."""
    half = Rational(1, 2)
    page.say(
        "It starts on the line $\\beta=\\alpha(d+\\frac12)$ of (25), but flatter; with "
        "$x=\\cos\\Omega$:"
    )
    page.limit(
        "The boundary starts from the stiffness $-\\gamma$",
        stiffness,
        theta,
        S.Zero,
        S.NegativeOne,
        name=r"\alpha(\theta)/\gamma",
    )
    page.limit(
        "The boundary starts from the damping $-(d+\\frac12)\\gamma$",
        damping,
        theta,
        S.Zero,
        -(d + half),
        name=r"\beta(\theta)/\gamma",
    )
    right = (1 + x) / (4 * (1 - x)) + (d + 1) ** 2 / 2
    up = (d + half) * right - (d + 1) * (2 * d + 1) * (2 * d + 3) / 12
    name = r"\frac{\alpha(\theta)+\gamma}{\gamma\theta^2}"
    page.limit(
        "From its start the boundary goes to the right in the second order",
        (stiffness + 1) / theta**2,
        theta,
        S.Zero,
        right,
        name=name,
    )
    page.limits((damping + d + half) / theta**2, theta, S.Zero, up)
    page.step(
        "At its start the boundary is flatter than the line",
        up / right,
        d + half - (d + 1) * (2 * d + 1) * (2 * d + 3) / (12 * right),
        name=r"\frac{d\beta}{d\alpha}",
        because="flatter for every spring and every delay; only for a free mass, $x\\to1$, it is "
        "the line's",
    )


def end(page):
    """The end at theta -> pi, for whole delays."""
    page.say(
        "Towards the other end, for whole $d$, both grow without bound, as $n_1=n_0$ has no line "
        "of a root at $-1$. As $\\sin(d+1)\\theta=(-1)^d\\sin(d+1)(\\pi-\\theta)$, their sum stays "
        "close to a line:"
    )
    per_gamma = (x - cos(theta)) / (1 - x)
    page.limit(
        "Stiffness and twice the damping approach a line",
        2 * per_gamma * sin((d + 1) * (pi - theta)) / sin(theta),
        theta,
        pi,
        2 * (d + 1) * (1 + x) / (1 - x),
        name=r"(-1)^d\,\frac{\alpha(\theta)+2\beta(\theta)}{\gamma}",
    )
    per_gamma = per_gamma.subs(x, -1)
    page.step(
        "For odd half swings, $x=-1$, it stays finite",
        per_gamma * cos(ANGLE) / cos(theta / 2) ** 2,
        -cos(ANGLE),
        name=r"\frac{\alpha}{\gamma}\Big|_{x=-1}",
    )
    page.step(
        "For $x=-1$ the damping stays finite, too",
        2 * per_gamma * sin(ANGLE) / sin(theta),
        -sin(ANGLE) / tan(theta / 2),
        name=r"\frac{\alpha+2\beta}{\gamma}\Big|_{x=-1}",
        because="so that it ends at $\\alpha=(-1)^d\\gamma$, $\\beta=-\\alpha/2$",
    )

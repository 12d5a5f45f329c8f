r"""Is there an explicit solution with a delay of one period?

The paper says that only an implicit one could be determined for $d=1$. We write it down, for every
device, and find that it is quadratic in $\alpha$. For longer delays we show that it says the same
as the boundary whose every point is explicit.
"""

from sympy import Rational, S, sqrt

from symhaptic.book.figures.passivity import free_mass_inequalities
from symhaptic.model import boundary, jury, plant
from symhaptic.model.parts import Parts
from symhaptic.model.plant import Sampled
from symhaptic.notation import a, alpha, beta, d, delta, e, n_0, n_1
from symhaptic.proof.sign import assume, combined, quotient

FREE = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
RISE = n_1 + n_0


def derive(page):
    minor = jury.criterion(jury.coefficients(1)).expressions[-1]
    low = n_0 * alpha - (n_1 - n_0) * beta
    page.step(
        "For one period of delay the last minor is a difference of two products",
        minor,
        (1 + n_0 * beta) ** 2 * (1 - e - n_1 * (alpha + beta) - n_0 * beta)
        - (low + a) * (low - a * n_0 * beta),
        name=r"\Delta_3",
        because="for every device",
    )
    page.say("Without a spring, $a=1+e$ and $\\delta(n_1+n_0)=1-e$, it is quadratic in $\\alpha$:")
    damped = {a: 1 + e, e: 1 - delta * RISE}
    linear = n_0**2 * n_1 * beta**2 + (1 - e) * n_0**2 * beta + (1 + e) * n_0 + n_1
    constant = RISE * (beta + delta) * (1 - (n_1 + e * n_0) * beta - n_0**2 * beta**2)
    implicit = constant - linear * alpha - n_0**2 * alpha**2
    proof = page.same(
        "quadratic", minor.subs(a, damped[a]).subs(e, damped[e]), implicit.subs(e, damped[e])
    )
    page.show("The condition is implicit", r"\Delta_3", implicit, proof, boxed=True)
    root = (sqrt(linear**2 + 4 * n_0**2 * constant) - linear) / (2 * n_0**2)
    page.same("a root", implicit.subs(alpha, root), S.Zero)
    page.say(
        "So one period of delay has an explicit solution too, by a square root. It is shortest for "
        "a free mass, where $p_1(-1)=4$ and four inequalities are left:"
    )
    free_mass(page)
    two_roads(page)


def free_mass(page):
    minor = 2 * beta * (4 - 4 * beta - beta**2) - (beta**2 + 12) * alpha - 2 * alpha**2
    plane = 4 - alpha - 4 * beta
    page.result(
        "A wall of a free mass, one period late, is stable if and only if",
        (alpha > 0, plane > 0, 2 + beta > 0, minor > 0),
        equal_to=jury.inequalities(1, FREE),
    )
    page.say(
        "For $-2<\\beta\\le0$ the last one cannot hold, as $4-4\\beta-\\beta^2=4-\\beta(4+\\beta)$ "
        "is positive. So $\\beta>0$, and then the second is idle:"
    )
    push, brake, last = assume(alpha), assume(beta), assume(minor)
    rest = combined(
        8 * beta * (1 - beta), [last], [2, *[brake] * 3], [12, push], [push, brake, brake],
        [2, push, push],
    )  # fmt: skip
    room = quotient(1 - beta, rest, combined(8 * beta, [8, brake]))
    plane = combined(
        plane,
        [Rational(1, 12), last],
        [Rational(10, 3), room],
        [Rational(2, 3), room, room],
        [Rational(1, 6), *[brake] * 3],
        [Rational(1, 12), push, brake, brake],
        [Rational(1, 6), push, push],
    )
    page.positive(
        "The second half plane follows from the minor", plane, r"\alpha>0,\ \beta>0,\ \Delta_3>0"
    )
    page.say(
        "What is left, $\\alpha>0$ and $\\Delta_3>0$, lies between 0 and the larger root of a "
        "quadratic in $\\alpha$ whose roots have different signs if $4-4\\beta-\\beta^2>0$, that "
        "is for $0<\\beta<2\\sqrt2-2$:"
    )
    square = beta**2 + 12
    explicit = (sqrt(square**2 + 16 * beta * (4 - 4 * beta - beta**2)) - square) / 4
    proof = page.same("a root", minor.subs(alpha, explicit), S.Zero)
    page.show("The stable walls lie below", alpha, explicit, proof, boxed=True)


def two_roads(page):
    device = Sampled(n_1, n_0, a, e)
    page.say(
        "With every period the degree in $\\alpha$ rises by one, so that solving for it soon ends. "
        "But the boundary stays explicit. Put the wall of a root at $e^{j\\theta}$ into the last "
        "minor, with any numbers of the device, for $d=0,1,2$:"
    )
    stiffness, damping = boundary.wall(device)
    for delay in range(3):
        minor = jury.criterion(jury.coefficients(delay)).expressions[-1]
        wall = {alpha: stiffness.subs(d, delay), beta: damping.subs(d, delay)}
        proof = page.same(f"delay {delay}", minor.subs(wall, simultaneous=True), S.Zero)
    page.show(
        "Both roads lead to one curve",
        r"\Delta_{d+2}\bigl(\alpha(\theta),\beta(\theta)\bigr)",
        S.Zero,
        proof,
        because="$\\alpha+\\beta(1-1/z)=-z^dA/N$ on the circle",
    )
    page.figure(
        "jury",
        "Free mass, two periods late: where each inequality turns false (lines), where all hold "
        "(green), and points of the explicit boundary (dots). The thick line is the last minor; "
        "only it and $\\alpha=0$ bound the region.",
        free_mass_inequalities,
    )

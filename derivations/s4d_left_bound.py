r"""Does the stable region end at $\alpha=-\gamma$ on the left?

A wall that pulls harder than the arm's spring holds cannot be stable. We ask whether this is the
only limit on the left: does the stable region always reach the line $\alpha=-\gamma$?
"""

from sympy import I, diff, exp, sin

from symhaptic.model import loop, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import alpha, beta, c, d, delta, gamma, n_0, n_1, phi, t, v, x, z


def derive(page):
    given = {gamma: (delta**2 - c**2) / 4}
    device = plant.sampled(plant.normalised(FULL), split=c)
    alone = plant.sampled(plant.normalised(Parts(stiffness=False)))
    total = device.n1 + device.n0
    page.show(
        "At $z=1$ the polynomial is a multiple of $\\alpha+\\gamma$",
        "p_1(1)",
        (n_1 + n_0) * (alpha + gamma),
        page.same(
            "at z = 1",
            loop.characteristic(split=c).subs(z, 1).xreplace(given),
            (total * (alpha + gamma)).xreplace(given),
        ),
        because="a monic real polynomial with all roots inside the unit circle is positive there",
    )
    page.step(
        "An overdamped device has a positive sum",
        (total * gamma).xreplace(given),
        (1 - exp(-(delta - c) / 2)) * (1 - exp(-(delta + c) / 2)),
        name=r"\gamma(n_1+n_0)\big|_{c\ge0}",
        because="both factors are positive for $0\\le c<\\delta$, that is $\\gamma>0$",
    )
    page.step(
        "A swinging device has a positive sum",
        (total * gamma).xreplace(given).subs(c, 2 * I * phi),
        (1 - exp(-delta / 2)) ** 2 + 4 * exp(-delta / 2) * sin(phi / 2) ** 2,
        name=r"\gamma(n_1+n_0)\big|_{c=2j\varphi}",
        because="with $c=2j\\varphi$; zero only for $\\delta=0$ and whole swings, "
        "$\\varphi=2\\pi,4\\pi,\\ldots$, where $p_1(1)=0$ for every wall and none is stable",
    )
    page.step(
        "Without a spring the sum is positive",
        alone.n1 + alone.n0,
        (1 - exp(-delta)) / delta,
        name=r"(n_1+n_0)\big|_{\gamma=0}",
        because="positive too, and 1 for $\\delta\\to0$",
    )
    page.say(
        "So $\\alpha>-\\gamma$ is necessary for every delay and every damping. Is it also where "
        "the region ends? Without delay, look at the wall $\\alpha=-\\gamma$, $\\beta=0$:"
    )
    speed = plant.normalised(FULL).transition(t, c)
    kept = speed[1, 1].subs(t, 1)
    at_line = loop.characteristic(FULL, split=c).subs({d: 0, alpha: -gamma, beta: 0})
    page.show(
        "For $d=0$ the roots are 0, 1 and a speed",
        "p_1(z)",
        z * (z - 1) * (z - x),
        page.same("roots", at_line.xreplace(given), (z * (z - 1) * (z - kept)).xreplace(given)),
        because="$x$ is the speed that is left after one period of a unit speed, without a wall",
    )
    place, velocity = speed[0, 1].xreplace(given), speed[1, 1].xreplace(given)
    page.show(
        "The energy of that motion falls",
        r"\tfrac{d}{dt}(v^2+\gamma x^2)",
        -2 * delta * v**2,
        page.same(
            "energy", diff(velocity**2 + given[gamma] * place**2, t), -2 * delta * velocity**2
        ),
        because="so the speed left is less than 1, but for $\\delta=0$ and whole half swings",
    )
    page.show(
        "At the root 1 the slope is positive",
        r"p_1'(1)",
        1 - x,
        page.same("slope", diff(at_line, z).subs(z, 1).xreplace(given), (1 - kept).xreplace(given)),
        because="positive, as is $\\partial p_1/\\partial\\alpha=n_1+n_0$: the root moves inside "
        "as $\\alpha$ grows",
    )
    free = loop.characteristic(Parts(False, False)).subs({d: 0, alpha: 0})
    page.step(
        "For a free mass, $d=0$, the polynomial has the root 1",
        free,
        (z - 1) * (z**2 + (beta / 2 - 1) * z + beta / 2),
        name="p_1(z)",
        because="on the line $\\alpha=0$; the quadratic has both roots inside for $0<\\beta<2$",
    )
    page.say(
        "So without delay the region touches the line: there the left bound is "
        "$\\alpha=-\\gamma$, but for whole half swings without damping. What a delay changes is "
        "asked in \\chapter{s4d_left_bound_delayed}."
    )

r"""How stiff may the physical spring be before sampling misses its oscillation?

A device on a spring oscillates. Sampling can follow that up to the Nyquist frequency; we ask for
which stiffness it is reached, and what happens to the loop there.
"""

from sympy import Eq, I, S, pi, sqrt

from symhaptic.model import loop, plant
from symhaptic.model.plant import Plant
from symhaptic.notation import T, alpha, b, beta, d, delta, gamma, k, m, omega, z
from symhaptic.scene import Parts


def derive(page):
    damped = Plant()
    rate = sqrt(k / m - b**2 / (4 * m**2))
    one, two = damped.poles(2 * I * rate)
    page.step(
        "Poles of a swinging device",
        damped.characteristic.subs("s", one),
        S.Zero,
        name=r"ms^2+bs+k\,\big|_{s=-\frac{b}{2m}+j\omega}",
        because="with $\\omega$ as follows, real where $k>b^2/(4m)$",
        paper="28",
    )
    frequency = (one - two) / (2 * I)
    page.settle("eq28", Eq(omega, frequency))
    unit = plant.normalised(Parts())
    turns = sqrt(gamma - delta**2 / 4)
    page.step(
        "In units of mass and period",
        unit.characteristic.subs("s", unit.poles(2 * I * turns)[0]),
        S.Zero,
        name=r"s^2+\delta s+\gamma\,\big|_{s=-\delta/2+j\omega T}",
        because="with $\\omega T=\\sqrt{\\gamma-\\delta^2/4}$",
        paper="29",
    )
    page.settle("eq29", Eq(omega, turns / T))
    page.say(
        "The Nyquist frequency is $\\omega T=\\pi$. Both sides being positive, "
        "$\\omega T\\le\\pi$ is the same as their squares:"
    )
    page.result(
        "Below the Nyquist frequency",
        gamma - delta**2 / 4 <= pi**2,
        equal_to=turns**2 <= pi**2,
        paper="30",
    )
    page.settle("eq30", turns**2 <= pi**2)
    page.say(
        "Without damping the sampled device degenerates there: it returns to its mirror image "
        "after each period. Its numerator shares the double pole at $-1$ once."
    )
    undamped = Parts(damping=False)
    stuck = loop.characteristic(undamped).subs(gamma, pi**2)
    rest = page.step(
        "The polynomial at $\\gamma=\\pi^2$, $\\delta=0$",
        stuck,
        (z + 1) * ((z + 1) * z ** (d + 1) + 2 * ((alpha + beta) * z - beta) / pi**2),
        name="p_1(z)",
        because="the root at $-1$ is there for every wall and every delay",
    )
    page.settle(
        "s5c-undamped-limit",
        page.same("a root at -1", rest.subs(z, -1), S.Zero),
        note="no wall is asymptotically stable there; a second root at $-1$ or one outside makes "
        "it unstable",
    )

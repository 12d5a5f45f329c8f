r"""Which walls does no spring destabilise?

A wall is robustly stable if it is stable with every spring, $0\le\gamma\le\pi^2+\delta^2/4$. Passive
walls are, by an earlier chapter. Are there others, and are there any without damping?
"""

from sympy import I, S, cos, exp, pi, sin, symbols, tan

from symhaptic.model import loop, passivity, plant
from symhaptic.model.passivity import on_circle, real_part
from symhaptic.notation import B, K, Omega, T, alpha, beta, d, delta, gamma, n_0, n_1, phi, theta, z
from symhaptic.report.stability_figures import springs
from symhaptic.scene import Parts


def derive(page):
    undamped = Parts(damping=False)
    device = plant.sampled(plant.normalised(undamped))
    n = symbols("n")
    size = (1 - cos(Omega)) / Omega**2
    swing = {gamma: Omega**2}
    page.say(
        "Without damping the device on a spring swings for ever, by $\\Omega=\\sqrt\\gamma$ per period. "
        "Its two numerator coefficients are one number, $n=(1-\\cos\\Omega)/\\Omega^2$. On the circle "
        "the characteristic polynomial is a real number plus a turning one:"
    )
    turning = exp(-I * (d + 1) * theta) * (
        alpha * cos(theta / 2) + I * (alpha + 2 * beta) * sin(theta / 2)
    )
    flat = 2 * (cos(theta) - cos(Omega))
    whole = on_circle(loop.characteristic(undamped) * z ** (-d - 2)).subs(swing)
    page.show(
        "The polynomial without damping",
        r"z^{-(d+2)}p_1(z)",
        2 * (cos(theta) - cos(Omega)) + 2 * n * cos(theta / 2) * symbols("V"),
        page.same("on the circle", whole, flat + 2 * size * cos(theta / 2) * turning),
    )
    print(whole)

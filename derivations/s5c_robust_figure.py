r"""Which walls does no spring destabilise?

A wall is robustly stable if it is stable with every spring, $0\le\gamma\le\pi^2+\delta^2/4$.
Passive walls are, for whole delays, by an earlier chapter; without damping none is, by the chapter
before. We ask what a little damping leaves.
"""

from sympy import I, S, cos, exp, sin

from symhaptic.model import boundary, passivity
from symhaptic.model.passivity import on_circle, real_part
from symhaptic.notation import B, K, T, a, alpha, beta, d, e, n_0, n_1, theta, z
from symhaptic.report.stability_figures import springs


def derive(page):
    turned = exp(-I * (d + 1) * theta)
    turned *= alpha * cos(theta / 2) + I * (alpha + 2 * beta) * sin(theta / 2)
    need = passivity.dirichlet_form().subs({K: alpha, B: beta, T: S.One})
    pull = -2 * n_1 * cos(theta / 2) * turned / (2 * I * sin(theta))
    page.say(
        "In the notation of the chapter before, a little damping moves the plant's roots "
        "$e^{\\pm j\\Omega}$ inside by $\\delta/2$. A weak wall moves them by its part of the "
        "polynomial over the slope of the plant's. At the plant's own angle, $\\theta=\\Omega$:"
    )
    page.step(
        "How far the wall pulls a root out",
        real_part(pull),
        n_1 * need,
        name=r"\Re\frac{-2n_1\cos\frac\theta2\,V}{2j\sin\theta}",
        because="the bracket, $\\alpha\\sin(d+\\frac12)\\theta/(2\\sin\\frac\\theta2)-\\beta\\cos"
        "(d+1)\\theta$, is the damping that passivity wants at this angle",
    )
    page.say(
        "To first order a wall is therefore robustly stable if, at every angle, passivity wants "
        "less than $\\delta/(2n_1)=\\delta\\,(\\tfrac\\theta2)^2/\\sin^2\\tfrac\\theta2$: up to "
        "$\\pi^2/4$ times what the device has, most at high frequencies. (Not at $\\theta=\\pi$, "
        "where two roots of the plant meet.) Long delays bring the passive boundary to low "
        "frequencies, and so the two regions together: for $\\delta=0.02$ the robust one is 1.25, "
        "1.19 and 1.08 times as large as the passive one for $d=0$, 1 and 2."
    )
    page.figure(
        "fig13",
        "Fig. 13 of the paper: stable walls for 41 springs up to the Nyquist frequency, with "
        "close-ups. Green: passive walls by (27). Black: walls stable for all springs. Half a "
        "period is drawn exactly, and below as the paper reads it: another region if $\\gamma>2$.",
        springs,
        panels=(5, 3),
        height=1.5,
    )
    bottom, top = z**2 - a * z + e, n_1 * z + n_0
    stiffness, damping = boundary.solved(on_circle(-(z**d) * bottom / top))
    wall = {K: stiffness, B: damping, T: S.One}
    page.settle(
        "fig13",
        page.same(
            "the delay drops out",
            passivity.dirichlet_form().subs(wall, simultaneous=True),
            real_part(on_circle(bottom / ((z - 1) * top))),
        ),
        note="no drawn curve enters the passive walls, as for Fig. 11",
    )

r"""Which walls does no spring destabilise?

A wall is robustly stable if it is stable with every spring, $0\le\gamma\le\pi^2+\delta^2/4$.
Passive walls are, for whole delays, by \chapter{s5a_passive_is_robust}; without damping none is, by
\chapter{s5c_robust}. We ask what a little damping leaves.
"""

from symhaptic.book.figures.stability import springs
from symhaptic.book.lemmas.one_plane import up_to_nyquist
from symhaptic.book.lemmas.prelude import *


def derive(page):
    turned = exp(-I * (d + 1) * theta)
    turned *= alpha * cos(theta / 2) + I * (alpha + 2 * beta) * sin(theta / 2)
    need = passivity.dirichlet_form().subs({K: alpha, B: beta, T: S.One})
    pull = -2 * n_1 * cos(theta / 2) * turned / (2 * I * sin(theta))
    page.say(
        "In the notation of \\chapter{s5c_robust}, a little damping moves the plant's roots "
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
        "$\\pi^2/4$ times what the device has, most at high frequencies. (Not at $\\theta=0$ and "
        "$\\pi$, where two roots of the plant meet.) Long delays bring the passive boundary to low "
        "frequencies, and so the two regions together: for $\\delta=0.02$ the robust one is 1.25, "
        "1.19 and 1.08 times as large as the passive one for $d=0$, 1 and 2."
    )
    undamped, apart = plant.normalised(Parts(damping=False)), 2 * I * Omega
    late = fractional.late(undamped, split=apart)
    page.step(
        "At $z=e^{j\\Omega}$ a fraction of a period only turns",
        on_circle(late.numerator / late.device.numerator, Omega).subs(gamma, Omega**2),
        exp(I * (1 - epsilon) * Omega),
        name=r"\frac{M(e^{j\Omega})}{N(e^{j\Omega})}",
        because="that is $z^{1-\\varepsilon}$: there the delay by a fraction turns the force by "
        "$e^{-j\\varepsilon\\Omega}$, as the paper reads it",
    )
    page.say(
        "So to first order both readings have one robust region, although the stable regions of "
        "stiff springs are not at all alike: in the figure half a period stands once for a force "
        "that is really late and once for the paper's reading."
    )
    page.figure(
        "fig13",
        "Fig. 13 of the paper: stable walls for 41 springs up to the Nyquist frequency, with "
        "close-ups. Green: passive walls by (27). Black: walls stable for all springs. For "
        "$d=0.5$ the force is late by half a period; below it the paper's reading.",
        springs,
        panels=(5, 3),
        height=1.5,
    )
    page.settle(
        "fig13",
        up_to_nyquist(),
        note="the text does not say which polynomial the curves for $d=\\tfrac12$ belong to, so "
        "that of this delay only the passive walls are claimed to be robustly stable. One "
        "$\\delta$ stands for passivity and stability; for a held device the passive walls drawn "
        "here are at least 32 times too large (\\texttt{one-delta-figures})",
    )

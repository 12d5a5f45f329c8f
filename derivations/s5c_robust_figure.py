r"""Which walls are stable with every spring?

A wall is robustly stable if it is stable with every spring, $0\le\gamma\le\pi^2+\delta^2/4$.
Passive walls are robustly stable for integer delays, by \chapter{s5a_passive_is_robust}; without
damping no wall is, by \chapter{s5c_robust}. We ask which walls are robustly stable with little
damping.
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
        r"In the notation of \chapter{s5c_robust}, a little damping moves the plant's roots "
        r"$e^{\pm j\Omega}$ inside by $\delta/2$. A wall of small gain moves them by its part of "
        r"the polynomial over the derivative of the plant's part. At $\theta=\Omega$:"
    )
    page.step(
        "The distance by which the wall moves a root outwards",
        real_part(pull),
        n_1 * need,
        name=r"\Re\frac{-2n_1\cos\frac\theta2\,V}{2j\sin\theta}",
        because="the bracket, "
        r"$\alpha\sin(d+\frac12)\theta/(2\sin\frac\theta2)-\beta\cos(d+1)\theta$, is the "
        "damping that passivity requires at this angle",
    )
    page.say(
        "To first order a wall is therefore robustly stable if, at every angle, the damping that "
        "passivity requires is less than "
        r"$\delta/(2n_1)=\delta\,(\tfrac\theta2)^2/\sin^2\tfrac\theta2$. This bound grows with the "
        r"frequency, up to $\pi^2/4$ times the damping of the device. (This does not "
        r"apply at $\theta=0$ and $\pi$, where two roots of the plant meet.) With long delays low "
        r"frequencies decide, and the two regions approach each other: for $\delta=0.02$ the "
        "robust one is 1.25, 1.19 and 1.08 times as large as the passive one for $d=0$, 1 and 2."
    )
    undamped, apart = plant.normalised(Parts(damping=False)), 2 * I * Omega
    late = fractional.late(undamped, split=apart)
    page.step(
        r"At $z=e^{j\Omega}$ a fractional delay changes only the phase",
        on_circle(late.numerator / late.device.numerator, Omega).subs(gamma, Omega**2),
        exp(I * (1 - epsilon) * Omega),
        name=r"\frac{M(e^{j\Omega})}{N(e^{j\Omega})}",
        because=r"that is $z^{1-\varepsilon}$: there the fractional delay multiplies the force by "
        r"$e^{-j\varepsilon\Omega}$, as the paper reads it",
    )
    page.say(
        "So to first order both readings have the same robust region, although their stable "
        "regions for stiff springs differ. The figure shows a delay of half a period twice: for a "
        "delayed force and for the paper's reading."
    )
    page.figure(
        "fig13",
        "Fig. 13 of the paper: stable walls for 41 springs up to the Nyquist frequency, with "
        "close-ups. Green: passive walls by (27). Black: walls stable for all springs. For "
        "$d=0.5$ the force is delayed by half a period; below, the paper's reading.",
        springs,
        panels=(5, 3),
        height=1.5,
    )
    page.settle(
        "fig13",
        up_to_nyquist(),
        note=r"the text does not say which polynomial the curves for $d=\tfrac12$ belong to, so "
        "that of this delay only the passive walls are claimed to be robustly stable. One "
        r"$\delta$ stands for passivity and stability; for a device with an arm the passive "
        r"regions drawn here are at least 32 times too large (\texttt{one-delta-figures})",
    )

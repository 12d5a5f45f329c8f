r"""Which walls are stable with every spring?

A wall is robustly stable if it is stable with every spring, $0\le\gamma\le\pi^2+\delta^2/4$. For
integer delays, passive walls are robustly stable (\chapter{s5a_passive_is_robust}). Without
damping, no wall is robustly stable (\chapter{s5c_robust}). We ask which walls are robustly stable
with little damping.
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
        r"We use the notation of \chapter{s5c_robust}. A little damping moves the plant's roots "
        r"$e^{\pm j\Omega}$ inside by $\delta/2$. A wall of small gain also moves them, by the "
        "quotient of the wall's part of the polynomial and the derivative of the plant's part. "
        r"At $\theta=\Omega$ the motion of the root is proportional to one number:"
    )
    page.step(
        "The wall moves a root outwards by a multiple of the required damping",
        real_part(pull),
        n_1 * need,
        name=r"\Re\frac{-2n_1\cos\frac\theta2\,V}{2j\sin\theta}",
        because="the bracket, "
        r"$\alpha\sin(d+\frac12)\theta/(2\sin\frac\theta2)-\beta\cos(d+1)\theta$, is the "
        "damping that passivity requires at this angle",
    )
    page.say(
        "To first order a wall is therefore robustly stable if, at every angle, the damping "
        "that passivity requires is less than "
        r"$\delta/(2n_1)=\delta\,(\tfrac\theta2)^2/\sin^2\tfrac\theta2$. This bound grows with "
        r"the frequency, up to $\pi^2/4$ times the damping of the device. (The argument does not "
        r"apply at $\theta=0$ and $\pi$, where two roots of the plant coincide.) With long "
        "delays, low frequencies decide, and the robustly stable region approaches the passive "
        r"region. For $\delta=0.02$ the robustly stable region is 1.25, 1.19 and 1.08 times as "
        "large as the passive region for $d=0$, 1 and 2."
    )
    undamped, apart = plant.normalised(Parts(damping=False)), 2 * I * Omega
    late = fractional.late(undamped, split=apart)
    page.step(
        r"At $z=e^{j\Omega}$ a fractional delay changes only the phase",
        on_circle(late.numerator / late.device.numerator, Omega).subs(gamma, Omega**2),
        exp(I * (1 - epsilon) * Omega),
        name=r"\frac{M(e^{j\Omega})}{N(e^{j\Omega})}",
        because=r"the quotient is $z^{1-\varepsilon}$: at this frequency the fractional delay "
        r"multiplies the force by $e^{-j\varepsilon\Omega}$, as in the paper",
    )
    page.say(
        "So, to first order, the two readings of a fractional delay have the same robustly "
        "stable region, although their stable regions for stiff springs differ. The figure "
        "shows a delay of half a period twice: for a delayed force and for the paper's reading."
    )
    page.figure(
        "fig13",
        "Fig. 13 of the paper: stable walls for 41 springs up to the Nyquist frequency, with "
        "close-ups. The green walls are passive by (27), and the black walls are stable for all "
        "springs. For $d=0.5$ the upper figure shows a force that is delayed by half a period, and "
        "the lower figure shows the paper's reading.",
        springs,
        panels=(5, 3),
        height=1.5,
    )
    page.settle(
        "fig13",
        up_to_nyquist(),
        note=r"the text does not say which polynomial the curves for $d=\tfrac12$ belong to. "
        "Therefore the claim for this delay is only that the passive walls are robustly stable. "
        r"The figure uses the same $\delta$ for passivity and stability; for a device with an "
        "arm, the passive regions drawn here are at least 32 times too large "
        r"(\texttt{one-delta-figures})",
    )

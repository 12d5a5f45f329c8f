r"""Do the stability boundaries of Fig. 11 intersect the passive regions?

Fig. 11 of the paper draws both kinds of boundary in one plane, for $\gamma=0.001$, $\delta=0.02$
and seven delays, two of them fractions of a period. For integer delays passive walls are stable, by
\chapter{s5a_passive_is_stable}. What do the curves for $d=\tfrac14$ and $d=\tfrac12$ show?
"""

from symhaptic.book.figures.stability import passive_and_stable
from symhaptic.book.lemmas.enclosed import enclosed_walls_are_stable
from symhaptic.book.lemmas.one_plane import (
    held_passive_is_stable,
    in_one_plane,
    passive_curve,
    stable_curve,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.plots import dashed


def derive(page):
    bottom, top = z**2 - a * z + e, n_1 * z + n_0
    stiffness, damping = boundary.solved(on_circle(-(z**d) * bottom / top))
    page.say(
        r"Take a point $(\alpha,\beta)$ of the explicit boundary, whose root is $z=e^{j\theta}$, "
        "and compute the damping that passivity requires at the same angle:"
    )
    wall = {K: stiffness, B: damping, T: S.One}
    size = n_1**2 + n_0**2 + 2 * n_1 * n_0 * cos(theta)
    need = (1 + a - e) * n_1 + (1 - a - e) * n_0 + 2 * (n_0 - e * n_1) * cos(theta)
    page.same("A", need / (2 * size), real_part(on_circle(bottom / ((z - 1) * top))))
    page.step(
        r"At the angle of the root the required damping is $\Re\{A/((z-1)N)\}$",
        passivity.dirichlet_form().subs(wall, simultaneous=True),
        need / (2 * size),
        name=r"\frac{\alpha\sin(d+\frac12)\theta}{2\sin\frac\theta2}-\beta\cos(d+1)\theta",
        because=r"the delay cancels: this is $\Re\{A/((z-1)N)\}$ for every real $d$, where $z^d$ "
        r"is "
        r"read as $e^{jd\theta}$",
    )
    page.say(
        r"By the energy of \chapter{s5a_passive_is_stable} the right side is larger than $\delta$ "
        r"for $0<\theta\le\pi$. The curve therefore never enters the passive region, for any "
        r"stiffness, damping and delay, if fractional delays are read as $z^{-d}=e^{-jd\theta}$."
    )
    page.say(
        "A force with a fractional delay has other boundaries, the solid ones here. They differ "
        r"from the paper's by 1.6 % of the largest stiffness for $d=\tfrac14$ and by 0.3 % for "
        r"$d=\tfrac12$. All walls of (27) seem to lie inside: of $4\cdot10^5$ on its border none "
        "was found unstable. This is evidence and not a proof. The walls of (27) for the next "
        r"integer delay do lie inside, by \chapter{s6g_next_whole_delay} and "
        r"\chapter{s6e_fractional_passive_is_stable}."
    )
    page.figure(
        "fig11",
        "Fig. 11 of the paper: stable walls (solid) and passive walls (dashed), for "
        "$\\gamma=0.001$, $\\delta=0.02$; (b) is the framed part of (a). Dotted: the paper's "
        "reading of $d=\\frac14$ and $d=\\frac12$. Dash-dotted: the largest stable stiffness.",
        passive_and_stable,
        panels=(1, 2),
        height=0.62,
    )
    _settled(page)


def _settled(page):
    page.lemma(
        r"The walls of the curve (27) for $\delta=0.02$ are on the boundary of the passive ones, "
        "and above its corner there are no others",
        passive_curve(dashed()),
        because=r"up to $\hat\omega=\pi/(d+1)$ and for integer delays, as in Fig. 4",
    )
    page.lemma(
        "The walls of the other curve have a zero on the circle, and none of them is stable",
        stable_curve(),
        because="with integer delays",
    )
    page.lemma(
        "Walls that the boundaries enclose with a stable one are stable",
        enclosed_walls_are_stable(),
        because="for integer delays, as in Fig. 9",
    )
    page.lemma(
        "A passive wall is stable with a damped device with a spring, for every delay",
        held_passive_is_stable(),
        because="the stiffness of a passive wall is not negative; then by the energy of "
        "\\chapter{s6e_fractional_passive_is_stable}",
    )
    page.settle(
        "fig11",
        in_one_plane(),
        note=r"the text does not say which polynomial the solid curves for $d=\tfrac14$ and "
        r"$d=\tfrac12$ belong to, so that of these delays only the last lemma is claimed. One "
        r"$\delta$ stands for passivity and stability; for a device with an arm the passive "
        r"regions drawn here are at least 32 times too large (\texttt{one-delta-figures})",
    )

r"""Do the drawn stability boundaries keep clear of the passive walls?

Fig. 11 of the paper draws both kinds of boundary in one plane, for $\gamma=0.001$, $\delta=0.02$
and seven delays, two of them fractions of a period. For whole delays passive walls are stable, by
\chapter{s5a_passive_is_stable}. What do the curves for $d=\tfrac14$ and $d=\tfrac12$ say?
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
        "Take a point $(\\alpha,\\beta)$ of the explicit boundary, whose root is "
        "$z=e^{j\\theta}$, and ask for the damping that passivity wants at this same angle:"
    )
    wall = {K: stiffness, B: damping, T: S.One}
    size = n_1**2 + n_0**2 + 2 * n_1 * n_0 * cos(theta)
    need = (1 + a - e) * n_1 + (1 - a - e) * n_0 + 2 * (n_0 - e * n_1) * cos(theta)
    page.same("A", need / (2 * size), real_part(on_circle(bottom / ((z - 1) * top))))
    page.step(
        "At the root's own angle the wall needs $\\Re\\{A/((z-1)N)\\}$",
        passivity.dirichlet_form().subs(wall, simultaneous=True),
        need / (2 * size),
        name=r"\frac{\alpha\sin(d+\frac12)\theta}{2\sin\frac\theta2}-\beta\cos(d+1)\theta",
        because="the delay is gone: this is $\\Re\\{A/((z-1)N)\\}$ for every real $d$, where $z^d$ "
        "is read as $e^{jd\\theta}$",
    )
    page.say(
        "By the energy of \\chapter{s5a_passive_is_stable} the right side is larger than "
        "$\\delta$ for $0<\\theta\\le\\pi$. The curve therefore never enters the passive walls, "
        "for any stiffness, any damping and any delay so read: whole ones, and fractions with "
        "$z^{-d}=e^{-jd\\theta}$."
    )
    page.say(
        "A force that is really held back by a fraction of a period has other boundaries, the "
        "solid ones here. They leave the paper's by 1.6 % of the largest stiffness for "
        "$d=\\tfrac14$ and by 0.3 % for $d=\\tfrac12$. All walls of (27) seem to lie inside: of "
        "$4\\cdot10^5$ on its border none was found unstable. That is no proof; such a count could "
        "only have refuted it. The walls of (27) for the next whole delay do lie inside, by "
        "\\chapter{s6g_next_whole_delay} and \\chapter{s6e_fractional_passive_is_stable}."
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
        "The walls of the curve (27) for $\\delta=0.02$ are on the boundary of the passive ones, "
        "and above its corner no others",
        passive_curve(dashed()),
        because="up to $\\hat\\omega=\\pi/(d+1)$ and behind whole delays, as for Fig. 4",
    )
    page.lemma(
        "The other curve has the walls with a zero on the circle, and none of them is stable",
        stable_curve(),
        because="behind whole delays",
    )
    page.lemma(
        "Walls that the boundaries enclose with a stable one are stable",
        enclosed_walls_are_stable(),
        because="with whole delays, as for Fig. 9",
    )
    page.lemma(
        "A passive wall keeps a damped device with a spring stable, for every delay",
        held_passive_is_stable(),
        because="the stiffness of a passive wall is not negative; then by the energy of "
        "\\chapter{s6e_fractional_passive_is_stable}",
    )
    page.settle(
        "fig11",
        in_one_plane(),
        note="the text does not say which polynomial the solid curves for $d=\\tfrac14$ and "
        "$d=\\tfrac12$ belong to, so that of these delays only the last lemma is claimed. One "
        "$\\delta$ stands for passivity and stability; for a held device the passive walls drawn "
        "here are at least 32 times too large (\\texttt{one-delta-figures})",
    )

r"""Do the stability boundaries of Fig. 11 intersect the passive regions?

Fig. 11 of the paper draws the passivity and the stability boundaries in one plane, for
$\gamma=0.001$, $\delta=0.02$ and seven delays, two of them fractions of a period. For integer
delays passive walls are stable, by \chapter{s5a_passive_is_stable}. We ask whether the curves
for $d=\tfrac14$ and $d=\tfrac12$ intersect, and whether they are the boundaries of a loop with
this delay.
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
        because=r"the delay cancels for every real $d$ if $z^d$ is read as $e^{jd\theta}$",
    )
    page.say(
        r"By the energy argument of \chapter{s5a_passive_is_stable}, this damping is larger than "
        r"$\delta$ for $0<\theta\le\pi$. Therefore the stability boundary never enters the "
        "passive region, for any spring, damper and delay, if fractional delays are read as "
        r"$z^{-d}=e^{-jd\theta}$."
    )
    page.say(
        "A loop whose force has a fractional delay has other boundaries, the solid curves in the "
        r"figure. They differ from the paper's by 1.6 % of the largest stiffness for $d=\tfrac14$ "
        r"and by 0.3 % for $d=\tfrac12$. All walls of (27) seem to lie inside these boundaries: "
        r"we tested $4\cdot10^5$ walls of (27), and all are stable. This test is evidence and not "
        r"a proof. By \chapter{s6g_next_whole_delay} and "
        r"\chapter{s6e_fractional_passive_is_stable}, the walls of (27) for the next integer "
        "delay lie inside these boundaries."
    )
    page.figure(
        "fig11",
        "Fig. 11 of the paper: stable walls (solid) and passive walls (dashed), for "
        r"$\gamma=0.001$, $\delta=0.02$; (b) is the framed part of (a). The dotted curves follow "
        r"the paper's reading of $d=\frac14$ and $d=\frac12$. The dash-dotted curve is the largest "
        "stable stiffness.",
        passive_and_stable,
        panels=(1, 2),
        height=0.62,
    )
    _settled(page)


def _settled(page):
    page.lemma(
        r"For $\delta=0.02$ the curve (27) bounds the passive walls, and above its corner every "
        "wall on the boundary lies on this curve",
        passive_curve(dashed()),
        because=r"the curve is the boundary up to $\hat\omega=\pi/(d+1)$ and for integer delays, "
        "as in Fig. 4",
    )
    page.lemma(
        "The walls on the explicit boundary have a zero on the circle, and none of them is stable",
        stable_curve(),
        because="this holds for integer delays",
    )
    page.lemma(
        "A wall that no boundary separates from a stable wall is stable",
        enclosed_walls_are_stable(),
        because="the statement holds for integer delays, as in Fig. 9",
    )
    page.lemma(
        "A passive wall is stable with a damped device with a spring, for every delay",
        held_passive_is_stable(),
        because="the stiffness of a passive wall is not negative, so the energy argument of "
        r"\chapter{s6e_fractional_passive_is_stable} applies",
    )
    page.settle(
        "fig11",
        in_one_plane(),
        note=r"the text does not say which polynomial the solid curves for $d=\tfrac14$ and "
        r"$d=\tfrac12$ belong to. Therefore only the last lemma is claimed for these delays. The "
        r"figure uses the same $\delta$ for passivity and stability; for a device with an arm, "
        "the passive regions drawn here are at least 32 times too large "
        r"(\texttt{one-delta-figures})",
    )

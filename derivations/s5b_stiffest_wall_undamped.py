r"""Is the stiffest wall also on the first arc without damping?

That no wall is stiffer than the first arc, \chapter{s5b_stiffest_wall_bound}, asks for $\delta>0$,
as an undamped plant has its own roots on the circle. To know what a damper is worth we need the
loop without one.
"""

from sympy import I, Rational, cos, exp, sin, tan

from symhaptic.model import boundary
from symhaptic.model.passivity import on_circle
from symhaptic.model.plant import Sampled
from symhaptic.notation import a, d, n_0, theta, z

SWING = Sampled(n_0, n_0, a, 1)
"""Without damping n_1 = n_0 and e = 1, by mirror symmetry in time (s4a_discretisation)."""


def derive(page):
    page.say(
        "\\emph{No stable wall is stiffer.} A wall that is stable without damping stays so with a "
        "little of it, as roots move with the coefficients. The inequalities of "
        "\\chapter{s5b_stiffest_wall_bound} hold strictly, so for little damping too, and its "
        "largest stiffness is a maximum of a function that is continuous in $\\delta$, $|N|$ "
        "being positive up to $\\theta=\\frac{2\\pi}3$. So with $\\delta\\to0$ no wall is stiffer "
        "than the arc without damping."
    )
    page.say(
        "\\emph{The curve is reached.} Without damping $n_1=n_0$ and $e=1$. As before let "
        "$F=z^{d+1/2}A/N$:"
    )
    page.step(
        "Without damping the plant is real on the circle",
        on_circle((z**2 - a * z + 1) / z),
        2 * cos(theta) - a,
        name="A/z",
        because="real: the angle of $A$ jumps by $\\pi$ at $\\theta_r$, where $A$ is zero",
    )
    force = on_circle((z**2 - a * z + 1) / (n_0 * z + n_0)) * exp(I * (d + Rational(1, 2)) * theta)
    turned = (2 * cos(theta) - a) * exp(I * (d + 1) * theta) / (2 * n_0 * cos(theta / 2))
    page.step(
        "With its delay the force is real times a turn",
        force,
        turned,
        name="F",
        because="$\\chi=(d+1)\\theta$ before $\\theta_r$ and $(d+1)\\theta+\\pi$ behind it",
    )
    page.step(
        "The boundary's stiffness has one factor that turns",
        boundary.wall(SWING)[0],
        (a - 2 * cos(theta)) * cos((d + 1) * theta) / (2 * n_0 * cos(theta / 2) ** 2),
        name=r"\alpha(\theta)",
        because="positive for $\\theta_r<\\theta<\\frac\\pi{2(d+1)}$, with its maximum at a "
        "$\\theta_*$ there, if $(d+1)\\theta_r<\\frac\\pi2$",
    )
    page.step(
        "The boundary's damping has the sine of that turn",
        boundary.wall(SWING)[0] + 2 * boundary.wall(SWING)[1],
        (a - 2 * cos(theta))
        * sin((d + 1) * theta)
        / (2 * n_0 * cos(theta / 2) ** 2 * tan(theta / 2)),
        name=r"\alpha(\theta)+2\beta(\theta)",
        because="positive up to there, so that $0<\\kappa<\\frac\\pi2$",
    )
    page.say(
        "Take the wall at $\\theta_*$ and turn $V$ a little on. The surplus $|A|^2-|NW|^2$ is "
        "quadratic in $y$, negative at $\\theta_r$, where $A=0$, and positive at $z=-1$, where "
        "$N=0$. So the wall leads up to $\\theta_*$ and the plant from there on. Its lead starts "
        "at 0, or at an angle below $\\theta_r$, where $\\kappa$ and $\\chi$ lie between 0 and "
        "$\\frac\\pi2$; in both cases the argument of $p_1$ is that of $NW$ without a whole turn. "
        "At $\\theta_*$ the difference $\\kappa-\\chi$ is a little more than $-\\pi$: again no "
        "whole turn. The argument of $z^{d+1}A$, which $p_1$ follows from there on, is "
        "$(d+3)\\pi$ at $\\theta=\\pi$, as it is past the jump. So $p_1$ turns by $(d+3)\\pi$ on "
        "the half circle, and all its $d+3$ roots are inside."
    )
    page.state(
        "stiffest-wall-undamped",
        r"without damping too the largest stable stiffness for $d\ge1$ is that of the boundary up "
        r"to $\theta=\pi/(d+\frac12)$, where the inequalities on the first arc hold",
    )

r"""How large is the error of the linear condition along the boundary?

The paper compares the boundary's $\alpha$ with the $\alpha_{\text{lin}}$ of the line at the same
$\beta$, in units of $\alpha+\gamma$. We write this error down for the whole boundary.
"""

from sympy import Abs, Rational, cos, sin

from symhaptic.model import boundary, lag, linear, plant
from symhaptic.model.parts import Parts
from symhaptic.notation import (
    alpha,
    alpha_lin,
    beta,
    d,
    delta,
    gamma,
    nu,
    s_1,
    s_2,
    theta,
)

HALF = Rational(1, 2)
Y = linear.CHORD
GAP = linear.GAP


def derive(page):
    error = page.define(
        "The relative error compares stiffnesses at the same $\\beta$",
        r"|\varepsilon|",
        Abs((alpha_lin - alpha) / (alpha + gamma)),
    )
    page.settle(
        "eq26",
        error,
        definition=True,
        note="not defined at the boundary's start, $\\alpha=-\\gamma$",
    )
    page.step(
        "The error is the surplus over the line, per $(d+\\frac12)(\\alpha+\\gamma)$",
        (lag.line(beta, delta) - alpha) / (alpha + gamma),
        linear.surplus() / ((d + HALF) * (alpha + gamma)),
        name=r"\varepsilon",
        because="positive where the boundary lies left of the line",
    )
    page.say(
        "Put $\\alpha$ and $\\beta$ of the explicit boundary in: this is the error as a function "
        "of $\\theta$, for every real $d$ on the principal sheet. For whole $d$ it is a quotient "
        "of polynomials in $y=4\\sin^2\\frac\\theta2$. With the gap "
        " $g=s_1-\\delta-\\frac12\\gamma$ "
        "and $\\kappa=\\nu\\bigl(s_2+(1-\\nu)s_1\\bigr)$, $\\mu=\\frac12-\\nu$, "
        "$|M|^2=1-\\nu(1-\\nu)y$:"
    )
    polynomials(page)
    free_mass(page)


def polynomials(page):
    """The two polynomials for d = 0 and d = 1."""
    kappa, mu, size = nu * (s_2 + (1 - nu) * s_1), HALF - nu, linear.arc(0).size
    low = s_1 / 2 + mu * s_2
    rows = [
        (0, (s_1 + s_2) * Y - kappa * Y**2, -low * Y + kappa * Y**2 / 2),
        (
            1,
            (gamma + 2 * s_1 + s_2) * Y
            - (s_1 + s_2 + 2 * kappa + nu * (1 - nu) * gamma) * Y**2
            + kappa * Y**3,
            -(2 * s_1 + 3 * gamma / 2 + mu * s_2) * Y
            + ((s_1 + s_2 + nu * (1 - nu) * gamma) * 3 / 2 + 2 * kappa) * Y**2
            - kappa * Y**3 * 3 / 2,
        ),
    ]
    shown = [
        (
            r"(s_1+s_2)y-\kappa y^2",
            r"-g|M|^2-\bigl(\tfrac12s_1+\mu s_2\bigr)y+\tfrac12\kappa y^2",
        ),
        (
            r"(\gamma+2s_1+s_2)y-(\sigma+2\kappa)y^2+\kappa y^3",
            r"-g|M|^2-\bigl(2s_1+\tfrac32\gamma+\mu s_2\bigr)y"
            r"+\bigl(\tfrac32\sigma+2\kappa\bigr)y^2-\tfrac32\kappa y^3",
        ),
    ]
    for (delay, right, above), (first, second) in zip(rows, shown, strict=True):
        arc = linear.arc(delay)
        because = "with $\\sigma=s_1+s_2+\\nu(1-\\nu)\\gamma$" if delay else ""
        page.show(
            f"For $d={delay}$ the denominator is a polynomial in $y$",
            r"|M|^2(\alpha+\gamma)",
            first,
            page.same("right", arc.right, right),
            because=because,
        )
        page.show(
            f"For $d={delay}$ the surplus is a polynomial in $y$",
            r"|M|^2\Delta",
            second,
            page.same("above", arc.above, above - GAP * size),
            because="so that $\\varepsilon=\\Delta/((d+\\frac12)(\\alpha+\\gamma))$",
        )


def free_mass(page):
    """gamma = delta = 0."""
    stiffness, damping = boundary.wall(plant.sampled(plant.normalised(Parts(False, False))))
    page.step(
        "Of a free mass the error is a quotient of sines",
        lag.line(damping, 0) / stiffness - 1,
        sin((d + HALF) * theta) / ((2 * d + 1) * sin(theta / 2) * cos((d + 1) * theta)) - 1,
        name=r"\varepsilon",
        because="for every real $d$",
    )

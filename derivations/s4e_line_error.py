r"""How large is the error of the linear condition along the boundary?

The paper compares the boundary's $\alpha$ with the $\alpha_{\text{lin}}$ of the line at the same
$\beta$, in units of $\alpha+\gamma$. We derive a formula for this error on the whole boundary.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag, linear
from symhaptic.notation import alpha_lin

Y = linear.CHORD
GAP = linear.GAP
G, MU, SIGMA = symbols("g mu sigma")


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
        note=r"the error is not defined at the start of the boundary, $\alpha=-\gamma$",
    )
    page.step(
        r"The error is the surplus $\Delta$ divided by $(d+\frac12)(\alpha+\gamma)$",
        (lag.line(beta, delta) - alpha) / (alpha + gamma),
        linear.surplus() / ((d + HALF) * (alpha + gamma)),
        name=r"\varepsilon",
        because="the error is positive where the boundary lies left of the line",
    )
    page.say(
        r"We insert $\alpha$ and $\beta$ of the explicit boundary. The error is then a function of "
        r"$\theta$, for every real $d$ with $z^d=e^{jd\theta}$. For integer $d$ the error is a "
        r"quotient of polynomials in $y=4\sin^2\frac\theta2$, with the common denominator "
        r"$|M|^2=1-\nu(1-\nu)y$:"
    )
    polynomials(page)
    free_mass(page)


def polynomials(page):
    """The polynomials of denominator and surplus for d = 0 and d = 1."""
    page.define("The gap $g$ lies between the start of the boundary and the line", G, GAP)
    page.define(
        r"The fraction $\nu$ of the numerator is less than one half by $\mu$", MU, HALF - nu
    )
    page.define(r"The number $\kappa$ of the arm is a product", kappa, nu * (s_2 + (1 - nu) * s_1))
    page.define(
        r"The number $\sigma$ of the arm is a sum", SIGMA, s_1 + s_2 + nu * (1 - nu) * gamma
    )
    size = 1 - nu * (1 - nu) * Y
    rows = [
        (0, (s_1 + s_2) * Y - kappa * Y**2, -(s_1 / 2 + MU * s_2) * Y + kappa * Y**2 / 2),
        (
            1,
            (gamma + 2 * s_1 + s_2) * Y - (SIGMA + 2 * kappa) * Y**2 + kappa * Y**3,
            -(2 * s_1 + 3 * gamma / 2 + MU * s_2) * Y
            + (3 * SIGMA / 2 + 2 * kappa) * Y**2
            - 3 * kappa * Y**3 / 2,
        ),
    ]
    for delay, right, above in rows:
        arc = linear.arc(delay)
        page.step(
            f"For $d={delay}$ the denominator is a polynomial in $y$",
            arc.right,
            right,
            name=r"|M|^2(\alpha+\gamma)",
        )
        page.step(
            f"For $d={delay}$ the surplus is a polynomial in $y$",
            arc.above,
            above - G * size,
            name=r"|M|^2\Delta",
            because="the quotient of the two polynomials is "
            r"$\varepsilon=\Delta/((d+\frac12)(\alpha+\gamma))$",
        )


def free_mass(page):
    """The error for a free mass, gamma = delta = 0."""
    stiffness, damping = boundary.wall(plant.sampled(plant.normalised(Parts(False, False))))
    page.step(
        "For a free mass the error is a quotient of sines",
        lag.line(damping, 0) / stiffness - 1,
        sin((d + HALF) * theta) / ((2 * d + 1) * sin(theta / 2) * cos((d + 1) * theta)) - 1,
        name=r"\varepsilon",
        because="the formula holds for every real $d$",
    )

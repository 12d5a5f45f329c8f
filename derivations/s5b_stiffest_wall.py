r"""How do the plant and the wall turn around the circle?

The explicit boundary goes on to higher angles behind its first tip, and is stiffer there. To tell
whether such walls can be stable we look at two angles: that of the wall, turned back by half a
period, and that of the plant with its delay. Springs are soft here and $d\ge1$ is whole.
"""

from sympy import I, Rational, cos, diff, exp, sin, symbols, tan

from symhaptic.bounds.walls import DEVICE
from symhaptic.model import boundary, circle
from symhaptic.model.passivity import on_circle
from symhaptic.notation import a, alpha, beta, d, e, n_0, n_1, phi, tau, theta, z

PLANT, FORCE = DEVICE.denominator, DEVICE.numerator
WALL = (alpha + beta) * z - beta


def derive(page):
    page.say(
        "Let $A=z^2-az+e$ and $N=n_1z+n_0$, and turn the wall $W=(\\alpha+\\beta)z-\\beta$ back by "
        "half a period. On the circle its angle $\\kappa$ then lies between $\\pm\\tfrac\\pi2$ for "
        "$\\alpha>0$:"
    )
    turned = alpha * cos(theta / 2) + I * (alpha + 2 * beta) * sin(theta / 2)
    back = exp(-I * theta / 2)
    page.step(
        "Half a period earlier the wall turns by $\\chi$",
        on_circle(WALL) * back,
        turned,
        name=r"V=z^{-1/2}W",
    )
    page.say(
        "A root is a place where $V=-f$ with $f=z^{d+1/2}A/N$. Let $\\chi$ be the angle of $f$, "
        "followed from $\\theta\\to0$, where it is 0 with a spring and $\\tfrac\\pi2$ without. The "
        "explicit boundary is the real part of this equation:"
    )
    force = on_circle(PLANT / FORCE) * exp(I * (d + Rational(1, 2)) * theta)
    f, mirrored, over, beside = symbols(r"f \overline{f} C S")
    page.define("The plant with its delay, turned by half a period", f, force)
    page.define("Its mirror image in the real axis", mirrored, force.xreplace({I: -I}))
    page.step(
        "The stiffness on the boundary is a real part",
        boundary.wall(DEVICE)[0],
        -(f + mirrored) / (2 * cos(theta / 2)),
        name=r"\alpha(\theta)",
        because="so that it is $-R\\cos\\chi$ with $R=|A|/(|N|\\cos\\frac\\theta2)$: positive just "
        "for $\\tfrac\\pi2<\\chi<\\tfrac{3\\pi}2$, as far as $\\chi<\\tfrac{5\\pi}2$",
    )
    page.define("The angle enters by the tangent of its half", tau, tan(theta / 2))
    page.define("and by the angle that the delay and a period turn", phi, (d + 1) * theta)
    turned = (n_1 + n_0) * cos(phi), (n_1 - n_0) * tau * sin(phi)
    page.define("A cosine of the numerator and of this angle", over, sum(turned))
    turned = (n_1 + n_0) * sin(phi), -(n_1 - n_0) * tau * cos(phi)
    page.define("A sine of the numerator and of this angle", beside, sum(turned))
    page.step(
        "The stiffness on the boundary is a quotient of real numbers",
        boundary.wall(DEVICE)[0],
        (((1 + a + e) * tau**2 - (1 - a + e)) * over + 2 * (1 - e) * tau * beside)
        / ((n_1 + n_0) ** 2 + (n_1 - n_0) ** 2 * tau**2),
        name=r"\alpha(\theta)",
    )
    phases(page)


def phases(page):
    """How chi turns."""
    slow = circle.square(FORCE) - circle.real(z * diff(FORCE, z) * FORCE.subs(circle.MIRRORED))
    page.step(
        "$N$ turns less than $z$",
        on_circle(slow),
        n_0 * (n_0 + n_1 * cos(theta)),
        name=r"|N|^2\Bigl(1-\frac{d\arg N}{d\theta}\Bigr)",
        because="positive up to $\\theta=\\frac{2\\pi}3$, where $2n_0>n_1$",
    )
    x, height = (1 + e) * cos(theta) - a, (1 - e) * sin(theta)
    page.same("A/z", on_circle(PLANT / z), x + I * height)
    page.step(
        "$A$ turns more than $z$",
        x * diff(height, theta) - height * diff(x, theta),
        (1 - e) * (1 - a + e + a * (1 - cos(theta))),
        name=r"|A|^2\Bigl(\frac{d\arg A}{d\theta}-1\Bigr)",
    )
    page.say(
        "So $\\chi$ rises up to $\\theta=\\pi/(d+\\frac12)\\le\\frac{2\\pi}3$. Let $\\theta_r$ be "
        "the angle with $(1+e)\\cos\\theta_r=a$, about the spring's own frequency "
        "$\\sqrt\\gamma$, or 0 without a spring; from there on $\\arg(A/z)\\ge\\frac\\pi2$. As "
        "$\\frac\\theta2\\le\\arg N<\\theta$, beyond $\\pi/(d+\\frac12)$ we have "
        "$\\chi>(d+\\frac12)\\theta+\\frac\\pi2\\ge\\frac{3\\pi}2$, if $\\theta_r$ lies before. "
        "Let even $(d+1)\\theta_r\\le\\frac\\pi2$; then at $\\theta_r$ it is at most "
        "$(d+1)\\theta_r+\\frac\\pi2\\le\\pi$."
    )

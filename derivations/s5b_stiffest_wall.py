r"""How do the plant and the wall turn around the circle?

The explicit boundary goes on to higher angles behind its first tip, and is stiffer there. To tell
whether such walls can be stable we look at two angles: that of the wall, turned back by half a
period, and that of the plant with its delay. Springs are soft here and $d\ge1$ is whole.
"""

from sympy import I, Rational, cos, diff, exp, sin, tan

from symhaptic.bounds.walls import DEVICE, STIFFNESS
from symhaptic.model import boundary, circle
from symhaptic.model.passivity import on_circle, real_part
from symhaptic.notation import a, alpha, beta, d, e, n_0, n_1, phi, t, theta, z

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
        "A root is a place where $V=-F$ with $F=z^{d+1/2}A/N$. Let $\\chi$ be the angle of $F$, "
        "followed from $\\theta\\to0$, where it is 0 with a spring and $\\tfrac\\pi2$ without. The "
        "explicit boundary is the real part of this equation:"
    )
    force = on_circle(PLANT / FORCE) * exp(I * (d + Rational(1, 2)) * theta)
    page.show(
        "The stiffness on the boundary is a length times a cosine",
        r"\alpha(\theta)",
        r"-\frac{\Re F}{\cos\frac\theta2}=-R\cos\chi,\quad R=\frac{|A|}{|N|\cos\frac\theta2}",
        page.same("real part", -real_part(force) / cos(theta / 2), boundary.wall(DEVICE)[0]),
        because="positive just for $\\tfrac\\pi2<\\chi<\\tfrac{3\\pi}2$, as far as "
        "$\\chi<\\tfrac{5\\pi}2$",
    )
    there = {t: tan(theta / 2), phi: (d + 1) * theta}
    page.show(
        "With $t=\\tan\\frac\\theta2$ and $\\varphi=(d+1)\\theta$ the stiffness is a real quotient",
        r"\alpha(\theta)",
        r"\frac{\bigl((1+a+e)t^2-(1-a+e)\bigr)C+2(1-e)tS}{(n_1+n_0)^2+(n_1-n_0)^2t^2}",
        page.same("in real numbers", STIFFNESS.subs(there), boundary.wall(DEVICE)[0]),
        because="with $C=(n_1+n_0)\\cos\\varphi+(n_1-n_0)t\\sin\\varphi$ and "
        "$S=(n_1+n_0)\\sin\\varphi-(n_1-n_0)t\\cos\\varphi$",
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

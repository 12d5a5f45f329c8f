r"""What does the passivity boundary look like in the plane of the stability analysis?

Table I turns $(K,B)$ into $(\alpha,\beta)$. The passive walls can then be drawn beside the stable
ones, and only the damping $\delta$ and the delay are left.
"""

from sympy import Eq, Rational, S

from symhaptic.model import passivity
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, m, omega_hat, theta


def derive(page):
    stiffness, damping = (e.subs(theta, omega_hat) for e in passivity.envelope())
    scaled = {b: delta * m / T}
    in_plane = [
        (stiffness * T**2 / m).subs(scaled),
        (damping * T / m).subs(scaled),
    ]
    line = passivity.margin(omega_hat) * T / m
    line = line.subs({K: alpha * m / T**2, B: beta * m / T}).subs(scaled)
    free = page.free_of("the line", line, T, m)
    page.say(
        "The envelope of the passive walls, multiplied by $T^2/m$ and $T/m$: mass and period drop "
        f"out of the line of each frequency ({free.method}), and so of the envelope, and both "
        "coordinates are proportional to $\\delta$."
    )
    page.step(
        "The line of one frequency",
        line,
        delta - passivity.dirichlet_form(omega_hat).subs({K: alpha, B: beta, T: 1}),
        name=r"\tfrac{T}{m}F",
    )
    page.say(
        "As in physical units, the curve is the boundary for $0<\\hat\\omega\\le\\pi/(d+1)$ and "
        "$d>0$. Beyond, up to $\\pi$, it leaves the passive walls and bounds nothing; for some "
        "delays, such as $d=\\tfrac14$, it even has a pole there."
    )
    page.settle(
        "eq27",
        Eq(alpha, in_plane[0]),
        Eq(beta, in_plane[1]),
        provided=r"d\in\mathbb{N},\ \alpha\ge0,\ 0<\hat\omega\le\pi/(d+1)",
        unless={d: S.Zero, delta: S.One, omega_hat: S.One, alpha: S.One, beta: Rational(1, 2)},
        truth=Eq(delta, alpha / 2 + beta),
        shows=r"for $d=0$ (27) is the point $(2\delta,0)$; $(1,\tfrac12)\delta$ is on the boundary",
    )

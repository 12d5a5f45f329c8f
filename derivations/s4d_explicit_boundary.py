r"""Is there an explicit stability boundary with delay and stiffness?

The paper draws the boundary of the stable region by a grid, since the inequalities of the usual
criteria grow with the delay. But the characteristic polynomial is affine in $\alpha$ and $\beta$,
and that is enough: on the unit circle one complex equation fixes both.
"""

from sympy import Ne, S, cos, sin, symbols, tan

from symhaptic.model import boundary, loop, plant
from symhaptic.model.passivity import on_circle
from symhaptic.notation import alpha, beta, c, d, delta, gamma, theta, z
from symhaptic.scene import FULL, Parts


def derive(page):
    a, e, n_1, n_0 = symbols("a e n_1 n_0")
    bottom, top = z**2 - a * z + e, n_1 * z + n_0
    polynomial = bottom * z ** (d + 1) + top * ((alpha + beta) * z - beta)
    page.say("With $A=z^2-az+e$ and $N=n_1z+n_0$, a root of the polynomial is a point where")
    q = boundary.needed(plant.Sampled(n_1, n_0, a, e))
    page.step(
        "The wall that a root needs",
        polynomial / (z * top),
        alpha + beta * (1 - 1 / z) - q,
        name=r"\frac{p_1(z)}{zN(z)}",
        because="vanishes: $\\alpha+\\beta(1-1/z)=Q$ with $Q=-z^dA/N$",
    )
    page.say(
        "On the unit circle, $z=e^{j\\theta}$, real and imaginary part are two real equations."
    )
    stiffness, damping = boundary.solved(on_circle(q))
    solved = page.same(
        "both solved", on_circle(polynomial).subs({alpha: stiffness, beta: damping}), S.Zero
    )
    page.show(
        "Damping on the boundary",
        beta,
        r"\frac{\Im Q}{\sin\theta}",
        solved,
        because="for every plant, and for every real $d$ on the principal sheet",
        boxed=True,
    )
    page.show(
        "Stiffness on the boundary",
        alpha,
        r"\Re Q-\beta(1-\cos\theta)",
        solved,
        because="with both, $p_1(e^{j\\theta})$ vanishes identically",
        boxed=True,
    )
    page.say(
        "No grid and no iteration: each angle gives one point of the boundary. The other pieces "
        "are the lines of a root at $z=1$ and at $z=-1$:"
    )
    page.step(
        "A root at 1",
        polynomial.subs(z, 1),
        1 - a + e + (n_1 + n_0) * alpha,
        name="p_1(1)",
        because="zero for $\\alpha=-\\gamma$, as $1-a+e=\\gamma(n_1+n_0)$",
    )
    page.step(
        "A root at $-1$, even delays",
        polynomial.subs(d, 0).subs(z, -1),
        (n_1 - n_0) * (alpha + 2 * beta) - (1 + a + e),
        name="p_1(-1)",
        because="for odd delays the last bracket changes its sign",
    )
    page.say("For a free mass, $\\gamma=\\delta=0$, the boundary is as short as one could wish:")
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    numbers = {a: free.a, e: free.e, n_1: free.n1, n_0: free.n0}
    short_stiffness = page.step(
        "Stiffness of the free mass",
        stiffness.subs(numbers),
        4 * tan(theta / 2) ** 2 * cos((d + 1) * theta),
        name=alpha,
        boxed=True,
    )
    short_damping = page.step(
        "Damping of the free mass",
        damping.subs(numbers),
        2 * tan(theta / 2) * sin((d + S.Half) * theta) / cos(theta / 2),
        name=beta,
        boxed=True,
    )
    page.limit(
        "Slope at the origin",
        short_damping / short_stiffness,
        theta,
        S.Zero,
        d + S.Half,
        name=r"\beta/\alpha",
        because="damping over stiffness is the delay, half a period of hold included",
    )
    device = plant.sampled(plant.normalised(FULL), split=c)
    general = {a: device.a, e: device.e, n_1: device.n1, n_0: device.n0}
    given = {gamma: (delta**2 - c**2) / 4}
    walls = {alpha: stiffness.subs(general), beta: damping.subs(general)}
    residual = on_circle(loop.characteristic(FULL, split=c)).subs(walls).xreplace(given)
    page.settle(
        "s4d-explicit-only-undelayed",
        page.same("the boundary of every plant and every delay", residual, S.Zero),
        corrected=(
            r"\beta=\frac{\Im Q}{\sin\theta}",
            r"\alpha=\Re Q-\beta(1-\cos\theta)",
            r"Q=-e^{jd\theta}A(e^{j\theta})/N(e^{j\theta})",
        ),
        misprint=False,
        unless={d: S.One, delta: S.One, c: S.Half, theta: S.One},
        truth=Ne(residual, 0, evaluate=False),
        shows=r"an explicit point of the boundary for $d=1$, $\gamma=\tfrac3{16}$",
        note="for fractional delays this is the principal sheet of the paper's substitution",
    )

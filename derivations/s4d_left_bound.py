r"""Does the stable region end at $\alpha=-\gamma$ on the left?

A wall with $\alpha<-\gamma$ cannot be stable. We ask whether the stable region always reaches the
line $\alpha=-\gamma$.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import loop


def derive(page):
    device = plant.sampled(plant.normalised(FULL), split=c)
    alone = plant.sampled(plant.normalised(Parts(stiffness=False)))
    total = device.n1 + device.n0
    at_one = Eq(loop.named().subs(z, 1), (n_1 + n_0) * (alpha + gamma))
    page.lemma(
        "At $z=1$ the polynomial is a multiple of $\\alpha+\\gamma$",
        combined(at_one, [device_static(assume(DEVICE)), 1]),
        because="a monic real polynomial with all roots inside the unit circle is positive at "
        "$z=1$",
    )
    page.define("The poles of the arm differ by $c$", gamma, (delta**2 - c**2) / 4)
    page.step(
        "For an overdamped device $n_1+n_0>0$",
        total * gamma,
        (1 - exp(-(delta - c) / 2)) * (1 - exp(-(delta + c) / 2)),
        name=r"\gamma(n_1+n_0)\big|_{c\ge0}",
        because=r"the two factors are positive for $0\le c<\delta$, that is, for $\gamma>0$",
    )
    swinging = (total * gamma).subs(gamma, (delta**2 - c**2) / 4).subs(c, 2 * I * phi)
    page.step(
        "For an underdamped device $n_1+n_0>0$",
        swinging,
        (1 - exp(-delta / 2)) ** 2 + 4 * exp(-delta / 2) * sin(phi / 2) ** 2,
        name=r"\gamma(n_1+n_0)\big|_{c=2j\varphi}",
        because=r"in this case $c=2j\varphi$, and $\varphi=\omega_dT$ is the angle of the damped "
        r"natural frequency $\omega_d$. The sum is zero only for $\delta=0$ and "
        r"$\varphi=2\pi,4\pi,\ldots$; in this case $p_1(1)=0$ for every wall, and no wall "
        "is stable",
    )
    page.step(
        "Without a spring $n_1+n_0>0$",
        alone.n1 + alone.n0,
        (1 - exp(-delta)) / delta,
        name=r"(n_1+n_0)\big|_{\gamma=0}",
        because=r"the sum is positive, and tends to 1 for $\delta\to0$",
    )
    page.say(
        r"So $\alpha>-\gamma$ is necessary for every delay and every damping. Does the region end "
        r"at $\alpha=-\gamma$? Without delay, take the wall $\alpha=-\gamma$, $\beta=0$:"
    )
    kept = plant.normalised(FULL).transition(t, c)[1, 1].subs(t, 1)
    at_line = loop.characteristic(FULL, split=c).subs({d: 0, alpha: -gamma, beta: 0})
    page.define("After a period without a force, a unit speed becomes $r$", r, kept)
    page.step(
        "For $d=0$ the roots are 0, 1 and the speed $r$ after a period",
        at_line,
        z * (z - 1) * (z - r),
        name="p_1(z)",
    )
    page.step(
        "The energy of the motion without a force decreases",
        2 * v * (-delta * v - gamma * x) + 2 * gamma * x * v,
        -2 * delta * v**2,
        name=r"\tfrac{d}{dt}(v^2+\gamma x^2)",
        because="the derivative of $v$ is given by Newton's law. The motion starts with $x=0$ "
        r"and $v=1$ and loses energy, so $|r|<1$, except for $\delta=0$ and "
        r"$\varphi=\pi,2\pi,\ldots$",
    )
    page.step(
        "At the root 1 the derivative of the polynomial is positive",
        diff(at_line, z).subs(z, 1),
        1 - r,
        name=r"p_1'(1)",
        because=r"the derivatives $p_1'(1)$ and $\partial p_1/\partial\alpha=n_1+n_0$ are "
        r"positive, so the root moves inside as $\alpha$ grows",
    )
    free = loop.characteristic(Parts(False, False)).subs({d: 0, alpha: 0})
    page.step(
        "For a free mass without delay the polynomial has the root 1",
        free,
        (z - 1) * (z**2 + (beta / 2 - 1) * z + beta / 2),
        name="p_1(z)",
        because=r"the wall is on the line $\alpha=0$; the quadratic factor has both roots inside "
        r"for $0<\beta<2$",
    )
    page.say(
        r"So without delay the region reaches the line, and its left bound is $\alpha=-\gamma$. "
        r"The only exception is an undamped device with $\omega_dT$ a multiple of $\pi$. For loops "
        r"with a delay see \chapter{s4d_left_bound_delayed}."
    )

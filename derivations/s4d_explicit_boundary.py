r"""Is there an explicit stability boundary with delay and stiffness?

The paper computes the boundary of the stable region on a grid, since the usual inequalities grow
with the delay. But the characteristic polynomial is affine in $\alpha$ and $\beta$, so one
complex equation on the unit circle determines them.
"""

from symhaptic.book.figures.arguments import crossing
from symhaptic.book.lemmas.boundary import numerator_on_circle, zero_on_circle_is_explicit
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.stability import explicit, on_boundary


def derive(page):
    bottom, top = z**2 - a * z + e, n_1 * z + n_0
    polynomial = bottom * z ** (d + 1) + top * ((alpha + beta) * z - beta)
    page.say(
        "The sampled device is $N/A$ with $A=z^2-az+e$ and $N=n_1z+n_0$. The characteristic "
        r"polynomial is $p_1=z^{d+1}A+N((\alpha+\beta)z-\beta)$ (\chapter{s4b_polynomial}):"
    )
    q = boundary.needed(plant.Sampled(n_1, n_0, a, e))
    page.step(
        "A root on the circle determines one wall",
        polynomial / (z * top),
        alpha + beta * (1 - 1 / z) - q,
        name=r"\frac{p_1(z)}{zN(z)}",
        because=r"the polynomial vanishes if $\alpha+\beta(1-1/z)=Q$ with $Q=-z^dA/N$",
    )
    page.say(
        r"On the circle, $z=e^{j\theta}$, the condition $p_1=0$ consists of two real equations."
    )
    stiffness, damping = boundary.solved(on_circle(q))
    page.step(
        "At each angle one wall solves the two equations",
        on_circle(polynomial).subs({alpha: stiffness, beta: damping}),
        S.Zero,
        name=r"p_1(e^{j\theta})\big|_{\beta=\Im Q/\sin\theta,\ \alpha=\Re Q-\beta(1-\cos\theta)}",
        because="the two parts vanish for every plant, and for every real $d$ with "
        r"$z^d=e^{jd\theta}$",
        boxed=True,
    )
    page.figure(
        "crossing",
        r"Walls of increasing stiffness ($d=1$, $\gamma=0.05$, $\delta=0.4$), and their roots.",
        crossing,
        panels=(1, 2),
        height=0.45,
    )
    page.say(
        "Neither a grid nor an iteration is necessary. Each angle gives one point of the boundary, "
        "at which a pair of roots crosses the circle. The other pieces of the boundary are the "
        "lines of walls with a root at 1 or at $-1$:"
    )
    page.step(
        r"A root at 1 means $\alpha=-\gamma$",
        polynomial.subs(z, 1),
        1 - a + e + (n_1 + n_0) * alpha,
        name="p_1(1)",
        because=r"the value is zero for $\alpha=-\gamma$, as $1-a+e=\gamma(n_1+n_0)$",
    )
    page.step(
        "A root at $-1$ means that the wall lies on a second line, here for even delays",
        polynomial.subs(d, 0).subs(z, -1),
        (n_1 - n_0) * (alpha + 2 * beta) - (1 + a + e),
        name="p_1(-1)",
        because="for odd delays the last bracket changes its sign",
    )
    page.say(r"For a free mass, $\gamma=\delta=0$, the formula is short:")
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    numbers = {a: free.a, e: free.e, n_1: free.n1, n_0: free.n0}
    short_stiffness = page.step(
        "The free mass has this stiffness on its boundary",
        stiffness.subs(numbers),
        4 * tan(theta / 2) ** 2 * cos((d + 1) * theta),
        name=r"\alpha(\theta)",
        boxed=True,
    )
    short_damping = page.step(
        "The free mass has this damping on its boundary",
        damping.subs(numbers),
        2 * tan(theta / 2) * sin((d + S.Half) * theta) / cos(theta / 2),
        name=r"\beta(\theta)",
        boxed=True,
    )
    page.limit(
        r"At the origin $\beta/\alpha=d+\frac12$",
        short_damping / short_stiffness,
        theta,
        S.Zero,
        d + S.Half,
        name=r"\beta(\theta)/\alpha(\theta)",
        because="near the origin, the ratio of damping to stiffness is the delay plus half a "
        "period for the hold",
    )
    _settled(page)
    _undamped(page)


def _settled(page):
    page.same(
        "as Q", boundary.wall(plant.Sampled(n_1, n_0, a, e)), [p.right for p in on_boundary().parts]
    )
    exact = page.lemma(
        r"The polynomial has a zero at $e^{j\theta}$ for this wall and for no other",
        zero_on_circle_is_explicit(),
        because=r"the statement holds for every device whose $N$ does not vanish at $e^{j\theta}$",
    )
    page.lemma(
        "For a damped device, $N$ does not vanish on the circle",
        numerator_on_circle(),
        because="a held force that is multiplied by $z$ in each period does work",
    )
    arm = (gamma, delta, d)
    given = [gamma >= 0, delta >= 0, d >= 0]
    found = add_assum(as_claimed(explicit(), exact), *given)
    page.state(
        "explicit-boundary",
        r"for every spring, damper and delay the walls with a zero at $e^{j\theta}$, "
        r"$0<\theta<\pi$, are $\beta=\Im Q/\sin\theta$, $\alpha=\Re Q-\beta(1-\cos\theta)$ with "
        r"$Q=-e^{jd\theta}A(e^{j\theta})/N(e^{j\theta})$",
        claim=every(arm, given, explicit()),
    )
    page.settle(
        "explicit-boundary",
        for_all(arm, given, found),
        example={gamma: S.One, delta: S.One, d: S.One},
        note="for fractional delays, the boundary is that of the principal sheet of $z^{-d}$",
    )
    page.settle_external(
        "s4d-explicit-only-undelayed",
        "what was derived in [15] and [12]",
        r"\texttt{explicit-boundary} gives an explicit boundary for every spring and delay",
    )


ANGLE = (d + 1) * theta
SPRING = Symbol("g")


def _undamped(page):
    page.say(
        "For a mass with a spring and no damper the formula is also short. In this case $n_1=n_0$, "
        "and no wall has a root at $-1$."
    )
    swinging = plant.sampled(plant.normalised(Parts(damping=False)), split=2 * I * Omega)
    arm = plant.Sampled(swinging.n1, swinging.n0, swinging.a, S.One)
    stiffness, damping = (side.xreplace({gamma: Omega**2}) for side in boundary.wall(arm))
    page.define(r"The natural frequency times the period is the angle $\Omega$", gamma, Omega**2)
    page.define(
        r"One function contains the stiffness $\gamma$",
        SPRING,
        gamma * (cos(Omega) - cos(theta)) / (1 - cos(Omega)),
    )
    first, second = cos(ANGLE) / cos(theta / 2) ** 2, 2 * sin(ANGLE) / sin(theta)
    page.step(
        "The boundary of an undamped device has one stiffness at each angle",
        stiffness,
        SPRING * first,
        name=r"\alpha(\theta)",
        boxed=True,
        because=r"the formula holds for every real $d$ with $z^d=e^{jd\theta}$, and for "
        r"$\cos\Omega\ne1$",
    )
    page.step(
        "The damping on the boundary is a multiple of a sine",
        stiffness + 2 * damping,
        SPRING * second,
        name=r"\alpha(\theta)+2\beta(\theta)",
        boxed=True,
    )
    per_gamma = (x - cos(theta)) / (1 - x)
    begin(page, per_gamma * first, per_gamma * (second - first) / 2)
    end(page)


def begin(page, stiffness, damping):
    """The limit at theta -> 0, in units of gamma, with x = cos Omega."""
    half = Rational(1, 2)
    page.say(
        r"The boundary starts on the line $\beta=\alpha(d+\frac12)$ of (25) with a smaller slope. "
        r"Let $x=\cos\Omega$:"
    )
    page.limit(
        r"The boundary starts at $\alpha=-\gamma$",
        stiffness,
        theta,
        S.Zero,
        S.NegativeOne,
        name=r"\alpha(\theta)/\gamma",
    )
    page.limit(
        r"The boundary starts at $\beta=-(d+\frac12)\gamma$",
        damping,
        theta,
        S.Zero,
        -(d + half),
        name=r"\beta(\theta)/\gamma",
    )
    right = (1 + x) / (4 * (1 - x)) + (d + 1) ** 2 / 2
    up = (d + half) * right - (d + 1) * (2 * d + 1) * (2 * d + 3) / 12
    name = r"\frac{\alpha(\theta)+\gamma}{\gamma\theta^2}"
    page.limit(
        r"Near its start the stiffness on the boundary grows as $\theta^2$",
        (stiffness + 1) / theta**2,
        theta,
        S.Zero,
        right,
        name=name,
    )
    page.limits((damping + d + half) / theta**2, theta, S.Zero, up)
    page.step(
        "The initial slope of the boundary is smaller than that of the line",
        up / right,
        d + half - (d + 1) * (2 * d + 1) * (2 * d + 3) / (12 * right),
        name=r"\frac{d\beta}{d\alpha}",
        because="the inequality holds for every spring and every delay; the two slopes are "
        r"equal only for a free mass, $x\to1$",
    )


def end(page):
    """The limit at theta -> pi, for integer delays."""
    page.say(
        "At the other end, for integer $d$, stiffness and damping grow without bound. As "
        r"$\sin(d+1)\theta=(-1)^d\sin(d+1)(\pi-\theta)$, the sum $\alpha+2\beta$ has a limit:"
    )
    per_gamma = (x - cos(theta)) / (1 - x)
    page.limit(
        r"The boundary approaches a line of constant $\alpha+2\beta$",
        2 * per_gamma * sin((d + 1) * (pi - theta)) / sin(theta),
        theta,
        pi,
        2 * (d + 1) * (1 + x) / (1 - x),
        name=r"(-1)^d\,\frac{\alpha(\theta)+2\beta(\theta)}{\gamma}",
    )
    per_gamma = per_gamma.subs(x, -1)
    page.step(
        r"The stiffness stays finite if $\Omega$ is an odd multiple of $\pi$, that is, for $x=-1$",
        per_gamma * cos(ANGLE) / cos(theta / 2) ** 2,
        -cos(ANGLE),
        name=r"\frac{\alpha}{\gamma}\Big|_{x=-1}",
    )
    page.step(
        "For $x=-1$ the damping also stays finite",
        2 * per_gamma * sin(ANGLE) / sin(theta),
        -sin(ANGLE) / tan(theta / 2),
        name=r"\frac{\alpha+2\beta}{\gamma}\Big|_{x=-1}",
        because=r"therefore the boundary ends at $\alpha=(-1)^d\gamma$, $\beta=-\alpha/2$",
    )

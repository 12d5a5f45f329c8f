r"""What is the stability boundary for a fractional delay?

The sampled device of \chapter{s6a_fractional_plant} has one more coefficient. We derive the
polynomial, its roots at 1 and $-1$, and the explicit boundary for this device.
"""

from symhaptic.book.lemmas.late_boundary import boundary_is_explicit, late_boundary
from symhaptic.book.lemmas.late_loop import (
    late_polynomial,
    numbers_of_a_late_device,
    polynomial_of_a_late_loop,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import loop

EXAMPLE = dict.fromkeys((alpha, beta, gamma, delta, epsilon), Rational(1, 2)) | {l: S.One}


def derive(page):
    a, e = symbols("a e")
    bottom, top = z**2 - a * z + e, m_2 * z**2 + m_1 * z + m_0
    push = (alpha + beta) * z - beta
    page.say("Let $A=z^2-az+e$ and $M=m_2z^2+m_1z+m_0$. The wall closes the loop:")
    polynomial = page.step(
        r"The characteristic polynomial with a fractional delay has degree $\ell+4$",
        (1 + top / (z * bottom) * z ** (-l) * push / z) * z ** (l + 2) * bottom,
        z ** (l + 2) * bottom + top * push,
        name="p_1(z)",
        because="the polynomial is monic, and has one more root than with the integer delay "
        r"$\ell$",
    )
    device = fractional.late(plant.normalised(FULL), split=c)
    numbers = {m_2: device.m2, m_1: device.m1, m_0: device.m0}
    numbers |= {a: device.device.a, e: device.device.e}
    given = {gamma: (delta**2 - c**2) / 4}
    made = fractional.characteristic(FULL, split=c)
    page.same("made of the plant", polynomial.subs(numbers), made)
    whole = loop.characteristic(FULL, split=c)
    for end, expected in ((0, z * whole.subs(d, l)), (1, whole.subs(d, l + 1))):
        page.same("ends", made.subs(epsilon, end).xreplace(given), expected.xreplace(given))
    found = page.lemma(
        "A loop is stable with a fractional delay if all zeros of this polynomial lie inside",
        polynomial_of_a_late_loop(),
        because=r"for $\varepsilon=0$ and $\varepsilon=1$ the polynomial is that of an integer "
        "delay, since $(m_2,m_1,m_0)$ is $(n_1,n_0,0)$ and $(0,n_1,n_0)$",
    )
    page.state(
        "fractional-polynomial",
        r"for a delay of $(\ell+\varepsilon)T$ the characteristic polynomial is "
        r"$z^{\ell+2}A+M((\alpha+\beta)z-\beta)$, of degree $\ell+4$; it tends to the polynomials "
        "of both neighbouring integer delays",
        claim=late_polynomial(),
    )
    page.settle("fractional-polynomial", found, example=EXAMPLE)

    page.say(r"The polynomial is affine in $\alpha$ and $\beta$, so the boundary is explicit:")
    q = -(z ** (l + 1)) * bottom / top
    page.step(
        "A root determines one wall",
        polynomial / (z * top),
        alpha + beta * (1 - 1 / z) - q,
        name=r"\frac{p_1(z)}{zM(z)}",
        because=r"the polynomial vanishes if $\alpha+\beta(1-1/z)=Q$ with $Q=-z^{\ell+1}A/M$",
    )
    turned = on_circle(q)
    real = real_part(turned)
    damping = (turned - real) / I / sin(theta)
    boundary = {alpha: real - damping * (1 - cos(theta)), beta: damping}
    residual = on_circle(polynomial).subs(boundary)
    page.step(
        "At each angle one wall satisfies both parts of the equation",
        residual,
        S.Zero,
        name=r"p_1(e^{j\theta})\big|_{\beta=\Im Q/\sin\theta,"
        r"\ \alpha=\Re Q-\beta(1-\cos\theta)}",
        because=r"the solution holds for every plant, every integer $\ell$ and every "
        r"$\varepsilon$",
    )
    at_one = Eq(polynomial.subs(z, 1), (n_1 + n_0) * (alpha + gamma))
    total = numbers_of_a_late_device()[0]
    page.lemma(
        r"A root at 1 means $\alpha=-\gamma$",
        combined(at_one, [device_static(assume(DEVICE)), 1], [total, alpha]),
    )
    page.say(r"So $\alpha>-\gamma$ is necessary. There may also be a root at $-1$:")
    page.step(
        r"For even $\ell$ the walls with a root at $-1$ lie on a second line",
        polynomial.subs(l, 0).subs(z, -1),
        1 + a + e - (m_2 - m_1 + m_0) * (alpha + 2 * beta),
        name="p_1(-1)",
        because="for odd $\\ell$ the first three terms change their sign",
    )
    found = page.lemma(
        "At each angle one wall has a root",
        boundary_is_explicit(),
        because="the equation and its conjugate determine two real unknowns; if $M=0$, then "
        "$A=0$ as well, and no wall moves the root",
    )
    page.state(
        "fractional-boundary",
        "for every plant and every delay $(\\ell+\\varepsilon)T$ the boundary is explicit: "
        "$\\beta=\\Im Q/\\sin\\theta$, $\\alpha=\\Re Q-\\beta(1-\\cos\\theta)$ with "
        "$Q=-z^{\\ell+1}A/M$, $z=e^{j\\theta}$, and the lines of a root at 1 and $-1$",
        claim=late_boundary(),
    )
    page.settle("fractional-boundary", found, example=EXAMPLE)
    page.say(
        r"A root on the unit circle requires $|A|=|M|\,|(\alpha+\beta)z-\beta|$. This equation "
        r"does not contain $\ell$:"
    )
    x = cos(theta)
    for title, factor, square in (
        (
            "The size of $A$ does not contain the delay",
            bottom,
            4 * e * x**2 - 2 * a * (1 + e) * x + a**2 + (1 - e) ** 2,
        ),
        (
            "The size of $M$ does not contain the delay either",
            top,
            4 * m_2 * m_0 * x**2 + 2 * m_1 * (m_2 + m_0) * x + m_1**2 + (m_2 - m_0) ** 2,
        ),
        (
            "The size of the wall $W=(\\alpha+\\beta)z-\\beta$ is linear in $\\cos\\theta$",
            push,
            alpha**2 + 2 * beta * (alpha + beta) * (1 - x),
        ),
    ):
        value = on_circle(factor)
        name = {bottom: "|A|^2", top: "|M|^2"}.get(factor, "|W|^2")
        page.step(title, value * value.xreplace({I: -I}), square, name=name)
    page.say(
        r"So the angles of all possible crossings are the roots of a cubic in $\cos\theta$. For "
        "integer delays $m_0=0$, and the cubic becomes a quadratic. The cost of a test does not "
        "grow with the delay."
    )
    free = fractional.late(plant.normalised(Parts(stiffness=False, damping=False)))
    numbers = {m_2: free.m2, m_1: free.m1, m_0: free.m0, a: free.device.a, e: free.device.e}
    shift = exp(-I * (l + epsilon + S.Half) * theta)
    page.limit(
        "The boundary of a free mass starts at the origin with the slope of (25)",
        (turned.subs(numbers) * shift / theta**2 - 1) / theta,
        theta,
        S.Zero,
        S.Zero,
        name=r"\frac1\theta\Bigl(\frac{Q}{\theta^2}\,e^{-j(\ell+\varepsilon+1/2)\theta}-1\Bigr)",
        because=r"therefore the boundary starts with $\beta/\alpha=d+\frac12$. Near the origin, "
        "the linear condition (25) is also valid for fractional delays",
    )

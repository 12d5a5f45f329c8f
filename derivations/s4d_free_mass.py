r"""Which walls of a free mass are stable?

For a mass without arm and damping, $\gamma=\delta=0$, and with an integer delay of $d$ periods, the
boundary is known in closed form. We show that the first arc, $0<(d+1)\theta<\pi/2$, and the line
$\alpha=0$ enclose exactly the stable walls.
"""

from symhaptic.book.figures.passivity import free_mass
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import loop

FREE = Parts(stiffness=False, damping=False)
ANGLE = (d + 1) * theta
BENT = (1 + 2 * cos(theta / 2) ** 2) / sin(theta / 2) ** 4
CURVATURE = (d + 1) ** 2 * cos(ANGLE) + alpha * BENT / 8


def derive(page):
    polynomial = loop.characteristic(FREE)
    stiffness, damping = boundary.wall(plant.sampled(plant.normalised(FREE)))
    page.define(r"The parameter of the boundary is $\tau=\tan(\theta/2)$", tau, tan(theta / 2))
    page.step(
        "On the boundary of a free mass the stiffness is a multiple of a cosine",
        stiffness,
        4 * tau**2 * cos(ANGLE),
        name=r"\alpha(\theta)",
    )
    page.step(
        r"On the boundary of a free mass $\alpha+2\beta$ is a multiple of a sine",
        stiffness + 2 * damping,
        4 * tau * sin(ANGLE),
        name=r"\alpha(\theta)+2\beta(\theta)",
    )
    necessary(page, polynomial)
    page.lemma(
        "On the boundary of a free mass the damping is a function of stiffness and angle",
        damping_given(),
        because=r"for a given $\alpha$ the damping grows with $\theta$",
    )
    page.say(
        r"A stiffness $0<\alpha<\alpha_{\max}$ occurs at two angles $\theta_1<\theta_2$ of the "
        r"first arc. Therefore the damping at $\theta_1$ is less than at $\theta_2$. At every "
        r"larger angle with this stiffness the damping is negative or more than at $\theta_2$, so "
        "the boundary does not enter the region between the two dampings. A wall of this region "
        "has no root at 1 and, by the real part, none at $-1$. The region is connected, so all its "
        r"walls are stable if one is. Near $\alpha=0$ the region contains walls with a small "
        r"positive $\beta$:"
    )
    loose = z ** (d + 1) * (z - 1) + beta * (z + 1) / 2
    page.step(
        "On the line $\\alpha=0$ two roots are known",
        polynomial.subs(alpha, 0),
        (z - 1) * loose,
        name="p_1(z)",
    )
    page.step(
        r"The second root near 1 moves inside as $\beta$ grows",
        (-diff(loose, beta) / diff(loose, z)).subs(beta, 0).subs(z, 1),
        -1,
        name=r"\frac{dz}{d\beta}",
        because=r"the second root is at $z=1$ for $\beta=0$; the other $d+1$ roots are at 0",
    )
    page.step(
        r"The first root near 1 moves inside as $\alpha$ grows",
        (-diff(polynomial, alpha) / diff(polynomial, z)).subs({alpha: 0, z: 1}),
        -1 / beta,
        name=r"\frac{dz}{d\alpha}",
        because=r"the first root is at $z=1$ for $\alpha=0$. So walls with a small $\beta$ and a "
        r"much smaller $\alpha$ are stable, and therefore all walls of the region are stable",
    )
    page.figure(
        "free_mass",
        "Stable walls of a free mass, between the first arc of the boundary and the line "
        r"$\alpha=0$. The dots are the walls of maximum stiffness.",
        free_mass,
    )


def necessary(page, polynomial):
    """A stable wall lies between the two ends of the first arc."""
    page.step(
        r"At $z=1$ the value of the polynomial is $\alpha$",
        polynomial.subs(z, 1),
        alpha,
        name="p_1(1)",
        because=r"so every stable wall has $\alpha>0$",
    )
    real = cos(theta / 2) ** 2 * (alpha - 4 * tau**2 * cos(ANGLE))
    imaginary = sin(theta) / 2 * (alpha + 2 * beta - 4 * tau * sin(ANGLE))
    turned = on_circle(polynomial) * exp(-I * theta)
    page.step(
        "On the upper half of the circle a cosine and a sine give the two parts of the polynomial",
        turned,
        real + I * imaginary,
        name=r"e^{-j\theta}p_1(e^{j\theta})",
    )
    root = x + I * y
    page.step(
        r"A root $r=x+jy$ contributes one term to the growth of the phase with $\theta$",
        real_part(on_circle(z / (z - root))) - HALF,
        (1 - x**2 - y**2) / (2 * ((cos(theta) - x) ** 2 + (sin(theta) - y) ** 2)),
        name=r"\frac{d}{d\theta}\arg(e^{j\theta}-r)-\tfrac12",
        because="the term is positive for $|r|<1$",
    )
    page.say(
        r"With all $d+3$ roots inside, the phase of $p_1(e^{j\theta})$ grows by $(d+3)\pi$ over "
        r"$0<\theta<\pi$. The phase of the left side of the last but one step grows by "
        r"$(d+2)\pi$. The left side is $\alpha>0$ at $\theta=0$, and its phase always increases, "
        r"as $\frac12(d+3)>1$. So its real part has $d+2$ zeros. At the first two of them, "
        r"$\theta_1<\theta_2$, its imaginary part is positive and then negative. The real part "
        r"and $h=\cos(d+1)\theta-\frac\alpha4\cot^2\frac\theta2$ have the same zeros."
    )
    level = cos(ANGLE) - alpha / 4 * cot(theta / 2) ** 2
    page.step(
        "The second derivative of $h$ is a sum", -diff(level, theta, 2), CURVATURE, name="-h''"
    )
    page.lemma(
        "The curvature of $h$ has one sign where $\\cos(d+1)\\theta$ is not negative",
        concave(),
        because="so $h$ is concave where the cosine is not negative",
    )
    page.say(
        r"A zero of $h$ requires $\cos(d+1)\theta>0$. On the first interval, "
        r"$(d+1)\theta<\pi/2$, and on each interval around $2\pi,4\pi,\ldots$ a concave $h$ has "
        "at most two zeros. For odd $d$, $h$ has one zero on the half interval before "
        r"$\theta=\pi$, as it rises from negative values to 1. These are at most $d+2$ zeros, so "
        r"each interval contains its maximal number of zeros, and $\theta_1$, $\theta_2$ lie on "
        r"the first arc. At $\theta_1$ and $\theta_2$, $\alpha$ is the stiffness of the "
        r"boundary. By the signs of the imaginary part, $\beta$ lies between the two dampings. "
        "No other wall is stable."
    )


def concave():
    """0 < -h''(theta) for 0 < theta < pi, 0 < alpha, 0 <= d and 0 <= cos((d+1) theta)."""
    here = Given(theta > 0, theta < pi, alpha > 0, d >= 0, cos(ANGLE) >= 0)
    bent = here.have(sin(theta / 2) > 0, sine_of_half(theta))
    bent = here.show(BENT > 0, bent, square(cos(theta / 2)))
    return here.show(CURVATURE > 0, bent)


def damping_given():
    """(alpha + 2 beta)^2 in terms of alpha and tau."""
    cosine = Eq(alpha, 4 * tau**2 * cos(ANGLE))
    sine = Eq(alpha + 2 * beta, 4 * tau * sin(ANGLE))
    return combined(
        Eq((alpha + 2 * beta) ** 2, 16 * tau**2 - alpha**2 / tau**2),
        [assume(sine), sine.lhs + sine.rhs],
        [assume(cosine), (cosine.lhs + cosine.rhs) / tau**2],
    )

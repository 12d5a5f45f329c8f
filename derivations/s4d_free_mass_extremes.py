r"""What are the largest stable stiffness and the largest stable damping of a free mass?

The stable walls of a free mass lie between the line $\alpha=0$ and the first arc of the boundary,
$0<(d+1)\theta\le\pi/2$. On this arc we look for the largest stiffness and the largest damping.
"""

from sympy import chebyshevt

from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import rho
from symhaptic.proof import roots
from symhaptic.proof.enclosed import value

ANGLE = (d + 1) * theta
TANGENT, BRACKET = tan(theta / 2), Symbol("g")
RISE = (
    (1 + 2 * (d + 1) * TANGENT**2 + TANGENT**4) * sin(ANGLE)
    + 2 * d * TANGENT * cos(ANGLE)
    + (TANGENT**2 + TANGENT**4) * sin(d * theta)
)
"""The slope of the damping along the arc."""
FALL = (d + 1) * ((2 + cos(theta)) * sin(ANGLE) + (d + 1) * sin(theta) * cos(ANGLE))
"""Minus the slope of g along the arc."""
DELAYS = range(9)


def derive(page):
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    stiffness, damping = boundary.wall(free)
    page.define(r"The parameter of the boundary is $\tau=\tan(\theta/2)$", tau, tan(theta / 2))
    page.step(
        "The stiffness on the arc is quadratic in $\\tau$",
        stiffness,
        4 * tau**2 * cos(ANGLE),
        name=r"\alpha(\theta)",
    )
    page.step(
        "The damping on the arc is quadratic in $\\tau$",
        damping,
        2 * tau * sin(ANGLE) - 2 * tau**2 * cos(ANGLE),
        name=r"\beta(\theta)",
    )
    bend = 2 * cos(ANGLE) - (d + 1) * sin(theta) * sin(ANGLE)
    page.step(
        "The slope of the damping along the arc is a sum",
        diff(damping, theta),
        RISE.subs(TANGENT, tau),
        name=r"\frac{d\beta}{d\theta}",
    )
    rises, falls = signs()
    page.lemma("The damping rises along the arc: each term of its slope is positive", rises)
    page.step(
        r"The damping is largest at the end of the arc, where $\alpha=0$",
        damping.subs(theta, pi / (2 * (d + 1))),
        2 * tan(pi / (4 * (d + 1))),
        name=r"\beta_{\max}",
        boxed=True,
        because=r"stable walls approach this bound as $\alpha\to0$",
    )
    page.define("The function $g$ gives the sign of the slope of the stiffness", BRACKET, bend)
    page.step(
        "The slope of the stiffness has the sign of $g$",
        diff(stiffness, theta),
        4 * tau**2 * BRACKET / sin(theta),
        name=r"\frac{d\alpha}{d\theta}",
    )
    page.step("The slope of $g$ is a sum", -diff(bend, theta), FALL, name=r"-\frac{dg}{d\theta}")
    page.lemma("The function $g$ falls along the arc: each term of $-g'$ is positive", falls)
    page.step(r"At $\theta=0$ the function $g$ is 2", bend.subs(theta, 0), S(2), name="g(0)")
    page.step(
        "The function $g$ is negative where the arc ends",
        -bend.subs(theta, pi / (2 * (d + 1))),
        (d + 1) * sin(pi / (2 * (d + 1))),
        name=r"-g\bigl(\tfrac{\pi}{2(d+1)}\bigr)",
        because="therefore, for every real $d$, the largest stiffness is at the angle with "
        r"$(d+1)\tan(d+1)\theta\,\sin\theta=2$",
    )
    whole_delays(page, stiffness, bend)


def signs():
    """0 < d beta/d theta and 0 < -dg/d theta for 0 <= d, 0 < theta and (d+1) theta < pi/2."""
    here = Given(d >= 0, theta > 0, pi / 2 > ANGLE)
    half = sin(theta / 2) > 0, cos(theta / 2) > 0
    for claim in (ANGLE > 0, d * theta >= 0, theta < pi / 2, *half):
        here.have(claim)
    here.have(TANGENT > 0, over(TANGENT > 0, *half))
    here.have(sin(d * theta) >= 0, weak_sine(d * theta))
    return here.show(RISE > 0), here.show(FALL > 0)


def whole_delays(page, stiffness, bend):
    """The largest stiffness as an algebraic number."""
    page.say(
        r"For integer $d$ stiffness and slope are algebraic in $x=\cos\theta$. Let "
        r"$C=\cos(d+1)\theta$ be the Chebyshev polynomial of $x$. The largest $\alpha/4$ is "
        r"$\rho=\frac{1-x}{1+x}C$ at the root of $g=2C-(1-x^2)C'$ on the arc. Multiplication by "
        r"$\rho$ modulo $g$ has the characteristic polynomial $\mu_d$, which is irreducible:"
    )
    wave = cos(ANGLE)
    page.same(
        "in x, by the chain rule",
        (stiffness / 4, bend),
        ((1 - cos(theta)) / (1 + cos(theta)) * wave, 2 * wave + sin(theta) * diff(wave, theta)),
    )
    waves = [chebyshevt(delay + 1, x) for delay in DELAYS]
    page.same(
        "Chebyshev polynomials",
        [wave.subs(d, delay) for delay in DELAYS],
        [polynomial.subs(x, cos(theta)) for polynomial in waves],
    )
    found = []
    for delay, polynomial in enumerate(waves):
        turning = 2 * polynomial - (1 - x**2) * diff(polynomial, x)
        end = cos(pi / (2 * (delay + 1)))
        quarter = (1 - x) / (1 + x) * polynomial
        found.append(roots.algebraic(quarter, turning, x, rho, end, S.One))
    page.minimal(
        "The largest stiffnesses are algebraic, with these minimal polynomials",
        [(rf"\mu_{delay}(\rho)", number) for delay, number in enumerate(found)],
        because=r"the value $\alpha_{\max}(d)/4$ is the smallest positive root of $\mu_d$",
    )
    page.enclosed(
        "Intervals contain the largest stable stiffnesses of a free mass",
        [
            (rf"\alpha_{{\max}}({delay})", value(4 * rho, {rho: number}))
            for delay, number in enumerate(found)
        ],
        because="the stiffness is largest at the one root of $g$ on the arc, and balls around all "
        "roots of $g$ find this root",
    )
    at = sqrt(2) - 1
    page.step(
        "Without delay the largest stiffness has a closed form",
        4 * (1 - at) / (1 + at) * at,
        12 - 8 * sqrt(2),
        name=r"\alpha_{\max}(0)",
        boxed=True,
        because=r"the maximum is at $\cos\theta=\sqrt2-1$, a root of $x^2+2x-1$",
    )

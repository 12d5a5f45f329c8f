r"""How stiff and how damped can the wall of a free mass be?

The stable walls of a free mass lie between the line $\alpha=0$ and the first arc of the boundary,
$0<(d+1)\theta\le\pi/2$. On it we look for the largest stiffness and the largest damping.
"""

from sympy import Rational, S, Symbol, chebyshevt, cos, diff, pi, sin, sqrt, tan

from symhaptic.model import boundary, plant
from symhaptic.model.parts import Parts
from symhaptic.notation import alpha, beta, d, rho, tau, theta, x
from symhaptic.proof import roots, sign
from symhaptic.proof.enclosed import value

ANGLE = (d + 1) * theta
ARC = r"d\ge0,\ 0<(d+1)\theta\le\pi/2"
HALF = Rational(1, 2)
DELAYS = range(9)


def derive(page):
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    t = tan(theta / 2)
    stiffness, damping = 4 * t**2 * cos(ANGLE), 2 * t * sin(ANGLE) - 2 * t**2 * cos(ANGLE)
    arc = page.same("boundary", boundary.wall(free), (stiffness, damping))
    page.show(
        "With $\\tau=\\tan\\frac\\theta2$ the arc's stiffness is quadratic in $\\tau$",
        alpha,
        4 * tau**2 * cos(ANGLE),
        arc,
    )
    page.show(
        "With $\\tau=\\tan\\frac\\theta2$ the arc's damping is quadratic in $\\tau$",
        beta,
        2 * tau * sin(ANGLE) - 2 * tau**2 * cos(ANGLE),
        arc,
    )
    bend = 2 * cos(ANGLE) - (d + 1) * sin(theta) * sin(ANGLE)
    signs(page, damping, bend)
    page.step(
        "The largest damping is that of its end, where $\\alpha=0$",
        damping.subs(theta, pi / (2 * (d + 1))),
        2 * tan(pi / (4 * (d + 1))),
        name=r"\beta_{\max}",
        boxed=True,
        because="a bound that is approached as $\\alpha\\to0$",
    )
    page.show(
        "The stiffness rises with that function",
        r"\frac{d\alpha}{d\theta}",
        4 * tau**2 * Symbol("g") / sin(theta),
        page.same("slope", diff(stiffness, theta), 4 * t**2 / sin(theta) * bend),
    )
    page.step("The bracket $g$ starts from 2", bend.subs(theta, 0), S(2), name="g")
    page.step(
        "The bracket $g$ is negative where the arc ends",
        -bend.subs(theta, pi / (2 * (d + 1))),
        (d + 1) * sin(pi / (2 * (d + 1))),
        name="-g",
        because="so for every real $d$ one angle has the largest stiffness, that with "
        "$(d+1)\\tan(d+1)\\theta\\,\\sin\\theta=2$",
    )
    whole_delays(page, stiffness, bend)


def signs(page, damping, bend):
    """Along the arc the damping rises, and the sign of the stiffness's slope changes once."""
    up = sign.assume(theta)
    steps, room = (sign.assume(e, strict=False) for e in (d, pi / 2 - ANGLE))
    size = sign.combined(d + 1, [1], [steps])
    quarter = sign.number(pi / 2)
    angle, part = sign.combined(ANGLE, [size, up]), sign.combined(d * theta, [steps, up])
    side = sign.combined(pi / 2 - theta, [room], [part])
    half, rest = sign.combined(theta / 2, [HALF, up]), pi / 2 - theta / 2
    rest = sign.combined(rest, [HALF, side], [HALF, quarter])
    t = sign.quotient(
        tan(theta / 2),
        sign.sine(half, sign.combined(pi - theta / 2, [rest], [quarter])),
        sign.cosine(half, rest),
    )
    sine = sign.sine(angle, sign.combined(pi - ANGLE, [room], [quarter]))
    cosine = sign.cosine(angle, room)
    less = sign.sine(part, sign.combined(pi - d * theta, [room], [up], [quarter]))
    small = sign.sine(up, sign.combined(pi - theta, [side], [quarter]))
    wide = sign.cosine(up, side)
    grown = ([sine], [2, size, t, t, sine], [t, t, t, t, sine], [2, steps, t, cosine])
    rising = sign.combined(diff(damping, theta), *grown, [t, t, less], [t, t, t, t, less])
    page.positive("Along the arc the damping rises", rising, ARC, name=r"\frac{d\beta}{d\theta}")
    falls = sign.combined(
        -diff(bend, theta), [2, size, sine], [size, wide, sine], [size, size, small, cosine]
    )
    page.positive(
        "The bracket $g=2\\cos(d+1)\\theta-(d+1)\\sin\\theta\\sin(d+1)\\theta$ falls",
        falls,
        ARC,
        name=r"-\frac{dg}{d\theta}",
    )


def whole_delays(page, stiffness, bend):
    """The largest stiffness as an algebraic number."""
    page.say(
        "For whole $d$ all this is algebraic in $x=\\cos\\theta$: with the Chebyshev polynomial "
        "$C=\\cos(d+1)\\theta$ of $x$, the largest $\\alpha/4$ is $\\rho=\\frac{1-x}{1+x}C$ at the "
        "root of $g=2C-(1-x^2)C'$ on the arc. Multiplication by $\\rho$ modulo $g$ has the "
        "characteristic polynomial $\\mu_d$, which turns out to be irreducible:"
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
        because="$\\alpha_{\\max}(d)/4$ is the smallest positive root of $\\mu_d$",
    )
    page.enclosed(
        "The largest stable stiffnesses of a free mass are enclosed",
        [
            (rf"\alpha_{{\max}}({delay})", value(4 * rho, {rho: number}))
            for delay, number in enumerate(found)
        ],
        because="at the one root of $g$ on the arc, by balls around all roots",
    )
    at = sqrt(2) - 1
    page.step(
        "Without delay the largest stiffness has a closed form",
        4 * (1 - at) / (1 + at) * at,
        12 - 8 * sqrt(2),
        name=r"\alpha_{\max}(0)",
        boxed=True,
        because="at $\\cos\\theta=\\sqrt2-1$, a root of $x^2+2x-1$",
    )

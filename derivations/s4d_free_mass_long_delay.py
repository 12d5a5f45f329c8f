r"""How does the largest stiffness of a free mass fall with the delay?

Let $\varphi=(d+1)\theta$, which lies between 0 and $\pi/2$ on the arc that bounds the stable walls
of a free mass, and let $h=1/(d+1)$. We look for the limit of $(d+1)^2\alpha_{\max}$ for long
delays, for the rate of convergence, and for bounds.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import chi
from symhaptic.proof.enclosed import value
from symhaptic.proof.roots import zero
from symhaptic.proof.theorems.analysis import grows

LONG, CHORD = phi**2 * cos(phi), 2 * psi - sin(2 * psi)
AT = r"at $\varphi=\varphi_*$"


def derive(page):
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    stiffness = boundary.wall(free)[0].subs(d, 1 / h - 1).subs(theta, h * phi)
    page.define("The number $h$ is the reciprocal of the delay plus one period", d, 1 / h - 1)
    page.define(r"The boundary of a free mass has the stiffness $\alpha$", alpha, stiffness)
    scaled = page.step(
        r"As a function of $\varphi$, the scaled stiffness $(d+1)^2\alpha$ is its limit for long "
        "delays times a factor near 1",
        stiffness / h**2,
        LONG * (tan(h * phi / 2) / (h * phi / 2)) ** 2,
        name=r"(d+1)^2\alpha",
    )
    page.limit(
        r"For long delays, the scaled stiffness tends to $\varphi^2\cos\varphi$",
        scaled,
        h,
        S.Zero,
        LONG,
        name=r"(d+1)^2\alpha",
    )
    page.step(
        "The slope of the limit changes its sign once",
        diff(LONG, phi),
        phi * cos(phi) * (2 - phi * tan(phi)),
        name=r"\tfrac{d}{d\varphi}\,\varphi^2\cos\varphi",
        because=r"the bracket falls and vanishes at one angle $\varphi_*$, where the limit is "
        "largest",
    )
    angle = zero(2 * cos(phi) - phi * sin(phi), phi, S.One, Rational(11, 10))
    largest = value(LONG, {phi: angle})
    page.enclosed(
        "Intervals contain the angle and the height of the maximum",
        [(r"\varphi_*", angle), (r"\varphi_*^2\cos\varphi_*", largest)],
    )
    sides(page)
    page.say(
        r"As $h\varphi\le h\pi/2$, the largest stiffness has a lower and an upper bound for every "
        "real $d\\ge0$,\n\n"
        "$\\displaystyle\\quad\\varphi_*^2\\cos\\varphi_*<(d+1)^2\\alpha_{\\max}\\le\\varphi_*^2\\cos\\varphi_*\\left(\\frac{\\tan(h\\pi/4)}{h\\pi/4}\\right)^2,$\n\n"
        r"and $(d+1)^2\alpha_{\max}$ falls as the delay grows, from $12-8\sqrt2$ without delay."
    )
    factor = (tan(h * pi / 4) / (h * pi / 4)) ** 2
    page.limit("The ratio of the two bounds tends to 1", factor, h, S.Zero, S.One)
    expansion(page, scaled, angle)


def expansion(page, scaled, angle):
    """The next two terms in 1/(d+1)."""
    next_one = phi**4 * cos(phi) / 6
    name = r"\bigl((d+1)^2\alpha-\varphi^2\cos\varphi\bigr)/h^2"
    page.limit(
        "The next term is of order $h^2$",
        (scaled - LONG) / h**2,
        h,
        S.Zero,
        next_one,
        name=name,
    )
    after = 17 * phi**6 * cos(phi) / 720
    page.limits((scaled - LONG - h**2 * next_one) / h**4, h, S.Zero, after)
    there = {sin(phi): 2 * cos(phi) / phi}
    bent = page.step(
        "At $\\varphi_*$, with $\\tan\\varphi_*=2/\\varphi_*$, the curvature is negative",
        diff(LONG, phi, 2).subs(there),
        -(6 + phi**2) * cos(phi),
        name=r"\tfrac{d^2}{d\varphi^2}\,\varphi^2\cos\varphi",
        because="the curvature is not zero at the angle of the maximum",
    )
    shift = diff(next_one, phi).subs(there) ** 2 / (2 * bent)
    page.say(
        r"So $(d+1)^2\alpha_{\max}=\varphi_*^2\cos\varphi_*\,(1+a_2h^2+a_4h^4+\ldots)$. The change "
        "of the angle enters only the coefficient $a_4$:"
    )
    second, third = phi**2 / 6, phi**4 * (Rational(17, 720) + 1 / (18 * (6 + phi**2)))
    page.step(
        r"The coefficient of $h^2$ is $\varphi_*^2/6$",
        next_one / LONG,
        second,
        name="a_2",
        because=AT,
    )
    page.step(
        r"The coefficient of $h^4$ is rational in $\varphi_*^2$",
        (after - shift) / LONG,
        third,
        name="a_4",
        because=AT,
    )
    numbers = (value(term, {phi: angle}) for term in (second, third))
    page.enclosed(
        "Intervals contain the coefficients of the next terms",
        list(zip(("a_2", "a_4"), numbers, strict=True)),
    )


def sides(page):
    """tan(psi)/psi rises with psi."""
    page.step(
        "The slope of $\\tan\\psi/\\psi$ is a quotient",
        diff(tan(psi) / psi, psi),
        CHORD / (2 * psi**2 * cos(psi) ** 2),
        name=r"\frac{d}{d\psi}\,\frac{\tan\psi}{\psi}",
    )
    page.lemma(
        "The slope of $\\tan\\psi/\\psi$ is positive for $0<\\psi<\\pi/2$",
        rises(),
        because=r"therefore, with $\psi=h\varphi/2$, the stiffness $(d+1)^2\alpha$ at a given "
        r"$\varphi$ falls as $d$ grows",
    )


def rises():
    """0 < (2 psi - sin 2 psi)/(2 psi^2 cos^2 psi) for 0 < psi < pi/2."""
    here = Given(psi > 0, psi < pi / 2)
    here.have(cos(psi) > 0)
    slope = positive(diff(CHORD, psi).subs(psi, chi) > 0, [4, sin(chi) > 0, sin(chi) > 0])
    slope = here.and_(chi > 0, chi < psi).closed(slope)
    chord = here.show(CHORD > 0, grows(CHORD.subs(psi, chi), chi, S.Zero, psi, slope))
    return here.show(CHORD / (2 * psi**2 * cos(psi) ** 2) > 0, chord)
